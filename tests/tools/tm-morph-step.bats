load ../helpers/common

setup() { cd "$BATS_TEST_TMPDIR"; }

# value KEY FILE: prints a value of a report's results.
value() {
  awk -v key="\"$1\":" '/"result"/ { inside = 1 }
    inside && $1 == key { gsub("[\",]", "", $2); print $2; exit }' "$2"
}

# close_to A B SHARE
close_to() {
  awk -v a="$1" -v b="$2" -v share="$3" 'BEGIN { d = a - b; exit !(d * d <= share * share * b * b) }' ||
    fail "$1 is not $2"
}

spheres() {
  tm-shape sphere --radius 1 --faces 2000 -o one.ply
  tm-shape sphere --radius 1.25 --faces 2000 -o large.ply
}

@test "between concentric spheres the distance is the difference of the radii, both ways" {
  spheres
  tm-morph-step --target one.ply --report r.json large.ply -o moved.ply
  for key in rms_distance_to_target max_distance_to_target rms_distance_from_target; do
    close_to "$(value $key r.json)" 0.25 0.02
  done
  [ "$(value distance r.json)" = surface ]
  [ "$(value moved r.json)" = "$(tm-info --get vertices large.ply)" ]
  # The movement is one clamp inwards: a fifth of the edge.
  close_to "$(value max_displacement r.json)" \
    "$(awk -v e="$(value mean_edge r.json)" 'BEGIN { print 0.2 * e }')" 0.2
  awk -v a="$(tm-info --get volume moved.ply)" -v b="$(tm-info --get volume large.ply)" \
    'BEGIN { exit !(a < b) }'
}

@test "a mesh inside the target grows" {
  spheres
  tm-morph-step --target large.ply one.ply -o moved.ply
  awk -v a="$(tm-info --get volume moved.ply)" -v b="$(tm-info --get volume one.ply)" \
    'BEGIN { exit !(a > b) }'
}

@test "points are a target: text, PLY with normals, and PLY without" {
  spheres
  # On a sphere around the origin, the normal is the position.
  tm-convert --format off --no-provenance one.ply | awk 'NF == 3 && $3 != 0 && NR > 2 { print $0, $0 }' >one.P3D
  tm-morph-step --target one.P3D --report text.json --write-target points.ply large.ply -o a.ply
  tm-morph-step --target points.ply --report ply.json large.ply -o b.ply
  cmp a.ply b.ply
  [ "$(value distance text.json)" = points ]
  close_to "$(value rms_distance_to_target text.json)" 0.25 0.02
  cut -d' ' -f1-3 one.P3D >one.xyz
  run --separate-stderr tm-morph-step --target one.xyz --report bare.json large.ply -o c.ply
  assert_status 0
  [[ $stderr == *estimated* ]]
  close_to "$(value rms_distance_to_target bare.json)" 0.25 0.02
}

@test "the authors' point clouds are read" {
  needs_shared meshes/transformesh/dancer.P3D
  tm-shape sphere --radius 3 --faces 500 -o ball.ply
  tm-morph-step --target "$shared_file" --report r.json ball.ply -o out.ply
  [ "$(value distance r.json)" = points ]
}

@test "targets that make no sense are refused" {
  spheres
  run --separate-stderr tm-morph-step one.ply
  assert_status 2
  [[ $stderr == *--target* ]]
  tm-stitch --flip one.ply -o inside-out.ply
  run --separate-stderr tm-morph-step --target inside-out.ply one.ply
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"inside out"*"tm-stitch --flip"* ]]
  printf '1 2 3 0 0 1\n1 2 3 0 0\n' >bad.P3D
  run --separate-stderr tm-morph-step --target bad.P3D one.ply
  assert_status 3
  [[ $stderr == *"bad.P3D line 2"* ]]
  printf '1 2 3 0 0 1\n' >point.P3D
  run --separate-stderr tm-morph-step --target point.P3D --distance surface one.ply
  assert_status 2
  run --separate-stderr tm-morph-step --target absent.ply one.ply
  assert_status 3
}

@test "a target that cannot be read is reported with file and reason" {
  tm-shape sphere --faces 100 -o source.ply
  printf 'some words\n' >words.txt
  printf '1 2 3 0.5\n' >four.xyz
  printf '1,2,3\n' >commas.csv
  printf '1 2 3\n4 5 x\n' >late.xyz
  head -c 300 source.ply >cut.ply
  while IFS='|' read -r file reason; do
    for program in tm-morph-step tm-morph; do
      run --separate-stderr "$program" --target "$file" source.ply -o out.ply
      assert_status 3
      one_line "$stderr"
      [[ $stderr == *"$file"* && $stderr == *"$reason"* ]] || fail "$stderr"
    done
  done <<'TABLE'
none.ply|cannot be read: No such file or directory
words.txt|PCD and points as text are read (words.txt)
four.xyz|this line has 4: take the first three, by awk
commas.csv|replace the commas
late.xyz|z of point 1 is not a number: 'x' (late.xyz line 2)
cut.ply|the file is cut off or its header is wrong (cut.ply byte
TABLE
}
