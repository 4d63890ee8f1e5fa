# Files on which tm-clean once failed. They are not part of the project; without them the tests are skipped.

load ../helpers/common

@test "tm-clean: two nearly coplanar sheets with 8,000 intersecting pairs become one surface" {
  needs_shared found/clean_hang_112588.ply.gz
  zcat "$shared_file" >"$BATS_TEST_TMPDIR/in.ply"
  cd "$BATS_TEST_TMPDIR"
  tm-clean in.ply -o out.ply --report report.json
  [ "$(jq .result.pairs report.json)" -eq 8000 ]
  tm-checkmanifold --certify in.ply out.ply
}

@test "tm-offset: a solid that touches itself, whose offset intersects itself at edges of 3e-8 of its size" {
  needs_shared found/10-order-small.off
  tm-repair -q "$shared_file" | tm-offset -q --distance 1% - -o "$BATS_TEST_TMPDIR/out.ply"
  tm-checkmanifold --closed --intersections "$BATS_TEST_TMPDIR/out.ply"
}

@test "tm-clean: an open mesh with coordinates of all magnitudes comes to an end" {
  needs_shared hostile/never-ends-78.off
  timeout 60 tm-clean "$shared_file" -o "$BATS_TEST_TMPDIR/out.ply"
  tm-checkmanifold "$BATS_TEST_TMPDIR/out.ply"
}
