#!/bin/sh
# scripts/dev/layers.py on a house made up here: it finds a wrong arrow, a circle through a table of function pointers, and what is too long.
layers=$(cd "$(dirname "$0")/../../.." && pwd)/scripts/dev/layers.py
. "$(dirname "$0")/../../support/common.sh"

build() { # every .c of the program as an object file
  rm -rf build
  for c in */*.c compare/*/*.c; do
    mkdir -p "build/${c%/*}"
    "${CC:-cc}" -std=c11 -I. -c -o "build/${c%.c}.o" "$c" || note "$c is not compiled"
  done
}
judge() { # CODE
  build
  /usr/bin/python3 "$layers" build >out 2>err
  code=$?
  [ "$code" = "$1" ] || note "exit code $code, not $1: $(cat out err)"
}
said() { grep -q -F -e "$1" out || note "'$1' is not among: $(cat out err)"; }

mkdir -p model numerics asymptotics compare/tables compare/maps compare/breakdown
echo 'double law(double t);' >model/law.h
printf '#include "model/law.h"\ndouble law(double t) { return t; }\n' >model/law.c
printf '#include "model/law.h"\ndouble solve(void);\ndouble solve(void) { return law(1); }\n' >numerics/solve.c
echo 'extern int written;' >compare/tables/table.h
printf '#include "compare/tables/table.h"\nint written;\n' >compare/tables/table.c
printf '#include "compare/tables/table.h"\nint grid(void);\nint grid(void)\n{\n  return written;\n}\n' >compare/maps/grid.c
judge 0
[ ! -s out ] || note "of a house in order: $(cat out)"
finish "make layers: a house in order"

# Upward: by an include, by a call without one, by data without one
cp compare/tables/table.c kept.c
printf '#include "compare/maps/map.h"\n' >>compare/tables/table.c
: >compare/maps/map.h
judge 1
said "tables must not use maps: compare/tables/table.c:3 includes compare/maps/map.h"
printf 'int grid(void);\nint (*const row)(void) = grid;\n' >>kept.c
cp kept.c compare/tables/table.c
judge 1
said "tables must not use maps: compare/tables/table.c uses grid of compare/maps/grid.c"
said "circle in the program, of maps, tables:"
sed '/grid/d' kept.c >compare/tables/table.c
printf 'extern int written;\nint *law_written(void);\nint *law_written(void) { return &written; }\n' >model/data.c
judge 1
said "model must not use tables: model/data.c uses written of compare/tables/table.c"
rm model/data.c
mkdir compare/cellar
: >compare/cellar/box.h
judge 1
said "cellar: not in layers.txt"
rm -r compare/cellar
finish "make layers: arrows that are not allowed, by includes and by symbols"

# A table of functions; one of them reads the table.
cat >compare/breakdown/kinds.c <<'END'
int reach(void), radius(void);
int (*const kinds[])(void) = { reach, radius };
END
cat >compare/breakdown/reach.c <<'END'
extern int (*const kinds[])(void);
int reach(void), radius(void);
int reach(void) { return kinds[1](); }
END
echo 'int radius(void); int radius(void) { return 1; }' >compare/breakdown/radius.c
judge 1
said "circle in compare/breakdown, of kinds, reach:"
said "compare/breakdown/kinds.c uses reach of compare/breakdown/reach.c"
said "compare/breakdown/reach.c uses kinds of compare/breakdown/kinds.c"
[ "$(wc -l <out)" = 3 ] || note "more than one circle: $(cat out)"
sed -i 's/kinds\[1\]/radius/' compare/breakdown/reach.c
judge 0
finish "make layers: a circle through a table of function pointers"

printf '#ifndef BOX_H\n#define BOX_H\n#endif\n' | tee model/box.h numerics/box.h >compare/tables/other.h
judge 1
said "BOX_H guards compare/tables/other.h and model/box.h and numerics/box.h"
rm model/box.h numerics/box.h compare/tables/other.h
judge 0
finish "make layers: include guards that are the same"

{
  printf 'int many(int i);\nint many(int i)\n{\n'
  for _ in $(seq 57); do echo '  i++;'; done
  printf '  return i;\n}\n'
} >numerics/many.c # 61 lines from its name on
for i in $(seq 26); do : >"compare/maps/header$i.h"; done
seq 451 | sed 's|^|// |' >compare/tables/long.h
most=$(awk '$1 == "model" { print $2 }' "${layers%.py}.txt")
seq "$most" | sed 's|^|// |' >model/long.h
printf "// %118d\n" 1 >>numerics/many.c
judge 1
said "numerics/many.c: many: 61 lines, 60 are allowed"
said "compare/maps: 28 files, 25 are allowed"
said "compare/tables/long.h: 451 lines, 450 are allowed"
said "model: $((most + 3)) lines, $most are allowed"
said "numerics/many.c:63: 121 columns"
[ "$(wc -l <out)" = 5 ] || note "more is refused: $(cat out)"
/usr/bin/python3 "$layers" build --size >out || note "--size gives exit code $?"
grep -q '^numerics  *2  *66  *[0-9][0-9]*  *2  *31  *61$' out || note "the size of numerics: $(cat out)"
finish "make layers, make size: lines, functions, files and folders that are too long"
exit $failed
