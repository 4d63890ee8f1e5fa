load ../helpers/common
load ../helpers/scene

# Cameras and masks that do not belong together. Some mistakes are corrected with a message, and the result
# is that of correct masks. Others are named with exit code 3, and nothing is written.

setup() {
  cd "$BATS_TEST_TMPDIR"
  make_balls .
  cp par.txt right.txt
}

hull() { # [OPTION]...
  run --separate-stderr timeout 5 tm-hull --cameras par.txt --silhouettes masks -o out.ply "$@"
}

# refused WORD...: checks for exit code 3, one line with all words, and no output.
refused() {
  assert_status 3
  one_line "$stderr"
  local word
  for word in "$@"; do [[ $stderr == *"$word"* ]] || fail "no '$word' in: $stderr"; done
  [ ! -e out.ply ] || fail 'something was written'
}

# mended WORD...: checks for a message with all words, and for the hull of the correct masks.
mended() {
  assert_status 0
  one_line "$stderr"
  local word
  for word in "$@"; do [[ $stderr == *"$word"* ]] || fail "no '$word' in: $stderr"; done
  mkdir -p right
  (cd right && make_balls . && tm-hull --cameras par.txt --silhouettes masks -o out.ply)
  cmp right/out.ply out.ply
}

change() { # EXPRESSION VIEW...: changes the intensities in the masks of these views
  local view
  for view in "${@:2}"; do
    changed_mask "$1" <"masks/view$view.pgm" >changed
    mv changed "masks/view$view.pgm"
  done
}

# with_names 'AWK OF k': gives line k of the camera file the name of another line, computed from k.
with_names() {
  awk "FNR == NR { n[FNR] = \$1; next } FNR == 1 { print; next }
    { k = FNR; $1; \$1 = n[k]; print }" right.txt right.txt >par.txt
}

@test "views that agree are accepted, and their agreement is reported" {
  hull --report r.json
  assert_status 0
  [ -z "$stderr" ]
  awk '/"least_agreement"/ { share = $2 + 0 } END { exit !(share > 0.95) }' r.json
  grep -q '"dropped_views": 0' r.json
}

@test "one inverted mask is named; without it, the hull of the others" {
  change '255 - l' 3
  hull
  refused "'view3'" inverted
  hull --drop-bad-views
  assert_status 0
  one_line "$stderr"
  [[ $stderr == *"'view3' is left out"* ]]
  cp out.ply dropped.ply
  rm masks/view3.pgm && sed -i -e '1s/9/8/' -e /view3/d par.txt
  hull
  cmp <(tm-info out.ply) <(tm-info dropped.ply)
}

@test "all masks inverted" {
  change '255 - l' 0 1 2 3 4 5 6 7 8
  hull
  refused 'all masks' inverted
}

@test "masks from JPEG, and masks with nearly black background" {
  # Ringing: changes of up to 40 levels near the contour and far from it.
  change 'l == 0 ? (i * 7919 % 41) : 255 - i * 104729 % 41' 4
  hull
  mended masks/view4.pgm JPEG
  make_balls .
  change 'l == 0 ? (i * 7919 % 10) : 246 + i * 104729 % 10' 0 1 2 3 4 5 6 7 8
  hull
  mended masks/view0.pgm '8 further masks'
  change 'l < 128 ? 5 : 250' 0 1 2 3 4 5 6 7 8
  hull
  mended 'brighter than halfway'
}

@test "labels are the object, whatever they are" {
  change 'l == 0 ? 0 : 1 + i % 3' 2
  hull
  assert_status 0
  [ -z "$stderr" ]
  cp out.ply labels.ply
  make_balls .
  hull
  cmp labels.ply out.ply
}

@test "the transparency of a mask is the mask" {
  needs_command python3
  for i in 0 1 2 3 4 5 6 7 8; do
    python3 - "masks/view$i.pgm" "masks/view$i.png" <<'PY'
import struct, sys, zlib
words = open(sys.argv[1]).read().split()
width, height = int(words[1]), int(words[2])
alpha = list(map(int, words[4:]))
rows = b''
for y in range(height):
    rows += b'\0' + b''.join(bytes((200, 180, 160, a)) for a in alpha[y * width:(y + 1) * width])
def chunk(name, data):
    return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))
open(sys.argv[2], 'wb').write(b'\x89PNG\r\n\x1a\n' + chunk(
    b'IHDR', struct.pack('>IIBBBBB', width, height, 8, 6, 0, 0, 0)) + chunk(
    b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))
PY
    rm "masks/view$i.pgm"
  done
  hull
  mended masks/view0.png '8 further masks' transparency
}

@test "two cameras swapped are named" {
  with_names 'if (k == 4) k = 7; else if (k == 7) k = 4'
  hull
  refused "'view2'" "'view5'" swapped
  with_names 'if (k == 2) k = 3; else if (k == 3) k = 2'
  hull
  refused "'view0'" "'view1'" swapped
}

@test "all masks shifted by one, either way" {
  with_names 'k = k == 10 ? 2 : k + 1'
  hull
  refused 'shifted by one' 'numbered from 0'
  with_names 'k = k == 2 ? 10 : k - 1'
  hull
  refused 'shifted by one' 'numbered from 0'
}

@test "a view that disagrees is refused, or left out" {
  # The object lies 14 pixels to the right.
  awk 'NR == 1 { print; next } { l[NR - 2] = $1 }
    END { for (i = 0; i < 64 * 48; ++i) print (i % 64 >= 14 ? l[i - 14] : 0) }' masks/view5.pgm >moved
  cp moved masks/view5.pgm
  hull
  refused "'view5'" disagrees --drop-bad-views
  hull --drop-bad-views --report r.json
  assert_status 0
  [[ $stderr == *"'view5' is left out"* ]]
  grep -q '"dropped_views": 1' r.json
  hull --least-agreement 0
  assert_status 0
}

@test "cameras of a left-handed world: --mirror gives the mirror image of the hull" {
  tm-cameras --format matrices par.txt | awk '/^#/ { print; next } { $3 = -$3; print }' >left.txt
  tm-hull --cameras par.txt --silhouettes masks -o right.ply
  run --separate-stderr timeout 5 tm-hull --cameras left.txt --silhouettes masks -o out.ply
  refused 'behind every camera' --mirror
  tm-hull --cameras left.txt --silhouettes masks --mirror -o out.ply
  tm-compare --reference right.ply out.ply | awk '/^hausdorff:/ { exit !($2 < 1e-3) }'
  tm-cameras --mirror left.txt -o mended.txt
  tm-hull --cameras mended.txt --silhouettes masks -o again.ply
  tm-compare --reference right.ply again.ply | awk '/^hausdorff:/ { exit !($2 < 1e-3) }'
}

@test "the loop refuses and leaves out the same" {
  tm-photograph --cameras par.txt --size 64x48 --write-images photos -o /dev/null \
    <(tm-hull --cameras par.txt --silhouettes masks --resolution 20)
  change '255 - l' 3
  run --separate-stderr timeout 5 tm-reconstruct --cameras par.txt --images photos --silhouettes masks \
    -o out.ply
  refused "'view3'" inverted
  [ ! -e out.ply.tm-reconstruct ]
  run --separate-stderr tm-reconstruct --cameras par.txt --images photos --silhouettes masks \
    --drop-bad-views --coarsest 1 --passes 1 --iterations 1 -o out.ply
  assert_status 0
  [[ $stderr == *"'view3' is left out"* ]]
}

@test "a step refuses and leaves out the same" {
  tm-hull --cameras par.txt --silhouettes masks --resolution 20 -o start.ply
  tm-photograph --cameras par.txt --size 64x48 --write-images photos -o /dev/null start.ply
  change '255 - l' 3
  step=(tm-photo-step --cameras par.txt --images photos --silhouettes masks --no-provenance start.ply)
  run --separate-stderr timeout 5 "${step[@]}" -o out.ply
  refused "'view3'" inverted
  run --separate-stderr "${step[@]}" --drop-bad-views --report r.json -o out.ply
  assert_status 0
  [[ $stderr == *"'view3' is left out"* ]]
  grep -q '"dropped_views": 1' r.json
  grep -q '"views": 8' r.json
  # The result equals that of a run without the bad view.
  mv masks/view3.pgm photos/*view3* .
  sed -i -e '1s/9/8/' -e /view3/d par.txt
  "${step[@]}" -o right.ply
  cmp right.ply out.ply
  # The options accept the views, or skip the check.
  mv view3.pgm masks && mv ./*view3* photos && cp right.txt par.txt
  "${step[@]}" --least-agreement 0 -o believed.ply
  "${step[@]}" --silhouettes-show least -o least.ply
}

@test "a step takes the mirror image of a left-handed world" {
  tm-hull --cameras par.txt --silhouettes masks --resolution 20 -o start.ply
  tm-photograph --cameras par.txt --size 64x48 --write-images photos -o /dev/null start.ply
  tm-cameras --format matrices par.txt | awk '/^#/ { print; next } { $3 = sprintf("%.15g", -$3); print }' >left.txt
  step=(tm-photo-step --images photos --silhouettes masks start.ply)
  run --separate-stderr "${step[@]}" --cameras left.txt -o out.ply
  refused 'behind every camera' --mirror
  "${step[@]}" --cameras par.txt -o right.ply
  "${step[@]}" --cameras left.txt --mirror -o mirrored.ply
  tm-compare --reference right.ply mirrored.ply | awk '/^hausdorff:/ { exit !($2 < 1e-6) }'
}
