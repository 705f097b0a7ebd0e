#!/bin/sh
# What make does before and beside its goals: tools that are missing, make -n, what was remade, and the count of make check.
# Usage: sh tests/compare/command/cli_make.sh build/scallop
# shellcheck disable=SC2154
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"
build=$(dirname "$tool")
unset MAKEFLAGS MFLAGS MAKELEVEL CPPFLAGS

# A machine with a user of this number, whose sudo wants a password, and where apt-get brings the compiler that is missing, or fails
mkdir bin
put() { printf '#!/bin/sh\n%s\n' "$2" >"bin/$1" && chmod +x "bin/$1"; }
put id 'echo $NUMBER'
put sudo 'exit 1'
put apt-get "echo \"\$*\" >>\"$scratch/asked\"; echo Unpacking; [ \$1 = update ] || \$APT"
put bring "printf '#!/bin/sh\nexec cc \"\$@\"\n' >\"$scratch/bin/absent-cc\"; chmod +x \"$scratch/bin/absent-cc\""
on_it() { # COMMAND...: with a compiler that is missing
  rm -f asked bin/absent-cc
  (cd "$root" && PATH="$scratch/bin:$PATH" NUMBER=${user:-0} APT=${apt:-false} CC=absent-cc "$@") >out 2>err
  code=$?
}
setup=scripts/dev/setup.sh
on_it "${MAKE:-make}" -n B="$scratch/none" all
[ $code = 0 ] && [ ! -e asked ] || note "exit code $code: $(cat asked err)"
finish "make -n installs nothing"
for goal in help clean uninstall size gates; do
  on_it $setup $goal
  [ $code = 0 ] && [ ! -e asked ] || note "make $goal asks for $(cat asked err)"
done
finish "what compiles nothing needs no compiler"

object=$scratch/checked/compare/config/config.o
(cd "$root" && "${MAKE:-make}" B="$scratch/checked" CFLAGS='-O1 -fsanitize=address,undefined' "$object") >out 2>err || note "$(grep -m 1 error err)"
finish "the sanitizers of gcc at -O1 bring no warning"

apt=bring
on_it $setup all
[ $code = 0 ] && [ "$(cut -c 1-32 err)" = "Installing: absent-cc libc6-dev " ] || note "exit code $code: $(cat out err)"
grep -q '^install .* absent-cc libc6-dev ' asked || note "apt-get was asked for $(cat asked)"
finish "what is missing is installed, quietly"
apt=false
on_it $setup all
[ $code = 2 ] && grep -q '^Unpacking$' err && grep -q '^Still missing: .*absent-cc' err || note "exit code $code: $(cat out err)"
finish "what apt-get said is shown where it fails"
user=1000
on_it $setup all
[ $code = 2 ] && [ ! -e asked ] || note "exit code $code: $(cat out err)"
grep -q '^Install them, as root: apt-get install .*absent-cc' err && grep -q 'a sudo that asks for no password' err || note "$(cat err)"
finish "a user is told what to install"

mkdir -p "a prefix/gsl" && : >"a prefix/gsl/gsl_roots.h"
looked() { (cd "$root" && CC='cc -nostdinc' CPPFLAGS=$1 $setup --missing all); }
case $(looked '') in *libgsl-dev*) ;; *) note "libgsl-dev is not missed" ;; esac
case $(looked "-I'$scratch/a prefix'") in *libgsl-dev*) note "libgsl-dev is missed" ;; *libconfig-dev*) ;; *) note "libconfig-dev is not missed" ;; esac
finish "headers are looked for where CPPFLAGS says"

# -W takes a file for a new one
(cd "$root" && "${MAKE:-make}" -n B="$build" -W scripts/dev/embed.sh all) >out 2>&1 || note "exit code $?"
grep -q 'shipped_scenes' out || note "nothing is remade"
grep -e 'error: ' -e '\.d\.c' out >said && note "$(head -n 3 said)"
finish "make after a change of what writes sources"

# A test program of two tests, of which one fails, beside tests that are skipped, or pass
mkdir -p tests/explorer scripts/python
echo 'echo skipped: here' >tests/explorer/core.sh
: >scripts/python/reference.py
cat >test_one <<'END_OF_TEST'
#!/bin/sh
printf '[ RUN      ] a_1\n[       OK ] a_1\n[ RUN      ] b\n[  FAILED  ] b\n[==========] 2 test(s) run.\n'
printf '[  FAILED  ] 1 test(s), listed below:\n[  FAILED  ] b\n'
exit 1
END_OF_TEST
chmod +x test_one
WITH_FLINT=0 sh "$root/scripts/dev/check.sh" "$scratch" test_one >out 2>&1 && note "it passes"
[ "$(tail -n 1 out)" = "1 passed, 1 failed" ] || note "$(tail -n 1 out)"
finish "a test that fails counts once"
exit $failed
