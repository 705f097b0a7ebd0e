#!/bin/sh
# Runs the gates of a table one after another: scripts/dev/gates.sh [--ci] TABLE LOGS [NAME...], only the named ones where there are names. A
# row of the table is a name, "ci" or "-", and a command; # begins a comment. Prints a row for each gate: its name, passed or FAILED,
# seconds, and what fails; for one that was not run, when it last passed, and on which commit. LOGS/NAME.log has all that the gate printed,
# LOGS/passed the last time of each. Exit code 1 if a gate failed, 2 if the table has none, or none of a name.
# --ci: only the rows with "ci", with all that they print; the first failure ends the run.
set -u
ci=''
[ "$1" != --ci ] || { ci=ci; shift; }
table=$1 logs=$2 count=0 failed=0
shift 2
mkdir -p "$logs"
rm -f "$logs"/*.log "$logs"/*.code
touch "$logs/passed"
if [ -n "$ci" ]; then exec 3>&1; else exec 3>/dev/null; fi

for name in "$@"; do
  grep -q "^$name " "$table" || { echo "gates.sh: $table has no gate '$name'" >&2; exit 2; }
done
what_fails() { # LOG
  { grep -e '^FAIL' -e 'error: ' -e 'ERROR: ' "$1" || tail -n 1 "$1"; } | head -n 1 | cut -c 1-150
}
note_passed() { # NAME
  grep -v "^$1 " "$logs/passed" >"$logs/passed.new"
  echo "$1 $(date '+%Y-%m-%d %H:%M') on $(git describe --always --dirty='-with-changes' 2>/dev/null || echo 'no commit')" >>"$logs/passed.new"
  mv "$logs/passed.new" "$logs/passed"
}
not_run() { # NAME
  last=$(sed -n "s/^$1 //p" "$logs/passed")
  printf '%-10s not run: %s\n' "$1" "${last:+passed }${last:-it has never passed here}"
}
while read -r name where command; do
  case $name in '' | '#'*) continue ;; esac
  wanted=$ci
  [ -n "$ci" ] || wanted=$where
  [ $# = 0 ] || case " $* " in *" $name "*) ;; *) wanted='none' ;; esac
  if [ "$where" != "$wanted" ] || { [ -n "$ci" ] && [ $failed = 1 ]; }; then
    not_run "$name"
    continue
  fi
  count=$((count + 1))
  log=$logs/$name.log begun=$(date +%s)
  { sh -c "$command" </dev/null 2>&1; echo $? >"$logs/$name.code"; } | tee "$log" >&3
  seconds=$(($(date +%s) - begun))
  if [ "$(cat "$logs/$name.code")" = 0 ]; then
    printf '%-10s passed %6d s\n' "$name" $seconds
    note_passed "$name"
  else
    failed=1
    printf '%-10s FAILED %6d s  %s: %s\n' "$name" $seconds "$log" "$(what_fails "$log")"
  fi
done <"$table"
[ $count -gt 0 ] || { echo "gates.sh: $table has no gate" >&2; exit 2; }
exit $failed
