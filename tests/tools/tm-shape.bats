# Generated shapes and their options. tests/lib/shapes tests the shapes themselves.

load ../helpers/common

# refused TEXT COMMAND...: checks for exit code 2, an empty stdout, and one line on stderr that contains
# TEXT.
refused() {
  local text=$1
  shift
  run --separate-stderr "$@"
  assert_status 2
  [ -z "$output" ] || fail "output despite the error"
  one_line "$stderr"
  [[ $stderr == "tm-shape: "*"$text"* ]] || fail "'$text' is not in: $stderr"
}

header_of() {
  head -c 400 "$1" | sed '/^end_header/q' | tr -d '\0'
}

faces_of() {
  header_of "$1" | sed -n 's/^element face //p'
}

setup() {
  cd "$BATS_TEST_TMPDIR"
}

@test "the default is binary little endian PLY with double coordinates and nothing else" {
  tm-shape sphere --faces 320 >sphere.ply
  run header_of sphere.ply
  [ "$output" = "ply
format binary_little_endian 1.0
comment tm-shape $(tm-shape --version | cut -d' ' -f2) sphere --faces 320
element vertex 162
property double x
property double y
property double z
element face 320
property list uchar int vertex_indices
end_header" ] || fail "$output"
}

@test "every kind of the manual works with its default, into a pipe too" {
  for kind in sphere dented ellipsoid box torus genus torus-knot two-spheres tori dumbbell bowl figure \
    folded tangle many-spheres boxes pinch; do
    grep -qE "^\*\*$kind\*\*" "$tm_root/man/tm-shape.1.md" || fail "$kind is not in the manual"
    pipe "tm-shape $kind --faces 1200 | tm-convert --format off | head -n 1"
    [ "$output" = OFF ] || fail "$kind: $output"
  done
}

@test "the same options give the same bytes, another seed others" {
  tm-shape folded --seed 7 >first.ply
  tm-shape folded --seed 7 >second.ply
  tm-shape folded --seed 8 --no-provenance >third.ply
  tm-shape folded --seed 7 --no-provenance >fourth.ply
  cmp first.ply second.ply
  run cmp third.ply fourth.ply
  assert_status 1
}

@test "lengths in % are of the shape, or of the box to go around" {
  tm-shape torus -o torus.ply
  tm-shape torus --edge 1% -o fine.ply
  tm-shape torus --edge 2% -o coarse.ply
  tm-shape sphere --edge 2% --around torus.ply -o around.ply
  awk -v fine="$(faces_of fine.ply)" -v coarse="$(faces_of coarse.ply)" \
    'BEGIN { exit !(fine / coarse > 3.9 && fine / coarse < 4.1) }' || fail "$(faces_of fine.ply)"
  [ "$(faces_of around.ply)" -gt 1000 ]
}

@test "negative lengths are values, not options" {
  tm-shape two-spheres --gap -0.2 -o overlapping.ply
  tm-shape dumbbell --neck=-0.1 -o inverted.ply
}

@test "an unknown kind is refused with the nearest" {
  refused "did you mean 'sphere'?" tm-shape shpere
  refused "did you mean 'torus-knot'?" tm-shape torus_knot
  refused "KIND" tm-shape
}

@test "bad parameters are refused in one clear line" {
  refused "common factor" tm-shape torus-knot 2 4
  refused "2 parameters" tm-shape torus-knot 2
  refused "'0' is not an integer" tm-shape genus 0
  refused "too few" tm-shape genus 8 --faces 500
  refused "'2' is not a number from 0 to 1" tm-shape figure 2
  refused "--radius" tm-shape sphere --radius -1
  refused "radius must be positive" tm-shape sphere --radius 0
  refused "dumbbell" tm-shape sphere --neck 0.1
  refused "give one of them" tm-shape sphere --faces 100 --edge 0.1
  refused "10^9" tm-shape sphere --edge 1e-7
  refused "x" tm-shape sphere --edge 0.7x
  tm-shape torus -o torus.ply
  refused "around makes a sphere" tm-shape torus --around torus.ply
}

@test "a file to go around that is missing or empty is bad input" {
  run --separate-stderr tm-shape sphere --around missing.ply
  assert_status 3
  one_line "$stderr"
}

@test "--tube is the radius of a torus's tube, --count the number of spheres or boxes" {
  thick=$(tm-shape torus --radius 2 --tube 0.5 --faces 20000 | tm-info --get volume)
  thin=$(tm-shape torus --radius 2 --tube 0.25 --faces 20000 | tm-info --get volume)
  # The volume is 2 pi^2 R r^2, less the parts that are cut off between vertices.
  awk -v thick="$thick" -v thin="$thin" 'BEGIN {
    pi = atan2(0, -1)
    exit !(thick < pi * pi && thick > 0.98 * pi * pi && thin < thick / 4 && thin > 0.97 * thick / 4)
  }'
  [ "$(tm-shape many-spheres --count 7 --faces 700 | tm-info --get components)" -eq 7 ]
  [ "$(tm-shape boxes --count 5 | tm-info --get components)" -eq 5 ]
}

@test "lengths have a range, and a negative number is not taken for an option" {
  refused() { # MESSAGE KIND OPTION...
    run --separate-stderr tm-shape "${@:2}" -o out.ply
    assert_status 2
    one_line "$stderr"
    [[ $stderr == *"$1"* ]] || fail "$stderr"
    [ ! -e out.ply ]
  }
  for length in 1e308 1e51 1e-51; do
    refused 'noise must be positive, from 1e-50 to 1e50' sphere --noise $length
    refused 'edge must be positive' sphere --edge $length
    refused 'gap must be positive' two-spheres --gap $length
    refused 'tube must be positive' torus --tube $length
    for kind in sphere torus torus-knot two-spheres tangle folded; do
      refused 'radius must be positive' $kind --radius $length
    done
  done
  tm-shape sphere --noise 0 --faces 100 | tm-checkmanifold >/dev/null
  tm-shape torus --radius 1e50 --faces 1000 | tm-checkmanifold >/dev/null
  refused "unknown option '-1'; write -- before it if it is a file name" genus -1
  refused "unknown option '-.5'; write -- before it if it is a file name" ellipsoid 1 -.5 1
  run --separate-stderr tm-shape -o out.ply -- genus -1
  assert_status 2
  [[ $stderr == "tm-shape: genus: '-1' is not an integer from 1 to"* ]]
  refused 'genus takes 1 parameter, for' genus 1 2
  # The shape surrounds another mesh.
  for scale in 1e100 1e200; do
    tm-shape sphere --faces 20 --format ply-ascii |
      awk -v s=$scale 'body && NF == 3 { printf "%.17g %.17g %.17g\n", s * $1, s * $2, s * $3; next }
        /^end_header/ { body = 1 } { print }' >large.ply
    run --separate-stderr tm-shape sphere --around large.ply -o out.ply
    assert_status 3
    [[ $stderr == *"scale it"* ]]
  done
}

@test "a shape that its coordinates cannot hold is refused: too far off, too thin, or in floats" {
  for options in '--center 1e308,0,0' '--center 0,1e16,0' '--center 0,0,-1e14' '--radius 1e-20 --center 1,1,1'; do
    # shellcheck disable=SC2086
    refused "cannot represent this shape" tm-shape sphere $options
  done
  for kind in 'torus --tube 1e-17' 'torus --tube 1e-50' 'torus-knot --tube 1e-40' 'box 1e-20 1 1 --center 1,1,1' \
    'bowl --center 1e15,0,0' 'many-spheres --center 1e300,1e300,0' 'boxes --center 1e30,0,0'; do
    # shellcheck disable=SC2086
    refused "cannot represent this shape" tm-shape $kind
  done
  run --separate-stderr tm-shape sphere --center 1e9,0,0 --float -o out.ply
  assert_status 4
  one_line "$stderr"
  run --separate-stderr tm-shape sphere --radius 1e-50 --float -o out.ply
  assert_status 4
  tm-shape sphere --center 1e9,0,0 -o far.ply
  tm-checkmanifold --closed far.ply >/dev/null
  tm-intersect --check far.ply >/dev/null
  tm-shape sphere --radius 1e-20 --center 1e-10,0,0 | tm-checkmanifold --closed >/dev/null
  run --separate-stderr tm-shape sphere --around far.ply --faces 1000 -o around.ply
  assert_status 0
  for output in '--float -o out.ply' '-o out.stl'; do
    # shellcheck disable=SC2086
    run --separate-stderr tm-convert far.ply $output
    assert_status 4
    one_line "$stderr"
    [ ! -e out.ply ] && [ ! -e out.stl ]
  done
}

@test "the frames of a figure: arms that cross and let go are a handle for that time" {
  for time in 0 0.24 0.25 0.5 0.73 0.74 1; do tm-shape figure $time --faces 6000 -o "$time.ply"; done
  for time in 0 0.24 0.74 1; do [ "$(tm-info --get genus $time.ply)" -eq 0 ]; done
  for time in 0.25 0.5 0.73; do [ "$(tm-info --get genus $time.ply)" -eq 1 ]; done
  for frame in *.ply; do tm-checkmanifold --closed --intersections "$frame"; done
}

@test "cylinders and cones are closed, clean and as large as they should be" {
  while read -r kind faces volume; do
    # shellcheck disable=SC2086
    tm-shape $kind 0.5 2 --faces "$faces" -o solid.ply
    tm-checkmanifold --closed --intersections solid.ply >/dev/null
    awk -v f="$(tm-info --get faces solid.ply)" -v n="$faces" 'BEGIN { exit !(f > 0.6 * n && f < 1.2 * n + 2) }'
    awk -v v="$(tm-info --get volume solid.ply)" -v w="$volume" -v n="$faces" \
      'BEGIN { exit !(v < w && (n < 1000 || v > 0.98 * w)) }'
    [ "$(tm-info --get bbox_min solid.ply | cut -d ' ' -f 3)" = -1 ]
    [ "$(tm-info --get bbox_max solid.ply | cut -d ' ' -f 3)" = 1 ]
  done <<'TABLE'
cylinder 20 1.5707963
cylinder 500 1.5707963
cylinder 10000 1.5707963
cone 20 0.5235988
cone 500 0.5235988
cone 10000 0.5235988
TABLE
  for options in 'cylinder 1' 'cone 0 1' 'cylinder 1 -1' 'hull' 'sphere --of solid.ply' 'hull --of solid.ply --faces 9'; do
    # shellcheck disable=SC2086
    run --separate-stderr tm-shape $options
    assert_status 2
    one_line "$stderr"
  done
}

@test "a hull is convex and contains all points, by awk" {
  tm-shape torus-knot --faces 1000 -o knot.ply
  tm-shape hull --of knot.ply -o hull.ply
  tm-checkmanifold --closed --intersections hull.ply >/dev/null
  for name in hull knot; do
    # Keeps the lines after the line of counts.
    tm-convert --format off $name.ply | grep -v '^#' | tail -n +3 >$name.off
  done
  # No point is in front of a face.
  awk 'BEGIN { n = 0; m = 0 }
    NF == 3 && FILENAME == "hull.off" { x[n] = $1; y[n] = $2; z[n] = $3; ++n }
    NF == 4 && FILENAME == "hull.off" { a[m] = $2; b[m] = $3; c[m] = $4; ++m }
    NF == 3 && FILENAME == "knot.off" {
      for (f = 0; f < m; ++f) {
        ux = x[b[f]] - x[a[f]]; uy = y[b[f]] - y[a[f]]; uz = z[b[f]] - z[a[f]]
        vx = x[c[f]] - x[a[f]]; vy = y[c[f]] - y[a[f]]; vz = z[c[f]] - z[a[f]]
        d = (uy * vz - uz * vy) * ($1 - x[a[f]]) + (uz * vx - ux * vz) * ($2 - y[a[f]]) + (ux * vy - uy * vx) * ($3 - z[a[f]])
        if (d > 1e-12) exit 1
      }
      ++seen
    }
    END { exit !(m > 20 && seen > 400) }' hull.off knot.off
  printf 'OFF\n4 0 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n' >flat.off
  run --separate-stderr tm-shape hull --of flat.off
  assert_status 3
  [[ $stderr == *"one plane"* ]]
}

@test "a kind that is far from all others is not corrected into one of them" {
  run --separate-stderr tm-shape prism
  assert_status 2
  [[ $stderr == *"with --help"* ]]
  run --separate-stderr tm-shape cyllinder
  [[ $stderr == *"did you mean 'cylinder'?"* ]]
}
