# Chains of programs on random CAD-like bodies, each output judged by an oracle that links nothing
# of the library. `chains --seeds 1..5000 --jobs 2` runs many, `chains --pipelines` those of the recipes.

load ../helpers/common

chains=$tm_build/bin-test/chains

setup() {
  cd "$BATS_TEST_TMPDIR" || exit
}

# percent 'words': prints the percentage before these words in the last run's summary.
percent() {
  grep -oE "[0-9.]+ % $1" <<<"$output" | cut -d ' ' -f 1
}

@test "chains: 200 chains write no intersection, open edge, face without area or wrong volume" {
  run "$chains" --seeds 1..200 --bin "$tm_build/bin"
  grep -v '^pair' <<<"$output"
  assert_status 0
  awk -v share="$(percent 'rotated with coplanar contact')" 'BEGIN { exit !(share >= 30) }'
  awk -v share="$(percent 'of three programs or more')" 'BEGIN { exit !(share >= 50) }'
}

@test "chains: the same seed gives the same chain" {
  "$chains" --write 5 one --bin "$tm_build/bin" || true
  "$chains" --write 5 two --bin "$tm_build/bin" || true
  rm one/report.json two/report.json
  diff -r one two
}

@test "chains: every pipeline of the runner is in the README or the recipes" {
  "$chains" --pipelines --list >commands
  # A line that ends in a pipe continues on the next line.
  cat "$tm_root/README.md" "$tm_root/docs/recipes.md" |
    sed -e ':more' -e '/|$/ { N; s/\n */ /; b more' -e '}' >readme
  [ "$(wc -l <commands)" -ge 12 ]
  while IFS= read -r command; do
    grep -qF -- "${command% -o *}" readme || fail "not printed: $command"
  done <commands
}

@test "chains: the pipelines of the recipes on 5 bodies have no finding" {
  run "$chains" --pipelines --seeds 1..5 --jobs 2 --bin "$tm_build/bin"
  grep -v '^pair' <<<"$output"
  assert_status 0
}

# spoil PROGRAM SCRIPT: makes a folder of programs in which PROGRAM is wrong. SCRIPT runs in its place, with
# the correct program in $real and the arguments.
spoil() {
  rm -rf spoiled && mkdir spoiled
  ln -s "$tm_build"/bin/tm-* spoiled/
  rm "spoiled/$1"
  printf '#!/usr/bin/env bash\nPATH=%s:$PATH\nreal=%s\n%s\n' "$tm_build/bin" "$tm_build/bin/$1" "$2" \
    >"spoiled/$1"
  chmod +x "spoiled/$1"
}

# spoil_off PROGRAM SCRIPT: changes the output of the correct program by an awk script. The output is OFF; v
# and f are its numbers of vertices and faces.
spoil_off() {
  spoil "$1" "\"\$real\" \"\$@\" | tm-convert --format off --no-provenance | grep -v '^#' |
    awk 'NR == 2 { v = \$1; f = \$2 } $2'"
}

# expect_kind KIND: checks that a chain fails with a finding of this kind, and that the options of the
# runner that repeat the chain are printed.
expect_kind() {
  run "$chains" --seeds 1..30 --bin spoiled
  assert_status 1
  grep -qE "^FAILED [0-9]+ $1 in .*\[chains --write [0-9]+ FOLDER\]" <<<"$output" ||
    fail "no $1 in: $(grep -v '^pair' <<<"$output")"
}

# shellcheck disable=SC2016
@test "chains: every kind of fault is found" {
  spoil_off tm-clean 'NR == 2 { print v, f - 1, 0; next } NR < v + f + 2'
  expect_kind open
  spoil tm-clean '"$real" "$@" >"$$.ply" && tm-cat "$$.ply" "$$.ply"; rm "$$.ply"'
  expect_kind intersects
  spoil tm-clean '"$real" "$@" | tm-transform --scale 1.001'
  expect_kind volume
  spoil tm-remesh 'tm-shape box 1 1 1 --faces 12 --center 9,9,9 >"$$.ply"
    "$real" "$@" | tm-cat - "$$.ply"; rm "$$.ply"'
  expect_kind components
  # A tetrahedron with four corners at only two positions.
  spoil_off tm-clean 'NR == 2 { print v + 4, f + 4, 0; next } NR == 3 { p = $0 } NR == 4 { q = $0 }
    { print } NR == v + 2 { print p "\n" q "\n" p "\n" q }
    END { a = v; b = v + 1; c = v + 2; d = v + 3
      print 3, a, b, c "\n" 3, a, c, d "\n" 3, a, d, b "\n" 3, b, d, c }'
  expect_kind no-area
  # A face whose first corner is replaced by a corner of a distant face.
  spoil_off tm-clean 'NR == v + 3 { $2 = ($2 + int(v / 2)) % v } { print }'
  expect_kind not-manifold
  spoil_off tm-clean 'NR == v + 3 { $2 = v } { print }'
  expect_kind index
  spoil tm-clean 'echo "no mesh"'
  expect_kind unreadable
  spoil tm-clean 'kill -SEGV $$'
  expect_kind crash
  spoil tm-intersect '"$real" "$@"; for last; do :; done
    sed -i "s/\"pairs\": [0-9][0-9]*/\"pairs\": 1234567/" "$last"'
  expect_kind count
  spoil tm-clean '"$real" "$@"; for last; do :; done; echo "{" >"$last"'
  expect_kind report
}

@test "chains: refusals are counted, and too many fail" {
  spoil tm-clean 'echo "tm-clean: not today" >&2; exit 4'
  run "$chains" --seeds 1..20 --bin spoiled
  assert_status 1
  [[ $output == *"REFUSED 1 refused in "*": exit code 4: tm-clean: not today"* ]]
}

@test "chains: a program that does not end is a fault" {
  spoil tm-clean 'while :; do :; done'
  run "$chains" --seeds 1 --seconds 1 --bin spoiled
  assert_status 1
  [[ $output == *"FAILED 1 hang in "* ]]
}
