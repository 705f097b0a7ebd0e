#!/bin/sh
# README's commands on the bare systems of scripts/dev/release.txt: release.sh BUILD, with SUITES="SUITE..." only on these; as root, on
# Debian, with the mirror that the machine has its packages from. Each row is a new root file system of what every system of the suite
# has, git and make. There root makes the goals, after `make`. data/ must stay as it is, and `make reproduce` must print the same in each.
# BUILD/release/SUITE-LANG.log has all that was printed.
set -u
mkdir -p "$1/release/root"
release=$(cd "$1/release" && pwd) top=${1%%/*} failed=0 first=''
. scripts/dev/apart.sh
from=$(mirror) || { echo "FAIL apt has no source of packages" >&2; exit 1; }

bare() { # ROOT SUITE: with the sources in its /project, and what makes a locale
  rm -rf "$1"
  mmdebstrap --quiet --variant=minbase --include=git,make "$2" "$1" "deb $from $2 main" || return
  cp /etc/apt/apt.conf.d/* "$1/etc/apt/apt.conf.d"
  cp -r /usr/share/i18n "$1/i18n"
  mkdir "$1/project" && tar --exclude="./$top" --exclude=./.git -cf - . | tar -C "$1/project" -xf -
}
make_in() { # ROOT LANG GOAL...: what a goal prints is in ROOT/GOAL too
  place=$1 language=$2
  shift 2
  # shellcheck disable=SC2016
  unshare -m sh -c 'cd "$0" && mount -t proc proc proc && mount --rbind /dev dev && exec chroot . "$@"' "$place" /usr/bin/env -i \
    PATH="$PATH" HOME=/root http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" I18NPATH=/i18n LOCPATH=/i18n LANG="$language" \
    sh -ec 'localedef -i de_DE -f UTF-8 /i18n/de_DE.UTF-8
      cd /project
      make
      for goal in "$@"; do make "$goal" >"/$goal" || failed=1; cat "/$goal"; [ ! "${failed:-}" ]; done' sh "$@" </dev/null
}
while read -r suite language goals; do
  case $suite in '' | '#'*) continue ;; esac
  case " ${SUITES:-$suite} " in *" $suite "*) ;; *) continue ;; esac
  language=${language#-}
  begun=$(date +%s) root=$release/root/$suite-$language log=$release/$suite-$language.log trouble=''
  # shellcheck disable=SC2086
  { bare "$root" "$suite" && make_in "$root" "$language" $goals; } >"$log" 2>&1 ||
    trouble=$(grep -m 1 -e '^FAIL' -e 'rror: ' "$log" || tail -n 1 "$log")
  [ -n "$trouble" ] || diff -r data "$root/project/data" || trouble="other tables in data/"
  first=${first:-$root}
  [ -n "$trouble" ] || diff "$first/reproduce" "$root/reproduce" || trouble="make reproduce prints something else than in the first row"
  if [ -z "$trouble" ]; then
    echo "ok   $suite, LANG=$language: make $goals, $(($(date +%s) - begun)) s"
  else
    failed=1
    echo "FAIL $suite, LANG=$language: $log: $trouble"
  fi
done <scripts/dev/release.txt
[ $failed = 0 ] && rm -rf "$release/root"
