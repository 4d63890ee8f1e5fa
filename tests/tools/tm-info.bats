load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >mesh.ply
}

@test "tm-info: a tetrahedron, every key in its order" {
  pipe 'tm-info mesh.ply | cut -d: -f1 | tr "\n" " "'
  assert_status 0
  [ "$output" = "vertices faces edges components genus boundary_loops area volume bbox_min bbox_max edge_mean edge_min edge_max angle_min angle_min_mean valence6 " ]
  [ "$(tm-info --get vertices mesh.ply)" = 4 ]
  [ "$(tm-info --get edges mesh.ply)" = 6 ]
  [ "$(tm-info --get genus mesh.ply)" = 0 ]
  [ "$(tm-info --get bbox_max mesh.ply)" = "1 1 1" ]
  [ "$(tm-info --get edge_min mesh.ply)" = 1.4142135623730951 ]
  tm-info --get volume mesh.ply | awk '{ exit !($1 > 0.3333333333 && $1 < 0.3333333334) }'
  tm-info --get area mesh.ply | awk '{ exit !($1 > 3.4641016151 && $1 < 3.4641016152) }'
  tm-info --get angle_min mesh.ply | awk '{ exit !($1 > 59.99999999 && $1 < 60.00000001) }'
}

@test "tm-info: JSON holds the same numbers" {
  needs_command python3
  pipe 'tm-info --json mesh.ply | python3 -c "
import json, sys
report = json.load(sys.stdin)
print(report[\"faces\"], report[\"bbox_min\"], report[\"edge_max\"])"'
  assert_status 0
  [ "$output" = "4 [0.0, 0.0, 0.0] 1.4142135623730951" ]
}

@test "tm-info: an unknown key is exit 2 and names the nearest" {
  run tm-info --get genius mesh.ply
  assert_status 2
  [[ $output == *"'genus'"* ]]
}

@test "tm-info: points and an empty mesh are described" {
  printf 'OFF\n2 0 0\n0 0 0\n3 4 0\n' >points.off
  pipe 'tm-info points.off'
  assert_status 0
  [[ $output == *"vertices: 2"*"faces: 0"*"components: 0"*"area: 0"*"bbox_max: 3 4 0"*"edge_mean: 0"* ]]
  printf 'OFF\n0 0 0\n' >empty.off
  pipe 'tm-info empty.off'
  assert_status 0
  [[ $output == *"vertices: 0"*"bbox_min: 0 0 0"*"valence6: 0"* ]]
}

@test "tm-info: generated shapes have their genus" {
  [ "$(tm-shape torus --faces 2000 | tm-info --get genus)" = 1 ]
  [ "$(tm-shape genus 3 --faces 4000 | tm-info --get genus)" = 3 ]
  [ "$(tm-shape sphere --faces 2000 | tm-info --get genus)" = 0 ]
}

@test "tm-info: known meshes of others" {
  needs_shared meshes/cgal/3torus.off
  [ "$(tm-info --get genus "$shared_file")" = 3 ]
  needs_shared meshes/cgal/eight.off
  [ "$(tm-info --get genus "$shared_file")" = 2 ]
  needs_shared meshes/cgal/bones.off
  [ "$(tm-info --get components "$shared_file")" = 26 ]
}

@test "tm-info: --per-vertex writes the mesh with its curvature, the report stays" {
  tm-shape sphere --radius 2 --faces 2000 >sphere.ply
  tm-info sphere.ply >usual
  tm-info --per-vertex bent.ply sphere.ply >report
  cmp usual report
  pipe 'tm-convert --format ply-ascii bent.ply | awk "/^end_header/ { inside = 1; next }
    inside && NF == 4 && \$1 != 3 { ++n; if (\$4 < 0.49 || \$4 > 0.51) ++bad } END { print (n > 900), bad + 0 }"'
  [ "$output" = "1 0" ]
}
