#!/usr/bin/env bats
# Boolean operations, checked by volumes in closed form.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# cube X0 X1 [FILE]: writes the cube from X0 to X1 along each axis, as OFF with 8 vertices.
cube() {
  awk -v a="$1" -v b="$2" 'BEGIN {
    print "OFF\n8 12 0"
    for (i = 0; i < 8; ++i)
      print (i % 2 ? b : a), (int(i / 2) % 2 ? b : a), (i >= 4 ? b : a)
    print "3 0 2 1\n3 1 2 3\n3 4 5 6\n3 5 7 6\n3 0 1 4\n3 1 5 4"
    print "3 2 6 3\n3 3 6 7\n3 0 4 2\n3 2 4 6\n3 1 3 5\n3 3 7 5"
  }'
}

# bare MESH: prints only the numbers of a mesh.
bare() {
  tm-convert --format off "$1" | grep -v '^#'
}

# volume_of COMMAND MESH...: prints the volume of the result, which must be a solid.
volume_of() {
  tm-boolean "$@" -o result.ply
  tm-checkmanifold --closed --intersections result.ply >/dev/null
  tm-info --get volume result.ply
}

@test "each operation has the volume of its definition" {
  cube 0 2 >a.off
  cube 1 3 >b.off
  cube 0.5 2.5 >c.off
  [ "$(volume_of union a.off b.off)" = 15 ]
  [ "$(volume_of intersection a.off b.off)" = 1 ]
  [ "$(volume_of difference a.off b.off)" = 7 ]
  [ "$(volume_of xor a.off b.off)" = 14 ]
  # The intersections of two cubes have the volumes 1, 3.375 and 3.375; the intersection of all three has 1.
  [ "$(volume_of union a.off b.off c.off)" = 17.25 ]
  [ "$(volume_of intersection a.off b.off c.off)" = 1 ]
  [ "$(volume_of difference a.off b.off c.off)" = 4.625 ]
  [ "$(volume_of xor a.off b.off c.off)" = 12.5 ]
}

@test "a mesh that overlaps itself is one solid" {
  cube 0 2 >a.off
  cube 1 3 >b.off
  cube 0.5 2.5 >c.off
  tm-cat a.off b.off -o twice.off
  [ "$(volume_of union twice.off)" = 15 ]
  [ "$(volume_of difference twice.off c.off)" = 9.25 ]
  [ "$(volume_of difference c.off twice.off)" = 2.25 ]
  [ "$(volume_of intersection twice.off c.off)" = 5.75 ]
  [ "$(volume_of xor twice.off c.off)" = 11.5 ]
  tm-cat twice.off a.off | tm-boolean intersection - a.off -o result.ply
  [ "$(tm-info --get volume result.ply)" = 8 ]
}

@test "a body inside another is subtracted as a cavity" {
  cube 0 3 >a.off
  cube 1 2 >b.off
  [ "$(volume_of xor a.off b.off)" = 26 ]
  [ "$(volume_of xor b.off a.off)" = 26 ]
  [ "$(volume_of difference a.off b.off)" = 26 ]
  [ "$(volume_of union a.off b.off)" = 27 ]
  [ "$(volume_of intersection a.off b.off)" = 1 ]
}

@test "bodies that touch become one, and leave nothing in common" {
  cube 0 1 >a.off
  tm-transform --translate 1,0,0 a.off -o beside.off
  [ "$(volume_of union a.off beside.off)" = 2 ]
  [ "$(tm-info --get faces result.ply)" = 12 ]
  for command in intersection xor; do
    tm-boolean "$command" a.off a.off beside.off -o result.ply 2>messages || fail "$command failed"
    case $command in
    intersection) [ "$(tm-info --get faces result.ply)" = 0 ] ;;
    xor) [ "$(tm-info --get volume result.ply)" = 1 ] ;;
    esac
  done
}

# sources_of COMMAND MESH...: prints for each mesh of the result's faces its number and how many faces it has.
sources_of() {
  tm-boolean "$@" --source-operand --format ply-ascii -o result.ply
  tail -n "$(tm-info --get faces result.ply)" result.ply | awk '{ print $NF }' | sort -n | uniq -c |
    awk '{ printf "%s%s:%s", (NR > 1 ? " " : ""), $2, $1 }'
}

@test "where faces coincide, one is left, from the first mesh with a face in its direction" {
  cube 0 1 >a.off
  cube 0 2 >large.off # three of its faces contain faces of a.off
  tm-transform --translate 1,0,0 a.off -o beside.off
  [ "$(sources_of union a.off a.off)" = 0:12 ]
  [ "$(sources_of intersection a.off large.off)" = 0:12 ]
  [ "$(sources_of intersection large.off a.off)" = "0:6 1:6" ]
  # The face at x = 1 has the direction of a.off, and of beside.off reversed.
  [ "$(sources_of difference a.off beside.off)" = 0:12 ]
  # Only beside.off has a face in the direction of the result at x = 1.
  [ "$(sources_of xor a.off a.off beside.off)" = 2:12 ]
}

@test "an empty result is a mesh without faces, which a note says" {
  cube 0 1 >a.off
  cube 2 3 >b.off
  run --separate-stderr tm-boolean intersection a.off b.off -o empty.ply
  [ "$status" -eq 0 ]
  [ "$stderr" = "tm-boolean: the result is empty: a mesh without faces" ]
  [ "$(tm-info --get faces empty.ply)" = 0 ]
  run --separate-stderr tm-boolean intersection a.off b.off --require-nonempty -o none.ply
  [ "$status" -eq 4 ]
  [ ! -e none.ply ]
  # An empty mesh is accepted as an operand.
  [ "$(volume_of union a.off empty.ply)" = 1 ]
  [ "$(volume_of difference a.off empty.ply)" = 1 ]
  tm-boolean -q intersection a.off empty.ply -o result.ply
  [ "$(tm-info --get faces result.ply)" = 0 ]
}

@test "a mesh that is inside out encloses nothing, which a note says" {
  cube 0 3 >a.off
  cube 1 2 | tm-stitch --flip -o b.off
  run --separate-stderr tm-boolean difference a.off b.off -o result.ply
  [ "$status" -eq 0 ]
  [ "$stderr" = "tm-boolean: b.off encloses nothing: its faces are oriented inwards; reverse it with tm-stitch --flip" ]
  [ "$(tm-info --get volume result.ply)" = 27 ]
  echo "c = difference a.off b.off" >steps.txt
  run --separate-stderr tm-boolean --script steps.txt -o result.ply
  [[ $stderr = "tm-boolean: line 1 of the script: b.off encloses nothing: "* ]]
}

@test "a mesh whose faces cancel out encloses nothing, and the advice mends it" {
  cube 0 3 >a.off
  cube 1 2 >b.off
  tm-stitch --flip b.off | tm-cat b.off - -o both.off
  run --separate-stderr tm-boolean difference a.off both.off -o result.ply
  [ "$status" -eq 0 ]
  [[ $stderr = "tm-boolean: both.off encloses nothing: its faces coincide and cancel out; "*"tm-stitch --one-side"* ]]
  [ "$(tm-info --get volume result.ply)" = 27 ]
  [ "$(tm-stitch --one-side both.off | tm-boolean difference a.off - | tm-info --get volume)" = 26 ]
  tm-stitch --flip b.off >flipped.off
  run --separate-stderr bash -c 'tm-boolean union - <flipped.off >result.ply'
  [[ $stderr = "tm-boolean: standard input encloses nothing: its faces are oriented inwards; "* ]]
}

@test "a script keeps the unit, and the bound of how far flat faces moved" {
  cube 0 2 | tm-convert -o a.3mf
  cube 1 3 >b.off
  tm-shape sphere -o ball.ply
  tm-transform --translate 0.5,0,0 ball.ply | tm-boolean union ball.ply - -o c.ply
  tm-convert --format ply-ascii c.ply | grep '^comment tm:planarity' >bound
  printf '%s\n' "x = union a.3mf b.off" "x = union x c.ply" >steps.txt
  tm-boolean --script steps.txt --format ply-ascii -o result.ply
  [ "$(tm-info --get unit result.ply)" = millimeter ]
  awk 'NR == FNR { least = $3; next } /^comment tm:planarity/ { found = $3 >= least } END { exit !found }' bound result.ply
  tm-transform --to in a.3mf -o inch.3mf
  printf '%s\n' "x = union a.3mf inch.3mf" >steps.txt
  run --separate-stderr tm-boolean --script steps.txt -o result.ply
  [[ $stderr = *"the units differ, "* ]]
}

@test "a mesh with borders is refused by its name" {
  cube 0 1 >a.off
  sed -e 's/^8 12 0$/8 11 0/' -e '$d' a.off >"open =1.off"
  run --separate-stderr tm-boolean union a.off "open =1.off"
  [ "$status" -eq 3 ]
  [ "$stderr" = "tm-boolean: open =1.off has 1 border: it is not a solid; close holes with tm-fill" ]
  # The mesh is refused even if another operand closes it.
  printf '%s\n' OFF "8 1 0" "$(sed -n 3,10p a.off)" "$(tail -n 1 a.off)" >rest.off
  run --separate-stderr tm-boolean union "open =1.off" rest.off
  [ "$status" -eq 3 ]
  [[ $stderr = "tm-boolean: open =1.off has 1 border"* ]]
  awk 'NR == 11 { print 3, $2, $4, $3; next } { print }' a.off >turned.off
  run --separate-stderr tm-boolean union a.off turned.off
  [ "$status" -eq 3 ]
  [[ $stderr = "tm-boolean: turned.off: "*"tm-stitch --orient"* ]]
}

@test "faces keep their properties, and the number of their mesh" {
  tm-shape box 2 2 2 --faces 300 -o a.ply
  tm-shape sphere --radius 1.2 --faces 500 -o b.ply
  tm-boolean difference a.ply b.ply --source-operand -o c.ply
  tm-select --where 'source_operand>0' c.ply -o inner.ply
  # All faces that come from the ball are on its facets.
  tm-compare --reference b.ply --json inner.ply >report
  awk -F'[:,]' '/"accuracy"/ { exit !($2 < 1e-12) }' report
  run tm-info --get faces inner.ply
  [ "$output" -gt 100 ]
}

@test "cut gives the part of a sheet outside or inside of a solid" {
  cube 0 2 >solid.off
  printf '%s\n' OFF "4 2 0" "-1 -1 1" "3 -1 1" "3 3 1" "-1 3 1" "3 0 1 2" "3 0 2 3" >sheet.off
  tm-boolean cut sheet.off solid.off -o outside.ply
  tm-boolean cut --inside sheet.off solid.off -o inside.ply
  [ "$(tm-info --get area outside.ply)" = 12 ]
  [ "$(tm-info --get area inside.ply)" = 4 ]
  [ "$(tm-info --get boundary_loops outside.ply)" = 2 ]
  run --separate-stderr tm-boolean cut sheet.off
  [ "$status" -eq 2 ]
  run --separate-stderr tm-boolean cut solid.off sheet.off
  [ "$status" -eq 3 ]
  [[ $stderr = "tm-boolean: sheet.off has 1 border"* ]]
}

@test "--cap closes what a sheet cuts off a ball and a box" {
  cube 0 2 >solid.off
  printf '%s\n' OFF "4 2 0" "-1 -1 .5" "3 -1 .5" "3 3 .5" "-1 3 .5" "3 0 1 2" "3 0 2 3" >sheet.off
  [ "$(volume_of cut --inside --cap sheet.off solid.off)" = 2 ]
  tm-stitch --flip sheet.off >down.off
  [ "$(volume_of cut --inside --cap down.off solid.off)" = 6 ]
  tm-shape sphere --faces 20000 -o ball.ply
  tm-transform --translate 0,0,-.5 sheet.off | tm-transform --scale 3 -o middle.off
  half=$(volume_of cut --inside --cap middle.off ball.ply)
  awk -v half="$half" 'BEGIN { exit !(half > 2.09 && half < 4 * atan2(1, 1) * 2 / 3) }'
}

@test "--cap is refused where a sheet bounds nothing, and the advice mends it" {
  cube 0 2 >solid.off
  cube 1 3 >other.off
  printf '%s\n' OFF "3 1 0" ".5 .5 1" "1 .5 1" ".5 1 1" "3 0 1 2" >small.off
  run --separate-stderr tm-boolean cut --inside --cap small.off solid.off -o none.ply
  [ "$status" -eq 3 ]
  [[ $stderr = "tm-boolean: the sheet ends inside the solid, at ("*"): a cap cannot close it there" ]]
  [ ! -e none.ply ]
  tm-stitch --flip other.off >inwards.off
  run --separate-stderr tm-boolean cut --cap inwards.off solid.off
  [ "$status" -eq 3 ]
  [ "$stderr" = "tm-boolean: the region behind the sheet is not bounded: the sheet may be reversed; reverse it with tm-stitch --flip" ]
  tm-stitch --flip inwards.off -o outwards.off
  [ "$(volume_of cut --cap outwards.off solid.off)" = 7 ]
  for option in --cap --inside; do
    run --separate-stderr tm-boolean union "$option" other.off solid.off
    [ "$status" -eq 2 ]
    [ "$stderr" = "tm-boolean: $option can be used only with cut" ]
  done
}

@test "a script gives the bytes of the same operations through files" {
  tm-shape box 2 2 2 --faces 500 -o a.ply
  tm-shape sphere --radius 1.2 --faces 500 -o "the ball.ply"
  tm-shape torus --faces 500 -o c.ply
  tm-boolean union a.ply c.ply -o 1.ply
  tm-boolean difference 1.ply "the ball.ply" a.ply -o 2.ply
  tm-boolean xor 2.ply 1.ply -o 3.ply
  printf '%s\n' "# three" "x = union a.ply c.ply" "" 'y = difference x "the ball.ply" a.ply # two' \
    "x = xor y x" >steps.txt
  tm-boolean --script steps.txt --no-provenance -o script.ply
  cmp <(bare 3.ply) <(bare script.ply)
}

@test "a script that is wrong is refused by the line" {
  local line
  while read -r line; do
    printf 'a = union b.ply\n%s\n' "$line" >steps.txt
    run --separate-stderr tm-boolean --script steps.txt
    [ "$status" -eq 3 ]
    [[ $stderr = "tm-boolean: line 2 of the script: "* ]]
  done <<'LINES'
x = unoin a
x = union
x union a b
x = union "a
LINES
  run --separate-stderr tm-boolean --script /dev/null
  [ "$status" -eq 3 ]
}

@test "a missing command is an error, and for a wrong one the nearest is suggested" {
  run --separate-stderr tm-boolean diference a.ply b.ply
  [ "$status" -eq 2 ]
  [ "$stderr" = "tm-boolean: unknown command 'diference'; did you mean 'difference'?" ]
  run --separate-stderr tm-boolean </dev/null
  [ "$status" -eq 2 ]
}
