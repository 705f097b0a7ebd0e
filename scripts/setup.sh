#!/bin/sh
# Makes sure that what a build needs is there: installs it as root or with sudo on Debian, and
# otherwise says exactly what to install. Usage: scripts/setup.sh build|plots|tests|lint ...
set -eu

has_header() { printf '#include <%s>\n' "$1" | cc -E - >/dev/null 2>&1; }

missing=""
need() { missing="$missing $1"; }
command -v cc >/dev/null 2>&1 || need "gcc libc6-dev"
for purpose in "$@"; do
  case $purpose in
    build)    has_header gsl/gsl_roots.h || need libgsl-dev ;;
    plots)    command -v gnuplot >/dev/null 2>&1 || need "gnuplot-nox fonts-dejavu-core" ;;
    tests)    has_header cmocka.h || need libcmocka-dev
              /usr/bin/python3 -c 'import mpmath' 2>/dev/null || need "python3 python3-mpmath" ;;
    lint)     command -v clang-tidy >/dev/null 2>&1 || need clang-tidy
              command -v clang-format >/dev/null 2>&1 || need clang-format
              command -v cppcheck >/dev/null 2>&1 || need cppcheck ;;
    *)        echo "setup.sh: unknown purpose '$purpose'" >&2; exit 2 ;;
  esac
done
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
echo "Installing:$missing" >&2
export DEBIAN_FRONTEND=noninteractive
# shellcheck disable=SC2086
{ $as_root apt-get update -qq && $as_root apt-get install -y -qq --no-install-recommends $missing; } >&2
