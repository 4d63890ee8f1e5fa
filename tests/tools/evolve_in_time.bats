load ../helpers/common

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  tm-shape sphere --faces 1000 --center 1,0,0 --double -o ball.ply
  # Two commands that rotate about the z axis. The first runs once per stage, the second runs for all stages.
  cat >turn.awk <<'AWK'
BEGIN { OFMT = "%.17g" }
/^element vertex/ { count = $3 }
/^element face/ { print "property double vx\nproperty double vy\nproperty double vz" }
/^end_header/ { body = 1; print; next }
body && count > 0 { --count; print $0, -$2, $1, 0; next }
{ print }
AWK
  cat >turn.py <<'PYTHON'
import struct, sys
source, sink = sys.stdin.buffer, sys.stdout.buffer
sink.write(b'ready\n')
sink.flush()
while line := source.readline():
    head, body = source.read(int(line.split()[1])).split(b'end_header\n', 1)
    count = int(head.split(b'element vertex ')[1].split()[0])
    sink.write(b'velocities %d\n' % count)
    for x, y, z in struct.iter_unpack('<3d', body[:24 * count]):
        sink.write(struct.pack('<3d', -y, x, 0))
    sink.flush()
PYTHON
}

setup() {
  cd "$BATS_TEST_TMPDIR"
  cp "$BATS_FILE_TMPDIR"/turn.* .
  ball=$BATS_FILE_TMPDIR/ball.ply
  once='tm-convert --format ply-ascii | awk -f turn.awk'
}

value() { jq -r ".result.$1" "$2"; }

# Arguments: the exit code and a part of the message.
assert_failure_with() {
  assert_status "$1"
  [[ $stderr == *"$2"* ]] || fail "$stderr"
}

# Prints the distance between the center of the box and the rotated center of the ball.
distance_from_turned() {
  read -r x0 y0 _ <<<"$(tm-info --get bbox_min "$1")"
  read -r x1 y1 _ <<<"$(tm-info --get bbox_max "$1")"
  awk -v x="$x0" -v X="$x1" -v y="$y0" -v Y="$y1" -v t="$2" \
    'BEGIN { print sqrt(((x + X) / 2 - cos(t))^2 + ((y + Y) / 2 - sin(t))^2) }'
}

@test "all vertices move for the same time, and higher orders are more accurate" {
  for integrator in euler midpoint rk4; do
    tm-evolve "$ball" -o $integrator.ply -q --time 1 --time-step 0.1 --report $integrator.json \
      --integrator $integrator --velocity "$once"
    jq -e ".result.time == 1" $integrator.json
    [ "$(value iterations $integrator.json)" = 10 ]
    distance_from_turned $integrator.ply 1 >>distances
  done
  # After ten steps, the errors of Euler's method, midpoint and rk4 are about 1/20, 1/600 and 1e-6. The center
  # of the rotated mesh's box adds an error.
  awk 'NR == 1 { euler = $1 } NR == 2 { mid = $1 } END { exit !(euler > 0.03 && mid < 0.01 && $1 < 0.01) }' distances
}

@test "a persistent command gives the same bytes as one started for each stage" {
  command -v python3 || skip "without Python"
  tm-evolve "$ball" -o once.ply --no-provenance -q --time 0.5 --velocity "$once"
  tm-evolve "$ball" -o alive.ply --no-provenance -q --time 0.5 --persistent --velocity 'python3 turn.py'
  cmp once.ply alive.ply
}

@test "commands find the time, the span and the stage in their environment" {
  tm-evolve "$ball" -o out.ply -q --time 0.2 --time-step 0.1 \
    --velocity "echo \"\$TM_ITERATION \$TM_TIME \$TM_TIME_STEP \$TM_STAGE\" >>calls; $once"
  diff calls - <<'END'
1 0 0 0
1 0.05 0.1 1
2 0.1 0 0
2 0.15000000000000002 0.1 1
END
}

@test "a run that was stopped continues to the same bytes, and the CSV holds the time" {
  tm-evolve "$ball" -o whole.ply --no-provenance -q --time 0.6 --velocity "$once" --csv whole.csv
  tm-evolve "$ball" -o parts.ply --no-provenance -q --time 0.6 --velocity "$once" --csv parts.csv --iterations 2
  tm-evolve "$ball" -o parts.ply --no-provenance -q --time 0.6 --velocity "$once" --csv parts.csv --resume
  cmp whole.ply parts.ply
  cut -d, -f1-10 whole.csv >whole
  cut -d, -f1-10 parts.csv | cmp - whole
  [ "$(tail -1 whole | cut -d, -f2)" = 0.6 ]
}

@test "the volume is kept while smoothing would reduce it" {
  volume=$(tm-info --get volume "$ball")
  for keep in '' --keep-volume; do
    tm-evolve "$ball" -o out.ply -q --time 3 --integrator rk4 --max-move 2 --smooth 0.1 --velocity "$once" \
      --max-edge 1.05x $keep
    awk -v a="$volume" -v b="$(tm-info --get volume out.ply)" 'BEGIN { print (b - a) / a }' >>errors
  done
  awk 'NR == 1 { lost = $1 } END { exit !(lost < -5e-4 && $1 > -1e-5 && $1 < 1e-5) }' errors
}

@test "each body keeps its own volume beside another one" {
  tm-shape sphere --radius 0.5 --faces 2000 --center 3,0,0 --double | tm-cat "$ball" - -o two.ply
  tm-evolve two.ply -o out.ply -q --time 0.1 --time-step 0.001 --keep-volume \
    --flow volume-preserving-curvature
  for place in 1,0,0 3,0,0; do
    for mesh in two out; do tm-select -q --around $place $mesh.ply | tm-info --get volume; done
  done >volumes
  awk '{ v[NR] = $1 } END { e = v[2] / v[1] - 1; f = v[4] / v[3] - 1
    exit !(e < 1e-10 && e > -1e-10 && f < 1e-10 && f > -1e-10) }' volumes
}

@test "volume lost to 32-bit rounding is reported, and the advised conversion avoids it" {
  tm-shape sphere --faces 1000 --center 1,0,0 --float -o float.ply
  keep() { run --separate-stderr tm-evolve "$1" -o out.ply --time 1 --velocity "$once" --keep-volume; }
  keep float.ply
  assert_status 0
  [[ $stderr == *"the volume differs by "*", which could not be restored: 32-bit coordinates are rounded; run tm-convert --double first"* ]]
  tm-convert --double float.ply -o double.ply
  keep double.ply
  assert_status 0
  [[ $stderr != *"which could not be restored"* ]]
}

@test "a part that was remeshed as the man page advises keeps its sharp edges with --curved" {
  tm-shape box 2 1 0.4 --faces 12 -o base.ply
  tm-shape cylinder 0.3 1 --faces 200 | tm-transform --translate 0.05,0.03,0 -o drill.ply
  tm-boolean difference base.ply drill.ply | tm-remesh --edge 0.1 -o part.ply
  tm-evolve part.ply -o turned.ply -q --time 1 --time-step 0.02 --integrator rk4 --curved \
    --flow rotation --center 0,0,0
  tm-checkmanifold --closed --intersections turned.ply
  tm-compare --reference part.ply turned.ply >distances
  # The limit is a twentieth of the longest edge, by which collapses may move the surface. Without --curved,
  # the distance is 0.06.
  awk '/^hausdorff:/ { exit !($2 < 0.0085) }' distances
}

@test "commands that break the protocol are reported, and nothing hangs" {
  persistent() {
    run --separate-stderr timeout 20 tm-evolve "$ball" -o out.ply --time 1 --persistent --velocity "$1"
  }
  persistent 'cat'
  assert_failure_with 4 "did not begin with the line 'ready'"
  persistent 'exit 3'
  assert_failure_with 3 "ended with exit code 3"
  persistent 'echo ready; read -r line; echo wrong'
  assert_failure_with 3 "answered 'wrong' instead of 'velocities' and the number of vertices"
  persistent 'echo ready; read -r line; echo velocities 7; head -c 168 /dev/zero'
  assert_failure_with 3 "returned 7 vectors for 492 vertices"
  persistent 'echo ready; read -r line; exit 0'
  assert_failure_with 4 "ended before all velocities were computed"
}

@test "conflicting options are refused with the ones that fit together" {
  refused() {
    run --separate-stderr tm-evolve "$ball" -o out.ply "${@:2}"
    assert_failure_with 2 "$1"
  }
  refused 'give either --flow NAME or --velocity COMMAND' --time 1
  refused 'give either --flow NAME or --velocity COMMAND' --time 1 --flow abc --velocity cat
  refused 'the motion is missing'
  refused '--time must be above 0' --time 0 --flow rotation
  refused '--max-move needs --time T' --step cat --max-move 1
  refused '--alpha cannot be combined with --time' --time 1 --velocity cat --alpha 1
  refused '--step cannot be combined with --time' --time 1 --step cat
  refused '--time-step auto needs --time T' --step cat --time-step auto
  refused "--time-step: 'x' is not a number" --time 1 --velocity cat --time-step x
  refused 'span > 0' --time 1 --velocity cat --time-step 0
  refused 'name their face property with --bodies' --time 1 --velocity cat --contact stop
  refused 'neither gap:LENGTH nor stop' --time 1 --velocity cat --bodies body --contact near
  refused 'the error must be above 0' --time 1 --velocity cat --adaptive 0
  refused 'does not support --tolerance: limit their span with --max-move or --time-step' --time 1 --flow mean-curvature --tolerance 1
  refused 'does not support --integrator: limit their span with --max-move or --time-step' --time 1 --flow surface-diffusion --integrator rk4
  refused 'use midpoint or rk4 with a tolerance' --time 1 --velocity cat --integrator euler --tolerance 1
}

@test "steps that move vertices far are reported, and the advice helps" {
  run --separate-stderr tm-evolve "$ball" -o out.ply --time 1 --time-step 0.5 --velocity "$once"
  assert_status 0
  [[ $stderr == *"mean edges in a step; a smaller --time-step, or auto,"* ]]
  run --separate-stderr tm-evolve "$ball" -o out.ply --time 1 --velocity "$once"
  [[ $stderr != *"mean edges in a step"* ]]
}

@test "cubes that move towards each other come to rest at each other, or keep the gap" {
  for place in 0 1.3; do tm-shape box 1 1 1 --double --faces 200 --center "$place,0,0" -o "at$place.ply"; done
  tm-cat --format ply-ascii at0.ply at1.3.ply |
    awk -v half="$(tm-info --get vertices at0.ply)" -v faces="$(tm-info --get faces at0.ply)" '
      /^element face/ { print "property double vx\nproperty double vy\nproperty double vz" }
      /^end_header/ { print "property uchar body"; is_body = 1; print; next }
      !is_body { print; next }
      row++ < 2 * half { print $0, (row > half ? -1 : 1), 0, 0; next }
      { print $0, (row - 2 * half > faces) }' >start.ply
  # distance CONTACT: prints the distance of the two planes that face each other. Without --contact they would
  # overlap by 0.5.
  distance() {
    tm-evolve -q --curved --bodies body --contact "$1" --reference-edge 0.3 --velocity cat --time 0.4 --time-step 0.01 -o end.ply start.ply
    tm-intersect --check end.ply >pairs
    tm-select -q --where 'body=0' end.ply -o left.ply
    tm-select -q --where 'body=1' end.ply -o right.ply
    # The other sides move freely.
    awk -v low="$(tm-info --get bbox_min left.ply)" 'BEGIN { split(low, x, " "); exit !(x[1] > -0.1001 && x[1] < -0.0999) }'
    awk -v low="$(tm-info --get bbox_min right.ply)" -v high="$(tm-info --get bbox_max left.ply)" \
      'BEGIN { split(low, x, " "); split(high, y, " "); print x[1] - y[1] }'
  }
  awk -v distance="$(distance gap:0.04)" 'BEGIN { exit !(distance >= 0.04 && distance < 0.041) }'
  awk -v distance="$(distance stop)" 'BEGIN { exit !(distance > 0 && distance < 1e-6) }'
}

@test "edges that adapt to curvature bring a sphere that was a film nearer to where it began" {
  tm-shape sphere --double --radius 0.15 --center 0.35,0.35,0.35 --faces 1280 -o ball.ply
  # distance OPTION...: prints the largest distance from the sphere after Enright's test, in edge lengths.
  distance() {
    tm-evolve -q --curved "$@" --flow deformation --period 3 --time 3 --time-step 0.03 --integrator rk4 ball.ply |
      tm-convert -q --format off | awk -v edge="$(tm-info --get edge_mean ball.ply)" '
        NR == 2 { vertices = $1 }
        NR > 2 && NR <= vertices + 2 {
          from = sqrt(($1 - 0.35)^2 + ($2 - 0.35)^2 + ($3 - 0.35)^2) - 0.15
          if (from < 0) from = -from
          if (from > most) most = from
        }
        END { print most / edge }'
  }
  awk -v even="$(distance)" -v adaptive="$(distance --adaptive 0.03x)" \
    'BEGIN { exit adaptive > 0.2 || even < 2 * adaptive }'
}

@test "curved remeshing of long edges changes the volume, and the advice avoids it" {
  tm-shape sphere --faces 320 --double -o coarse.ply
  carry() { run --separate-stderr tm-evolve "$1" --curved --max-edge 0.1 --min-edge 0.05 --time 0.1 --flow translation -o out.ply; }
  carry coarse.ply
  assert_status 0
  [[ $stderr == *"remeshing changed the volume by 0."*": remesh the source first, by tm-remesh --edge LENGTH, or use shorter edges"* ]]
  tm-remesh -q --edge 0.08 coarse.ply -o fine.ply
  carry fine.ply
  assert_status 0
  [[ $stderr != *"remeshing changed"* ]]
}

@test "a surface that vanishes ends the run, and a note gives the time" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --radius 0.3 --faces 320 -o ball.ply
  run --separate-stderr tm-evolve ball.ply --time 0.05 --flow mean-curvature --events events.csv -o out.ply
  assert_status 0
  [[ $stderr == *"the surface vanished at time 0.02"* ]]
  [ "$(tm-info --get faces out.ply)" -eq 0 ]
  grep -q 'component vanished' events.csv
}

@test "volume that remeshing removes is noted, and --curved keeps it" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 2 1 0.3 --faces 12 -o plate.ply
  run --separate-stderr tm-evolve plate.ply --time 1 --flow translation -o out.ply
  assert_status 0
  [[ $stderr == *"remeshing changed the volume by "*": --curved keeps the volume and sharp edges"* ]]
  run --separate-stderr tm-evolve plate.ply --time 1 --flow translation --curved -o out.ply
  assert_status 0
  [[ $stderr != *"remeshing changed"* ]]
}
