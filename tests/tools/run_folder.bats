# Loops with --run: all files of a run in one folder, in the layout of tm-run(5).

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus --faces 1000 -o torus.ply
  tm-shape sphere --around torus.ply --faces 1000 -o "a sphere.ply"
}

morph() {
  tm-morph -q "a sphere.ply" --target torus.ply "$@"
}

files_of() {
  (cd "$1" && find . -type f ! -path './result.ply.tm-*' | sort | sed 's|^\./||')
}

@test "tm-morph --run keeps start, target, frames, log, report, result and command" {
  morph --run r --iterations 5 --every 2
  diff - <(files_of r) <<'FILES'
frames/frame-00000.ply
frames/frame-00002.ply
frames/frame-00004.ply
log.csv
report.json
result.ply
run.json
start.ply
target.ply
FILES
  jq -e '.layout == 1 and .tool == "tm-morph" and (.version | length) > 0' r/run.json
  [ "$(jq -r '.commands[]' r/run.json)" = \
    "tm-morph -q 'a sphere.ply' --target torus.ply --run r --iterations 5 --every 2" ]
  # The meshes equal those of the same run with the separate options -o, --frames and --csv.
  morph -o one.ply --frames frames --csv log.csv --iterations 5 --every 2
  cmp one.ply r/result.ply
  for frame in frames/*; do cmp "$frame" "r/$frame"; done
  cut -d, -f1-12 log.csv | diff - <(cut -d, -f1-12 r/log.csv)
  tm-compare --json --reference "a sphere.ply" r/start.ply | jq -e '.hausdorff < 1e-12'
  tm-compare --json --reference torus.ply r/target.ply | jq -e '.hausdorff < 1e-12'
  jq -e '.result.iterations == 5' r/report.json
}

@test "the command of a run repeats it, and a run that continues tells both commands" {
  morph --run r --iterations 3 --every 1
  cp r/result.ply first.ply
  bash -c "$(jq -r '.commands[0]' r/run.json)"
  cmp first.ply r/result.ply
  morph --run r --iterations 6 --every 1 --resume
  [ "$(jq '.commands | length' r/run.json)" -eq 2 ]
  morph -o six.ply --iterations 6
  cmp six.ply r/result.ply
  [ "$(files_of r/frames | wc -l)" -eq 7 ]
  [ "$(wc -l <r/log.csv)" -eq 7 ]
}

@test "a new run replaces an earlier one in its folder, and no other file" {
  morph --run r --iterations 5 --every 1
  touch r/picture.png r/frames/picture.png
  tm-evolve -q --step cat --iterations 2 --every 1 --run r torus.ply
  diff - <(files_of r) <<'FILES'
events.csv
frames/frame-00000.ply
frames/frame-00001.ply
frames/frame-00002.ply
frames/picture.png
log.csv
picture.png
report.json
result.ply
run.json
start.ply
FILES
  [ "$(jq -r .tool r/run.json)" = tm-evolve ]
  # A failure before the first iteration does not change the earlier run.
  run --separate-stderr morph --target nothing.ply --run r
  assert_status 3
  [ "$(jq -r .tool r/run.json)" = tm-evolve ]
}

@test "a folder that is no run, and options that --run sets, are refused" {
  mkdir other
  touch other/letter
  run --separate-stderr morph --run other
  assert_status 2
  one_line "$stderr"
  [[ $stderr == *"'other' holds letter, but not a run"* ]]
  [ "$(ls -A other)" = letter ]
  for option in '-o x.ply' '--csv x' '--report x' '--frames x' '--format off'; do
    run --separate-stderr morph --run r $option
    assert_status 2
    one_line "$stderr"
    [[ $stderr == *"--run"*"leave out --"* ]]
  done
  [ ! -e r ]
  run --separate-stderr morph --target nothing.ply --run r
  assert_status 3
  [ ! -e r ]
}

@test "a run that is killed at any moment is continued, to the same bytes" {
  morph -o all.ply --iterations 12
  for kill_at in 2 5 9; do
    rm -f r/log.csv
    tm-morph -q "a sphere.ply" --target torus.ply --run r --iterations 12 --every 1 --restart 3>&- &
    until [ -e r/log.csv ] && [ "$(wc -l <r/log.csv)" -ge "$kill_at" ]; do sleep 0.01; done
    kill -KILL $! || true
    wait $! || true
    # The file is as after an interruption during writing.
    echo half >r/frames/.frame-00003.ply.123-0.tmp
    morph --run r --iterations 12 --every 1 --resume
    cmp all.ply r/result.ply
    [ "$(files_of r/frames | wc -l)" -eq 13 ]
    [ "$(wc -l <r/log.csv)" -eq 13 ]
  done
}

@test "a run that is killed while it replaces another one is continued or restarted" {
  morph -o all.ply --iterations 4
  for seconds in 0 0.002 0.005 0.01 0.02 0.04; do
    tm-morph -q "a sphere.ply" --target torus.ply --run r --iterations 4 --every 1 --restart 3>&- &
    sleep "$seconds"
    kill -KILL $! || true
    wait $! || true
    morph --run r --iterations 4 --every 1 --resume
    cmp all.ply r/result.ply
    [ "$(files_of r/frames | wc -l)" -eq 5 ]
    [ "$(wc -l <r/log.csv)" -eq 5 ]
    jq -e '.tool == "tm-morph"' r/run.json
  done
}

@test "a sequence and a reconstruction have runs too" {
  tm-morph -q "a sphere.ply" --sequence torus.ply torus.ply --iterations 2 --run film
  [ "$(files_of film/frames | wc -l)" -eq 3 ]
  [ ! -e film/target.ply ]

  mkdir photos
  tm-photograph -q --ring 12 --size 80x60 --write-images photos --write-silhouettes masks \
    -o photos.txt torus.ply
  reconstruct() {
    tm-reconstruct -q --cameras photos.txt --images photos --silhouettes masks --coarsest 1 \
      --passes 2 --iterations 1 --robust 0 "$@"
  }
  reconstruct --run seen
  diff - <(files_of seen) <<'FILES'
cameras.txt
frames/frame-00000.ply
frames/frame-00001.ply
frames/frame-00002.ply
log.csv
photographs/000-80x60.png
photographs/001-80x60.png
photographs/002-80x60.png
photographs/003-80x60.png
photographs/004-80x60.png
photographs/005-80x60.png
photographs/006-80x60.png
photographs/007-80x60.png
photographs/008-80x60.png
photographs/009-80x60.png
photographs/010-80x60.png
photographs/011-80x60.png
report.json
result.ply
run.json
FILES
  diff <(tm-cameras photos.txt | sed 's/\.png / /') <(tm-cameras seen/cameras.txt)
  reconstruct -o alone.ply
  cmp alone.ply seen/result.ply
}

@test "a movie that is followed keeps each frame's target, and none of an earlier movie" {
  tm-transform -q --scale 1.1 torus.ply -o large.ply
  tm-morph -q "a sphere.ply" --sequence torus.ply large.ply torus.ply --iterations 2 --run film
  [ "$(files_of film/targets | xargs)" = "00001.ply 00002.ply 00003.ply" ]
  tm-compare --json --reference large.ply film/targets/00002.ply | jq -e '.hausdorff < 1e-12'
  # A run with fewer steps leaves no files of the earlier run.
  touch film/targets/letter
  tm-morph -q "a sphere.ply" --sequence torus.ply --iterations 2 --run film
  [ "$(files_of film/targets | xargs)" = "00001.ply letter" ]
  tm-evolve -q --step cat --iterations 1 --run film torus.ply
  [ "$(files_of film/targets)" = letter ]
}

# steps NUMBER: makes photographs and masks of a rotating torus, in steps/1 and so on.
steps() {
  local step cameras=(--ring 12)
  for step in $(seq "$1"); do
    mkdir -p "steps/$step"
    tm-transform -q --rotate "0,0,1,$((step * 5))" torus.ply | tm-photograph -q "${cameras[@]}" \
      --size 80x60 --write-images "steps/$step/photos" --write-silhouettes "steps/$step/masks" -o new.txt
    mv new.txt cameras.txt
    cameras=(--cameras cameras.txt)
  done
}

reconstruct_steps() {
  tm-reconstruct -q --cameras cameras.txt --images '{}/photos' --silhouettes '{}/masks' --coarsest 1 \
    --track 1 --passes 2 --iterations 1 --robust 0 --sequence 'steps/*' "$@"
}

@test "a reconstruction of a movie keeps surfaces and photographs of each time step" {
  steps 2
  reconstruct_steps --run seen
  files_of seen | grep -v photographs | diff - <(printf '%s\n' frames/frame-00001.ply \
    frames/frame-00002.ply log.csv report.json result.ply run.json views/00001/cameras.txt \
    views/00002/cameras.txt)
  [ "$(files_of seen/views/00002/photographs | wc -l)" -eq 12 ]
  jq -e '.result.time_steps == 2 and .output.faces > 100' seen/report.json
  # The surfaces equal those of -o.
  reconstruct_steps -o surfaces
  cmp surfaces/1.ply seen/frames/frame-00001.ply
  cmp surfaces/2.ply seen/frames/frame-00002.ply
  cmp surfaces/2.ply seen/result.ply
}

@test "a reconstruction of a movie that is killed is continued, to the same bytes" {
  steps 3
  reconstruct_steps -o surfaces
  tm-reconstruct -q --cameras cameras.txt --images '{}/photos' --silhouettes '{}/masks' --coarsest 1 \
    --track 1 --passes 2 --iterations 1 --robust 0 --sequence 'steps/*' --run seen 3>&- &
  until [ -e seen/frames/frame-00001.ply ]; do sleep 0.01; done
  kill -KILL $! || true
  wait $! || true
  reconstruct_steps --run seen --resume
  cmp surfaces/3.ply seen/result.ply
  [ "$(files_of seen/frames | wc -l)" -eq 3 ]
  [ "$(wc -l <seen/log.csv)" -eq 4 ]
  [ "$(files_of seen/views | grep -c cameras)" -eq 3 ]
  [ "$(jq '.commands | length' seen/run.json)" -eq 2 ]
}
