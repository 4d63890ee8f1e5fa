#!/usr/bin/env bats
load ../helpers/common

@test "an STL soup becomes the mesh it was" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus --faces 1000 --float -o torus.ply
  tm-convert torus.ply -q -o torus.stl
  tm-stitch -q torus.stl -o back.ply
  [ "$(tm-info --get vertices back.ply)" = "$(tm-info --get vertices torus.ply)" ]
  [ "$(tm-info --get genus back.ply)" = 1 ]
  run tm-checkmanifold --closed back.ply
  assert_status 0
}

@test "two tetrahedra that share a vertex come apart" {
  tetrahedron > "$BATS_TEST_TMPDIR/a.ply"
  awk 'body { if (NF == 3) { print -$1, -$2, -$3; next } if (NF == 4) { print 3, $2, $4, $3; next } }
    /end_header/ { body = 1 } { print }' "$BATS_TEST_TMPDIR/a.ply" > "$BATS_TEST_TMPDIR/b.ply"
  tm-cat "$BATS_TEST_TMPDIR/a.ply" "$BATS_TEST_TMPDIR/b.ply" |
    tm-stitch --report "$BATS_TEST_TMPDIR/report.json" -o "$BATS_TEST_TMPDIR/out.ply"
  [ "$(tm-info --get vertices "$BATS_TEST_TMPDIR/out.ply")" = 8 ]
  grep -q '"copied_vertices": 1' "$BATS_TEST_TMPDIR/report.json"
  run tm-checkmanifold --closed "$BATS_TEST_TMPDIR/out.ply"
  assert_status 0
}

@test "--flip negates the volume" {
  pipe 'tm-shape box | tm-stitch --flip | tm-info --get volume'
  assert_status 0
  [[ $output == -* ]]
}

@test "--orient mends shuffled faces and says when it cannot" {
  for mesh in blobby oblong tet; do
    needs_shared "meshes/cgal/$mesh-shuffled.off"
    tm-stitch -q --orient "$shared_file" -o "$BATS_TEST_TMPDIR/out.ply"
    run tm-checkmanifold --closed "$BATS_TEST_TMPDIR/out.ply"
    assert_status 0
    [[ $(tm-info --get volume "$BATS_TEST_TMPDIR/out.ply") != -* ]]
  done
  needs_shared meshes/geometry-central/moebius.obj
  run tm-stitch -q --orient "$shared_file" -o "$BATS_TEST_TMPDIR/out.ply"
  assert_status 3
  [[ $output == *Moebius* ]]
}
