# Small inputs cost little time and memory, whatever sizes they announce and however repetitive they are.
# The limits are wide for slow machines; a program without these bounds would take minutes or gigabytes.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# cheap COMMAND...: runs the command with limits of 20 seconds and a gigabyte of address space.
cheap() {
  (
    ulimit -v 1000000
    timeout 20 "$@"
  )
}

# Prints a PLY header with the lines of standard input among its elements, after the vertices.
tetrahedron_with() {
  tetrahedron | sed '/^element face/,$d'
  cat
  tetrahedron | sed -n '/^element face/,/^end_header/p'
}

@test "a polygon that goes around many times is triangulated" {
  {
    printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n20000'
    for _ in {1..5000}; do printf ' 0 1 2 3'; done
    echo
  } >round.off
  run --separate-stderr cheap tm-info --json round.off
  assert_status 0
  [ "$(jq .faces <<<"$output")" -eq 10000 ]
  [ "$(grep -c 'cut into triangles that fold over, because the outline intersects itself; the first is face 0' <<<"$stderr")" -eq 1 ]
}

@test "100 000 elements, properties and comments in a header cost no more than their bytes" {
  seq 100000 | sed 's/.*/element e& 0\nproperty int a/' | tetrahedron_with >elements.ply
  tetrahedron | sed '1,/^end_header/d' >>elements.ply
  seq 100000 | sed 's/.*/comment & is here/' >lines
  seq 100000 | sed 's/.*/obj_info &/' >>lines
  tetrahedron | sed '2r lines' >comments.ply
  seq 100000 | sed 's/.*/property char p&/' | tetrahedron_with >properties.ply
  ones=$(printf ' 1%.0s' {1..100000})
  tetrahedron | sed "1,/^end_header/d" | sed "1,4s/\$/ONES/" | while read -r line; do
    printf '%s\n' "${line/ONES/$ones}"
  done >>properties.ply
  for name in elements properties comments; do
    cheap tm-convert --no-provenance -o out.ply "$name.ply"
    cmp out.ply "$name.ply" || fail "$name"
    cheap tm-cat "$name.ply" "$name.ply" >/dev/null
    cheap tm-clean -q "$name.ply" >/dev/null
    cheap tm-convert -q --format off "$name.ply" >/dev/null
  done
}

@test "counts beyond the data are refused, and take no memory" {
  header() { printf 'ply\nformat %s 1.0\nelement vertex %s\nproperty double x\nproperty double y\nproperty double z\n' "$@"; }
  {
    header binary_little_endian 4000000000
    printf 'end_header\n'
  } >vertices.ply
  {
    header binary_little_endian 0
    printf 'element face 4000000000\nproperty list uchar int vertex_indices\nend_header\n'
  } >faces.ply
  {
    header binary_little_endian 0
    printf 'element face 1\nproperty list uint int vertex_indices\nend_header\n\377\377\377\377'
  } >corners.ply
  {
    header ascii 0
    printf 'element more 4000000000\nproperty list uchar int a\nend_header\n'
  } >lists.ply
  printf 'OFF\n4000000000 1 0\n' >vertices.off
  printf 'OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n' >faces.off
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n' >corners.off
  { head -c 80 /dev/zero && printf '\377\377\377\377' && head -c 50 /dev/zero; } >facets.stl
  printf 'v 0 0 0\nf 1 4000000000 1\n' >corners.obj
  for name in *.ply *.off facets.stl corners.obj; do
    run --separate-stderr bash -c "ulimit -v 200000; exec tm-info --threads 1 $name"
    assert_status 3
    one_line "$stderr"
  done
}

@test "images take memory for their bytes, not for their headers" {
  local names=(huge interlaced plain baseline progressive gray color)
  mkdir "${names[@]}"
  # Images of 60000 x 60000 pixels, 20000 x 20000 interlaced, and the latter as rows; their data is invalid.
  printf '\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\352\140\000\000\352\140\010\000\000\000\000\245\271\052\236' >huge/a.png
  printf '\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\116\040\000\000\116\040\010\000\000\000\001\261\034\051\163' >interlaced/a.png
  printf '\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\116\040\000\000\116\040\010\000\000\000\000\306\033\031\345' >plain/a.png
  # Images of 20000 x 20000 pixels as well; the last one has samples of 16 bits.
  printf '\377\330\377\300\000\013\010\116\040\116\040\001\001\021\000' >baseline/a.png
  printf '\377\330\377\302\000\013\010\116\040\116\040\001\001\021\000' >progressive/a.png
  printf 'P5 20000 20000 255\n' >gray/a.png
  printf 'P6 20000 20000 65535\n' >color/a.png
  for name in interlaced plain; do printf '\000\007\241\040IDAT' >>$name/a.png; done
  for name in "${names[@]:1}"; do head -c 500000 /dev/zero >>$name/a.png; done
  printf '%s\n' 1 "a.png 300 0 79.5 0 300 59.5 0 0 1 1 0 0 0 1 0 0 0 1 0 0 5" >par.txt
  for name in "${names[@]}"; do
    run --separate-stderr bash -c "ulimit -v 600000; exec tm-hull --threads 1 --cameras par.txt --silhouettes $name"
    assert_status 3
    one_line "$stderr"
    [[ $stderr == *"$name/a.png"* ]]
  done
  # The size of an image can be read without its pixels.
  run --separate-stderr bash -c "ulimit -v 100000; exec tm-cameras --threads 1 --images interlaced par.txt"
  assert_status 0
}

@test "clusters of points within the tolerance are joined quickly" {
  awk 'BEGIN {
    print "OFF\n100005 33335 0"
    for (i = 0; i < 50000; ++i) print "0 0 0"
    for (i = 0; i < 50000; ++i) print (i % 37) * 1e-5, (i % 41) * 1e-5, i * 1e-8
    for (i = 0; i < 5; ++i) print i % 2, int(i / 2) % 2, int(i / 4)
    for (i = 0; i < 33335; ++i) print 3, 3 * i, 3 * i + 1, 3 * i + 2
  }' >heaps.off
  cheap tm-stitch -q --tolerance 0.01 heaps.off >joined.off
  [ "$(tm-info --get faces joined.off)" -le 10 ]
}

@test "20 000 copies of a tetrahedron are cleaned as one" {
  tetrahedron | tm-convert --no-provenance --format off >one.off
  {
    printf 'OFF\n4 80000 0\n'
    sed -n 3,6p one.off
    for _ in {1..20000}; do echo; done | sed "s/^/$(sed -n 7,10p one.off | paste -sd , | sed 's/,/\\n/g')/"
  } >copies.off
  cheap tm-clean copies.off --report report.json -o out.off
  [ "$(jq .result.pairs report.json)" -eq $((4 * 20000 * 19999 / 2)) ]
  tm-checkmanifold -q out.off
  [ "$(tm-info --get volume out.off)" = "$(tm-info --get volume one.off)" ]
  [ "$(tm-info --get faces out.off)" -eq 4 ]
}

@test "2 000 boxes whose faces lie in four planes become one" {
  awk 'BEGIN {
    split("0 2 1,1 2 3,4 5 6,5 7 6,0 1 4,1 5 4,2 6 3,3 6 7,0 4 2,2 4 6,1 3 5,3 7 5", faces, ",")
    print "OFF\n16000 24000 0"
    for (v = 0; v < 16000; ++v) print 0.5 * int(v / 8) + v % 2, int(v / 2) % 2, int(v / 4) % 2
    for (v = 0; v < 16000; v += 8)
      for (f = 1; f <= 12; ++f) {
        split(faces[f], corners, " ")
        print 3, v + corners[1], v + corners[2], v + corners[3]
      }
  }' >boxes.off
  cheap tm-clean -q boxes.off -o bar.off
  tm-checkmanifold -q --closed --intersections --certify boxes.off bar.off
  tm-info bar.off >facts
  grep -qx 'components: 1' facts
  grep -qx 'volume: 1000.5' facts
}

@test "hundreds of edges through one point are cut and joined" {
  tm-shape pinch --faces 20000 -o pinch.ply
  cheap tm-clean -q pinch.ply -o apart.ply
  tm-checkmanifold -q --closed --intersections --certify pinch.ply apart.ply
}

@test "a vertex far away does not slow down the rest of the mesh" {
  tm-shape sphere --faces 50000 --format off --no-provenance | sed '4s/.*/1e15 2e15 3e15/' >stray.off
  cheap tm-intersect -q stray.off >/dev/null
  cheap tm-clean -q stray.off >/dev/null
}
