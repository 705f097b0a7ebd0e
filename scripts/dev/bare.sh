#!/bin/sh
# Does each goal of scripts/dev/bare.txt ask for what it needs, at once, and for nothing else? bare.sh BUILD; as root, on Debian; without
# network. A root file system in BUILD/bare has, of the files of this machine, those of the packages that every Debian has, and of make.
# There `make GOAL` asks for packages; with these and no other packages a user without rights makes the goal, where decimals have a comma.
set -u
umask 022
[ "$(id -u)" = 0 ] || { echo "FAIL make bare must be root: it makes a root file system, and runs make in it" >&2; exit 1; }
rm -rf "$1/bare"
mkdir -p "$1/bare/packages" "$1/bare/root" "$1/bare/project/.locale"
bare=$(cd "$1/bare" && pwd) root=$bare/root log=$bare/log failed=0
. scripts/dev/apart.sh

# What is installed here, as packages of which apt knows what they need
awk -v RS= -v ORS='\n\n' '/\nStatus: install ok installed/' /var/lib/dpkg/status |
  sed -e "s/^Status:.*/Filename: none\nSize: 1\nSHA256: $(printf '%064d' 0)/" -e '/^Conffiles:/d' -e '/^ /d' >"$bare/packages/Packages"
apart "$bare/apt" "[trusted=yes] file:$bare/packages ./" || exit 1
every=$(dpkg-query -W -f '${Package} ${Essential} ${Priority}\n' | awk '$2 == "yes" || $3 == "required" { print $1 }')

fill() { # ROOT PACKAGE...: it has the files of these packages, and of all that they need
  place=$root/$1
  shift
  rm -rf "$place"
  for folder in project proc dev etc tmp var/lib/dpkg usr/bin usr/sbin usr/lib usr/lib32 usr/lib64 usr/libx32; do mkdir -p "$place/$folder"; done
  chmod 1777 "$place/tmp"
  # shellcheck disable=SC2086
  apt-get install -s -qq --no-install-recommends $every make "$@" >"$bare/solved" || return 1
  {
    echo /etc/passwd
    sed -n 's/^Inst \([^ ]*\).*/\1/p' "$bare/solved" | xargs dpkg -L
    find /usr /etc/alternatives -type l \( -lname '/etc/alternatives/*' -o -path '/etc/alternatives/*' \)
  } | grep '^/.*[^.]$' | grep -v -E '^/usr/share/(doc|man|locale|info)/' | sort -u |
    tar -C / --no-recursion --ignore-failed-read -cf - -T - 2>"$bare/tar.log" | tar -C "$place" -xf -
  cp "$bare/packages/Packages" "$place/var/lib/dpkg/status" # for apt-cache there
  ldconfig -r "$place"
}
make_in() { # ROOT GOAL
  unshare -m sh -c 'mount --bind "$2" "$1/project" && mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" && cd / &&
    exec chroot --userspec=65534:65534 "$1" /usr/bin/env -i PATH=/usr/bin:/bin HOME=/tmp LANG=de_DE.UTF-8 LOCPATH=/project/.locale \
    sh -c "cd /project && make $3 DESTDIR=/tmp/installed"' sh "$root/$1" "$bare/project" "$2" >"$log" 2>&1 </dev/null
}
sorted() { tr ' ' '\n' | sed '/^$/d' | sort | tr '\n' ' '; }

tar --exclude="./${1%%/*}" --exclude=./.git -cf - . | tar -C "$bare/project" -xf -
localedef -i de_DE -f UTF-8 "$bare/project/.locale/de_DE.UTF-8"
chown -R 65534:65534 "$bare/project"
fill base || exit 1
holds='' all=''
while read -r goal packages; do
  case $goal in '' | '#'*) continue ;; esac
  begun=$(date +%s) trouble=''
  [ "$goal" != all ] || all=$packages
  case $packages in all*) packages="$all${packages#all}" ;; esac
  apt-cache show libflint-arb-dev >/dev/null 2>&1 || packages=$(echo "$packages" | sed 's/libflint-arb-dev//')
  wanted=$(echo "$packages" | sorted)
  make_in base "$goal"
  code=$? asked=$(sed -n 's/.*apt-get install //p' "$log" | sorted)
  if [ "$asked" != "$wanted" ]; then
    trouble="asks for ${asked:-nothing}, not for ${wanted:-nothing}"
  elif [ -n "$wanted" ]; then
    # shellcheck disable=SC2086
    [ "$holds" = "$wanted" ] || { fill goal $wanted && holds=$wanted; }
    make_in goal "$goal"
    code=$?
  fi
  [ -n "$trouble" ] || [ $code = 0 ] || trouble=$(grep -m 1 -e 'rror: ' -e 'ot found' -e 'annot find' -e 'No such' "$log" || tail -n 1 "$log")
  [ -n "$trouble" ] || trouble=$(grep -m 1 'warning: ' "$log")
  if [ -z "$trouble" ]; then
    echo "ok   make $goal, $(($(date +%s) - begun)) s"
  else
    failed=1
    echo "FAIL make $goal: $trouble"
    cat "$log"
  fi
done <scripts/dev/bare.txt
diff -r data "$bare/project/data" && [ $failed = 0 ] && rm -rf "$bare"
