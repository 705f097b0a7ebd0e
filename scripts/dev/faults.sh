#!/bin/sh
# Does a test fail for each fault of tests/faults/*.txt? scripts/dev/faults.sh [--listed] BUILD PROGRAM..., with FAULTS="WORDS" only for those
# whose name or file has the words. A fault is the lines
#     fault: WHAT IT BREAKS
#     file: FILE
#     old: A TEXT THAT ONE LINE OF THE FILE HAS, ONCE
#     new: THE TEXT IN ITS PLACE
#     tests: TEST...
# Each is put into a copy of the tree, what depends on it is built, and the tests run until one fails: those of the list, and, should all of
# them pass, every other one, but with --listed. Prints a line for each fault; exit code 1 if one was not caught, or is not what the sources have.
set -u
listed_only=''
[ "$1" != --listed ] || { listed_only=1; shift; }
build=$1 copy=$1/faults/root begun=$(date +%s)
shift
rm -rf "$copy"
mkdir -p "$copy/build"
tar -cf - --exclude="./${build%%/*}" --exclude=./.git . | tar -C "$copy" -xf -
tar -C "$build" -cf - --exclude=./faults --exclude=./asan --exclude=./matrix --exclude=./coverage --exclude=./release --exclude=./bare . |
  tar -C "$copy/build" -xf -
listed=$PWD/tests/faults all=''
for test in "$@" tests/compare/command/cli_* tables claims; do all="$all $(basename "$test")"; done
cd "$copy" || exit 2

broken() { # FILE: with new in the place of old, which must be there once; the two are in the environment
  awk '
    { rest = $0; while (i = index(rest, ENVIRON["old"])) { found++; rest = substr(rest, i + length(ENVIRON["old"])) } }
    i = index($0, ENVIRON["old"]) { $0 = substr($0, 1, i - 1) ENVIRON["new"] substr($0, i + length(ENVIRON["old"])) }
    { print }
    END { if (found != 1) { print "the old text is there " found + 0 " times" >"/dev/stderr"; exit 1 } }' "$1"
}
made() { # TEST...: builds what these need
  needed=''
  for test in "$@"; do
    case $test in
      test_* | fuzz_*) needed="$needed build/$test" ;;
      *) needed="$needed build/scallop" ;;
    esac
  done
  # shellcheck disable=SC2086
  "${MAKE:-make}" -s B=build $needed >build.log 2>&1
}
caught_by() { # TEST...: the first that fails
  for test in "$@"; do
    timeout 600 sh scripts/dev/test.sh build "$test" </dev/null >test.log 2>&1 || { caught=$test; return; }
  done
  false
}
one() { # looks at the fault that was read
  cp -p "$file" kept || return
  { broken kept >"$file"; } 2>why || { verdict="FAIL   $(cat why)"; return; }
  # shellcheck disable=SC2086
  if ! made $tests; then
    verdict="FAIL   $(grep -m 1 -e 'error:' build.log || tail -n 1 build.log)"
  elif caught_by $tests; then
    verdict="caught $caught"
  elif [ -z "$listed_only" ] && made $all && caught_by $all; then
    verdict="caught $caught, which the fault does not list"
  fi
}
caught_all=0 missed=0
cat "$listed"/*.txt | {
  while IFS= read -r line; do
    text=${line#*: }
    case $line in
      'fault: '*) fault=$text ;;
      'file: '*) file=$text ;;
      'old: '*) export old="$text" ;;
      'new: '*) export new="$text" ;;
      'tests: '*)
        case "$fault $file" in *"${FAULTS:-}"*) ;; *) continue ;; esac
        tests=$text verdict='MISSED no test fails' since=$(date +%s)
        one
        cat kept >"$file" # with a new date: what was built of the fault is built again
        printf '%s: %s: %s (%d s)\n' "$verdict" "$file" "$fault" $(($(date +%s) - since))
        case $verdict in caught*) caught_all=$((caught_all + 1)) ;; *) missed=$((missed + 1)) ;; esac
        ;;
      '' | '#'*) ;;
      *) echo "FAIL   no line of a fault: $line"; missed=$((missed + 1)) ;;
    esac
  done
  echo "$caught_all faults caught, $missed not, in $(($(date +%s) - begun)) s"
  [ $missed = 0 ] && [ $caught_all -gt 0 ]
}
