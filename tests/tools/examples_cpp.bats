# The C++ examples that docs/recipes.md shows.

load ../helpers/common

@test "own_velocity: an evolution in fifteen lines turns a ball, and the recipes show it" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --center 1,0,0 --radius 0.3 --faces 1000 -o ball.ply
  "$tm_build/bin-test/example_own_velocity" ball.ply turned.ply
  tm-checkmanifold --closed turned.ply
  tm-intersect --check turned.ply
  # The ball has rotated about the axis to positive y, at the same distance.
  tm-info turned.ply >facts
  awk '$1 == "bbox_max:" { exit !($3 > 0.35) }' facts || fail "$(cat facts)"
  # The recipes print the program with file names instead of arguments.
  sed -e '1d; /if (argc < 3)/d; s/int argc, char[*][*] argv//' -e 's/argv\[1\]/"ball.ply"/; s/argv\[2\]/"turned.ply"/' \
    "$tm_root/tests/examples/own_velocity.cpp" >expected
  awk '/^```cpp$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$tm_root/docs/recipes.md" | diff expected -
}
