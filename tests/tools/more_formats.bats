#!/usr/bin/env bats
# Formats that pipes do not carry: glTF, 3MF, VTP, VTK, PCD, XYZ, and gzip of all formats. Other programs
# write files for this suite, and read the files of this suite.

load ../helpers/common

convert() {
  tm-convert -q --no-provenance "$1" -o "$2"
}

# bare FILE: prints the triangles without properties, in floats.
bare() {
  convert "$1" "$BATS_TEST_TMPDIR/bare.stl"
  triangles "$BATS_TEST_TMPDIR/bare.stl"
}

foreign_files() {
  needs_command python3
  python3 "$tm_root/tests/helpers/foreign_files.py" "$BATS_TEST_TMPDIR"
}

@test "a closed manifold stays one through every pair of formats" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus --faces 300 | tm-convert --float --no-provenance -o original.ply
  expected=$(triangles original.ply)
  [ -n "$expected" ]
  for first in ply off obj glb vtp 3mf; do
    convert original.ply "first.$first"
    for second in ply off obj glb vtp 3mf; do
      convert "first.$first" "second.$second"
      tm-checkmanifold -q "second.$second" || fail "$first to $second"
      [ "$(triangles "second.$second")" = "$expected" ] || fail "$first to $second"
    done
  done
}

@test "colors of vertices and of faces survive formats that have them" {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >plain.ply
  tm-convert --no-provenance --format ply-ascii plain.ply |
    awk '/^property .* z/ { print; for (c = 1; c <= 3; ++c) print "property uchar " substr("red  greenblue ", 5 * c - 4, 5); next }
      /^end_header/ { body = 1; print; next } body && NF == 3 { print $0, 10 * ++n, 0, 255; next } { print }' >colored.ply
  for format in glb vtp 3mf; do
    convert colored.ply "a.$format"
    convert "a.$format" back.ply
    tm-convert -q --no-provenance --format ply-ascii back.ply | grep -v '^comment' >back
    [ "$(sed -n '/end_header/,$p' back)" = "$(sed -n '/end_header/,$p' colored.ply)" ] || fail "$format"
  done
}

@test "files that a library of Python writes: VTP in every encoding, VTK, 3MF and PCD" {
  foreign_files
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >original.ply
  expected=$(bare original.ply)
  for file in *.vtp *.vtk *.3mf; do [ "$(bare "$file")" = "$expected" ] || fail "$file"; done
  [ "$(find . -name '*.vtp' | wc -l)" -eq 32 ]
  tm-convert --no-provenance -q original.ply -o points.xyz
  for file in *.pcd; do tm-convert -q --no-provenance "$file" -o - --format xyz | cmp - points.xyz; done
  [ "$(tm-info --units stored.3mf | grep unit)" = "unit: centimeter" ]
}

@test "every format is read from a pipe, compressed or not" {
  foreign_files
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >a.ply
  expected=$(bare a.ply)
  for format in off obj stl glb; do convert a.ply "a.$format"; done
  for file in a.* inline0.vtp raw6.vtp binary.vtk deflated.3mf; do
    [ "$(gzip -c "$file" | tm-info -q --get faces)" -eq 4 ] || fail "$file.gz"
    [ "$(tm-info -q --get faces <"$file")" -eq 4 ] || fail "$file"
    gzip -kf "$file"
    [ "$(bare "$file.gz")" = "$expected" ] || fail "$file.gz by name"
  done
  [ "$(gzip -c text.pcd | tm-info -q --get vertices)" -eq 4 ]
  gzip -c a.stl | head -c 60 >cut.gz
  run --separate-stderr tm-info cut.gz
  assert_status 3
  [ "$stderr" = "tm-info: the compressed data is cut off (cut.gz byte 60)" ]
}

@test "assimp reads what is written, and its files are read, in every pair" {
  needs_command assimp
  cd "$BATS_TEST_TMPDIR"
  tm-shape box --faces 200 -o original.ply
  expected=$(bare original.ply)
  for first in ply off obj stl glb 3mf; do
    convert original.ply "first.$first"
    for second in ply stl obj glb gltf; do
      rm -f "second.$second"
      assimp export "first.$first" "second.$second" >log 2>&1 || fail "$first to $second: $(cat log)"
      [ "$(bare "second.$second")" = "$expected" ] || fail "$first to $second"
    done
  done
}

@test "meshio reads what is written, and its files are read, in every pair; its VTK is read" {
  /usr/bin/python3 -c 'import meshio' 2>/dev/null || skip "python3-meshio is not installed"
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus --faces 300 | tm-convert --float -o original.ply
  expected=$(bare original.ply)
  for format in ply off obj stl; do convert original.ply "first.$format"; done
  /usr/bin/python3 - <<'PYTHON'
import meshio

for first in ("ply", "off", "obj", "stl"):
    mesh = meshio.read("first." + first)
    assert mesh.cells_dict["triangle"].shape == (304, 3), mesh
    for second in ("ply", "off", "obj", "stl", "vtk"):
        meshio.write("%s-second.%s" % (first, second), mesh)
    for second in ("ply", "stl", "vtk"):
        meshio.write("%s-text.%s" % (first, second), mesh, binary=False)
PYTHON
  for file in *-second.* *-text.*; do [ "$(bare "$file")" = "$expected" ] || fail "$file"; done
  [ "$(find . -name '*-*.*' | wc -l)" -eq 32 ]
}

@test "glTF with a buffer of its own: by its name, not through a pipe, and not from elsewhere" {
  needs_command assimp
  cd "$BATS_TEST_TMPDIR"
  mkdir in
  tetrahedron >a.ply
  assimp export a.ply in/a.gltf >/dev/null
  [ "$(tm-info --get faces in/a.gltf)" -eq 4 ]
  run --separate-stderr tm-info <in/a.gltf
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"'a.bin' is in another file"* ]]
  mv in/a.bin a.bin
  sed 's|"a.bin"|"../a.bin"|' in/a.gltf >in/b.gltf
  run --separate-stderr tm-info in/b.gltf
  assert_status 3
  [[ $stderr == *"'../a.bin' is not in the folder of the file"* ]]
}

@test "units: stated by 3MF, kept through pipes, changed, and missed" {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >a.ply
  run --separate-stderr tm-transform --to mm a.ply
  assert_status 3
  [[ $stderr == *"the mesh does not state its unit: give it with --from"* ]]
  tm-transform --from in --to mm -o a.3mf a.ply
  [ "$(tm-info --get bbox_max a.3mf)" = "25.4 25.4 25.4" ]
  tm-convert a.3mf | tm-transform --to in | tm-info --get bbox_max |
    awk '{ exit !($1 > 0.999999 && $1 < 1.000001) }'
  [ "$(tm-transform --to m a.3mf | tm-convert --format glb | tm-info --units | grep unit)" = "unit: meter" ]
  [ "$(tm-info --units a.ply | grep unit)" = "unit: unknown" ]
  tm-convert a.ply -o a.stl
  [ "$(tm-info -q --units a.stl | grep unit)" = "unit: millimeter" ]
  # The unit of an input does not depend on the format of the output.
  tm-transform -q --to in a.stl -o c.3mf
  tm-info --get bbox_max c.3mf | awk '{ exit !(25.4 * $1 > 0.999999 && 25.4 * $1 < 1.000001) }'
  run --separate-stderr tm-transform --to in a.ply -o c.stl
  assert_status 3
  [[ $stderr == *"the mesh does not state its unit: give it with --from"* ]]
  tm-transform --from in --to in a.ply -o inch.ply
  run --separate-stderr tm-cat inch.ply a.stl -o all.ply
  [[ $stderr == *"the units differ, inch and millimeter: coordinates are used without conversion"* ]]
  for command in "tm-compare a.stl" "tm-compare a.stl --reference" "tm-align a.stl --reference" \
    'tm-carry a.stl --closest --from' 'tm-morph-step a.3mf --target' \
    'tm-morph --iterations 1 a.3mf -o /dev/null --target'; do
    pipe_apart "$command inch.ply >/dev/null"
    [[ $stderr == *"the units differ, millimeter and inch: coordinates are used without conversion"* ]] ||
      fail "$command: $stderr"
  done
  run --separate-stderr tm-transform --to in a.3mf -o b.stl
  assert_status 0
  [[ $stderr == *"the unit inch cannot be stored, and programs will assume millimeter"* ]]
}

@test "points of a mesh and of a sample as text, with normals if there are any" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --faces 200 -o sphere.ply
  tm-sample --count 50 --no-provenance sphere.ply -o points.xyz
  [ "$(grep -vc '^#' points.xyz)" -eq 50 ]
  # On the unit sphere, the normal of a face is nearly the position.
  awk '!/^#/ { n = $1 * $4 + $2 * $5 + $3 * $6; if (NF != 6 || n < 0.8) exit 1 }' points.xyz
  [ "$(tm-info --get vertices points.xyz)" -eq 50 ]
  run --separate-stderr tm-convert sphere.ply -o sphere.xyz
  assert_status 0
  [[ $stderr == *"faces cannot be stored in XYZ, dropped"* ]]
  tm-info --get vertices sphere.ply >count
  [ "$(tm-info --get vertices sphere.xyz)" -eq "$(cat count)" ]
  run --separate-stderr tm-convert points.xyz -o points.3mf
  assert_status 4
  one_line "$stderr"
}
