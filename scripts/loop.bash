# What the loops share: messages, options, the filters and their reports, frames, signals. Sourced by
# them. They set: name, long_options, quiet, verbose, progress, output, threads, format, frames, every,
# state (a folder), iteration; and job, the process group of the filters while they run.
# shellcheck shell=bash disable=SC2154,SC2034

# What is closed must not become one of our files. Reading and writing the data go on failing.
occupy_standard_descriptors() {
  : >&2 || exec 2>/dev/null
  { : <&0; } 2>/dev/null || exec 0>/dev/null
  { : >&1; } 2>/dev/null || exec 1</dev/null
}

# A message that nobody can read is no failure of the loop.
message() { printf '%s: %s\n' "$name" "$*" >&2 2>/dev/null || true; }
say() { [ "$quiet" = yes ] || message "$@"; }
detail() { [ "$verbose" = no ] || message "$@"; }
fail() {
  clear_progress
  message "$2"
  exit "$1"
}

# Ends the loop with what the command says on stdout.
print_and_exit() { # COMMAND...
  local text
  text=$("$@") || exit $?
  printf '%s\n' "$text" 2>/dev/null || fail 5 'cannot write standard output'
  exit 0
}

# The known option with the smallest edit distance to $1.
nearest_option() {
  awk -v word="$1" -v options="$long_options" '
    function distance(a, b,   i, j, row, corner, above) {
      for (j = 0; j <= length(b); ++j) row[j] = j
      for (i = 1; i <= length(a); ++i) {
        corner = row[0]; row[0] = i
        for (j = 1; j <= length(b); ++j) {
          above = row[j]
          corner += substr(a, i, 1) != substr(b, j, 1)
          if (row[j] + 1 < corner) corner = row[j] + 1
          if (row[j - 1] + 1 < corner) corner = row[j - 1] + 1
          row[j] = corner; corner = above
        }
      }
      return row[length(b)]
    }
    BEGIN {
      least = 1e9
      for (n = split(options, known, /[ \n]+/); n > 0; --n)
        if ((d = distance(word, known[n])) <= least) { least = d; best = known[n] }
      print best
    }'
}

need_integer() { # OPTION VALUE MINIMUM
  if ! [[ $2 =~ ^[0-9]{1,9}$ ]] || [ "$2" -lt "$3" ]; then
    fail 2 "$1: '$2' is not a whole number of at least $3"
  fi
}

# --progress or --no-progress, and --quiet or --verbose, as the filters have them.
set_progress() { # yes|no
  [ "${progress:-$1}" = "$1" ] || fail 2 'give either --progress or --no-progress, not both'
  progress=$1
}
check_verbosity() {
  [ "$quiet$verbose" != yesyes ] || fail 2 'give either --quiet or --verbose, not both'
}

# Before any work is done: each output has a name of its own, and a place to be written to.
check_outputs() { # OPTION FILE...
  local -A places=()
  while [ $# -gt 0 ]; do
    if [ -n "$2" ] && [ "$2" != - ]; then
      local place
      place=$(readlink -m -- "$2")
      if [ -n "${places[$place]-}" ] && { [ -f "$place" ] || [ ! -e "$place" ]; }; then
        fail 2 "give either ${places[$place]} or $1 its own file, not both"
      fi
      places[$place]=$1
      check_writable "$2" "$place"
    elif [ "$2" = - ] && [ "$1" != --output ]; then
      fail 2 "$1: name a file, as standard output is the mesh's"
    elif [ "$1" = --output ] && [ -z "$2" ]; then
      fail 5 'cannot write a file without a name'
    fi
    shift 2
  done
}

# As the filters do: folders of files are not made, and what is not a regular file is written directly.
check_writable() { # NAME PLACE
  local folder=${2%/*}
  if [ -d "$2" ] || [[ $1 == */ ]]; then
    fail 5 "cannot write '$1': Is a directory"
  elif [ -e "$2" ] && [ ! -f "$2" ]; then
    return
  elif [ ! -d "${folder:-/}" ]; then
    fail 5 "cannot write '$1': No such file or directory"
  elif [ ! -w "${folder:-/}" ] || [ ! -x "${folder:-/}" ]; then
    fail 5 "cannot write '$1': Permission denied"
  fi
}

# The filters: beside the loop, in the project's build, or on PATH.
find_filters() { # FILTER...
  local folder filter
  for folder in "$here" "${TM_BUILD:-$here/../build}/bin"; do
    if [ -x "$folder/$1" ]; then
      PATH=$folder:$PATH
      break
    fi
  done
  for filter; do
    command -v "$filter" >/dev/null ||
      fail 2 "cannot find $filter: build the project, or put it on PATH"
  done
}

clear_progress() {
  if [ "${progress:-no}" = terminal ]; then printf '\r\033[K' >&2 2>/dev/null || true; fi
}

# Whether and how to show progress: no, yes (lines) or terminal.
settle_progress() {
  if [ -z "$progress" ]; then progress=no && [ ! -t 2 ] || progress=terminal; fi
  if [ "$progress" = yes ] && [ -t 2 ]; then progress=terminal; fi
  if [ "$quiet" = yes ]; then progress=no; fi
}

seconds_since() {
  local now=$EPOCHREALTIME
  local microseconds=$((${now/[.,]/} - ${1/[.,]/}))
  printf -v seconds '%d.%06d' $((microseconds / 1000000)) $((microseconds % 1000000))
}

keep_frame() {
  if [ -z "$frames" ] || [ $((iteration % every)) -ne 0 ]; then return; fi
  local frame mesh=$state/mesh-$((iteration % 2)).ply
  printf -v frame '%s/frame-%05d.ply' "$frames" "$iteration"
  [ -d "$frames" ] || mkdir -p "$frames" || fail 5 "cannot make the folder '$frames'"
  # The mesh is replaced and never rewritten, so a second name keeps it, where the file system can.
  ln -f "$mesh" "$frame" 2>/dev/null && return
  cp "$mesh" "$frame.new" || fail 5 "cannot write '$frame.new'"
  mv "$frame.new" "$frame"
}

# Of a pipeline that failed: the messages of the filter to blame, and its code.
blame() { # FILTER CODE...
  while [ $# -gt 0 ]; do
    # 141: its reader went away, and is the one to blame.
    if [ "$2" -ne 0 ] && [ "$2" -ne 141 ]; then
      cat "$state/$1.messages" >&2
      return "$2"
    fi
    shift 2
  done
}

# The filters in a process group of their own, so that a signal can end all at once.
run_group() {
  set -m
  run_filters &
  job=$!
  set +m
  local code=0
  wait "$job" || code=$?
  job=''
  return "$code"
}

trap_signals() {
  trap 'on_signal SIGINT 130' INT
  trap 'on_signal SIGTERM 143' TERM
  trap 'on_signal SIGHUP 129' HUP
}

on_signal() { # NAME CODE
  trap '' INT TERM HUP
  [ -z "$job" ] || kill -TERM -- "-$job" 2>/dev/null || true
  wait 2>/dev/null || true
  fail "$2" "interrupted by $1$([ "$output" = - ] || echo "; --resume continues")"
}

write_mesh() { # FILE PROGRAM...
  local file=$1
  shift
  local as=()
  if [ -n "$format" ]; then as=(--format "$format"); fi
  "$@" -q --threads "$threads" "${as[@]}" -o "$output" "$file"
}

# Awk: "1 face", "2 faces".
# shellcheck disable=SC2016
readonly counted='
  function counted(count, noun) {
    return sprintf("%d %s", count, noun) (count == 1 ? "" : noun ~ /s$/ ? "es" : "s")
  }'

# Awk that flattens the reports of our programs, one key per line, to value["FILE.SECTION.KEY"].
# shellcheck disable=SC2016
readonly read_reports='
  FNR == 1 { file = FILENAME; sub(/.*\//, "", file); sub(/\.json$/, "", file); section = "" }
  FILENAME ~ /\.json$/ && /^ *"/ {
    key = $0; sub(/^ *"/, "", key); sub(/".*/, "", key)
    text = $0; sub(/^[^:]*: */, "", text); sub(/,$/, "", text); gsub(/"/, "", text)
    if (text == "{") section = key
    else value[file "." (/^    /? section "." : "") key] = text
  }'
