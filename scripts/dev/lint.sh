#!/bin/sh
# Wordings (prose.py), then clang-format, cppcheck and clang-tidy on every source: lint.sh BUILD
set -eu
/usr/bin/python3 "$(dirname "$0")/prose.py"
folders="model asymptotics numerics compare tests bench"
# shellcheck disable=SC2086
sources=$(find $folders -name '*.c')
# shellcheck disable=SC2086
clang-format --dry-run -Werror $sources explorer/*.[ch] scallop.h $(find $folders -name '*.h')
# shellcheck disable=SC2086
cppcheck --quiet --std=c11 --enable=warning,performance,portability --inline-suppr --error-exitcode=1 -I. $sources explorer/*.c
# shellcheck disable=SC2016
echo "$sources" | xargs -n 8 -P "$(getconf _NPROCESSORS_ONLN)" sh -c 'clang-tidy --quiet "$@" -- -std=c11 -D_XOPEN_SOURCE=700 -I.' clang-tidy
