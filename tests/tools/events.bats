# Events of tm-evolve: events.csv, and the labels of components.
load ../helpers/common

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  tm-shape sphere --faces 1000 --double -o left.ply
  tm-shape sphere --faces 800 --double --radius 0.9 --center 2.2,0,0 -o right.ply
  # A vertex property holds the velocity: the right ball moves to the left. The gap is 0.3 wide.
  tm-cat -q left.ply right.ply | tm-convert --format ply-ascii | awk '
    /^element vertex/ { n = $3 }
    /^element face/ { print "property float speed" }
    body && n-- > 0 { print $0, ($1 > 1.15 ? -1 : 0); next }
    /^end_header/ { body = 1 }
    { print }' >balls.ply
  cat >left.awk <<'AWK'
/^element vertex/ { count = $3 }
/^element face/ { print "property double vx\nproperty double vy\nproperty double vz" }
/^end_header/ { body = 1; print; next }
body && count > 0 { --count; print $0, $4, 0, 0; next }
{ print }
AWK
}

setup() {
  cd "$BATS_TEST_TMPDIR"
  cp "$BATS_FILE_TMPDIR"/* .
  words=(balls.ply -q --no-provenance --time 0.35 --until components:1
    --velocity 'tm-convert --format ply-ascii | awk -f left.awk')
}

approach() { tm-evolve "${words[@]}" "$@"; }

# column NAME FILE: prints a column of a CSV file.
column() {
  awk -F, -v name="$1" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) at = i; next } { print $at }' "$2"
}

@test "two balls that approach merge once, when and where they touch" {
  approach -o out.ply --events events.csv --report r.json
  [ "$(column kind events.csv)" = merge ]
  [ "$(column labels_before events.csv)" = "1 2" ]
  [ "$(column labels_after events.csv)" = 1 ]
  # The tolerance is a thousandth of the time. The balls are polyhedra, so they do not meet exactly at 0.3.
  awk -v t="$(column time events.csv)" 'BEGIN { exit !(t > 0.295 && t < 0.32) }'
  awk -v x="$(column x events.csv)" -v y="$(column y events.csv)" -v z="$(column z events.csv)" \
    'BEGIN { exit !(sqrt((x - 1) ^ 2 + y * y + z * z) < 0.11) }'
  jq -e '.result.events == 1 and .result.components == 1' r.json
  tm-convert -q out.ply --format ply-ascii -o ascii.ply
  grep -q '^property int component_label' ascii.ply
}

@test "labels stay with their components until they merge" {
  approach -o out.ply --events events.csv --frames frames --every 1 --iterations 2
  for frame in frames/*; do
    tm-select -q --where 'component_label==2' "$frame" -o right.ply
    [ "$(tm-info --get components right.ply)" -eq 1 ]
    awk -v x="$(tm-info --get bbox_min right.ply | cut -d' ' -f1)" 'BEGIN { exit !(x > 0.9) }'
  done
}

@test "without physical time, the iteration number is the time" {
  tm-evolve balls.ply -o out.ply -q --iterations 6 --smooth none --events events.csv \
    --step 'tm-displace --alpha 1 --normal-speed 0.04'
  [ "$(column kind events.csv)" = merge ]
  [ "$(column time events.csv)" = "$(column iteration events.csv)" ]
  # Each surface approaches the other by 0.04 in an iteration; the gap is 0.3.
  [ "$(column iteration events.csv)" -eq 4 ]
}

@test "a run that is killed continues to the same events, for any number of threads" {
  approach -o whole.ply --events whole.csv
  for threads in 1 2 4; do
    # Runs the program itself; with a shell function, another process would be killed.
    tm-evolve "${words[@]}" -o out.ply --events parts.csv --threads $threads --restart 3>&- &
    pid=$!
    for _ in {1..200}; do
      [ "$(grep -ao 'iteration [0-9]*' out.ply.tm-evolve/mesh.ply 2>/dev/null | cut -d' ' -f2)" != "" ] && break
      sleep 0.02
    done
    sleep "0.0$threads"
    kill -KILL $pid 2>/dev/null || true
    wait $pid || true
    # Adds a row of an unfinished step, which --resume must remove.
    [ ! -e parts.csv ] || echo '99,1,merge,0,0,0,0,1 2,1,1 1,2' >>parts.csv
    approach -o out.ply --events parts.csv --threads $threads --resume
    cmp whole.csv parts.csv
    cmp whole.ply out.ply
    rm -f out.ply parts.csv
  done
}

@test "a run has its events under a fixed name, and continues only with them" {
  approach --run run
  [ "$(column kind run/events.csv)" = merge ]
  run --separate-stderr approach --run run --events other.csv
  assert_status 2
  [[ $stderr == *"leave out --events"* ]]
  approach -o out.ply --iterations 2
  run --separate-stderr approach -o out.ply --resume --events events.csv
  assert_status 2
  [[ $stderr == *"other settings"* ]]
}

@test "cavities are filled, or kept with --keep-cavities" {
  tm-shape sphere --faces 500 --radius 0.5 -o inner.ply
  tm-boolean -q difference left.ply inner.ply -o shell.ply
  for keep in '' --keep-cavities; do
    tm-evolve shell.ply -o out.ply -q --step cat --iterations 1 $keep --smooth none
    tm-info --get components out.ply >>components
  done
  diff components - <<<$'1\n2'
}
