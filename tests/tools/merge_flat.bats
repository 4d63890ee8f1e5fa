#!/usr/bin/env bats
# tm-clean --merge-flat: chains of cuts through files.
load ../helpers/common

faces_of() { tm-info --get faces "$1"; }

# cut WORK TOOL OPTION...: subtracts the tool from the work.
cut_with() {
  local work=$1 tool=$2
  shift 2
  tm-stitch --flip "$tool" | tm-cat "$work" - | tm-clean --no-provenance "$@" -o next.ply
  mv next.ply "$work"
}

assert_sound() {
  run tm-checkmanifold "$1"
  assert_status 0
  [[ $output == *"closed: true"* ]]
  run tm-intersect --check "$1"
  assert_status 0
}

setup() { cd "$BATS_TEST_TMPDIR"; }

@test "twenty slots with a common bottom: the faces of the shape, its volume, and nothing else" {
  tm-shape box 4 4 1 --faces 12 --double -o merged.ply
  cp merged.ply plain.ply
  tm-shape box .3 5 .5 --faces 12 --double -o tool.ply
  local i
  for i in {0..19}; do
    tm-transform --rotate "0,0,1,$((9 * i))" --translate 0,0,.5 tool.ply -o turned.ply
    cut_with merged.ply turned.ply --merge-flat
    cut_with plain.ply turned.ply
  done
  assert_sound merged.ply
  local merged plain
  merged=$(faces_of merged.ply)
  plain=$(faces_of plain.ply)
  [ $((5 * merged)) -lt "$plain" ] || fail "$merged of $plain faces"
  run tm-compare --within 1e-12 --reference plain.ply merged.ply
  assert_status 0
}

@test "a union of cubes in a row is one box of twelve faces" {
  tm-shape box 1 1 1 --faces 12 --double -o work.ply
  local i
  for i in 1 2 3 4 5; do
    tm-shape box 1 1 1 --faces 12 --double --center "$i,0,0" | tm-cat work.ply - |
      tm-clean --merge-flat -o next.ply
    mv next.ply work.ply
  done
  [ "$(faces_of work.ply)" = 12 ]
  run tm-info --get volume work.ply
  [ "$output" = 6 ]
}

@test "uncut meshes pass unchanged" {
  tm-shape sphere --faces 500 -o ball.ply
  tm-clean --no-provenance --merge-flat ball.ply -o same.ply
  tm-clean --no-provenance ball.ply -o cleaned.ply
  cmp cleaned.ply same.ply
  tm-shape box 1 1 1 --faces 300 -o box.ply
  tm-clean --no-provenance box.ply -o cleaned.ply
  tm-clean --no-provenance --merge-flat box.ply -o same.ply
  cmp cleaned.ply same.ply
}

@test "tm:planarity adds up what the report says, and tm-transform scales it" {
  tm-shape box 4 4 1 --faces 12 --double --no-provenance -o work.ply
  tm-shape box .3 5 .5 --faces 12 --double -o tool.ply
  local i sum=0 moved
  for i in 1 2 3; do
    tm-transform --rotate "1,2,3,$((17 * i))" tool.ply -o turned.ply
    cut_with work.ply turned.ply --merge-flat --report report.json
    moved=$(python3 -c 'import json; print(json.load(open("report.json"))["result"]["merge_displacement"])')
    sum=$(python3 -c "print($sum + $moved)")
  done
  run grep -a -o 'tm:planarity .*' work.ply
  python3 -c "import sys; a, b = $sum, float('${output#* }'); sys.exit(abs(a - b) > 1e-3 * a or a <= 0)"
  local before=${output#* }
  tm-transform --scale 4 work.ply -o scaled.ply
  run grep -a -o 'tm:planarity .*' scaled.ply
  python3 -c "import sys; sys.exit(float('${output#* }') != 4 * $before)"
}

@test "any number of threads gives the same bytes" {
  tm-shape boxes --count 20 --double -o in.ply
  tm-clean --merge-flat --no-provenance --threads 1 in.ply -o one.ply
  tm-clean --merge-flat --no-provenance --threads 4 in.ply -o four.ply
  cmp one.ply four.ply
  assert_sound one.ply
}

@test "--merge-flat needs the whole mesh" {
  tm-shape two-spheres --faces 2000 -o in.ply
  run tm-clean --merge-flat --box 0,0,0,1,1,1 in.ply
  assert_status 2
  [[ $output == *"merging flat faces needs the whole mesh"* ]]
}
