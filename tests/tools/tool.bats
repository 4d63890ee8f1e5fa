# Rules that the frame enforces for every program, shown with tm-convert and tm-cat.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >t.ply
}

@test "the format follows the input, --format, or the name given with -o" {
  tm-convert --no-provenance t.ply | cmp - t.ply
  [ "$(tm-convert --format off t.ply | head -n 1)" = OFF ]
  [ "$(tm-convert --format off t.ply | tm-convert | head -n 1)" = OFF ]
  tm-convert --format ply-be t.ply | tm-convert | sed -n 2p | grep -qx "format binary_big_endian 1.0"
  tm-convert -o t.off t.ply && [ "$(head -n 1 t.off)" = OFF ]
  tm-convert -o t.OBJ t.ply && grep -q '^v 1 1 0' t.OBJ
  tm-convert --format ply -o wrong.off t.ply && [ "$(head -n 1 wrong.off)" = ply ]
}

@test "OBJ and STL come in by name, and go on as the pipe format" {
  for extension in obj stl; do
    tm-convert -o "t.$extension" t.ply
    tm-convert "t.$extension" | sed -n 2p | grep -qx "format binary_little_endian 1.0"
  done
}

@test "--float and --double change the scalar type" {
  tm-convert --float t.ply | grep -qx "property float x"
  tm-convert --float t.ply | tm-convert --double | grep -qx "property double x"
  run --separate-stderr tm-convert --float --double t.ply
  assert_status 2
}

@test "a provenance comment names the options that affect the result, and only those" {
  tm-convert --threads 2 -q --float -o out.ply --report r.json t.ply
  version=$(tm-convert --version)
  [ "$(grep '^comment' out.ply)" = "comment ${version% (commit*} --float" ]
  tm-convert --no-provenance t.ply | grep -c '^comment' | grep -qx 0
}

@test "the last twenty provenance comments stay" {
  cp t.ply now.ply
  for _ in $(seq 23); do tm-convert -o now.ply now.ply; done
  [ "$(grep -c '^comment tm-convert' now.ply)" -eq 20 ]
}

@test "a mean edge that x cannot refer to is reported" {
  sed 's/^1 1 0/1e200 0 0/' t.ply >huge.ply
  sed -E 's/^-?[01] -?[01] -?[01]$/0 0 0/' t.ply >point.ply
  for case in 'huge too large*scale' 'point mean edge of the mesh is 0, so'; do
    run --separate-stderr tm-remesh "${case%% *}.ply"
    assert_status 3
    # shellcheck disable=SC2053
    [[ $stderr == *${case#* }* ]] || fail "$stderr"
  done
}

@test "--reference-edge writes the comment that later programs read" {
  tm-convert --reference-edge auto t.ply | grep -qx "comment tm:reference-edge 1.4142135623730951"
  tm-convert --reference-edge 10 t.ply | tm-convert --reference-edge 0.5x |
    grep -qx "comment tm:reference-edge 5"
  tm-convert t.ply | grep -c reference-edge | grep -qx 0
}

@test "a malformed reference edge is reported" {
  sed 's/^element vertex/comment tm:reference-edge 0\n&/' t.ply >bad.ply
  run --separate-stderr tm-convert --reference-edge 1x bad.ply
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *reference-edge* ]]
  tm-convert --reference-edge auto bad.ply >/dev/null
}

@test "a malformed reference edge is not passed on, and that is told once" {
  for edge in nan inf -inf -1 0 x ''; do
    sed "s/^element vertex/comment tm:reference-edge $edge\n&/" t.ply >bad.ply
    run --separate-stderr tm-convert bad.ply
    assert_status 0
    one_line "$stderr"
    [[ $stderr == *"tm:reference-edge comment"*dropped* ]]
    [[ $output != *reference-edge* ]]
    run --separate-stderr tm-cat t.ply bad.ply
    [[ $output != *reference-edge* ]]
  done
}

@test "stdin named twice is exit 2 and says so" {
  for arguments in "tm-cat - -" "tm-compare --reference -" "tm-morph-step --target -"; do
    # shellcheck disable=SC2086
    run --separate-stderr $arguments <t.ply
    assert_status 2
    one_line "$stderr"
    [[ $stderr == *"standard input is named twice"* ]]
  done
}

@test "an input that cannot be read is exit 3 and says why" {
  for input in none.ply . ''; do
    run --separate-stderr tm-convert "$input"
    assert_status 3
    one_line "$stderr"
    [[ $stderr == "tm-convert: ${input:-''}: cannot be read: "* ]]
  done
}

@test "more than one input for a filter is exit 2" {
  run --separate-stderr tm-convert t.ply t.ply
  assert_status 2
  one_line "$stderr"
}

@test "--report holds tool, options, counts, timings and memory" {
  tm-cat --report r.json t.ply t.ply >/dev/null
  for entry in '"tool": "tm-cat"' '"vertices": 8' '"faces": 8' '"meshes": 2' '"read": ' \
    '"write": ' '"total": ' '"peak_memory_bytes": '; do
    grep -q "$entry" r.json || fail "$(cat r.json)"
  done
  tm-cat --report - -o out.ply t.ply | grep -q '"tool": "tm-cat"'
  run --separate-stderr tm-cat --report - t.ply
  assert_status 2
}

@test "-q is silent about notes, -v says what was done" {
  tm-convert -o t.stl t.ply 2>notes
  tm-convert -q t.stl 2>quiet >/dev/null
  [ ! -s quiet ]
  tm-convert t.stl 2>loud >/dev/null
  one_line "$(cat loud)"
  tm-cat -v t.ply 2>verbose >/dev/null
  grep -qx "tm-cat: meshes: 1" verbose
}

@test "--threads takes any positive number, and the result stays" {
  for threads in 0 1 3 64 1024; do
    tm-convert --no-provenance --threads "$threads" t.ply | cmp - t.ply
  done
  run --separate-stderr tm-convert --threads 1025 t.ply
  assert_status 2
  one_line "$stderr"
  run tm-convert --threads many t.ply
  assert_status 2
}

# in_terminal 'command': runs it with stdin, stdout and stderr on a terminal.
in_terminal() {
  needs_command script
  script -qec true /dev/null </dev/null >/dev/null 2>&1 || skip "no pseudo-terminal to be had"
  run script -qec "$1" /dev/null </dev/null
}

@test "with a terminal as stdin and no input named: short help, exit 2" {
  in_terminal 'tm-convert'
  assert_status 2
  [[ $output == "Usage: tm-convert "*"--help"* ]]
}

@test "binary is refused on a terminal, with advice; text is not" {
  in_terminal 'tm-convert --format ply t.ply'
  assert_status 2
  [[ $output == *"--format ply-ascii"* && $output != *end_header* ]]
  in_terminal 'tm-convert t.ply'
  assert_status 0
  [[ $output == *end_header* ]]
}

@test "color only on a terminal, and NO_COLOR and TERM=dumb are obeyed" {
  escape=$'\033'
  in_terminal 'env TERM=xterm tm-convert none.ply'
  [[ $output == *"$escape"* ]]
  in_terminal 'env TERM=xterm NO_COLOR=1 tm-convert none.ply'
  [[ $output != *"$escape"* ]]
  in_terminal 'env TERM=dumb tm-convert none.ply'
  [[ $output != *"$escape"* ]]
  run env TERM=xterm tm-convert none.ply
  [[ $output != *"$escape"* ]]
}

# The beginning of a mesh of ten million vertices.
large_mesh() {
  printf 'ply\nformat binary_little_endian 1.0\nelement vertex 10000000\n'
  printf 'property double x\nproperty double y\nproperty double z\nend_header\n'
  head -c 240000000 /dev/zero
}

@test "out of memory is exit 6 and one line" {
  export -f large_mesh
  run --separate-stderr bash -c 'large_mesh 2>/dev/null |
    (ulimit -v 300000 && exec tm-convert --threads 1 >/dev/null)'
  assert_status 6
  [ "$stderr" = "tm-convert: out of memory: more is needed than the 293M that ulimit allows" ]
}

@test "a missing required option is reported before anything is read" {
  run --separate-stderr tm-carry none.ply
  assert_status 2
  one_line "$stderr"
  [[ $stderr == "tm-carry: --from FILE is needed: "* ]]
}

@test "-v shows every length in input units" {
  tm-remesh -v --max-edge 100% t.ply 2>verbose >/dev/null || true
  grep -qx "tm-remesh: --min-edge 0.7x = 0.989949" verbose
  grep -qx "tm-remesh: --max-edge 100% = 1.73205" verbose
  grep -qx "tm-remesh: reference edge 1.41421" verbose
  # A percentage refers to the reference's box, which is twice as large.
  sed '/^end_header/,$ s/^1/2/; /^end_header/,$ s/ 1/ 2/g' t.ply | sed -E 's/^3 .*//; /^$/d' |
    sed 's/^element face 4/element face 0/' >points.ply
  tm-compare -v --reference points.ply t.ply 2>verbose >/dev/null || true
  grep -qx "tm-compare: --distance 1% = 0.034641" verbose
}
