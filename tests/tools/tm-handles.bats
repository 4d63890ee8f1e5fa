#!/usr/bin/env bats
load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

@test "a ring becomes a rod where its tube is thinner than --max-length, and only there" {
  # The loop around the tube is 1.9 long, and along edges up to a seventh longer.
  tm-shape torus --tube 0.3 --faces 4000 -o ring.ply
  tm-handles -q --max-length 1.7 ring.ply -o still.ply
  [ "$(tm-info --get genus still.ply)" = 1 ]
  tm-handles --max-length 2.3 --report r.json ring.ply -o rod.ply
  [ "$(tm-info --get genus rod.ply)" = 0 ]
  tm-checkmanifold --closed --intersections rod.ply
  jq -e '.result | .removed == 1 and .refused == 0 and .genus == 0 and .max_length == 2.3' r.json
}

@test "handles made by self-intersections vanish by cleaning, and components stay" {
  tm-shape folded torus --faces 20000 | tm-clean -q -o tied.ply
  before=$(tm-info --get genus tied.ply)
  [ "$before" -gt 0 ]
  tm-handles -q --max-length 20% tied.ply | tm-clean -q | tm-remesh -q -o untied.ply
  tm-checkmanifold --closed --intersections untied.ply
  [ "$(tm-info --get genus untied.ply)" -lt "$before" ]
  tm-compare --json --reference tied.ply untied.ply | jq -e '.volume_difference | fabs < 0.01'
}

@test "by default five mean edges are the most, by the comment where there is one" {
  tm-shape torus --tube 0.3 --faces 4000 -o ring.ply
  edge=$(tm-info --get edge_mean ring.ply)
  tm-handles -q --report r.json ring.ply -o same.ply
  jq -e --argjson edge "$edge" '.result | (.max_length / $edge - 5 | fabs) < 0.01 and .removed == 0' r.json
  tm-handles -q --reference-edge 0.48 --report r.json ring.ply -o rod.ply
  jq -e '.result | .max_length == 2.4 and .removed == 1' r.json
}

@test "an open mesh is refused with what mends it, and nothing is written" {
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >open.off
  run --separate-stderr tm-handles open.off -o out.off
  assert_status 3
  [[ $stderr == *"handles are removed only from closed oriented manifolds, but "*"tm-fill"* ]]
  [ ! -e out.off ]
  run --separate-stderr tm-handles --max-length 0 open.off
  assert_status 2
}

@test "a sealed cavity stays sealed, and what is left is said" {
  # A hollow ring. The loops around its two tubes lie at different angles.
  tm-shape torus --tube 0.3 --faces 4000 -o ring.ply
  tm-shape torus --tube 0.15 --faces 2000 | tm-transform --rotate 0,0,1,50 | tm-stitch --flip -o cavity.ply
  tm-cat ring.ply cavity.ply -o hollow.ply
  [ "$(tm-clean -q hollow.ply | tm-info --get components -)" = 2 ]
  run --separate-stderr tm-handles --max-length 100% --report r.json -o untied.ply hollow.ply
  assert_status 0
  [[ $stderr == *"would open a cavity"* ]]
  jq -e '.result | .blocked > 0 and .removed == 1' r.json
  [ "$(tm-clean -q untied.ply | tm-info --get components -)" = 2 ]
}
