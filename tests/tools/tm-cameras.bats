# tm-cameras: camera files of every format, compared with numbers that are computed from the files
# independently.

load ../helpers/common
load ../helpers/contract

setup() {
  cd "$BATS_TEST_TMPDIR" || exit
}

# pixels MATRICES: prints the pixels at which each 3x4 matrix of the file shows points around CENTER_X,Y,Z
# of size SIZE.
pixels() {
  awk -v center="$2" -v size="$3" '
    /^#/ { next }
    { for (j = 1; j <= 4; ++j) p[rows % 3, j] = $j }
    ++rows % 3 == 0 {
      split(center, c, ",")
      for (k = 0; k < 6; ++k) {
        x = c[1] + size * sin(k); y = c[2] + size * cos(2 * k); z = c[3] + size * sin(3 * k + 1)
        for (i = 0; i < 3; ++i) q[i] = p[i, 1] * x + p[i, 2] * y + p[i, 3] * z + p[i, 4]
        printf "%.12f %.12f\n", q[0] / q[2], q[1] / q[2]
      }
    }' "$1"
}

# raw_middlebury FILE: prints K [R | t] for each line of the file.
raw_middlebury() {
  awk 'NR > 1 {
    for (i = 0; i < 3; ++i) {
      for (j = 0; j < 3; ++j) {
        s = 0
        for (k = 0; k < 3; ++k) s += $(2 + 3 * i + k) * $(11 + 3 * k + j)
        printf "%.17g ", s
      }
      s = 0
      for (k = 0; k < 3; ++k) s += $(2 + 3 * i + k) * $(20 + k)
      printf "%.17g\n", s
    }
  }' "$1"
}

# raw_colmap FOLDER: prints the same for one PINHOLE camera and quaternions, shifted by half a pixel.
raw_colmap() {
  awk '
    /^#/ { next }
    FNR == NR { fx = $5; fy = $6; cx = $7 - 0.5; cy = $8 - 0.5; next }
    ++line % 2 == 1 {
      w = $2; x = $3; y = $4; z = $5
      r[1, 1] = 1 - 2 * (y * y + z * z); r[1, 2] = 2 * (x * y - w * z); r[1, 3] = 2 * (x * z + w * y)
      r[2, 1] = 2 * (x * y + w * z); r[2, 2] = 1 - 2 * (x * x + z * z); r[2, 3] = 2 * (y * z - w * x)
      r[3, 1] = 2 * (x * z - w * y); r[3, 2] = 2 * (y * z + w * x); r[3, 3] = 1 - 2 * (x * x + y * y)
      r[1, 4] = $6; r[2, 4] = $7; r[3, 4] = $8
      for (j = 1; j <= 4; ++j) printf "%.17g ", fx * r[1, j] + cx * r[3, j]
      printf "\n"
      for (j = 1; j <= 4; ++j) printf "%.17g ", fy * r[2, j] + cy * r[3, j]
      printf "\n"
      for (j = 1; j <= 4; ++j) printf "%.17g ", r[3, j]
      printf "\n"
    }' "$1/cameras.txt" "$1/images.txt"
}

# agree TOLERANCE FIRST SECOND: checks that both have the same number of lines, and that numbers differ by
# at most TOLERANCE; prints the largest difference.
agree() {
  paste -d' ' "$2" "$3" | awk -v tolerance="$1" '
    NF % 2 == 1 { print "lines differ: " $0; failed = 1; exit 1 }
    { for (i = 1; i <= NF / 2; ++i) { d = $i - $(i + NF / 2); if (d < 0) d = -d; if (d > m) m = d } }
    END { if (failed || NR == 0 || m > tolerance) { print "largest difference " m; exit 1 } }'
}

@test "tm-cameras: COLMAP and Middlebury files of one scene project to the same pixels" {
  needs_shared mvs/synthetic16/par.txt
  folder=${shared_file%/*}
  tm-cameras --format matrices "$folder/par.txt" >par.txt
  tm-cameras --format matrices "$folder/colmap" >colmap.txt
  [ "$(grep -c '^#' par.txt)" = 16 ]
  raw_middlebury "$folder/par.txt" >raw_par.txt
  raw_colmap "$folder/colmap" >raw_colmap.txt
  for file in par colmap raw_par raw_colmap; do pixels $file.txt 0,0,0 50 >$file.pixels; done
  agree 1e-9 par.pixels raw_par.pixels
  agree 1e-9 colmap.pixels raw_colmap.pixels
  agree 1e-8 par.pixels colmap.pixels
}

@test "tm-cameras: 3x4 matrices, decomposed and multiplied again, project to the same pixels" {
  needs_shared mvs/dinoSparse_transformesh/camera0000.txt
  folder=${shared_file%/*}
  cat "$folder"/camera*.txt >raw.txt
  tm-cameras "$folder" >par.txt
  [ "$(head -n 1 par.txt)" = 16 ]
  raw_middlebury par.txt >matrices.txt
  pixels raw.txt -0.025,0.02,-0.02 0.05 >raw.pixels
  pixels matrices.txt -0.025,0.02,-0.02 0.05 >matrices.pixels
  [ "$(wc -l <raw.pixels)" = 96 ]
  agree 1e-9 raw.pixels matrices.pixels
}

@test "tm-cameras: an off-by-one numbering is refused, and the file's line named" {
  needs_shared mvs/dinoSparse_transformesh/dinoSR0000.png
  images="${shared_file%/*}/dinoSR*.png"
  needs_shared mvs/dinoSparseRing_params/dinoSR_par.txt
  run --separate-stderr tm-cameras --images "$images" "$shared_file"
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"dinoSR0016.png ("*"dinoSR_par.txt line 17)"* ]]
}

@test "tm-cameras: Middlebury parameters come back number by number" {
  two_cameras >in.txt
  diff in.txt <(tm-cameras in.txt)
  # Matrices are multiplied and decomposed, so that the last digits change.
  tm-cameras --format matrices in.txt | tm-cameras >back.txt
  diff <(awk '{ print $1 }' in.txt) <(awk '{ print $1 }' back.txt)
  agree 1e-12 <(raw_middlebury in.txt) <(raw_middlebury back.txt)
}

@test "tm-cameras: the files of a folder are those of the format" {
  two_cameras >in.txt
  mkdir images
  for name in a b; do { echo P5 160 120 255; head -c 19200 /dev/zero; } >images/$name.pgm; done
  for format in middlebury colmap matrices; do
    tm-cameras --format $format --folder $format --images images in.txt >stdout
    [ ! -s stdout ]
  done
  [ "$(ls middlebury colmap matrices | tr '\n' ' ')" = "colmap: cameras.txt images.txt points3D.txt  matrices: a.txt b.txt  middlebury: cameras_par.txt " ]
  grep -qx '1 PINHOLE 160 120 300 300 80 60' colmap/cameras.txt
  pixels <(tm-cameras --format matrices in.txt) 0,0,0 1 >expected
  for folder in colmap matrices middlebury; do
    agree 1e-12 expected <(pixels <(tm-cameras --format matrices $folder) 0,0,0 1)
  done
}

@test "tm-cameras: the table, against numbers worked out by hand" {
  two_cameras >in.txt
  # Camera b is rotated by atan(3/4) = 36.87 degrees and 5 away from the origin; a pixel there is 5 / 300
  # wide.
  tm-cameras --list --center 0,0,0 in.txt >table
  [ "$(sed -n 2p table | tr -s ' ')" = "a.png - 300 0 0 -5 0.0166667 b.png:36.87" ]
  [ "$(sed -n 3p table | tr -s ' ')" = "b.png - 300 -3 0 -4 0.0166667 a.png:36.87" ]
  [ "$(wc -l <table)" = 3 ]
  # Both axes go through the origin.
  diff table <(tm-cameras --list in.txt)
  [ "$(tm-cameras --list --pairs 0 in.txt | sed -n 2p | awk '{ print $NF }')" = - ]
  # The point is behind a, and beside b.
  tm-cameras --list --center 9,0,-6 in.txt | sed -n 2p | tr -s ' ' | grep -q ' -5 - '
}

@test "tm-cameras: a table of one camera, which has no pairs" {
  two_cameras | sed '1s/.*/1/; 3d' >in.txt
  tm-cameras --list in.txt >table
  [ "$(wc -l <table)" = 2 ]
  [[ $(sed -n 2p table | tr -s ' ') = "a.png - 300 0 0 -5 "*" -" ]] || fail "$(cat table)"
}

@test "tm-cameras: a table of cameras that look away from each other, and what it says" {
  # The cameras are back to back on the x axis: the axes meet between them, behind both.
  printf '2\na 300 0 80 0 300 60 0 0 1 0 0 1 0 1 0 -1 0 0 0 0 -1\nb 300 0 80 0 300 60 0 0 1 0 0 -1 0 1 0 1 0 0 0 0 -1\n' >in.txt
  run --separate-stderr tm-cameras --list --center 0,0,0 in.txt
  assert_status 0
  one_line "$stderr"
  [[ $stderr == *"behind all cameras"*"--center"* ]]
  [ "$(tm-cameras -q --json --center 0,0,0 in.txt | jq .pixel_size)" = null ]
  # The option that the message names helps.
  run --separate-stderr tm-cameras --list --center 5,0,0 in.txt
  assert_status 0
  [ -z "$stderr" ]
}

@test "tm-cameras: JSON and the report hold the same numbers" {
  needs_command python3
  two_cameras >in.txt
  tm-cameras --json --report report.json in.txt >table.json
  python3 -c "
import json
table, report = json.load(open('table.json')), json.load(open('report.json'))['result']
assert [c['name'] for c in table['cameras']] == ['a.png', 'b.png']
assert abs(table['pixel_size'] - 5 / 300) < 1e-12 and report['pixel_size'] == table['pixel_size']
assert report['cameras'] == 2 and report['pairs'] == 2
assert abs(table['cameras'][0]['pairs'][0]['angle'] - 36.8698976458) < 1e-9
assert max(abs(x - y) for x, y in zip(table['cameras'][1]['center'], [-3, 0, -4])) < 1e-12"
}

@test "tm-cameras: unsupported input is one line and exit 3, and nothing is written" {
  two_cameras >in.txt
  sed 's/300 59.5/nan 59.5/' in.txt >nan.txt
  sed 1d in.txt >headless.txt
  head -n 2 in.txt >short.txt
  printf '1 RADIAL 160 120 300 300 80 60 0.1 0 0 0\n1 1 0 0 0 0 0 5 1 a.png\n\n' >lens.txt
  printf '1 2 3 4\n2 4 6 8\n0 0 1 1\n' >singular.txt
  printf '# Bundle file v0.3\n1 0\n500 0.01 0\n1 0 0\n0 1 0\n0 0 1\n0 0 5\n' >distorted.out
  printf '# Bundle file v0.3\n1 0\n500 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 5\n' >bundle.out
  while read -r file what; do
    run --separate-stderr tm-cameras -o target "$file"
    assert_status 3
    one_line "$stderr"
    [[ $stderr == "tm-cameras: "*"$what"* ]] || fail "$file: $stderr"
    [ ! -e target ]
  done <<'CASES'
nan.txt nan.txt line 2
headless.txt headless.txt line 1
short.txt short.txt line 3
lens.txt lens.txt line 1
singular.txt singular.txt line 3
distorted.out distorted.out line 3
bundle.out bundle.out line 3
missing.txt missing.txt
CASES
  run --separate-stderr tm-cameras --format colmap in.txt
  assert_status 3
  [[ $stderr == *"in.txt line 2"*"name the images"* ]]
}

@test "tm-cameras: matrices from standard input have names that every format takes" {
  two_cameras | tm-cameras --format matrices | grep -v '^#' >two.txt
  head -n 3 two.txt >one.txt
  [ "$(tm-cameras <one.txt | awk 'NR > 1 { print $1 }')" = camera ]
  [ "$(tm-cameras <two.txt | awk 'NR > 1 { print $1 }' | tr '\n' ' ')" = 'camera-1 camera-2 ' ]
  [ "$(tm-cameras one.txt | awk 'NR > 1 { print $1 }')" = one ]
  diff <(tm-cameras <one.txt | cut -d' ' -f2-) <(tm-cameras one.txt | cut -d' ' -f2-)
}

@test "tm-cameras: a line of COLMAP cut short: what is missing, and names that cannot harm a terminal" {
  mkdir model
  refused() { # CAMERAS IMAGES MESSAGE
    printf "$1" >model/cameras.txt
    printf "$2" >model/images.txt
    run --separate-stderr tm-cameras model
    assert_status 3
    one_line "$stderr"
    [[ $stderr == *"$3"* ]] || fail "$stderr"
    [[ $stderr != *$'\e'* ]]
  }
  lens='1 PINHOLE 160 120 300 300 80 60\n'
  refused "$lens" '7 1 0 0 0 0 0 5\n' "the camera of image '7' is missing"
  refused "$lens" '7 1 0 0 0 0 0 5 1\n' "the name of image '7' is missing"
  refused "$lens" '7 1 0 0 0 0 0\n' "tz of image '7' is missing"
  refused "$lens" '\e[31m 1 0 0 0 0 0 5 2 a.png\n' "image '\\x1b[31m'"
  refused '1\n' '7 1 0 0 0 0 0 5 1 a.png\n' "the model of camera '1' is missing"
  refused '\e[31m PINHOLE 160 120 0 300 80 60\n' '7 1 0 0 0 0 0 5 1 a.png\n' "camera '\\x1b[31m'"
  refused "$lens" '7 1 0 0 0 0 0 5 1 \ea.png\n\n8 1 0 0 0 0 0 5 1 \ea.png\n\n' "'\\x1ba.png'"
}

@test "tm-cameras: a JPEG gives its size, a broken one is refused" {
  printf '1\na.jpg 300 0 3 0 300 3 0 0 1 1 0 0 0 1 0 0 0 1 0 0 5\n' >in.txt
  # An image of 8 x 6 gray pixels.
  base64 -d >a.jpg <<'JPEG'
/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDABALDA4MChAODQ4SERATGCgaGBYWGDEjJR0oOjM9PDkz
ODdASFxOQERXRTc4UG1RV19iZ2hnPk1xeXBkeFxlZ2P/wAALCAAGAAgBAREA/8QAFAABAAAAAAAA
AAAAAAAAAAAABf/EABQQAQAAAAAAAAAAAAAAAAAAAAD/2gAIAQEAAD8AMf/Z
JPEG
  tm-cameras --images a.jpg --format colmap in.txt | grep -q '^1 PINHOLE 8 6 '
  # The pixels are not read.
  head -c -3 a.jpg >short.jpg && mv short.jpg a.jpg
  tm-cameras --images a.jpg --format colmap in.txt | grep -q '^1 PINHOLE 8 6 '
  head -c 95 a.jpg >short.jpg && mv short.jpg a.jpg
  run --separate-stderr tm-cameras --images a.jpg in.txt
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"not a complete JPEG"*"(a.jpg)"* ]]
}

@test "tm-cameras: an image of another format is refused with the way to convert it" {
  printf '1\na.webp 300 0 3 0 300 3 0 0 1 1 0 0 0 1 0 0 0 1 0 0 5\n' >in.txt
  printf 'RIFF\x24\0\0\0WEBPVP8 ' >a.webp
  run --separate-stderr tm-cameras --images a.webp in.txt
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"JPEG, PNG, TIFF and PNM"*"magick a.webp a.png"* ]]
}

@test "an image that claims 20000 x 20000 pixels and has none is refused at once" {
  while read -r name bytes; do
    printf '1\n%s 300 0 3 0 300 3 0 0 1 1 0 0 0 1 0 0 0 1 0 0 5\n' "$name" >in.txt
    base64 -d <<<"$bytes" >"$name"
    run --separate-stderr timeout 10 tm-hull --cameras in.txt --silhouettes "$name"
    assert_status 3
    one_line "$stderr"
    [[ $stderr == *"($name)" ]] || fail "$stderr"
  done <<'IMAGES'
g4.tif SUkqABIAAAAmoSahJqEmoSahCQAAAQQAAQAAACBOAAABAQQAAQAAACBOAAACAQMAAQAAAAEAAAADAQMAAQAAAAQAAAAGAQMAAQAAAAEAAAARAQQAAQAAAAgAAAAVAQMAAQAAAAEAAAAWAQQAAQAAACBOAAAXAQQAAQAAAAoAAAAAAAAA
packbits.tif SUkqABIAAACBAIEAgQCBAIEACQAAAQQAAQAAACBOAAABAQQAAQAAACBOAAACAQMAAQAAAAgAAAADAQMAAQAAAAWAAAAGAQMAAQAAAAEAAAARAQQAAQAAAAgAAAAVAQMAAQAAAAEAAAAWAQQAAQAAACBOAAAXAQQAAQAAAAoAAAAAAAAA
palette.tif SUkqABoAAAB4nGNgGAWjYBQMdwAAA+gAAQAJAAABBAABAAAAIE4AAAEBBAABAAAAIE4AAAIBAwABAAAACAAAAAMBAwABAAAACAAAAAYBAwABAAAAAwAAABEBBAABAAAACAAAABUBAwABAAAAAQAAABYBBAABAAAAIE4AABcBBAABAAAAEQAAAAAAAAA=
none.tif SUkqABIAAACBAIEAgQCBAIEACQAAAQQAAQAAACBOAAABAQQAAQAAACBOAAACAQMAAQAAAAgAAAADAQMAAQAAAAEAAAAGAQMAAQAAAAEAAAARAQQAAQAAAAgAAAAVAQMAAQAAAAEAAAAWAQQAAQAAACBOAAAXAQQAAQAAAAoAAAAAAAAA
empty.tif SUkqAAgAAAAAAAgAAAA=
a.png iVBORw0KGgoAAAANSUhEUgAATiAAAE4gCAIAAABsEtFuAAAADElEQVR4nGNgoD0AAABkAAGGZDw1AAAAAElFTkSuQmCC
a.jpg /9j/wAALCE4gTiABAREA/9oACAEBAAA/AP/Z
IMAGES
}
