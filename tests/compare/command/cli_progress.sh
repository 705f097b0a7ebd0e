#!/bin/sh
# The line about long work: on a terminal, with the time left, and nowhere else.
. tests/support/common.sh
[ "${WITH_FLINT:-1}" != 0 ] || exit 0

cat >watch.py <<'END'
import os, pty, re, sys
pid, terminal = pty.fork()
if pid == 0:
    os.execv(sys.argv[1], sys.argv[1:])
said = b""
try:
    while not re.search(rb"\r\x1b\[Kscallop: .*[0-9]+ of [0-9]+, [0-9]+ s, about [0-9]+ s left, [0-9]+ in 10 s", said):
        said += os.read(terminal, 4096) or sys.exit("no line, but: " + repr(said[-200:]))
except OSError:
    sys.exit("no line, but: " + repr(said[-200:]))
finally:
    os.kill(pid, 9)
END
# Work that goes on until it is ended. The noisy gait has more modes in a phase than are kept, of which the transitions went beyond the end.
awk 'BEGIN { print "T"; for (i = 0; i < 100000; i++) print 1 + i/1e5 }' >rows.tsv
awk 'BEGIN { for (i = 0; i <= 400; i++) print i/400, 3 - cos(i*atan2(0, -1)/200)/2 + 0.005*(i % 400 ? sin(i*i) : 0) }' >noisy.tsv
awk 'BEGIN { for (i = 0; i < 3000; i++) printf "%s{ name = \"f%d\"; of = \"v_end\"; claimed = 3; text = \"(F1-F2)/M*T + %d*T^3\"; }", i ? "," : "formulas = (", i, i; print ");" }' >mine.cfg
keep_counts_apart
for command in "stress --cases 100000 -o none" "steady --T 1:2:900000000 -o none" "breakdown --map F1/F2 T --x 1:9:3000 --y 1:2:3000 -o none" \
  "breakdown --map F1/F2 T --boundaries --x 1:9:2001 --y 1:2:2001 -o none" \
  "steady --certified --points rows.tsv -o none" "breakdown --gait measured:noisy.tsv" \
  "breakdown --gait measured:noisy.tsv --only transition" "workprec -o none" "claims --gait sinusoidal" "claims --formulas mine.cfg"; do
  # shellcheck disable=SC2086
  /usr/bin/python3 watch.py "$tool" $command >said 2>&1 || note "$command: $(cat said)"
done
rm -f none*
finish "a line on a terminal with the time left"

"$tool" claims --gait sinusoidal >out 2>err
! grep -q "$(printf '\033')" out err || note "a line where there is no terminal: $(head -c 200 err)"
finish "no line where there is no terminal"
exit $failed
