#!/bin/sh
# `pip install .` offline: the wheel, with what this machine has and without GSL, libconfig and FLINT, installed where there is nothing else.
# Usage: sh tests/compare/command/cli_wheel.sh build/scallop. Not where the build is instrumented.
# shellcheck disable=SC2154
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"
build=$(dirname "$tool")
/usr/bin/python3 -c 'import importlib.util as u, sys; sys.exit(not all(map(u.find_spec, ("ensurepip", "pip", "setuptools", "venv", "wheel"))))' || {
  echo "skipped: /usr/bin/python3 has no venv, pip, setuptools or wheel (Debian: python3-venv python3-pip python3-setuptools python3-wheel)"
  exit 0
}
if nm "$tool" 2>/dev/null | grep -q -e __asan_init -e __ubsan_ -e __gcov_; then
  echo "skipped: an instrumented build is not installed"
  exit 0
fi
unset SCALLOP_LIBRARY SCALLOP_COMMAND PYTHONPATH MAKEFLAGS MFLAGS MAKELEVEL LD_LIBRARY_PATH
export PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_NO_INDEX=1 PIP_ROOT_USER_ACTION=ignore PIP_CONFIG_FILE=/dev/null
quietly() { "$@" >said 2>&1 || note "$*: exit code $?: $(tail -n 3 said)"; }

# A copy, because setuptools writes beside the sources
mkdir tree
tar -C "$root" --exclude=./build --exclude=./.git -cf - . | tar -C tree -xpf -
wheel() { # FOLDER
  quietly /usr/bin/python3 -m pip wheel --no-build-isolation --no-deps -w "$1" ./tree
  file=$(echo "$1"/crawling_scallop-*-py3-none-linux_*.whl)
  [ -f "$file" ] || note "$1 has no wheel"
}
venv() { # NAME OPTION...: with the wheel, and pip nowhere
  name=$1
  shift
  quietly /usr/bin/python3 -m venv --without-pip "$@" "$name"
  quietly /usr/bin/python3 -m pip --python "$name/bin/python" install --no-deps "$file"
}
tested() { # VENV: the tests of the package that is installed there
  if /usr/bin/python3 -c 'import numpy, pytest' 2>err; then
    (cd / && "$scratch/$1/bin/python" -m pytest -q -p no:cacheprovider --pyargs crawling_scallop) >said 2>&1 || note "$(grep -m 3 -e ^FAILED -e ^ERROR said || tail -n 3 said)"
    grep -q -E '^[3-9][0-9] passed' said || note "$(tail -n 1 said)"
  fi
}

SCALLOP_BUILD=$build wheel full
venv apart
printf '0.1 0.011\n0.05 0.0026\n0.025 6.3e-4\n0.0125 1.57e-4\n' >errors.txt
"$tool" order errors.txt --expect 2 >want
apart/bin/scallop order errors.txt --expect 2 >got 2>err || note "$(cat err)"
cmp -s got want || note "another table: $(cat got)"
apart/bin/python -W error >got 2>err <<'END' || note "$(tail -n 1 err)"
import sys
import crawling_scallop
rows = [[float(x) for x in line.split()] for line in open("errors.txt")]
found = crawling_scallop.order(*zip(*rows), expect=2)
print(found.verdict, found.reason, "numpy" in sys.modules, crawling_scallop.load())
END
[ "$(cat got)" = "pass order 2.04 in rows 1 to 4 False $(cd apart/lib/python3*/site-packages && pwd)/crawling_scallop/lib/libscallop.so.$(sed -n 's/^#define SCALLOP_ABI //p' "$root/model/version.h")" ] || note "$(cat got)"
finish "the command and order() with nothing else installed"
# The steps of the workflow in docs/guide/order.md
awk 'BEGIN { print "h,L2,H1"; for (h = 1; h > 0.01; h /= 2) printf "%.17g,%.17g,%.17g\n", h, h ^ 2, h }' >errors.csv
sed -n 's/^      - run: \(scallop order .*\)$/\1/p' "$root/docs/guide/order.md" >steps.sh
[ "$(wc -l <steps.sh)" -eq 2 ] || note "$(wc -l <steps.sh) steps"
quietly env PATH="$scratch/apart/bin:$PATH" GITHUB_STEP_SUMMARY=summary.md sh -e steps.sh
grep -q '<testcase' orders.xml && grep -q '| pass |' summary.md || note "$(cat orders.xml summary.md)"
finish "the workflow of docs/guide/order.md"
venv beside --system-site-packages
tested beside
if [ "${WITH_FLINT:-1}" != 0 ]; then
  beside/bin/scallop steady --certified --digits 20 >got 2>err || note "$(cat err)"
fi
finish "the tests of the package, installed"
quietly /usr/bin/python3 -m pip --python apart/bin/python uninstall -y crawling-scallop
left=$(find apart -name '*scallop*')
[ -z "$left" ] || note "left: $left"
finish "pip uninstall leaves nothing"

# ---- without GSL, libconfig and FLINT: what the sources include of these ends the compiler ----
mkdir -p poison/gsl
for header in gsl_errno gsl_odeiv2 gsl_roots gsl_sort gsl_statistics_double gsl_qrng; do echo '#error GSL' >poison/gsl/$header.h; done
for header in gmp arb; do echo '#error FLINT' >poison/$header.h; done
CPPFLAGS=-I$scratch/poison CFLAGS=-O0 WITH_FLINT=0 WITH_GSL=0 WITH_LIBCONFIG=0 wheel bare
venv poor --system-site-packages
for made in poor/bin/scallop poor/lib/python3*/site-packages/crawling_scallop/lib/libscallop.so.*; do
  others=$(readelf -d "$made" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' | grep -v -E '^(libm|libc|libgomp|ld-linux.*)\.so\.[0-9]+$')
  [ -z "$others" ] || note "$made needs $others"
done
tested poor
finish "a wheel that needs C's library only"
/usr/bin/python3 "$root/tests/support/cases.py" poor/bin/scallop "$root/tests/compare/command/cli_order.cases" >said || note "$(grep -m 2 FAIL said)"
tool=$scratch/poor/bin/scallop
run 0 steady --F1 3 --T 0.5
"$build/scallop" steady --F1 3 --T 0.5 | cmp -s out - || note "another steady state"
run 2 run figure2
grep -q 'this program reads no scenes and no formula files: it was built without libconfig' err || note "$(cat err)"
run 3 claims
grep -q 'needs FLINT' err || note "$(cat err)"
finish "its command: the orders, the steady state, and what it says of the rest"
exit $failed
