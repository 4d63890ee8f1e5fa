load ../helpers/common

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  tm-shape sphere --faces 1000 -o ball.ply
}

setup() {
  cd "$BATS_TEST_TMPDIR"
  ball=$BATS_FILE_TMPDIR/ball.ply
}

value() { jq -r ".result.$1" "$2"; }

@test "a step by one of our filters makes the bytes of the loop by hand" {
  tm-evolve "$ball" --step 'tm-displace --normal-speed 0.02' --iterations 5 -o out.ply \
    --no-provenance -q
  tm-clean --no-provenance --outermost --reference-edge auto -o mesh.ply "$ball"
  for _ in {1..5}; do
    pipe "tm-displace --no-provenance --normal-speed 0.02 mesh.ply | tm-clean --no-provenance --outermost |
      tm-remesh --no-provenance --smooth 0.1 --feature-angle 180 -o mesh.ply"
    assert_status 0
  done
  tm-clean --no-provenance --outermost -o mesh.ply mesh.ply
  cmp out.ply mesh.ply
}

@test "velocities in another language: vx vy vz out, or vertices moved" {
  # Awk reads ASCII PLY, and adds velocities away from the z axis.
  cat >outwards <<'AWK'
/^element vertex/ { count = $3 }
/^element face/ { print "property double vx\nproperty double vy\nproperty double vz" }
/^end_header/ { body = 1; print; next }
body && count > 0 { --count; print $0, $1, $2, 0; next }
{ print }
AWK
  tm-evolve "$ball" -o out.ply --iterations 10 -q --report r.json --time-step 0.05 --alpha 1 \
    --step 'tm-convert --format ply-ascii | awk -f outwards'
  [ "$(value components r.json)" -eq 1 ]
  # The factor is exp(0.5), apart from the smoothing.
  awk -v x="$(tm-info --get bbox_max out.ply | cut -d' ' -f1)" 'BEGIN { exit !(x > 1.5 && x < 1.7) }'
  sed '/^end_header/q' out.ply >header
  run ! grep -q vx header
  tm-evolve "$ball" -o moved.ply --iterations 3 -q \
    --step 'tm-convert --format ply-ascii | awk "/^end_header/ { b = 1 } b && NF == 3 { \$1 *= 1.1 } { print }"'
  awk -v x="$(tm-info --get bbox_max moved.ply | cut -d' ' -f1)" 'BEGIN { exit !(x > 1.2 && x < 1.35) }'
}

# Awk adds a flow without divergence to the box, so volumes stay.
@test "clamped velocities are reported on stderr, in the report and in the CSV" {
  cat >squeeze <<'AWK'
/^element vertex/ { count = $3 }
/^element face/ { print "property double vx\nproperty double vy\nproperty double vz" }
/^end_header/ { body = 1; print; next }
body && count > 0 { --count; print $0, $1, $2, -2 * $3; next }
{ print }
AWK
  squeeze() {
    run --separate-stderr tm-evolve "$ball" -o out.ply --csv log.csv --report r.json \
      --step 'tm-convert --format ply-ascii | awk -f squeeze' "$@"
    assert_status 0
  }
  squeeze --iterations 8 --time-step 0.025
  [[ $stderr == *"tm-evolve: movements of up to "*" % of the vertices are clamped to 0.2 of the mean edge in 8 of 8 iterations: vertices moved less far than their velocities prescribe; use a smaller --time-step and more --iterations, or a larger --alpha"* ]] ||
    fail "$stderr"
  [ "$(value clamped_iterations r.json)" -eq 8 ]
  value clamped_share r.json | awk '{ exit !($1 > 0.1 && $1 <= 1) }'
  # The report has the largest clamped fraction of all rows of the log.
  awk -F, -v most="$(value clamped_share r.json)" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == "clamped_fraction") at = i }
    NR > 1 && $at > share { share = $at } END { exit !(at && (share - most) ^ 2 < 1e-8) }' log.csv
  for options in "--iterations 40 --time-step 0.005" "--iterations 8 --time-step 0.025 --alpha 3"; do
    # shellcheck disable=SC2086
    squeeze $options --smooth none
    [[ $stderr != *clamped* ]] || fail "$stderr"
    [ "$(value clamped_iterations r.json)" -eq 0 ]
    awk -v before="$(tm-info --get volume "$ball")" -v after="$(tm-info --get volume out.ply)" \
      'BEGIN { exit !(after > 0.97 * before && after < 1.03 * before) }' || fail "$options"
  done
}

@test "clamped iterations of a run that is resumed count as well" {
  step='tm-convert --format ply-ascii | awk "/^element face/ { print \"property double vx\nproperty double vy\nproperty double vz\" }
    /^element vertex/ { n = \$3 } b && n-- > 0 { print \$0, 1, 0, 0; next } /^end_header/ { b = 1 } { print }"'
  tm-evolve "$ball" -o out.ply --step "$step" --iterations 2 -q
  tm-evolve "$ball" -o out.ply --step "$step" --iterations 5 -q --resume --report r.json
  [ "$(value clamped_iterations r.json)" -eq 5 ]
}

@test "it stops if no vertex moves as far as the limit, or if nothing improves" {
  step='tm-morph-step --target '$ball
  tm-shape sphere --radius 1.3 --faces 1000 -o large.ply
  tm-evolve large.ply -o out.ply --step "$step" --until moved:0.03x --report r.json -q
  [ "$(value stop r.json)" = converged ]
  [ "$(value iterations r.json)" -lt 60 ]
  tm-evolve large.ply -o out.ply --step "$step" --until stalled --report r.json -q
  [ "$(value stop r.json)" = converged ]
  run tm-evolve large.ply -o out.ply --step "$step" --iterations 2 --until moved:1e-9 \
    --require-convergence -q
  assert_status 1
}

@test "TM_ITERATION counts, from the first iteration on and over a resumed run" {
  step='echo $TM_ITERATION >>numbers; cat'
  tm-evolve "$ball" -o out.ply --step "$step" --iterations 2 -q
  tm-evolve "$ball" -o out.ply --step "$step" --iterations 4 -q --resume
  [ "$(tr '\n' ' ' <numbers)" = "1 2 3 4 " ]
}

@test "a failed step, an invalid mesh and changed faces are reported with the iteration" {
  told() { # CODE MESSAGE COMMAND
    run --separate-stderr tm-evolve "$ball" -o out.ply --step "$3"
    assert_status "$1"
    [[ ${stderr_lines[-1]} == "tm-evolve: "*"$2"* ]] || fail "$stderr"
    [ ! -e out.ply ] && [ ! -e out.ply.tm-evolve ]
  }
  told 4 "iteration 1: 'exit 9' ended with exit code 9" 'exit 9'
  told 3 "ended with exit code 3" 'cat >/dev/null; exit 3'
  told 4 "was ended by signal 9" 'kill -9 $$'
  told 3 "the step's output" 'cat >/dev/null'
  told 3 "a step may only move vertices" 'tm-remesh --max-edge 0.5x --min-edge 0.2x'
  told 4 "ended with exit code 127" 'no-such-program-here 2>/dev/null'
  # A filter that does not read its input fails because of its output, not by a broken pipe.
  told 3 "the step's output" 'exec 0<&-; echo no mesh'
  run --separate-stderr tm-evolve "$ball" -o out.ply
  assert_status 2
  [[ $stderr == *--step* ]]
  run --separate-stderr tm-evolve "$ball" -o out.ply --step cat --until moved
  assert_status 2
}

@test "a mesh of megabytes passes through pipes with smaller buffers" {
  tm-shape sphere --faces 40000 -o large.ply
  tm-evolve large.ply -o out.ply --step cat --iterations 1 -q
  [ "$(tm-info --get components out.ply)" -eq 1 ]
}

@test "a run that was killed continues to the same bytes" {
  step='tm-displace --normal-speed 0.01'
  tm-evolve "$ball" -o whole.ply --step "$step" --iterations 60 -q
  tm-evolve "$ball" -o out.ply --step "$step" --iterations 60 --csv log.csv -q 3>&- &
  while [ ! -e log.csv ] || [ "$(wc -l <log.csv)" -lt 9 ]; do sleep 0.01; done
  kill -KILL $!
  wait $! || true
  tm-evolve "$ball" -o out.ply --step "$step" --iterations 60 --csv log.csv -q --resume
  cmp <(tm-convert --no-provenance whole.ply | tail -c 1000) <(tm-convert --no-provenance out.ply | tail -c 1000)
  cmp whole.ply out.ply
  [ "$(wc -l <log.csv)" -eq 61 ]
}

@test "--until components:N and genus:N stop when the topology is reached" {
  tm-transform --translate 2.2,0,0 "$ball" | tm-cat "$ball" - -o two.ply
  tm-evolve two.ply -o one.ply -q --report r.json --iterations 60 --until components:1 \
    --step 'tm-displace --normal-speed 0.02'
  [ "$(value stop r.json)" = converged ]
  [ "$(tm-info --get components one.ply)" -eq 1 ]
  # Both balls move by 0.02 per step, so the gap of 0.2 closes after 5 steps, or 6 with rounding.
  steps=$(value iterations r.json)
  [ "$steps" -ge 5 ] && [ "$steps" -le 7 ] || fail "$steps iterations"
  # The mesh has two components one iteration before the merge.
  tm-evolve two.ply -o before.ply -q --iterations $((steps - 1)) --step 'tm-displace --normal-speed 0.02'
  [ "$(tm-info --get components before.ply)" -eq 2 ]
  tm-shape torus --radius 1 --tube 0.7 --faces 1000 -o ring.ply
  tm-evolve ring.ply -o filled.ply -q --report r.json --iterations 60 --until genus:0 \
    --step 'tm-displace --normal-speed 0.03'
  [ "$(value stop r.json)" = converged ]
  [ "$(tm-info --get genus filled.ply)" -eq 0 ]
  # The hole has a radius of 0.3, so it closes within 10 steps.
  steps=$(value iterations r.json)
  [ "$steps" -ge 9 ] && [ "$steps" -le 13 ] || fail "$steps iterations"
  run --separate-stderr tm-evolve two.ply -o none.ply --until components:none --step cat
  [ "$status" -eq 2 ]
}
