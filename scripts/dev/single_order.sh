#!/bin/sh
# The estimator of orders as one file of C99, which is C++17 too: asymptotics/observed in the order in which its parts need each other. What its
# files share is static there. Usage: single_order.sh >scallop_order.h
set -eu
cd asymptotics/observed
version=$(sed -n 's/^#define SCALLOP_VERSION "\(.*\)"/\1/p' ../../model/version.h)
guarded() { sed -e '/^#ifndef SCALLOP_ASYMPTOTICS_/d' -e '/^#define SCALLOP_ASYMPTOTICS_/d' -e '/^#include "/d' -e '$d' "$1"; } # without its guard
cat <<HEAD
/* scallop_order.h $version: the observed order of a table of h and err, with a verdict. One file of C99, and of C++17; needs libm.
 * Include it where scallop_order() is called; in one file, define SCALLOP_ORDER_IMPLEMENTATION before.
 * Made by \`make single-order\` of the crawling-scallop toolkit: do not edit.
 *
HEAD
sed -e 's/^/ * /' -e 's/ *$//' ../../LICENSE
cat <<'HEAD'
 */
#ifndef SCALLOP_ORDER_H
#define SCALLOP_ORDER_H

HEAD
guarded order.h
printf '#endif\n\n#if defined(SCALLOP_ORDER_IMPLEMENTATION) && !defined(SCALLOP_ORDER_IMPLEMENTED)\n#define SCALLOP_ORDER_IMPLEMENTED\n\n'
guarded judged.h | sed -e 's/ __attribute__((.*))//' -e 's/^\([a-z].*(.*);\)$/static \1/'
for part in student points values floor trend verdict; do
  sed '/^#include "/d' $part.c
done
printf '\n#endif\n'
