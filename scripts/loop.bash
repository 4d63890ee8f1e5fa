# What the loops share: messages, progress, the filters and their reports, frames, signals. Sourced by
# them, before loop-options.bash and loop-state.bash. They set: name, quiet, verbose, progress, output,
# threads, format, frames, every, state (a folder), iteration; and job, the process group of the filters
# while they run.
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

# A line of progress, which nobody needs to be able to read.
show_progress() { # TEXT
  case $progress in
    terminal) printf '\r\033[K%s: %s' "$name" "$1" >&2 2>/dev/null || true ;;
    yes) message "$1" ;;
  esac
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

# What runs filters, in a process group of its own, so that a signal can end all at once.
run_group() { # COMMAND...
  set -m
  "$@" &
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
  }
  function own_seconds(filter) {
    return value[filter ".timings.total"] - value[filter ".timings.read"]
  }'

# Awk that writes the report of a loop.
# shellcheck disable=SC2016
readonly write_entries='
  function entry(key, text) { printf "    \"%s\": %s,\n", key, text >report }
  function begin_report() {
    printf "{\n  \"tool\": \"%s\",\n  \"version\": \"%s\",\n", name, value["final.version"] >report
    printf "  \"output\": {\n    \"vertices\": %d,\n    \"faces\": %d\n  },\n",
      value["final.output.vertices"], value["final.output.faces"] >report
    printf "  \"result\": {\n" >report
  }
  function end_report(mean_edge) {
    printf "    \"mean_edge\": %s\n  },\n", mean_edge >report
    printf "  \"timings\": {\n    \"total\": %s\n  }\n}\n", seconds >report
  }'
