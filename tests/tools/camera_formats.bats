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
  head -c 700 binary/images.bin >cut && mv cut binary/images.bin
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
