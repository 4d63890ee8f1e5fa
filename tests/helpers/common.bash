# Loaded by every bats file: where the programs are, pipelines that cannot hide a failure, and
# inputs that may be absent.

bats_require_minimum_version 1.5.0

tm_root=$(cd "${BASH_SOURCE[0]%/*}/../.." && pwd)
tm_build=${TM_BUILD:-$tm_root/build}
PATH=$tm_build/bin:$PATH
export PATH
export LC_ALL=C
unset NO_COLOR

# pipe 'a | b': runs it under pipefail; stdout and stderr together are in $output.
pipe() {
  run bash -o pipefail -c "$1"
}

# pipe_apart 'a | b': the same, with stderr in $stderr and only stdout in $output.
pipe_apart() {
  run --separate-stderr bash -o pipefail -c "$1"
}

# triangles MESH: a line for each, from its first corner in the order of text on, sorted.
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

# needs_shared meshes/cgal/bones.off: sets $shared_file to that of the folder TM_DATA, or skips.
needs_shared() {
  shared_file=${TM_DATA:-$tm_root/../shared/data}/$1
  [ -e "$shared_file" ] || skip "TM_DATA names no folder with $1"
}

# needs_command convert: skips and says why where a command is not installed.
needs_command() {
  command -v "$1" >/dev/null || skip "$1 is not installed"
}

# winding_oracle INPUT OUTPUT [--level K] [--samples N] [--seed S]: whether OUTPUT is the boundary
# of what INPUT encloses at least K times. Prints `tested N wrong N undecided N`; status 1 if wrong.
winding_oracle() {
  "$tm_build/bin-test/winding_oracle" "$@"
}

# What went wrong, shown when a test fails.
fail() {
  echo "$*" >&2
  return 1
}

# assert_status 2: compares with the last run and shows its output on a difference.
assert_status() {
  [ "$status" -eq "$1" ] || fail "exit code $status instead of $1, output: $output ${stderr-}"
}

# one_line TEXT: the text is a single line that is not empty.
one_line() {
  [ -n "$1" ] && [ "$(printf '%s\n' "$1" | wc -l)" -eq 1 ] || fail "not one line: $1"
}

# The smallest closed mesh on stdout: a tetrahedron of edge sqrt(2) and volume 1/3, as ASCII PLY.
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
