# The pipelines of tm-repair(7) on broken real meshes.
load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# repaired MESSAGE FILE: the file has that problem, and is a solid afterwards.
repaired() {
  needs_shared "meshes/$2"
  run tm-checkmanifold --closed --intersections "$shared_file"
  assert_status 1
  [[ $output == *"$1"* ]] || fail "$output"
  tm-stitch -q --orient "$shared_file" | tm-fill -q --allow-crossings |
    tm-clean -q --outermost -o solid.ply
  tm-checkmanifold --closed --intersections solid.ply
}

# has_volume REFERENCE: that of the solid is within 1 %.
has_volume() {
  awk -v is="$(tm-info --get volume solid.ply)" -v is_to_be="$1" \
    'BEGIN { exit !(is > 0.99 * is_to_be && is < 1.01 * is_to_be) }' || fail "volume, not $1"
}

@test "an open figure of parts that end within each other: pig" {
  repaired "no face across" cgal/pig.stl
}

@test "holes whose patches cross: elephant-with-holes, against the elephant" {
  repaired "no face across" cgal/elephant-with-holes.off
  needs_shared meshes/cgal/elephant.off
  has_volume "$(tm-info --get volume "$shared_file")"
}

@test "a hole and many crossings: mannequin-devil" {
  repaired "no face across" cgal/mannequin-devil.off
}

@test "faces that look this way and that: blobby-shuffled, against blobby" {
  repaired "the same way" cgal/blobby-shuffled.off
  needs_shared meshes/cgal/blobby.off
  has_volume "$(tm-info --get volume "$shared_file")"
}

@test "a soup, inside out: multibody" {
  repaired "no face across" trimesh/multibody.stl
}

@test "parts that cross: rabbit" {
  repaired "" trimesh/rabbit.obj
}

@test "cubes become solids of volume 2" {
  repaired "" cgal/cubes.off
  has_volume 2
}

@test "a knot that crosses itself: knot-1000" {
  repaired "" transformesh/knot-1000.off
}
