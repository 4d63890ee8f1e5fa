load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tm-shape two-spheres --gap -0.3 --faces 2000 --format ply-ascii | awk '
    /^element vertex/ { n = $3 }
    /^element face/ { print "property double height" }
    body && n-- > 0 { print $0, $1 + 2 * $2 - $3; next }
    /^end_header/ { body = 1 }
    { print }' >a.ply
}

# vertices FILE: prints x, y, z and the properties of each vertex, a line per vertex
vertices() {
  tm-convert --format ply-ascii "$1" | awk '/^element vertex/ { n = $3 }
    body && n-- > 0 { print }
    /^end_header/ { body = 1 }'
}

# off_by FILE FACTOR: prints the largest and the mean difference between height and its function of the
# positions divided by FACTOR
off_by() {
  vertices "$1" | awk -v factor="$2" '
    { off = ($1 + 2 * $2 - $3) / factor - $4; if (off < 0) off = -off; if (off > most) most = off; sum += off }
    END { print most, sum / NR }'
}

@test "tm-carry: a function of position through clean, a motion and remesh" {
  tm-clean --source a.ply >b.ply
  vertices b.ply | awk '{ if (NF != 7) exit 1 }'
  tm-convert --format ply-ascii b.ply | awk '
    /^element vertex/ { n = $3 }
    body && n-- > 0 { $1 *= 2; $2 *= 2; $3 *= 2 }
    /^end_header/ { body = 1 }
    { print }' >moved.ply
  tm-remesh --source moved.ply >c.ply
  tm-carry --from a.ply moved.ply c.ply >d.ply
  # Remeshing cuts off the crease where the balls meet.
  off_by d.ply 2 | awk '{ exit !($1 < 0.06 && $2 < 0.002) }'
  # The source points of d.ply are already on the first mesh.
  tm-carry --from a.ply d.ply >again.ply
  cmp <(vertices d.ply) <(vertices again.ply)
}

@test "tm-carry: the loop of an evolution needs only its last mesh" {
  tm-remesh --iterations 0 --source a.ply >now.ply
  for _ in 1 2; do
    tm-displace --normal-speed 0.1x now.ply | tm-clean --source >cleaned.ply
    tm-remesh --source cleaned.ply | tm-carry --from a.ply now.ply cleaned.ply - >next.ply
    mv next.ply now.ply
  done
  # The two steps move vertices by a fifth of an edge in total. Height changes by up to 2.45 times as much,
  # which is .08.
  off_by now.ply 1 | awk '{ exit !($1 > 0.02 && $1 < 0.08) }'
}

@test "tm-carry: textures of faces survive, and normals are not carried" {
  tm-clean a.ply | tm-convert --format ply-ascii | awk '
    /^element vertex/ { n = $3 }
    /^end_header/ { print "property list uchar float texcoord"; body = 1; print; next }
    body && n-- > 0 { x[k + 0] = $1; y[k++ + 0] = $2; print; next }
    body && $1 == 3 { print $0, 6, x[$2], y[$2], x[$3], y[$3], x[$4], y[$4]; next }
    { print }' >textured.ply
  run --separate-stderr tm-remesh --source -o remeshed.ply textured.ply
  [[ $stderr == *"'texcoord' dropped"* ]]
  tm-carry --from textured.ply remeshed.ply --format ply-ascii | awk '
    /^element vertex/ { n = $3 }
    /^end_header/ { body = 1; next }
    body && n-- > 0 { x[k + 0] = $1; y[k++ + 0] = $2; next }
    body && NF == 14 { for (i = 0; i < 3; ++i) {
      dx = x[$(2 + i)] - $(9 + 2 * i); dy = y[$(2 + i)] - $(10 + 2 * i)
      if (dx * dx + dy * dy > 0.001) bad = 1 }
      ++faces }
    END { exit bad || faces < 1000 }'
}

@test "tm-carry: --columns chooses, --closest needs no places" {
  tm-remesh a.ply >b.ply
  run --separate-stderr tm-carry --from a.ply b.ply
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"--source"*"--closest"* ]]
  tm-carry --from a.ply --closest --columns height b.ply >c.ply
  off_by c.ply 1 | awk '{ exit !($1 < 0.02) }'
  run --separate-stderr tm-carry --from a.ply --closest --columns hight b.ply
  assert_status 3
  one_line "$stderr"
}

@test "tm-carry: source points on another mesh are reported" {
  tm-remesh --source a.ply >b.ply
  tm-shape sphere --faces 100 -o other.ply
  run --separate-stderr tm-carry --from other.ply b.ply
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"other.ply"* ]]
}

@test "without --source, untouched faces keep their source points" {
  tm-shape sphere --faces 500 | tm-clean --source >clean.ply
  tm-clean --no-provenance clean.ply | cmp - clean.ply
  run --separate-stderr tm-remesh -o remeshed.ply clean.ply
  [[ $stderr == *"source_face"*"dropped"* ]]
  run -1 grep -a source_face remeshed.ply
}

# faces FILE: prints the properties of each face, a line per face
faces() {
  tm-convert --format ply-ascii "$1" | awk '/^element vertex/ { n = $3 }
    body && n-- <= 0 { print }
    /^end_header/ { body = 1 }'
}

@test "tm-carry: faces have the properties of the face that they are cut from, though bodies touch" {
  # Two rotated boxes with a common plane; side is a number for each face.
  tm-shape box 1 1 1 --faces 12 -o one.ply
  tm-shape box 1 0.5 1 --faces 12 --center 0.3,0,0 -o two.ply
  tm-cat one.ply two.ply | tm-transform --rotate 1,2,3,17 --format ply-ascii | awk '
    /^element vertex/ { n = $3 }
    /^end_header/ { print "property int side"; body = 1; print; next }
    body && n-- > 0 { print; next }
    body { print $0, ++k; next }
    { print }' >boxes.ply
  tm-clean --source boxes.ply >clean.ply
  tm-carry --from boxes.ply clean.ply >carried.ply
  # Cleaning itself carries numbers from faces to pieces.
  cmp <(faces clean.ply | cut -d " " -f 1-5) <(faces carried.ply | cut -d " " -f 1-5)
  [ "$(faces carried.ply | cut -d " " -f 5 | sort -u | wc -l)" -gt 12 ]
}

@test "tm-carry: faces without a source are reported, and get no face" {
  tm-shape sphere --faces 500 -o ball.ply
  tm-remesh -q --source ball.ply | tm-select --box -2,-2,-2,2,2,0.8 -o open.ply
  run --separate-stderr tm-fill -o filled.ply open.ply
  [[ $stderr == *"source_face, source_u and source_v dropped"*"tm-carry --closest"* ]]
  run --separate-stderr tm-carry --from ball.ply filled.ply
  assert_status 3
  tm-carry --from ball.ply --closest filled.ply >carried.ply
  # Face numbers alone are not source points.
  tm-clean -q --source ball.ply | tm-clean -q --source-face >numbered.ply
  run --separate-stderr tm-carry --from ball.ply numbered.ply
  assert_status 3
}
