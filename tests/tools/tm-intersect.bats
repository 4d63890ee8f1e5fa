#!/usr/bin/env bats
load ../helpers/common

@test "--check answers by exit code" {
  pipe 'tm-shape torus --faces 1000 | tm-intersect --check'
  assert_status 0
  [ "$output" = "pairs: 0" ]
  pipe 'tm-shape two-spheres --faces 1000 | tm-intersect --check'
  assert_status 1
}

@test "--any tells whether there are pairs, without counting" {
  pipe 'tm-shape torus --faces 50000 | tm-intersect --any'
  assert_status 0
  [ "$output" = "intersects: false" ]
  pipe 'tm-shape two-spheres --faces 50000 | tm-intersect --any'
  assert_status 1
  [ "$output" = "intersects: true" ]
  pipe 'tm-shape torus --faces 1000 | tm-intersect --any --refine'
  assert_status 2
}

@test "the property counts each pair twice, and --pairs lists it once" {
  tm-shape two-spheres --faces 1000 |
    tm-intersect --pairs "$BATS_TEST_TMPDIR/pairs.txt" --report "$BATS_TEST_TMPDIR/report.json" \
      --format ply-ascii -o "$BATS_TEST_TMPDIR/out.ply"
  pairs=$(wc -l < "$BATS_TEST_TMPDIR/pairs.txt")
  [ "$pairs" -gt 0 ]
  grep -q "\"pairs\": $pairs" "$BATS_TEST_TMPDIR/report.json"
  sum=$(awk '$1 == 3 && NF == 5 { s += $5 } END { print s }' "$BATS_TEST_TMPDIR/out.ply")
  [ "$sum" -eq $((2 * pairs)) ]
}

@test "--refine leaves nothing that crosses, and the same volume" {
  tm-shape two-spheres --faces 1000 -o "$BATS_TEST_TMPDIR/in.ply"
  tm-intersect --refine "$BATS_TEST_TMPDIR/in.ply" -o "$BATS_TEST_TMPDIR/out.ply"
  run tm-intersect --check "$BATS_TEST_TMPDIR/out.ply"
  assert_status 0
  awk -v a="$(tm-info --get volume "$BATS_TEST_TMPDIR/in.ply")" \
    -v b="$(tm-info --get volume "$BATS_TEST_TMPDIR/out.ply")" \
    'BEGIN { exit !(a - b < 1e-9 && b - a < 1e-9) }'
}

@test "--segments of two spheres lie on a circle" {
  tm-shape two-spheres --faces 3000 |
    tm-intersect --segments "$BATS_TEST_TMPDIR/segments.ply" -o /dev/null
  run tm-info --get vertices "$BATS_TEST_TMPDIR/segments.ply"
  assert_status 0
  [ "$output" -gt 100 ]
}

@test "real meshes have the pairs that CGAL counts" {
  for mesh in man:848 bones:366 spheres_intersecting:88 camel:20; do
    needs_shared "meshes/cgal/${mesh%:*}.off"
    run tm-intersect --check "$shared_file"
    [ "$output" = "pairs: ${mesh#*:}" ]
  done
}

@test "--any and outputs that need all pairs exclude each other" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --faces 200 -o ball.ply
  for option in --refine "--pairs pairs.txt" "--segments segments.ply"; do
    # shellcheck disable=SC2086
    run --separate-stderr tm-intersect --any $option ball.ply
    [ "$status" -eq 2 ]
    [[ $stderr == *"--any stops at the first pair: leave out --refine, --pairs and --segments" ]]
  done
  tm-intersect --any ball.ply
}
