# Shared by the tests of the command line, which give it the command as $1: a scratch folder as the current one,
# and one line "ok NAME" or "FAIL NAME: what" for each check.
set -u
export LC_ALL=C.UTF-8
tool=$(cd "$(dirname "$1")" && pwd)/$(basename "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
trap 'exit 1' HUP INT TERM
cd "$scratch" || exit 1
failed=0 problem=''

note() { problem="$problem$*; "; }
finish() { # NAME: of the checks since the last one
  if [ -z "$problem" ]; then
    echo "ok $1"
  else
    echo "FAIL $1: $problem"
    failed=1
  fi
  problem=''
}
# make coverage: a run that is killed, or whose files must not grow, leaves half a file of counts, which no other run may read
keep_counts_apart() { export GCOV_PREFIX="$scratch/counts" GCOV_ERROR_FILE=/dev/null; }
# A command where numbers have a decimal comma, in a locale that is made here, since few machines have it
in_german() { # COMMAND...
  [ -d "$scratch/locale" ] || { mkdir "$scratch/locale" && localedef -i de_DE -f UTF-8 "$scratch/locale/de_DE.UTF-8"; } || return
  env -u LC_ALL LOCPATH="$scratch/locale" LANG=de_DE.UTF-8 "$@"
}
run() { # CODE ARGUMENT...
  wanted=$1
  shift
  "$tool" "$@" </dev/null >out 2>err
  code=$?
  [ "$code" = "$wanted" ] || note "scallop $* gives exit code $code, not $wanted: $(head -n 2 err)"
}
# The help of a command or topic, each item of a list on one line
help_of() { "$tool" help "$1" | awk '/^                    / { sub(/^ +/, ""); printf " %s", $0; next } { printf "%s%s", (NR == 1 ? "" : "\n"), $0 } END { print "" }'; }
header() { sed '/^#/d; q' "$1" | tr '\t' ' '; }
rows() { sed '/^#/d' "$1" | sed 1d; }
cells() { # FILE COLUMN...: those columns of every row, separated by blanks
  file=$1
  shift
  sed '/^#/d' "$file" | awk -F '\t' -v names="$*" '
    NR == 1 { n = split(names, name, " "); for (i = 1; i <= NF; i++) at[$i] = i; next }
    { for (i = 1; i <= n; i++) printf "%s%s", $(at[name[i]]), i < n ? " " : "\n" }'
}
# The Python below has this in front. bad(text) notes a problem; it is printed and shown by python().
cat >tables.py <<'END'
import json, math, re, sys
def read(name):
    lines = [l.rstrip("\n").split("\t") for l in open(name, encoding="utf-8") if not l.startswith("#")]
    return [dict(zip(lines[0], l)) for l in lines[1:]]
def number(row, *names):
    values = [float(row[n]) for n in names]
    return values[0] if len(values) == 1 else values
def near(a, b, tolerance):
    return abs(a - b) <= tolerance * max(abs(a), abs(b))
def bad(*text):
    print(*text)
    sys.exit()
END
python() { # reads the program from standard input; its arguments follow
  cat tables.py - >program.py
  /usr/bin/python3 program.py "$@" >said 2>&1 || note "python: $(tail -n 1 said)"
  [ ! -s said ] || note "$(head -n 3 said)"
}
