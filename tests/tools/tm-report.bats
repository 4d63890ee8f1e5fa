load ../helpers/common

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  tm-shape torus --faces 1000 -o torus.ply
  tm-shape sphere --around torus.ply --faces 1000 -o sphere.ply
  tm-morph -q sphere.ply --target torus.ply --run one --iterations 6 --every 2
  tm-morph -q sphere.ply --target torus.ply --run two --iterations 4 --every 1 --alpha 0.1
}

setup() {
  cd "$BATS_FILE_TMPDIR"
  [ -e "$tm_build/share/transformesh/viewer.html" ] || skip "the viewer is not built: scripts/setup --browser"
}

# data_of PAGE: prints the JSON of a page.
data_of() {
  sed -n 's|^<script id="page" type="application/json">\(.*\)</script>$|\1|p' "$1"
}

# block_of PAGE NAME: prints the decompressed block of that name.
block_of() {
  sed -n "s|^<script id=\"$2\" type=\"text/plain\">\(.*\)</script>\$|\1|p" "$1" | base64 -d |
    python3 -c 'import sys, zlib; sys.stdout.buffer.write(zlib.decompress(sys.stdin.buffer.read()))'
}

@test "a page has all frames, the target, the log, the report and the commands" {
  tm-report one -o page.html --report report.json
  jq -e '.result.runs == 1 and .result.meshes == 4' report.json
  [ "$(jq .result.bytes report.json)" -eq "$(wc -c <page.html)" ]
  data_of page.html >data.json
  jq -e '.title == "one" and (.runs | length) == 1' data.json
  jq -e '[.runs[0].meshes[].number] == [0, 2, 4, 6]' data.json
  jq -e '.runs[0].tool == "tm-morph" and .runs[0].report.result.iterations == 6' data.json
  jq -r '.runs[0].log' data.json | cmp - <(cat one/log.csv; echo)
  [ "$(jq -r '.runs[0].commands[]' data.json)" = "$(jq -r '.commands[]' one/run.json)" ]
  for i in 0 1 2 3; do
    frame=one/frames/frame-0000$((2 * i)).ply
    [ "$(jq ".runs[0].meshes[$i].faces" data.json)" -eq "$(tm-info --get faces "$frame")" ]
    block_of page.html "mesh-0-$i" | tail -c +5 | grep -aq '"name":"distance"'
  done
  block_of page.html target-0-0 | tail -c +5 | grep -aq '"faces":'
}

@test "the page loads nothing, and contains the licenses of its parts" {
  tm-report one -o page.html
  grep -q "default-src 'none'" page.html
  run ! grep -oiE '(src|href)="(http|//)[^"]*' page.html
  grep -q 'three.js authors' page.html
}

@test "--every takes few frames and the last, and several runs are in the order named" {
  tm-report --every 3 two one -o page.html --title 'a & b'
  data_of page.html >data.json
  jq -e '[.runs[0].meshes[].number] == [0, 3, 4] and [.runs[1].meshes[].number] == [0, 6]' data.json
  jq -e '[.runs[].name] == ["two", "one"] and .title == "a & b"' data.json
  grep -q '<title>a &amp; b</title>' page.html
}

@test "invalid runs, unknown properties and missing runs are reported" {
  refused() { # CODE MESSAGE ARGUMENT...
    run --separate-stderr tm-report "${@:3}" -o none.html
    assert_status "$1"
    one_line "$stderr"
    [[ $stderr == "tm-report: "*"$2"* ]] || fail "$stderr"
    [ ! -e none.html ]
  }
  mkdir -p other
  refused 2 'RUN is missing'
  refused 3 'is not a run' other
  refused 3 'is not a run' torus.ply
  refused 2 "--color-by: no mesh has a property 'heat'" one --color-by heat
  run --separate-stderr tm-report one -o page.png
  assert_status 2
  [[ $stderr == *'pages are .html'* ]]
}

@test "where the viewer is missing it is exit 4, and says how to get it" {
  mkdir -p elsewhere/bin
  cp "$tm_build/bin/tm-report" "$tm_build/bin/tm-view" elsewhere/bin
  for command in 'tm-report one' 'tm-view torus.ply'; do
    run --separate-stderr elsewhere/bin/$command -o none.html
    assert_status 4
    one_line "$stderr"
    [[ $stderr == *'elsewhere/share/transformesh/viewer.html'*'scripts/setup --browser'* ]]
    [ ! -e none.html ]
  done
}

@test "a run of a hundred frames of ten thousand faces stays below 30 MB" {
  tm-shape torus-knot --faces 10000 -o knot.ply
  tm-evolve -q knot.ply --step 'tm-displace -q --normal-speed 0.02x' --iterations 9 --every 1 --run knot
  tm-report knot -o knot.html
  frame=$(data_of knot.html | jq '[.runs[0].meshes[].faces] | add / length | floor')
  [ "$frame" -gt 5000 ]
  size=$(($(wc -c <knot.html) - $(wc -c <"$tm_build/share/transformesh/viewer.html")))
  # The page has ten frames. Its size per million faces is below 29 MB.
  awk -v size="$size" -v faces="$frame" 'BEGIN { exit !(size / (10 * faces) * 1e6 < 29e6) }'
}
