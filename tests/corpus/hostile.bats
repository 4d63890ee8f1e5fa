# Tiny meshes that stress rounding: two seeds of every family that is always quick. The command
# `hostile_grid --seeds 200 --jobs 2` runs all, with limits of 2 s and 200 MB.

load ../helpers/common

@test "hostile: results are right, by winding numbers with local tolerances" {
  run "$tm_build/bin-test/hostile_grid" --seeds 2 --jobs 2 --seconds 60 --megabytes 1000 --hang 100 \
    near-vertices spike far-coordinates nearly-flat stacked-plates needles-in-ball \
    tetrahedra-at-edge tetrahedra-of-magnitudes tilted-plates sliver-fan lattice-tetrahedra \
    lattice-sphere spikes denormals near-copies exact-copies far-from-origin random-sphere folded-sides
  echo "$output"
  assert_status 0
  [[ $output == *"all "*" 76 "*" 76 "* ]]
}

@test "hostile: thin sheets between the same few points, which rounding would cut anew for ever" {
  run "$tm_build/bin-test/hostile_grid" --first 139 --seeds 1 --seconds 60 near-vertices
  assert_status 0
}

@test "hostile: sheets within 256 spacings that cross at tiny angles all over" {
  run "$tm_build/bin-test/hostile_grid" --first 10 --seeds 8 --jobs 2 --seconds 60 nearly-flat
  assert_status 0
}

@test "hostile: the grid can fail: a limit that nothing keeps" {
  run "$tm_build/bin-test/hostile_grid" --seeds 1 --megabytes 0 spike
  assert_status 1
  [[ $output == *"FAILED spike 1 double"* ]]
}
