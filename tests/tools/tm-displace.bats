load ../helpers/common

setup() { cd "$BATS_TEST_TMPDIR"; }

# value KEY FILE: prints a number of a report.
value() {
  awk -v key="\"$1\":" '$1 == key { gsub(",", "", $2); print $2 }' "$2"
}

# A tetrahedron with the same velocity at every vertex.
moving_tetrahedron() { # VX VY VZ
  tetrahedron | awk -v velocity="$*" '
    { print (body && n-- > 0 ? $0 " " velocity : $0) }
    /^element vertex/ { n = $3 }
    /^property double z/ { print "property float vx\nproperty float vy\nproperty double vz" }
    /^end_header/ { body = 1 }'
}

@test "vertices move by time step times velocity, and velocities stay" {
  moving_tetrahedron 0.25 0 -0.125 >in.ply
  pipe "tm-displace --time-step 2 --alpha 10 --report r.json in.ply | tail -n 8 | head -n 4"
  assert_status 0
  [ "${lines[0]}" = "0.5 0 -0.25 0.25 0 -0.125" ]
  [ "${lines[3]}" = "0.5 1 0.75 0.25 0 -0.125" ]
  [ "$(value moved r.json)" -eq 4 ]
  [ "$(value clamped r.json)" -eq 0 ]
}

@test "movements are clamped to alpha times the mean edge at the vertex" {
  moving_tetrahedron 0 0 100 >in.ply
  pipe "tm-displace -q --alpha 0.5 --report r.json in.ply | tail -n 8 | head -n 1"
  assert_status 0
  # The clamp is half of the edge, which has length sqrt(2).
  [[ $output == "0 0 0.7071067811865476 "* || $output == "0 0 0.7071067811865475 "* ]]
  [ "$(value clamped r.json)" -eq 4 ]
  run --separate-stderr tm-displace --alpha 0.5 in.ply -o out.ply
  [ "$stderr" = "tm-displace: movements of 4 of 4 vertices are clamped to 0.5 of the mean edge at the vertex; the largest movement is 0.707; use a smaller --time-step, or a larger --alpha" ]
  run --separate-stderr tm-displace --alpha 200 in.ply -o out.ply
  [ -z "$stderr" ]
}

@test "--normal-speed grows and shrinks along the normals, and adds to the columns" {
  tetrahedron >in.ply
  before=$(tm-info --get volume in.ply)
  for sign in '' -; do
    after=$(tm-displace --normal-speed "${sign}0.01" in.ply | tm-info --get volume)
    awk -v b="$before" -v a="$after" -v s="${sign}1" 'BEGIN { exit !((a - b) * s > 0) }' ||
      fail "volume $before became $after"
  done
  moving_tetrahedron 0 0 0 | tm-displace --no-provenance --normal-speed 0.01 >sum.ply
  tm-displace --no-provenance --normal-speed 0.01 in.ply >alone.ply
  cmp <(tm-convert --no-provenance --format off sum.ply 2>/dev/null) \
    <(tm-convert --no-provenance --format off alone.ply)
}

@test "--mask holds vertices fast" {
  moving_tetrahedron 0.25 0 0 >in.ply
  pipe "sed 's/property double vz/&\nproperty uchar free/; s/^0 1 1 .*/& 1/; s/ 0.25 0 0$/& 0/' in.ply |
    tm-displace --mask free --report r.json | tail -n 8 | head -n 4"
  assert_status 0
  [[ ${lines[2]} == "1 0 1 "* && ${lines[3]} == "0.25 1 1 "* ]]
  [ "$(value moved r.json)" -eq 1 ]
}

@test "missing and impossible velocities are exit 3 and name what is wrong" {
  tetrahedron >in.ply
  run --separate-stderr tm-displace in.ply
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"vx vy vz"* && $stderr == *--normal-speed* ]]
  moving_tetrahedron 0 nan 0 >nan.ply
  run --separate-stderr tm-displace nan.ply
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"vertex 0 at (0, 0, 0)"* ]]
  run --separate-stderr tm-displace --normal-speed 1 --mask free in.ply
  assert_status 3
  [[ $stderr == *"'free'"* ]]
}

@test "under mean-curvature flow a dumbbell pinches off and its balls part" {
  tm-shape dumbbell --neck 0.1 --faces 1500 -o a.ply
  for _ in $(seq 60); do
    tm-displace -q --curvature-speed 0.0008 a.ply | tm-clean -q | tm-remesh -q -o b.ply
    mv b.ply a.ply
    components=$(tm-info --get components a.ply)
    [ "$components" -eq 1 ] || break
  done
  [ "$components" -eq 2 ]
  tm-intersect --check a.ply
  # Both balls are left; only the neck vanished.
  awk -v v="$(tm-info --get volume a.ply)" 'BEGIN { exit !(v > 0.3) }'
}

@test "a step beyond the precision of coordinates is refused, in floats too" {
  tm-shape sphere --faces 320 --format ply-ascii | awk '
    /^element vertex/ { n = $3 }
    /^element face/ { print "property double vx\nproperty double vy\nproperty double vz" }
    inside && n-- > 0 { print $0, 1e20, 0, 0; next }
    /^end_header/ { inside = 1 }
    { print }' >far.ply
  run --separate-stderr tm-displace --alpha 1e30 far.ply -o out.ply
  assert_status 4
  one_line "$stderr"
  [ ! -e out.ply ]
  tm-displace far.ply | tm-checkmanifold --closed >/dev/null
  tm-shape sphere --faces 320 --center 1e10,0,0 -o off.ply
  tm-displace --normal-speed 0.01 off.ply | tm-checkmanifold --closed >/dev/null
  run --separate-stderr tm-displace --normal-speed 0.01 --float off.ply -o out.ply
  assert_status 4
  one_line "$stderr"
}
