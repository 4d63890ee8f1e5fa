load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >t.ply
}

@test "every format gives the mesh back" {
  for format in ply ply-ascii ply-be off; do
    tm-convert --no-provenance --format "$format" t.ply |
      tm-convert --no-provenance --format ply-ascii | cmp - t.ply
  done
  tm-convert --no-provenance -o t.obj t.ply
  tm-convert --no-provenance --format ply-ascii t.obj | cmp - t.ply
}

@test "STL holds separate triangles" {
  tm-convert --no-provenance -o t.stl t.ply
  tm-convert t.stl --format ply-ascii 2>notes >t2.ply
  grep -qx "element vertex 12" t2.ply
  grep -qx "element face 4" t2.ply
  one_line "$(cat notes)"
}

@test "what a format cannot hold is named once" {
  sed '/^property double z/a property float quality' t.ply |
    sed '/^end_header/,$ s/^\(. . .\)$/\1 7/' >quality.ply
  tm-convert --format off quality.ply 2>notes >/dev/null
  one_line "$(cat notes)"
  grep -q quality notes
}

@test "polygons are cut into fans, and that is said once" {
  printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n' >square.off
  tm-convert square.off 2>notes >out.off
  tail -n 2 out.off | tr '\n' ' ' | grep -qx '3 0 1 2 3 0 2 3 '
  one_line "$(cat notes)"
}

@test "a real mesh survives a round trip through every format of a pipe" {
  needs_shared meshes/cgal/bones.off
  tm-convert --no-provenance "$shared_file" -o first.ply
  tm-convert --no-provenance first.ply --format ply-ascii |
    tm-convert --no-provenance --format ply-be | tm-convert --no-provenance --format off |
    tm-convert --no-provenance --format ply | cmp - first.ply
}
