# The oracle as bats files call it: which results it accepts, which faults it finds, and its exit codes.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR" || exit
  tm-shape sphere --faces 500 -o ball.ply
  tm-shape sphere --faces 500 --center 0.5,0,0 -o second.ply
  tm-shape sphere --faces 500 --center 5,0,0 -o far.ply
}

@test "a union judged right and a mere concatenation judged wrong" {
  tm-cat ball.ply far.ply -o both.ply
  run winding_oracle both.ply both.ply
  assert_status 0
  [[ $output =~ ^"tested "[0-9]+" wrong 0 undecided "[0-9]+$ ]]

  tm-cat ball.ply second.ply -o crossing.ply
  run winding_oracle crossing.ply crossing.ply --samples 500 --seed 7
  assert_status 1
  [[ $output == *"first wrong at"* ]]
}

@test "a dropped and a flipped component are found" {
  tm-cat ball.ply far.ply -o both.ply
  run winding_oracle both.ply ball.ply
  assert_status 1
  tm-stitch --flip far.ply -o flipped.ply
  tm-cat ball.ply flipped.ply -o wrong.ply
  run winding_oracle both.ply wrong.ply
  assert_status 1
}

@test "levels are distinguished" {
  tm-cat ball.ply ball.ply -o twice.ply
  run winding_oracle twice.ply ball.ply --level 2
  assert_status 0
  run winding_oracle ball.ply ball.ply --level 2
  assert_status 1
}

@test "usage is exit 2, an unreadable file exit 3" {
  run winding_oracle ball.ply
  assert_status 2
  run winding_oracle ball.ply ball.ply --levle 2
  assert_status 2
  run winding_oracle ball.ply absent.ply
  assert_status 3
}
