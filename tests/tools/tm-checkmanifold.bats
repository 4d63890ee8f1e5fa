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
  [[ $output == *"problem: the edge from vertex 0 at (0, 0, 0) to vertex 1 at (1, 0, 0) of face 0 has no face across (the first of 3 such edges)" ]]
}

@test "tm-checkmanifold: it says where edges, vertices, faces and orientation are wrong" {
  points='0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n'
  printf "OFF\n5 3 0\n${points}3 0 1 2\n3 1 0 3\n3 0 1 4\n" >edge.off
  run tm-checkmanifold edge.off
  assert_status 1
  [[ $output == *"manifold: false"*"nonmanifold_edges: 1"*"of face 0 has more than two faces"* ]]

  printf "OFF\n5 2 0\n${points}3 0 1 2\n3 0 3 4\n" >vertex.off
  run tm-checkmanifold vertex.off
  assert_status 1
  [[ $output == *"nonmanifold_vertices: 1"*"vertex 0 at (0, 0, 0) are not one fan"* ]]

  printf "OFF\n5 2 0\n${points}3 0 1 2\n3 0 1 3\n" >alike.off
  run tm-checkmanifold alike.off
  assert_status 1
  [[ $output == *"manifold: true"*"oriented: false"*"misoriented_edges: 1"*"the same way"* ]]

  printf "OFF\n5 1 0\n${points}3 2 1 2\n" >twice.off
  run tm-checkmanifold twice.off
  assert_status 1
  [[ $output == *"collapsed_faces: 1"*"face 0 names a vertex twice"* ]]
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
  [[ $stderr == "tm-checkmanifold: "*"no face across"* ]]
  pipe 'tm-checkmanifold --closed --pass open.off | cat'
  assert_status 1
}

@test "tm-checkmanifold: known meshes of others" {
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
