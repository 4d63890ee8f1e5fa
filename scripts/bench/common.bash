# Functions of the benchmarks: paths of programs, input meshes and measurement of time.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${TM_BUILD:-$root/build}
export LC_ALL=C
export PATH=$build/bin:$build/bin-bench:$PATH

# shellcheck disable=SC2034 # used by the scripts that load this
workloads=(two-spheres folded tangle many-spheres boxes pinch)

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# workload KIND FACES: generates a shape of this kind by tm-shape, and sets $mesh to its file.
workload() {
  mesh=$scratch/$1.ply
  local options=()
  if [ "$1" = two-spheres ]; then options=(--gap=-0.3); fi
  tm-shape "$1" "${options[@]}" --faces "$2" -o "$mesh"
}

# best_of COUNT COMMAND...: runs a command COUNT times and sets $seconds to the least CPU time. Exit
# code 1 is allowed. The output is in $scratch/stdout.
best_of() {
  local count=$1 run status spent
  shift
  seconds=
  for ((run = 0; run < count; ++run)); do
    status=0
    TIMEFORMAT='%U %S'
    { time "$@" >"$scratch/stdout" 2>"$scratch/stderr" || status=$?; } 2>"$scratch/times"
    if [ "$status" -gt 1 ]; then
      cat "$scratch/stderr" >&2
      return "$status"
    fi
    spent=$(awk '{ print $1 + $2 }' "$scratch/times")
    seconds=$(awk -v a="${seconds:-$spent}" -v b="$spent" 'BEGIN { print a < b ? a : b }')
  done
}

# value KEY FILE: prints the value of a key in a report.
value() {
  awk -v key="$1:" '$1 == key { print $2 }' "$2"
}

# faces FILE: prints the number of faces in a PLY header.
faces() {
  sed -n 's/^element face \([0-9]*\).*/\1/p; /^end_header/q' "$1"
}
