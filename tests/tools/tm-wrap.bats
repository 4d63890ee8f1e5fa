load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus --faces 4000 --format off |
    awk '/^[-0-9]/ && NF == 3 && counts++ > 0' >points.xyz
}

@test "points alone are wrapped: closed, outside of all points" {
  run --separate-stderr tm-wrap points.xyz --alpha 0.2 --offset 0.02 -o wrap.ply --report r.json
  assert_status 0
  [ -z "$output$stderr" ]
  grep -q '"method": "alpha"' r.json
  tm-checkmanifold --closed wrap.ply
  tm-intersect --check wrap.ply
  [ "$(tm-info --get genus wrap.ply)" -eq 1 ]
  tm-wrap --alpha 0.2 --offset 0.02 <points.xyz | cmp - wrap.ply
}

@test "without --alpha it is found: no hole is closed, and nothing is hollow" {
  awk 'NR % 4 == 0' points.xyz >sparse.xyz
  for points in points sparse; do
    tm-wrap $points.xyz -o $points.ply --report $points.json
    tm-checkmanifold --closed $points.ply
    [ "$(tm-info --get components $points.ply)" -eq 1 ]
    [ "$(tm-info --get genus $points.ply)" -eq 1 ]
    awk -v volume="$(tm-info --get volume $points.ply)" -v truth="$(tm-shape torus | tm-info --get volume)" \
      'BEGIN { exit !(volume > 0.9 * truth && volume < 1.2 * truth) }'
  done
  run cmp -s <(grep '"alpha":' sparse.json) <(grep '"alpha":' points.json)
  [ "$status" -eq 1 ]
}

@test "points with normals get a Poisson surface" {
  awk '{ ring = sqrt($1 * $1 + $2 * $2); x = $1 - 0.85 * $1 / ring; y = $2 - 0.85 * $2 / ring
    print $1, $2, $3, x, y, $3 }' points.xyz >oriented.xyz
  tm-wrap oriented.xyz -o wrap.ply --report r.json
  grep -q '"method": "poisson"' r.json
  tm-checkmanifold --closed wrap.ply
  tm-shape torus --faces 4000 -o torus.ply
  tm-compare --reference torus.ply --within 0.1 wrap.ply
  for threads in 1 2 4; do tm-wrap oriented.xyz --threads "$threads" | cmp - wrap.ply; done
  tm-wrap oriented.xyz --method alpha -o other.ply
  run cmp -s wrap.ply other.ply
  [ "$status" -eq 1 ]
}

@test "options of the method alpha are refused if they are 0 or if the method is poisson" {
  awk '{ print $1, $2, $3, 0, 0, 1 }' points.xyz >oriented.xyz
  for option in --alpha --offset; do
    for how in '--method poisson' '--method auto'; do
      run --separate-stderr tm-wrap oriented.xyz $how $option 0.1
      assert_status 2
      [[ $stderr == *'--alpha and --offset need --method alpha' ]]
    done
    run --separate-stderr tm-wrap points.xyz $option 0
    assert_status 2
    [[ $stderr == *"$option must be above 0" ]]
  done
}

@test "of a mesh the vertices are wrapped" {
  tm-shape sphere --faces 2000 | tm-wrap --alpha 20% -o wrap.ply
  tm-checkmanifold --closed wrap.ply
  [ "$(tm-info --get genus wrap.ply)" -eq 0 ]
}

@test "points that are not finite and points without a normal are left out with a count" {
  awk '{ ring = sqrt($1 * $1 + $2 * $2); x = $1 - 0.85 * $1 / ring; y = $2 - 0.85 * $2 / ring
    print $1, $2, $3, x, y, $3 }' points.xyz >oriented.xyz
  { cat oriented.xyz; echo 'nan 0 0 0 0 1'; } >bad.xyz
  sed '7s/[^ ]*$/nan/' oriented.xyz >bad_normal.xyz
  for method in alpha poisson; do
    how=(--method "$method")
    if [ $method = alpha ]; then how+=(--alpha 0.2); fi
    tm-wrap oriented.xyz "${how[@]}" -o whole.ply
    run --separate-stderr tm-wrap bad.xyz "${how[@]}" -o wrap.ply
    assert_status 0
    [[ $stderr == *'1 vertex with a coordinate that is not finite dropped' ]]
    cmp whole.ply wrap.ply
    run --separate-stderr tm-wrap bad_normal.xyz "${how[@]}" -o wrap.ply --report r.json
    assert_status 0
    [[ $stderr == *'1 normal that is not finite becomes 0'* ]]
    if [ $method = alpha ]; then
      cmp whole.ply wrap.ply
    else
      [[ $stderr == *'1 point without a normal left out'* ]]
      [ "$(jq .result.points_without_normal r.json)" -eq 1 ]
    fi
    for file in bad bad_normal; do
      run tm-wrap --strict $file.xyz --method $method
      assert_status 3
    done
  done
}

@test "bad input is exit 3" {
  run --separate-stderr tm-wrap points.xyz --method poisson
  assert_status 3
  [[ $stderr == *"no normals"* ]]
  echo "1 2" >bad.xyz
  run --separate-stderr tm-wrap bad.xyz
  assert_status 3
  one_line "$stderr"
  printf '1 1 1\n1 1 1\n1 1 1\n1 1 1\n1 1 1\n' >same.xyz
  run --separate-stderr tm-wrap same.xyz
  assert_status 3
  one_line "$stderr"
}

@test "an alpha that would take minutes is refused, and the one named instead is not" {
  run --separate-stderr timeout 20 tm-wrap points.xyz --alpha 0.0001 --offset 0.05 -o wrap.ply
  assert_status 2
  one_line "$stderr"
  [ ! -e wrap.ply ]
  # The wrap of this point would be a ball of radius 1 with too many faces, so the program must refuse it.
  echo 0 0 0 >one.xyz
  run --separate-stderr timeout 20 tm-wrap one.xyz --alpha 0.0001 --offset 1 -o wrap.ply
  assert_status 2
  [[ $stderr == *"; use 0.0029 or more"* ]]
}

@test "coordinates that no square fits, and all that are too few: an answer, or exit 3 and one line" {
  for scale in 1e-320 1e-200 1e154 1e200 1e308; do
    awk -v s=$scale 'NR % 40 == 0 { printf "%.17g %.17g %.17g\n", s * $1, s * $2, s * $3 }' \
      points.xyz >cloud.xyz
    printf "$scale 0 0\n%.0s" 1 2 3 4 5 >same.xyz
    printf "$scale 0 0\n0 $scale 0\n" >two.xyz
    echo "$scale $scale 0" >one.xyz
    for points in cloud same two one; do
      awk '{ print $0, 0, 0, 1 }' $points.xyz >$points-normals.xyz
      for file in $points $points-normals; do
        run --separate-stderr timeout 60 tm-wrap $file.xyz -o wrap.ply
        case $status in
          0) tm-checkmanifold --closed wrap.ply ;;
          3 | 4) one_line "$stderr" ;;
          *) fail "$file at $scale: exit code $status" ;;
        esac
      done
    done
  done
}

@test "points that CGAL finds no surface for: exit 4 and one line, not CGAL's" {
  # The points form a flat ring, which encloses no volume.
  awk 'BEGIN { for (i = 0; i < 200; ++i) print cos(i), sin(i), 1e-15 * (i % 3), 0, 0, 1 }' >flat.xyz
  run --separate-stderr tm-wrap flat.xyz -o wrap.ply
  assert_status 4
  one_line "$stderr"
  [[ $stderr == "tm-wrap: "* ]]
}

@test "messages are about points, not about a target; a mesh inside out has vertices as well" {
  printf 'ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n' >none.ply
  run --separate-stderr tm-wrap none.ply
  assert_status 3
  [[ $stderr != *target* ]]
  printf '0 0 0 nan 0 1\n' >nan.xyz
  run --separate-stderr tm-wrap nan.xyz
  assert_status 3
  [[ $stderr != *target* ]]
  # No normals have to be estimated.
  echo 1 2 3 | tm-wrap --alpha 0.2 --offset 0.1 | tm-checkmanifold --closed >/dev/null
  tm-shape sphere --faces 320 | tm-stitch --flip | tm-wrap --alpha 20% | tm-checkmanifold --closed >/dev/null
}

@test "equal points count as one" {
  awk 'BEGIN {
    for (i = 0; i < 5000; ++i) {
      z = (2 * i + 1) / 5000 - 1
      r = sqrt(1 - z * z)
      print r * cos(2.4 * i), r * sin(2.4 * i), z
    }
  }' >points.xyz
  # Points with normals on a sphere: CGAL's refinement chooses between equally bad cells.
  awk '{ print $1, $2, $3, $1, $2, $3 }' points.xyz >oriented.xyz
  for cloud in points oriented; do
    normal=
    [ "$cloud" = points ] || normal=' 0 0 1'
    echo "0 0 0$normal" | cat "$cloud.xyz" - >one.xyz
    yes "0 0 0$normal" | head -n 50000 | cat "$cloud.xyz" - >heap.xyz
    tm-wrap one.xyz >expected
    tm-wrap heap.xyz | cmp - expected
  done
}

@test "outliers are left out and said: the wrap is that of the points without them" {
  tm-shape sphere --faces 3000 --format off | awk '/^[-0-9]/ && NF == 3 && counts++ > 0' >clean.xyz
  printf '40 5 3\n10 50 2\n-30 2 6\n' | cat clean.xyz - >spoiled.xyz
  run --separate-stderr tm-wrap clean.xyz -o clean.ply --report clean.json
  assert_status 0
  [ -z "$stderr" ]
  jq -e '.result | .outliers == 0 and .least_distance > 0' clean.json
  run --separate-stderr tm-wrap spoiled.xyz -o spoiled.ply --report spoiled.json
  assert_status 0
  one_line "$stderr"
  [[ $stderr == *"3 outliers left out"*"(40, 5, 3)"*"--keep-outliers"* ]]
  jq -e --argjson all "$(wc -l <spoiled.xyz)" ".result | .outliers == 3 and .points == \$all" spoiled.json
  cmp clean.ply spoiled.ply
  # The same points with normals.
  awk '{ print $0, $1, $2, $3 }' clean.xyz >oriented.xyz
  awk '{ print $0, $1, $2, $3 }' spoiled.xyz | tm-wrap -q | cmp - <(tm-wrap oriented.xyz)
  # The option that the message names keeps these points.
  run --separate-stderr tm-wrap --keep-outliers --alpha 1 --offset 0.1 spoiled.xyz -o all.ply
  assert_status 0
  [[ $stderr != *"left out"* ]]
  tm-info --get bbox_max all.ply | awk '{ exit !($1 > 39 && $2 > 49) }'
}

@test "the vertices of a mesh are no outliers: a plate with a small ball" {
  tm-shape box 40 40 1 --faces 12 -o plate.ply
  tm-shape sphere --faces 1000 | tm-transform --translate 0,0,2 | tm-cat plate.ply - -o both.ply
  run --separate-stderr tm-wrap --alpha 20 both.ply -o wrap.ply --report r.json
  assert_status 0
  [ -z "$stderr" ]
  jq -e '.result.outliers == 0' r.json
  tm-info --get bbox_max wrap.ply | awk '{ exit !($1 > 20 && $2 > 20) }'
}

# 500 points on a sphere in COLMAP's format: 1 % with large errors, 2 % in only two photographs.
colmap_points() {
  echo '# 3D point list with one line of data per point:'
  awk 'BEGIN {
    for (i = 0; i < 500; ++i) {
      z = (2 * i + 1) / 500 - 1
      r = sqrt(1 - z * z)
      error = i % 100 == 50 ? 5 : 0.5 + i % 7 / 10
      print i, r * cos(2.4 * i), r * sin(2.4 * i), z, 10, 20, 30, error, "1 1 2 2" (i % 50 == 7 ? "" : " 3 3")
    }
  }'
}

@test "COLMAP's points are read, those of large errors and short tracks left out and said" {
  colmap_points >points3D.txt
  run --separate-stderr tm-wrap points3D.txt -o wrap.ply --report r.json
  assert_status 0
  [ "$(wc -l <<<"$stderr")" -eq 2 ]
  [[ $stderr == *"5 points with a large reprojection error left out"* ]]
  [[ $stderr == *"10 points in fewer than three photographs left out"* ]]
  jq -e '.result | .points == 500 and .large_errors == 5 and .short_tracks == 10 and
    .outliers == 0 and .components == 1' r.json
  # Wrapping only the remaining points, as text, gives the same result.
  awk '!/^#/ && $9 != "" && $8 < 5 && NF == 14 { print $2, $3, $4 }' points3D.txt >left.xyz
  [ "$(wc -l <left.xyz)" -eq 485 ]
  tm-wrap left.xyz | cmp - wrap.ply
  tm-wrap <points3D.txt 2>/dev/null | cmp - wrap.ply
  awk '!/^#/ { print $2, $3, $4 }' points3D.txt | tm-wrap --keep-outliers >all.ply
  tm-wrap --keep-outliers points3D.txt | cmp - all.ply
}

@test "5 % of outliers at 2 to 1000 times the size change nothing" {
  for shape in sphere torus box; do
    tm-shape $shape --faces 6000 | tm-sample --distance 4% --format xyz |
      awk '!/^#/ { print $1, $2, $3 }' >clean.xyz
    tm-wrap clean.xyz -o clean.ply
    for size in 2 30 1000; do
      awk -v size="$size" '{ print } NR % 20 == 0 {
        a = 2.4 * NR; z = (NR * 37) % 199 / 100 - 0.99; r = sqrt(1 - z * z); s = 3 * size
        print s * r * cos(a), s * r * sin(a), s * z }' clean.xyz >spoiled.xyz
      tm-wrap -q spoiled.xyz --report r.json | cmp - clean.ply
      jq -e --argjson all "$(wc -l <clean.xyz)" '.result.outliers == ($all / 20 | floor)' r.json
    done
  done
}

@test "a wrap that follows stray points is said to do so" {
  awk 'BEGIN { for (i = 0; i < 3000; ++i) { z = (2 * i + 1) / 3000 - 1; r = sqrt(1 - z * z)
    print r * cos(2.4 * i), r * sin(2.4 * i), z } print "300 0 0\n0 300 0\n-300 0 0" }' >points.xyz
  run --separate-stderr tm-wrap --keep-outliers points.xyz -o wrap.ply --report r.json
  assert_status 0
  [[ $stderr == *"the wrap has 4 components"* ]]
  jq -e '.result.components == 4' r.json
  run --separate-stderr tm-wrap --keep-outliers --offset 1 points.xyz -o wrap.ply
  [[ $stderr == *"the wrap of 3003 points has only "*" faces"* ]]
  run --separate-stderr tm-wrap points.xyz -o wrap.ply
  one_line "$stderr"
  [[ $stderr == *"3 outliers left out"* ]]
}
