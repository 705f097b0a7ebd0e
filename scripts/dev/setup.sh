#!/bin/sh
# Makes sure that what make's goals need is there: installs it on Debian, as root or with a sudo that asks for no password, and elsewhere
# prints what to install. Usage: [CC=cc CPPFLAGS=... WITH_FLINT=0 WITH_GSL=0 WITH_LIBCONFIG=0] scripts/dev/setup.sh [--missing] GOAL...; --missing: only prints it
set -eu
CC=${CC:-cc}

purposes() { # GOAL...: the first column of the table below
  for goal in "$@"; do
    echo "${goal##*/}"
    case ${goal##*/} in
      help | clean | uninstall | gates | size | api | release | core.wasm | single-order | scallop_order.h) continue ;;
      check | asan | faults | fuzz | lint | valgrind | matrix | coverage) echo tests ;;
      explorer | check-explorer | pictures) echo core.wasm ;;
      test_*) echo test ;;
    esac
    echo build
    [ "${WITH_FLINT:-1}" = 0 ] || echo flint
    [ "${WITH_GSL:-1}" = 0 ] || echo gsl
    [ "${WITH_LIBCONFIG:-1}" = 0 ] || echo libconfig
  done
}
# What for; packages, by their Debian names; the command that tells whether they are there
table() {
  cat <<'ROWS'
build                 | ${compiler##*/} libc6-dev     | found "${CC%% *}"
gsl                   | libgsl-dev                    | header gsl/gsl_roots.h
libconfig             | libconfig-dev                 | header libconfig.h
flint                 | libgmp-dev                    | header gmp.h
flint                 | libflint-dev                  | header flint/fmpq.h
flint                 | libflint-arb-dev              | header arb.h || header flint/arb.h || flint_has_it
test tests flint3 bare | libcmocka-dev                 | header cmocka.h
tests reproduce bare pictures | gnuplot-nox fonts-dejavu-core | found gnuplot
tests reproduce bare docs | python3 python3-jinja2    | module jinja2
tests bare            | locales                       | there /usr/share/i18n/locales/de_DE
tests                 | pkgconf                       | found pkg-config
tests                 | python3-mpmath python3-numpy  | module mpmath,numpy
tests                 | python3-pytest mypy           | module pytest && found mypy
tests                 | python3-venv python3-pip python3-setuptools python3-wheel | module ensurepip && module pip && module setuptools,wheel
layers size bench-sweeps check-report check-explorer pictures | python3 | found /usr/bin/python3
api                   | doxygen python3-sphinx python3-numpy | found doxygen && module sphinx,numpy
check-report check-explorer pictures | chromium       | found chromium || found chromium-browser || found google-chrome
lint                  | clang-tidy clang-format cppcheck | found clang-tidy && found clang-format && found cppcheck
fuzz matrix core.wasm | clang                         | found clang
fuzz                  | libclang-rt-dev               | there /usr/lib/llvm-*/lib/clang/*/lib/linux/libclang_rt.fuzzer-*
coverage              | gcovr                         | found gcovr
valgrind instructions growth | valgrind               | found valgrind
release               | mmdebstrap                    | found mmdebstrap
core.wasm             | lld                           | found wasm-ld
core.wasm             | binaryen                      | found wasm-opt
core.wasm             | wasi-libc                     | there /usr/lib/wasm32-wasi/libc.a
core.wasm             | libclang-rt-dev-wasm32        | there /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a
core.wasm             | nodejs                        | found node
check-cluster         | slurmctld slurmd slurm-client munge parallel procps | found slurmctld && found slurmd && found sbatch && found munged && found parallel
explorer check-explorer pictures | npm                | found npm
ROWS
}
found() { command -v "$1"; }
there() { [ -e "$1" ]; } # of several, the first
module() { /usr/bin/python3 -c "import $1"; }
header() { printf '#include <%s>\n' "$1" | eval "$CC ${CPPFLAGS:-} -E -"; }
flint_has_it() { ! header flint/fmpq.h && ! apt-cache show libflint-arb-dev; } # FLINT 3, which comes without that package
case ${CC%% *} in cc | c99) compiler=gcc ;; *) compiler=${CC%% *} ;; esac

look() { # GOAL...: the packages that are missing
  wanted=" $(purposes "$@" | tr '\n' ' ')"
  table | while IFS='|' read -r purposes packages test; do
    for purpose in $purposes; do
      case $wanted in *" $purpose "*) eval "$test" </dev/null >/dev/null 2>&1 || eval echo "$packages" ;; esac
    done
  done | tr ' ' '\n' | sort -u | tr '\n' ' '
}
[ "$1" != --missing ] || { shift; look "$@"; exit; }
missing=$(look "$@")
[ -n "$missing" ] || exit 0

as_root=$([ "$(id -u)" = 0 ] || echo sudo -n)
if ! $as_root true 2>/dev/null || ! found apt-get >/dev/null; then
  echo "These packages (Debian names) are missing: $missing" >&2
  echo "make installs packages only on Debian, as root or with a sudo that asks for no password." >&2
  echo "Install them, as root: apt-get install $missing" >&2
  exit 2
fi
log=$(mktemp)
trap 'rm -f "$log"' EXIT
$as_root apt-get update -qq >"$log" 2>&1 || true
for _ in 1 2 3 4; do # what apt knows now, or one package, may show that another is missing
  missing=$(look "$@")
  [ -n "$missing" ] || exit 0
  echo "Installing: $missing" >&2
  # shellcheck disable=SC2086
  $as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >>"$log" 2>&1 || break
done
cat "$log" >&2
echo "Still missing: $missing" >&2
exit 2
