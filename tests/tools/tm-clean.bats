#!/usr/bin/env bats
load ../helpers/common

@test "two balls become one, and the oracle agrees" {
  tm-shape two-spheres --faces 3000 -o "$BATS_TEST_TMPDIR/in.ply"
  run tm-clean "$BATS_TEST_TMPDIR/in.ply" -o "$BATS_TEST_TMPDIR/out.ply" \
    --report "$BATS_TEST_TMPDIR/report.json"
  assert_status 0
  run winding_oracle "$BATS_TEST_TMPDIR/in.ply" "$BATS_TEST_TMPDIR/out.ply"
  assert_status 0
  run tm-intersect --check "$BATS_TEST_TMPDIR/out.ply"
  assert_status 0
  run tm-info --get components "$BATS_TEST_TMPDIR/out.ply"
  [ "$output" = 1 ]
  grep -q '"changed": true' "$BATS_TEST_TMPDIR/report.json"
  grep -q '"genus": 0' "$BATS_TEST_TMPDIR/report.json"
}

@test "both methods write the same bytes" {
  tm-shape tangle --faces 3000 -o "$BATS_TEST_TMPDIR/in.ply"
  tm-clean --no-provenance "$BATS_TEST_TMPDIR/in.ply" -o "$BATS_TEST_TMPDIR/grow.ply"
  tm-clean --no-provenance --method static "$BATS_TEST_TMPDIR/in.ply" -o "$BATS_TEST_TMPDIR/static.ply"
  cmp "$BATS_TEST_TMPDIR/grow.ply" "$BATS_TEST_TMPDIR/static.ply"
}

@test "a mesh with nothing to clean comes out byte for byte" {
  tm-shape torus --faces 2000 --no-provenance -o "$BATS_TEST_TMPDIR/in.ply"
  tm-clean --no-provenance "$BATS_TEST_TMPDIR/in.ply" -o "$BATS_TEST_TMPDIR/out.ply"
  cmp "$BATS_TEST_TMPDIR/in.ply" "$BATS_TEST_TMPDIR/out.ply"
}

@test "a clean mesh stays as it is, byte for byte, whatever the shape and the format" {
  cd "$BATS_TEST_TMPDIR"
  local kinds=(sphere ellipsoid box torus "genus 3" torus-knot two-spheres "two-spheres --gap=0.1"
    tori "tori --gap=-0.1" dumbbell "dumbbell --neck=-0.1" bowl "folded sphere" "folded torus"
    tangle "tangle 3 5" many-spheres boxes pinch)
  local kind format
  for kind in "${kinds[@]}"; do
    for format in "--format ply --float" "--format ply --double" "--format off" \
      "--format ply-ascii --float"; do
      # shellcheck disable=SC2086 # several words each
      tm-shape $kind --faces 2000 $format -o in.mesh
      tm-clean --no-provenance in.mesh -o once.mesh
      tm-clean --no-provenance once.mesh -o twice.mesh
      cmp once.mesh twice.mesh || fail "$kind, $format"
    done
  done
}

@test "union, intersection and difference add up" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --faces 2000 -o a.ply
  tm-shape sphere --faces 2000 --center 0.5,0.31,0.2 -o b.ply
  tm-cat a.ply b.ply | tm-clean > union.ply
  tm-cat a.ply b.ply | tm-clean --level 2 > intersection.ply
  tm-stitch --flip b.ply | tm-cat a.ply - | tm-clean > difference.ply
  volume() { tm-info --get volume "$1"; }
  awk -v a="$(volume a.ply)" -v b="$(volume b.ply)" -v u="$(volume union.ply)" \
    -v i="$(volume intersection.ply)" -v d="$(volume difference.ply)" 'BEGIN {
      e = u + i - a - b; f = d + i - a
      exit !(e < 1e-9 && e > -1e-9 && f < 1e-9 && f > -1e-9 && i > 0.1) }'
}

@test "--refuse and an inside-out mesh exit 4 and write nothing" {
  tm-shape two-spheres --faces 1000 -o "$BATS_TEST_TMPDIR/in.ply"
  run --separate-stderr tm-clean --refuse "$BATS_TEST_TMPDIR/in.ply" -o "$BATS_TEST_TMPDIR/out.ply"
  assert_status 4
  [[ $stderr == *"intersecting face pairs"* ]]
  [ ! -e "$BATS_TEST_TMPDIR/out.ply" ]
  pipe_apart 'tm-shape sphere --faces 500 | tm-stitch --flip | tm-clean'
  assert_status 4
  [[ $stderr == *"tm-stitch --flip"* ]]
}

@test "--source-face names the faces of the input" {
  tm-shape two-spheres --faces 1000 -o "$BATS_TEST_TMPDIR/in.ply"
  tm-clean --source-face --format ply-ascii "$BATS_TEST_TMPDIR/in.ply" -o "$BATS_TEST_TMPDIR/out.ply"
  grep -q '^property int source_face$' "$BATS_TEST_TMPDIR/out.ply"
}

@test "--outermost drops a cavity" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --faces 500 --radius 0.5 | tm-stitch --flip > cavity.ply
  tm-shape sphere --faces 500 --radius 1 | tm-cat - cavity.ply > hollow.ply
  [ "$(tm-clean hollow.ply | tm-info --get components)" = 2 ]
  [ "$(tm-clean --outermost hollow.ply | tm-info --get components)" = 1 ]
}

@test "--separate leaves no two vertices in one place" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 1 1 1 --faces 12 -o a.ply
  tm-shape box 1 1 1 --faces 12 --center 1,1,0 | tm-cat a.ply - > boxes.ply
  tm-shape pinch --faces 3000 --float > pinch.ply
  for kind in boxes pinch; do
    tm-clean $kind.ply -o touching.ply --report touching.json
    tm-clean --separate 1% $kind.ply -o apart.ply --report apart.json
    grep -q '"separated_vertices": 0' touching.json
    run ! grep -q '"separated_vertices": 0' apart.json
    grep -q '"separation_refused": 0' apart.json
    tm-stitch touching.ply -o /dev/null --report touching.json
    tm-stitch apart.ply -o /dev/null --report apart.json
    run ! grep -q '"joined_vertices": 0' touching.json
    grep -q '"joined_vertices": 0' apart.json
    run tm-checkmanifold --closed --intersections apart.ply
    assert_status 0
    [ "$(tm-info --get vertices touching.ply)" = "$(tm-info --get vertices apart.ply)" ]
  done
  run tm-clean --refuse --separate 1% touching.ply -o refused.ply
  assert_status 4
  [ ! -e refused.ply ]
}

# shared_mesh NAME: cleans it and asks the oracle.
shared_mesh() {
  needs_shared "$1"
  tm-clean "$shared_file" -o "$BATS_TEST_TMPDIR/out.ply"
  tm-intersect --check "$BATS_TEST_TMPDIR/out.ply"
  tm-checkmanifold --closed "$BATS_TEST_TMPDIR/out.ply"
  winding_oracle "$shared_file" "$BATS_TEST_TMPDIR/out.ply"
}

@test "real mesh: spheres_intersecting" { shared_mesh meshes/cgal/spheres_intersecting.off; }
@test "real mesh: bones" { shared_mesh meshes/cgal/bones.off; }
@test "real mesh: man" { shared_mesh meshes/cgal/man.off; }
@test "real mesh: camel" { shared_mesh meshes/cgal/camel.off; }
@test "real mesh: self_intersectA" { shared_mesh meshes/manifold/self_intersectA.obj; }
