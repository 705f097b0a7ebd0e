#!/bin/sh
# make reproduce makes what is not there, or is another one, and nothing else. Usage: sh tests/compare/command/cli_reproduce.sh build/scallop
# shellcheck disable=SC2154
root=$(cd "$(dirname "$0")/../../.." && pwd)
. "$(dirname "$0")/../../support/common.sh"

# Two tables that take no time, and steps behind them that tell that they were there
mkdir -p build data/scenes scripts/dev scripts/plots/plot scripts/report
cp "$root"/data/scenes/figure[25].cfg data/scenes
cp "$root"/data/claims.tsv "$root"/data/workprec.tsv data
cp "$root/scripts/dev/reproduce.sh" scripts/dev
cp "$root/scripts/plots/cheapest.awk" scripts/plots
touch scripts/plots/plot/map.awk scripts/plots/map_labels.awk
cat >build/scallop <<END
#!/bin/sh
[ "\$1" = claims ] && exit
echo "\$2" >>made
exec "$tool" "\$@"
END
chmod +x build/scallop
# shellcheck disable=SC2016
echo 'echo maps >>made; mkdir -p "$2"; echo grid >"$2/grid.tsv"' >scripts/dev/maps.sh
# shellcheck disable=SC2016
echo 'echo plots >>made; mkdir -p "$2"; cat "$1"/figure*.tsv >"$2/figure.svg"' >scripts/plots/draw.sh
echo 'import os; print("report", file=open("made", "a")); os.makedirs("build/report", exist_ok=True); open("build/report/index.html", "w").write("page")' >scripts/report/report.py
makes() { # WANTED: the steps, in one line
  : >made
  sh scripts/dev/reproduce.sh build >out 2>err || note "exit code $?: $(head -n 3 err)"
  [ "$(tr '\n' ' ' <made)" = "$1" ] || note "made: $(tr '\n' ' ' <made), and not $1"
  grep -q 'Refuted under' out || note "no summary: $(tail -n 2 out)"
  [ ! -s err ] || note "on standard error: $(head -n 2 err)"
}
all='data/scenes/figure2.cfg data/scenes/figure5.cfg maps plots report '
makes "$all"
cp data/figure2.tsv first
makes ''
rm data/figure2.tsv
makes 'data/scenes/figure2.cfg '
cmp -s first data/figure2.tsv || note "figure2 is another table"
echo '# more' >>data/scenes/figure5.cfg
makes 'data/scenes/figure5.cfg report '
echo '# changed' >>data/figure5.tsv
makes 'data/scenes/figure5.cfg '
echo '# another program' >>build/scallop
makes "$all"
rm build/plots/figure.svg
makes 'plots ' # the same plots, so that the report stays
finish "what is there is not made again"

cat >watch.py <<'END'
import os, pty, sys
pid, terminal = pty.fork()
if pid == 0:
    os.execvp("sh", ["sh", "scripts/dev/reproduce.sh", "build"])
said = b""
try:
    while True:
        said += os.read(terminal, 4096) or sys.exit()
except OSError:
    os.waitpid(pid, 0)
    sys.stdout.buffer.write(said)
END
echo '# once more' >>build/scallop
/usr/bin/python3 watch.py >said
grep -q 'reproduce: 1 of 5: figure2, 0 s, about [0-9]* s left' said || note "no first line: $(head -c 300 said)"
grep -q 'reproduce: 5 of 5: report, [0-9]* s, about [0-9]* s left' said || note "no last line: $(head -c 900 said)"
finish "on a terminal the step, and the time left"
exit $failed
