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
