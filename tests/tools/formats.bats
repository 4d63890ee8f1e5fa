#!/usr/bin/env bats
# Formats through tm-convert: every pair of formats, unusual PLY files byte for byte, and the real files of
# $TM_DATA/meshes.

load ../helpers/common

# convert INPUT OUTPUT: converts without the provenance comment, which would differ.
convert() {
  tm-convert -q --no-provenance "$1" -o "$2"
}

# facets FILE: prints the triangles as binary STL without the header, for any format.
facets() {
  convert "$1" "$BATS_TEST_TMPDIR/facets.stl"
  tail -c +81 "$BATS_TEST_TMPDIR/facets.stl" | cksum
}

odd_ply() {
  cat <<'PLY'
ply
format ascii 1.0
comment first
comment tm:reference-edge 0.5
obj_info kept too
element camera 1
property double focal
property list uchar short size
element vertex 4
property ushort code
property float x
property float y
property float z
property char side
property list int double ring
element edge 2
property int vertex1
property int vertex2
element face 4
property short label
property list ushort uint vertex_index
property list uchar float texcoord
property double weight
element note 0
property uint id
end_header
35.5 2 640 -480
65535 0 0 0 -128 2 0.1 -1e-300
1 1 0 0.1 127 0
2 0 1.5 0 0 1 1e+100
3 0 0 1e-20 1 0
0 1
2 3
-1 3 0 2 1 2 0.25 0.1 0.3333333333333333
2 3 0 1 3 0 1
3 3 1 2 3 0 -0
4 3 0 3 2 1 16777216 2.5
PLY
}

@test "every pair of formats: there and back is the same mesh" {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron | tm-convert --no-provenance --format ply >original.ply
  expected=$(facets original.ply)
  for first in ply off obj stl; do
    convert original.ply "first.$first"
    for second in ply off obj stl; do
      convert "first.$first" "second.$second"
      convert "second.$second" "third.$first"
      [ "$(facets "third.$first")" = "$expected" ] || fail "$first to $second and back"
      # Without STL in between, even the order of the vertices is the same.
      if [ "$first" != stl ] && [ "$second" != stl ]; then cmp "first.$first" "third.$first"; fi
    done
  done
}

@test "PLY with odd properties and elements, byte for byte in all three encodings" {
  cd "$BATS_TEST_TMPDIR"
  odd_ply >ascii.ply
  tm-convert --no-provenance ascii.ply | cmp - ascii.ply
  for format in ply ply-be; do
    tm-convert --no-provenance --format "$format" ascii.ply >binary.ply
    tm-convert --no-provenance binary.ply | cmp - binary.ply
    tm-convert --no-provenance --format ply-ascii binary.ply | cmp - ascii.ply
  done
}

@test "PLY with sized type names keeps them" {
  odd_ply | sed -e '/^property/{s/uchar/uint8/;s/ushort/uint16/;s/uint /uint32 /;s/double/float64/
    s/float /float32 /;s/char /int8 /;s/short/int16/;s/int /int32 /;s/int3232/int32/}' \
    >"$BATS_TEST_TMPDIR/sized.ply"
  grep -q 'property list int32 float64 ring' "$BATS_TEST_TMPDIR/sized.ply"
  tm-convert --no-provenance "$BATS_TEST_TMPDIR/sized.ply" | cmp - "$BATS_TEST_TMPDIR/sized.ply"
}

@test "what a format cannot hold is named once on stderr" {
  odd_ply >"$BATS_TEST_TMPDIR/odd.ply"
  run --separate-stderr tm-convert --format off "$BATS_TEST_TMPDIR/odd.ply"
  assert_status 0
  [ "$(grep -c "vertex property 'code' cannot be stored in OFF, dropped" <<<"$stderr")" -eq 1 ]
  [ "$(grep -c "element 'camera' cannot be stored in OFF, dropped" <<<"$stderr")" -eq 1 ]
}

@test "comments pass through OFF and OBJ" {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron | sed 's/^element vertex/comment tm:reference-edge 0.5\n&/' >a.ply
  for format in off obj; do
    convert a.ply "a.$format"
    convert "a.$format" b.ply
    grep -q '^comment tm:reference-edge 0.5$' b.ply
  done
}

# Makes a locale with a decimal comma, because the system may have none. The other categories are missing,
# of which localedef warns.
make_comma_locale() { # FOLDER
  printf '%s\n' '<code_set_name> UTF-8' '<escape_char> /' CHARMAP '<U0000>..<U007F> /x00 ASCII' \
    'END CHARMAP' >"$BATS_TEST_TMPDIR/ascii"
  printf '%s\n' 'escape_char /' LC_NUMERIC 'decimal_point ","' 'thousands_sep "."' 'grouping 3;3' \
    'END LC_NUMERIC' >"$BATS_TEST_TMPDIR/comma"
  localedef --force --quiet -f "$BATS_TEST_TMPDIR/ascii" -i "$BATS_TEST_TMPDIR/comma" "$1" || true
}

@test "a locale with a decimal comma changes nothing" {
  [ -x "$tm_build/bin/unit_tests" ] || skip "unit_tests is not built"
  make_comma_locale "$BATS_TEST_TMPDIR/de_DE.UTF-8"
  unset LC_ALL
  export LOCPATH=$BATS_TEST_TMPDIR LC_NUMERIC=de_DE.UTF-8
  [ "$(bash -c 'printf %.1f 0,5')" = 0,5 ] || fail "localedef made no locale"
  run "$tm_build/bin/unit_tests" -tc='mesh io: the decimal comma*'
  assert_status 0
  [[ $output != *"no locale"* ]]
  tetrahedron >"$BATS_TEST_TMPDIR/a.ply"
  tm-convert --no-provenance --format off "$BATS_TEST_TMPDIR/a.ply" | grep -qx '0 1 1'
}

@test "every real mesh is read and comes back the same" {
  needs_shared meshes
  cd "$BATS_TEST_TMPDIR"
  count=0
  for file in "$shared_file"/*/*; do
    tm-convert -q --no-provenance --format ply "$file" >once.ply || fail "$file"
    tm-convert -q --no-provenance once.ply | cmp - once.ply
    tm-convert -q --no-provenance --format off once.ply >once.off
    tm-convert -q --no-provenance --format ply once.off |
      tm-convert -q --no-provenance --format off | cmp - once.off || fail "$file through OFF"
    count=$((count + 1))
  done
  [ "$count" -ge 100 ]
}

@test "real files that are written as we write come back byte for byte" {
  needs_shared meshes/trimesh/fuze.ply
  for file in trimesh/fuze.ply trimesh/empty.ply geometry-central/bob_small.ply trimesh/ballA.off \
    cgal/armadillo.off transformesh/knot.off FastAndRobustMeshArrangements/three_cubes.stl; do
    needs_shared "meshes/$file"
    case $file in
      *.stl)
        convert "$shared_file" "$BATS_TEST_TMPDIR/same.stl"
        cmp "$BATS_TEST_TMPDIR/same.stl" "$shared_file"
        ;;
      *) tm-convert -q --no-provenance "$shared_file" | cmp - "$shared_file" ;;
    esac
  done
}

@test "edge cases among the real files" {
  needs_shared meshes/trimesh/notenoughindices.obj
  run tm-convert --format off "$shared_file"
  assert_status 0
  [[ $output == *"1 face with fewer than three corners dropped"* ]]
  needs_shared meshes/trimesh/fuze_ascii.ply
  run bash -c "tm-convert --format off '$shared_file' 2>&1 >/dev/null"
  [[ $output == *"more values than the header announces, from line 523"* ]]
  needs_shared meshes/geometry-central/stl_box_ascii.stl
  run bash -c "tm-convert --format off '$shared_file' 2>&1 >/dev/null"
  [[ $output == *"12 faces read as a soup of separate triangles; join them with tm-stitch"* ]]
  needs_shared meshes/trimesh/nancolor.obj
  run tm-convert --strict "$shared_file"
  assert_status 3
  [[ $output == *"the color of vertex 7 is not a finite number: 'nan'"* ]]
  run --separate-stderr tm-convert "$shared_file"
  assert_status 0
  [[ $stderr == *"not finite become"* ]]
}

@test "unsupported file endings are refused; without one, or with --format, the name stays" {
  cd "$BATS_TEST_TMPDIR"
  for name in a.gltf a.jpg; do
    run --separate-stderr tm-shape sphere --faces 100 -o "$name"
    assert_status 2
    [[ $stderr == *".ply, .off, .obj, .stl, .glb, .vtp, .3mf or .xyz"* ]]
    [ ! -e "$name" ]
  done
  tm-shape sphere --faces 100 -o plain
  tm-convert --format obj -o a.gltf plain
  grep -q '^v ' a.gltf
  run --separate-stderr tm-render plain -o a.jpg
  assert_status 2
  [[ $stderr == *".png"* ]]
}

@test "GLB and VTP are written by name or --format, and what they lose is named" {
  cd "$BATS_TEST_TMPDIR"
  odd_ply >odd.ply
  tm-convert odd.ply -o a.glb 2>notes
  [ "$(head -c 4 a.glb)" = glTF ]
  grep -q "glb: face property 'label' cannot be stored in GLB, dropped" notes
  grep -q "glb: coordinates are rounded to float" notes && fail "floats need no rounding"
  tm-convert --format glb -o - odd.ply 2>/dev/null | cmp - a.glb
  tm-convert odd.ply -o a.vtp 2>notes
  grep -q '<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0"' a.vtp
  grep -q '<DataArray type="Int16" Name="label" NumberOfComponents="1"' a.vtp
  grep -q "vtp: element 'camera' cannot be stored in VTP, dropped" notes
  # A filter also writes these formats, and all of them can be read.
  tm-shape sphere --faces 200 | tm-remesh -q -o sphere.VTP
  grep -q 'Polys' sphere.VTP
  for name in a.glb a.vtp; do [ "$(tm-info --get faces "$name")" -eq 4 ]; done
}

# corners FILE: prints the vertices and texture coordinates of every face of an OBJ by value.
corners() {
  awk '$1 == "v" { v[++n] = $2 + 0 " " $3 + 0 " " $4 + 0 }
    $1 == "vt" { vt[++m] = $2 + 0 " " $3 + 0 }
    $1 == "f" { for (i = 2; i <= 4; ++i) { split($i, c, "/"); print v[c[1]], vt[c[2]] } }' "$1"
}

@test "the texture of a real OBJ comes through pipes of PLY" {
  needs_shared meshes/cinolib/spot_triangulated.obj
  cd "$BATS_TEST_TMPDIR"
  tm-convert -q --format ply "$shared_file" | tm-stitch -q | tm-convert -q -o back.obj
  diff <(corners "$shared_file") <(corners back.obj)
  grep -q '^f 1/.* ' back.obj
}
