#!/bin/sh
# A sweep on a cluster that fails: the Slurm script and the line of GNU parallel of docs/guide/sweeps.md, as they stand there, on a private Slurm of
# four nodes on this machine, of which one is killed (SIGKILL) while it computes, and then lacks until the end. The merged shards have to be the
# bytes of a single run. check-cluster.sh BUILD. All files are in a temporary folder, and only what this script started is ended.
set -u
tool=$(cd "$1" && pwd)/scallop page=$(pwd)/docs/guide/sweeps.md
folder=$(mktemp -d) || exit 1
started='' passed=0 failed=0
leave() {
  trap - EXIT
  [ ! -d "$folder/shards" ] || scancel -u "$(id -un)" 2>/dev/null # of this Slurm: SLURM_CONF
  # what runs the jobs of a node that was killed has lost its parent: each job notes both
  for process in $started $(cat "$folder"/processes 2>/dev/null); do
    [ "$process" -gt 1 ] && grep -qs "slurm\|munged\|job" "/proc/$process/cmdline" && kill "$process" 2>/dev/null
  done
  wait
  rm -rf "$folder"
}
trap leave EXIT
trap 'exit 1' HUP INT TERM
give_up() { echo "FAIL the cluster cannot start: $*"; tail -n 3 "$folder"/*.log "$folder"/munge/log 2>/dev/null; echo "$passed passed, 1 failed"; exit 1; }
result() { # NAME: of the command before
  if [ "$?" = 0 ]; then passed=$((passed + 1)); echo "ok   $1"; else failed=$((failed + 1)); echo "FAIL $1"; fi
}
until_it_is() { # SECONDS COMMAND...
  left=$(($1 * 10))
  shift
  until "$@" >/dev/null 2>&1; do
    left=$((left - 1))
    [ $left -gt 0 ] || return 1
    sleep 0.1
  done
}
block() { awk -v what="$1" '/^```/ { if (found) exit; inside = !inside; text = ""; next } inside { text = text $0 "\n"; found = found || index($0, what) } END { printf "%s", text }' "$page"; }
as_root_itself() { [ "$(id -u)" = 0 ]; }
as_root_itself || give_up "slurmd and munged of a user of their own need root here"

# ---- a Slurm of four nodes ----
mkdir "$folder/state" "$folder/munge" "$folder/shards" "$folder/parallel" "$folder/bin"
ln -s "$tool" "$folder/bin/scallop"
chmod 755 "$folder" "$folder/munge"
head -c 1024 /dev/urandom >"$folder/munge/key"
chmod 600 "$folder/munge/key"
port=$((20000 + $$ % 20000))
cat >"$folder/slurm.conf" <<END
ClusterName=sweep
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$folder/munge/socket
SlurmctldPort=$port
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/%n.spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SlurmdParameters=config_overrides
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdTimeout=5
KillWait=1
ReturnToService=2
MailProg=/bin/true
NodeName=n[1-4] NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=[$((port + 1))-$((port + 4))] CPUs=1
PartitionName=all Nodes=ALL Default=YES
END
export SLURM_CONF="$folder/slurm.conf" PATH="$folder/bin:$PATH"
munged --foreground --force --socket="$folder/munge/socket" --key-file="$folder/munge/key" --log-file="$folder/munge/log" \
  --pid-file="$folder/munge/pid" --seed-file="$folder/munge/seed" >"$folder/munged.log" 2>&1 &
started="$started $!"
until_it_is 10 [ -S "$folder/munge/socket" ] || give_up "munged does not answer"
slurmctld -D >"$folder/ctld.out" 2>&1 &
started="$started $!"
for n in 1 2 3 4; do
  slurmd -D -N n$n >"$folder/n$n.out" 2>&1 &
  started="$started $!"
  [ $n != 4 ] || killed=$!
done
all_idle() { [ "$(sinfo -h -o '%D %t')" = "4 idle" ]; }
until_it_is 60 all_idle || give_up "its nodes are not idle: $(sinfo -h -o '%D %t' 2>&1 | tr '\n' ' ')"

# ---- the documents' script, with a node that dies ----
block '#SBATCH' >"$folder/job.sh"
grep -q '^scallop steady ' "$folder/job.sh" || give_up "docs/guide/sweeps.md has no script for Slurm"
command=$(sed -n '/^scallop steady/,$p' "$folder/job.sh" | tr -d '\\\n' | sed 's/ --shard.*//; s/  */ /g')
sed "/^scallop/i echo \$\$ \$PPID >>$folder/processes; [ \"\$SLURMD_NODENAME\" != n4 ] || echo \$\$ \$PPID \$SLURM_ARRAY_TASK_ID >>$folder/on-n4" \
  "$folder/job.sh" >"$folder/noted.sh"
$command --threads 1 --quiet -o "$folder/whole.tsv"
[ "$(grep -vc '^#' "$folder/whole.tsv")" = 1000001 ]
result "a single run: $(wc -c <"$folder/whole.tsv") bytes"
(cd "$folder/shards" && sbatch --parsable "$folder/noted.sh") >"$folder/job" || give_up "sbatch: $(cat "$folder/job")"
until_it_is 60 [ -s "$folder/on-n4" ] || give_up "no shard comes to the fourth node"
sleep 0.3
read -r job step lost <<END
$(tail -n 1 "$folder/on-n4")
END
kill -KILL "$killed" "$step" "$job" $(ps -o pid= --ppid "$job") # as when its power goes
[ ! -e "$folder/shards/part-$lost.tsv" ]
result "a node dies while it computes shard $lost"
no_jobs() { [ -z "$(squeue -h)" ]; }
until_it_is 150 no_jobs
result "the array ends"
grep -q 'requeue job .*due to failure of node n4' "$folder/slurmctld.log"
result "Slurm has queued it again: $(grep -o 'requeue job .*' "$folder/slurmctld.log" | head -n 1)"
"$tool" merge "$folder"/shards/part-*.tsv | cmp - "$folder/whole.tsv"
result "the shards of Slurm give the bytes of the single run"

# ---- the same by GNU parallel, interrupted once ----
block 'parallel ' >"$folder/line.sh"
cd "$folder/parallel" || exit 1
echo y | parallel --citation >/dev/null 2>&1
timeout -s TERM 3 sh "$folder/line.sh" >/dev/null 2>&1
done_before=$(find . -name 'part-*.tsv' | wc -l)
sh "$folder/line.sh" && cmp all.tsv "$folder/whole.tsv"
result "the shards of GNU parallel, of which $done_before were there after 3 seconds, give the bytes of the single run"
cd / || exit 1
echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
