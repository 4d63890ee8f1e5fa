# Runs Slurm on one node for a test: munged, slurmctld and slurmd as root, with all their files in
# one folder. stop_slurm stops exactly these processes.

# start_slurm FOLDER: starts Slurm with its files in the folder. Skips the test, with the reason, if
# Slurm cannot be started.
start_slurm() {
  local command
  for command in sbatch slurmctld slurmd munged; do
    command -v "$command" >/dev/null || PATH=$PATH:/usr/sbin
    needs_command "$command"
  done
  [ "$(id -u)" -eq 0 ] || skip "Slurm's programs need root"
  slurm=$1
  slurm_ids=()
  mkdir -p "$slurm"/{state,spool,munge}
  chmod 0755 "$slurm" "$slurm/munge"
  head -c 1024 /dev/urandom >"$slurm/munge.key"
  chmod 0600 "$slurm/munge.key"
  local name port
  name=$(hostname -s)
  port=$((20000 + $$ % 20000))
  cat >"$slurm/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$name(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$slurm/munge/socket,cred_expire=5
CredType=cred/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU_Memory
SchedulerParameters=sched_interval=1,sched_min_interval=0,bf_interval=1
DefMemPerCPU=200
ReturnToService=2
MailProg=/bin/true
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/spool
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.pid
SlurmctldLogFile=$slurm/slurmctld.log
SlurmdLogFile=$slurm/slurmd.log
NodeName=$name NodeAddr=127.0.0.1 CPUs=2 RealMemory=900 State=UNKNOWN
PartitionName=main Nodes=ALL Default=YES MaxTime=INFINITE State=UP
CONF
  export SLURM_CONF=$slurm/slurm.conf
  munged --foreground --force --key-file="$slurm/munge.key" --socket="$slurm/munge/socket" \
    --pid-file="$slurm/munge/pid" --seed-file="$slurm/munge/seed" --log-file="$slurm/munge/log" \
    --num-threads=2 >"$slurm/munged.out" 2>&1 3>&- &
  slurm_ids+=($!)
  slurm_waits "$slurm/munge/socket" "[ -S '$slurm/munge/socket' ]"
  slurmctld -D -f "$SLURM_CONF" >"$slurm/slurmctld.out" 2>&1 3>&- &
  slurm_ids+=($!)
  slurmd -D -f "$SLURM_CONF" -N "$name" >"$slurm/slurmd.out" 2>&1 3>&- &
  slurm_ids+=($!)
  slurm_waits "an idle node" "sinfo -h -o %T 2>/dev/null | grep -qx idle"
}

# slurm_waits WHAT CONDITION: waits up to 30 seconds until a condition is true. Skips the test if it
# stays false. WHAT describes the condition in the message.
slurm_waits() {
  local tries
  for tries in $(seq 300); do
    if eval "$2"; then return; fi
    sleep 0.1
  done
  tail -n 3 "$slurm"/*.out "$slurm"/*.log "$slurm/munge/log" 2>/dev/null || true
  stop_slurm
  skip "Slurm does not start here: no $1 after $((tries / 10)) s"
}

stop_slurm() {
  local i
  for ((i = ${#slurm_ids[@]} - 1; i >= 0; --i)); do
    kill "${slurm_ids[$i]}" 2>/dev/null || true
    wait "${slurm_ids[$i]}" 2>/dev/null || true
  done
  slurm_ids=()
}
