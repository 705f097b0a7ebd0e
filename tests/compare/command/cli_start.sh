#!/bin/sh
# What is loaded when the command starts: C's library, and nothing that has to be looked for. Usage: sh tests/compare/command/cli_start.sh build/scallop
# shellcheck disable=SC2154
. "$(dirname "$0")/../../support/common.sh"

loads() { LC_ALL=C readelf -d "$1" | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p'; }
loads "$tool" >libraries || note "no readelf"
if grep -q -E 'asan|ubsan|tsan' libraries; then
  echo "ok the sanitizers' libraries are loaded, and nothing is said of others"
elif [ "${STATIC:-1}" = 0 ]; then
  ! grep -q -E 'gomp|libomp|flint|arb|gmp|sundials' libraries || note "loads $(tr '\n' ' ' <libraries)"
  finish "a build with shared libraries loads no OpenMP, FLINT or SUNDIALS"
else
  others=$(grep -v -E '^(libm|libc|ld-linux.*)\.so\.[0-9]+$' libraries | tr '\n' ' ')
  [ -z "$others" ] || note "loads $others"
  finish "the command loads C's library only"
fi
exit $failed
