#!/usr/bin/env bats
# The command-line contract (tests/tools/contract.bats) for the programs of the WebAssembly module.
load ../helpers/common

package=$BATS_TEST_DIRNAME/../../build-wasm/package

setup() {
  [ -e "$package/transformesh.wasm" ] || skip "scripts/wasm has not built the module"
  needs_command node
  cd "$BATS_TEST_TMPDIR"
}

# A build folder in which the programs of the module replace the native ones. In the contract
# tm-evolve runs another program, which WebAssembly cannot.
make_build() {
  local program name
  mkdir -p build/bin
  for program in "$tm_build"/*; do
    [ "${program##*/}" = bin ] || ln -s "$program" build
  done
  for program in "$tm_build"/bin/*; do
    name=${program##*/}
    if [ -e "$package/bin/$name.mjs" ] && [ "$name" != tm-evolve ]; then
      printf '#!/bin/sh\nexec node "%s" "$@"\n' "$package/bin/$name.mjs" >"build/bin/$name"
      chmod +x "build/bin/$name"
    else
      ln -s "$program" build/bin
    fi
  done
}

# Check 1 compares the help of tm-repair, which has no --picture here. Check 9 also closes the standard
# output, for which Node.js opens another one. Check 12 waits for a signal handler, but signals end Node.js
# without one.
@test "the checks of the contract pass, except 1, 9 and 12" {
  make_build
  TM_BUILD=$PWD/build bats --filter '^([2-8]|10|11):' "$tm_root/tests/tools/contract.bats"
}

@test "a full disk is told, and a signal leaves no file" {
  tm-shape sphere --faces 200 -o ball.ply
  for program in tm-clean tm-remesh tm-convert; do
    code=0
    node "$package/bin/$program.mjs" ball.ply >/dev/full 2>stderr || code=$?
    [ "$code" -eq 5 ]
    one_line "$(cat stderr)"
  done
  mkdir folder
  mkfifo fifo
  node "$package/bin/tm-clean.mjs" -o folder/out.ply <fifo 3>&- &
  pid=$!
  exec 9>fifo
  head -c 1000 ball.ply >&9
  sleep 1
  kill -s TERM "$pid"
  code=0
  wait "$pid" || code=$?
  [ "$code" -eq 143 ]
  [ -z "$(ls -A folder)" ]
}
