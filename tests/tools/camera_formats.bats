load ../helpers/common
load ../helpers/scene

# The same cameras in every format give the same hull, and come back from what they are written as.

setup() {
  cd "$BATS_TEST_TMPDIR"
  make_balls .
  tm-cameras --format colmap --folder colmap --images masks par.txt
}

# hull NAME CAMERAS [OPTION]...: NAME.ply
hull() {
  tm-hull --cameras "$2" --silhouettes masks --no-provenance -o "$1.ply" "${@:3}"
}

# near FIRST SECOND DISTANCE: neither mesh is anywhere farther from the other.
near() {
  tm-compare --reference "$1.ply" "$2.ply" >compared
  awk -v most="$3" '/^hausdorff:/ { exit !($2 < most) }' compared || fail "$(cat compared)"
}

@test "Middlebury, COLMAP and matrices, there and back" {
  hull par par.txt
  hull colmap colmap
  near par colmap 1e-3
  # Twelve digits leave a skew of their own, which is none.
  mkdir matrices
  tm-cameras --format matrices par.txt | awk '/^#/ { print; next }
    { printf "%.12g %.12g %.12g %.12g\n", $1, $2, $3, $4 }' >matrices.txt
  hull matrices matrices.txt
  near par matrices 1e-3
  tm-cameras --format colmap --images masks --folder back matrices.txt
  hull back back
  near par back 1e-3
}

@test "COLMAP's binary model gives the hull of its text, byte for byte" {
  needs_command python3
  mkdir binary
  python3 - <<'PY'
import struct
ids = {'SIMPLE_PINHOLE': 0, 'PINHOLE': 1}
rows = [l.split() for l in open('colmap/cameras.txt') if not l.startswith('#')]
out = struct.pack('<Q', len(rows))
for r in rows:
    out += struct.pack('<iiQQ', int(r[0]), ids[r[1]], int(r[2]), int(r[3]))
    out += b''.join(struct.pack('<d', float(x)) for x in r[4:])
open('binary/cameras.bin', 'wb').write(out)
rows = [l.split() for l in open('colmap/images.txt') if not l.startswith('#') and l.strip()]
out = struct.pack('<Q', len(rows))
for r in rows:
    out += struct.pack('<I7dI', int(r[0]), *map(float, r[1:8]), int(r[8]))
    out += r[9].encode() + b'\0' + struct.pack('<Q', 2) + struct.pack('<ddqddq', 1, 2, -1, 3, 4, 5)
open('binary/images.bin', 'wb').write(out)
PY
  hull text colmap
  hull binary binary
  cmp text.ply binary.ply
  hull file binary/images.bin
  cmp text.ply file.ply
  cmp <(tm-cameras --format colmap colmap) <(tm-cameras --format colmap binary)
  head -c 700 binary/images.bin >short.bin
  mv short.bin binary/images.bin
  run --separate-stderr tm-hull --cameras binary --silhouettes masks -o out.ply
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"ends too early"*"binary/images.bin"* ]]
}

@test "distortion of COLMAP's models is taken out of masks" {
  hull right colmap
  make_balls . 2
  hull ignored colmap
  # f cx cy k1, f cx cy k1 k2, fx fy cx cy k1 k2 p1 p2
  for model in 'SIMPLE_RADIAL 64 48 120 32 24 2' 'RADIAL 64 48 120 32 24 2 0' \
    'OPENCV 64 48 120 120 32 24 2 0 0 0' 'FULL_OPENCV 64 48 120 120 32 24 2 0 0 0 0 0 0 0'; do
    echo "1 $model" >colmap/cameras.txt
    hull "${model%% *}" colmap
    cmp SIMPLE_RADIAL.ply "${model%% *}.ply"
  done
  # A pixel is 8 / 120 = 0.067 wide where the balls are.
  tm-compare --reference right.ply SIMPLE_RADIAL.ply >compared
  tm-compare --reference right.ply ignored.ply >compared_ignored
  awk '/^mean:/ { mean[FILENAME] = $2 }
    END { exit !(mean["compared"] < 0.01 && mean["compared_ignored"] > 2 * mean["compared"]) }' \
    compared compared_ignored || fail "$(cat compared compared_ignored)"
  # It comes back, and what cannot hold it is refused.
  tm-cameras --format colmap --folder back colmap
  hull back back
  near SIMPLE_RADIAL back 1e-3
  run --separate-stderr tm-cameras colmap -o out.txt
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *distortion*image_undistorter* ]]
  [ ! -e out.txt ]
}

@test "distortion whose coefficients are 0 is none" {
  hull right colmap
  for model in 'SIMPLE_RADIAL 64 48 120 32 24 0' 'OPENCV 64 48 120 120 32 24 0 0 0 0'; do
    echo "1 $model" >colmap/cameras.txt
    hull zero colmap
    cmp right.ply zero.ply
  done
}

# opencv yaml|xml K1: a file for each camera of par.txt, in the folder opencv.
opencv() {
  rm -rf opencv
  mkdir opencv
  awk -v format="$1" -v k1="$2" '
    function matrix(key, rows, columns, from,   i, text) {
      for (i = 0; i < rows * columns; ++i)
        text = text (i ? (format == "xml" ? " " : ", ") : "") (from ? $(from + i) : (i ? 0 : k1))
      if (format == "xml")
        printf "<%s type_id=\"opencv-matrix\"><rows>%d</rows><cols>%d</cols><dt>d</dt>\n<data>\n%s</data></%s>\n",
          key, rows, columns, text, key >file
      else
        printf "%s: !!opencv-matrix\n   rows: %d\n   cols: %d\n   dt: d\n   data: [ %s ]\n", key, rows,
          columns, text >file
    }
    NR > 1 {
      file = "opencv/" substr($1, 1, length($1) - 4) "." format
      print (format == "xml" ? "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_width>64</image_width>" \
        : "%YAML:1.0\n---\nimage_width: 64\nimage_height: 48") >file
      matrix("camera_matrix", 3, 3, 2)
      matrix("distortion_coefficients", 5, 1, 0)
      matrix("R", 3, 3, 11)
      matrix("T", 3, 1, 20)
      if (format == "xml") print "</opencv_storage>" >file
      close(file)
    }' par.txt
}

@test "OpenCV's YAML and XML give the hull of the same numbers" {
  hull par par.txt
  for format in yaml xml; do
    opencv $format 0
    hull $format opencv
    cmp par.ply $format.ply
  done
  tm-cameras --format colmap --images masks --folder back opencv
  hull back back
  near par back 1e-3
}

@test "OpenCV's distortion is COLMAP's, and what is missing or wrong is told" {
  make_balls . 2
  tm-cameras --images masks --format colmap --folder colmap par.txt
  echo '1 OPENCV 64 48 120 120 32 24 2 0 0 0' >colmap/cameras.txt
  hull colmap colmap
  opencv yaml 2
  hull opencv opencv
  near colmap opencv 0.01
  sed '/^R:/,$d' opencv/view0.yaml >no_pose.yaml
  sed 's/data: \[ 2,/data: [ 2x,/' opencv/view0.yaml >no_number.yaml
  sed '/^camera_matrix/,/data/d' opencv/view0.yaml >no_matrix.yaml
  for what in 'no_pose no R' "no_number '2x'" 'no_matrix no camera_matrix'; do
    run --separate-stderr tm-cameras "${what%% *}.yaml"
    assert_status 3
    one_line "$stderr"
    [[ $stderr == *"${what#* }"*"${what%% *}.yaml"* ]] || fail "$stderr"
  done
}
