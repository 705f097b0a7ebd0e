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
run() { # CODE ARGUMENT...
  wanted=$1
  shift
  "$tool" "$@" </dev/null >out 2>err
  code=$?
  [ "$code" = "$wanted" ] || note "scallop $* gives exit code $code, not $wanted: $(head -n 2 err)"
}
cells() { # FILE COLUMN...: those columns of every row, separated by blanks
  file=$1
  shift
  sed '/^#/d' "$file" | awk -F '\t' -v names="$*" '
    NR == 1 { n = split(names, name, " "); for (i = 1; i <= NF; i++) at[$i] = i; next }
    { for (i = 1; i <= n; i++) printf "%s%s", $(at[name[i]]), i < n ? " " : "\n" }'
}
