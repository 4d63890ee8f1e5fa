#!/usr/bin/env bats
# Batches on a real Slurm of one node.
load ../helpers/common
load ../helpers/batch
load ../helpers/slurm

setup() {
  needs_command jq
  cd "$BATS_TEST_TMPDIR"
  start_slurm "$BATS_TEST_TMPDIR/slurm"
}

teardown() { [ -z "${slurm_ids[*]-}" ] || stop_slurm; }

# loop_in FOLDER: prints the process id of the tm-morph that works in a folder.
loop_in() {
  local process
  for process in $(pgrep -x tm-morph); do
    [ "$(readlink "/proc/$process/cwd" 2>/dev/null)" = "$1" ] && echo "$process" && return
  done
  return 1
}

@test "40 runs as an array job, one killed, the node drained and resumed: as make has them" {
  cat >table <<'TABLE'
shape slow tm-shape genus 2 --faces 40000 -o target.ply; tm-shape sphere --around target.ply --faces 40000 -o source.ply
shape ellipsoid-1..12 tm-shape ellipsoid 1 1 1.% --faces 1000 -o target.ply; tm-shape sphere --around target.ply --faces 1000 -o source.ply
shape genus-1..6 tm-shape genus % --faces 2000 -o target.ply; tm-shape sphere --around target.ply --faces 1000 -o source.ply
shape none tm-shape genus 99 -o target.ply
run one tm-morph source.ply --target target.ply -o result.ply --resume --threads 1 --alpha 0.2 --iterations 150
run two tm-morph source.ply --target target.ply -o result.ply --resume --threads 1 --alpha 0.5 --iterations 20
TABLE
  batch slurm BATCH="$PWD/by-slurm" >slurm.out 2>&1 3>&- &
  local batch=$! tries=0 process=
  # Kills the slow run, which takes many seconds, when it has a state.
  until [ -e by-slurm/slow,one.unfinished/result.ply.tm-morph ] &&
    process=$(loop_in "$PWD/by-slurm/slow,one.unfinished"); do
    sleep 0.05
    tries=$((tries + 1))
    [ "$tries" -lt 1200 ] || fail "the slow run does not begin: $(cat slurm.out by-slurm/slurm.log)"
  done
  kill -KILL "$process"
  scontrol update "NodeName=$(hostname -s)" State=DRAIN Reason=test
  sleep 2
  sinfo -h -o %T | grep -q '^drain'
  scontrol update "NodeName=$(hostname -s)" State=RESUME
  wait "$batch" || fail "$(cat slurm.out by-slurm/slurm.log)"
  grep -q 'slow,one was interrupted (exit code 137)' by-slurm/slurm.log
  grep -q '38 done, 2 failed, 0 not ended' by-slurm/slurm.log || fail "$(cat by-slurm/slurm.log)"

  batch -j2 batch BATCH="$PWD/by-make"
  diff <(columns by-slurm) <(columns by-make)
  local mesh
  for mesh in by-make/*/result.ply; do
    cmp "$mesh" "by-slurm/${mesh#by-make/}"
  done
  [ "$(ls -d by-slurm/*/result.ply | wc -l)" -eq 38 ]
}
