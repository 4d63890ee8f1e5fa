load ../helpers/common

# value KEY FILE: prints a number of a report.
value() {
  awk -v key="\"$1\":" '$1 == key { gsub(",", "", $2); print $2 }' "$2"
}

@test "a refined mesh has more faces, and a report states what was done" {
  tetrahedron >"$BATS_TEST_TMPDIR/in.ply"
  pipe "tm-remesh --min-edge 0.35x --max-edge 0.75x --report $BATS_TEST_TMPDIR/r.json \
    < $BATS_TEST_TMPDIR/in.ply > $BATS_TEST_TMPDIR/out.ply"
  assert_status 0
  [ "$(value splits "$BATS_TEST_TMPDIR/r.json")" -gt 5 ]
  [ "$(value degenerate_faces "$BATS_TEST_TMPDIR/r.json")" -eq 0 ]
  for key in collapses flips refused components_dropped; do
    [ -n "$(value $key "$BATS_TEST_TMPDIR/r.json")" ] || fail "no $key in the report"
  done
}

@test "the reference edge of the first program holds in the second" {
  tetrahedron >"$BATS_TEST_TMPDIR/in.ply"
  pipe "tm-remesh --min-edge 0.35x --max-edge 0.75x < $BATS_TEST_TMPDIR/in.ply |
    tm-remesh -v --min-edge 0.35x --max-edge 0.75x 2>&1 >/dev/null | grep 'reference edge'"
  assert_status 0
  [[ $output == *"reference edge 1.41421"* ]]
}

@test "contradictory lengths are refused with numbers" {
  tetrahedron >"$BATS_TEST_TMPDIR/in.ply"
  run tm-remesh --min-edge 1 --max-edge 1.2 "$BATS_TEST_TMPDIR/in.ply"
  assert_status 2
  one_line "$output"
  [[ $output == *"1.2 is below 1.5 times the shortest 1"* ]]
}

@test "an empty result is exit 4, with nothing written" {
  tetrahedron >"$BATS_TEST_TMPDIR/in.ply"
  run --separate-stderr tm-remesh --min-edge 5 --max-edge 10 "$BATS_TEST_TMPDIR/in.ply"
  assert_status 4
  [ -z "$output" ]
  [[ $stderr == *"nothing would be left; use a smaller --min-edge"* ]]
}

@test "a mesh that is no manifold is exit 3 with faces and advice" {
  cat >"$BATS_TEST_TMPDIR/in.off" <<'MESH'
OFF
5 3 0
0 0 0
1 0 0
0 1 0
0 0 1
1 1 1
3 0 1 2
3 0 1 3
3 1 0 4
MESH
  run tm-remesh "$BATS_TEST_TMPDIR/in.off"
  assert_status 3
  [[ $output == *"faces 0 and 1 traverse the edge "*" in the same direction"*"orient it with tm-stitch --orient"* ]]
}

@test "factors of smoothing are read and checked" {
  tetrahedron >"$BATS_TEST_TMPDIR/in.ply"
  for good in "--smooth 0.1" "--smooth none" "--smooth tangential" "--smooth2 0.1,0.05"; do
    # shellcheck disable=SC2086 # two words
    run tm-remesh $good -o "$BATS_TEST_TMPDIR/out.ply" "$BATS_TEST_TMPDIR/in.ply"
    assert_status 0
  done
  for bad in "--smooth 2" "--smooth strong" "--smooth2 0.1" "--smooth2 0.1,0.3" \
    "--smooth 0.1 --smooth2 0.1,0"; do
    # shellcheck disable=SC2086 # words
    run tm-remesh $bad -o "$BATS_TEST_TMPDIR/bad.ply" "$BATS_TEST_TMPDIR/in.ply"
    assert_status 2
    one_line "$output"
    [ ! -e "$BATS_TEST_TMPDIR/bad.ply" ]
  done
}

@test "float input gives floats that hold what was checked" {
  tetrahedron | tm-convert --float >"$BATS_TEST_TMPDIR/in.ply"
  pipe "tm-remesh --min-edge 0.2x --max-edge 0.5x < $BATS_TEST_TMPDIR/in.ply |
    tm-convert --format ply-ascii | grep -c 'property float [xyz]'"
  assert_status 0
  [ "$output" -eq 3 ]
}

@test "real meshes come out manifold, without self-intersections" {
  needs_shared meshes/cgal/elephant-with-holes.off
  pipe "tm-remesh --iterations 3 $shared_file | tm-intersect --check --report $BATS_TEST_TMPDIR/r.json"
  assert_status 0
}

# sized NEAR FAR: writes a sphere whose property `size` is NEAR if x < 0, and otherwise FAR.
sized() {
  tm-shape sphere --faces 2000 --format ply-ascii --no-provenance |
    awk -v near="$1" -v far="$2" '
      /^element face/ { print "property double size" }
      /^element vertex/ { vertices = $3 }
      heading_over && n < vertices { $4 = $1 < 0 ? near : far; ++n }
      { print }
      /^end_header/ { heading_over = 1 }'
}

@test "a size field makes edges long here and short there, and stays in the mesh" {
  sized 0.04 0.2 >"$BATS_TEST_TMPDIR/in.ply"
  pipe "tm-remesh --size-field size --iterations 4 $BATS_TEST_TMPDIR/in.ply |
    tm-convert --format ply-ascii | awk '
      /^property double/ { ++columns }
      /^element vertex/ { vertices = \$3 }
      over && n < vertices { ++n; if (\$1 < -0.5) ++near; if (\$1 > 0.5) ++far }
      /^end_header/ { over = 1 }
      END { print columns, near / far }'"
  assert_status 0
  read -r columns ratio <<<"$output"
  [ "$columns" -eq 4 ]
  # edges that are five times as short make twenty-five times as many faces, without grading
  awk -v r="$ratio" 'BEGIN { exit !(r > 12 && r < 27) }' || fail "ratio $ratio"
}

@test "with a size field lengths are factors, and the property must be there" {
  sized 0.1 0.1 >"$BATS_TEST_TMPDIR/in.ply"
  run tm-remesh --size-field size --min-edge 0.05 "$BATS_TEST_TMPDIR/in.ply"
  assert_status 2
  [[ $output == *"--min-edge is a factor of the local size: write it as 0.7x, not as 0.05"* ]]
  run tm-remesh --size-field sise "$BATS_TEST_TMPDIR/in.ply"
  assert_status 3
  [[ $output == *"no vertex property 'sise'"* ]]
  sized 0.1 0 >"$BATS_TEST_TMPDIR/zero.ply"
  run tm-remesh --size-field size "$BATS_TEST_TMPDIR/zero.ply"
  assert_status 3
  [[ $output == *"has the size 0"* ]]
  run tm-remesh --size-field size --adaptive 0.1x "$BATS_TEST_TMPDIR/in.ply"
  assert_status 2
}

@test "an adaptive mesh has fewer faces than an even one, and stays within the error" {
  tm-shape torus --faces 20000 -o "$BATS_TEST_TMPDIR/in.ply"
  pipe "tm-remesh --adaptive 0.1x --iterations 4 -o $BATS_TEST_TMPDIR/out.ply $BATS_TEST_TMPDIR/in.ply &&
    tm-compare --reference $BATS_TEST_TMPDIR/in.ply $BATS_TEST_TMPDIR/out.ply"
  assert_status 0
  error=$(awk '$1 == "hausdorff:" { print $2 }' <<<"$output")
  edge=$(tm-info --get edge_mean "$BATS_TEST_TMPDIR/in.ply")
  awk -v h="$error" -v e="$edge" 'BEGIN { exit !(h < 0.1 * e) }' || fail "$error of $edge"
  [ "$(tm-info --get faces "$BATS_TEST_TMPDIR/out.ply")" -lt 10000 ]
}

@test "an adaptive error of nothing is refused" {
  tetrahedron >"$BATS_TEST_TMPDIR/in.ply"
  run tm-remesh --adaptive 0 "$BATS_TEST_TMPDIR/in.ply"
  assert_status 2
  [[ $output == *"the error must be above 0"* ]]
}

# kept_above FILE: prints the feature angle in the report, rounded, because jq 1.7 prints 40.0 as it is written.
kept_above() {
  jq '.result.feature_angle | floor' "$1"
}

@test "sharp edges stay sharp by themselves, but not with --feature-angle 180" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 1 1 1 --faces 600 -o box.ply
  options=(--iterations 5 --min-edge 0.35x --max-edge 0.75x --no-provenance box.ply)
  tm-remesh --feature-angle 40 "${options[@]}" -o sharp.ply
  tm-remesh "${options[@]}" -o own.ply --report own.json
  tm-remesh --feature-angle auto "${options[@]}" -o auto.ply
  tm-remesh --feature-angle 180 "${options[@]}" -o blunt.ply --report blunt.json
  cmp sharp.ply own.ply && cmp sharp.ply auto.ply
  [ "$(kept_above own.json)" = 40 ] && [ "$(kept_above blunt.json)" = 180 ]
  awk -v sharp="$(tm-info --get volume sharp.ply)" -v blunt="$(tm-info --get volume blunt.ply)" \
    'BEGIN { exit !((sharp - 1) ^ 2 < 1e-24 && blunt < 0.9999) }'
}

@test "a box keeps its faces in planes, however fine it is, turned, and with sharp edges of a cut" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 1 1 3 --edge 0.11 -o coarse.ply
  tm-shape box 1 1 3 --faces 60000 -o fine.ply
  tm-transform --rotate 1,2,3,17 coarse.ply -o turned.ply
  # The coordinates of the cut are rounded.
  tm-shape box 1 1 1 --center 0.3,0.4,1.5 --faces 300 | tm-transform --rotate 0,0,1,30 | tm-stitch --flip |
    tm-cat coarse.ply - | tm-transform --rotate 1,2,3,17 | tm-clean -q -o cut.ply
  for mesh in coarse fine turned cut; do
    tm-remesh -q --iterations 3 "$mesh.ply" -o out.ply --report r.json
    [ "$(kept_above r.json)" = 40 ] || fail "$mesh"
    tm-compare --reference "$mesh.ply" --within 1e-9 out.ply || fail "$mesh"
  done
}

@test "smooth shapes have the bytes of --feature-angle 180: coarse, noisy and folded ones too" {
  cd "$BATS_TEST_TMPDIR"
  while read -r shape; do
    # shellcheck disable=SC2086
    tm-shape $shape -o in.ply
    tm-remesh --no-provenance in.ply -o own.ply --report r.json
    tm-remesh --no-provenance --feature-angle 180 in.ply -o blunt.ply
    cmp own.ply blunt.ply || fail "$shape"
    [ "$(kept_above r.json)" = 180 ] || fail "$shape"
  done <<'SHAPES'
sphere --faces 80
sphere --faces 3000 --noise 10%
sphere --faces 3000 --noise 30%
genus 3 --faces 500
torus --faces 200
dumbbell --faces 200
figure 0.2 --faces 1000
folded --faces 3000
dented --faces 3000 --noise 20%
SHAPES
}

@test "--feature-angle takes auto or degrees; decimation keeps no edge by it unless asked to" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 1 1 1 --faces 600 -o box.ply
  for angle in 0 -1 181 sharp nan; do
    run tm-remesh "--feature-angle=$angle" box.ply -o out.ply
    assert_status 2
    [[ $output == *"neither auto nor a number of degrees from 1 to 180"* ]]
  done
  tm-remesh --no-provenance --faces 100 box.ply -o auto.ply
  tm-remesh --no-provenance --faces 100 --feature-angle 180 box.ply -o none.ply
  cmp auto.ply none.ply
}

@test "edges that keep within an error stay long beside edges that stay sharp" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 1 1 1 --faces 3000 -o box.ply
  tm-remesh --adaptive 0.1x --iterations 5 box.ply -o sharp.ply
  tm-remesh --adaptive 0.1x --iterations 5 --feature-angle 180 box.ply -o blunt.ply
  tm-compare --reference box.ply --within 1e-9 sharp.ply
  [ "$(tm-info --get faces sharp.ply)" -lt "$(tm-info --get faces blunt.ply)" ]
}

@test "--project puts the vertices back onto the input" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --faces 2000 -o sphere.ply
  options=(--iterations 5 --min-edge 0.35x --max-edge 0.75x sphere.ply)
  tm-remesh --project "${options[@]}" -o on.ply
  tm-remesh "${options[@]}" -o off.ply
  for mesh in on off; do
    tm-compare --reference sphere.ply --samples 0 $mesh.ply |
      awk '/^hausdorff_to_reference/ { print $2 }'
  done | paste -s | awk '{ exit !($1 < 1e-14 && $2 > 1e-4) }'
  # Faces between vertices of the sphere lie inside of the sphere, and larger faces lie farther inside.
  for line in "--project --iterations 5" "--iterations 5"; do
    read -ra words <<<"$line"
    tm-remesh "${words[@]}" sphere.ply -o mesh.ply
    tm-info --get volume mesh.ply
    tm-compare --reference sphere.ply --get mean mesh.ply
  done | paste -s | awk '{ exit !($1 < 0.9995 * $3 && $2 > 1.5 * $4) }'
}

@test "the lengths that a refusal advises are accepted, and have four digits" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --faces 100 -o sphere.ply
  for lengths in "0.075 0.07" "0.2 0.25" "0.333333333 0.3"; do
    read -r shortest longest <<<"$lengths"
    run tm-remesh --min-edge "$shortest" --max-edge "$longest" sphere.ply
    assert_status 2
    [[ $output =~ "use at most "([0-9.e-]{1,9})" for the shortest, or at least "([0-9.e-]{1,9})" for the longest" ]] ||
      fail "$output"
    tm-remesh --min-edge "${BASH_REMATCH[1]}" --max-edge "$longest" sphere.ply >/dev/null
    tm-remesh --min-edge "$shortest" --max-edge "${BASH_REMATCH[2]}" sphere.ply >/dev/null
  done
}

# A sphere without its cap above z = 0.5.
open_sphere() {
  tm-shape sphere --faces 2000 --format ply-ascii --no-provenance |
    awk '
      /^element vertex/ { vertices = $3 }
      /^element face/ { rest_of_header = 1; next }
      /^end_header/ { in_body = 1; next }
      !in_body { header = header (rest_of_header ? "" : $0 "\n"); list = $0; next }
      n < vertices { z[n++] = $3; points = points $0 "\n"; next }
      z[$2] <= 0.5 && z[$3] <= 0.5 && z[$4] <= 0.5 { faces = faces $0 "\n"; ++count }
      END { printf "%selement face %d\n%s\nend_header\n%s%s", header, count, list, points, faces }'
}

# border FILE: prints the points of the border edges, sorted.
border() {
  tm-convert --format ply-ascii "$1" | awk '
    /^element vertex/ { vertices = $3 }
    /^end_header/ { in_body = 1; next }
    !in_body { next }
    n < vertices { point[n++] = $1 " " $2 " " $3; next }
    { for (i = 2; i <= 4; ++i) is_edge[$i " " $(i < 4 ? i + 1 : 2)] = 1 }
    END {
      for (edge in is_edge) {
        split(edge, ends, " ")
        if (!((ends[2] " " ends[1]) in is_edge)) print point[ends[1]]
      }
    }' | sort
}

@test "--keep-border leaves every vertex of the border, and adds none" {
  cd "$BATS_TEST_TMPDIR"
  open_sphere >open.ply
  border open.ply >before
  [ "$(wc -l <before)" -gt 20 ]
  options=(--iterations 3 --min-edge 0.35x --max-edge 0.75x open.ply)
  tm-remesh --keep-border "${options[@]}" -o kept.ply
  border kept.ply | diff before -
  tm-remesh "${options[@]}" -o changed.ply
  [ "$(border changed.ply | wc -l)" -gt "$(wc -l <before)" ]
}

@test "coordinates too large for areas are exit 3, with what to do; one component is one" {
  cd "$BATS_TEST_TMPDIR"
  for scale in 1e80 1e100 1e154; do
    tm-shape sphere --faces 320 --format ply-ascii |
      awk -v s=$scale 'body && NF == 3 { printf "%.17g %.17g %.17g\n", s * $1, s * $2, s * $3; next }
        /^end_header/ { body = 1 } { print }' >large.ply
    run --separate-stderr tm-remesh large.ply
    assert_status 3
    one_line "$stderr"
    [[ $stderr == *"too large"*"scale it"* ]] || fail "$stderr"
  done
  run --separate-stderr bash -c 'tm-shape sphere --faces 320 | tm-remesh --min-edge 10 --max-edge 20'
  assert_status 4
  [[ $stderr == *"the only component is smaller"* ]]
}

@test "--faces decimates to that number, keeps the shape and makes no self-intersection" {
  tm-shape genus 3 --faces 20000 -o "$BATS_TEST_TMPDIR/in.ply"
  pipe "tm-remesh --faces 1500 <$BATS_TEST_TMPDIR/in.ply >$BATS_TEST_TMPDIR/out.ply"
  assert_status 0
  [ "$(tm-info --get faces "$BATS_TEST_TMPDIR/out.ply")" -eq 1500 ]
  [ "$(tm-info --get genus "$BATS_TEST_TMPDIR/out.ply")" -eq 3 ]
  tm-intersect --check "$BATS_TEST_TMPDIR/out.ply"
  tm-compare --json --reference "$BATS_TEST_TMPDIR/in.ply" "$BATS_TEST_TMPDIR/out.ply" \
    >"$BATS_TEST_TMPDIR/distance.json"
  edge=$(tm-info --get edge_mean "$BATS_TEST_TMPDIR/out.ply")
  jq -e --argjson edge "$edge" '.rms < 0.05 * $edge' "$BATS_TEST_TMPDIR/distance.json"
}

@test "decimation that open seams stop says so, and its advice helps" {
  cd "$BATS_TEST_TMPDIR"
  # Every triangle has corners of its own, up to 1e-15 from those of its neighbors.
  tm-shape box 1 1 1 --faces 600 --double --format off --no-provenance | awk '
    NR == 2 { n = $1; print "OFF\n" 3 * $2, $2, 0 }
    NR > 2 && NR <= n + 2 { x[NR - 3] = $1; y[NR - 3] = $2; z[NR - 3] = $3 }
    NR > n + 2 { for (i = 2; i < 5; ++i) printf "%.17g %.17g %.17g\n", x[$i] + NR % 7 * 1e-15, y[$i], z[$i] }
    NR > n + 2 { faces = faces 3 " " 3 * m " " 3 * m + 1 " " 3 * m + 2 "\n"; ++m }
    END { printf "%s", faces }' >soup.off
  run --separate-stderr tm-remesh --faces 100 soup.off
  [ "$status" -eq 4 ]
  [[ $stderr == *"are left, more than the 100 wanted"*"or run tm-repair first"* ]]
  tm-repair -q soup.off | tm-remesh --faces 12 -o box.off
  [ "$(tm-info --get faces box.off)" -eq 12 ]
}

@test "--error decimates while input and result stay that close, in both directions" {
  cd "$BATS_TEST_TMPDIR"
  # Three meshes: a closed noisy one, a folded one, and one with a border.
  tm-shape genus 3 --faces 8000 --noise 10% -o noisy.ply
  tm-shape folded --faces 8000 | tm-clean -q -o folded.ply
  tm-shape sphere --faces 8000 | tm-select --box=-9,-9,-9,9,9,0.5 -o open.ply
  local mesh error
  for mesh in noisy folded open; do
    for error in 0.05 0.01; do
      tm-remesh --error "$error" "$mesh.ply" -o out.ply --report r.json
      tm-compare --json --samples 100000 --reference "$mesh.ply" out.ply >distance.json
      # Both distances come close to the error; otherwise the error would not be used.
      jq -e --argjson error "$error" '.hausdorff <= $error and .hausdorff > 0.7 * $error' distance.json ||
        fail "$mesh $error: $(cat distance.json)"
      jq -e --argjson error "$error" --slurpfile distance distance.json \
        '.result | .error_bound <= $error and .error_bound >= $distance[0].hausdorff' r.json
      tm-intersect --check out.ply
      [ "$(tm-info --get faces out.ply)" -eq "$(jq .result.faces r.json)" ]
    done
  done
}

@test "--error with --faces ends at whichever comes first, and says so" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus --faces 4000 -o in.ply
  run tm-remesh --error 0.1 --faces 1000 in.ply -o out.ply
  assert_status 0
  [ -z "$output" ]
  [ "$(tm-info --get faces out.ply)" -eq 1000 ]
  run tm-remesh --error 0.01 --faces 20 in.ply -o out.ply
  assert_status 0
  [[ $output == *" faces left, more than the 20 wanted: "*"a larger --error leaves fewer"* ]]
  # The advice of the message works.
  run tm-remesh --error 1 --faces 20 in.ply -o out.ply
  [ -z "$output" ]
  [ "$(tm-info --get faces out.ply)" -eq 20 ]
  tm-shape box 1 1 1 --faces 3000 -o box.ply
  run tm-remesh --error 0.01 --faces 500 box.ply -o out.ply
  [[ $output == *"12 faces left, fewer than the 500 wanted, as flat faces were merged"* ]]
}

@test "--error 0 merges flat faces and moves nothing" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 1 1 3 --faces 3000 | tm-transform --rotate 1,2,3,17 -o box.ply
  tm-remesh --error 0 box.ply -o out.ply --report r.json
  [ "$(tm-info --get faces out.ply)" -eq 12 ]
  jq -e '.result | .merged_faces > 2800 and .error_bound < 1e-13' r.json
  tm-compare --reference box.ply --within 1e-13 out.ply
  run tm-remesh --error 0 --keep-border box.ply
  assert_status 2
  [[ $output == *"allow an error above 0"* ]]
  run tm-remesh --error 0.1 --iterations 2 box.ply
  assert_status 2
  [[ $output == *"--iterations remeshes"* ]]
}

@test "--faces leaves a mesh with fewer alone and says so, and is not mixed with remeshing" {
  tm-shape sphere --faces 100 -o "$BATS_TEST_TMPDIR/in.ply"
  run tm-remesh --faces 5000 "$BATS_TEST_TMPDIR/in.ply" -o "$BATS_TEST_TMPDIR/out.ply"
  assert_status 0
  [[ $output == *"stays as it is"* ]]
  [ "$(tm-info --get faces "$BATS_TEST_TMPDIR/out.ply")" -eq "$(tm-info --get faces "$BATS_TEST_TMPDIR/in.ply")" ]
  run tm-remesh --faces 50 --iterations 2 "$BATS_TEST_TMPDIR/in.ply"
  assert_status 2
  [[ $output == *"--iterations remeshes"* ]]
  tm-cat "$BATS_TEST_TMPDIR/in.ply" "$BATS_TEST_TMPDIR/in.ply" >"$BATS_TEST_TMPDIR/two.ply"
  run tm-remesh --faces 4 "$BATS_TEST_TMPDIR/two.ply" -o "$BATS_TEST_TMPDIR/none.ply"
  assert_status 4
  [ ! -e "$BATS_TEST_TMPDIR/none.ply" ]
}

@test "--only smooth keeps every face" {
  tm-shape sphere --faces 2000 --noise 2% --seed 1 -o "$BATS_TEST_TMPDIR/in.ply"
  tm-remesh --only smooth --smooth 0.5 --iterations 3 "$BATS_TEST_TMPDIR/in.ply" -o "$BATS_TEST_TMPDIR/out.ply"
  tm-convert --format off "$BATS_TEST_TMPDIR/in.ply" | grep '^3 ' >"$BATS_TEST_TMPDIR/faces-in"
  tm-convert --format off "$BATS_TEST_TMPDIR/out.ply" | grep '^3 ' >"$BATS_TEST_TMPDIR/faces-out"
  cmp "$BATS_TEST_TMPDIR/faces-in" "$BATS_TEST_TMPDIR/faces-out"
  run ! cmp -s "$BATS_TEST_TMPDIR/in.ply" "$BATS_TEST_TMPDIR/out.ply"
  run tm-remesh --only smooth --smooth none "$BATS_TEST_TMPDIR/in.ply"
  assert_status 2
}

@test "a reference edge of another mesh is reported, unless requested" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --faces 4000 -o fine.ply
  tm-remesh fine.ply | tm-remesh --faces 400 -o coarse.ply
  run --separate-stderr tm-remesh coarse.ply -o out.ply
  assert_status 0
  [[ $stderr == *"tm:reference-edge"*"--reference-edge auto"* ]]
  run --separate-stderr tm-remesh --reference-edge auto coarse.ply -o out.ply
  [ -z "$stderr" ]
}

# far_pairs: counts pairs of faces of far.ply that intersect as floats.
far_pairs() {
  tm-convert -q --float far.ply | tm-intersect -q --report pairs.json -o intersected.ply
  sed -n 's/.*"pairs": \([0-9][0-9]*\).*/\1/p' pairs.json
}

@test "far from the origin, what is written as floats was checked as floats" {
  cd "$BATS_TEST_TMPDIR"
  for shape in sphere torus 'torus-knot 2 3'; do
    # shellcheck disable=SC2086 # a kind and its numbers
    tm-shape $shape --faces 20000 | tm-transform --translate 1e5,0,0 -o far.ply
    [ "$(far_pairs)" -eq 0 ]
    run --separate-stderr tm-remesh --max-edge 0.8x --min-edge 0.4x -o out.stl far.ply
    assert_status 0
    [ -z "$stderr" ]
    tm-intersect -q --check out.stl
  done
}

@test "intersections due to rounding to floats are reported, and tm-clean writes none" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus-knot 2 3 --faces 20000 | tm-transform --translate 1e6,0,0 -o far.ply
  count=$(far_pairs)
  [ "$count" -gt 0 ]
  for output in '-o out.stl' '-o out.glb' '--float -o out.ply'; do
    # shellcheck disable=SC2086 # two words
    run --separate-stderr timeout 60 tm-remesh $output far.ply
    assert_status 0
    [[ $stderr == *"$count pairs of faces intersect only as floats: let tm-clean write the file"* ]]
  done
  tm-remesh far.ply | tm-clean -q -o out.stl
  tm-intersect -q --check out.stl
  # Computed coordinates are checked too, once.
  tm-convert -q --float far.ply -o floats.ply
  run --separate-stderr tm-displace --normal-speed 0.05x floats.ply -o out.ply
  one_line "$stderr"
  [[ $stderr == *"only as floats"* ]]
}

@test "where floats are as far apart as vertices, remeshing ends" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape genus 3 --faces 20000 | tm-transform --translate 1e6,0,0 -o far.ply
  timeout 60 tm-remesh -q --float --max-memory 2G far.ply -o out.ply
  [ "$(tm-info --get faces out.ply)" -lt 100000 ]
}

@test "guaranteed: boxes that share planes are remeshed without a self-intersection" {
  cd "$BATS_TEST_TMPDIR" || return
  tm-shape box 1 1 1 --faces 12 -o a.ply
  tm-shape box 1 0.5 1 --faces 12 -o b.ply
  for angle in 17 34 51 68 85; do
    pipe "tm-cat a.ply b.ply | tm-transform --rotate 1,2,3,$angle | tm-clean |
      tm-remesh --reference-edge 0.1 --report r.json | tm-checkmanifold --closed --intersections"
    assert_status 0
    [[ $output == *"degenerate_faces: 0"* ]]
    [ "$(value faces_without_area r.json)" -eq 0 ]
  done
}

@test "dropped components are reported with their faces, area and volume" {
  cd "$BATS_TEST_TMPDIR" || return
  tm-shape sphere --radius 0.05 --faces 200 | tm-transform --translate 3,0,0 -o speck.ply
  pipe "tm-shape sphere --faces 1000 | tm-cat - speck.ply |
    tm-remesh --min-edge 0.2 --max-edge 0.4 --report r.json 2>&1 >/dev/null"
  assert_status 0
  [[ $output == *"1 component of "*" dropped: smaller than the shortest edge 0.2; a smaller --min-edge keeps more"* ]]
  [ "$(value components_dropped r.json)" -eq 1 ]
  [ "$(value components_dropped_faces r.json)" -eq "$(tm-info --get faces speck.ply)" ]
  # If the advice of the message is followed, the small component stays.
  pipe "tm-shape sphere --faces 1000 | tm-cat - speck.ply |
    tm-remesh --min-edge 0.02 --max-edge 0.4 | tm-info --get components"
  assert_status 0
  [ "$output" -eq 2 ]
}

@test "--curved moves no vertex that no step touches, and --smooth given with it does" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape dented --faces 3000 -o in.ply
  places() { tm-convert --format off "$1" | awk '!/^#/ && NF == 3' | tail -n +2 | sort -u; }
  places in.ply >in.txt
  tm-remesh --curved --max-edge 1.15x --report r.json in.ply -o curved.ply
  places curved.ply >curved.txt
  touched=$(($(value splits r.json) + $(value collapses r.json)))
  [ "$touched" -gt 20 ]
  [ "$touched" -lt 1000 ]
  [ "$(comm -13 in.txt curved.txt | wc -l)" -le "$touched" ]
  tm-remesh --curved --smooth tangential --max-edge 1.15x in.ply -o slid.ply
  places slid.ply >slid.txt
  [ "$(comm -13 in.txt slid.txt | wc -l)" -gt 1000 ]
}

@test "--min-film keeps the rim of a plate, which is said in the report" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape box 1 1 0.02 --faces 3000 -o plate.ply
  tm-remesh --edge 0.1 --smooth none --feature-angle 180 plate.ply -o without.ply
  tm-remesh --edge 0.1 --smooth none --feature-angle 180 --min-film 0.015 --report r.json \
    plate.ply -o with.ply
  [ "$(value films_kept r.json)" -gt 0 ]
  lost() { tm-info --json "$1" | awk '$1 == "\"volume\":" { print 1 - $2 / 0.02 }'; }
  awk -v a="$(lost without.ply)" -v b="$(lost with.ply)" 'BEGIN { exit !(a > 0.02 && b < 0.005) }'
}

@test "--pinch parts a dumbbell and says so, and refuses what is open" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape dumbbell --neck 0.1 --faces 4000 -o whole.ply
  tm-remesh --pinch 0.8 --report r.json whole.ply -o parted.ply
  [ "$(value pinched r.json)" = 1 ]
  [ "$(tm-info --get components parted.ply)" = 2 ]
  tm-intersect --check parted.ply
  tm-remesh --pinch 0.4 whole.ply -o same.ply
  [ "$(tm-info --get components same.ply)" = 1 ]
  tetrahedron | tm-select --plane 1,1,1,0.4 >open.ply
  run tm-remesh --pinch 1 -o bad.ply open.ply
  assert_status 3
  one_line "$output"
  [ ! -e bad.ply ]
}

@test "--edge is --min-edge 0.7 times and --max-edge 1.5 times as long" {
  cd "$BATS_TEST_TMPDIR"
  tm-shape sphere --faces 2000 -o ball.ply
  tm-remesh --no-provenance --edge 0.1 ball.ply -o edge.ply
  tm-remesh --no-provenance --min-edge 0.07 --max-edge 0.15 ball.ply -o limits.ply
  cmp <(sed '1,/^end_header/d' edge.ply) <(sed '1,/^end_header/d' limits.ply)
  # Meshes with longer and with shorter edges lead to about the same length.
  for faces in 300 20000; do
    tm-shape sphere --faces $faces | tm-remesh --edge 0.1 -o other.ply
    awk -v mean="$(tm-info --get edge_mean other.ply)" 'BEGIN { exit !(mean > 0.08 && mean < 0.12) }'
  done
  run --separate-stderr tm-remesh --edge 0.1 --min-edge 0.05 ball.ply
  [ "$status" -eq 2 ]
}

@test "--faces merges flat faces where collapses alone get stuck, and says so" {
  cd "$BATS_TEST_TMPDIR"
  awk 'BEGIN {
    slivers = 60; n = slivers + 2; u = 2 ^ -53
    print "OFF"; print 4 * n, 8 * (n - 1) + 4, 0
    for (z = 0; z < 2; ++z) for (x = 0; x < 2; ++x) for (i = 0; i < n; ++i)
      printf "%d %.17g %d\n", x, i == 0 ? 0 : i == n - 1 ? 1 : .5 + (i - 1) * u, z
    for (i = 0; i + 1 < n; ++i) {
      quad(2 * n + i, 3 * n + i, 3 * n + i + 1, 2 * n + i + 1); quad(i, i + 1, n + i + 1, n + i)
      quad(n + i, n + i + 1, 3 * n + i + 1, 3 * n + i); quad(i, 2 * n + i, 2 * n + i + 1, i + 1)
    }
    quad(0, n, 3 * n, 2 * n); quad(n - 1, 3 * n - 1, 4 * n - 1, 2 * n - 1)
  }
  function quad(a, b, c, d) { print 3, a, b, c; print 3, a, c, d }' >slivers.off
  run tm-remesh --faces 20 slivers.off -o out.ply
  assert_status 0
  [[ $output == *"collapses alone left more than 20 faces, so flat faces were merged first"* ]]
  [[ $output == *"12 faces left, fewer than the 20 wanted"* ]]
  tm-checkmanifold --closed --intersections out.ply
}
