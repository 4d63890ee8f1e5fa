#!/usr/bin/env bats
# --keep-polygons: faces of more than three corners stay faces. Files are compared by their lines.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  # A cube without its top below a pyramid: 5 squares, 4 triangles and, apart from them, a concave pentagon.
  cat >house.off <<'MESH'
OFF
14 10 0
0 0 0
2 0 0
2 2 0
0 2 0
0 0 2
2 0 2
2 2 2
0 2 2
1 1 3
5 0 0
7 0 0
7 2 0
6 0.5 0
5 2 0
4 3 2 1 0
4 0 1 5 4
4 1 2 6 5
4 2 3 7 6
4 3 0 4 7
3 4 5 8
3 5 6 8
3 6 7 8
3 7 4 8
5 9 10 11 12 13
MESH
}

# bare FILE: prints the file without comments and blank lines.
bare() {
  grep -v -e '^#' -e '^comment' -e '^$' "$1"
}

@test "polygons pass through OFF, OBJ and PLY and come back" {
  tm-convert --keep-polygons house.off -o a.obj
  [ "$(grep -c '^f' a.obj)" -eq 10 ]
  grep -qx 'f 10 11 12 13 14' a.obj
  tm-convert --keep-polygons a.obj -o a.ply
  grep -qx 'element face 10' a.ply
  tm-convert --keep-polygons --format ply-be a.ply | tm-convert --keep-polygons --format ply-ascii |
    tm-convert --keep-polygons --format off >b.off
  cmp <(bare house.off) <(bare b.off)
  # Without the option, polygons become triangles, and a note says so.
  run --separate-stderr tm-convert house.off
  [[ $stderr == *"6 polygons cut into 13 triangles"* ]]
  run --separate-stderr tm-convert --keep-polygons house.off
  [ -z "$stderr" ]
}

@test "tm-transform and tm-select keep polygons" {
  tm-transform --translate 1,0,0 --mirror x --keep-polygons house.off -o moved.off
  awk 'NF > 3 && $1 > 2' moved.off | awk '{ print $1 }' | sort | uniq -c | tr -s ' ' >sizes
  printf ' 4 3\n 5 4\n 1 5\n' | cmp - sizes
  # A mirrored polygon has the opposite direction and starts at the same corner.
  grep -qx '4 3 0 1 2' moved.off
  tm-select --largest 1 --keep-polygons house.off -o house-only.off
  cmp <(bare house.off | sed -n '17,25p') <(bare house-only.off | sed -n '12,$p')
}

@test "tm-info counts polygons as faces" {
  tm-info --keep-polygons --json house.off >report.json
  jq -e '.faces == 10 and .polygons == 6 and .vertices == 14' report.json
  [ "$(tm-info --get faces house.off)" = 17 ]
  [ "$(tm-info --keep-polygons --get faces house.off)" = 10 ]
  [ "$(tm-info --get polygons house.off)" = 6 ]
  tm-select --largest 1 --keep-polygons house.off | tm-info --keep-polygons --json | jq -e '.edges == 16'
}

@test "a format without polygons is noted, and a partly removed polygon stays one" {
  run --separate-stderr tm-convert --keep-polygons house.off -o a.stl
  [ "$status" -eq 0 ]
  [[ $stderr == *"stl: 6 polygons written as triangles"* ]]
  tm-select --plane 0,0,1,1 --keep-polygons house.off -o top.off 2>/dev/null
  [ "$(bare top.off | awk 'NF == 6 && $1 == 5' | wc -l)" -eq 4 ]
}
