#!/bin/sh
# What `make install` puts somewhere works from there and nowhere else, and `make uninstall` takes it away.
# Usage: sh tests/compare/command/cli_install.sh build/scallop. MAKE: the make that built it. Not under the sanitizers, nor where the build counts lines.
# shellcheck disable=SC2154
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"
build=$(dirname "$tool") compiler=${CC:-cc} place=$scratch/place
version=$(sed -n 's/^#define SCALLOP_VERSION "\(.*\)"/\1/p' "$root/model/version.h")
abi=$(sed -n 's/^#define SCALLOP_ABI //p' "$root/model/version.h")
if nm "$tool" 2>/dev/null | grep -q -e __asan_init -e __ubsan_ -e __gcov_; then
  echo "ok an instrumented build is not installed"
  exit 0
fi

quietly() { "$@" >"$scratch/said" 2>&1 || note "$*: exit code $?: $(tail -n 3 "$scratch/said")"; }
# DESTDIR, and a PREFIX that is not where the files are
made() { (cd "$root" && "${MAKE:-make}" --no-print-directory "$1" B="$build" PREFIX=/usr DESTDIR="$place"); }
quietly made install
for file in bin/scallop lib/libscallop-core.a lib/libscallop.a lib/pkgconfig/scallop.pc include/scallop/scallop.h share/doc/scallop/LICENSE; do
  [ -s "$place/usr/$file" ] || note "no $file"
done
finish "make install"

# ---- libraries ----
# without the node of the versions, and what compilers make for OpenMP
names() { nm "$@" --defined-only | awk 'NF == 3 && $2 ~ /^[A-Z]$/ && $3 !~ /^(SCALLOP_[0-9]|\.)/ { sub(/@.*/, "", $3); print $3 }' | LC_ALL=C sort -u; }
for name in scallop-core scallop; do
  library=$place/usr/lib/lib$name
  [ "$(readlink "$library.so")" = "lib$name.so.$abi" ] || note "lib$name.so leads elsewhere"
  [ "$(readlink "$library.so.$abi")" = "lib$name.so.$abi.$version" ] || note "lib$name.so.$abi leads elsewhere"
  readelf -d "$library.so" | grep -q "SONAME.*\[lib$name.so.$abi\]" || note "lib$name: another soname"
  names -D "$library.so" >visible
  names -g "$library.a" >global
  [ "$(grep -c . visible)" -gt 40 ] || note "lib$name shows $(grep -c . visible) names"
  grep -v -E '^scallop_' visible >others && note "lib$name shows $(head -n 5 others | tr '\n' ' ')"
  cmp -s visible global || note "lib$name.a and .so show other names: $(diff visible global | grep '^[<>]' | head -n 5 | tr '\n' ' ')"
  for word in $(cat visible); do
    grep -r -q -w "$word" "$place/usr/include/scallop" || echo "$word"
  done >undeclared
  [ ! -s undeclared ] || note "in no header: $(head -n 5 undeclared | tr '\n' ' ')"
done
finish "libraries show what the headers declare"
others=$(readelf -d "$place/usr/lib/libscallop-core.so" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' | grep -v -E '^(libm|libc|ld-linux.*)\.so\.[0-9]+$')
[ -z "$others" ] || note "needs $others"
finish "libscallop-core needs C's library only"

# ---- headers ----
alone() { # COMPILER LANGUAGE HEADER: it needs nothing in front of it
  printf '#include "%s"\n' "$3" | quietly "$1" -x "$2" -fsyntax-only -Wall -Wextra -Werror -I "$place/usr/include/scallop" -
}
for header in $(cd "$place/usr/include/scallop" && find . -name '*.h' | sed 's|^\./||'); do
  alone "$compiler" c "$header"
  if command -v c++ >/dev/null 2>&1; then
    alone c++ c++ "$header"
  fi
done
finish "each header compiles alone, as C and as C++"

# ---- a program ----
cp "$root/tests/support/installed.c" .
export PKG_CONFIG_LIBDIR="$place/usr/lib/pkgconfig" PKG_CONFIG_SYSROOT_DIR="$place"
unset PKG_CONFIG_PATH
"$tool" steady --F1 3 --T 0.5 >want
"$tool" steady --F1 10 --T 0.5 --gait sinusoidal >want_sine
agrees() { # PROGRAM NAME
  LD_LIBRARY_PATH=$place/usr/lib "./$1" >got 2>err || note "exit code $?: $(cat err)"
  for row in 'exact:want' 'quadratic, F1 = 3:want' 'sinusoidal, F1 = 10:want_sine'; do
    given=$(sed -n "s/^${row%:*}\t//p" got | cut -f 1) wanted=$(cells "${row#*:}" displacement)
    awk -v a="$given" -v b="$wanted" 'BEGIN { exit !(a != "" && a + 0 == b + 0) }' || note "${row%:*}: $given, not $wanted"
  done
  [ "$(sed -n 's/^failed\t//p' got)" = 1 ] || note "failed: $(sed -n 's/^failed\t//p' got)"
  finish "$2"
}
flags() { pkg-config "$@"; }
for name in scallop-core scallop; do
  [ "$(pkg-config --modversion $name)" = "$version" ] || note "$name.pc has version $(pkg-config --modversion $name)"
  # shellcheck disable=SC2046
  quietly "$compiler" -std=c11 -Wall -Wextra -Werror -o shared installed.c $(flags --cflags --libs $name)
  readelf -d shared | grep -q "lib$name.so.$abi" || note "does not load lib$name.so.$abi"
  agrees shared "a program with lib$name, shared"
  # shellcheck disable=SC2046
  quietly "$compiler" -std=c11 -o static installed.c $(flags --cflags $name) $(flags --static --libs $name | sed "s/-l$name /-l:lib$name.a /")
  ! readelf -d static | grep -q 'NEEDED.*libscallop' || note "loads the shared library"
  agrees static "a program with lib$name, static"
done
# Each block of C is a program, which prints a line. What includes a header of derived/ needs libscallop, and calls FLINT itself.
awk '/^```/ { inside = $0 == "```c"; n += inside; next } inside { print >("example" n ".c") }' "$root/docs/reference/library.md"
for example in example*.c; do
  name=scallop-core flint=
  if grep -q '/derived/' "$example"; then
    name=scallop flint=-lflint
    [ "${WITH_FLINT:-1}" != 0 ] || continue
  fi
  # shellcheck disable=SC2046,SC2086
  quietly "$compiler" -std=c11 -Wall -Wextra -Werror -o example "$example" $(flags --cflags --libs $name) $flint
  LD_LIBRARY_PATH=$place/usr/lib ./example >got 2>&1 || note "$example: exit code $?"
  tr '\n' ' ' <"$root/docs/reference/library.md" | grep -q -F "It prints \`$(cat got)\`." || note "$example prints: $(cat got)"
done
finish "the examples of docs/reference/library.md"
pages=$place/usr/share/doc/scallop
links=$(cd "$pages" && grep -oE '\]\([^)#]+' ./*.md ./*/*.md | sed 's|[^/]*:](||' | grep -v 'https\?:' | sort -u)
[ "$(echo "$links" | wc -l)" -gt 20 ] || note "links of the pages: $links"
for link in $links; do # from the folder of the page
  [ -f "$pages/$link" ] || note "no $link"
done
finish "what the installed pages link to is there"
if command -v c++ >/dev/null 2>&1; then
  printf '#include <scallop.h>\nint main() { scallop_crawler c = scallop_crawler_default(); return !(scallop_published_value(scallop_formula_named("eq28_displacement"), &c, SCALLOP_EXTENSION, 0, 0, 0, 0) > 0); }\n' >main.cc
  # shellcheck disable=SC2046
  quietly c++ -Wall -Wextra -Werror -o plus main.cc $(flags --cflags --libs scallop-core)
  LD_LIBRARY_PATH=$place/usr/lib ./plus || note "exit code $?"
  finish "a program in C++"
fi

# ---- the command ----
mv "$place" elsewhere
tool=$scratch/elsewhere/usr/bin/scallop
run 0 steady --F1 3 --T 0.5
cmp -s out want || note "another table"
finish "the command works from another folder"
if [ "${WITH_FLINT:-1}" != 0 ]; then
  run 0 steady --F1 3 --T 0.5 --certified --digits 20
  [ "$(cells out status)" = ok ] || note "status $(cells out status)"
  [ -f elsewhere/usr/lib/scallop/scallop-flint.so ] || note "no scallop-flint.so"
  finish "it finds scallop-flint.so there"
fi
if command -v gnuplot >/dev/null 2>&1; then
  draws() { # PICTURE ARGUMENT...
    picture=$1
    shift
    run 0 "$@"
    grep -q '</svg>' "$picture" || note "scallop $* draws no $picture: $(cat err)"
  }
  sed 's|"figure2"|"elsewhere/usr/share/scallop/plots/figure2.gp"|' elsewhere/usr/share/scallop/scenes/figure2.cfg >mine.cfg
  draws figure4.svg run figure4
  draws figure3.svg run elsewhere/usr/share/scallop/scenes/figure3.cfg
  draws figure2.svg run mine.cfg
  draws trajectory.svg trajectory --plot trajectory.svg
  for script in plot.sh common.gp figure2.gp figure5.gp plot/request.awk plot/map.awk; do
    cmp -s "$root/scripts/plots/$script" "elsewhere/usr/share/scallop/plots/$script" || note "no script $script"
  done
  PLOT_of=figure PLOT_x=T PLOT_y=dxC_over_L PLOT_table=figure4.tsv PLOT_file=own.svg PLOT_output=own.svg sh elsewhere/usr/share/scallop/plots/plot.sh
  grep -q '</svg>' own.svg || note "no picture by the installed script alone"
  finish "figures are drawn there"
fi
if /usr/bin/python3 -c 'import numpy' 2>/dev/null; then
  loaded() { env -u SCALLOP_LIBRARY -u LD_LIBRARY_PATH PYTHONPATH="$1" /usr/bin/python3 -c 'import crawling_scallop as s; s.run(["steady"]); s.steady(F1=s.table("figure4")["T"]); print(s.load())' 2>err; }
  loaded elsewhere/usr/share/scallop/python >got || note "$(tail -n 1 err)"
  [ "$(cat got)" = "$scratch/elsewhere/usr/lib/libscallop.so.$abi" ] || note "it loads '$(cat got)'"
  (cd "$root" && "${MAKE:-make}" --no-print-directory install B="$build" PREFIX=/opt libdir=/usr/lib/some-machine DESTDIR="$scratch/debian") >said 2>&1 || note "$(tail -n 3 said)"
  loaded debian/opt/share/scallop/python >got || note "$(tail -n 1 err)"
  [ "$(cat got)" = "$scratch/debian/usr/lib/some-machine/libscallop.so.$abi" ] || note "with a libdir of its own it loads '$(cat got)'"
  mkdir copied
  cp -r elsewhere/usr/share/scallop/python/* copied
  SCALLOP_LIBRARY=$scratch/elsewhere/usr/lib/libscallop.so PYTHONPATH=copied /usr/bin/python3 -c 'import scallop; scallop.steady()' 2>err || note "$(tail -n 1 err)"
  finish "the Python package finds library, command and tables, and can be copied"
fi
run 0 --help
for command in $(sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z]*\) .*/-\1/p' out) ''; do
  grep -q "^\.TH SCALLOP.* 1 .*scallop $version" "elsewhere/usr/share/man/man1/scallop$command.1" || note "no page scallop$command"
done
[ "$(find elsewhere/usr/share/man -name '*.1' | wc -l)" -gt 5 ] || note "$(find elsewhere/usr/share/man -name '*.1' | wc -l) pages"
run 0 --completion bash
cmp -s out elsewhere/usr/share/bash-completion/completions/scallop || note "no completion"
for scene in "$root"/data/scenes/*.cfg; do
  [ ! -f "$scene" ] || cmp -s "$scene" "elsewhere/usr/share/scallop/scenes/$(basename "$scene")" || note "no scene $(basename "$scene")"
done
cmp -s "$root/scripts/plots/cheapest.awk" elsewhere/usr/share/scallop/cheapest.awk || note "no cheapest.awk"
finish "pages, completion and scenes are there"

mv elsewhere "$place"
touch "$place/usr/lib/libscallop.so.0"
quietly made uninstall
[ -f "$place/usr/lib/libscallop.so.0" ] || note "the library of another binary interface has gone"
rm -f "$place/usr/lib/libscallop.so.0"
find "$place" ! -type d >left
[ ! -s left ] || note "left: $(head -n 3 left | tr '\n' ' ')"
[ ! -d "$place/usr/include/scallop" ] || note "the folder of the headers is left"
finish "make uninstall leaves nothing"

odd='/a&b|c\d'
(cd "$root" && quietly "${MAKE:-make}" --no-print-directory install B="$build" PREFIX="$odd" DESTDIR="$place")
[ "$(head -n 1 "$place$odd/lib/pkgconfig/scallop.pc")" = "prefix=$odd" ] || note "$(head -n 3 "$place$odd/lib/pkgconfig/scallop.pc")"
finish "a PREFIX with characters that sed takes for its own"
exit $failed
