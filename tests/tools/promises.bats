# Tests of promises of the man pages that belong to no other file. tests/PROMISES.md names the test of each
# promise. Meshes are judged by `bin-test/chains`, which shares no code with the library.

load ../helpers/common
load ../helpers/contract
load ../helpers/scene

promises=$tm_root/tests/PROMISES.md

setup_file() {
  make_contract_inputs "$BATS_FILE_TMPDIR"
}

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# judge FILE...: checks by exact predicates that meshes are closed and manifold, without intersections and
# faces without area.
judge() {
  "$tm_build/bin-test/chains" --judge "$@" || fail "not sound"
}

# rows: prints page, words, file and test of each promise, separated by tabs.
rows() {
  sed -nE 's/^\| ([^|]*\.md) \| (.*) \| (tests[^|]*) \| (.*) \|$/\1\t\2\t\3\t\4/p' "$promises"
}

# sentences PAGE: prints the sentences of a page, one per line.
sentences() {
  grep -v '^# ' "$tm_root/man/$1" | awk -v RS= '{ gsub("\n", " "); gsub("[.] +", ".\n"); print }'
}

@test "every promise is on its page and has its test" {
  local count=0 page words file name
  while IFS=$'\t' read -r page words file name; do
    tr '\n' ' ' <"$tm_root/man/$page" | grep -qF -- "$words" || fail "$page does not say: $words"
    grep -qF -e "@test \"$name\"" -e "TEST_CASE(\"$name\")" "$tm_root/$file" ||
      fail "$file has no test: $name"
    count=$((count + 1))
  done < <(rows)
  [ "$count" -ge 25 ]
  # Every row has all cells.
  [ "$count" -eq "$(($(grep -c '^|' "$promises") - 2))" ]
}

@test "every sentence of a man page that promises has a row" {
  local page sentence words is_listed
  while read -r page; do
    while IFS= read -r sentence; do
      is_listed=
      while IFS= read -r words; do
        if [[ $sentence == *"$words"* ]]; then is_listed=yes; fi
      done < <(rows | awk -F '\t' -v page="$page" '$1 == page { print $2 }')
      [ -n "$is_listed" ] || fail "tests/PROMISES.md lacks, of $page: $sentence"
    done < <(sentences "$page" | grep -iE '\<(guarantee[a-z]*|never|always|promise[a-z]*|no step)\>')
  done < <(cd "$tm_root/man" && ls -- *.md fragments/*.md)
}

@test "tm-clean: no step perturbs or approximates" {
  # On a lattice of eighths, all intersections are lattice points, and volumes are exact.
  tm-shape box 1 1 1 --faces 12 -o a.ply
  tm-shape box 1 0.5 0.75 --faces 12 --center 0.5,0.25,0.125 -o b.ply
  tm-cat a.ply b.ply | tm-clean -o union.ply
  tm-cat a.ply b.ply | tm-clean --level 2 -o common.ply
  judge union.ply common.ply
  tm-convert --format off union.ply | awk '
    /^(#|OFF)/ { next }
    !vertices { vertices = $1; next }
    ++count <= vertices { for (i = 1; i <= 3; ++i) if (8 * $i != int(8 * $i)) exit 1 }'
  tm-info --get volume common.ply | awk '{ exit !(($1 - 0.5 * 0.5 * 0.75) ^ 2 < 1e-30) }'
  tm-info --get volume union.ply | awk '{ exit !(($1 - 1 - 0.5 * 0.5 * 0.75) ^ 2 < 1e-30) }'
}

@test "tm-clean: guaranteed for every input: closed, no self-intersection, and what moved stayed within rounding_displacement" {
  local turn type moved size
  for turn in 17 34 51 68 85; do
    for type in --float --double; do
      tm-shape boxes --count 12 --seed "$turn" --double |
        tm-transform --rotate "1,2,3,$turn" | tm-convert "$type" >in.ply
      tm-clean in.ply --report report.json -o out.ply
      judge out.ply
      moved=$(jq .result.rounding_displacement report.json)
      size=$(tm-info --json in.ply | jq '[.bbox_min[], .bbox_max[]] | map(fabs) | max')
      winding_oracle in.ply out.ply --tolerance "$(jq -n "($moved + 1e-15) / $size")" ||
        fail "winding numbers are wrong beyond $moved"
    done
  done
}

@test "tm-clean: always there are the keys of the report" {
  awk '/^Always there are:/ { inside = 1 } /^# ROUNDING/ { inside = 0 } inside && /^\*\*/' \
    "$tm_root/man/tm-clean.1.md" | grep -oE '\*\*[a-z_]+\*\*' | tr -d '*' | sort >keys
  [ "$(wc -l <keys)" -ge 15 ]
  tm-shape sphere --faces 300 -o clean.ply
  tm-shape boxes -o boxes.ply
  tm-shape folded --faces 2000 -o folded.ply
  tm-select --box=-9,-9,-9,9,9,0 clean.ply -o open.ply
  local mesh
  for mesh in clean boxes folded open; do
    tm-clean "$mesh.ply" --report report.json -o out.ply
    [ -z "$(jq -r '.result | keys[]' report.json | sort | comm -13 - keys)" ]
  done
}

# Two rotated boxes with common planes: tm-clean leaves slivers thinner than a spacing.
turned_boxes() { # DEGREES
  tm-shape box 1 1 1 --faces 12 -o a.ply
  tm-shape box 1 0.5 1 --faces 12 -o b.ply
  tm-cat a.ply b.ply | tm-transform --rotate "1,2,3,$1"
}

@test "tm-remesh: no step makes a self-intersection or a triangle without area" {
  local turn options
  for turn in 17 34 51 68 85; do
    for options in '' '--iterations 3' '--feature-angle 40' '--smooth 0.1'; do
      # shellcheck disable=SC2086
      turned_boxes "$turn" | tm-clean | tm-remesh --reference-edge 0.1 $options -o out.ply
      judge out.ply
    done
  done
}

@test "tm-remesh: the result is an oriented manifold of the same genus, with the same components" {
  local shape
  for shape in 'genus 3' tori 'many-spheres --count 5'; do
    # shellcheck disable=SC2086
    tm-shape $shape --faces 4000 | tm-clean -o in.ply
    tm-remesh --min-edge 1.5x --max-edge 3x --iterations 3 in.ply -o out.ply
    judge out.ply
    diff <(tm-info in.ply | grep -E '^(genus|components)') \
      <(tm-info out.ply | grep -E '^(genus|components)')
  done
}

@test "tm-remesh: always in the report: joined_vertices" {
  tm-shape box 1 1 3 --faces 300 -o in.ply
  local options
  for options in '' '--faces 100' '--align in.ply' '--only smooth' '--iterations 0' '--adaptive 2%'; do
    # shellcheck disable=SC2086
    tm-remesh $options --report report.json in.ply -o out.ply
    [ "$(jq .result.joined_vertices report.json)" = 0 ] || fail "with $options: $(cat report.json)"
  done
}

@test "tm-remesh: with --faces the topology stays, and no self-intersection appears" {
  local shape
  for shape in 'genus 3' tori bowl; do
    # shellcheck disable=SC2086
    tm-shape $shape --faces 4000 -o in.ply
    tm-remesh --faces 800 in.ply -o out.ply
    judge out.ply
    diff <(tm-info in.ply | grep -E '^(genus|components)') \
      <(tm-info out.ply | grep -E '^(genus|components)')
  done
}

@test "tm-fill: patches do not intersect the mesh" {
  # Holes whose flat patches would intersect an obstacle in the hole, and holes of a soup with many holes.
  tm-shape sphere --faces 2000 | tm-select --invert --box=-9,-9,0.5,9,9,9 >cap.ply
  tm-shape box 0.2 0.2 0.8 --faces 300 --center 0,0,0.5 | tm-cat cap.ply - >pin.ply
  local mesh
  for seed in 1 2 3; do
    tm-shape genus 3 --faces 3000 --format off --seed "$seed" | grep -v '^#' |
      awk -v seed="$seed" 'BEGIN { srand(seed) } NR == 2 { v = $1; f = $2; next } NR > 2 {
        if (NR <= v + 2) points = points $0 "\n"; else if (rand() > 0.1) { faces = faces $0 "\n"; ++n } }
        END { printf "OFF\n%d %d 0\n%s%s", v, n, points, faces }' | tm-stitch >"holes-$seed.ply"
  done
  for mesh in pin holes-1 holes-2 holes-3; do
    tm-fill "$mesh.ply" --report report.json -o out.ply
    "$tm_build/bin-test/chains" --judge out.ply | grep ' no_area 0 intersections 0 ' ||
      fail "$mesh crosses or has faces without area"
    [ "$(jq .result.holes report.json)" -gt 0 ]
  done
}

@test "tm-compare: distances are never more than the true ones, and more samples bring them closer" {
  # A wall stands between floor and ceiling. Only its points on the line at half its height are half the
  # height away from both, which is the largest distance.
  printf 'OFF\n8 4 0\n-9 -9 0\n9 -9 0\n9 9 0\n-9 9 0\n-9 -9 1\n9 -9 1\n9 9 1\n-9 9 1
3 0 1 2\n3 0 2 3\n3 4 5 6\n3 4 6 7\n' >planes.off
  printf 'OFF\n4 2 0\n-3 0 0\n3 0 0\n3 0 1\n-3 0 1\n3 0 1 2\n3 0 2 3\n' >wall.off
  local samples all=
  for samples in 10 1000 100000; do
    all+="$(tm-compare --reference planes.off --samples "$samples" wall.off |
      awk '/^hausdorff_to_reference:/ { print $2 }') "
  done
  awk '{ exit !($1 < $2 && $2 < $3 && $3 <= 0.5 && $3 > 0.4999) }' <<<"$all" || fail "$all"
}

@test "tm-compare: without --within the answer is always yes" {
  tm-shape sphere --faces 300 -o a.ply
  tm-shape box 9 9 9 --center 99,0,0 -o b.ply
  tm-compare --reference a.ply b.ply
  tm-compare --reference b.ply a.ply
  run tm-compare --reference a.ply --within 1 b.ply
  assert_status 1
}

@test "tm-morph: --features on aligns always, auto only where many edges are sharp" {
  # A ball from which a small box protrudes: its sharp edges are less than a fiftieth of all edges.
  tm-shape sphere --faces 4000 -o ball.ply
  tm-shape box 0.4 0.4 0.4 --faces 12 --center 0,0,1 | tm-cat ball.ply - | tm-clean >target.ply
  tm-shape sphere --around target.ply --faces 2000 -o source.ply
  local choice
  for choice in on auto off; do
    tm-morph -q source.ply --target target.ply --features "$choice" --report "$choice.json" -o out.ply
    jq -e '.result.converged' "$choice.json"
  done
  jq -e '.result.aligned > 0' on.json
  jq -e '.result.aligned == 0' auto.json
  jq -e '.result.aligned == 0' off.json
}

time_is_unlimited() {
  [ "$kind" = source ] || arguments+=("$mesh")
  "$program" "${arguments[@]}" --max-time 0 -o out 2>stderr || fail "$program: $(cat stderr)"
  [ -s out ]
}

@test "--max-time 0 is never" {
  for_each filter picture source converter loop -- time_is_unlimited
  # The input arrives after 1.5 s, when any immediate limit would have ended the program.
  tetrahedron | (sleep 1.5 && cat) | tm-clean --max-time 0 >out.ply
  [ "$(tm-info --get faces out.ply)" -eq 4 ]
  run bash -c 'sleep 1.5 | tm-clean --max-time 0.5'
  assert_status 4
}

@test "--no-progress never reports progress" {
  needs_command script
  export TERM=xterm  # progress is not reported on a terminal named "dumb"
  tm-shape torus --faces 60000 -o torus.ply
  tm-shape sphere --around torus.ply --faces 3000 -o ball.ply
  script -qec 'tm-remesh --iterations 60 torus.ply -o out.ply' /dev/null </dev/null >seen
  grep -q '%' seen
  script -qec 'tm-remesh --no-progress --iterations 60 torus.ply -o out.ply' /dev/null </dev/null >seen
  [ ! -s seen ]
  script -qec 'tm-morph --no-progress --iterations 3 ball.ply --target torus.ply -o out.ply' /dev/null \
    </dev/null >seen
  if grep -q '%' seen; then fail "progress: $(cat seen)"; fi
}
