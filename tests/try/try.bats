#!/usr/bin/env bats
# The page of docs/try in headless Chromium: its results have the bytes of the native programs, and so have
# the command lines that it prints. Skipped without a browser or the module of scripts/wasm.
load ../helpers/common
load ../helpers/try

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  has_try || return 0
  "$tm_root/scripts/try" site 2>/dev/null
  tm-shape folded torus --faces 3000 -o folded.stl
  tm-shape sphere --faces 2000 -o ball.ply
  tm-shape sphere --faces 500 -o small.ply
  tm-shape torus --faces 2000 | tm-convert -o ring.obj
  tm-shape boxes --count 4 -o boxes.off
  tm-select -q --plane=0,-1,0,-0.8 ball.ply -o open.ply
  tm-select -q --box=0.2,-0.6,-0.6,2,0.6,0.6 open.ply -o patch.ply
  tm-select -q --invert --box=0.2,-0.6,-0.6,2,0.6,0.6 open.ply | tm-cat -q - <(tm-stitch -q --flip patch.ply) |
    tm-convert -q -o broken.stl
}

setup() {
  cd "$BATS_FILE_TMPDIR"
  needs_try
}

# Drops the files, runs the task, and compares the result with that of the page's command line.
same_as_pasted() { # KIND FIELDS FILE...
  local name=$BATS_TEST_TMPDIR
  mkdir "$name/page" "$name/shell"
  try_page task "$name/page" "$@"
  cp "${@:3}" "$name/shell"
  (cd "$name/shell" && sh -e ../page/command.sh 2>/dev/null)
  rm "$name/page/command.sh"
  for file in "$name"/page/*; do cmp "$file" "$name/shell/${file##*/}"; done
  [ "$(find "$name/page" -type f | wc -l)" = 1 ]
}

@test "a repair has the bytes of tm-repair" {
  same_as_pasted repair '{}' folded.stl
  tm-repair -q folded.stl -o expected.stl
  cmp expected.stl "$BATS_TEST_TMPDIR/page/folded-repaired.stl"
}

@test "a repair that leaves holes open has the bytes of tm-repair" {
  same_as_pasted repair '{"keepOpen": "on"}' broken.stl
  tm-repair -q --keep-open broken.stl -o expected.stl
  cmp expected.stl "$BATS_TEST_TMPDIR/page/broken-repaired.stl"
}

@test "a union has the bytes of tm-boolean" {
  same_as_pasted combine '{"operation": "union"}' ball.ply ring.obj
  tm-boolean -q union ball.ply ring.obj -o expected.ply
  cmp expected.ply "$BATS_TEST_TMPDIR/page/ball-with-ring.ply"
}

@test "a difference has the bytes of tm-boolean" {
  same_as_pasted combine '{"operation": "difference"}' ring.obj ball.ply
  tm-boolean -q difference ring.obj ball.ply -o expected.obj
  cmp expected.obj "$BATS_TEST_TMPDIR/page/ring-without-ball.obj"
}

@test "an intersection has the bytes of tm-boolean" {
  same_as_pasted combine '{"operation": "intersection", "other": "ring.obj"}' ball.ply boxes.off ring.obj
  tm-boolean -q intersection ball.ply ring.obj -o expected.ply
  cmp expected.ply "$BATS_TEST_TMPDIR/page/ball-in-ring.ply"
}

@test "an offset has the bytes of tm-offset" {
  same_as_pasted offset '{"distance": "-2%"}' ring.obj
  tm-offset -q --distance=-2% ring.obj -o expected.obj
  cmp expected.obj "$BATS_TEST_TMPDIR/page/ring-offset.obj"
}

@test "a decimation has the bytes of tm-remesh" {
  same_as_pasted decimate '{"error": "0.5%"}' boxes.off
  tm-remesh -q --error=0.5% boxes.off -o expected.off
  cmp expected.off "$BATS_TEST_TMPDIR/page/boxes-decimated.off"
}

@test "a morph has the bytes of tm-morph, and its film the frames" {
  same_as_pasted morph '{"every": "5"}' ball.ply ring.obj
  tm-morph -q ball.ply --target ring.obj --every 5 --frames frames -o expected.ply
  cmp expected.ply "$BATS_TEST_TMPDIR/page/ball-to-ring.ply"
  diff -r frames "$BATS_TEST_TMPDIR/shell/ball-to-ring-frames"
  try_page film ball.ply ring.obj "$(find frames -name '*.ply' | wc -l)"
}

@test "names with spaces, quotes and dashes are quoted in the command line" {
  cp folded.stl "$BATS_TEST_TMPDIR/-it's \$1 of two.stl"
  cd "$BATS_TEST_TMPDIR"
  mkdir page shell
  try_page task page repair '{}' "./-it's \$1 of two.stl"
  cp "./-it's \$1 of two.stl" shell
  (cd shell && sh -e ../page/command.sh 2>/dev/null)
  cmp "page/-it's \$1 of two-repaired.stl" "shell/-it's \$1 of two-repaired.stl"
}

@test "a task on a result, in another format, has the command lines of both" {
  cd "$BATS_TEST_TMPDIR"
  mkdir page shell
  try_page chain page "$BATS_FILE_TMPDIR/folded.stl" '["repair"]' '["decimate", {"error": "1%"}]' off
  cp "$BATS_FILE_TMPDIR/folded.stl" shell
  (cd shell && sh -e ../page/command.sh 2>/dev/null)
  cmp page/folded-repaired-decimated.off shell/folded-repaired-decimated.off
  tm-repair -q shell/folded.stl -o one.stl
  tm-remesh -q --error=1% one.stl -o expected.off
  cmp expected.off page/folded-repaired-decimated.off
}

@test "counts are those of the native programs" {
  for file in folded.stl broken.stl ring.obj boxes.off open.ply; do
    tm-stitch -q "$file" -o joined.ply
    # Faces with inconsistent orientations have borders where tm-stitch separates them. The holes are those of
    # the mesh after --orient.
    tm-stitch -q --orient --outwards "$file" -o turned.ply --report turned.json
    jq -n --argjson check "$(tm-checkmanifold --json turned.ply 2>/dev/null || true)" \
      --argjson info "$(tm-info --json turned.ply)" --argjson pairs "$(tm-intersect -q --check --get pairs "$file" || true)" \
      --slurpfile turned turned.json \
      '{intersections: $pairs, holes: $check.boundary_loops, turned: $turned[0].result.turned_faces,
        faces: $info.faces, parts: $info.components, volume: $info.volume}' >expected.json
    try_page counts "$file" | jq '{intersections, holes, turned, faces, parts, volume}' >found.json
    diff expected.json found.json || fail "$file"
  done
  [ "$(jq .turned turned.json expected.json | tail -1)" = 0 ]
}

@test "holes and flipped parts are seen in their colors, and repaired" {
  try_page highlights broken.stl
}

@test "a line parts before and after" {
  try_page compare ball.ply
}

@test "nothing is asked for after loading, and nobody else can be asked" {
  try_page private folded.stl
}

@test "everything is reached and done by the keyboard" {
  try_page keyboard folded.stl
}

@test "axe-core finds nothing and nothing is cut off on a phone, light or dark" {
  try_page accessible phone small.ply ring.obj
}

@test "axe-core finds nothing and nothing is cut off on a laptop, light or dark" {
  try_page accessible laptop small.ply ring.obj
}

@test "axe-core finds nothing and nothing is cut off on a large screen, light or dark" {
  try_page accessible large small.ply ring.obj
}

@test "what cannot be done is said" {
  try_page refusals ring.obj
}

@test "without WebGL all works but the view" {
  try_page plain "$BATS_TEST_TMPDIR" folded.stl
  tm-repair -q folded.stl -o expected.stl
  cmp expected.stl "$BATS_TEST_TMPDIR/folded-repaired.stl"
}

@test "each example opens" {
  try_page examples
}

@test "sheets that touch at an edge are no fault, and a wing at an edge is one" {
  # Two cubes share one edge, at which four faces meet, in pairs.
  tm-shape box 1 1 1 --faces 12 -o one.ply
  tm-shape box 1 1 1 --faces 12 --center 1,1,0 | tm-cat -q one.ply - | tm-stitch -q -o touching.ply
  tm-checkmanifold --closed touching.ply
  try_page counts touching.ply | jq -e '.branching == 0 and .holes == 0 and .intersections == 0'
  # A tetrahedron with one more face at an edge.
  tetrahedron | sed -e 's/vertex 4/vertex 5/' -e 's/face 4/face 5/' -e 's/^0 1 1$/&\n3 3 0/' >wing.ply
  echo '3 0 1 4' >>wing.ply
  try_page counts wing.ply | jq -e '.branching == 1 and .holes == 1 and .turned == 0'
}
