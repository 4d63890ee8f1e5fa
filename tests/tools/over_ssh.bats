#!/usr/bin/env bats
# Batches by GNU parallel over ssh, to this machine.
load ../helpers/common
load ../helpers/batch
load ../helpers/sshd

setup() {
  needs_command jq
  needs_command parallel
  cd "$BATS_TEST_TMPDIR"
  start_sshd "$BATS_TEST_TMPDIR/sshd"
}

teardown() { [ -z "${sshd_id-}" ] || stop_sshd; }

@test "a batch over ssh has the rows and the meshes that make has; what was interrupted goes on" {
  cat >table <<'TABLE'
shape genus-1..3 tm-shape genus % --faces 1000 -o target.ply; tm-shape sphere --around target.ply --faces 1000 -o source.ply
shape none tm-shape genus 99 -o target.ply
run one tm-morph source.ply --target target.ply -o result.ply --resume --threads 1 --iterations 15
run killed [ -e ../killed ] || { touch ../killed; kill -KILL $$; }; tm-clean source.ply -o result.ply
TABLE
  batch ssh BATCH="$PWD/by-ssh" HOSTS=2/node OPTIONS="--ssh '$ssh_command'" >out 2>&1 3>&- || fail "$(cat out)"
  grep -q '6 done, 2 failed, 0 not ended' out || fail "$(cat out)"
  [ -e by-ssh/killed ]
  mkdir by-make && touch by-make/killed
  batch -j2 batch BATCH="$PWD/by-make"
  diff <(columns by-ssh) <(columns by-make)
  local mesh
  for mesh in by-make/*/result.ply; do
    cmp "$mesh" "by-ssh/${mesh#by-make/}"
  done
  [ "$(ls -d by-ssh/*/result.ply | wc -l)" -eq 6 ]
  # This host does not exist.
  run batch ssh BATCH="$PWD/nowhere" HOSTS=1/nowhere.invalid OPTIONS="--ssh '$ssh_command'"
  [ "$status" -ne 0 ]
  [[ $output == *"8 runs have not ended"* ]]
}
