load ../helpers/common

# A textured sphere with dents, photographed by a ring of cameras.
setup_file() {
  cd "$BATS_FILE_TMPDIR"
  mkdir photos
  tm-shape dented --faces 3000 -o truth.ply
  tm-photograph --size 160x120 --ring 8 --noise 0 --write-images photos -o par.txt truth.ply
}

setup() {
  scene=$BATS_FILE_TMPDIR
  cd "$BATS_TEST_TMPDIR"
  color=(tm-color --cameras "$scene/par.txt" --images "$scene/photos")
}

# value KEY FILE: prints a number of a report.
value() { awk -v key="\"$1\":" '$1 == key { gsub(",", "", $2); print $2 }' "$2"; }

@test "vertices get colors on a pipe, and keep all else" {
  pipe "${color[*]} --report r.json <$scene/truth.ply | tm-convert --format ply-ascii >colored.ply"
  assert_status 0
  grep -qx "property uchar red" colored.ply
  awk '/^element vertex/ { n = $3 } inside && n-- > 0 { sum += $4; squares += $4 * $4; ++count; if ($4 != $5 || $5 != $6) exit 1 }
    /^end_header/ { inside = 1 }
    END { mean = sum / count; deviation = sqrt(squares / count - mean * mean)
          exit !(mean > 100 && mean < 156 && deviation > 15) }' colored.ply
  [ "$(value views r.json)" -eq 8 ]
  awk -v d="$(value disagreement r.json)" 'BEGIN { exit !(d < 8) }'
  tm-transform --translate 0,0,0 "$scene/truth.ply" -o same.ply
  [ "$(tm-info --json same.ply | jq -c '[.volume, .area]')" = "$(tm-info --json colored.ply | jq -c '[.volume, .area]')" ]
  tm-render --size 80x60 colored.ply -o picture.png
}

@test "a texture is beside an OBJ with its materials, beside a PLY, and in a GLB" {
  for name in a.obj a.ply a.glb; do
    mkdir "${name#a.}"
    "${color[@]}" --texture "$scene/truth.ply" -o "${name#a.}/$name" --report r.json
  done
  [ "$(value charts r.json)" -ge 2 ]
  cmp obj/a.png ply/a.png
  grep -qx "mtllib a.mtl" obj/a.obj
  grep -qx "usemtl photographs" obj/a.obj
  grep -q "^vt " obj/a.obj
  grep -qx "newmtl photographs" obj/a.mtl
  grep -qx "map_Kd a.png" obj/a.mtl
  grep -qxa "comment TextureFile a.png" ply/a.ply
  grep -qxa "property list uchar float texcoord" ply/a.ply
  [ ! -e glb/a.png ]
  grep -qa KHR_materials_unlit glb/a.glb

  # The mesh file contains the picture byte for byte.
  offset=$(LC_ALL=C grep -obaF "PNG" glb/a.glb | head -n 1 | cut -d: -f1)
  cmp <(tail -c "+$offset" glb/a.glb | head -c "$(stat -c %s obj/a.png)") obj/a.png
}

@test "a texture is as large as it may be, and the same for any number of threads" {
  for threads in 1 2 4; do
    mkdir "$threads"
    "${color[@]}" --texture --texture-size 128 --threads "$threads" "$scene/truth.ply" \
      -o "$threads/a.obj" --report r.json
    [ "$(value texture_width r.json)" -le 128 ]
    [ "$(value texture_height r.json)" -le 128 ]
    for file in a.obj a.mtl a.png; do cmp "1/$file" "$threads/$file"; done
  done
}

@test "refused: a texture on a pipe or in a format without textures, and a mesh that no photograph shows" {
  run --separate-stderr "${color[@]}" --texture "$scene/truth.ply"
  assert_status 2
  [[ $stderr == *"-o NAME.obj"* ]]
  for format in off stl vtp 3mf xyz; do
    run --separate-stderr "${color[@]}" --texture "$scene/truth.ply" -o "a.$format"
    assert_status 2
    [[ $stderr == *"not for $format"* ]]
    [ ! -e "a.$format" ] && [ ! -e a.png ]
  done
  tm-stitch --flip "$scene/truth.ply" -o inside_out.ply
  run --separate-stderr "${color[@]}" inside_out.ply
  assert_status 3
  [[ $stderr == *"the mesh is visible in no view"* ]]
  run --separate-stderr "${color[@]}" --texture --texture-size 16 "$scene/truth.ply" -o a.obj
  assert_status 4
  [ ! -e a.obj ] && [ ! -e a.png ]
}
