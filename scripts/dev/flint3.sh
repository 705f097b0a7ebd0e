#!/bin/sh
# Does the code compile with FLINT 3, whatever FLINT the machine has? flint3.sh BUILD, MAKE being set. Takes the headers of Debian's suite
# trixie from the mirror that the machine has its packages from, and compiles every source with them, without optimisation.
set -u
mkdir -p "$1/flint3" && folder=$(cd "$1/flint3" && pwd)
trap 'rm -rf "$folder"' EXIT
. scripts/dev/apart.sh
from=$(mirror) && (apart "$folder/apt" "$from trixie main" && cd "$folder" && apt-get download -qq libflint-dev && dpkg -x libflint-dev_*.deb .) ||
  { echo "FAIL no libflint-dev of Debian trixie: ${from:-apt has no source of packages}" >&2; exit 1; }
basename "$folder"/*.deb .deb
# shellcheck disable=SC2046
$MAKE -k B="$folder" CFLAGS=-O0 CPPFLAGS="-isystem $folder/usr/include ${CPPFLAGS:-}" \
  $(find model asymptotics numerics compare tests bench -name '*.c' ! -name installed.c | sed "s|\(.*\)c\$|$folder/\1o|")
