load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus --faces 2000 -o torus.ply
}

@test "tm-sample: so many points with normals, without faces" {
  tm-sample --count 500 --format ply-ascii torus.ply >points.ply
  grep -qx 'element vertex 500' points.ply
  grep -qx 'property double nz' points.ply
  run grep 'element face' points.ply
  assert_status 1
  [ "$(sed '1,/^end_header/d' points.ply | awk 'NF == 6' | wc -l)" -eq 500 ]
}

@test "tm-sample: no two points are nearer than the distance" {
  tm-sample --distance 0.1 --format ply-ascii torus.ply | sed '1,/^end_header/d' >points
  awk '{ for (i = 0; i < n; ++i) if ((x[i] - $1) ^ 2 + (y[i] - $2) ^ 2 + (z[i] - $3) ^ 2 < 0.01) bad = 1
         x[n] = $1; y[n] = $2; z[n++] = $3 } END { exit bad || n < 500 }' points
}

@test "tm-sample: its points become the surface again" {
  tm-sample --distance 3% torus.ply >points.ply
  tm-compare --reference points.ply --within 10% torus.ply
}

@test "tm-sample: OFF in is PLY out, unless OFF is asked for" {
  tm-convert -o torus.off torus.ply
  pipe 'tm-sample --count 5 torus.off | head -1'
  [ "$output" = ply ]
  pipe 'tm-sample --count 5 --format off torus.off | head -1'
  [ "$output" = NOFF ]
}

@test "tm-sample: invalid options are refused in one line" {
  for options in '' '--count 5 --distance 1%' '--distance 0' '--distance 1e-9' '--count -1'; do
    # shellcheck disable=SC2086
    run --separate-stderr tm-sample $options torus.ply
    assert_status 2
    one_line "$stderr"
  done
  printf 'OFF\n1 0 0\n0 0 0\n' >point.off
  run --separate-stderr tm-sample --count 5 point.off
  assert_status 3
  one_line "$stderr"
}
