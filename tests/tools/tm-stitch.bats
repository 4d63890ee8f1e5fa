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

# shuffle: reverses about every second face of an ASCII PLY on stdin, in a fixed random pattern.
shuffle() {
  awk 'BEGIN { srand(3) }
    body && NF == 4 && $1 == 3 && rand() < 0.5 { print 3, $3, $2, $4; next }
    /end_header/ { body = 1 } { print }'
}

# cubes X,Y,Z...: prints unit cubes with a corner at each of these points, as ASCII PLY.
cubes() {
  printf '%s\n' "$@" | awk -F, '
    { n = NR - 1
      for (i = 0; i < 8; ++i) points = points ($1 + i % 2) " " ($2 + int(i / 2) % 2) " " ($3 + int(i / 4)) "\n"
      count = split("021 123 456 576 014 154 263 367 042 246 135 375", corners, " ")
      for (f = 1; f <= count; ++f) {
        faces = faces "3"
        for (i = 1; i <= 3; ++i) faces = faces " " (8 * n + substr(corners[f], i, 1))
        faces = faces "\n"
      } }
    END {
      printf "ply\nformat ascii 1.0\nelement vertex %d\n", 8 * NR
      printf "property double x\nproperty double y\nproperty double z\n"
      printf "element face %d\nproperty list uchar int vertex_indices\nend_header\n", 12 * NR
      printf "%s%s", points, faces
    }'
}

# is_solid VOLUME < mesh: checks for a closed oriented manifold of that volume that tm-clean does not
# change.
is_solid() {
  cat > "$BATS_TEST_TMPDIR/solid.ply"
  tm-checkmanifold --closed "$BATS_TEST_TMPDIR/solid.ply" >&2 || return
  tm-info --get volume "$BATS_TEST_TMPDIR/solid.ply" |
    awk -v expected="$1" '{ d = $1 - expected; exit !(d < 1e-9 && d > -1e-9) }' ||
    fail "the volume is $(tm-info --get volume "$BATS_TEST_TMPDIR/solid.ply") instead of $1"
}

@test "--orient mends shuffled faces: tm-clean refuses before and accepts after" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus --faces 600 -o torus.ply
  tm-convert --format ply-ascii torus.ply | shuffle > shuffled.ply
  run --separate-stderr tm-clean shuffled.ply -o out.ply
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"the mesh is not oriented; orient it with tm-stitch --orient" ]]
  run --separate-stderr tm-stitch shuffled.ply -o out.ply
  assert_status 0
  [[ $stderr == *"such edges): they stay apart; orient them with --orient" ]]
  tm-stitch --orient shuffled.ply | tm-clean | is_solid "$(tm-info --get volume torus.ply)"
}

@test "--orient gives solids that share an edge or a corner their insides back" {
  for place in 1,1,0 1,1,1; do
    cubes 0,0,0 "$place" | shuffle | tm-stitch --orient -o "$BATS_TEST_TMPDIR/out.ply"
    is_solid 2 < "$BATS_TEST_TMPDIR/out.ply"
    [ "$(tm-info --get components "$BATS_TEST_TMPDIR/out.ply")" = 2 ]
    tm-clean "$BATS_TEST_TMPDIR/out.ply" | is_solid 2
  done
}

@test "three faces on an edge become two sheets" {
  cd "$BATS_TEST_TMPDIR"
  printf 'OFF\n5 3 0\n0 0 -3\n0 -2 1\n3 0 0\n0 2 1\n-3 0 0\n3 0 2 4\n3 3 2 4\n3 2 4 1\n' > fan.off
  run --separate-stderr tm-clean fan.off -o out.off
  assert_status 3
  [[ $stderr == *"faces 0, 1 and 2 traverse the edge from vertex 2 at (3, 0, 0) to "* ]]
  tm-stitch -q --orient fan.off -o out.off
  [ "$(tm-info --get components out.off)" = 2 ]
  tm-checkmanifold out.off
  tm-clean out.off -o clean.off
}

@test "a Moebius strip is refused with the place and what to do" {
  cd "$BATS_TEST_TMPDIR"
  # Five vertices, five faces, half a twist.
  printf 'OFF\n5 5 0\n0 0 0\n4 0 0\n6 3 1\n2 5 3\n-2 3 1\n3 0 1 2\n3 1 2 3\n3 2 3 4\n3 3 4 0\n3 4 0 1\n' > strip.off
  for program in tm-clean "tm-stitch --orient"; do
    # shellcheck disable=SC2086 # the option is a word of its own
    run --separate-stderr $program strip.off -o out.off
    assert_status 3
    one_line "$stderr"
    [[ $stderr =~ faces\ [0-4]\ and\ [0-4]\ cannot\ have\ consistent\ orientations\ at\ the\ edge\ from\ vertex ]]
    [[ $stderr == *"only one side, like a Moebius strip; cut it open with tm-stitch without --orient, then close its borders with tm-fill --allow-crossings" ]]
    [ ! -e out.off ]
  done
  # The advice is true, and tm-stitch does not refer back to --orient.
  run --separate-stderr tm-stitch strip.off -o open.off
  assert_status 0
  [[ $stderr == *"however faces are reversed: they stay apart"* && $stderr != *"--orient"* ]]
  tm-clean open.off -o clean.off
  tm-fill -q --allow-crossings open.off -o closed.off
  [ "$(tm-info --get boundary_loops closed.off)" -eq 0 ]
  # Between the strip and its patch there is no room with five faces, but there is with twenty-four.
  awk 'BEGIN {
    print "OFF\n24 24 0"
    for (i = 0; i < 12; i++) for (side = -0.3; side < 0.4; side += 0.6) {
      turn = 3.14159265 * i / 6; r = 1 + side * cos(turn / 2)
      print r * cos(turn), r * sin(turn), side * sin(turn / 2)
    }
    for (i = 0; i < 12; i++) {
      c = i < 11 ? 2 * i + 2 : 1; d = i < 11 ? 2 * i + 3 : 0
      print 3, 2 * i, c, 2 * i + 1; print 3, 2 * i + 1, c, d
    }
  }' >strip.off
  run tm-clean strip.off
  assert_status 3
  tm-stitch -q strip.off | tm-fill -q --allow-crossings | tm-clean -o solid.off
  tm-checkmanifold --closed --intersections solid.off
}

@test "copies of faces beside others: what tm-clean says mends them does" {
  cd "$BATS_TEST_TMPDIR"
  # A wall of two faces that occurs twice, between two single faces with which it shares edges.
  printf 'OFF\n6 6 0\n0 0 1\n1 0 1\n0 1 1\n0 1 0\n1 0 0\n0 0 0\n' >copies.off
  printf '3 %s\n' "0 1 2" "3 1 4" "4 1 0" "4 0 5" "4 1 0" "4 0 5" >>copies.off
  run --separate-stderr tm-clean copies.off -o out.off
  assert_status 3
  one_line "$stderr"
  case $stderr in
    *"orient it with tm-stitch --orient") tm-stitch -q --orient copies.off -o mended.off ;;
    *"cannot change that; separate them with tm-stitch") tm-stitch -q copies.off -o mended.off ;;
    *) fail "$stderr" ;;
  esac
  tm-clean mended.off -o out.off
  tm-checkmanifold out.off
}

# mended FILE [closed]: checks that tm-stitch --orient makes a mesh that tm-checkmanifold and tm-clean
# accept.
mended() {
  needs_shared "meshes/$1"
  tm-stitch -q --orient "$shared_file" -o "$BATS_TEST_TMPDIR/out.ply"
  tm-checkmanifold ${2:+--closed} "$BATS_TEST_TMPDIR/out.ply"
  tm-clean -q "$BATS_TEST_TMPDIR/out.ply" -o "$BATS_TEST_TMPDIR/clean.ply"
}

@test "real shuffled meshes become closed and look outwards" {
  for mesh in blobby oblong tet; do
    mended "cgal/$mesh-shuffled.off" closed
    [[ $(tm-info --get volume "$BATS_TEST_TMPDIR/out.ply") != -* ]]
  done
  mended trimesh/multibody.stl closed
}

@test "real meshes with singular edges and vertices come apart" {
  for mesh in cgal/cubes.off geometry-central/hourglass_ico.obj transformesh/knot-1000.off \
    cgal/cow.off cgal/diplodocus.off trimesh/two_objects.obj; do
    mended "$mesh" closed
  done
  for mesh in cgal/non_manifold_face_graph.off cgal/cubes_one_patch_id_per_cc.off \
    cgal/quads_to_stitch.off cgal/degenerated-sd.off cgal/degtri_sliding.off \
    geometry-central/fan3.obj geometry-central/triple_vierbein.obj \
    cgal/tetra_intersected_by_triangle.off; do
    mended "$mesh"
  done
}

@test "real soups become meshes" {
  for mesh in cgal/sphere.stl geometry-central/stl_box_ascii.stl trimesh/torus.STL \
    trimesh/two_objects_mixed_case_names.stl; do
    mended "$mesh" closed
  done
  for mesh in cgal/pig.stl trimesh/soup.stl trimesh/featuretype.STL; do
    mended "$mesh"
  done
}

@test "a real Moebius strip is refused" {
  needs_shared meshes/geometry-central/moebius.obj
  run tm-stitch -q --orient "$shared_file" -o "$BATS_TEST_TMPDIR/out.ply"
  assert_status 3
  [[ $output == *Moebius* ]]
}

@test "--tolerance joins corners that lie a little apart" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --faces 500 -o sphere.ply
  tm-convert -q -o soup.stl sphere.ply
  tm-convert -q --double --format ply-ascii soup.stl | awk '
    in_body && NF == 3 { $1 += (n++ % 5 - 2) * 1e-6 }
    /^end_header/ { in_body = 1 }
    { print }' >apart.ply
  tm-stitch -o exact.ply apart.ply
  [ "$(tm-info --get boundary_loops exact.ply)" -gt 0 ]
  for tolerance in 0.00001 0.001% 0.0001x; do
    tm-stitch --tolerance $tolerance -o joined.ply apart.ply
    [ "$(tm-info --get vertices joined.ply)" -eq "$(tm-info --get vertices sphere.ply)" ]
    tm-checkmanifold --closed joined.ply
  done
}

@test "--one-side makes a solid of a double-sided model, which tm-clean names" {
  tm-shape sphere --faces 500 -o "$BATS_TEST_TMPDIR/ball.ply"
  tm-stitch --flip "$BATS_TEST_TMPDIR/ball.ply" -o "$BATS_TEST_TMPDIR/reverse.ply"
  tm-cat "$BATS_TEST_TMPDIR/reverse.ply" "$BATS_TEST_TMPDIR/ball.ply" >"$BATS_TEST_TMPDIR/both.ply"
  run --separate-stderr tm-clean "$BATS_TEST_TMPDIR/both.ply"
  assert_status 4
  [[ $stderr == *"in double-sided models; keep one side of a double-sided model with tm-stitch --one-side" ]]
  pipe "tm-stitch --one-side $BATS_TEST_TMPDIR/both.ply | tm-clean >$BATS_TEST_TMPDIR/out.ply"
  assert_status 0
  [ "$(tm-info --get volume "$BATS_TEST_TMPDIR/out.ply")" = "$(tm-info --get volume "$BATS_TEST_TMPDIR/ball.ply")" ]
}

@test "--orient does not turn a copy against its original: two rings are one after cleaning" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus --faces 400 -o ring.ply
  # Every third face of both is reversed.
  tm-cat ring.ply ring.ply | tm-convert --no-provenance --format off |
    awk '$1 == 3 && NF == 4 && ++k % 3 == 0 { print 3, $2, $4, $3; next } { print }' >two.off
  tm-stitch -q --orient two.off | tm-clean -q -o one.ply
  [ "$(tm-info --get components one.ply)" = 1 ]
  awk -v one="$(tm-info --get volume one.ply)" -v ring="$(tm-info --get volume ring.ply)" \
    'BEGIN { exit !(one > 0.999999 * ring && one < 1.000001 * ring) }'
}
