#!/bin/sh
# The tests under the address, leak and undefined-behaviour sanitizers: asan.sh BUILD, MAKE being set.
# With them gcc 12 warns of regions and texts that cannot be too small.
ASAN_OPTIONS=detect_leaks=1 LSAN_OPTIONS=suppressions=$PWD/tests/support/lsan.supp:print_suppressions=0 exec ${MAKE:-make} check B="$1/asan" CFLAGS="-O1 -g \
  -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all -Wno-stringop-overflow -Wno-stringop-overread -Wno-format-truncation"
