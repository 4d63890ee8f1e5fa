load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 1 1 1 --faces 3000 -o small.ply
  tm-shape box 3 3 3 --faces 500 | tm-transform --translate 9,0,0 | tm-cat small.ply - -o two.ply
}

@test "the largest component by faces or volume, and what is not" {
  tm-select --largest 1 two.ply -o faces.ply
  [ "$(tm-info --get faces faces.ply)" = "$(tm-info --get faces small.ply)" ]
  tm-info --get volume <(tm-select --largest 1 --by volume two.ply) | awk '{ exit !($1 > 26.99 && $1 < 27.01) }'
  tm-info --get volume <(tm-select --largest 1 --by volume --invert two.ply) |
    awk '{ exit !($1 > 0.99 && $1 < 1.01) }'
  [ "$(tm-info --get components <(tm-select --at-least 5.9 --by area two.ply))" = 2 ]
}

@test "faces by a property and by a box" {
  [ "$(tm-info --get faces <(tm-select --box -2,-2,-2,2,2,2 two.ply))" = "$(tm-info --get faces small.ply)" ]
  tm-convert --no-provenance --format ply-ascii small.ply >ascii.ply
  awk '/^end_header/ { print "property int label" } { print }
    ' ascii.ply | awk '/^element face/ { n = $3 } /^end_header/ { body = 1 }
    body && $1 == 3 && NF == 4 { print $0, ++i; next } { print }' >labels.ply
  [ "$(tm-info --get faces <(tm-select --where 'label <= 7' labels.ply))" = 7 ]
}

@test "nothing selected is exit 4, a bad condition 2, a missing property 3" {
  run --separate-stderr tm-select --box 5,5,5,6,6,6 two.ply
  assert_status 4
  [[ $stderr == *"none of "*" faces is selected"* ]]
  run --separate-stderr tm-select --where 'x ~ 3' two.ply
  assert_status 2
  run --separate-stderr tm-select --where 'nothing > 3' two.ply
  assert_status 3
}

@test "the component around a point, and the closest where there is none" {
  tm-shape sphere --radius 3 --faces 500 | tm-cat small.ply - >nested.ply
  volume() { tm-info --get volume <(tm-select "$@"); }
  volume --around 0.1,0.2,0.3 nested.ply | awk '{ exit !($1 > 0.99 && $1 < 1.01) }'
  volume --around 0,0,2 nested.ply | awk '{ exit !($1 > 100) }'
  run --separate-stderr tm-select --around 0,0,4 --report r.json nested.ply -o far.ply
  assert_status 0
  one_line "$stderr"
  [[ $stderr == *"no component contains the point: the closest is taken, 1"* ]]
  jq -e '.result | .contains_point == false and .distance > 0.9 and .distance < 1.1' r.json
  tm-info --get volume far.ply | awk '{ exit !($1 > 100) }'
}

@test "--split writes a file for each component, the largest first, and nothing else" {
  tm-select --no-provenance --split faces two.ply >stdout
  [ ! -s stdout ]
  tm-select --largest 1 --no-provenance two.ply | cmp - faces-001.ply
  tm-select --largest 1 --invert --no-provenance two.ply | cmp - faces-002.ply
  tm-select --split volume --by volume --invert --box 99,99,99,100,100,100 two.ply
  tm-info --get volume volume-001.ply | awk '{ exit !($1 > 26.99 && $1 < 27.01) }'
  [ "$(echo faces-* volume-*)" = "faces-001.ply faces-002.ply volume-001.ply volume-002.ply" ]
  # tm-info prints the same for two files together as for the mesh that was divided into them.
  tm-cat faces-001.ply faces-002.ply | tm-info --json >parts
  cmp parts <(tm-info --json two.ply)
}

@test "--split takes formats, and writes the whole where -o says so" {
  tm-select --split part --format off --report r.json -o whole.off two.ply
  [ "$(head -c 3 part-002.off)" = OFF ]
  [ "$(tm-info --get faces whole.off)" = "$(tm-info --get faces two.ply)" ]
  jq -e '.result.files == 2' r.json
  tm-select --split part --format obj <two.ply
  [ "$(tm-info --get faces part-001.obj)" = "$(tm-info --get faces small.ply)" ]
  tm-convert --format off two.ply >two.off
  tm-select --split ascii --format ply-ascii --float two.off
  grep -qx 'property float x' ascii-001.ply
  tm-select --split fine two.off
  grep -aqx 'property double x' fine-001.ply
}

@test "--split writes nothing where one file cannot be, and no more than 9999" {
  mkdir part-002.ply
  run --separate-stderr tm-select --split part two.ply
  assert_status 5
  one_line "$stderr"
  [ ! -e part-001.ply ]
  run --separate-stderr tm-select --split none/part two.ply
  assert_status 5
  rmdir part-002.ply
  run --separate-stderr tm-select --split part --report part-001.ply two.ply
  assert_status 2
  [ ! -e part-001.ply ]
  tm-shape sphere --faces 12000 -o soup.stl
  run --separate-stderr tm-select --split soup soup.stl
  assert_status 4
  [[ $stderr == *"9999 are the most: join a soup with tm-stitch"* ]]
  [ "$(find . -name 'soup-*')" = "" ]
}

@test "a capped cut is closed, and its volume is that in front of the plane" {
  # The box is from -0.5 to 0.5. Planes are inside, at a side, and in front of the whole box.
  while read -r plane volume; do
    tm-select --plane "$plane" --cap small.ply -o cut.ply
    tm-checkmanifold --closed --intersections cut.ply >/dev/null
    tm-info --get volume cut.ply | awk -v v="$volume" '{ exit !($1 > v - 1e-9 && $1 < v + 1e-9) }'
  done <<'TABLE'
0,0,1,0.25 0.25
0,0,-1,-0.25 0.75
0,0,2,-1 1
1,0,0,-7 1
1,1,0,0 0.5
1,1,1,0 0.5
1,1,1,0.5 0.1666666667
TABLE
  for plane in 0,0,1,0.5 1,0,0,3; do
    run --separate-stderr tm-select --plane $plane --cap small.ply -o none.ply
    assert_status 4
    one_line "$stderr"
    [[ $stderr == *"nothing of the mesh lies on the side"* ]]
    [ ! -e none.ply ]
  done
}

@test "a plane that touches the mesh or contains a face leaves nothing behind it, and all in front" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 1 1 1 | tm-transform --translate 0.5,0.5,0.5 >unit.ply
  printf 'OFF\n4 4 0\n2 0 0\n0 8 0\n0 0 8\n0 0 0\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n' >steep.off
  printf 'OFF\n4 4 0\n7 0 0\n0 7 0\n0 0 1\n0 0 0\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n' >flat.off
  while read -r name plane back; do
    faces=$(tm-info --get faces $name)
    for cap in '' --cap; do
      run --separate-stderr tm-select $cap --plane=$plane $name -o none.ply
      assert_status 4
      [[ $stderr == *"nothing of the mesh lies on the side"* ]]
      [ ! -e none.ply ]
      run --separate-stderr tm-select $cap --plane=$back $name -o all.ply
      assert_status 0
      [ "$stderr" = "" ]
      [ "$(tm-info --get faces all.ply)" -eq "$faces" ]
    done
  done <<'TABLE'
unit.ply -3,3,3,6 3,-3,-3,-6
steep.off 4,1,1,8 -4,-1,-1,-8
flat.off 1,1,7,7 -1,-1,-7,-7
TABLE
}

@test "both sides of a capped cut are the whole, of a knot, a mesh that intersects itself, and floats" {
  tm-shape torus-knot --faces 6000 -o knot.ply
  tm-shape two-spheres --faces 3000 | tm-convert --float -o balls.ply
  for name in knot balls; do
    tm-select --plane 1,2,3,0.1 --cap $name.ply -o front.ply
    tm-select --plane -1,-2,-3,-0.1 --cap $name.ply -o back.ply
    for side in front back; do tm-checkmanifold --closed --intersections $side.ply >/dev/null; done
    whole=$(tm-clean $name.ply | tm-info --get volume)
    awk -v a="$(tm-info --get volume front.ply)" -v b="$(tm-info --get volume back.ply)" -v w="$whole" \
      'BEGIN { d = a + b - w; exit !(d < 1e-5 && d > -1e-5) }'
  done
}

@test "an open cut leaves a border in the plane, and keeps properties" {
  run --separate-stderr tm-select --plane 0,0,1,0.123 small.ply -o open.ply
  assert_status 0
  [[ $stderr == *"close it with --cap"* ]]
  [ "$(tm-info --get boundary_loops open.ply)" -eq 1 ]
  [[ $(tm-info --get bbox_min open.ply) == *" 0.123" ]]
  tm-info --get area open.ply | awk '{ a = 1 + 4 * 0.377; exit !($1 > a - 1e-9 && $1 < a + 1e-9) }'
  tm-fill --max-edges 1000 open.ply | tm-checkmanifold --closed --intersections
  # A face in the plane bounds the part in front of it.
  tm-select --plane 0,0,1,-0.5 small.ply | tm-checkmanifold --closed
  run --separate-stderr tm-select --plane 0,0,1,0.5 small.ply
  assert_status 4
  run --separate-stderr tm-select --plane 0,0,1,0 --cap open.ply -o none.ply
  assert_status 3
  [[ $stderr == *"close holes with tm-fill"* ]]
}

@test "sections are the outline of a box, as edges and as a drawing" {
  tm-select --plane 0,0,1,0.123 --cap --section edges.ply small.ply -o cut.ply
  tm-convert --format ply-ascii --no-provenance edges.ply >edges.txt
  # The perimeter of the unit square, from the vertices that each edge names.
  awk 'BEGIN { k = 0 } /^element vertex/ { n = $3 } /^element edge/ { m = $3 }
    inside && k < n { x[k] = $1; y[k] = $2; if ($3 != 0.123) exit 1; ++k; next }
    inside && m-- > 0 { sum += sqrt((x[$1] - x[$2]) ^ 2 + (y[$1] - y[$2]) ^ 2) }
    /^end_header/ { inside = 1 }
    END { exit !(sum > 4 - 1e-9 && sum < 4 + 1e-9) }' edges.txt
  tm-select --plane 0,0,1,0.123 --cap --section outline.svg small.ply -o cut.ply
  [ "$(grep -c '<path' outline.svg)" -eq 1 ]
  grep -q ' Z"/>' outline.svg
  python3 -c 'import sys, xml.dom.minidom as d; d.parse(sys.argv[1])' outline.svg
}

@test "options of a cut need its plane, and a plane its normal" {
  for options in '--cap' '--section a.svg' '--plane 0,0,0,1' '--plane 0,0,0,1 --cap' '--plane 1,0,0,0 --invert'; do
    # shellcheck disable=SC2086
    run --separate-stderr tm-select $options small.ply
    assert_status 2
    one_line "$stderr"
  done
}

@test "edges are dropped with a note if vertices are dropped, in the parts too" {
  printf '%s\n' ply 'format ascii 1.0' 'element vertex 4' 'property double x' 'property double y' \
    'property double z' 'element face 1' 'property list uchar int vertex_indices' \
    'element edge 1' 'property int vertex1' 'property int vertex2' end_header \
    '5 5 5' '0 0 0' '1 0 0' '0 1 0' '3 1 2 3' '2 3' >unused.ply
  tm-select --largest 1 --split part unused.ply -o out.ply 2>notes
  [ "$(grep -c "element 'edge' dropped" notes)" -eq 1 ]
  for file in out.ply part-001.ply; do
    grep -aq '^element vertex 3' $file
    ! grep -aq '^element edge' $file || false
  done
  tm-convert --no-provenance unused.ply | cmp - unused.ply
}
