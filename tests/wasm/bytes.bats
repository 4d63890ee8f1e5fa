#!/usr/bin/env bats
# The programs of the WebAssembly module of scripts/wasm: same bytes, exit codes and messages as the native
# ones.
load ../helpers/common

package=$BATS_TEST_DIRNAME/../../build-wasm/package

setup() {
  [ -e "$package/transformesh.wasm" ] || skip "scripts/wasm has not built the module"
  command -v node >/dev/null || skip "there is no Node.js"
  cd "$BATS_TEST_TMPDIR"
}

wasm() {
  node "$package/bin/$1.mjs" "${@:2}"
}

# Runs both programs, with the standard input of the file named first ('' for none).
same() {
  local input=$1
  shift
  "$@" <"${input:-/dev/null}" >native.out 2>native.err && local native=0 || local native=$?
  wasm "$@" <"${input:-/dev/null}" >wasm.out 2>wasm.err && local other=0 || local other=$?
  [ "$native" = "$other" ]
  cmp native.out wasm.out
  diff native.err wasm.err
}

@test "shapes have the same bytes" {
  while read -r -a words; do
    tm-shape "${words[@]}" -o native.ply
    wasm tm-shape "${words[@]}" -o wasm.ply
    cmp native.ply wasm.ply
  done <<'END'
sphere --faces 3000
torus-knot 2 3 --faces 3000
genus 3 --faces 3000
folded sphere --faces 3000
tangle 2 3 --faces 3000
boxes --count 20
many-spheres --count 10
pinch
figure 1 --faces 3000
sphere --faces 2000 --noise 3% --seed 4
END
}

@test "cleaning gives the same bytes, from a pipe and to a file" {
  tm-shape folded torus --faces 8000 -o folded.ply
  tm-shape tangle --faces 4000 -o tangle.ply
  tm-shape boxes --count 30 -o boxes.ply
  for name in folded tangle boxes; do
    same $name.ply tm-clean -q
    [ -s native.out ]
  done
  tm-clean -q folded.ply -o native.ply
  wasm tm-clean -q folded.ply -o wasm.ply
  cmp native.ply wasm.ply
  # No temporary file is left beside the result.
  [ "$(find . -name '*.tmp' | wc -l)" = 0 ]
}

@test "cleaning of single precision and of text gives the same bytes" {
  tm-shape folded torus --faces 5000 | tm-convert --float -o float.ply
  tm-convert float.ply --format ply-ascii -o text.ply
  tm-convert float.ply -o float.off
  tm-convert float.ply -o float.stl
  same float.ply tm-clean -q
  same text.ply tm-clean -q
  same float.off tm-clean -q
  same float.stl tm-clean -q
}

@test "combining, offsets, repair, remeshing and morphing give the same bytes" {
  tm-shape sphere --faces 4000 -o ball.ply
  tm-shape torus --faces 4000 -o ring.ply
  tm-transform --rotate 1,2,3,20 --translate 0.3,0.1,0.2 ball.ply -o moved.ply
  same "" tm-boolean -q union ball.ply ring.ply
  same "" tm-boolean -q difference ball.ply moved.ply
  same ring.ply tm-remesh -q --edge 0.1
  same ring.ply tm-offset -q --distance 0.05
  same ball.ply tm-morph-step -q --target ring.ply
  tm-select -q --plane=0,0,-1,-0.7 ball.ply -o open.ply
  same open.ply tm-fill -q --no-fair
  tm-convert ring.ply -o soup.stl
  same soup.stl tm-repair -q
}

@test "smooth patches differ by rounding alone" {
  # CGAL's weights of edges use the tangent of the C library, which differs in the last digit.
  tm-shape sphere --faces 4000 | tm-select -q --plane=0,0,-1,-0.7 -o open.ply
  tm-fill -q open.ply -o native.ply
  wasm tm-fill -q open.ply -o wasm.ply
  [ "$(tm-info --get faces native.ply)" = "$(tm-info --get faces wasm.ply)" ]
  tm-compare --json --reference native.ply wasm.ply | jq -e '.hausdorff < 1e-12'
}

@test "reports of programs that measure have the same bytes" {
  tm-shape folded torus --faces 3000 -o folded.ply
  same folded.ply tm-info --json
  same folded.ply tm-intersect --check
  same folded.ply tm-checkmanifold --intersections
}

@test "errors have the same exit codes and words" {
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n' >bad.off
  : >empty.ply
  same bad.off tm-clean
  same empty.ply tm-clean
  same "" tm-clean missing.ply
  same "" tm-clean --colour
  same "" tm-remesh --edge tiny
  same "" tm-clean .
  same "" tm-boolean union
}

@test "help and unwritable targets are the same" {
  same "" tm-clean --help
  tm-shape sphere --faces 200 -o ball.ply
  same ball.ply tm-clean -o missing/folder.ply
  if [ -e /dev/full ]; then
    run -5 wasm tm-clean -q ball.ply -o /dev/full
  fi
}

@test "a reader that ends early silences a writer" {
  tm-shape sphere --faces 60000 -o ball.ply
  run bash -c "node '$package/bin/tm-convert.mjs' --format ply-ascii ball.ply | head -1"
  [ "$output" = ply ]
}

@test "limits that WebAssembly cannot keep are refused, and so are commands of others" {
  tm-shape sphere --faces 200 -o ball.ply
  run -2 --separate-stderr wasm tm-clean --max-time 5 ball.ply
  [ "$stderr" = "tm-clean: --max-time: this system cannot limit the time of a program" ]
  run -2 --separate-stderr wasm tm-clean --max-memory 1G ball.ply
  [ "$stderr" = "tm-clean: --max-memory: this system cannot limit the memory of a program" ]
  run -4 --separate-stderr wasm tm-evolve ball.ply --step 'tm-displace' --iterations 1 -o end.ply
  [[ $stderr = *"cannot run 'tm-displace'"* ]]
  [ ! -e end.ply ]
}
