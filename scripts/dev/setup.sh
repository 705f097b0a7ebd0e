#!/bin/sh
# Makes sure that what a build needs is there: installs it as root or with sudo on Debian, and
# otherwise says exactly what to install. Usage: [WITH_FLINT=0] scripts/dev/setup.sh GOAL..., make's goals
set -eu

has_header() { printf '#include <%s>\n' "$1" | cc -E - >/dev/null 2>&1; }

need() { missing="$missing $1"; }
purposes() { # GOAL...
  for goal in "$@"; do
    case $goal in
      help | size | clean | uninstall | gates) ;;
      check | asan) echo build tests ;;
      fuzz | lint | valgrind | matrix | coverage) echo "build tests $goal" ;;
      reproduce) echo build plots ;;
      check-report) echo build plots report ;;
      explorer) echo build explorer ;;
      check-explorer) echo build explorer report ;;
      *) echo build ;;
    esac
  done
}
look() { # GOAL...: what is missing
  missing=""
  command -v cc >/dev/null 2>&1 || need "gcc libc6-dev"
  for purpose in $(purposes "$@" | tr ' ' '\n' | sort -u); do
    case $purpose in
      build)    has_header gsl/gsl_roots.h || need libgsl-dev
                has_header libconfig.h || need libconfig-dev
                if [ "${WITH_FLINT:-1}" != 0 ]; then
                  has_header gmp.h || need libgmp-dev
                  if ! has_header flint/fmpq.h; then
                    need libflint-dev
                  elif ! has_header arb.h && ! has_header flint/arb.h; then
                    need libflint-arb-dev # beside FLINT 2; FLINT 3 has it inside
                  fi
                fi ;;
      plots)    command -v gnuplot >/dev/null 2>&1 || need "gnuplot-nox fonts-dejavu-core"
                /usr/bin/python3 -c 'import jinja2' 2>/dev/null || need "python3 python3-jinja2" ;;
      report)   command -v chromium >/dev/null 2>&1 || need chromium ;;
      explorer) command -v clang >/dev/null 2>&1 || need clang
                command -v wasm-ld >/dev/null 2>&1 || need lld
                command -v wasm-opt >/dev/null 2>&1 || need binaryen
                [ -f /usr/lib/wasm32-wasi/libc.a ] || need wasi-libc
                ls /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a >/dev/null 2>&1 || need libclang-rt-dev-wasm32
                command -v node >/dev/null 2>&1 || need nodejs
                command -v npm >/dev/null 2>&1 || need npm ;;
      tests)    has_header cmocka.h || need libcmocka-dev
                command -v pkg-config >/dev/null 2>&1 || need pkgconf
                command -v gnuplot >/dev/null 2>&1 || need "gnuplot-nox fonts-dejavu-core"
                /usr/bin/python3 -c 'import mpmath' 2>/dev/null || need "python3 python3-mpmath"
                /usr/bin/python3 -c 'import jinja2' 2>/dev/null || need python3-jinja2
                /usr/bin/python3 -c 'import numpy' 2>/dev/null || need python3-numpy ;;
      lint)     command -v clang-tidy >/dev/null 2>&1 || need clang-tidy
                command -v clang-format >/dev/null 2>&1 || need clang-format
                command -v cppcheck >/dev/null 2>&1 || need cppcheck ;;
      fuzz)     command -v clang >/dev/null 2>&1 || need clang
                ls /usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.fuzzer-* >/dev/null 2>&1 || need libclang-rt-dev ;;
      valgrind) command -v valgrind >/dev/null 2>&1 || need valgrind ;;
      matrix)   command -v clang >/dev/null 2>&1 || need clang ;;
      coverage) command -v gcovr >/dev/null 2>&1 || need gcovr ;;
    esac
  done
}
look "$@"
[ -n "$missing" ] || exit 0

if [ "$(id -u)" = 0 ]; then
  as_root=""
elif sudo -n true 2>/dev/null; then
  as_root="sudo"
else
  as_root="none"
fi
if [ "$as_root" = none ] || ! command -v apt-get >/dev/null 2>&1; then
  echo "These packages (Debian names) are missing and cannot be installed from here:$missing" >&2
  echo "Install them, as root: apt-get install$missing" >&2
  exit 2
fi
export DEBIAN_FRONTEND=noninteractive
for again in 1 2 3; do # one package shows whether another is wanted; and the compiler comes before its headers are seen
  [ -n "$missing" ] || exit 0
  echo "Installing:$missing" >&2
  # shellcheck disable=SC2086
  { [ $again -gt 1 ] || $as_root apt-get update -qq; } >&2 &&
    $as_root apt-get install -y -qq --no-install-recommends $missing >&2
  look "$@"
done
[ -z "$missing" ] || { echo "Still missing:$missing" >&2; exit 2; }
