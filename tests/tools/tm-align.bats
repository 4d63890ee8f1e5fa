load ../helpers/common

# scan NAME BOX [TRANSFORM...]: writes the part of a dented ball in a box, after a motion.
scan() {
  tm-shape dented --faces "$2" | tm-select --box "$3" | tm-transform "${@:4}" -o "$1"
}

setup() {
  cd "$BATS_TEST_TMPDIR"
  scan one.ply 6000 -9,-9,-9,0.4,9,9
  scan two.ply 7000 -0.4,-9,-9,9,9,9 --rotate 1,2,3,20 --translate 0.1,0.2,-0.1
}

@test "a turned scan comes back to its place, by tm-compare with the whole" {
  tm-shape dented --faces 20000 -o whole.ply
  tm-align --reference one.ply --report r.json two.ply -o placed.ply
  far=$(tm-compare --reference whole.ply placed.ply | sed -n 's/^hausdorff_to_reference: //p')
  awk -v far="$far" 'BEGIN { exit !(far < 0.02) }'
  jq -e '.result | .converged and .rms < 0.005 and .overlap > 0.3 and .overlap < 0.7 and
    .rotation > 19 and .rotation < 21 and .stability > 0.03' r.json
}

@test "the written matrix gives the same result by tm-transform" {
  tm-align --reference one.ply --write-matrix motion.txt --no-provenance two.ply -o placed.ply
  tm-transform --matrix motion.txt --no-provenance two.ply | cmp - placed.ply
}

@test "any number of threads gives the same bytes" {
  for threads in 1 3; do
    tm-align --reference one.ply --threads $threads --write-matrix $threads.txt two.ply -o $threads.ply
  done
  cmp 1.ply 3.ply
  cmp 1.txt 3.txt
}

@test "a ball on a ball is reported as undetermined" {
  tm-shape sphere --faces 3000 -o ball.ply
  tm-transform --translate 0.1,0,0 ball.ply -o moved.ply
  run --separate-stderr tm-align --reference ball.ply moved.ply -o placed.ply
  assert_status 0
  [[ $stderr == *"slide along each other"* ]]
  tm-compare --reference ball.ply --within 0.02 placed.ply
}

@test "an early stop or a bad fit is reported, and the advice helps" {
  run --separate-stderr tm-align --reference one.ply --iterations 1 two.ply -o placed.ply --report r.json
  assert_status 0
  if [ "$(jq .result.converged r.json)" = false ]; then [[ $stderr == *"--iterations"* ]]; fi
  tm-transform --rotate 0,0,1,180 two.ply | tm-select --box -9,-9,-9,9,9,0 -o far.ply
  run --separate-stderr tm-align --reference one.ply far.ply -o placed.ply
  assert_status 0
}

@test "an inverted ball is refused, and its advice helps" {
  tm-shape sphere --faces 500 -o ball.ply
  tm-stitch --flip ball.ply -o inside.ply
  run --separate-stderr tm-align --reference ball.ply inside.ply -o placed.ply
  assert_status 4
  one_line "$stderr"
  [[ $stderr == *"inside out"* ]]
  [ ! -e placed.ply ]
  tm-stitch --flip inside.ply | tm-align --reference ball.ply -o placed.ply
}

@test "points align with points and with meshes" {
  tm-sample --count 3000 two.ply -o points.ply
  for reference in one.ply "--points"; do
    if [ "$reference" = --points ]; then
      tm-sample --count 20000 one.ply -o dense.ply
      reference=dense.ply
    fi
    tm-align --reference "$reference" --write-matrix motion.txt points.ply -o placed.ply
    tm-transform --matrix motion.txt two.ply -o moved.ply
    tm-shape dented --faces 20000 |
      tm-compare --reference - moved.ply | awk '/^hausdorff_to_reference/ { exit !($2 < 0.05) }'
  done
}

@test "empty and flat meshes are refused by name" {
  printf 'OFF\n0 0 0\n' >empty.off
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n' >flat.off
  for name in empty flat; do
    run --separate-stderr tm-align --reference one.ply "$name.off"
    assert_status 3
    one_line "$stderr"
    run --separate-stderr tm-align --reference "$name.off" one.ply
    assert_status 3
    one_line "$stderr"
  done
}
