#!/bin/sh
# What `make install` puts where, and `make uninstall` takes away: install.sh install|uninstall BUILD VERSION ABI "HEADERS" "PROGRAM", the
# last with the part that it loads from ../lib/scallop, if there is one.
# From the environment: INSTALL, DESTDIR and the folders of config.mk.
set -eu
what=$1 build=$2 version=$3 abi=$4 headers=$5 program=$6
data=$DESTDIR$datadir/scallop parts=${bindir%/*}/lib/scallop

escaped() { printf '%s\n' "$1" | sed 's/[\\&|]/\\&/g'; } # for the right side of s|||
put() { # FOLDER FILE...
  folder=$1
  shift
  "$INSTALL" -d "$DESTDIR$folder"
  "$INSTALL" -m 644 "$@" "$DESTDIR$folder"
}
if [ "$what" = uninstall ]; then
  rm -f "$DESTDIR$bindir/scallop" "$DESTDIR$completionsdir/scallop" \
    "$DESTDIR$mandir"/man1/scallop.1 "$DESTDIR$mandir"/man1/scallop-*.1
  for name in scallop-core scallop; do
    rm -f "$DESTDIR$pkgconfigdir/$name.pc" "$DESTDIR$libdir/lib$name".a "$DESTDIR$libdir/lib$name".so "$DESTDIR$libdir/lib$name.so.$abi" \
      "$DESTDIR$libdir/lib$name.so.$abi".*
  done
  rm -rf "$DESTDIR$parts" "$DESTDIR$includedir/scallop" "$data" "$DESTDIR$datadir/doc/scallop"
  exit 0
fi
"$INSTALL" -d "$DESTDIR$bindir"
"$INSTALL" "${program%% *}" "$DESTDIR$bindir"
case $program in *' '*) put "$parts" "${program#* }" ;; esac
for name in scallop-core scallop; do
  put "$libdir" "$build/lib$name.a" "$build/lib$name.so.$abi.$version"
  ln -sf "lib$name.so.$abi.$version" "$DESTDIR$libdir/lib$name.so.$abi"
  ln -sf "lib$name.so.$abi" "$DESTDIR$libdir/lib$name.so"
  put "$pkgconfigdir" "$build/$name.pc"
  sed -i -e "s|@PREFIX@|$(escaped "$PREFIX")|" -e "s|@libdir@|$(escaped "$libdir")|" -e "s|@includedir@|$(escaped "$includedir")|" \
    "$DESTDIR$pkgconfigdir/$name.pc"
done
for header in $headers; do
  "$INSTALL" -m 644 -D "$header" "$DESTDIR$includedir/scallop/$header"
done
put "$mandir/man1" "$build"/man/*.1
put "$completionsdir" scripts/dev/completion.bash
mv "$DESTDIR$completionsdir/completion.bash" "$DESTDIR$completionsdir/scallop"
package=$datadir/scallop/python/crawling_scallop
put "$datadir/scallop/python" scripts/python/scallop.py
put "$package" scripts/python/crawling_scallop/*.py scripts/python/crawling_scallop/py.typed
put "$package/tests" scripts/python/crawling_scallop/tests/*.py
# The Python package knows the number of the interface, and finds library, command and tables from its own place
beside() { realpath -ms --relative-to="$package" "$1" | sed 's/[\\"]/\\&/g'; }
printf '{"version": "%s", "abi": %s, "libraries": "%s", "command": "%s", "data": "../../data"}\n' \
  "$version" "$abi" "$(beside "$libdir")" "$(beside "$bindir/scallop")" >"$DESTDIR$package/installed.json"
chmod 644 "$DESTDIR$package/installed.json"
put "$datadir/scallop/data" data/*.tsv asymptotics/published/paper.cfg
pages=$datadir/doc/scallop
put "$pages" docs/*.* LICENSE
for folder in guide reference background development; do
  put "$pages/$folder" docs/$folder/*
done
# A link to a file of the sources becomes the name of the file
sed -i -e 's|\[\([^]]*\)\](\.\./[^)]*)|\1|g' "$DESTDIR$pages"/*.md
sed -i -e 's|\[\([^]]*\)\](\.\./\.\./[^)]*)|\1|g' "$DESTDIR$pages"/*/*.md
put "$datadir/scallop/scenes" data/scenes/*.cfg
put "$datadir/scallop/plots" scripts/plots/plot.sh scripts/plots/common.gp scripts/plots/figure*.gp
put "$datadir/scallop/plots/plot" scripts/plots/plot/*.awk
put "$datadir/scallop" scripts/plots/cheapest.awk
