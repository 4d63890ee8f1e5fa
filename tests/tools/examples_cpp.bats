# The C++ examples that the README shows.

load ../helpers/common

@test "own_velocity: an evolution in fifteen lines turns a ball, and the README shows its lines" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --center 1,0,0 --radius 0.3 --faces 1000 -o ball.ply
  "$tm_build/bin-test/example_own_velocity" ball.ply turned.ply
  tm-checkmanifold --closed turned.ply
  tm-intersect --check turned.ply
  # The ball has gone around the axis: it is where y is positive, as far away as before.
  tm-info turned.ply >facts
  awk '$1 == "bbox_max:" { exit !($3 > 0.35) }' facts || fail "$(cat facts)"
  # All but its frame is in the README.
  sed -nE '/const Velocity/,/write_mesh_file/p' "$tm_root/tests/examples/own_velocity.cpp" |
    sed 's/^  //; s/argv\[2\]/"turned.ply"/' >lines
  grep -qF "$(sed -n 1,5p lines)" "$tm_root/README.md"
  while IFS= read -r line; do grep -qF -- "$line" "$tm_root/README.md" || fail "not in the README: $line"; done <lines
}
