#!/bin/bash
# A Slurm cluster of two nodes, lr0 and lr1, on this machine, for tests: munged, slurmctld and two slurmd, all
# of one user, in one folder, on ports of their own. No service of the system is used or changed.
#
#   slurm_cluster.sh start FOLDER              makes FOLDER; returns when both nodes are idle
#   slurm_cluster.sh env FOLDER                prints what a shell must export: eval "$(slurm_cluster.sh env FOLDER)"
#   slurm_cluster.sh kill-node FOLDER N        node N is lost: its daemon, its job steps and all they started
#   slurm_cluster.sh kill-daemon FOLDER N      its daemon alone; what it had started runs on, as Slurm leaves it
#   slurm_cluster.sh revive-node FOLDER N      started again, with nothing running; returns when it takes jobs
#   slurm_cluster.sh stop FOLDER               ends all of it, jobs too, and removes what start made
#   slurm_cluster.sh selftest                  an array of 8 tasks; a node is lost while it works
#
# A node has one CPU. A lost node is noticed after 10 to 15 s, and what it ran waits another 5 s; a real cluster
# takes its SlurmdTimeout (300 s) and cred_expire (120 s). With LENTRAY_KEEP set, stop leaves the logs.
# Runs as root or as any user. Needs Debian's slurmctld, slurmd, slurm-client (together: slurm-wlm) and munge.
# Exit status: 0; 77 and a sentence where these packages are missing; 1 and a reason for anything else.
set -eu
PATH=$PATH:/usr/sbin:/sbin

fail() { echo "slurm_cluster.sh: $*" >&2; exit 1; }
usage() { sed -n '2,/^set -eu/{s/^# \{0,1\}//p}' "$0"; }

need_packages() {
  local program
  for program in munged slurmctld slurmd sbatch sinfo scontrol; do
    command -v "$program" >/dev/null && continue
    echo "slurm_cluster.sh: no $program: install Debian's packages slurm-wlm and munge to test the cluster"
    exit 77
  done
}

# Waits until a command succeeds: until SECONDS COMMAND...
until_true() {
  local end=$(( SECONDS + $1 )); shift
  until "$@" >/dev/null 2>&1; do
    [ "$SECONDS" -lt "$end" ] || return 1
    sleep 0.2
  done
}

# Six ports in a row that nobody listens on, below those that the system hands out.
free_ports() {
  local base port taken
  taken=" $(awk '$4 == "0A" { split($2, a, ":"); print a[2] }' /proc/net/tcp /proc/net/tcp6 2>/dev/null | tr '\n' ' ') "
  while :; do
    base=$(( 20000 + RANDOM % 10000 ))
    for port in $(seq "$base" $(( base + 5 ))); do
      case $taken in *" $(printf %04X "$port") "*) continue 2 ;; esac
    done
    echo "$base"
    return
  done
}

write_configuration() {
  local host user ports
  host=$(hostname -s) user=$(id -un) ports=$(free_ports)
  cat > "$folder/slurm.conf" <<CONF
ClusterName=lentray
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
SlurmctldPort=$ports
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$folder/munge.socket,cred_expire=5
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool.%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.%n.log
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
SlurmdParameters=config_overrides
ReturnToService=2
JobRequeue=1
MaxArraySize=10001
MaxJobCount=20000
SlurmctldTimeout=60
SlurmdTimeout=10
MessageTimeout=5
BatchStartTimeout=10
KillWait=2
MinJobAge=30
NodeName=lr0 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(( ports + 1 )) CPUs=1 RealMemory=1000
NodeName=lr1 NodeHostname=$host NodeAddr=127.0.0.1 Port=$(( ports + 2 )) CPUs=1 RealMemory=1000
PartitionName=lentray Nodes=lr[0-1] Default=YES MaxTime=INFINITE State=UP OverSubscribe=NO
CONF
}

pid_of() { cat "$folder/$1.pid" 2>/dev/null || true; }

# A process of that number is still the program that we started: is_ours PID PROGRAM
is_ours() { [ -n "$1" ] && [[ "$(readlink "/proc/$1/exe" 2>/dev/null)" == */"$2"* ]]; }

ends() { ! kill -0 "$1" 2>/dev/null || [ "$(awk '{ print $3 }' "/proc/$1/stat" 2>/dev/null)" = Z ]; }

# end_daemon PID PROGRAM: asks, then insists.
end_daemon() {
  is_ours "$1" "$2" || return 0
  kill "$1" 2>/dev/null || return 0
  until_true 5 ends "$1" || kill -9 "$1" 2>/dev/null || true
}

# Step daemons of a node, by the sockets that they have in its spool folder.
steps_of() {
  local inodes process descriptor socket
  inodes=" $(awk -v at="$folder/spool.$1/" 'index($8, at) == 1 { print $7 }' /proc/net/unix | tr '\n' ' ') "
  for process in /proc/[0-9]*; do
    [[ "$(readlink "$process/exe" 2>/dev/null)" == */slurmstepd* ]] || continue
    for descriptor in "$process"/fd/*; do
      socket=$(readlink "$descriptor" 2>/dev/null) || continue
      socket=${socket#socket:[} socket=${socket%]}
      case $inodes in *" $socket "*) echo "${process#/proc/}"; break ;; esac
    done
  done
}

# Processes of jobs on a node, by what Slurm put into their environment.
jobs_of() {
  local process
  for process in /proc/[0-9]*; do
    grep -qszx "SLURMD_NODENAME=$1" "$process/environ" 2>/dev/null || continue
    grep -qszx "SLURM_CONF=$folder/slurm.conf" "$process/environ" 2>/dev/null && echo "${process#/proc/}"
  done
  return 0
}

# Again, for what was started meanwhile.
kill_work_of() {
  local round found
  for round in 1 2 3 4 5; do
    found="$(steps_of "$1") $(jobs_of "$1")"
    [ -n "${found// /}" ] || return 0
    # shellcheck disable=SC2086
    kill -9 $found 2>/dev/null || true
    sleep 0.1
  done
}

start_node() {
  mkdir -p "$folder/spool.$1"
  rm -f "$folder/slurmd.$1.pid"
  slurmd -N "$1" -f "$folder/slurm.conf" || fail "slurmd $1 does not start; see $folder/slurmd.$1.log"
}

node_is_up() { sinfo -h -n "$1" -o %t | grep -qxE 'idle|mix|alloc|comp'; }

start() {
  need_packages
  if [ -e "$folder/slurm.conf" ]; then fail "there is a cluster in $folder already"; fi
  mkdir -p "$folder/state"
  chmod 755 "$folder"
  folder=$(cd "$folder" && pwd -P)
  [ ${#folder} -le 80 ] || fail "the path $folder is too long for sockets"
  export SLURM_CONF=$folder/slurm.conf
  write_configuration
  (umask 077 && head -c 1024 /dev/urandom > "$folder/munge.key")
  munged --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" --pid-file="$folder/munged.pid" \
    --log-file="$folder/munged.log" --seed-file="$folder/munge.seed" --num-threads=2 2>"$folder/munged.err" \
    || fail "munged does not start: $(cat "$folder/munged.err")"
  slurmctld -c -f "$folder/slurm.conf" 2>"$folder/slurmctld.err" \
    || fail "slurmctld does not start: $(cat "$folder/slurmctld.err")"
  until_true 20 scontrol ping || fail "slurmctld does not answer; see $folder/slurmctld.log"
  local node
  for node in lr0 lr1; do start_node $node; done
  for node in lr0 lr1; do
    until_true 30 node_is_up $node || fail "$node does not come up: $(tail -3 "$folder/slurmd.$node.log")"
  done
}

kill_daemon() {
  local pid
  pid=$(pid_of "slurmd.$1")
  is_ours "$pid" slurmd || fail "$1 does not run"
  kill -9 "$pid"
  until_true 5 ends "$pid" || true
}

revive_node() {
  if is_ours "$(pid_of "slurmd.$1")" slurmd; then fail "$1 runs already"; fi
  kill_work_of "$1"  # a machine that starts again has nothing running
  start_node "$1"
  until_true 30 node_is_up "$1" || scontrol update nodename="$1" state=resume 2>/dev/null || true
  until_true 10 node_is_up "$1" || fail "$1 does not come back: $(tail -3 "$folder/slurmd.$1.log")"
}

stop() {
  [ -e "$folder/slurm.conf" ] || return 0
  local node
  end_daemon "$(pid_of slurmctld)" slurmctld
  for node in lr0 lr1; do
    end_daemon "$(pid_of slurmd.$node)" slurmd
    kill_work_of $node
  done
  end_daemon "$(pid_of munged)" munged
  if [ -n "${LENTRAY_KEEP-}" ]; then
    rm -rf "$folder"/{state,spool.lr0,spool.lr1}
  else
    rm -rf "$folder"/{state,spool.lr0,spool.lr1} "$folder"/{munged,slurmctld,slurmd.lr0,slurmd.lr1}.{log,pid,err}
  fi
  rm -f "$folder"/{slurm.conf,munge.key,munge.seed} "$folder"/munge.socket* "$folder"/*.pid
  rmdir "$folder" 2>/dev/null || true
}

# Every task writes a file; those of the lost node run again on the other one.
selftest() {
  need_packages
  local job begun
  folder=$(mktemp -d "${TMPDIR:-/tmp}/lentray-slurm-XXXXXX")
  trap 'stop; rm -rf "$folder"' EXIT
  start
  mkdir "$folder/out"
  job=$(sbatch --parsable --array=0-7 --output=/dev/null --chdir="$folder/out" <<'JOB'
#!/bin/sh
echo "$SLURMD_NODENAME" >> "began.$SLURM_ARRAY_TASK_ID"
sleep 3
echo "$SLURMD_NODENAME" > "done.$SLURM_ARRAY_TASK_ID"
JOB
  )
  until_true 20 is_at_work lr0 || fail "lr0 has nothing to do"
  until_true 20 test -e "$folder/out/done.1" || fail "job $job does not get on"
  until_true 20 is_at_work lr1 || fail "lr1 has nothing to do"
  kill_daemon lr1
  kill_work_of lr1
  echo "lr1 is lost; of 8 tasks $(count done) are done, $(count began) begun"
  until_true 120 all_done || fail "not all tasks end: $(count done) of 8 are done"
  begun=$(cat "$folder"/out/began.* | wc -l)
  [ "$begun" -gt 8 ] || fail "no task ran again"
  revive_node lr1
  echo "8 of 8 tasks are done, $(( begun - 8 )) of them begun twice; lr1 is back"
}
count() { find "$folder/out" -name "$1.*" | wc -l; }
all_done() { [ "$(count done)" = 8 ]; }
# The node has begun a task that is not done.
is_at_work() {
  local file
  for file in "$folder"/out/began.*; do
    grep -qsx "$1" "$file" && [ ! -e "${file/began/done}" ] && return 0
  done
  return 1
}

command=${1-}
case $command in
  selftest) selftest; exit ;;
  start | stop | env | kill-node | kill-daemon | revive-node) ;;
  -h | --help | '') usage; exit ;;
  *) fail "there is no command '$command'; there are start, env, kill-node, kill-daemon, revive-node, stop, selftest" ;;
esac
[ -n "${2-}" ] || fail "$command: which folder?"
folder=$2
if [ -d "$folder" ]; then folder=$(cd "$folder" && pwd -P); fi
case $command in
  start) trap 'test $? = 0 || stop' EXIT; start; exit ;;
  stop) stop; exit ;;
esac
[ -e "$folder/slurm.conf" ] || fail "there is no cluster in $folder"
export SLURM_CONF=$folder/slurm.conf
case $command in
  env) echo "export SLURM_CONF='$folder/slurm.conf'"; exit ;;
esac
node=lr${3-}
case $node in lr0 | lr1) ;; *) fail "$command: which node, 0 or 1?" ;; esac
case $command in
  kill-node) kill_daemon "$node"; kill_work_of "$node" ;;
  kill-daemon) kill_daemon "$node" ;;
  revive-node) revive_node "$node" ;;
esac
