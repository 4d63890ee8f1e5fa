# Loaded by every bats file: sets the path of the programs, runs pipelines without hiding failures,
# and skips tests whose inputs are absent.

bats_require_minimum_version 1.5.0

tm_root=$(cd "${BASH_SOURCE[0]%/*}/../.." && pwd)
tm_build=${TM_BUILD:-$tm_root/build}
PATH=$tm_build/bin:$PATH
export PATH
export LC_ALL=C
unset NO_COLOR

# pipe 'a | b': runs a pipeline with pipefail; $output has stdout and stderr.
pipe() {
  run bash -o pipefail -c "$1"
}

# pipe_apart 'a | b': runs a pipeline with pipefail; $output has stdout, and $stderr has stderr.
pipe_apart() {
  run --separate-stderr bash -o pipefail -c "$1"
}

# triangles MESH: prints a sorted line per triangle. Each begins with the corner that is first as
# text, so that the output does not depend on the order of vertices and faces.
triangles() {
  tm-convert -q --no-provenance --format off "$1" | awk '
    !started { if ($1 ~ /^[0-9]+$/) { vertices = $1; started = 1 } next }
    row < vertices { point[row++] = $0; next }
    {
      a = point[$2]; b = point[$3]; c = point[$4]
      if (b < a && b < c) { t = a; a = b; b = c; c = t }
      else if (c < a && c < b) { t = c; c = b; b = a; a = t }
      print a "|" b "|" c
    }' | sort
}

# needs_shared meshes/cgal/bones.off: sets $shared_file to the path of this file in the folder
# TM_DATA; skips the test if there is none.
needs_shared() {
  shared_file=${TM_DATA:-$tm_root/../shared/data}/$1
  [ -e "$shared_file" ] || skip "TM_DATA names no folder with $1"
}

# needs_command convert: skips the test, with the reason, if a command is not installed.
needs_command() {
  command -v "$1" >/dev/null || skip "$1 is not installed"
}

# winding_oracle INPUT OUTPUT [--level K] [--samples N] [--seed S]: tests whether OUTPUT is the
# boundary of the region that INPUT encloses at least K times. Prints `tested N wrong N undecided N`;
# the status is 1 if a sample is wrong.
winding_oracle() {
  "$tm_build/bin-test/winding_oracle" "$@"
}

# fail TEXT: fails the test and shows the text.
fail() {
  echo "$*" >&2
  return 1
}

# assert_status 2: compares the exit code of the last run, and shows its output on a difference.
assert_status() {
  [ "$status" -eq "$1" ] || fail "exit code $status instead of $1, output: $output ${stderr-}"
}

# one_line TEXT: checks that the text is a single line that is not empty.
one_line() {
  [ -n "$1" ] && [ "$(printf '%s\n' "$1" | wc -l)" -eq 1 ] || fail "not one line: $1"
}

# Prints the smallest closed mesh as ASCII PLY: a tetrahedron of edge sqrt(2) and volume 1/3.
tetrahedron() {
  cat <<'PLY'
ply
format ascii 1.0
element vertex 4
property double x
property double y
property double z
element face 4
property list uchar int vertex_indices
end_header
0 0 0
1 1 0
1 0 1
0 1 1
3 0 1 2
3 0 3 1
3 0 2 3
3 1 3 2
PLY
}
