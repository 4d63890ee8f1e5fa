#!/usr/bin/env bats
load ../helpers/common

# The upper part of a ball is missing.
open_ball() {
  tm-shape sphere --faces 3000 --format off --no-provenance | awk '
    NR == 1 || /^#/ { print; next }
    !n { n = $1; f = $2; next }
    v < n { z[v] = $3; vertex[v++] = $0; next }
    NF >= 4 && !(z[$2] > 0.8 && z[$3] > 0.8 && z[$4] > 0.8) { face[m++] = $0 }
    END { print n, m, 0; for (i = 0; i < n; ++i) print vertex[i]; for (i = 0; i < m; ++i) print face[i] }'
}

# sheet SQUARES: writes a flat sheet of 6 x 6 squares without the named ones.
sheet() {
  awk -v missing=" $1 " 'BEGIN {
    for (i = 0; i < 36; ++i) if (!index(missing, " " i " ")) {
      a = i + int(i / 6)
      face[m++] = "3 " a " " a + 1 " " a + 8
      face[m++] = "3 " a " " a + 8 " " a + 7
    }
    print "OFF"; print 49, m, 0
    for (v = 0; v < 49; ++v) print v % 7, int(v / 7), 0
    for (i = 0; i < m; ++i) print face[i]
  }'
}

setup() {
  cd "$BATS_TEST_TMPDIR"
  open_ball | tm-stitch -q -o open.ply
}

@test "a ball without its top becomes a ball" {
  run tm-checkmanifold --closed open.ply
  assert_status 1
  tm-fill --report r.json open.ply -o ball.ply
  tm-checkmanifold --closed --intersections ball.ply
  jq -e '.result | .holes == 1 and .filled == 1 and .faired == 1' r.json
  tm-info --get volume ball.ply | awk '{ exit !($1 > 4.12 && $1 < 4.23) }'
}

@test "what was there stays byte for byte" {
  tm-convert --format off --no-provenance open.ply -o open.off
  tm-fill --no-provenance --format off open.ply -o ball.off
  vertices=$(tm-info --get vertices open.ply)
  faces=$(tm-info --get faces open.ply)
  all=$(tm-info --get vertices ball.off)
  numbers() { grep -v '^#' "$1" | sed 1,2d; }
  diff <(numbers open.off | head -n "$vertices") <(numbers ball.off | head -n "$vertices")
  diff <(numbers open.off | tail -n "$faces") \
    <(numbers ball.off | tail -n +$((all + 1)) | head -n "$faces")
}

@test "holes that touch at a vertex are filled, also after tm-stitch" {
  # Every fifth face is missing.
  tm-shape sphere --faces 1000 --format off --no-provenance | awk '
    NR == 1 { print; next }
    NR == 2 { n = $1; for (i = 0; i < $2; ++i) kept += i % 5 != 0; print n, kept, 0; next }
    NR <= n + 2 || (NR - n - 3) % 5 != 0' >holes.off
  run tm-checkmanifold holes.off
  assert_status 1
  tm-fill holes.off -o direct.off
  tm-stitch holes.off | tm-fill -o stitched.off
  tm-convert --format stl holes.off | tm-fill --format off -o soup.off
  for name in direct stitched soup; do
    tm-checkmanifold --closed --intersections $name.off
    tm-info --get volume $name.off | awk "{ exit !(\$1 > 4.1 && \$1 < 4.2) }"
  done
}

@test "the missing side of a turned part is closed around a through hole" {
  tm-shape box 6 4 1 -o block.off
  tm-shape box 2 1 3 -o drill.off
  tm-boolean difference block.off drill.off -o part.off
  tm-select --box -9,-9,-0.6,9,9,-0.4 --invert part.off |
    tm-transform --rotate 1,2,3,40 -o open.off
  run --separate-stderr tm-fill --max-edges 5 open.off -o still.off
  [[ $stderr == *"1 hole stays open, beyond the limits: "* ]] || fail "$stderr"
  [ "$(tm-info --get faces still.off)" = "$(tm-info --get faces open.off)" ]
  for command in 'tm-fill --no-fair' 'tm-fill --no-refine' tm-repair; do
    $command open.off -o closed.off
    tm-checkmanifold --closed --intersections closed.off
    [ "$(tm-info --get genus closed.off)" -eq 1 ]
    tm-info --get volume closed.off | awk '{ exit !($1 > 21.999 && $1 < 22.001) }'
  done
}

@test "holes of a flat sheet within the limits are filled, and its border stays open" {
  # Two holes of four edges, one of eight.
  sheet '7 16 26 27 28' >sheet.off
  for limit in '--max-edges 7' '--max-diameter 2'; do
    # shellcheck disable=SC2086 # an option and its value
    tm-fill --no-refine $limit --report r.json sheet.off -o filled.off
    jq -e '.result | .holes == 4 and .filled == 2' r.json
    tm-info --get area filled.off | awk '{ exit !($1 > 32.999 && $1 < 33.001) }'
  done
  tm-fill --no-refine --max-edges 8 sheet.off -o filled.off
  tm-info --get area filled.off | awk '{ exit !($1 > 35.999 && $1 < 36.001) }'
}

@test "limits leave a hole open, which is reported with its place" {
  run --separate-stderr tm-fill --max-edges 5 open.ply -o still.ply
  assert_status 0
  [[ $stderr == *"1 hole stays open, beyond the limits: "*" edges, "*" long, at vertex "* ]]
  [ "$(tm-info --get faces still.ply)" = "$(tm-info --get faces open.ply)" ]
  run tm-fill --max-edges 2 open.ply
  assert_status 2
}

@test "an intersecting patch is reported with the option that closes the hole" {
  # The only patch for a single face is its reverse.
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >face.off
  run --separate-stderr tm-fill face.off -o still.off
  assert_status 0
  [[ $stderr == *"1 hole stays open, because every patch would intersect the mesh: "*"; close these holes with --allow-crossings, then run tm-clean" ]]
  run --separate-stderr tm-fill --allow-crossings face.off -o still.off
  [[ $stderr != *--allow-crossings* ]]
}

@test "a slit, which has only flat patches, is named with what closes it, whatever is allowed" {
  # A tetrahedron with a vertex in the middle of an edge, at which only one of the edge's two faces is split.
  printf '%s\n' OFF '5 5 0' '0 0 0' '1 0 0' '0 1 0' '0 0 1' '0.5 0 0' \
    '3 0 2 1' '3 0 4 3' '3 4 1 3' '3 0 3 2' '3 1 2 3' >slit.off
  for option in '' --allow-crossings; do
    # shellcheck disable=SC2086 # the option may be absent
    run --separate-stderr tm-fill $option slit.off -o still.off --report r.json
    assert_status 0
    [[ $stderr == *"1 hole stays open, because every patch would have a face without area, or an edge that has two faces already: "*"; close slits with tm-clean" ]]
    [ "$(jq .result.left_flat r.json)" -eq 1 ]
    [ "$(jq .result.left_crossing r.json)" -eq 0 ]
    tm-clean still.off -o closed.off
    tm-checkmanifold --closed closed.off
  done
}

@test "a soup is refused, and tm-stitch named" {
  printf 'OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n' >three.off
  run --separate-stderr tm-fill three.off
  assert_status 3
  [[ $stderr == *"tm-stitch --orient"* ]]
}
