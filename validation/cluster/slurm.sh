#!/bin/bash
# One SLURM controller and one node on loopback, from Debian's packages, and on them the same studies in one process, 1, 2 and 16 array tasks,
# and with a task killed in the middle: the bytes must be the same.
#
#     apt-get install slurm-wlm munge
#     cargo build -p truegap-cli
#     validation/cluster/slurm.sh            # as root: slurmd starts jobs
#     STUDIES=audit DESIGNS=32 validation/cluster/slurm.sh
#
# Leaves nothing running: what it started, it ends by process id.
set -u
cd "$(dirname "$0")/../.." && . validation/cluster/common.sh
for tool in slurmctld slurmd sbatch munged; do
    command -v $tool > /dev/null || { echo "no $tool: apt-get install slurm-wlm munge" >&2; exit 2; }
done

STARTED=()
finish() {
    scancel --user=root --state=RUNNING,PENDING 2> /dev/null
    for pid in "${STARTED[@]}"; do kill "$pid" 2> /dev/null; done
    wait 2> /dev/null
    [ "$FAILED" = 0 ] && rm -rf "$WORK" || echo "kept: $WORK"
}
trap finish EXIT

node=$(hostname -s)
mkdir -p "$WORK"/{state,spool,log,out}
cat > "$WORK/slurm.conf" << CONF
ClusterName=loop
SlurmctldHost=$node(127.0.0.1)
SlurmUser=root
SlurmctldPort=16817
SlurmdPort=16818
AuthType=auth/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=sched_interval=1,batch_sched_delay=0
StateSaveLocation=$WORK/state
SlurmdSpoolDir=$WORK/spool
SlurmctldPidFile=$WORK/slurmctld.pid
SlurmdPidFile=$WORK/slurmd.pid
SlurmctldLogFile=$WORK/log/slurmctld
SlurmdLogFile=$WORK/log/slurmd
MaxArraySize=1001
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
CONF
export SLURM_CONF="$WORK/slurm.conf"

if ! munge -n > /dev/null 2>&1; then
    install -d -o munge -g munge -m 0755 /run/munge
    runuser -u munge -- munged --foreground > "$WORK/log/munged" 2>&1 &
    STARTED+=($!)
    for _ in $(seq 50); do munge -n > /dev/null 2>&1 && break; sleep 0.1; done
fi
slurmctld -D > "$WORK/log/slurmctld.out" 2>&1 & STARTED+=($!)
slurmd -D -N "$node" > "$WORK/log/slurmd.out" 2>&1 & STARTED+=($!)
for _ in $(seq 300); do sinfo -h -o %T 2> /dev/null | grep -q idle && break; sleep 0.1; done
sinfo -h -o '%D node, %T, %c CPUs' || { tail -3 "$WORK"/log/*; FAILED=1; exit 2; }
sbatch --version

# A job file, as in docs/cluster.md; the process id, so that it can be killed.
cat > "$WORK/job.sh" << 'JOB'
#!/bin/bash
#SBATCH --cpus-per-task=1
echo $$ > "$PIDS/$SLURM_ARRAY_TASK_ID"
export RAYON_NUM_THREADS=$SLURM_CPUS_PER_TASK
exec "$@" --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT"
JOB
export PIDS="$WORK/pids"; mkdir -p "$PIDS"

submit() { # how, tasks, folder, study...
    local how=$1 tasks=$2 folder=$3; shift 3
    sbatch $how --quiet --output="$WORK/log/%A_%a" --array="1-$tasks" "$WORK/job.sh" "$@" -o "$folder"
}

# exit code 1 says that a study found something to look at
ran_well() { [ "$1" -le 1 ] || { echo "exit code $1"; FAILED=1; }; }

for study in $STUDIES; do
    command_of "$study"; begin=$(seconds)
    "${COMMAND[@]}" -o "$WORK/out/$study" > /dev/null; ran_well $?
    echo "$study, one process, all cores: $(since "$begin") s, $(cases "$WORK/out/$study") cases"
    for tasks in 1 2 16; do
        folder="$WORK/out/$study-$tasks"; begin=$(seconds)
        submit --wait "$tasks" "$folder" "${COMMAND[@]}"
        took=$(since "$begin")
        "$TRUEGAP" merge "$folder" -q > /dev/null; ran_well $?
        told=$(same "$WORK/out/$study" "$folder") || FAILED=1
        echo "$study, SLURM array of $tasks, 1 core a task: $took s; $told"
    done
done

study=${STUDIES%% *}; command_of "$study"
folder="$WORK/out/killed"; rm -f "$PIDS"/*
submit "" 2 "$folder" "${COMMAND[@]}"
for _ in $(seq 1200); do [ "$(cases "$folder")" -ge 5 ] && [ -s "$PIDS/1" ] && break; sleep 0.1; done
kill -9 "$(cat "$PIDS/1")"
sleep 1; echo "$study: killed task 1 by kill -9 with $(cases "$folder") cases done; $(squeue -h | wc -l) tasks left"
while squeue -h | grep -q .; do sleep 0.5; done
before=$(cases "$folder")
"$TRUEGAP" merge "$folder" -q > /dev/null 2> "$WORK/missing"; echo "merge says ($?): $(head -c 120 "$WORK/missing")..."
submit --wait 2 "$folder" "${COMMAND[@]}"
echo "submitted again: $before cases were there, $(cases "$folder") now, $(halves "$folder") half-written files left aside"
"$TRUEGAP" merge "$folder" -q > /dev/null; ran_well $?
same "$WORK/out/$study" "$folder" || FAILED=1
exit "$FAILED"
