load ../helpers/common

@test "maps apply in the order of the command line" {
  tetrahedron | tm-transform --translate 1,0,0 --scale 2 -o "$BATS_TEST_TMPDIR/a.ply"
  tetrahedron | tm-transform --scale 2 --translate 1,0,0 -o "$BATS_TEST_TMPDIR/b.ply"
  [ "$(tm-info --get bbox_min "$BATS_TEST_TMPDIR/a.ply")" = "2 0 0" ]
  [ "$(tm-info --get bbox_min "$BATS_TEST_TMPDIR/b.ply")" = "1 0 0" ]
  tetrahedron | tm-transform --translate 1,2,3 --rotate 0,0,1,90 --rotate 0,0,1,-90 --translate -1,-2,-3 \
    --no-provenance | cmp - <(tetrahedron | tm-transform --no-provenance)
}

@test "a mirror keeps the outside, and the provenance has the matrix that does it again" {
  tetrahedron | tm-transform --mirror 1,0,0,2 --center -o "$BATS_TEST_TMPDIR/a.ply"
  [[ $(tm-info --get volume "$BATS_TEST_TMPDIR/a.ply") == 0.333* ]]
  matrix=$(sed -n 's/^comment tm-transform .* --matrix //p' "$BATS_TEST_TMPDIR/a.ply")
  tetrahedron | tm-transform --matrix "$matrix" | cmp - "$BATS_TEST_TMPDIR/a.ply"
}

@test "the reference edge scales, and the unit box is one" {
  tm-shape box 1 2 4 --faces 200 | tm-remesh |
    tm-transform --report "$BATS_TEST_TMPDIR/r.json" --unit-box -o "$BATS_TEST_TMPDIR/a.ply"
  tm-shape box 1 2 4 --faces 200 | tm-remesh >"$BATS_TEST_TMPDIR/b.ply"
  edge() { sed -n 's/^comment tm:reference-edge //p' "$1"; }
  awk -v a="$(edge "$BATS_TEST_TMPDIR/a.ply")" -v b="$(edge "$BATS_TEST_TMPDIR/b.ply")" \
    'BEGIN { d = 4 * a / b - 1; exit !(d < 0.05 && d > -0.05) }'
  jq -e '.result | .mirrored == false and (.matrix | length) == 16' "$BATS_TEST_TMPDIR/r.json"
  tm-info --get bbox_max "$BATS_TEST_TMPDIR/a.ply" | awk '{ exit !($3 > 1 - 1e-15 && $3 < 1 + 1e-15) }'
}

@test "singular maps are exit 2, results that are not finite exit 4" {
  for options in '--scale 0' '--scale-axes 1,0,1' '--rotate 0,0,0,3' '--mirror 0,0,0,1' '--scale x' \
    '--matrix 1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,2'; do
    # shellcheck disable=SC2086 # words of their own
    run --separate-stderr tm-transform $options <(tetrahedron)
    assert_status 2
    one_line "$stderr"
  done
  run --separate-stderr tm-transform --translate 1e308,0,0 --translate 7e307,0,0 --scale 1.5 <(tetrahedron)
  assert_status 2
  run --separate-stderr tm-transform --scale 1e308 --translate 9e307,9e307,9e307 <(tetrahedron)
  assert_status 4
  one_line "$stderr"
}
