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

@test "convex polygons are cut into fans, and that is said once" {
  printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n' >square.off
  tm-convert square.off 2>notes >out.off
  tail -n 2 out.off | tr '\n' ' ' | grep -qx '3 0 1 2 3 0 2 3 '
  one_line "$(cat notes)"
}

# prism NAME: writes a prism of height 1 as OBJ. Its base is a polygon whose corners are lines of x y on
# standard input. Words after the name list the corners by number, from 1, if the polygon visits some of
# them twice.
prism() {
  local name=$1
  shift
  awk -v corners="$*" '
    { x[NR] = $1; y[NR] = $2 }
    END {
      for (z = 0; z < 2; ++z) for (i = 1; i <= NR; ++i) print "v", x[i], y[i], z
      size = split(corners, corner, " ")
      if (size == 0) for (size = NR; i-- > 1;) corner[i] = i
      printf "f"; for (i = 1; i <= size; ++i) printf " %d", corner[i] + NR; print ""
      printf "f"; for (i = size; i >= 1; --i) printf " %d", corner[i]; print ""
      for (i = 1; i <= size; ++i) {
        a = corner[i]; b = corner[i % size + 1]
        bridge[a, b] = 1
      }
      for (i = 1; i <= size; ++i) {
        a = corner[i]; b = corner[i % size + 1]
        if (!((b, a) in bridge)) print "f", a, b, b + NR, a + NR
      }
    }' >"$name.obj"
}

# facts FILE: prints components, genus, area and volume of a mesh that must be closed and free of
# self-intersections.
facts() {
  tm-checkmanifold -q --closed --intersections "$1" >/dev/null || fail "$1 is not clean"
  for key in components genus area volume; do printf '%s ' "$(tm-info -q --get "$key" "$1")"; done
}

@test "concave polygons and polygons with bridges to holes have no folds" {
  printf '%s\n' '2 0' '2 2' '1 1' '0 2' '0 0' | prism concave
  # two faces of area 3, and sides of length 6 + 2 sqrt(2)
  [[ $(facts concave.obj) == "1 0 14.82842712474"*" 3 " ]] || fail "$(facts concave.obj)"
  printf '%s\n' '0 0' '4 0' '4 4' '0 4' '1 1' '3 1' '3 3' '1 3' | prism ring 1 2 3 4 1 5 8 7 6 5
  [ "$(facts ring.obj)" = '1 1 48 12 ' ] || fail "$(facts ring.obj)"
  # The same lids in OFF and PLY.
  for format in off ply; do
    tm-convert -q --no-provenance --format "$format" ring.obj >"ring.$format"
    [ "$(facts "ring.$format")" = '1 1 48 12 ' ]
  done
  printf 'OFF\n6 1 0\n0 0 0\n2 0 0\n2 2 0\n1 2 0\n1 1 0\n0 1 0\n6 0 1 2 3 4 5\n' >corner.off
  [ "$(tm-info -q --get area corner.off)" -eq 3 ]
  # A thin hook in planes at several heights.
  for height in 0 0.1 0.125 1 9; do
    printf 'v %s\n' "8.6 4.6 $height" "8.8 4.9 $height" "-0.3 2.3 $height" "-0.2 2.0 $height" \
      "0.1 0.8 $height" "0.5 0.9 $height" "0.1 2.1 $height" >hook.obj
    echo 'f 1 2 3 4 5 6 7' >>hook.obj
    [[ $(tm-info -q --get area hook.obj) == 2.96* || $(tm-info -q --get area hook.obj) == 2.95999* ]]
  done
}

@test "an outline that intersects itself is named with the first face" {
  printf 'v %s\n' '0 0 0' '1 1 0' '1 0 0' '0 1 0' >bow.obj
  printf 'f 1 3 2\nf 1 2 3 4\nf 1 2 3 4\n' >>bow.obj
  run --separate-stderr tm-convert bow.obj --format off
  assert_status 0
  [[ $stderr == *'2 polygons cut into triangles that fold over, because the outline intersects itself; the first is face 2'* ]]
}

@test "100,000 corners of one polygon are cut in little time" {
  awk 'BEGIN {
    n = 25000
    print "OFF"; print 4 * n + 2, 1, 0
    for (i = 0; i < n; ++i) { print 2 * i, 0, 0; print 2 * i, 9, 0; print 2 * i + 1, 9, 0; print 2 * i + 1, 0, 0 }
    print 2 * n, -1, 0; print 0, -1, 0
    printf "%d", 4 * n + 2; for (i = 4 * n + 1; i >= 0; --i) printf " %d", i; print ""
  }' >comb.off
  # The teeth, and the bar, which has one slanted end.
  [ "$(timeout 30 tm-info -q --get area comb.off)" = 274999.5 ]
}

@test "infinite values are dropped with a count, and refused by --strict" {
  sed '/^element vertex/s/4/5/; /^0 1 1$/a nan inf -1.#IND' t.ply >point.ply
  run --separate-stderr tm-convert --no-provenance point.ply
  assert_status 0
  [[ $stderr == *'ply: 1 vertex with a coordinate that is not finite dropped' ]]
  [ "$output" = "$(tm-convert --no-provenance t.ply)" ]
  run --separate-stderr tm-convert --strict point.ply
  assert_status 3
  [[ $stderr == *"property 'x' of vertex 4 is not a finite number"* ]]
  # A face is removed together with its vertex.
  sed 's/^0 1 1$/nan 1 1/' t.ply >face.ply
  run --separate-stderr tm-info --json face.ply
  [ "$(jq -c '[.vertices, .faces]' <<<"$output")" = '[3,1]' ]
  [[ $stderr == *'1 vertex with a coordinate that is not finite dropped, and 3 faces that use it' ]]
  printf 'v %s\n' '0 0 0 .5 .5 .5' '1 0 0 nan nan nan' '0 1 0 .5 .5 .5' >color.obj
  echo 'f 1 2 3' >>color.obj
  run --separate-stderr tm-convert --no-provenance --format off color.obj
  assert_status 0
  [[ $stderr == *'obj: 1 color that is not finite becomes 0' ]]
  [[ $output == *'1 0 0 0.0 0.0 0.0'* ]]
  run tm-convert --strict color.obj
  assert_status 3
  # Other programs have the option, too; it does not change their output.
  tm-clean t.ply | cmp - <(tm-clean --strict t.ply)
  run tm-clean --strict face.ply
  assert_status 3
}

@test "lines that a format does not have are skipped with a count, and refused by --strict" {
  tm-convert --no-provenance --format obj t.ply >t.obj
  { echo 4 4; echo '$ by hand'; cat t.obj; echo 't crease 1'; echo 'vw 0 0 1'; printf '\n\0'; } >odd.obj
  for source in odd.obj -; do
    run --separate-stderr bash -c "tm-convert --no-provenance $source <odd.obj"
    assert_status 0
    [[ $stderr == *"4 unknown statements skipped; the first is '4' in line 1"* ]]
    [[ $stderr == *'1 byte of value 0 at the end skipped'* ]]
  done
  tm-convert -q --no-provenance --format obj odd.obj | cmp - t.obj
  run tm-convert --strict odd.obj
  assert_status 3
  sed '2a Created by a program, source file: ' t.ply | sed 's/property double/property DOUBLE/' >odd.ply
  run --separate-stderr tm-convert --no-provenance odd.ply
  assert_status 0
  [[ $stderr == *'1 line of the header without a keyword taken as a comment'* ]]
}

@test "STL with 0 in its header, without an end, and with blank lines first" {
  tm-convert --no-provenance -o t.stl t.ply
  { head -c 80 t.stl; printf '\0\0\0\0'; tail -c +85 t.stl; } >zero.stl
  run --separate-stderr tm-info --get faces zero.stl
  [ "$output" -eq 4 ]
  [[ $stderr == *'the header announces 0 facets, but 4 follow and are read'* ]]
  [ "$(tm-info -q --get faces <zero.stl)" -eq 4 ]
  awk 'BEGIN {
    print "solid t"
    for (i = 0; i < 4; ++i) {
      print "facet normal 0 0 0\nouter loop"
      for (j = 0; j < 3; ++j) print "vertex", i, j, i * j
      print "endloop\nendfacet"
    }
  }' >endless.stl
  run --separate-stderr tm-info --get faces endless.stl
  [ "$output" -eq 4 ]
  [[ $stderr == *"'endsolid' is missing at the end: the file may be cut off"* ]]
  { echo; cat endless.stl; echo endsolid; } >blank.stl
  [ "$(tm-info -q --get faces blank.stl)" -eq 4 ]
  for file in zero endless; do
    run tm-info --strict "$file.stl"
    assert_status 3
  done
}

@test "a real mesh survives a round trip through every format of a pipe" {
  needs_shared meshes/cgal/bones.off
  tm-convert --no-provenance "$shared_file" -o first.ply
  tm-convert --no-provenance first.ply --format ply-ascii |
    tm-convert --no-provenance --format ply-be | tm-convert --no-provenance --format off |
    tm-convert --no-provenance --format ply | cmp - first.ply
}
