load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >closed.ply
}

@test "tm-checkmanifold: a closed mesh passes, and its report says so" {
  run tm-checkmanifold --closed closed.ply
  assert_status 0
  [[ $output == "manifold: true
oriented: true
closed: true
nonmanifold_edges: 0"*"components: 1
genus: 0" ]]
}

@test "tm-checkmanifold: a border is a problem with --closed only" {
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >open.off
  run tm-checkmanifold open.off
  assert_status 0
  [[ $output == *"closed: false"*"boundary_loops: 1"* ]]
  run tm-checkmanifold --closed open.off
  assert_status 1
  [[ $output == *"problem: the edge from vertex 0 at (0, 0, 0) to vertex 1 at (1, 0, 0) of face 0 has only one face (the first of 3 such edges); close holes with tm-fill" ]]
}

@test "tm-checkmanifold: places of bad edges, vertices, faces and orientation are reported" {
  points='0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n'
  printf "OFF\n5 3 0\n${points}3 0 1 2\n3 1 0 3\n3 0 1 4\n" >edge.off
  run tm-checkmanifold edge.off
  assert_status 1
  [[ $output == *"manifold: false"*"nonmanifold_edges: 1"*"of face 0 has more than two faces"* ]]

  printf "OFF\n5 2 0\n${points}3 0 1 2\n3 0 3 4\n" >vertex.off
  run tm-checkmanifold vertex.off
  assert_status 1
  [[ $output == *"nonmanifold_vertices: 1"*"vertex 0 at (0, 0, 0) do not form one umbrella"* ]]

  printf "OFF\n5 2 0\n${points}3 0 1 2\n3 0 1 3\n" >alike.off
  run tm-checkmanifold alike.off
  assert_status 1
  [[ $output == *"manifold: true"*"oriented: false"*"misoriented_edges: 1"*"in the same direction"* ]]

  printf "OFF\n5 1 0\n${points}3 2 1 2\n" >twice.off
  run tm-checkmanifold twice.off
  assert_status 1
  [[ $output == *"collapsed_faces: 1"*"face 0 uses a vertex twice"* ]]
}

@test "tm-checkmanifold: faces without area are counted exactly and decide nothing" {
  printf 'OFF\n4 2 0\n0 0 0\n1 1 1\n3 3 3\n0 1 0\n3 0 1 2\n3 1 0 3\n' >flat.off
  run tm-checkmanifold flat.off
  assert_status 0
  [[ $output == *"degenerate_faces: 1"* ]]
}

@test "tm-checkmanifold: --pass hands a good mesh on and fails the pipe on a bad one" {
  tm-convert --no-provenance closed.ply >expected.ply
  tm-checkmanifold --closed --pass --no-provenance closed.ply >passed.ply
  cmp expected.ply passed.ply
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >open.off
  run --separate-stderr tm-checkmanifold --closed --pass open.off
  assert_status 1
  [ -z "$output" ]
  one_line "$stderr"
  [[ $stderr == "tm-checkmanifold: "*"only one face"* ]]
  pipe 'tm-checkmanifold --closed --pass open.off | cat'
  assert_status 1
}

@test "tm-checkmanifold: real meshes with known defects" {
  needs_shared meshes/geometry-central/fan3.obj
  run tm-checkmanifold "$shared_file"
  assert_status 1
  [[ $output == *"nonmanifold_edges: 1"* ]]
  needs_shared meshes/geometry-central/hourglass_ico.obj
  run tm-checkmanifold "$shared_file"
  assert_status 1
  [[ $output == *"nonmanifold_edges: 0"*"nonmanifold_vertices: 1"* ]]
  needs_shared meshes/geometry-central/moebius.obj
  run tm-checkmanifold "$shared_file"
  assert_status 1
  [[ $output == *"manifold: true"*"oriented: false"*"boundary_loops: 1"* ]]
}

# certified INPUT OUTPUT [OPTION...]: checks that the certificate of OUTPUT holds.
certified() {
  run tm-checkmanifold --certify "$@"
  assert_status 0
  [[ $output == *"winding: tested"*"wrong_samples: 0"* ]] || fail "$output"
  [[ $output != *"problem:"* ]]
}

# refused TEXT INPUT OUTPUT [OPTION...]: checks that the certificate of OUTPUT fails, and that the problem
# contains TEXT.
refused() {
  local text=$1
  shift
  run tm-checkmanifold --certify "$@"
  assert_status 1
  [[ $output == *"problem: "*"$text"* ]] || fail "$output"
}

# Two intersecting balls and their union; a small ball.
balls() {
  tm-shape two-spheres --faces 2000 -o crossing.ply
  tm-clean crossing.ply -o union.ply
  tm-shape sphere --radius 0.2 --faces 100 -o small.ply
}

# edit AWK-PROGRAM < MESH: changes lines of ASCII OFF.
edit() {
  tm-convert --format off | awk "$1"
}

@test "tm-checkmanifold: --certify holds for tm-clean on every workload, in floats and doubles" {
  local kind scalar
  for kind in two-spheres folded tangle "dumbbell --neck -0.1" many-spheres boxes pinch; do
    for scalar in --float --double; do
      # shellcheck disable=SC2086
      tm-shape $kind --faces 2000 $scalar -o in.ply
      tm-clean in.ply -o out.ply
      certified in.ply out.ply
    done
  done
}

@test "tm-checkmanifold: --certify reads the mesh from a pipe and passes it on" {
  balls
  pipe 'tm-clean crossing.ply | tm-checkmanifold --closed --intersections --certify crossing.ply'
  assert_status 0
  pipe 'tm-clean crossing.ply | tm-checkmanifold --certify crossing.ply --pass | cmp - <(
    tm-checkmanifold --certify crossing.ply --pass union.ply)'
  assert_status 0
  run --separate-stderr tm-checkmanifold --certify crossing.ply --pass crossing.ply
  assert_status 1
  [ -z "$output" ]
  one_line "$stderr"
}

@test "tm-checkmanifold: --certify finds a flipped face and a flipped component" {
  balls
  edit '$1 == 3 && !done { t = $2; $2 = $3; $3 = t; done = 1 } { print }' <union.ply >wrong.off
  refused "in the same direction" crossing.ply wrong.off
  [[ $output != *"wrong_samples: 0"* ]]
  tm-cat union.ply <(tm-shape sphere --center 9,0,0 --faces 100) -o right.ply
  tm-cat union.ply <(tm-shape sphere --center 9,0,0 --faces 100 | tm-stitch --flip) -o wrong.ply
  refused "the winding number is -1 and should be 1: that of the input is 1" right.ply wrong.ply
}

@test "tm-checkmanifold: --certify finds a dropped component and one too many" {
  balls
  tm-cat crossing.ply <(tm-shape sphere --center 9,0,0 --faces 100) -o more.ply
  refused "the winding number is 0 and should be 1" more.ply union.ply
  [[ $output == *"of the input, at (8."* || $output == *"of the input, at (9."* ]]
  tm-clean more.ply -o more-clean.ply
  refused "the winding number is 1 and should be 0" crossing.ply more-clean.ply
}

@test "tm-checkmanifold: --certify finds a crossing pair" {
  balls
  refused "pairs of faces intersect" crossing.ply crossing.ply
  [[ $output != *"wrong_samples: 0"* ]]
}

@test "tm-checkmanifold: --certify finds a wrong sheet, and knows winding levels" {
  balls
  tm-clean --level 2 crossing.ply -o inner.ply
  refused "should be 1" crossing.ply inner.ply
  certified crossing.ply inner.ply --level 2
  refused "the winding number is 1 and should be 0: that of the input is 1" \
    crossing.ply union.ply --level 2
  tm-cat <(tm-shape sphere --faces 500) small.ply -o nested.ply
  refused "the winding number is 2 and should be 1: that of the input is 2" nested.ply nested.ply
}

@test "tm-checkmanifold: --certify finds a cavity inverted or filled" {
  balls
  tm-shape sphere --faces 500 -o ball.ply
  tm-stitch --flip small.ply | tm-cat ball.ply - -o hollow.ply
  certified hollow.ply hollow.ply
  tm-cat ball.ply small.ply -o inverted.ply
  refused "the winding number is 2 and should be 0" hollow.ply inverted.ply
  refused "the winding number is 1 and should be 0" hollow.ply ball.ply
}

@test "tm-checkmanifold: --certify finds a moved vertex" {
  balls
  edit 'NF == 3 && ++n == 6 { $1 += 1e-6 } { print }' <union.ply >moved.off
  refused "winding number" crossing.ply moved.off
  [[ $output != *"wrong_samples: 0"* ]]
}

@test "tm-checkmanifold: --certify tests pieces where the input is open" {
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >open.off
  printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n.5 .5 0\n3 0 1 3\n3 0 3 2\n' >pieces.off
  run tm-checkmanifold --certify open.off pieces.off
  assert_status 0
  [[ $output == *"winding: not tested, the input is open"*"certified_samples: 2"* ]]
  sed 's/^.5 .5 0/.5 .5 .1/' pieces.off >bent.off
  run tm-checkmanifold --certify open.off bent.off
  assert_status 1
  [[ $output == *"problem: face 0, at (0, 0, 0), is not part of an input face"* ]]
}

@test "tm-checkmanifold: --certify needs its input, and --level needs --certify" {
  run tm-checkmanifold --certify absent.ply closed.ply
  assert_status 3
  run tm-checkmanifold --level 2 closed.ply
  assert_status 2
  [[ $output == *"--level needs --certify"* ]]
}

@test "tm-checkmanifold: cracks are distinguished from holes, and the advice closes them" {
  tm-shape sphere --faces 500 --double -o ball.ply
  # Each face has corners of its own, up to 1e-6 from those of its neighbors.
  tm-convert --format off ball.ply | grep -v '^#' | awk 'BEGIN { srand(1); faces = 0 }
    NR == 2 { count = $1 }
    NR > 2 && NR <= 2 + count { for (i = 1; i < 4; ++i) place[NR - 3, i] = $i }
    NR > 2 + count { for (c = 2; c < 5; ++c) corner[faces, c] = $c; ++faces }
    END {
      print "OFF\n" 3 * faces, faces, 0
      for (f = 0; f < faces; ++f) for (c = 2; c < 5; ++c)
        printf "%.17g %.17g %.17g\n", place[corner[f, c], 1] + 1e-6 * rand(),
          place[corner[f, c], 2] + 1e-6 * rand(), place[corner[f, c], 3] + 1e-6 * rand()
      for (f = 0; f < faces; ++f) print 3, 3 * f, 3 * f + 1, 3 * f + 2
    }' >cracked.off
  run --separate-stderr tm-checkmanifold --closed --get problem cracked.off
  [ "$status" -eq 1 ]
  [[ $output == *"; borders nearly meet along cracks of up to "*": tm-stitch --tolerance "*" joins them" ]] || fail "$output"
  width=$(sed 's/.*--tolerance \([^ ]*\) .*/\1/' <<<"$output")
  tm-stitch --tolerance "$width" cracked.off | tm-checkmanifold --closed
  # A hole is not a crack.
  tm-select --box -2,-2,-2,2,2,0.8 ball.ply -o bowl.ply
  run --separate-stderr tm-checkmanifold --closed --get problem bowl.ply
  [[ $output == *"; close holes with tm-fill" ]]
}
