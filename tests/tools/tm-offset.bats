load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR" || return
}

@test "a ball grows and shrinks by pipes, and the report measures how well" {
  tm-shape sphere --faces 3000 -o "$BATS_TEST_TMPDIR/ball.ply"
  pipe "tm-offset --distance 0.5 --report $BATS_TEST_TMPDIR/r.json <$BATS_TEST_TMPDIR/ball.ply |
    tm-offset --distance -0.5 >$BATS_TEST_TMPDIR/back.ply"
  assert_status 0
  jq -e '.result | .stop == "converged" and .deviation_max < 0.01 and .missed_max < 0.01 and
    .components == 1 and .genus == 0' "$BATS_TEST_TMPDIR/r.json"
  tm-compare --json --reference "$BATS_TEST_TMPDIR/ball.ply" "$BATS_TEST_TMPDIR/back.ply" \
    >"$BATS_TEST_TMPDIR/distance.json"
  jq -e '.hausdorff < 0.03' "$BATS_TEST_TMPDIR/distance.json"
}

@test "a torus loses its hole, and the result has no self-intersection" {
  tm-shape torus --faces 3000 -o "$BATS_TEST_TMPDIR/torus.ply"
  hole=$(tm-info --get genus "$BATS_TEST_TMPDIR/torus.ply")
  [ "$hole" -eq 1 ]
  tm-offset --distance 30% "$BATS_TEST_TMPDIR/torus.ply" -o "$BATS_TEST_TMPDIR/out.ply"
  [ "$(tm-info --get genus "$BATS_TEST_TMPDIR/out.ply")" -eq 0 ]
  tm-intersect --check "$BATS_TEST_TMPDIR/out.ply"
  tm-checkmanifold --closed "$BATS_TEST_TMPDIR/out.ply"
}

@test "bodies that overlap are united before they are offset" {
  cd "$BATS_TEST_TMPDIR" || return
  tm-shape box 2 1 1 --faces 400 -o a.ply
  tm-shape box 1 2 0.9 --faces 400 -o b.ply
  tm-cat a.ply b.ply | tm-offset --distance 0.1 --edge 0.05 --report r.json >overlapping.ply
  jq -e '.result.stop == "converged" and .result.missed_max < 0.0375' r.json
  tm-cat a.ply b.ply | tm-clean | tm-offset --distance 0.1 --edge 0.05 -o united.ply
  tm-compare --reference united.ply --within 1e-9 overlapping.ply
}

@test "what vanishes is exit 4, what is open exit 3, and a missing distance exit 2" {
  tm-shape box 1 1 1 --faces 500 -o "$BATS_TEST_TMPDIR/box.ply"
  run --separate-stderr tm-offset --distance -0.6 "$BATS_TEST_TMPDIR/box.ply" -o "$BATS_TEST_TMPDIR/none.ply"
  assert_status 4
  [[ $stderr == *"0.6 inside"* ]]
  [ ! -e "$BATS_TEST_TMPDIR/none.ply" ]
  tm-convert --no-provenance --format off "$BATS_TEST_TMPDIR/box.ply" |
    awk '/^[0-9]/ && !n { n = $1 + $2; $2 -= 1; print; next } /^[0-9-]/ && ++row == n { next } { print }' \
      >"$BATS_TEST_TMPDIR/open.off"
  run --separate-stderr tm-offset --distance 0.1 "$BATS_TEST_TMPDIR/open.off"
  assert_status 3
  [[ $stderr == *"the mesh is open"* ]]
  run tm-offset "$BATS_TEST_TMPDIR/box.ply"
  assert_status 2
  [[ $output == *"--distance"* ]]
}

@test "a limit of iterations that stops the loop before convergence is reported" {
  tm-shape sphere --faces 500 -o "$BATS_TEST_TMPDIR/ball.ply"
  run --separate-stderr tm-offset --distance 1 --iterations 2 "$BATS_TEST_TMPDIR/ball.ply" -o "$BATS_TEST_TMPDIR/out.ply"
  assert_status 0
  [[ $stderr == *"not converged after the last iteration"* ]]
}

@test "a thin plate that loses its rim did not converge, which is reported; the edge that is named keeps it" {
  tm-shape box 4 6 8 --faces 12 -o "$BATS_TEST_TMPDIR/box.ply"
  run --separate-stderr tm-offset --distance -1.9 --edge 0.4 --report "$BATS_TEST_TMPDIR/r.json" \
    -o "$BATS_TEST_TMPDIR/plate.ply" "$BATS_TEST_TMPDIR/box.ply"
  assert_status 0
  [[ $stderr == *"did not converge"*"--edge "* ]]
  jq -e '.result | .stop == "missed" and .missed_max > 0.75 * .edge' "$BATS_TEST_TMPDIR/r.json"
  while [[ $stderr == *"--edge "* ]]; do
    before=$(jq .result.missed_max "$BATS_TEST_TMPDIR/r.json")
    run --separate-stderr tm-offset --distance -1.9 --edge "${stderr##*--edge }" \
      --report "$BATS_TEST_TMPDIR/r.json" -o "$BATS_TEST_TMPDIR/plate.ply" "$BATS_TEST_TMPDIR/box.ply"
    assert_status 0
    jq -e --argjson before "$before" '.result.missed_max < $before' "$BATS_TEST_TMPDIR/r.json"
  done
  # The exact result is a box of .2 x 2.2 x 4.2, with the volume 1.848.
  tm-info --get volume "$BATS_TEST_TMPDIR/plate.ply" | awk '{ exit !($1 > 1.7 && $1 < 1.87) }'
}

@test "a narrow groove that is filled is reported as a gap, and the edge that is named comes nearer" {
  # The groove has an angle of 10 degrees.
  cat >wedge.off <<'END'
OFF
6 8 0
-0.3 -1 0
0.7 -1 -0.0875
0.7 -1 0.0875
-0.3 1 0
0.7 1 -0.0875
0.7 1 0.0875
3 0 1 2
3 3 5 4
3 0 3 4
3 0 4 1
3 1 4 5
3 1 5 2
3 2 5 3
3 2 3 0
END
  tm-shape box 1 1.5 1.5 --faces 12 -o block.off
  tm-boolean difference block.off wedge.off -q -o groove.off
  move() {
    run --separate-stderr tm-offset --distance 0.02 --edge "$1" groove.off --report r.json -o out.ply
    assert_status 0
  }
  move 0.03
  [[ $stderr == *"because parts or gaps thinner than an edge are lost; shorter edges come nearer: --edge 0.015" ]]
  before=$(jq .result.missed_max r.json)
  move "${stderr##*--edge }"
  jq -e --argjson before "$before" '.result.missed_max < $before' r.json
}

@test "--miter keeps corners sharp: a box becomes the larger or the smaller box" {
  while read -r distance volume; do
    tm-shape box 1 2 3 --faces 500 | tm-offset --miter --distance "$distance" -o box.ply
    tm-checkmanifold --closed --intersections box.ply >/dev/null
    tm-info --get volume box.ply | awk -v v="$volume" '{ exit !($1 > v - 1e-9 && $1 < v + 1e-9) }'
  done <<'TABLE'
0.25 13.125
-0.25 1.875
TABLE
  # An inward offset by 0.6 turns sides of length 1 inside out: one side of the first box, two of the second.
  for size in '1 2 3' '1 1 3'; do
    # shellcheck disable=SC2086
    tm-shape box $size --faces 500 -o box.ply
    run --separate-stderr tm-offset --miter --distance -0.6 box.ply -o none.ply
    assert_status 4
    one_line "$stderr"
    [ ! -e none.ply ]
  done
}

@test "--thicken makes a solid of a sheet, whose volume is its area times the thickness" {
  tm-shape box 1 2 3 --faces 500 | tm-select --box -9,-9,-9,9,9,1.4 -o tray.ply
  tm-offset --thicken 0.1 tray.ply -o solid.ply
  tm-checkmanifold --closed --intersections solid.ply >/dev/null
  # Mitered corners gain as much volume outside as they lose inside.
  awk -v a="$(tm-info --get area tray.ply)" -v v="$(tm-info --get volume solid.ply)" \
    'BEGIN { d = v / (0.1 * a) - 1; exit !(d < 0.01 && d > -0.01) }'
  run --separate-stderr tm-offset --thicken 0.1 solid.ply
  assert_status 3
  one_line "$stderr"
  for options in '' '--thicken 1 --distance 1' '--thicken 0'; do
    # shellcheck disable=SC2086
    run --separate-stderr tm-offset $options tray.ply
    assert_status 2
    one_line "$stderr"
  done
}
