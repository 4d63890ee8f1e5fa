load ../helpers/common
load ../helpers/scene

# Errors in cameras, photographs and masks, for every program that reads them and for the loop. Each gives
# exit code 3, nothing is written, and one line names the file and, in text files, the line.

setup() {
  cd "$BATS_TEST_TMPDIR"
  make_scene .
  mkdir photos
  for name in a b c; do mask 2 6 200 >photos/$name.pgm; done
  tm-shape sphere --radius 2 -o ball.ply
}

# Runs every program that reads the `images` or the `masks` of the scene, with the cameras in $cameras.
refused_by_all() { # READS WORD...
  local reads=$1 program
  shift
  for program in cameras hull photo-step photograph reconstruct; do
    case $reads/$program in
      images/cameras) run --separate-stderr tm-cameras --images photos -o out.txt "$cameras" ;;
      images/hull) run --separate-stderr tm-hull --cameras "$cameras" --images photos -o out.ply ;;
      */photo-step)
        run --separate-stderr tm-photo-step --cameras "$cameras" --images photos --silhouettes masks \
          -o out.ply ball.ply
        ;;
      */reconstruct)
        run --separate-stderr tm-reconstruct --cameras "$cameras" --images photos --silhouettes masks \
          -o out.ply
        ;;
      masks/hull) run --separate-stderr tm-hull --cameras "$cameras" --silhouettes masks -o out.ply ;;
      masks/photograph)
        run --separate-stderr tm-photograph --cameras "$cameras" --compare-silhouettes masks \
          -o out.txt ball.ply
        ;;
      *) continue ;;
    esac
    [ "$status" -eq 3 ] || fail "tm-$program: exit code $status: $stderr"
    [ -z "$output" ] || fail "tm-$program wrote to stdout: $output"
    one_line "$stderr"
    local word
    for word in "$@"; do [[ $stderr == *"$word"* ]] || fail "tm-$program: no '$word' in: $stderr"; done
    [ ! -e out.txt ] && [ ! -e out.ply ] && [ ! -e out.ply.tm-reconstruct ] ||
      fail "tm-$program left something behind: $(echo out.*)"
  done
}

@test "the scene is read where nothing is wrong with it" {
  tm-cameras --images photos -o out.txt par.txt
  tm-hull --cameras par.txt --images photos -o hull.ply
  tm-hull --cameras par.txt --silhouettes masks -o hull.ply
  tm-photograph --cameras par.txt --compare-silhouettes masks -o out.txt ball.ply
}

@test "a missing image, a missing mask: of which camera, and on which line" {
  cameras=par.txt
  rm photos/b.pgm
  refused_by_all images par.txt b.pgm 'line 3' photos
  mask 2 6 200 >photos/b.pgm
  rm masks/c.pgm
  refused_by_all masks c.pgm masks
}

@test "more images than cameras" {
  cameras=par.txt
  mask 2 6 200 >photos/d.pgm
  run --separate-stderr tm-cameras --images photos par.txt
  assert_status 0
  [[ $stderr == *"1 image in photos without camera left out, the first is photos/d.pgm" ]]
  for program in "tm-cameras --images photos par.txt" \
    "tm-hull --cameras par.txt --images photos" \
    "tm-photo-step --cameras par.txt --images photos ball.ply" \
    "tm-reconstruct --cameras par.txt --images photos --silhouettes masks"; do
    read -ra words <<<"$program"
    run --separate-stderr "${words[0]}" --missing refuse "${words[@]:1}" -o out.ply
    assert_status 3
    [[ $stderr == *"d.pgm"* ]] || fail "$program: $stderr"
    one_line "$stderr"
    [ ! -e out.ply ]
  done
  rm photos/d.pgm
  mask 2 6 >masks/d.pgm
  run --separate-stderr tm-hull --cameras par.txt --silhouettes masks -o out.ply
  assert_status 0
  [[ $stderr == *"1 silhouette in masks without camera left out, the first is masks/d.pgm"* ]]
}

@test "fewer cameras than the file says" {
  cameras=par.txt
  sed -i '4d' par.txt
  refused_by_all images par.txt 'line 4' 'only 2'
}

@test "distortion" {
  mkdir colmap
  cat >colmap/cameras.txt <<'C'
# a comment
1 SIMPLE_RADIAL_FISHEYE 9 9 10 4.5 4.5 0.1
C
  for i in 1 2 3; do
    printf '%d 1 0 0 0 0 0 10 1 %s.pgm\n\n' $i "$(cut -c$i <<<abc)"
  done >colmap/images.txt
  cameras=colmap
  refused_by_all images cameras.txt 'line 2' distort
}

@test "a singular matrix" {
  cameras=par.txt
  cp par.txt good.txt
  sed -i '3s/ 10 0 4 0 10 4 / 10 0 4 20 0 8 /' par.txt
  refused_by_all images par.txt 'line 3'
  # The matrix is not a rotation.
  sed '4s/.*/c.pgm 10 0 4 0 10 4 0 0 1 1 0 0 1 0 0 0 -1 0 0 0 10/' good.txt >par.txt
  refused_by_all images par.txt 'line 4'
  mkdir matrices
  for name in a b c; do printf '1 0 0 1\n0 1 0 2\n1 1 0 3\n' >matrices/$name.txt; done
  cameras=matrices
  refused_by_all images matrices/a.txt singular
}

@test "an empty silhouette" {
  cameras=par.txt
  mask 9 9 >masks/b.pgm
  refused_by_all masks masks/b.pgm empty
}

@test "images of other sizes: than the others, than their masks, than the cameras say" {
  cameras=par.txt
  mask 2 6 200 | awk 'NR == 1 { print "P2 9 10 255"; next } { print } END { print $0 }' >photos/b.pgm
  refused_by_all images b.pgm '9 x 10'
  mask 2 6 200 >photos/b.pgm
  mask 2 6 | awk 'NR == 1 { print "P2 9 10 255"; next } { print } END { print $0 }' >masks/c.pgm
  refused_by_all masks masks/c.pgm '9 x 10'
  mask 2 6 >masks/c.pgm
  mkdir colmap
  echo '1 PINHOLE 9 8 10 10 4.5 4.5' >colmap/cameras.txt
  for i in 1 2 3; do
    printf '%d 1 0 0 0 0 0 10 1 %s.pgm\n\n' $i "$(cut -c$i <<<abc)"
  done >colmap/images.txt
  cameras=colmap
  refused_by_all images photos/a.pgm '9 x 8'
}

@test "an image that is none, and a file that cannot be read" {
  cameras=par.txt
  head -c 20 photos/b.pgm >cut.pgm
  mv cut.pgm photos/b.pgm
  refused_by_all images photos/b.pgm
}
