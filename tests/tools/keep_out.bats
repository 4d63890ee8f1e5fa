# Surfaces that keep away from each other, through files.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tm-shape dented --faces 4000 -o brain.ply
}

# pairs_of FILE...: counts the intersecting pairs of faces if all files are one mesh.
pairs_of() {
  tm-cat "$@" | tm-intersect --report pairs.json -o /dev/null
  sed -n 's/.*"pairs": \([0-9]*\).*/\1/p' pairs.json
}

# nearest FILE FILE: prints the least distance of a vertex of either mesh from the other.
nearest() {
  tm-compare --samples 0 --reference "$2" --per-vertex there.ply "$1" >/dev/null
  tm-compare --samples 0 --reference "$1" --per-vertex back.ply "$2" >/dev/null
  for file in there.ply back.ply; do
    tm-convert --format ply-ascii "$file" | awk '/^element vertex/ { n = $3 }
      body && n-- > 0 { print $NF }
      /^end_header/ { body = 1 }'
  done | sort -g | head -1
}

# gap_of SHARE: prints a fraction of the diagonal of the skull.
gap_of() {
  tm-info skull.ply | awk -v share="$1" '
    /^bbox_min/ { split($0, low) }
    /^bbox_max/ { for (i = 2; i <= 4; ++i) sum += ($i - low[i]) ^ 2; print share * sqrt(sum) * 0.999999 }'
}

@test "brain, skull and skin at ever smaller distances are made coarse, and never touch" {
  for distance in 2% 1% 0.6%; do
    tm-displace --normal-speed $distance --alpha 9 brain.ply | tm-remesh >skull.ply
    tm-displace --normal-speed $distance --alpha 9 skull.ply | tm-remesh >skin.ply
    [ "$(pairs_of brain.ply skull.ply skin.ply)" -eq 0 ]
    tm-cat brain.ply skin.ply >others.ply
    tm-remesh --min-edge 2.5x --max-edge 5x --iterations 3 \
      --keep-out others.ply --gap 0.2% skull.ply --report report.json >coarse.ply
    [ "$(pairs_of brain.ply coarse.ply skin.ply)" -eq 0 ]
    nearest coarse.ply others.ply | awk -v gap="$(gap_of 0.002)" '{ exit !($1 >= gap) }'
    tm-checkmanifold --closed coarse.ply
    [ "$(tm-info --get faces coarse.ply)" -lt 3000 ]
  done
  # --keep-out is necessary at the last distance: without it, surfaces intersect.
  tm-remesh --min-edge 2.5x --max-edge 5x --iterations 3 skull.ply >free.ply
  [ "$(pairs_of brain.ply free.ply skin.ply)" -gt 0 ]
  grep -Eq '"kept_out": [1-9]' report.json
}

@test "a shell that shrinks stops at the gap, and one decimated keeps it" {
  tm-displace --normal-speed 1% --alpha 9 brain.ply >skull.ply
  for _ in 1 2 3; do
    tm-displace --normal-speed=-1% --alpha 9 --keep-out brain.ply --gap 0.3% \
      --report report.json skull.ply -o skull.ply
  done
  grep -Eq '"held_back": [1-9]' report.json
  [ "$(pairs_of brain.ply skull.ply)" -eq 0 ]
  nearest skull.ply brain.ply | awk -v gap="$(gap_of 0.0029)" '{ exit !($1 >= gap && $1 < 2 * gap) }'
  tm-remesh --faces 1500 --keep-out brain.ply --gap 0.2% skull.ply >light.ply
  [ "$(pairs_of brain.ply light.ply)" -eq 0 ]
}

@test "a gap without a surface, a surface without a gap, and surfaces that meet are refused" {
  for options in '--keep-out brain.ply' '--gap 1%' '--keep-out brain.ply --gap 0'; do
    for program in tm-remesh 'tm-displace --normal-speed 1%'; do
      # shellcheck disable=SC2086
      run --separate-stderr $program $options brain.ply
      assert_status 2
      one_line "$stderr"
    done
  done
  tm-shape sphere --radius 1 -o ball.ply
  for program in tm-remesh 'tm-remesh --faces 500' 'tm-displace --normal-speed 1%'; do
    run --separate-stderr $program --keep-out brain.ply --gap 1% ball.ply
    assert_status 3
    one_line "$stderr"
    [[ $stderr == *"intersects"* ]]
  done
}

@test "faces closer than the gap are reported, for any number of threads" {
  tm-displace --normal-speed 0.5% --alpha 9 brain.ply >skull.ply
  run --separate-stderr tm-displace --normal-speed=-1% --keep-out brain.ply --gap 1% \
    -o one.ply --threads 1 skull.ply
  assert_status 0
  [[ $stderr == *"nearer to brain.ply than the gap in the input"* ]]
  tm-displace -q --normal-speed=-1% --keep-out brain.ply --gap 1% --threads 4 skull.ply | cmp - one.ply
  [ "$(pairs_of brain.ply one.ply)" -eq 0 ]
}

@test "the advice for a mesh that intersects the obstacle leads to a result" {
  tm-shape sphere --faces 500 -o ball.ply
  tm-shape sphere --faces 500 --center 0.5,0,0 -o obstacle.ply
  run --separate-stderr tm-remesh --keep-out obstacle.ply --gap 0.01 ball.ply
  [ "$status" -eq 3 ]
  [[ $stderr == *"; enlarge that surface with tm-offset --distance, and subtract it from the mesh with tm-boolean difference" ]]
  tm-offset --distance 0.03 obstacle.ply -o enlarged.ply
  tm-boolean difference ball.ply enlarged.ply | tm-remesh --keep-out obstacle.ply --gap 0.01 -o result.ply
  [ "$(pairs_of obstacle.ply result.ply)" -eq 0 ]
}
