load ../helpers/common

# square Z: prints two triangles at that height, as OFF.
square() {
  printf 'OFF\n4 2 0\n0 0 %s\n3 0 %s\n3 4 %s\n0 4 %s\n3 0 1 2\n3 0 2 3\n' "$1" "$1" "$1" "$1"
}

setup() {
  cd "$BATS_TEST_TMPDIR"
  square 0 >low.off
  square 0.5 >high.off
}

@test "tm-compare: parallel squares, every key in its order" {
  pipe 'tm-compare --reference low.off high.off'
  assert_status 0
  [ "$output" = "accuracy: 0.5
completeness: 0
mean: 0.5
rms: 0.5
hausdorff: 0.5
hausdorff_to_reference: 0.5
hausdorff_from_reference: 0.5
volume_difference: 0" ]
}

@test "tm-compare: --within answers by exit code, relative to the reference's diagonal" {
  # The diagonal of the reference is 5: 9 % are 0.45, 11 % are 0.55.
  run tm-compare --reference low.off --within 11% high.off
  assert_status 0
  run tm-compare --reference low.off --within 9% high.off
  assert_status 1
  [[ $output == *"hausdorff: 0.5"* ]]
  run tm-compare --reference low.off --within 0.5 high.off
  assert_status 0
}

@test "tm-compare: --distance decides what is complete" {
  pipe 'tm-compare --reference low.off --distance 11% high.off | grep completeness'
  [ "$output" = "completeness: 1" ]
  pipe 'tm-compare --reference low.off --distance 0.49 high.off | grep completeness'
  [ "$output" = "completeness: 0" ]
}

@test "tm-compare: the reference is needed" {
  run --separate-stderr tm-compare high.off
  assert_status 2
  one_line "$stderr"
  [[ $stderr == *"--reference"* ]]
  run --separate-stderr tm-compare --reference absent.off high.off
  assert_status 3
  [[ $stderr == *"absent.off"* ]]
}

@test "tm-compare: points as reference, and an empty one" {
  printf 'OFF\n1 0 0\n0 0 2\n' >point.off
  pipe 'tm-compare --reference point.off low.off | grep hausdorff_from_reference'
  assert_status 0
  [ "$output" = "hausdorff_from_reference: 2" ]
  printf 'OFF\n0 0 0\n' >empty.off
  run --separate-stderr tm-compare --reference empty.off low.off
  assert_status 3
  [[ $stderr == *"no vertices"* ]]
}

@test "tm-compare: same seed and any threads, same bytes; another seed, other points" {
  tm-shape torus --faces 3000 >torus.ply
  tm-shape sphere --faces 1000 >sphere.ply
  tm-compare --reference sphere.ply --threads 1 --samples 5000 torus.ply >one
  tm-compare --reference sphere.ply --threads 4 --samples 5000 torus.ply >four
  tm-compare --reference sphere.ply --seed 2 --samples 5000 torus.ply >other
  cmp one four
  ! cmp -s one other
}

@test "tm-compare: --per-vertex writes the mesh with distances, the report stays" {
  tm-compare --reference low.off high.off >usual
  tm-compare --reference low.off --per-vertex far.ply high.off >report
  cmp usual report
  tm-convert --format ply-ascii far.ply >far.txt
  grep -q 'property double distance' far.txt
  grep -q 'comment tm-compare' far.txt
  [ "$(awk '/^end_header/ { inside = 1; next } inside && NF == 4 && $4 == 0.5' far.txt | wc -l)" -eq 4 ]
  run --separate-stderr tm-compare --reference low.off --per-vertex - high.off
  assert_status 2
  run --separate-stderr tm-compare --reference low.off --per-vertex far.off high.off
  assert_status 0
  [[ $stderr == *"'distance'"* ]]
  run --separate-stderr tm-compare --reference low.off --per-vertex absent/far.ply high.off
  assert_status 5
}

@test "tm-compare: two files, and one key" {
  tm-compare --reference low.off high.off >named
  tm-compare high.off low.off | cmp - named
  [ "$(tm-compare --get hausdorff high.off low.off)" = 0.5 ]
  run --separate-stderr tm-compare --get housedorf high.off low.off
  assert_status 2
  [[ $stderr == *"accuracy, completeness"* ]]
  run --separate-stderr tm-compare --reference low.off high.off low.off
  assert_status 2
  one_line "$stderr"
  run --separate-stderr tm-compare low.off high.off low.off
  assert_status 2
  one_line "$stderr"
}

@test "tm-compare: --signed says if signs can be wrong, and joins a soup" {
  tm-shape box --float -o box.ply
  tm-shape sphere --faces 500 --radius 0.6 -o ball.ply
  tm-compare --signed --per-vertex d.ply ball.ply box.ply >/dev/null
  tm-compare -q --signed --per-vertex soup.ply ball.ply <(tm-convert --format stl box.ply) >/dev/null
  cmp d.ply soup.ply
  tm-stitch -q --flip box.ply -o flipped.ply
  run --separate-stderr tm-compare --signed --per-vertex e.ply ball.ply flipped.ply
  assert_status 3
  [[ $stderr == *"the reference is inside out; reverse it with tm-stitch --flip"* ]] || fail "$stderr"
  [ ! -e e.ply ]
  tm-select --box -2,-2,-2,2,2,0.2 box.ply -o open.ply
  run --separate-stderr tm-compare --signed --per-vertex e.ply ball.ply open.ply
  assert_status 0
  [[ $stderr == *"signs of distances from the reference can be wrong: the edge"*"close holes with tm-fill" ]] || fail "$stderr"
  run --separate-stderr tm-compare ball.ply flipped.ply
  [ -z "$stderr" ]
}

@test "tm-compare: --signed is negative inside" {
  tm-shape sphere --faces 500 --radius 1 -o outer.ply
  tm-shape sphere --faces 500 --radius 0.5 -o inner.ply
  signs() { tm-convert --format ply-ascii "$1" | awk '/^end_header/ { i = 1; next } i && NF == 4 && $1 != 3 { print ($4 < 0) }' | sort -u; }
  tm-compare --signed --per-vertex d.ply inner.ply outer.ply >/dev/null
  [ "$(signs d.ply)" = 1 ]
  tm-compare --signed --per-vertex d.ply outer.ply inner.ply >/dev/null
  [ "$(signs d.ply)" = 0 ]
  run --separate-stderr tm-compare --signed outer.ply inner.ply
  assert_status 2
}
