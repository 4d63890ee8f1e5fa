# Pages of tm-report and tm-view in headless Chromium. Skipped where scripts/setup --browser has not
# installed it.

load ../helpers/common
load ../helpers/browser

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  has_browser || return 0
  tm-shape torus --faces 2000 -o torus.ply
  tm-shape sphere --around torus.ply --faces 2000 -o sphere.ply
  tm-morph -q sphere.ply --target torus.ply --run one --every 5
  tm-morph -q sphere.ply --target torus.ply --run slow --alpha 0.15 --every 5
  tm-report one -o one.html
  tm-report one slow -o two.html
  tm-shape sphere --faces 1000 -o left.ply
  tm-shape sphere --faces 500 --radius 0.7 --center 2,0,0 -o right.ply
  tm-cat -q left.ply right.ply -o balls.ply
  tm-evolve -q balls.ply --step 'tm-displace --alpha 1 --normal-speed 0.05' --smooth none --iterations 8 \
    --every 2 --run merges
  tm-report merges -o merges.html
  mkdir photos
  tm-shape dented --faces 3000 --format ply-ascii | tm-photograph -q --ring 12 --size 160x120 --look shade \
    --write-images photos --write-silhouettes masks -o photos.txt
  tm-reconstruct -q --cameras photos.txt --images photos --silhouettes masks --coarsest 1 --passes 2 \
    --iterations 1 --robust 0 --run seen
  tm-report seen -o seen.html
  for radius in 20 28; do
    mkdir -p "steps/$radius"
    tm-shape sphere --radius "$radius" --faces 1000 | tm-photograph -q --ring 12 --distance 200 \
      --size 160x120 --write-images "steps/$radius/photos" --write-silhouettes "steps/$radius/masks" -o steps.txt
  done
  tm-reconstruct -q --cameras steps.txt --sequence 'steps/*' --images '{}/photos' \
    --silhouettes '{}/masks' --coarsest 1 --track 1 --passes 1 --iterations 1 --robust 0 --run grows
  tm-report grows -o grows.html
  tm-shape sphere --around torus.ply --faces 1000 -o coarse.ply
  tm-morph -q torus.ply --sequence torus.ply coarse.ply sphere.ply --iterations 3 --run follows
  tm-report follows -o follows.html
  tm-shape sphere --faces 8000 --format ply-ascii | awk '
    /^element vertex/ { n = $3 }
    /^element face/ { print "property uchar red\nproperty uchar green\nproperty uchar blue" }
    inside && n-- > 0 { print $0, 220, 0, 0; next }
    /^end_header/ { inside = 1 }
    { print }' >red.ply
  tm-view red.ply -o red.html
  tm-shape box 1 1 1 --faces 300 | tm-view -o box.html
}

setup() {
  cd "$BATS_FILE_TMPDIR"
  needs_browser
}

@test "a page opens from its file, at 800 and 2000 pixels, without an error or a request" {
  check opens one.html
}

@test "the slider changes the picture, and going back brings it back" {
  check slider one.html
}

@test "a click on a curve goes to its time, and the curve says what the mesh is" {
  check curves one.html
}

@test "events are marked in the curves and listed, and a click on one goes to its time and place" {
  check events merges.html
}

@test "everything is reached and done by the keyboard" {
  check keyboard one.html
}

@test "a finger turns the mesh, on a narrow screen" {
  check touch one.html
}

@test "colors by distance with a legend, of all frames or one; wires" {
  check colors one.html
}

@test "the target shows through as a ghost, unless that is not wanted" {
  check ghost one.html
}

@test "the sides of a box are flat up to its edges" {
  check creases box.html
}

@test "a ball is a disc of the right size, place and color" {
  check silhouette red.html
}

@test "a reconstruction is seen as each photograph sees it, beside the photograph" {
  check photographs seen.html
}

@test "a movie shows cameras and photographs of the time step that the slider is at" {
  check film grows.html
}

@test "a movie shows the target of the frame that the slider is at" {
  check targets follows.html
}

@test "two runs are turned together" {
  check linked two.html
}

@test "axe-core finds nothing to complain of, light or dark" {
  check accessible one.html two.html red.html seen.html
}

@test "axe-core finds nothing on the page of a batch" {
  needs_command jq
  printf '%s\n' 'shape torus tm-shape torus --faces 300 -o source.ply' 'shape none exit 4' \
    'run clean tm-clean source.ply -o result.ply' 'run wrong tm-clean none.ply' >small.table
  for name in torus,clean torus,wrong none,clean; do
    "$tm_root/scripts/experiments/batch" run small.table batch "$name"
  done
  "$tm_root/scripts/experiments/batch" collect small.table batch
  check texts batch/index.html
}

@test "the page is dark where that is preferred" {
  check dark one.html
}

@test "a run that is served is followed as it goes on, and its end is told" {
  rm -rf live go
  tm-evolve -q --step 'while [ $TM_ITERATION -gt 2 ] && [ ! -e go ]; do sleep 0.02; done; tm-transform -q --scale 1.5' \
    --iterations 4 --every 1 --run live torus.ply 3>&- &
  loop=$!
  while [ ! -e live/frames/frame-00002.ply ]; do sleep 0.02; done
  tm-view --serve --run live >address 3>&- &
  server=$!
  while [ ! -s address ]; do sleep 0.02; done
  check live "$(cat address)" "$PWD/go" "$server"
  wait "$loop"
  code=0
  wait "$server" || code=$?
  [ "$code" -eq 130 ]
}
