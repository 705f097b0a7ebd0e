#!/bin/sh
# Runs the gates of a table one after another: scripts/dev/gates.sh [--ci] TABLE LOGS. A row of the table is a name, "ci" or "-", and a
# command; # begins a comment. Prints a row for each gate: its name, passed or FAILED, seconds, and what fails; LOGS/NAME.log has all
# that the gate printed. Exit code 1 if a gate failed, 2 if the table has none.
# --ci: only the rows with "ci", with all that they print; the first failure ends the run.
set -u
ci=''
[ "$1" != --ci ] || { ci=ci; shift; }
table=$1 logs=$2 count=0 failed=0
rm -rf "$logs"
mkdir -p "$logs"
if [ -n "$ci" ]; then exec 3>&1; else exec 3>/dev/null; fi

what_fails() { # LOG
  { grep -e '^FAIL' -e 'error: ' -e 'ERROR: ' "$1" || tail -n 1 "$1"; } | head -n 1 | cut -c 1-150
}
while read -r name where command; do
  case $name in '' | '#'*) continue ;; esac
  [ -z "$ci" ] || [ "$where" = ci ] || continue
  count=$((count + 1))
  log=$logs/$name.log begun=$(date +%s)
  { sh -c "$command" </dev/null 2>&1; echo $? >"$logs/$name.code"; } | tee "$log" >&3
  seconds=$(($(date +%s) - begun))
  if [ "$(cat "$logs/$name.code")" = 0 ]; then
    printf '%-10s passed %6d s\n' "$name" $seconds
  else
    failed=1
    printf '%-10s FAILED %6d s  %s: %s\n' "$name" $seconds "$log" "$(what_fails "$log")"
    [ -z "$ci" ] || break
  fi
done <"$table"
[ $count -gt 0 ] || { echo "gates.sh: $table has no gate" >&2; exit 2; }
exit $failed
