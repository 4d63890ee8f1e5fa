#!/usr/bin/env bats
# Files from other sources: every program reads each of them, or refuses it with one clear line.
load ../helpers/common

# takes_or_refuses PROGRAM ARGUMENT...: expects an exit code of the contract within a minute. If the program
# fails, the last line of stderr says why; lines before it are notes on omitted data.
takes_or_refuses() {
  local code=0 why said
  timeout 60 "$@" > "$BATS_TEST_TMPDIR/stdout" 2> "$BATS_TEST_TMPDIR/stderr" < /dev/null || code=$?
  [ "$code" -le 4 ] && [ "$code" -ne 2 ] || fail "exit code $code: $* $(cat "$BATS_TEST_TMPDIR/stderr")"
  said=$(cat "$BATS_TEST_TMPDIR/stderr")
  # Messages may contain cgal as the name of a folder of these files.
  ! grep -Eiq 'internal|assert|exception|cgal|std::' <<<"${said//'/cgal/'/}" ||
    fail "$* $said"
  [ "$code" -ge 3 ] || return 0
  why=$(grep -Ev "^$1: (ply|off|obj|stl): " "$BATS_TEST_TMPDIR/stderr")
  one_line "$why" && [ "${#why}" -gt 30 ] || fail "$* $(cat "$BATS_TEST_TMPDIR/stderr")"
}

# by_every_program FILE
by_every_program() {
  local program
  for program in cat clean convert info remesh stitch intersect checkmanifold; do
    takes_or_refuses "tm-$program" "$1"
  done
  takes_or_refuses tm-clean --float --outermost --source-face "$1"
  takes_or_refuses tm-checkmanifold --intersections "$1"
  takes_or_refuses tm-compare "$1" --reference "$1"
  takes_or_refuses tm-displace --normal-speed 0.001 "$1"
  takes_or_refuses tm-intersect --refine "$1"
  takes_or_refuses tm-morph-step --target "$1" "$1"
  takes_or_refuses tm-render "$1" -o "$BATS_TEST_TMPDIR/picture.png"
  takes_or_refuses tm-shape sphere --around "$1"
  takes_or_refuses tm-stitch --orient "$1"
}

@test "every small real file is accepted or refused by every program" {
  needs_shared meshes
  find "$shared_file" -type f -size -12k | sort > "$BATS_TEST_TMPDIR/files"
  [ "$(wc -l < "$BATS_TEST_TMPDIR/files")" -gt 30 ]
  while read -r file; do by_every_program "$file"; done < "$BATS_TEST_TMPDIR/files"
}

@test "unusual but valid files are read completely" {
  needs_shared meshes/trimesh/whitespace.off
  cd "${shared_file%/*}"
  for file in whitespace.off comments.off negative_indices.obj cube_compressed.obj; do
    run tm-info --get faces -q "$file"
    assert_status 0
    [ "$output" = 12 ] || fail "$file has $output faces"
    tm-checkmanifold -q --closed "$file"
  done
  [ "$(tm-info -q --get faces fuze_ascii.ply)" = 1000 ]
  [ "$(tm-info -q --get faces empty.ply)" = 0 ]
  pipe_apart 'tm-info --get faces notenoughindices.obj'
  [ "$output" = 1 ]
  [[ $stderr == *"1 face with fewer than three corners dropped"* ]]
}

@test "a file with an invalid number is refused with the line by --strict" {
  needs_shared meshes/trimesh/nancolor.obj
  run --separate-stderr tm-info "$shared_file"
  assert_status 0
  run --separate-stderr tm-info --strict "$shared_file"
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"vertex 7"*"'nan'"*"nancolor.obj line 7"* ]]
}
