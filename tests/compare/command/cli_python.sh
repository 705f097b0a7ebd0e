#!/bin/sh
# The Python package and scripts/python/figure4.py, with the shared library beside the command or in SCALLOP_LIBRARY; python.cases has
# what the package computes. Usage: sh tests/compare/command/cli_python.sh build/scallop. One line for each check; non-zero if any failed.
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"

/usr/bin/python3 -c 'import numpy' 2>err || { echo "ok python: not tried, /usr/bin/python3 has no NumPy"; exit 0; }
abi=$(sed -n 's/^#define SCALLOP_ABI //p' "$root/model/version.h")
for name in libscallop-core libscallop; do
  [ ! -f "$(dirname "$tool")/$name.so.$abi" ] || beside=$(dirname "$tool")/$name.so.$abi
done
library=${SCALLOP_LIBRARY:-${beside:-$(dirname "$tool")/libscallop.so.$abi}}
if readelf -d "$library" 2>err | grep -q 'NEEDED.*lib\(asan\|ubsan\)'; then
  echo "ok python: not tried, the library wants the runtime of a sanitizer"
  exit 0
fi
export SCALLOP_LIBRARY="$library" PYTHONPATH="$root/scripts/python" PYTHONDONTWRITEBYTECODE=1
export PYTHONWARNINGS=error,ignore::ResourceWarning # the tests leave files open
(cd "$root" && /usr/bin/python3 tests/support/cases.py "$tool" tests/compare/command/python.cases) || failed=1

# ---- the tests of the package, and the examples in its docstrings and in the documents ----
if /usr/bin/python3 -c 'import pytest' 2>err; then
  SCALLOP_COMMAND=$tool SCALLOP_PAGES=$root/docs/reference/python.md:$root/docs/guide/order.md /usr/bin/python3 -m pytest -q -p no:cacheprovider --pyargs crawling_scallop \
    >said 2>&1 || note "$(grep -m 3 -e ^FAILED -e ^ERROR said || tail -n 3 said)"
  grep -q -E '^[3-9][0-9] passed' said || note "$(tail -n 1 said)"
  finish "pytest --pyargs crawling_scallop, with the examples of docs/reference/python.md and docs/guide/order.md"
fi
if command -v mypy >/dev/null && [ -f "$root/pyproject.toml" ]; then
  MYPYPATH=$root/scripts/python mypy --strict --config-file "$root/pyproject.toml" --cache-dir "$scratch/mypy" -p crawling_scallop >said 2>&1 || note "$(head -n 3 said)"
  finish "mypy --strict"
fi

# ---- finding the library ----
mkdir -p tree/scripts/python tree/build tree/model
cp "$root/model/version.h" tree/model
cp -r "$root"/scripts/python/crawling_scallop "$root"/scripts/python/scallop.py tree/scripts/python
loads() { # FILE, or part of the message
  PYTHONPATH=tree/scripts/python /usr/bin/python3 -c 'import scallop; print(scallop.load())' >said 2>&1
  tail -n 1 said | grep -q -F -e "$1" || note "wanted $1: $(tail -n 1 said)"
}
loads "$library"
for copy in libscallop.so.9$abi libscallop.so libscallop.so.$abi.9.8 tree/build/libscallop-core.so.$abi; do cp "$library" $copy; done
ln -s libscallop.so.$abi.9.8 link.so
echo text >libscallop.so.$abi
cc -shared -o libscallop-core.so.$abi -x c /dev/null
for pair in "libscallop.so.9$abi=libscallop.so.9$abi: version 9$abi of the binary interface: version $abi is wanted" \
  "libscallop.so=the name does not say the version of the binary interface: .so.$abi is wanted" \
  "link.so=$scratch/link.so" "libscallop.so.$abi=cannot load the library of crawling_scallop: $scratch/libscallop.so.$abi: " \
  "libscallop-core.so.$abi=has no scallop_status_text: it is older than this package, or another library" \
  "none.so.$abi=cannot load the library of crawling_scallop: $scratch/none.so.$abi: cannot open"; do
  SCALLOP_LIBRARY=${pair%%=*} loads "${pair#*=}"
done
unset SCALLOP_LIBRARY
mv libscallop.so.$abi.9.8 libscallop.so.$abi
LD_LIBRARY_PATH=$scratch loads "$scratch/tree/build/libscallop-core.so.$abi"
rm tree/build/libscallop-core.so.$abi
LD_LIBRARY_PATH=$scratch loads libscallop.so.$abi
loads "neither libscallop.so.$abi nor libscallop-core.so.$abi is in $scratch/tree/build"
SCALLOP_LIBRARY=none.so.$abi PYTHONPATH=tree/scripts/python /usr/bin/python3 -c 'import sys, scallop; print(scallop.load(sys.argv[1]), scallop.steady().v_start)' \
  "$scratch/libscallop.so.$abi" >said 2>&1
[ "$(cat said)" = "$scratch/libscallop.so.$abi 3.0166206576889527" ] || note "the argument does not come first: $(tail -n 1 said)"
export SCALLOP_LIBRARY="$library"
finish "the library is found, in order, and refused when it is another one"

# ---- the example ----
"$tool" figure 4 --digits 17 >figure4.tsv || note "exit code $?"
draw() { # CODE FILE [PATH]
  PATH=${3:-$PATH} /usr/bin/python3 "$root/scripts/python/figure4.py" --output "$2" 2>err
  code=$?
  [ $code = "$1" ] || note "exit code $code, not $1, for $2: $(tail -n 1 err)"
}
if command -v gnuplot >/dev/null; then
  draw 0 python.svg
  gnuplot -e "table = 'figure4.tsv'; output_file = 'table.svg'; kind = 'svg'" "$root/scripts/plots/common.gp" "$root/scripts/plots/figure4.gp"
  cmp python.svg table.svg >said || note "$(cat said)"
  draw 4 none/python.svg
fi
draw 3 kept.svg /nowhere
[ ! -f kept.svg ] && grep -q 'gnuplot is not installed' err || note "$(tail -n 1 err)"
finish "figure4.py: its picture, and what it says without gnuplot"
exit $failed
