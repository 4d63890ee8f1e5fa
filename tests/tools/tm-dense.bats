load ../helpers/common

# 20 photographs of 200x150 pixels of a ball that sinks into a large table. No mask is made.
setup_file() {
  cd "$BATS_FILE_TMPDIR"
  mkdir images
  tm-shape box 7 7 0.4 --faces 4000 | tm-transform --translate 0,0,-0.8 -o slab.ply
  tm-shape sphere --radius 1 --faces 8000 -o ball.ply
  tm-boolean union slab.ply ball.ply -q -o truth.ply
  tm-photograph --ring 20 --elevations 50,25 --size 200x150 --focal 1.2 --distance 5 --finest 1.5% \
    --coarsest 10% --write-images images -o par.txt truth.ply
  tm-dense --cameras par.txt --images images --box=-1.7,-1.7,-0.9,1.7,1.7,1.2 --report scene.json \
    -q -o scene.ply
}

setup() {
  scene=$BATS_FILE_TMPDIR
  cd "$BATS_TEST_TMPDIR"
  dense=(tm-dense --cameras "$scene/par.txt" --images "$scene/images")
}

value() { # KEY FILE
  awk -v key="\"$1\":" '$1 == key { gsub("[\",]", "", $2); print $2; exit }' "$2"
}

below() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }' || fail "$1 is not below $2"; }

@test "a ball on a table: on the truth, complete from above, open, without a self-intersection" {
  tm-checkmanifold "$scene/scene.ply"
  run ! tm-checkmanifold --closed "$scene/scene.ply"
  tm-intersect --check "$scene/scene.ply"
  # A pixel is 0.021 wide at the ball.
  below "$(tm-compare --get accuracy "$scene/scene.ply" "$scene/truth.ply")" 0.0315
  tm-select --box=-1.2,-1.2,-0.2,1.2,1.2,1.2 -q "$scene/truth.ply" -o upper.ply
  below 0.9 "$(tm-compare --distance 0.0315 --get completeness "$scene/scene.ply" upper.ply)"
  [ "$(value idle_views "$scene/scene.json")" -eq 0 ]
  below 20000 "$(value consistent_pixels "$scene/scene.json")"
}

@test "points of COLMAP bound the search, and are counted" {
  mkdir sparse
  tm-cameras --format colmap --images "$scene/images" --folder sparse "$scene/par.txt"
  awk 'BEGIN { for (i = 0; i < 400; ++i)
    printf "%d %g %g %g 0 0 0 0.5 1 %d 2 %d 3 %d\n", i, sin(i), cos(1.7 * i), sin(2.3 * i), i, i, i }' \
    >sparse/points3D.txt
  tm-dense --cameras sparse --images "$scene/images" --report r.json -q --edge 2% -o out.ply
  [ "$(value sparse_points r.json)" -eq 400 ]
  below -1.25 "$(tm-info --get bbox_min out.ply | awk '{ print $1 }')"
  below "$(tm-info --get bbox_max out.ply | awk '{ print $1 }')" 1.25
}

@test "views that add nothing are named, and a size of cells is taken" {
  cp -r "$scene/images" images
  awk 'BEGIN { print "P2 200 150 255"; for (i = 0; i < 30000; ++i) print 90 }' >images/view0003.pgm
  rm images/view0003.png
  run --separate-stderr tm-dense --cameras "$scene/par.txt" --images images --box=-1,-1,-0.9,1,1,1.2 \
    --edge 0.1 --report r.json -o out.ply
  assert_status 0
  [[ $stderr == *"the view 'view0003' adds nothing"* ]] || fail "$stderr"
  [ "$(value idle_views r.json)" -eq 1 ]
  [ "$(value cell r.json)" = 0.1 ]
}

@test "bad input is named: a box elsewhere, no texture, one photograph" {
  run --separate-stderr "${dense[@]}" --box 90,90,90,91,91,91 -o out.ply
  assert_status 3
  one_line "$stderr"
  run --separate-stderr "${dense[@]}" --box 1,1,1,0,0,0 -o out.ply
  assert_status 2
  mkdir gray
  for i in 0 1 2; do
    awk 'BEGIN { print "P2 200 150 255"; for (i = 0; i < 30000; ++i) print 90 }' >gray/view000$i.pgm
  done
  run --separate-stderr tm-dense --cameras "$scene/par.txt" --images gray -q -o out.ply
  assert_status 4
  one_line "$stderr"
  rm gray/view000[12].pgm
  run --separate-stderr tm-dense --cameras "$scene/par.txt" --images gray -q -o out.ply
  assert_status 3
  [ ! -e out.ply ]
}

@test "tm-reconstruct begins with such a surface, says so, and ends on the truth" {
  run --separate-stderr tm-reconstruct --cameras "$scene/par.txt" --images "$scene/images" \
    --passes 1 --coarsest 1 -o out.ply
  assert_status 0
  [[ $stderr == *"depth maps"* ]] || fail "$stderr"
  tm-checkmanifold out.ply
  tm-intersect --check out.ply
  tm-select --box=-1.2,-1.2,-0.9,1.2,1.2,1.2 -q out.ply -o part.ply
  below "$(tm-compare --get accuracy part.ply "$scene/truth.ply")" 0.0315
}
