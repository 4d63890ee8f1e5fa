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

@test "a mirror by the name of an axis is the one in its plane" {
  for axis in x:1,0,0,0 y:0,1,0,0 z:0,0,1,0; do
    tetrahedron | tm-transform --mirror "${axis%:*}" --translate 1,2,3 |
      cmp - <(tetrahedron | tm-transform --mirror "${axis#*:}" --translate 1,2,3)
  done
  [ "$(tm-info --get bbox_min <(tetrahedron | tm-transform --mirror y))" = "0 -1 0" ]
  run --separate-stderr tm-transform --mirror w <(tetrahedron)
  assert_status 2
  [[ $stderr == *"'w' is neither x, y, z nor four numbers separated by commas" ]]
}

@test "a matrix in a file is the one on the command line, in its turn" {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >mesh.ply
  printf '%s\n' '# turned' '0 -1 0 3' '1, 0, 0, 0' '0 0 2 0 0 0 0 1' >pose.txt
  tm-transform --translate 1,2,3 --matrix 0,-1,0,3,1,0,0,0,0,0,2,0,0,0,0,1 --scale 2 mesh.ply >expected.ply
  tm-transform --translate 1,2,3 --matrix pose.txt --scale 2 mesh.ply | cmp - expected.ply
  tm-transform --translate 1,2,3 --matrix - --scale 2 mesh.ply <pose.txt | cmp - expected.ply
  [ "$(tm-info --get bbox_max <(tm-transform --matrix ./pose.txt --matrix pose.txt mesh.ply))" = "3 3 4" ]
  echo 1 2 3 >short.txt
  for matrix in short.txt none.txt /; do
    run --separate-stderr tm-transform --matrix "$matrix" mesh.ply -o out.ply
    assert_status 3
    one_line "$stderr"
    [ ! -e out.ply ]
  done
  run --separate-stderr tm-transform --matrix 1,2,3 mesh.ply
  assert_status 2
  run --separate-stderr tm-transform --matrix - <mesh.ply
  assert_status 2
}
