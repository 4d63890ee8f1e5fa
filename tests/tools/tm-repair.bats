# tm-repair: damaged solids become the original solids, which tm-checkmanifold checks.
load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 1 1 3 --faces 500 -o box.ply
}

# is_solid FILE VOLUME: checks that the mesh is closed, oriented, free of self-intersections, and has that
# volume.
is_solid() {
  tm-checkmanifold -q --closed --intersections "$1" >verdict || fail "$1 is no solid: $(cat verdict)"
  awk -v is="$(tm-info --get volume "$1")" -v is_to_be="$2" \
    'BEGIN { exit !(is > 0.999 * is_to_be && is < 1.001 * is_to_be) }' || fail "volume, not $2"
}

# repairs FILE VOLUME: checks that the mesh becomes that solid, by tm-repair and by the pipeline that it
# prints.
repairs() {
  tm-repair -q --no-provenance "$1" >repaired || fail "$1 is refused"
  tm-repair -q --no-provenance --print-pipeline "$1" >pipeline
  bash -o pipefail pipeline 2>/dev/null | cmp - repaired || fail "$(cat pipeline) gives another mesh"
  is_solid repaired "$2"
}

# Filters the faces of box.ply, as lines of OFF, through an awk program; the vertices stay.
edited() {
  tm-convert -q --no-provenance --double --format off box.ply | grep -v '^#' |
    awk "BEGIN { srand(1) } NR == 2 { vertices = \$1; faces = \$2 } NR <= 2 + vertices { print; next } $1" >lines
  # Corrects the counts.
  awk 'FNR == NR { if (FNR > 2 && NF == 4) ++faces; next } FNR == 2 { $2 = faces } { print }' lines lines
}

# cracked WIDTH: prints the triangles of box.ply, with every corner moved by up to WIDTH / 2 in each
# direction.
cracked() {
  tm-convert -q --no-provenance --double --format stl box.ply |
    tm-convert -q --no-provenance --double --format off |
    awk -v width="$1" 'BEGIN { srand(1) }
      NR > 2 && NF == 3 { print $1 + width * (rand() - 0.5), $2 + width * (rand() - 0.5), $3 + width * (rand() - 0.5); next }
      { print }'
}

@test "a damaged solid becomes the solid, and the pipeline that is printed gives the same bytes" {
  tm-convert -q --format stl box.ply >soup.stl
  edited '{ if (rand() < 0.3) print $1, $3, $2, $4; else print }' >reversed.off
  edited '{ print } rand() < 0.2 { print $1, $3, $4, $2 }' >copies.off
  edited '{ print; print $1, $4, $3, $2 }' >sides.off
  edited 'NR > 4 + vertices { print }' >hole.off
  edited '{ print; if (NR == 9 + vertices) print $1, $2, $2, $3 }' >collapsed.off
  tm-stitch --flip box.ply -o inside-out.ply
  for file in soup.stl reversed.off copies.off sides.off hole.off collapsed.off inside-out.ply; do
    repairs "$file" 3
  done
  tm-transform --translate 0.3,0.4,0.5 box.ply | tm-cat box.ply - -o overlap.ply
  repairs overlap.ply "$(tm-clean -q overlap.ply | tm-info --get volume)"
  tm-transform --translate 5,0,0 inside-out.ply | tm-cat box.ply - -o beside.ply
  repairs beside.ply 6
}

@test "cracks and T-junctions are measured, not filled" {
  for width in 1e-9 2e-6 1e-4; do
    cracked "$width" >cracked.off
    repairs cracked.off 3
    [ "$(tm-info --get genus repaired)" -eq 0 ]
    ! grep -q tm-fill pipeline
    tm-repair -q --dry-run --report r.json cracked.off
    jq -e --argjson width "$width" '.result.crack_width > 0.1 * $width and .result.crack_width < 3 * $width' r.json
  done
  # One face in five is split in two, but its neighbors are not.
  tm-convert -q --no-provenance --double --format off box.ply | grep -v '^#' | awk 'BEGIN { srand(2) }
    NR == 2 { count = vertices = $1; next }
    NR > 2 && NR <= 2 + count { x[NR - 3] = $1; y[NR - 3] = $2; z[NR - 3] = $3; next }
    NR > 2 && rand() < 0.2 {
      x[vertices] = (x[$2] + x[$3]) / 2; y[vertices] = (y[$2] + y[$3]) / 2; z[vertices] = (z[$2] + z[$3]) / 2
      face[faces++] = "3 " $2 " " vertices " " $4; face[faces++] = "3 " vertices++ " " $3 " " $4; next
    }
    NR > 2 { face[faces++] = $0 }
    END {
      print "OFF\n" vertices, faces, 0
      for (i = 0; i < vertices; ++i) printf "%.17g %.17g %.17g\n", x[i], y[i], z[i]
      for (i = 0; i < faces; ++i) print face[i]
    }' >junctions.off
  repairs junctions.off 3
  ! grep -q tm-fill pipeline
}

@test "the two sides of a thin plate without a rim are no crack" {
  printf 'OFF\n8 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1e-4\n1 0 1e-4\n1 1 1e-4\n0 1 1e-4\n' >plate.off
  printf '3 %s\n' "0 2 1" "0 3 2" "4 5 6" "4 6 7" >>plate.off
  tm-repair -q --dry-run --report r.json plate.off || true
  tm-repair -q --print-pipeline plate.off >pipeline || true
  ! grep -q tolerance pipeline
}

@test "a cavity stays a cavity, inside out, in faces of all directions, and with two sides" {
  tm-shape sphere --radius 0.3 --faces 300 | tm-stitch --flip | tm-cat box.ply - -o hollow.ply
  volume=$(tm-info --get volume hollow.ply)
  tm-repair --no-provenance hollow.ply | cmp - hollow.ply
  tm-stitch --flip hollow.ply -o turned.ply
  repairs turned.ply "$volume"
  tm-cat hollow.ply turned.ply -o sides.ply
  repairs sides.ply "$volume"
  cp hollow.ply box.ply
  edited '{ if (rand() < 0.3) print $1, $3, $2, $4; else print }' >reversed.off
  repairs reversed.off "$volume"
  edited 'NR > 4 + vertices { print }' >hole.off
  repairs hole.off "$volume"
}

@test "a cavity stays a cavity if its vertices are in line with edges of the body" {
  tm-shape box 4 4 4 --edge 2 -o outer.ply
  tm-shape box 2 2 2 --edge 2 | tm-stitch --flip | tm-cat outer.ply - | tm-convert --format stl -o soup.stl
  repairs soup.stl 56
}

@test "a body inside a body is removed, also from a mesh that is closed and does not intersect" {
  tm-shape sphere --radius 0.3 --faces 300 | tm-cat box.ply - -o double.ply
  repairs double.ply 3
}

@test "a solid passes byte for byte, in any format" {
  for format in ply ply-ascii ply-be off obj stl; do
    tm-convert -q --no-provenance --float --format "$format" box.ply >"solid.$format"
    tm-repair -q "solid.$format" -o "out.${format%%-*}" --format "$format"
    cmp "solid.$format" "out.${format%%-*}"
    [ "$(tm-repair -q --print-pipeline --format "$format" "solid.$format")" = "cat solid.$format" ]
  done
  # Numbers with a notation that the suite would not use.
  sed 's/^0 /0.000e0 /' solid.off >other.off
  tm-repair other.off | cmp - other.off
}

@test "a sheet without thickness is no solid, and stays open as the message says" {
  printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' >sheet.off
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >face.off
  for name in sheet face; do
    run --separate-stderr tm-repair "$name.off"
    assert_status 4
    [[ $stderr == *"open with --keep-open; or wrap it with tm-sample and tm-wrap --method alpha" ]]
    tm-repair --keep-open "$name.off" -o "$name.ply"
    [ "$(tm-info --get faces "$name.ply")" = "$(tm-info --get faces "$name.off")" ]
  done
}

@test "--keep-open leaves holes and mends the rest" {
  edited 'NR > 4 + vertices { if (rand() < 0.3) print $1, $3, $2, $4; else print }' >hole.off
  tm-repair -q --keep-open hole.off -o open.ply
  tm-checkmanifold --intersections open.ply
  [ "$(tm-info --get boundary_loops open.ply)" -eq 1 ]
}

@test "--max-change refuses what is farther away, and writes nothing" {
  tm-shape sphere --faces 1000 -o ball.ply
  tm-select --box -2,-2,-2,2,2,0.2 ball.ply -o bowl.ply
  tm-repair -q --max-change 2 bowl.ply -o solid.ply
  run --separate-stderr tm-repair -q --max-change 0.2 bowl.ply -o refused.ply
  assert_status 4
  one_line "$stderr"
  [[ $stderr == *"away from the input at ("*"more than the change that is allowed" ]]
  [ ! -e refused.ply ]
}

@test "--dry-run writes no mesh, and reports the steps" {
  tm-convert -q --format stl box.ply >soup.stl
  tm-repair --dry-run --report r.json soup.stl >out 2>log
  [ ! -s out ]
  grep -q 'tm-stitch --orient --drop-copies --outwards: .* joined with others' log
  jq -e '.result.steps == 1 and .result.step_1_count > 0' r.json
}

@test "a step that removes volume is named, with the share" {
  tm-shape box 2 2 2 -o box.ply
  # Four fifths of the second box are within the first.
  tm-transform --translate 0.4,0,0 box.ply | tm-cat box.ply - -o both.ply
  run --separate-stderr tm-repair both.ply -o repaired.ply
  [ "$status" -eq 0 ]
  [[ $stderr == *"tm-clean removes 40 % of the volume, in which overlaps counted once for each part, around ("* ]] || fail "$stderr"
  is_solid repaired.ply 9.6
  run --separate-stderr tm-repair box.ply -o repaired.ply
  [ -z "$stderr" ]
}

@test "closing a body that is inside out is no loss of volume" {
  tm-shape box 2 2 2 --faces 12 -o box.ply
  tm-transform --translate 9,0,0 box.ply | tm-select --invert --box 7,-2,0.9,11,2,2 | tm-stitch --flip |
    tm-cat box.ply - -o both.ply
  run --separate-stderr tm-repair both.ply -o repaired.ply
  assert_status 0
  [[ $stderr == *"tm-fill"*"volume -8"* && $stderr != *"removes"* ]] || fail "$stderr"
  is_solid repaired.ply 16
}

@test "bodies stay apart that lack faces at the edge along which they touch" {
  # The boxes touch along the edge from vertex 6 to 7; one of two faces of each box is missing there.
  cat >touching.off <<'END'
OFF
14 22 0
0 0 0
2 0 0
0 2 0
0 0 1
2 0 1
0 2 1
2 2 0
2 2 1
4 2 0
2 4 0
4 4 0
4 2 1
2 4 1
4 4 1
3 0 2 6
3 0 6 1
3 3 4 7
3 3 7 5
3 0 1 4
3 0 4 3
3 0 3 5
3 0 5 2
3 1 6 7
3 1 7 4
3 2 5 7
3 6 9 10
3 6 10 8
3 7 11 13
3 7 13 12
3 6 8 11
3 6 11 7
3 6 12 9
3 9 12 13
3 9 13 10
3 8 10 13
3 8 13 11
END
  tm-fill --report report.json touching.off 2>note >filled.ply
  jq -e '.result.cut_edges == 1 and .result.filled == 2' report.json
  [[ $(cat note) == "tm-fill: 1 edge cut where bodies touch, so that each gets a patch" ]] || fail "$(cat note)"
  run --separate-stderr tm-repair touching.off -o repaired.ply
  assert_status 0
  [[ $stderr == *"1 edge cut where bodies touch"* ]] || fail "$stderr"
  is_solid repaired.ply 8
  [ "$(tm-info --get components repaired.ply)" = 2 ]
}

@test "--picture shows what was lost and what is new" {
  tm-shape sphere --faces 2000 -o ball.ply
  tm-select --box -2,-2,-2,2,2,0.7 ball.ply -o bowl.ply
  tm-repair -q bowl.ply --picture change.png -o solid.ply
  [ "$(head -c 24 change.png | od -An -tu1 | tr -s ' \n' ' ')" = " 137 80 78 71 13 10 26 10 0 0 0 13 73 72 68 82 0 0 6 64 0 0 4 176 " ]
  tm-repair -q --dry-run --picture again.png bowl.ply
  cmp change.png again.png
  run --separate-stderr tm-repair -q bowl.ply --picture /nowhere/change.png -o other.ply
  [ "$status" -eq 5 ]
  [ ! -e other.ply ]
}

@test "a dropped sheet beside a body is reported with the place" {
  printf 'OFF\n4 2 0\n5 5 5\n9 5 5\n9 9 5\n5 9 5\n3 0 1 2\n3 0 2 3\n' | tm-cat box.ply - -o sheet.ply
  run --separate-stderr tm-repair sheet.ply -o solid.ply
  assert_status 0
  [[ $stderr == *"tm-clean drops 70 % of the area, most of it around ("[59]", "[59]", 5)"* ]] || fail "$stderr"
  is_solid solid.ply 3
}

@test "a sheet alone is refused: exit code 4, one sentence, nothing written" {
  printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' >sheet.off
  run --separate-stderr tm-repair -q sheet.off -o solid.ply
  assert_status 4
  one_line "$stderr"
  [[ $stderr == *"the faces enclose nothing"* ]]
  [ ! -e solid.ply ]
}

@test "a hole that no patch closes is refused, with advice that is true" {
  # A flat triangle of four faces beside a solid: a patch of its border has one of its edges, or a face
  # without area.
  printf '%s\n' OFF '6 4 0' '9 0 0' '11 0 0' '9 2 0' '10 0 0' '10 1 0' '9 1 0' \
    '3 0 3 5' '3 1 4 3' '3 2 5 4' '3 3 4 5' >sheet.off
  tm-cat -q box.ply sheet.off -o in.ply
  run --separate-stderr tm-repair in.ply -o out.ply
  assert_status 4
  [ ! -e out.ply ]
  [[ $stderr == *"has only one face"*"no patch closes these holes: leave them open with --keep-open" ]]
  tm-repair -q --keep-open in.ply -o out.ply
  [ "$(tm-info -q --get components out.ply)" -eq 2 ]
}

@test "shards are dropped and counted" {
  tm-shape sphere --radius 1e-4 --center 4,0,0 --faces 100 | tm-cat box.ply - -o shard.ply
  # A solid with a small component is a solid.
  tm-repair shard.ply | cmp - shard.ply
  tm-transform --translate 0.3,0.4,0.5 box.ply | tm-cat shard.ply - -o crossing.ply
  run --separate-stderr tm-repair crossing.ply -o solid.ply
  assert_status 0
  [[ $stderr == *"1 component dropped as small components"* ]] || fail "$stderr"
}

@test "vertices that are not numbers are dropped with their faces, and the hole is closed" {
  edited '{ print }' | awk 'NR == 40 { print "nan 0 0"; next } { print }' >nan.off
  run --separate-stderr tm-repair nan.off -o solid.ply
  assert_status 0
  [[ $stderr == *"not finite"* ]] || fail "$stderr"
  tm-checkmanifold --closed --intersections solid.ply
}

@test "broken real meshes become solids by the pipeline that is printed" {
  for name in cgal/elephant-with-holes.off trimesh/featuretype.STL transformesh/knot-1000.off; do
    needs_shared "meshes/$name"
    tm-repair -q --no-provenance "$shared_file" >repaired
    tm-checkmanifold --closed --intersections repaired
    tm-repair -q --no-provenance --print-pipeline "$shared_file" >pipeline
    bash -o pipefail pipeline 2>/dev/null | cmp - repaired
  done
}

@test "all kinds of damage: at least nine in ten are right" {
  "$tm_build/bin-test/repair_grid" --seeds 1 >table || fail "$(cat table)"
}

@test "two copies of a soup with rounded coordinates become one solid" {
  # Each corner of each face has its own rounding error.
  tm-shape torus --faces 600 --format off --no-provenance | awk '
    NR <= 2 { if (NR == 2) { n = $1; f = $2 } next }
    NR <= n + 2 { x[NR - 3] = $1; y[NR - 3] = $2; z[NR - 3] = $3; next }
    { face[m++] = $2 " " $3 " " $4 }
    END {
      print "OFF"; print 6 * f, 2 * f, 0
      for (i = 0; i < 2 * m; ++i) {
        split(face[i % m], v, " ")
        for (k = 1; k <= 3; ++k) {
          e = ((3 * i + k) * 7919 % 1000) * 1e-9
          printf "%.12f %.12f %.12f\n", x[v[k]] + e, y[v[k]] - e, z[v[k]] + e
        }
      }
      for (i = 0; i < 2 * m; ++i) print 3, 3 * i, 3 * i + 1 + (i % 3 == 0), 3 * i + 2 - (i % 3 == 0)
    }' >twice.off
  tm-repair twice.off -o solid.off
  tm-checkmanifold --closed --intersections solid.off
  [ "$(tm-info --get genus solid.off)" -eq 1 ]
  tm-info --get volume solid.off | awk '{ exit !($1 > 1.886 && $1 < 1.89) }'
}
