# The state of a run of a loop: a folder beside the output, from which --resume continues. Sourced by
# the loops, after loop.bash. Each line of its file `state` is complete once it ends, and describes the
# mesh after a round: mesh-0.ply after even ones, mesh-1.ply after odd ones. A loop's own file sets
# csv_header and round, what it calls one; and has describe_settings, which sets settings, start_state,
# write_state, resume_state, judge, and close_state, which removes the folder.
# shellcheck shell=bash disable=SC2154,SC2034

begin_run() {
  settle_progress
  find_filters "${filters[@]}"
  begun=$EPOCHREALTIME state='' job=''
  trap on_exit EXIT
  trap_signals
}

# Of a run that writes to stdout nothing can be continued.
on_exit() {
  if [ "$output" = - ] && [ -n "$state" ] && [ -d "$state" ]; then close_state; fi
}

open_state() {
  if [ "$output" = - ]; then
    state=$(mktemp -d "${TMPDIR:-/tmp}/$name.XXXXXX")
  else
    state=$output.$name
    mkdir -p "$state" || fail 5 "cannot make the folder '$state'"
  fi
  describe_settings
  if [ "$resume" = yes ] && [ -s "$state/state" ]; then
    check_settings
    keep_complete_lines "$state/state"
    resume_state
    resume_csv
    detail "continuing after $round $iteration"
  else
    rm -f "$state"/mesh-*.ply "$state"/state
    start_state
    printf '%s\n' "$settings" >"$state/settings"
    write_state
    start_csv
    keep_frame
  fi
  detail "$settings"
  detail "state in $state"
}

check_settings() {
  [ "$(cat "$state/settings")" = "$settings" ] ||
    fail 2 "'$state' is of a run with other settings ($(cat "$state/settings")); leave out --resume"
}

# What follows the last end of a line was being written.
keep_complete_lines() { # FILE
  sed -n '/ end$/p' "$1" >"$1.new"
  mv "$1.new" "$1"
}

append_state() { # LINE
  { printf '%s end\n' "$1" >>"$state/state"; } 2>/dev/null || fail 5 "cannot write to '$state'"
}

# A program before the first round: ends the loop with its message where it fails.
first_step() { # COMMAND...
  "$@" || {
    local code=$?
    close_state
    exit "$code"
  }
}

# A filter has said why. Where not even one round was completed, there is nothing to keep.
stop_after_failure() { # CODE
  local last=$((iteration - 1))
  if [ "$last" -eq 0 ]; then
    close_state
    exit "$1"
  fi
  local holds="'$output' is not written"
  if [ "$output" != - ] && write_mesh "$state/mesh-$((last % 2)).ply" tm-convert; then
    holds="'$output' holds the mesh of $round $last, and --resume continues from there"
  fi
  fail "$1" "stopped in $round $iteration; $holds"
}

# One round, in a process group of its own: the filters, then judge, whose line for the CSV file and
# whose progress are shown, and whose verdict is set. Returns the code of a filter that failed.
run_round() {
  local code=0 csv_line progress_line
  { : >"$state/verdict"; } 2>/dev/null || fail 5 "cannot write to '$state'"
  run_group filter_and_judge || code=$?
  if [ "$code" -ne 0 ]; then
    [ ! -s "$state/verdict" ] || fail 5 "cannot write to '$state'"
    return "$code"
  fi
  { read -r _ && read -r csv_line && read -r progress_line && read -r verdict; } <"$state/verdict"
  append_csv "$csv_line"
  show_progress "$progress_line"
}

# An empty line says that no filter failed. Judge takes the place of this process: another one would
# cost as much as a tenth of a filter.
filter_and_judge() {
  local started=$EPOCHREALTIME
  run_filters || return
  seconds_since "$started"
  { echo >"$state/verdict"; } 2>/dev/null || fail 5 "cannot write to '$state'"
  judge >>"$state/verdict"
}

start_csv() {
  if [ -z "$csv" ]; then return; fi
  { printf '%s\n' "$csv_header" >"$csv"; } 2>/dev/null || fail 5 "cannot write '$csv'"
}

append_csv() { # LINE
  if [ -z "$csv" ]; then return; fi
  { printf '%s\n' "$1" >>"$csv"; } 2>/dev/null || fail 5 "cannot write '$csv'"
}

# Without lines of a round that was not finished.
resume_csv() {
  if [ -n "$csv" ] && [ -e "$csv" ]; then
    awk -F, -v last="$iteration" 'NR == 1 || $1 <= last' "$csv" >"$csv.new"
    mv "$csv.new" "$csv"
  else
    start_csv
  fi
}
