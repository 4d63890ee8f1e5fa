# Chains of programs on random CAD-like bodies, each output judged by an oracle that links nothing
# of the library. `chains --seeds 1..5000 --jobs 2` runs many, `chains --pipelines` the README's.

load ../helpers/common

chains=$tm_build/bin-test/chains

setup() {
  cd "$BATS_TEST_TMPDIR" || exit
}

# number 'pattern': the number before a word of the last run's summary.
number() {
  sed -nE "s/.*[ ^]?([0-9.]+) %? ?$1.*/\1/p" <<<"$output" | tail -n 1
}

@test "chains: 200 chains write no intersection, open edge, face without area or wrong volume" {
  run "$chains" --seeds 1..200 --bin "$tm_build/bin"
  grep -v '^pair' <<<"$output"
  assert_status 0
  awk -v share="$(number 'rotated with coplanar contact')" 'BEGIN { exit !(share >= 30) }'
  awk -v share="$(number 'of three programs or more')" 'BEGIN { exit !(share >= 50) }'
}

@test "chains: the same seed gives the same chain" {
  "$chains" --write 5 one --bin "$tm_build/bin" || true
  "$chains" --write 5 two --bin "$tm_build/bin" || true
  rm one/report.json two/report.json
  diff -r one two
}

@test "chains: every pipeline of the runner is in the README" {
  "$chains" --pipelines --list >commands
  [ "$(wc -l <commands)" -ge 12 ]
  while IFS= read -r command; do
    grep -qF -- "${command% -o *}" "$tm_root/README.md" || fail "not in the README: $command"
  done <commands
}

@test "chains: the README's pipelines on 8 bodies have no finding" {
  run "$chains" --pipelines --seeds 1..8 --jobs 2 --bin "$tm_build/bin"
  grep -v '^pair' <<<"$output"
  assert_status 0
}

# spoil PROGRAM SCRIPT: a folder of programs of which one is wrong: SCRIPT is run with $real, the
# right one, and the arguments.
spoil() {
  rm -rf spoiled && mkdir spoiled
  ln -s "$tm_build"/bin/tm-* spoiled/
  rm "spoiled/$1"
  printf '#!/usr/bin/env bash\nPATH=%s:$PATH real=%s\n%s\n' "$tm_build/bin" "$tm_build/bin/$1" "$2" >"spoiled/$1"
  chmod +x "spoiled/$1"
}

# expect_kind KIND: some chain fails in that way, with the line that repeats it.
expect_kind() {
  run "$chains" --seeds 1..40 --bin spoiled
  assert_status 1
  grep -qE "^FAILED [0-9]+ $1 in .*\[chains --write [0-9]+ FOLDER\]" <<<"$output" ||
    fail "no $1 in: $output"
}

# shellcheck disable=SC2016
@test "chains: every kind of fault is found" {
  # A face less.
  spoil tm-clean '"$real" "$@" | tm-select --invert --where "kind = 1" 2>/dev/null ||
    "$real" "$@" | tm-convert --format off | awk "NR == 2 { \$2 -= 1 } { print }" | head -n -1'
  expect_kind open
  # A body twice, and without its smallest component.
  spoil tm-clean '"$real" "$@" >one.ply && tm-cat one.ply one.ply'
  expect_kind intersects
  spoil tm-clean '"$real" "$@" | tm-transform --scale 1.001'
  expect_kind volume
  spoil tm-transform '"$real" "$@" | tm-select --largest 1'
  expect_kind components
  # A face without area in place of an edge.
  spoil tm-clean '"$real" --format off "$@" | awk "
    NR == 2 { v = \$1; f = \$2; print v + 2, f + 4, 0; next }
    NR == 3 { x = \$0 }
    NR == v + 2 { print; print x; print x; next }
    { print }
    END { print 3, v, v + 1, 0; print 3, 0, v + 1, v; print 3, v, 0, v + 1; print 3, v + 1, 0, v }"'
  expect_kind no-area
  spoil tm-clean 'echo "tm-clean: no" >&2; kill -SEGV $$'
  expect_kind crash
  spoil tm-clean 'echo OFF 1 1 0 0 0 0 3 0 1 2'
  expect_kind index
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
