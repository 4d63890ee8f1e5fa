# tm-render: pictures from pipes and files.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR" || exit
}

# Prints width, height and color type (2: RGB, 6: RGBA) from the header of a PNG file.
png_header() {
  [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] || fail "$1 is no PNG"
  od -An -tu1 -j16 -N10 "$1" |
    awk '{ print $1 * 16777216 + $2 * 65536 + $3 * 256 + $4, $5 * 16777216 + $6 * 65536 + $7 * 256 + $8, $10 }'
}

differ() {
  if cmp -s "$1" "$2"; then fail "$1 and $2 are the same"; fi
}

@test "a mesh on stdin becomes a picture of the size asked for" {
  tetrahedron | tm-render >usual.png
  [ "$(png_header usual.png)" = "800 600 2" ]
  tetrahedron | tm-render --size 123x45 --background transparent -o small.png
  [ "$(png_header small.png)" = "123 45 6" ]
}

@test "several meshes share a picture, stdin among them" {
  tetrahedron >a.ply
  tetrahedron | tm-render --size 300x100 a.ply - a.ply >row.png
  tetrahedron | tm-render --size 300x100 --columns 2 a.ply - a.ply >rows.png
  [ "$(png_header row.png)" = "300 100 2" ]
  differ row.png rows.png
}

@test "every option of the appearance changes the picture" {
  tetrahedron >a.ply
  tm-shape sphere --faces 200 --center 5,0,0 -o b.ply
  tm-render --size 200x100 a.ply b.ply >usual.png
  for option in "--orbit 60,10" "--up z" "--zoom 0.5" "--frame scale" "--frame place" \
    "--around b.ply" "--color #208020" "--background white" "--crease-angle 0" "--views 2" --edges; do
    # shellcheck disable=SC2086
    tm-render --size 200x100 $option a.ply b.ply >other.png
    differ usual.png other.png
  done
}

@test "several views of a mesh share a picture" {
  tm-shape box 1 2 3 --faces 100 -o box.ply
  tm-render --size 300x200 --views 6 box.ply >six.png
  tm-render --size 300x200 --views 6 --columns 3 box.ply >columns.png
  tm-render --size 300x200 --views 6 --columns 6 box.ply >row.png
  [ "$(png_header six.png)" = "300 200 2" ]
  cmp six.png columns.png
  differ six.png row.png
  run --separate-stderr tm-render --size 300x200 --views 0 box.ply
  assert_status 2
  run --separate-stderr tm-render --size 30x2 --views 1000 box.ply
  assert_status 2
  [[ $stderr == *"too small"* ]]
}

@test "frames are numbered pictures, the last one step before the first" {
  tm-shape box 1 2 3 --faces 100 -o box.ply
  tm-render --size 60x40 --frames 12 -o turn.png --report report.json box.ply
  [ ! -e turn.png ]
  [ "$(echo turn-*.png | wc -w)" -eq 12 ]
  grep -q '"frames": 12' report.json
  differ turn-000.png turn-011.png
  # A box looks the same from behind.
  cmp turn-001.png turn-007.png
  tm-render --size 60x40 --orbit 120,20 --frames 12 -o later.png box.ply
  cmp later-000.png turn-003.png
  tm-render --size 60x40 --frames 12 --threads 1 -o one.png box.ply
  cmp one-005.png turn-005.png
}

@test "a film shows meshes one after the other, in the place of each among all" {
  for x in 0 2 4; do
    tm-shape box 1 2 3 --faces 100 --center $x,0,0 -o "$x.ply"
  done
  tm-render --size 60x40 --film 2 -o film.png --report report.json 0.ply 2.ply 4.ply
  [ ! -e film.png ]
  [ "$(echo film-*.png)" = "film-000.png film-001.png film-002.png" ]
  grep -q '"frames": 3' report.json
  tm-cat -o all.ply 0.ply 2.ply 4.ply
  for number in 0 1 2; do
    tm-render --size 60x40 --around all.ply "$((2 * number)).ply" | cmp - "film-00$number.png"
  done
  run --separate-stderr tm-render --film 2 --frames 3 -o a.png 0.ply
  assert_status 2
  [[ $stderr == *"--film shows meshes one after the other, and --frames moves around a mesh: give one of them" ]]
  run --separate-stderr tm-render --film 2 --frame scale -o a.png 0.ply
  assert_status 2
  [[ $stderr == *"--film shows the bounding box of all meshes"*"leave out --frame scale" ]]
}

@test "a film has one range of colors, and meshes without the property stay as they are" {
  for x in 1 2; do
    printf 'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nproperty float speed\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 %s\n' $x >"$x.ply"
  done
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >plain.off
  printf 'OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n' >square.off
  tm-render --size 160x90 --film 2 --color-by speed -o film.png 1.ply 2.ply plain.off
  for x in 1 2; do
    tm-render --size 160x90 --around square.off --range 1,2 --color-by speed "$x.ply" |
      cmp - "film-00$((x - 1)).png"
  done
  run ! cmp -s film-000.png film-001.png
  [ -e film-002.png ]
}

@test "a film that no player would show is refused before it is drawn" {
  # Nothing is encoded, so that any program of this name will do.
  mkdir bin
  printf '#!/bin/sh\n' >bin/ffmpeg
  chmod +x bin/ffmpeg
  tm-shape box --faces 12 -o box.ply
  PATH=$PWD/bin:$PATH run --separate-stderr tm-render --film 1e-9 -o film.mp4 box.ply
  assert_status 2
  [[ $stderr == *"pictures per second: choose a duration in which it has 0.01 to 120" ]]
}

@test "movies are encoded by ffmpeg" {
  needs_command ffmpeg
  needs_command ffprobe
  tm-shape box 1 2 3 --faces 100 -o box.ply
  for ending in mp4 GIF; do
    tm-render --size 60x40 --frames 5 -o "turn.$ending" box.ply
    tm-render --size 60x40 --frames 5 --threads 1 -o "again.$ending" box.ply
    cmp "turn.$ending" "again.$ending"
    facts=$(ffprobe -v error -count_frames -of csv=p=0 \
      -show_entries stream=width,height,avg_frame_rate,nb_read_frames "turn.$ending")
    [ "$facts" = 60,40,25/1,5 ] || fail "$facts"
  done
  # A film of 5 pictures lasts as long as it should.
  tm-render --size 60x40 --film 2 -o film.mp4 box.ply box.ply box.ply box.ply box.ply
  facts=$(ffprobe -v error -count_frames -of csv=p=0 \
    -show_entries stream=avg_frame_rate,nb_read_frames:format=duration film.mp4 | tr '\n' ',')
  [ "$facts" = 5/2,5,2.000000, ] || fail "$facts"
  # The decoded movie shows the drawn pictures, except for losses of the encoding.
  tm-render --size 60x40 --frames 5 -o turn.png box.ply
  ffmpeg -v error -i turn.mp4 -i turn-%03d.png -lavfi ssim=stats_file=log -f null -
  [ "$(wc -l <log)" -eq 5 ]
  sed 's/.*All:\([0-9.]*\).*/\1/' log | awk '$1 < 0.9 { exit 1 }' || fail "$(cat log)"
}

@test "an impossible movie is refused before it is drawn" {
  tetrahedron >a.ply
  refused() { # CODE WORDS OPTION...
    run --separate-stderr env PATH="$film_path" "$tm_build/bin/tm-render" "${@:3}" a.ply
    assert_status "$1"
    one_line "$stderr"
    [[ $stderr == *"$2"* ]] || fail "$stderr"
    [ "$(echo a*)" = a.ply ] || fail "$(echo a*)"
  }
  film_path=$BATS_TEST_TMPDIR/none
  for name in a.mp4 a.gif; do refused 4 'apt-get install ffmpeg' --frames 3 -o "$name"; done
  refused 2 '--frames' -o a.mp4
  refused 2 '-o orbit.mp4' --frames 3
  refused 2 'even' --frames 3 --size 41x30 -o a.mp4
  refused 2 'GIF' --frames 3 --background transparent -o a.mp4
  refused 2 '.png, ' --frames 3 -o a.avi
}

@test "an SVG holds the lines that show" {
  tm-shape box 1 2 3 --faces 100 -o box.ply
  tm-render --size 300x200 -o box.svg box.ply
  head -1 box.svg | grep -q '^<svg xmlns="http://www.w3.org/2000/svg" width="300" height="200"'
  [ "$(tail -1 box.svg)" = '</svg>' ]
  [ "$(grep -o 'class="[a-z]*"' box.svg | tr '\n' ' ')" = 'class="creases" class="outlines" ' ]
  tm-render --size 300x200 --threads 1 -o one.svg box.ply
  cmp box.svg one.svg
  tm-render --size 300x200 --edges -o edges.svg box.ply
  [ "$(wc -c <edges.svg)" -gt "$(wc -c <box.svg)" ]
  grep -q 'class="edges"' edges.svg
  # All coordinates have two decimals.
  [ -z "$(grep -o ' d="[^"]*"' edges.svg | tr -d 'd"=' | tr -s 'ML ' '\n' | grep -vE '^([0-9]+\.[0-9]{2})?$')" ]
}

@test "an SVG is of lines and their options alone, and movies of them are numbered" {
  tm-shape two-spheres --gap=-0.3 --faces 2000 -o crossing.ply
  tm-intersect --segments lines.ply -o marked.ply crossing.ply
  tm-render --views 2 --segments lines.ply -o lines.svg marked.ply
  [ "$(grep -c 'class="segments"' lines.svg)" -ge 1 ]
  [ "$(grep -c '<g>' lines.svg)" -eq 2 ]
  for option in --color=white --background=white --highlight=intersections --color-by=x --range=0,1 --ambient-occlusion --soft-shadow; do
    run --separate-stderr tm-render "$option" -o other.svg marked.ply
    assert_status 2
    one_line "$stderr"
    [[ $stderr == *"${option%%=*}"* ]]
    [ ! -e other.svg ]
  done
  tm-render --frames 3 -o turn.svg marked.ply
  [ "$(echo turn-*.svg)" = "turn-000.svg turn-001.svg turn-002.svg" ]
}

@test "a browser draws the SVG where the picture has its outline" {
  for command in chromium ffmpeg python3; do needs_command "$command"; done
  tm-shape torus --faces 2000 -o torus.ply
  tm-render --size 300x200 -o torus.svg torus.ply
  timeout 60 chromium --headless --no-sandbox --disable-gpu --window-size=300,200 \
    --screenshot="$PWD/drawn.png" "$PWD/torus.svg" >/dev/null 2>&1 || skip "chromium does not start"
  [ "$(png_header drawn.png | cut -d' ' -f1,2)" = "300 200" ]
  tm-render --size 300x200 --background transparent -o torus.png torus.ply
  ffmpeg -v error -i drawn.png -f rawvideo -pix_fmt gray drawn
  ffmpeg -v error -i torus.png -vf alphaextract -f rawvideo -pix_fmt gray covered
  # There is a line within two pixels of each place where the surface ends.
  python3 - <<'PYTHON'
width, height = 300, 200
drawn, covered = (open(name, "rb").read() for name in ("drawn", "covered"))
lines = {i for i, level in enumerate(drawn) if level < 128}
ends = [i for i in range(width, width * height)
        if (covered[i] > 127) != (covered[i - 1] > 127) or (covered[i] > 127) != (covered[i - width] > 127)]
reach = [dy * width + dx for dy in range(-2, 3) for dx in range(-2, 3)]
missed = [i for i in ends if not any(i + step in lines for step in reach)]
assert len(ends) > 500 and len(missed) < len(ends) / 100, (len(ends), len(missed), len(lines))
PYTHON
}

@test "ambient occlusion dims what lies deep, and nothing of a convex body" {
  tm-shape sphere --faces 500 -o ball.ply
  tm-render --size 100x100 ball.ply >plain.png
  tm-render --size 100x100 --ambient-occlusion ball.ply >dimmed.png
  cmp plain.png dimmed.png
  tm-shape genus 3 --faces 2000 -o genus.ply
  tm-render --size 100x100 genus.ply >plain.png
  tm-render --size 100x100 --ambient-occlusion genus.ply >dimmed.png
  tm-render --size 100x100 --ambient-occlusion --threads 1 genus.ply >one.png
  differ plain.png dimmed.png
  cmp dimmed.png one.png
}

@test "a soft shadow falls on the mesh and on a floor, for any number of threads" {
  tm-shape genus 3 --faces 2000 -o genus.ply
  tm-render --size 100x100 genus.ply >plain.png
  tm-render --size 100x100 --soft-shadow genus.ply >shaded.png
  tm-render --size 100x100 --soft-shadow --threads 1 genus.ply >one.png
  tm-render --size 100x100 --soft-shadow --threads 4 genus.ply >four.png
  differ plain.png shaded.png
  cmp shaded.png one.png
  cmp shaded.png four.png
  # Two meshes on one floor: the shadow of the upper one does not end where the mesh ends.
  tm-shape sphere --faces 500 -o ball.ply
  tm-transform -q --translate 0,1,0 ball.ply -o above.ply
  tm-render --size 200x100 --frame place --soft-shadow ball.ply above.ply >place.png
  tm-render --size 200x100 --frame scale --soft-shadow ball.ply above.ply >scale.png
  differ place.png scale.png
  tm-render --size 100x100 --frames 2 --soft-shadow -o turn.png genus.ply
  differ turn-000.png turn-001.png
}

@test "intersections are highlighted" {
  tm-shape two-spheres --gap=-0.3 --faces 2000 -o crossing.ply
  tm-intersect crossing.ply >marked.ply
  tm-render marked.ply >plain.png
  tm-render --highlight intersections marked.ply >marked.png
  differ plain.png marked.png
  run --separate-stderr tm-render --highlight intersections crossing.ply
  assert_status 2
  [[ $stderr == *"'intersections'"* ]]
}

@test "segments are drawn over the mesh, and what is none is refused" {
  tm-shape two-spheres --gap=-0.3 --faces 2000 -o crossing.ply
  tm-intersect --segments lines.ply crossing.ply >marked.ply
  tm-render marked.ply >plain.png
  tm-render --segments lines.ply marked.ply >lines.png
  differ plain.png lines.png
  run --separate-stderr tm-render --segments crossing.ply crossing.ply
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"crossing.ply"*"tm-intersect"* ]]
}

# Adds the vertex property h, the x coordinate.
with_height() {
  awk '/^element vertex/ { n = $3 } /^element face/ { print "property double h" }
    inside && n-- > 0 { print $0, $1; next } /^end_header/ { inside = 1 } { print }'
}

@test "colors stand for numbers, with a legend" {
  tm-shape torus --faces 2000 --format ply-ascii | with_height >high.ply
  tm-render high.ply >plain.png
  tm-render --color-by h high.ply >colored.png
  tm-render --color-by h --range 0,0.5 high.ply >narrow.png
  tm-render --color-by h --range -0.5,0.5 high.ply >signs.png
  differ plain.png colored.png
  differ colored.png narrow.png
  differ narrow.png signs.png
  [ "$(png_header colored.png)" = "800 600 2" ]
}

@test "a property to color by that is not there is exit 2 and names those that are" {
  tm-shape torus --faces 2000 --format ply-ascii | with_height >high.ply
  run --separate-stderr tm-render --color-by height high.ply
  assert_status 2
  one_line "$stderr"
  [[ $stderr == *"'height'"*"vertices h"* ]]
  for options in '--color-by h --range 1' '--color-by h --range 2,1' '--range 0,1'; do
    # shellcheck disable=SC2086
    run --separate-stderr tm-render $options high.ply
    assert_status 2
    one_line "$stderr"
    [[ $stderr == *range* ]]
  done
}

@test "the same bytes from every format and twice" {
  tetrahedron >a.ply
  tm-convert -o a.off a.ply
  tm-render a.ply >ply.png
  tm-render a.off >off.png
  tm-render a.ply >again.png
  cmp ply.png off.png && cmp ply.png again.png
}

@test "a mesh without faces is exit 3" {
  printf 'OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n' >points.off
  run --separate-stderr tm-render -o out.png points.off
  assert_status 3
  one_line "$stderr"
  [ ! -e out.png ]
}

@test "bad values are exit 2 and say how to write them" {
  tetrahedron >a.ply
  for option in --size=800 --size=0x5 --size=99999x99999 --orbit=30 --color=mauve --zoom=0 \
    --background=white,mauve --frame=all --up=w; do
    run --separate-stderr tm-render "$option" a.ply
    assert_status 2
    one_line "$stderr"
  done
}

@test "fifty thousand faces take well under a second" {
  tm-shape sphere --faces 50000 -o sphere.ply
  TIMEFORMAT='%U %S'
  { time tm-render sphere.ply >sphere.png; } 2>seconds
  awk '{ exit !($1 + $2 < 1) }' seconds || fail "CPU seconds: $(cat seconds)"
}

@test "a poster takes at most 12 bytes a pixel, the program included" {
  tm-shape torus --faces 2000 -o torus.ply
  tm-render --size 6000x4500 --zoom 0.2 --report report.json -o poster.png torus.ply
  [ "$(png_header poster.png)" = "6000 4500 2" ]
  bytes=$(sed -n 's/.*"peak_memory_bytes": \([0-9]*\).*/\1/p' report.json)
  [ "$bytes" -gt $((4 * 6000 * 4500)) ] && [ "$bytes" -lt $((12 * 6000 * 4500)) ] ||
    fail "$bytes bytes"
}

@test "a model from elsewhere is drawn" {
  needs_shared meshes/cgal/elephant.off
  tm-render --size 400x300 "$shared_file" >elephant.png
  [ "$(png_header elephant.png)" = "400 300 2" ]
}
