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

@test "Middlebury, COLMAP and matrices survive a round trip" {
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

@test "masks are undistorted by COLMAP's models" {
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

@test "distortion with coefficients 0 changes nothing" {
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

@test "OpenCV's distortion equals COLMAP's, and errors are reported" {
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

# program bundler|metashape|csv|xmp K1: the cameras of par.txt as bundle.out, metashape.xml,
# cameras.csv or a file for each in the folder xmp, for images of 64x48.
program() {
  mkdir -p xmp
  awk -v format="$1" -v k1="$2" '
    function degrees(y, x) { return atan2(y, x) * 57.29577951308232 }
    function row(i, sign) { return sprintf("%.17g %.17g %.17g\n", sign * r[i, 0], sign * r[i, 1], sign * r[i, 2]) }
    NR == 1 && format == "bundler" { print "# Bundle file v0.3\n" $1 " 0" }
    NR == 1 && format == "csv" { print "#cameras " $1 "\r\n#name,x,y,alt,heading,pitch,roll,f,px,py,k1,k2,k3,k4,t1,t2\r" }
    NR == 1 && format == "metashape" {
      print "<?xml version=\"1.0\"?>\n<document version=\"1.5.0\">\n<chunk label=\"1\">\n<sensors>"
      print "<!-- <sensor id=\"9\"> --><sensor id=\"7\" type=\"frame\"><resolution width=\"64\" height=\"48\"/>"
      print "<calibration type=\"frame\" class=\"initial\"><f>90</f></calibration>"
      print "<calibration type=\"frame\" class=\"adjusted\"><resolution width=\"64\" height=\"48\"/>"
      print "<f>120</f><cx>0</cx><cy>0</cy><k1>" k1 "</k1></calibration></sensor></sensors>\n<cameras>"
      print "<camera id=\"99\" sensor_id=\"7\" label=\"not aligned\"/>"
    }
    NR > 1 {
      name = substr($1, 1, length($1) - 4)
      for (i = 0; i < 9; ++i) r[int(i / 3), i % 3] = $(11 + i)
      for (i = 0; i < 3; ++i) c[i] = -(r[0, i] * $20 + r[1, i] * $21 + r[2, i] * $22)
      if (format == "bundler")
        printf "120 %g 0\n%s%s%s%.17g %.17g %.17g\n", k1, row(0, 1), row(1, -1), row(2, -1), $20, -$21, -$22
      if (format == "metashape") {
        printf "<camera id=\"%d\" sensor_id=\"7\" label=\"%s\"><transform>", NR, name
        for (i = 0; i < 3; ++i) printf "%.17g %.17g %.17g %.17g ", r[0, i], r[1, i], r[2, i], c[i]
        print "0 0 0 1</transform></camera>"
      }
      if (format == "csv") {
        # Columns of the turn from a camera with y up, which looks along -z.
        heading = -degrees(r[1, 0], -r[1, 1])
        pitch = degrees(-r[1, 2], sqrt(r[1, 0] ^ 2 + r[1, 1] ^ 2))
        roll = degrees(-r[0, 2], -r[2, 2])
        printf "%s.pgm,%.15g,%.15g,%.15g,%.15g,%.15g,%.15g,67.5,0,0,%g,0,0,0,0,0\r\n", name, c[0], c[1], c[2], heading, pitch, roll, k1
      }
      if (format == "xmp") {
        file = "xmp/" name ".xmp"
        print "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF><rdf:Description xcr:Version=\"3\"" >file
        print "xcr:DistortionModel=\"brown3\" xcr:FocalLength35mm=\"67.5\" xcr:Skew=\"0\" xcr:AspectRatio=\"1\"" >file
        print "xcr:PrincipalPointU=\"0\" xcr:PrincipalPointV=\"0\">\n<xcr:Rotation>" >file
        print row(0, 1) row(1, 1) row(2, 1) "</xcr:Rotation>" >file
        printf "<xcr:Position>%.17g %.17g %.17g</xcr:Position>\n", c[0], c[1], c[2] >file
        print "<xcr:DistortionCoeficients>" k1 " 0 0 0 0 0</xcr:DistortionCoeficients>" >file
        print "</rdf:Description></rdf:RDF></x:xmpmeta>" >file
        close(file)
      }
    }
    END { if (format == "metashape") print "</cameras>\n</chunk>\n</document>" }' par.txt
}

@test "Bundler, Metashape and RealityCapture give the hull of the same cameras, with and without distortion" {
  for k1 in 0 2; do
    make_balls . $k1
    tm-cameras --images masks --format colmap --folder colmap par.txt
    [ $k1 = 0 ] || echo "1 OPENCV 64 48 120 120 32 24 $k1 0 0 0" >colmap/cameras.txt
    hull right colmap
    program bundler $k1 >bundle.out
    program metashape $k1 >metashape.xml
    program csv $k1 >cameras.csv
    program xmp $k1
    # A node of the grid that is on the surface may count as in or out: a twentieth of a cell, where a
    # pixel is 0.067 wide.
    for cameras in bundle.out metashape.xml cameras.csv xmp; do
      hull other $cameras
      near right other 0.01
      # There and back.
      tm-cameras --images masks --format colmap-binary --folder back $cameras
      hull back back
      near right back 0.01
    done
  done
}

@test "COLMAP's binary model and OpenCV's files are written as they are read" {
  make_balls . 2
  echo '1 OPENCV 64 48 120 121 32 24.5 2 0.1 0.02 0.03' >colmap/cameras.txt
  tm-cameras --format colmap-binary --folder binary colmap
  [ "$(cd binary && echo *)" = "cameras.bin images.bin points3D.bin" ]
  # The same numbers as text.
  tm-cameras --format colmap --folder text colmap
  cmp <(tm-cameras --format colmap text) <(tm-cameras --format colmap binary)
  hull text text
  hull binary binary
  cmp text.ply binary.ply
  tm-cameras --format opencv --folder opencv binary
  [ "$(ls opencv | wc -l)" -eq 9 ]
  hull opencv opencv
  near text opencv 0.01
  tm-cameras --format opencv opencv/view3.yml | cmp - opencv/view3.yml
  # What is several files needs a folder.
  for format in opencv colmap-binary; do
    run --separate-stderr tm-cameras --format $format colmap
    assert_status 3
    one_line "$stderr"
    [[ $stderr == *folder* ]]
  done
}

@test "missing data of Metashape and RealityCapture, and unsupported distortion, are reported" {
  program metashape 0 >metashape.xml
  program csv 0 >cameras.csv
  program xmp 0
  tm-cameras --list metashape.xml >table
  [ "$(grep -c ^view table)" -eq 9 ]
  run --separate-stderr tm-cameras --list cameras.csv
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"cameras.csv line 3"*"name the images"* ]]
  run --separate-stderr tm-cameras cameras.csv
  assert_status 3
  [[ $stderr == *"name the images"* ]]
  refused() { # FILE WORDS
    run --separate-stderr tm-cameras --images masks "$1"
    assert_status 3
    one_line "$stderr"
    [[ $stderr == *"$2"* ]] || fail "$stderr"
  }
  sed 's/<k1>0/<k4>0.5<\/k4><k1>0/' metashape.xml >bad.xml && refused bad.xml 'k4'
  sed 's/type="frame" class/type="fisheye" class/' metashape.xml >bad.xml && refused bad.xml "'fisheye'"
  sed 's/sensor_id="7"/sensor_id="8"/' metashape.xml >bad.xml && refused bad.xml 'no sensor'
  sed 's/<transform>/<moved>/; s/<.transform>/<\/moved>/' metashape.xml >bad.xml && refused bad.xml 'aligned'
  sed '4s/67.5/67.5x/' cameras.csv >bad.csv && refused bad.csv "'67.5x'"
  sed 's/,pitch/,pinch/' cameras.csv >bad.csv && refused bad.csv 'pitch'
  sed '5s/,0,0\r/\r/' cameras.csv >bad.csv && refused bad.csv 'line 5'
  sed 's/brown3/division/; s/>0 0 0 0 0 0</>0.1 0 0 0 0 0</' xmp/view0.xmp >bad.xmp && refused bad.xmp "'division'"
  sed 's/Position/Place/g' xmp/view0.xmp >bad.xmp && refused bad.xmp 'Position'
}
