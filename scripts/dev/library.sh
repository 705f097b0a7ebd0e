#!/bin/sh
# Makes the library BUILD/libNAME.a, .so and NAME.pc: library.sh NAME BUILD VERSION ABI "NEEDED LIBRARIES" "HEADERS" OBJECT...
# Visible are the functions and tables that the headers declare, and nothing else, in the static library too: it is one object, in which
# the rest was made local. NAME.pc is a draft: `make install` puts the
# folders into it. From the environment: CC, AR, NM, OBJCOPY, LDFLAGS.
set -eu
name=$1 file=$2/lib$1 pc=$2/$1.pc version=$3 abi=$4 needed=$5 headers=$6
case $name in
  scallop-core) description="Exact motion of the crawling scallop and the published series" ;;
  scallop) description="Exact motion of the crawling scallop, certified numbers, and general-purpose methods to compare with" ;;
esac
shift 6
echo "  LD $file"
"$NM" -g --defined-only "$@" | awk 'NF == 3 { print $3 }' | LC_ALL=C sort -u >"$file.defined"
# shellcheck disable=SC2086
cat $headers | tr -c 'A-Za-z0-9_' '\n' | LC_ALL=C sort -u | LC_ALL=C comm -12 - "$file.defined" >"$file.names"
{ echo "SCALLOP_$abi { global:"; sed 's/$/;/' "$file.names"; echo 'local: *; };'; } >"$file.map"
# shellcheck disable=SC2086
$CC $LDFLAGS -shared -Wl,-soname,"lib$name.so.$abi" -Wl,--version-script="$file.map" -Wl,-Bsymbolic-functions -o "$file.so.$abi.$version" "$@" $needed
ln -sf "lib$name.so.$abi.$version" "$file.so.$abi"
ln -sf "lib$name.so.$abi" "$file.so"
# shellcheck disable=SC2086
$CC -r -nostdlib -o "$file.o" "$@"
"$OBJCOPY" --keep-global-symbols="$file.names" "$file.o"
rm -f "$file.a" "$file.defined"
"$AR" rcs "$file.a" "$file.o"
cat >"$pc" <<END
prefix=@PREFIX@
libdir=@libdir@
includedir=@includedir@

Name: $name
Description: $description
Version: $version
Cflags: -I\${includedir}/scallop
Libs: -L\${libdir} -l$name
Libs.private: $needed
END
