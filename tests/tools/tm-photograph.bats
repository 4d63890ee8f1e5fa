load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  mkdir images masks
  tm-shape torus --faces 3000 -o truth.ply
  size=(--size 80x60 --ring 6)
}

@test "photographs, masks and cameras of a ring belong together" {
  run --separate-stderr tm-photograph "${size[@]}" --write-images images \
    --write-silhouettes masks -o par.txt truth.ply
  assert_status 0
  [ -z "$output$stderr" ]
  [ "$(ls images | wc -l)" -eq 6 ]
  [ "$(ls images)" = "$(ls masks)" ]
  tm-cameras --list par.txt --images images >table
  grep -q '80x60' table
  # The hull of the masks contains the torus, has its hole, and has less than twice its volume.
  tm-hull --cameras par.txt --silhouettes masks --resolution 60 -o hull.ply
  tm-checkmanifold --closed hull.ply
  awk -v hull="$(tm-info --get volume hull.ply)" -v truth="$(tm-info --get volume truth.ply)" \
    'BEGIN { exit !(hull > 0.99 * truth && hull < 2 * truth) }'
}

@test "folders are made, and hold more than two thousand images" {
  tm-shape box --faces 12 | tm-photograph --ring 2100 --size 4x4 --write-images new/images -o /dev/null
  [ "$(ls new/images | wc -l)" -eq 2100 ]
}

@test "given cameras see the same as the ring that they came from" {
  tm-photograph "${size[@]}" --write-images images -o par.txt truth.ply
  mkdir again
  tm-photograph --cameras par.txt --size 80x60 --write-images again -o again.txt <truth.ply
  cmp par.txt again.txt
  diff -r images again
}

@test "agreement is full for the mesh itself and less for another" {
  tm-photograph "${size[@]}" --write-silhouettes masks -o par.txt truth.ply
  agreement=(tm-photograph --cameras par.txt --compare-silhouettes masks -o /dev/null)
  "${agreement[@]}" --report same.json truth.ply
  tm-shape sphere --radius 1 | "${agreement[@]}" --report other.json
  awk '/"silhouette_agreement"/ { if (FILENAME == "same.json") same = $2 + 0; else other = $2 + 0 }
    END { exit !(same > 0.97 && other < 0.9 && other > 0.2) }' same.json other.json
}

@test "seeds, threads, gain and appearance of photographs" {
  tm-photograph "${size[@]}" --write-images images --threads 1 -o par.txt truth.ply
  for arguments in "" "--seed 2" "--gain 0.2" "--look shade" "--noise 0"; do
    rm -rf other && mkdir other
    # shellcheck disable=SC2086
    tm-photograph "${size[@]}" --write-images other --threads 2 $arguments -o other.txt truth.ply
    if [ -z "$arguments" ]; then
      diff -r images other
    else
      cmp -s images/view0000.png other/view0000.png && fail "$arguments changes nothing"
    fi
    cmp par.txt other.txt
  done
}

@test "invalid input is refused" {
  run --separate-stderr tm-photograph --compare-silhouettes masks -o /dev/null truth.ply
  assert_status 2
  run --separate-stderr tm-photograph --write-images truth.ply -o par.txt truth.ply
  assert_status 5
  [ ! -e par.txt ]
  run --separate-stderr tm-photograph -o par.txt <<<$'OFF\n1 0 0\n1 2 3'
  assert_status 3
  one_line "$stderr"
  run --separate-stderr tm-photograph --elevations 90,0 -o par.txt truth.ply
  assert_status 2
  one_line "$stderr"
  run --separate-stderr tm-photograph --finest 2 --coarsest 1 -o par.txt truth.ply
  assert_status 2
}

@test "--focal is the focal length per width, and --waves changes the texture" {
  tm-photograph "${size[@]}" --write-images images -o par.txt truth.ply
  # Columns 2 to 10 have the first camera's K, for images 80 pixels wide.
  awk 'NR == 2 { exit !($2 == 3.4 * 80 && $6 == $2) }' par.txt
  tm-photograph "${size[@]}" --focal 2 --waves 80 --write-images other -o near.txt truth.ply
  awk 'NR == 2 { exit !($2 == 160 && $6 == $2) }' near.txt
  tm-photograph --cameras par.txt --size 80x60 --waves 80 --write-images waves -o /dev/null truth.ply
  ! cmp -s images/view0000.png waves/view0000.png
}

@test "cameras whose images have no known size draw nothing until it is given" {
  tm-photograph "${size[@]}" --write-silhouettes masks -o par.txt truth.ply
  run --separate-stderr tm-photograph --cameras par.txt --write-images new -o out.txt truth.ply
  assert_status 2
  one_line "$stderr"
  [[ $stderr == *"view0000.png (par.txt line 2)"*"--size WxH" ]]
  [ ! -e new ] && [ ! -e out.txt ]
  # COLMAP's cameras state the size of the images, and masks to compare with have it.
  tm-cameras --format colmap --images masks --folder colmap par.txt
  tm-photograph --cameras colmap --write-silhouettes again -o /dev/null truth.ply
  diff -r masks again
  tm-photograph --cameras par.txt --compare-silhouettes masks --write-silhouettes third \
    -o /dev/null truth.ply
  diff -r masks third
}

@test "COLMAP's names with folders: images are found, and written, in folders" {
  tm-photograph "${size[@]}" --write-images images --write-silhouettes masks -o par.txt truth.ply
  tm-cameras --format colmap --images images --folder colmap par.txt
  # Two rigs that give their images the same numbers.
  sed -i 's/view0003/left\/0001/; s/view0004/left\/0002/; s/view0005/left\/0003/
    s/view0000/right\/0001/; s/view0001/right\/0002/; s/view0002/right\/0003/' colmap/images.txt
  for folder in images masks; do
    mkdir $folder/left $folder/right
    for i in 1 2 3; do
      mv $folder/view000$((i - 1)).png $folder/right/000$i.png
      mv $folder/view000$((i + 2)).png $folder/left/000$i.png
    done
  done
  tm-cameras --list colmap --images images >table
  grep -q 'left/0001' table
  tm-hull --cameras colmap --silhouettes masks --resolution 40 -o hull.ply
  tm-hull --cameras par.txt --silhouettes masks --resolution 40 -o hull.ply && fail "no such names"
  tm-photograph --cameras colmap --write-images new --write-silhouettes mask -o new.txt truth.ply
  diff -r masks mask
  [ -e new/left/0003.png ]
  grep -q '^left/0001.png ' new.txt
  tm-hull --cameras new.txt --silhouettes 'masks/*/*.png' --resolution 40 -o again.ply
  cmp hull.ply again.ply
  # Names that lead out of the folder are changed to stay in it.
  sed -i 's/left/..\/up/' colmap/images.txt
  tm-photograph --cameras colmap --write-images in -o out.txt truth.ply
  [ -e in/0001.png ] && [ ! -e up ]
}
