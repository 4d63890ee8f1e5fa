# The corpus of degenerate and real meshes: its quick part, and tests that its runner can fail.

load ../helpers/common

corpus=$BATS_TEST_DIRNAME

setup() {
  cd "$BATS_TEST_TMPDIR" || exit
}

@test "corpus: the quick part passes" {
  run "$corpus/run" --quick
  echo "$output"
  assert_status 0
  [[ $output == *"kind "*"all "* ]]
}

@test "corpus: at least 500 cases of all kinds, with different names" {
  "$tm_build/bin-test/corpus_shapes" >list
  [ "$(wc -l <list)" -ge 500 ]
  [ "$(cut -d ' ' -f 1 list | sort -u | wc -l)" -eq "$(wc -l <list)" ]
  local kind
  for kind in axis barely-held cavity coincident coplanar-opposite coplanar-same \
    duplicate-vertices edge-contact eversion far-away folded-flat inside-out inverted jitter \
    lattice-soup levels many-in-one-face nearly-coplanar needles nested not-oriented open point \
    scale touching vertex-on-face walls workload zero-area zero-length; do
    grep -q " $kind " list || fail "no case of $kind"
  done
  run grep -vE '^[^ ]+ [^ ]+ (clean|clean-at-limit|by-winding|inside-out|not-oriented)( |$)' list
  assert_status 1
}

# Installs a wrong tm-clean, which runs the shell command $1; it reads the mesh and writes the result.
spoil() {
  mkdir -p spoiled/bin spoiled/bin-test
  ln -s "$tm_build"/bin/tm-* spoiled/bin/
  ln -s "$tm_build/bin-test/corpus_shapes" spoiled/bin-test/
  rm spoiled/bin/tm-clean
  printf '#!/usr/bin/env bash\n%s\n' "$1" >spoiled/bin/tm-clean
  chmod +x spoiled/bin/tm-clean
}

@test "corpus: a wrong result, a wrong refusal and a wrong message are failures" {
  local name=coplanar-same/boxes-20/seed-1/double-ascii refused=inside-out/ball-1/double
  "$tm_build/bin-test/corpus_shapes" | grep -q "^$refused " || refused=$refused-ascii
  "$tm_build/bin-test/corpus_shapes" | grep -q "^$name " || name=${name%-ascii}
  # The arguments end in INPUT -o OUTPUT.
  # shellcheck disable=SC2016
  spoil 'while [ $# -gt 3 ]; do shift; done; tm-convert "$1" -o "$3"'
  TM_BUILD=$PWD/spoiled run "$corpus/run" "$name" "$refused"
  assert_status 1
  [[ $output == *"FAILED $name: problem: "*"FAILED $refused: exit code 0"*"all "*" 2 "* ]] ||
    fail "$output"

  rm -r spoiled
  spoil 'echo "tm-clean: internal: no idea" >&2; exit 4'
  TM_BUILD=$PWD/spoiled run "$corpus/run" "$name" "$refused"
  assert_status 1
  [[ $output == *"FAILED $name: exit code 4"*"FAILED $refused: not refused in one line"* ]] ||
    fail "$output"
}
