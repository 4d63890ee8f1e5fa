# Meshes in tiles: split, cleaned one by one, joined.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# clean_tiles FOLDER [OPTION]...
clean_tiles() {
  local tile folder=$1
  shift
  for tile in "$folder"/tile-*.ply; do
    tm-clean -q "$@" "$tile" -o "${tile/tile-/clean-}"
  done
}

# through_tiles MESH N [OPTION]...: splits the mesh, cleans the tiles with these options, and joins them.
through_tiles() {
  rm -rf tiles
  tm-tile split "$1" --tiles "$2" -o tiles
  clean_tiles tiles "${@:3}"
  tm-tile join tiles -o joined.ply
}

# is_whole: checks that joined.ply equals whole.ply except for the order.
is_whole() {
  cmp <(triangles joined.ply) <(triangles whole.ply) &&
    diff <(tm-info joined.ply | grep -E '^(vertices|faces|components|genus):') \
      <(tm-info whole.ply | grep -E '^(vertices|faces|components|genus):')
}

@test "tiles, cleaned alone and joined, are the triangles and connections of one process" {
  local kind count
  for kind in many-spheres "folded sphere" "tangle 3 5" pinch "many-spheres --float"; do
    # shellcheck disable=SC2086 # several words
    tm-shape $kind --faces 10000 -o in.ply
    tm-clean in.ply -o whole.ply
    for count in 1 2 7 16; do
      through_tiles in.ply "$count"
      is_whole || fail "$kind in $count tiles"
      tm-checkmanifold --closed --intersections joined.ply
    done
  done
}

@test "so are bodies that share planes, edges and corners, and copies that overlap" {
  local i
  for i in 0 1 2 3 4 5 6 7 8; do
    tm-shape box 1 1 1 --faces 1200 --center "$((i % 3)),$((i / 3)).25,$((i % 2)).5" -o "box_$i.ply"
  done
  tm-cat box_?.ply -o in.ply
  tm-clean in.ply -o whole.ply
  for count in 2 7 16; do
    through_tiles in.ply "$count"
    is_whole || fail "boxes in $count tiles"
  done
  tm-shape folded sphere --faces 8000 -o once.ply
  tm-shape two-spheres --faces 3000 | tm-cat once.ply once.ply - -o in.ply
  for level in 1 2 3; do
    tm-clean --level "$level" in.ply -o whole.ply
    through_tiles in.ply 6 --level "$level"
    is_whole || fail "level $level"
  done
}

@test "properties, comments and byte order come through" {
  tm-shape many-spheres --faces 4000 | tm-clean -q --source-face | tm-convert --format ply-be --float -o one.ply
  tm-transform --translate 0.3,0,0 one.ply | tm-cat one.ply - -o in.ply
  through_tiles in.ply 5
  sed '/^end_header/q' joined.ply >header
  grep -qx 'format binary_big_endian 1.0' header
  grep -qx 'property float x' header
  grep -qx 'property int source_face' header
  [ "$(grep -c '^comment tm-tile .* join$' header)" -eq 1 ]
  run ! grep -q '^comment tm:' header
  tm-clean in.ply -o whole.ply
  is_whole
  cmp <(tm-convert --format ply-ascii joined.ply | sed '1,/^end_header/d' | awk 'NF == 5 { print $5 }' | sort) \
    <(tm-convert --format ply-ascii whole.ply | sed '1,/^end_header/d' | awk 'NF == 5 { print $5 }' | sort)
}

@test "the report adds up, and tiles are the same bytes on every run" {
  tm-shape folded sphere --faces 20000 -o in.ply
  tm-tile split in.ply --tiles 4 -o tiles --report split.json
  tm-tile split in.ply --tiles 4 -o again --threads 1
  diff -r tiles again
  [ "$(jq .result.tiles split.json)" = 4 ]
  [ "$(jq .result.faces split.json)" = "$(tm-info --get faces in.ply)" ]
  sum=0
  own=0
  for tile in tiles/tile-*.ply; do
    sum=$((sum + $(tm-info --get faces "$tile")))
    tm-clean "$tile" -o "${tile/tile-/clean-}" --report clean.json
    own=$((own + $(jq .result.box_faces clean.json)))
  done
  [ "$(jq .result.tile_faces split.json)" = "$sum" ]
  [ "$own" = "$(tm-info --get faces in.ply)" ]
  tm-tile join tiles --report join.json >joined.ply
  [ "$(jq .result.vertices join.json)" = "$(tm-info --get vertices joined.ply)" ]
  [ "$(jq .result.joined_vertices join.json)" -gt 0 ]
}

@test "meshes that cannot be split are refused, and nothing is left" {
  tm-shape sphere --faces 2000 -o in.ply
  tm-select --box=-9,-9,-9,9,9,.5 in.ply -o open.ply
  tm-convert --format ply-ascii in.ply -o text.ply
  tm-convert in.ply -o ball.stl
  head -c -5 in.ply >short.ply
  tm-select --box=50,50,50,60,60,60 in.ply -o none.ply 2>/dev/null || tm-clean --only --box=50,50,50,60,60,60 in.ply -o none.ply
  : >empty.ply
  local file
  for file in open.ply text.ply ball.stl short.ply none.ply empty.ply missing.ply . /dev/stdin; do
    run --separate-stderr tm-tile split "$file" --tiles 2 -o tiles < <(cat in.ply)
    assert_status 3
    one_line "$stderr"
    [ ! -e tiles ] || fail "$file left $(ls -A tiles)"
  done
  mkdir there
  run --separate-stderr tm-tile split in.ply --tiles 2 -o there
  assert_status 5
  one_line "$stderr"
  run --separate-stderr tm-tile split in.ply --tiles 2
  assert_status 2
  run --separate-stderr tm-tile split in.ply -o tiles
  assert_status 2
  run --separate-stderr tm-tile slpit in.ply -o tiles
  assert_status 2
  [[ $stderr == *"did you mean 'split'"* ]]
  run --separate-stderr tm-tile join
  assert_status 2
}

@test "a vertex that is no number is named" {
  tm-shape sphere --faces 500 -o in.ply
  # Changes the last coordinate of the last vertex; faces take 13 bytes each.
  faces=$(tm-info --get faces in.ply)
  size=$(stat -c %s in.ply)
  { head -c $((size - 13 * faces - 8)) in.ply && printf '\0\0\0\0\0\0\370\177' && tail -c $((13 * faces)) in.ply; } >nan.ply
  run --separate-stderr tm-tile split nan.ply --tiles 2 -o tiles
  assert_status 3
  [[ $stderr == *"vertex $(($(tm-info --get vertices in.ply) - 1)) has a coordinate that is not a finite number"* ]]
}

@test "tiles that cannot be cleaned or joined are named" {
  tm-shape two-spheres --faces 4000 -o in.ply
  tm-tile split in.ply --tiles 3 -o tiles
  run --separate-stderr tm-tile join tiles -o out.ply
  assert_status 3
  [[ $stderr == *"'tiles/clean-0.ply' is missing"* ]]
  clean_tiles tiles
  rm tiles/clean-1.ply
  run --separate-stderr tm-tile join tiles -o out.ply
  assert_status 3
  [[ $stderr == *"tile 1 of 3"* ]]
  tm-clean --level 2 tiles/tile-1.ply -o tiles/clean-1.ply
  run --separate-stderr tm-tile join tiles -o out.ply
  assert_status 3
  one_line "$stderr"
  cp tiles/tile-1.ply tiles/clean-1.ply
  run --separate-stderr tm-tile join tiles -o out.ply
  assert_status 3
  [ ! -e out.ply ]
  for options in "--box 0,0,0,1,1,1" --outermost --merge-flat "--method static" --source --float; do
    # shellcheck disable=SC2086 # several words
    run --separate-stderr tm-clean $options tiles/tile-1.ply -o out.ply
    assert_status 2
    one_line "$stderr"
  done
  sed 's/^comment tm:tile/comment held/' tiles/tile-1.ply | tm-transform --scale 2 |
    sed 's/^comment held/comment tm:tile/' >scaled.ply
  run --separate-stderr tm-clean scaled.ply -o out.ply
  assert_status 3
  [[ $stderr == *"differs from the tile"* ]]
  sed 's/^comment tm:tile 1 3/comment tm:tile 7 3/' tiles/tile-1.ply >bad.ply
  run --separate-stderr tm-clean bad.ply -o out.ply
  assert_status 3
  run --separate-stderr tm-tile join .. -o out.ply
  assert_status 3
  run --separate-stderr tm-tile join missing -o out.ply
  assert_status 3
}

@test "only tm-clean changes tiles: other programs refuse them, or say what they show" {
  tm-shape folded --faces 4000 -o in.ply
  tm-tile split in.ply --tiles 3 -o tiles
  tm-clean -q tiles/tile-1.ply -o tiles/clean-1.ply
  for tile in tiles/tile-1.ply tiles/clean-1.ply; do
    for program in tm-repair tm-remesh tm-transform tm-convert; do
      run --separate-stderr "$program" "$tile" -o out.ply
      assert_status 3
      [[ $stderr == *"is a tile of a larger mesh"*"tm-tile join"* ]]
      [ ! -e out.ply ]
    done
    run --separate-stderr tm-info "$tile"
    assert_status 0
    [[ $stderr == *"is a tile of a larger mesh, cut at its borders" ]]
  done
  # A comment that describes no tile does not keep a mesh from being looked at.
  sed 's/^comment tm:tile .*/comment tm:tile none/' tiles/tile-1.ply >bad.ply
  run --separate-stderr tm-info bad.ply
  assert_status 0
}

@test "a tile that needs the whole mesh says so, with exit code 4" {
  tm-shape boxes --faces 10000 -o in.ply
  tm-tile split in.ply --tiles 16 -o tiles
  run --separate-stderr tm-clean tiles/tile-05.ply -o out.ply
  assert_status 4
  one_line "$stderr"
  [ ! -e out.ply ]
}

@test "a full disk is exit 5, and leaves no folder" {
  [ "$(id -u)" -eq 0 ] || skip "needs a file system of its own"
  tm-shape sphere --faces 200000 -o in.ply
  mkdir small
  mount -t tmpfs -o size=1m none small 2>/dev/null || skip "no file system can be mounted"
  run --separate-stderr tm-tile split in.ply --tiles 4 -o small/tiles
  left=$(ls -A small)
  umount small
  [ -z "$left" ] || fail "left behind: $left"
  assert_status 5
  one_line "$stderr"
}

@test "--max-memory ends with exit code 6 where a tile does not fit" {
  tm-shape sphere --faces 400000 -o in.ply
  run --separate-stderr tm-tile split in.ply --tiles 1 -o tiles --max-memory 20M
  assert_status 6
  one_line "$stderr"
}

@test "scripts/experiments/tiles continues where it stopped, and names failures" {
  tm-shape folded sphere --faces 8000 -o in.ply
  tm-clean in.ply -o whole.ply
  "$tm_root/scripts/experiments/tiles" in.ply out 4
  cp out/clean.ply joined.ply
  is_whole
  # A clean tile is not cleaned again; a missing one is.
  rm out/clean.ply out/tiles/clean-2.ply out/tile-*.json
  "$tm_root/scripts/experiments/tiles" in.ply out 4
  [ "$(echo out/tile-*.json)" = out/tile-2.json ]
  cmp out/clean.ply joined.ply
  rm out/tiles/clean-1.ply
  printf x >>out/tiles/tile-1.ply
  sed -i 's/^comment tm:tile 1 4/comment tm:tile 1 0/' out/tiles/tile-1.ply
  run --separate-stderr "$tm_root/scripts/experiments/tiles" in.ply out 4
  assert_status 1
  [[ $stderr == *"1 of 4 tiles are not clean"* ]]
  grep -q 'does not describe a tile' out/tile-1.log
}

# Replaces Slurm if it is not installed: runs the tasks of an array one after the other.
@test "by sbatch, tiles are an array, and the job that joins depends on it" {
  mkdir bin
  cat >bin/sbatch <<'SBATCH'
#!/bin/bash
echo "$@" >>"$PWD/jobs"
last=0
while [ $# -gt 0 ]; do
  case $1 in
    --array=0-*) last=${1#--array=0-} ;;
    --wrap) command=$2 ;;
  esac
  shift
done
for i in $(seq 0 "$last"); do SLURM_ARRAY_TASK_ID=$i bash -c "$command" >&2 || exit 1; done
echo 17
SBATCH
  chmod +x bin/sbatch
  tm-shape folded sphere --faces 8000 -o in.ply
  tm-clean in.ply -o whole.ply
  PATH=$PWD/bin:$PATH "$tm_root/scripts/experiments/tiles" in.ply out 3 --partition=main
  grep -q -- '--array=0-2 .*' jobs
  grep -q -- '--dependency=afterany:17' jobs
  [ "$(grep -c -- '--partition=main' jobs)" -eq 2 ]
  cp out/clean.ply joined.ply
  is_whole
}
