# What the loops share: messages, options, the filters and their reports, frames, signals. Sourced by
# them. They set: name, long_options, quiet, verbose, progress, output, threads, format, frames, every,
# state (a folder), iteration; and job, the process group of the filters while they run.
# shellcheck shell=bash disable=SC2154,SC2034

say() { [ "$quiet" = yes ] || printf '%s: %s\n' "$name" "$*" >&2; }
detail() { [ "$verbose" = no ] || printf '%s: %s\n' "$name" "$*" >&2; }
fail() {
  clear_progress
  printf '%s: %s\n' "$name" "$2" >&2
  exit "$1"
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
  if [ "${progress:-no}" = terminal ]; then printf '\r\033[K' >&2; fi
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

on_signal() { # NAME CODE
  trap '' INT TERM
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
