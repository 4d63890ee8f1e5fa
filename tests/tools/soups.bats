# Soups and seams. In a soup, as STL is, every triangle has its own vertices; a seam is a row of edges whose
# faces have their own vertices. Programs that follow faces by vertex indices find borders there.
load ../helpers/common

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  # A closed ball on a plate, and a bowl.
  tm-shape box 2 2 0.3 --faces 800 -o plate.ply
  tm-shape sphere --radius 0.5 --center 0,0,0.4 --faces 800 | tm-cat plate.ply - |
    tm-clean -q | tm-convert -q --no-provenance -o body.off
  tm-shape sphere --faces 800 | tm-select --box=-2,-2,-2,2,2,0.5 | tm-convert -q --no-provenance -o bowl.off
  # Faces share vertices, except across the plane x = 0.
  awk '
    NR == 1 || /^#/ { print; next }
    !n { n = $1; f = $2; next }
    v < n { place[v++] = $0; x[v - 1] = $1; next }
    NF >= 4 { face[m++] = $2 " " $3 " " $4; side[m - 1] = x[$2] + x[$3] + x[$4] > 0 }
    END {
      print 2 * n, f, 0
      for (i = 0; i < 2 * n; ++i) print place[i % n]
      for (i = 0; i < f; ++i) { split(face[i], c, " "); s = side[i] * n; print 3, c[1] + s, c[2] + s, c[3] + s }
    }' body.off >seam.off
  tm-convert -q --no-provenance --double --format stl body.off | tm-convert -q --no-provenance -o body.ply
  tm-convert -q -o bowl.stl bowl.off
  tm-convert -q --no-provenance -o bowl.ply bowl.stl
}

setup() {
  cd "$BATS_FILE_TMPDIR"
  work=$BATS_TEST_TMPDIR
}

# Compares the output for a soup with the output for the mesh that tm-stitch makes of it.
joins() { # FILE PROGRAM OPTION...
  local file=$1
  shift
  tm-stitch -q --no-provenance "$file" | "$@" --no-provenance --format off >"$work/stitched.off" 2>/dev/null ||
    fail "$*: after tm-stitch $?"
  run --separate-stderr "$@" --no-provenance --format off --report "$work/report.json" -o "$work/joined.off" "$file"
  assert_status 0
  [[ $stderr == *" vertices joined with others in the same place, as tm-stitch does"* ]] || fail "$* $file: $stderr"
  [[ $stderr != *"join them with tm-stitch"* ]]
  cmp "$work/stitched.off" "$work/joined.off" || fail "$* $file"
  [ "$(jq .result.joined_vertices "$work/report.json")" -gt 0 ]
}

@test "programs that need connectivity join soups, with the result of a stitched mesh" {
  for file in body.ply seam.off bowl.ply; do
    [ "$(tm-checkmanifold --json "$file" | jq .touching_borders)" -gt 0 ]
    joins "$file" tm-remesh --reference-edge 0.1
    joins "$file" tm-remesh --reference-edge 0.1 --feature-angle 180 --iterations 3
    joins "$file" tm-remesh --faces 400
    joins "$file" tm-remesh --reference-edge 0.1 --align bowl.off
    joins "$file" tm-remesh --reference-edge 0.1 --source
  done
  joins bowl.ply tm-fill
  for file in body.ply seam.off; do
    joins "$file" tm-handles
    joins "$file" tm-offset --distance 0.05
  done
}

@test "an STL file keeps its area and its one component" {
  tm-shape box 1 1 3 --faces 500 -o "$work/box.stl"
  tm-remesh -q --iterations 3 "$work/box.stl" -o "$work/box.off"
  [ "$(tm-info --get components "$work/box.off")" -eq 1 ]
  tm-info --get area "$work/box.off" | awk '{ exit !($1 > 13.9999 && $1 < 14.0001) }'
}

@test "a mesh that is closed, or open without a seam, causes no note" {
  for file in body.off bowl.off; do
    run --separate-stderr tm-remesh --report "$work/report.json" -o "$work/out.ply" "$file"
    assert_status 0
    [ -z "$stderr" ] || fail "$stderr"
    [ "$(jq .result.joined_vertices "$work/report.json")" -eq 0 ]
  done
}

@test "steps refuse soups, and the advice is true" {
  refuses() {
    run --separate-stderr "$@" -o "$work/out.ply"
    assert_status 3
    [[ $stderr == *"border edges coincide"*"join them with tm-stitch" ]] || fail "$stderr"
    [ ! -e "$work/out.ply" ]
  }
  for file in body.ply seam.off; do
    refuses tm-displace --normal-speed 0.01 "$file"
    refuses tm-displace --curvature-speed 0.01 "$file"
    refuses tm-flow mean-curvature "$file"
    refuses tm-morph-step --target bowl.off "$file"
    tm-stitch -q "$file" -o "$work/mesh.ply"
    tm-displace -q --normal-speed 0.01 "$work/mesh.ply" -o /dev/null
    tm-flow -q mean-curvature "$work/mesh.ply" -o /dev/null
    tm-morph-step -q --target bowl.off "$work/mesh.ply" -o /dev/null
  done
}

@test "a soup as target gives the result of its mesh" {
  tm-shape box 1 1 3 --faces 12 --no-provenance -o "$work/box.ply"
  tm-convert -q -o "$work/box.stl" "$work/box.ply"
  tm-shape sphere --around "$work/box.ply" --faces 1000 -o "$work/ball.ply"
  for target in box.ply box.stl; do
    tm-morph -q --no-provenance "$work/ball.ply" --target "$work/$target" --reference-edge 0.3 -o "$work/to-$target.ply"
  done
  cmp "$work/to-box.ply.ply" "$work/to-box.stl.ply"
  tm-compare --reference "$work/box.ply" --within 1e-9 "$work/to-box.stl.ply"
}

@test "inconsistently oriented faces are refused with a remedy" {
  # A strip with one reversed face.
  printf 'OFF\n9 3 0\n0 0 0\n1 0 0\n0 1 0\n1 0 0\n1 1 0\n0 1 0\n1 0 0\n2 0 0\n1 1 0\n3 0 1 2\n3 3 4 5\n3 6 8 7\n' >"$work/strip.off"
  run --separate-stderr tm-remesh "$work/strip.off" -o "$work/out.ply"
  assert_status 3
  [[ $stderr == *"orient it with tm-stitch --orient" ]] || fail "$stderr"
  tm-stitch -q --orient "$work/strip.off" | tm-remesh -q -o "$work/out.ply"
}

@test "tm-info and tm-select say that counts are those of a soup" {
  for program in "tm-info" "tm-select --largest 1"; do
    run --separate-stderr $program body.ply
    assert_status 0
    [[ $stderr == *"body.ply: "*" border edges coincide: the faces share no vertices there; join them with tm-stitch" ]] ||
      fail "$stderr"
    # For STL, the note is given when the file is read.
    run --separate-stderr $program bowl.stl
    one_line "$stderr"
  done
}

@test "tm-checkmanifold --closed names tm-stitch before tm-fill, and is right" {
  run tm-checkmanifold --closed body.ply
  assert_status 1
  [[ $output == *"has only one face"*"border edges coincide, as in a soup of triangles; join them with tm-stitch" ]] ||
    fail "$output"
  tm-stitch -q body.ply | tm-checkmanifold --closed
  run tm-checkmanifold --closed bowl.ply
  [[ $output == *"join them with tm-stitch" ]]
  tm-stitch -q bowl.ply -o "$work/bowl.off"
  run tm-checkmanifold --closed "$work/bowl.off"
  [[ $output == *"; close holes with tm-fill" ]]
}
