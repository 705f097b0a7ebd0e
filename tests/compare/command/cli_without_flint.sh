#!/bin/sh
# Without FLINT: the command does not load it, and where scallop-flint.so is not there everything else works, and what needs it
# says so.
. "$(dirname "$0")/../../support/common.sh"
cp "$tool" alone
tool=$scratch/alone

ldd "$tool" >libraries 2>&1
! grep -q -E 'flint|libarb|libgmp' libraries || note "linked with $(grep -E 'flint|libarb|libgmp' libraries)"
finish "no FLINT in the program"

for arguments in steady phase 'trajectory --periods 1' series 'figure 4'; do
  # shellcheck disable=SC2086
  run 0 $arguments
  [ -s out ] || note "scallop $arguments prints nothing"
done
finish "the rest works"

lacks() { # NAME ARGUMENT...
  name=$1
  shift
  run 3 "$@"
  [ ! -s out ] || note "something on standard output"
  grep -q 'FLINT' err || note "scallop $*: $(cat err)"
  [ "$(wc -l <err)" = 1 ] || note "more than one line: $(cat err)"
  finish "$name"
}
lacks "claims says what is missing" claims
lacks "steady --certified says what is missing" steady --certified
lacks "phase --certified says what is missing" phase --certified --digits 40
lacks "series --source derived says what is missing" series --source derived
lacks "series --source limit says what is missing" series --source limit
lacks "series --bound says what is missing" series --bound
lacks "workprec says what is missing" workprec --quick
printf 'old\n' >kept
run 3 claims -o kept
[ "$(cat kept)" = old ] || note "the earlier file is gone"
finish "an existing output stays"
exit $failed
