# The rows of BY HAND in tm-repair(1), on generated shapes, and the pipeline of these rows on damaged real
# meshes.
load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# repaired MESSAGE FILE: checks that the file has that problem, and that the pipeline makes a solid of it.
repaired() {
  needs_shared "meshes/$2"
  run tm-checkmanifold --closed --intersections "$shared_file"
  assert_status 1
  [[ $output == *"$1"* ]] || fail "$output"
  tm-stitch -q --orient "$shared_file" | tm-fill -q --allow-crossings |
    tm-clean -q --outermost -o solid.ply
  tm-checkmanifold --closed --intersections solid.ply
}

# has_volume REFERENCE: checks that the solid has the volume of the reference within 1 %.
has_volume() {
  awk -v is="$(tm-info --get volume solid.ply)" -v is_to_be="$1" \
    'BEGIN { exit !(is > 0.99 * is_to_be && is < 1.01 * is_to_be) }' || fail "volume, not $1"
}

# row MESSAGE FILTER: checks that the page has a row with this message and filter.
row() {
  grep -F "$1" "$tm_root/man/tm-repair.1.md" | grep -qF "**${2/--/\\--}** |" || fail "no row: $1 | $2"
}

# is_solid FILE VOLUME: checks that the mesh is closed, oriented, free of self-intersections, and has that
# volume.
is_solid() {
  tm-checkmanifold --closed --intersections "$1" || fail "$1 is no solid"
  awk -v is="$(tm-info --get volume "$1")" -v is_to_be="$2" \
    'BEGIN { exit !(is > 0.9999 * is_to_be && is < 1.0001 * is_to_be) }' || fail "volume, not $2"
}

# refused MESSAGE FILE: checks that tm-clean refuses the file with that message, and writes nothing.
refused() {
  run --separate-stderr tm-clean "$2" -o refused.ply
  assert_status 4
  one_line "$stderr"
  [[ $stderr == *"$1"* ]] || fail "$stderr"
  [ ! -e refused.ply ]
}

@test "row --one-side: faces with their reverses, on vertices of their own or the same, and as a soup" {
  row "faces coincide with a face of opposite orientation, as in double-sided models" "tm-stitch --one-side"
  tm-shape box 1 1 3 --faces 1000 -o box.ply
  tm-stitch --flip box.ply | tm-cat box.ply - -o apart.ply
  tm-convert -o soup.stl apart.ply
  # Every face is followed by its reverse, on the same vertices.
  tm-convert --no-provenance --format off box.ply | grep -v '^#' | awk '
    NR == 2 { vertices = $1; print $1, 2 * $2, 0; next }
    { print }
    NR > 2 + vertices { print $1, $4, $3, $2 }' >same.off
  for file in apart.ply same.off soup.stl; do
    refused "the faces enclose nothing" <(tm-stitch -q "$file")
    tm-stitch -q --one-side "$file" | tm-clean -o solid.ply
    is_solid solid.ply 3
  done
}

@test "row --one-side: double-sided bodies that cross become one" {
  tm-shape box 1 1 3 --faces 500 -o box.ply
  tm-transform --rotate 0,1,0,90 box.ply | tm-cat box.ply - -o cross.ply
  tm-stitch --flip cross.ply | tm-cat cross.ply - -o sides.ply
  refused "in double-sided models" sides.ply
  tm-stitch --one-side sides.ply | tm-clean -o solid.ply
  is_solid solid.ply 5
}

@test "row --flip: a mesh that is inside out, and a soup of one" {
  row "the mesh is inside out" "tm-stitch --flip"
  tm-shape box 1 1 3 --faces 1000 | tm-transform --scale-axes 1,1,2 -o box.ply
  tm-stitch --flip box.ply -o inverted.ply
  tm-convert -o inverted.stl inverted.ply
  refused "if the mesh is inside out, reverse it with tm-stitch --flip" inverted.ply
  tm-stitch --flip inverted.ply | tm-clean -o solid.ply
  is_solid solid.ply 6
  tm-stitch -q --flip inverted.stl | tm-clean -o solid.ply
  is_solid solid.ply 6
}

@test "an empty difference is reported, not only if B minus A were not empty" {
  tm-shape box 1 1 1 --faces 300 -o small.ply
  tm-shape box 3 3 3 --faces 300 | tm-stitch --flip -o large.ply
  tm-cat small.ply large.ply -o none.ply
  refused "the difference of its parts is empty" none.ply
  tm-stitch --flip small.ply | tm-cat small.ply - -o itself.ply
  refused "an empty difference, and in double-sided models" itself.ply
  # The second mesh is the same body with another triangulation.
  tm-shape box 1 1 1 --faces 12 | tm-stitch --flip | tm-cat small.ply - -o other.ply
  refused "as in an empty difference" other.ply
}

@test "a sheet that is filled flat: one side stays open, and tm-wrap encloses it" {
  row "faces coincide with a face of opposite orientation, as in sheets" "tm-stitch --one-side"
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >one.off
  printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' >two.off
  for file in one.off two.off; do
    tm-fill -q --allow-crossings "$file" -o filled.off
    refused "with tm-sample and tm-wrap --method alpha" filled.off
    tm-sample -q --count 5000 filled.off | tm-wrap -q --method alpha -o body.ply
    tm-checkmanifold --closed --intersections body.ply
  done
  tm-fill -q --allow-crossings one.off -o filled.off
  refused "keep one side of a double-sided sheet, open, with tm-stitch --one-side" filled.off
  tm-stitch -q --one-side filled.off | tm-clean -o sheet.off
  [ "$(tm-info --get boundary_loops sheet.off)" -eq 1 ]
}

@test "bodies inside out beside others: lost as cavities, turned by --one-side" {
  tm-shape box 1 1 3 --faces 500 -o box.ply
  tm-transform --translate 5,0,0 box.ply | tm-stitch --flip | tm-cat box.ply - -o both.ply
  tm-clean -o one.ply both.ply
  is_solid one.ply 3
  for option in --one-side --outwards; do
    tm-stitch "$option" both.ply | tm-clean -o two.ply
    is_solid two.ply 6
  done
}

# cracked FILE WIDTH: prints the triangles with every corner moved by up to WIDTH/2 in each direction.
cracked() {
  tm-convert -q --no-provenance --double --format stl "$1" | tm-convert -q --no-provenance --double --format off |
    awk -v width="$2" 'BEGIN { srand(1) }
      NR > 2 && NF == 3 { print $1 + width * (rand() - 0.5), $2 + width * (rand() - 0.5), $3 + width * (rand() - 0.5); next }
      { print }'
}

@test "row --tolerance: cracks are joined by a tolerance, which the page warns of" {
  grep -qF '| has only one face, along cracks: borders nearly meet | **tm-stitch \--tolerance** *LENGTH*, larger' \
    "$tm_root/man/tm-repair.1.md"
  tm-shape box 1 1 3 --faces 500 -o box.ply
  cracked box.ply 2e-6 >cracked.off
  tm-stitch -q cracked.off -o equal.ply
  run tm-checkmanifold --closed equal.ply
  assert_status 1
  [[ $output == *"has only one face"* ]]
  tm-stitch -q --tolerance 1e-5 cracked.off -o joined.ply
  tm-checkmanifold --closed joined.ply
  tm-clean -q joined.ply -o solid.ply
  is_solid solid.ply 3
  # A tolerance that is larger than the edges makes faces collapse.
  tm-stitch -q --tolerance 0.5 cracked.off -o lost.ply --report r.json
  jq -e '.result.dropped_faces > 0' r.json
}

@test "an open figure of overlapping parts: pig" {
  repaired "only one face" cgal/pig.stl
}

@test "holes with intersecting patches: elephant-with-holes, against the elephant" {
  repaired "only one face" cgal/elephant-with-holes.off
  needs_shared meshes/cgal/elephant.off
  has_volume "$(tm-info --get volume "$shared_file")"
}

@test "a hole and many self-intersections: mannequin-devil" {
  repaired "only one face" cgal/mannequin-devil.off
}

@test "inconsistently oriented faces: blobby-shuffled, against blobby" {
  repaired "in the same direction" cgal/blobby-shuffled.off
  needs_shared meshes/cgal/blobby.off
  has_volume "$(tm-info --get volume "$shared_file")"
}

@test "a soup, inside out: multibody" {
  repaired "only one face" trimesh/multibody.stl
}

@test "intersecting parts: rabbit" {
  repaired "" trimesh/rabbit.obj
}

@test "cubes become solids of volume 2" {
  repaired "" cgal/cubes.off
  has_volume 2
}

@test "a knot that intersects itself: knot-1000" {
  repaired "" transformesh/knot-1000.off
}
