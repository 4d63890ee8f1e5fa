#!/usr/bin/env bats
# The targets of the paper's authors. A sphere around each is morphed until it has the components, the
# genus, and a two-way Hausdorff distance below one mean edge.
load ../helpers/common

# morphs NAME FACES COMPONENTS GENUS
morphs() {
  needs_shared "meshes/transformesh/$1.off"
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --around "$shared_file" --faces "$2" -o source.ply
  tm-morph -q source.ply --target "$shared_file" -o result.ply --report report.json
  grep -q '"converged": true' report.json
  [ "$(tm-info --get components result.ply)" = "$3" ]
  [ "$(tm-info --get genus result.ply)" = "$4" ]
  tm-checkmanifold --closed --intersections result.ply
  tm-compare --reference "$shared_file" --within "$(tm-info --get edge_mean result.ply)" result.ply
}

@test "Genus 3" { morphs genus3 6800 1 3; }
@test "Thoruses" { morphs two-thoruses 6300 2 2; }
