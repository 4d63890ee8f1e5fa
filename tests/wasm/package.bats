#!/usr/bin/env bats
# The npm package of scripts/wasm: installed from its tarball without a network, as programs and as a
# module.
load ../helpers/common

built=$BATS_TEST_DIRNAME/../../build-wasm

setup() {
  [ -e "$built/package/transformesh.wasm" ] || skip "scripts/wasm has not built the module"
  command -v npx >/dev/null || skip "there is no npm"
  cd "$BATS_TEST_TMPDIR"
  export npm_config_cache=$BATS_TEST_TMPDIR/cache
}

@test "npx runs a program of the tarball between pipes" {
  tm-shape folded torus --faces 3000 -o folded.stl
  mkdir project
  cd project
  npx --offline --yes -p "$built"/transformesh-*.tgz tm-clean -q <../folded.stl >out.ply
  tm-clean -q <../folded.stl | cmp - out.ply
}

@test "the module computes what the programs compute" {
  npm install --offline --no-audit --no-fund --silent "$built"/transformesh-*.tgz
  tm-shape folded torus --faces 3000 -o folded.stl
  tm-shape sphere --faces 3000 -o ball.ply
  cp "$BATS_TEST_DIRNAME/module.mjs" .
  node module.mjs folded.stl ball.ply
  tm-clean -q folded.stl | cmp - clean.ply
  tm-clean -q folded.stl | tm-boolean -q union - ball.ply -o union.ply
  [ "$(tm-info --get faces union.ply)" = "$(cat union.faces)" ]
}

@test "TypeScript accepts all functions, and refuses mistakes" {
  needs_command tsc
  npm install --offline --no-audit --no-fund --silent "$built"/transformesh-*.tgz
  cp "$BATS_TEST_DIRNAME/types.mts" .
  tsc --noEmit --strict --target es2022 --module nodenext --lib es2022,dom types.mts
}

@test "the compressed package is smaller than 3 MB" {
  [ "$(stat -c %s "$built"/transformesh-*.tgz)" -lt 3000000 ]
}
