# Runs the checks of the command-line contract for every program.

load ../helpers/common
load ../helpers/contract
load ../helpers/scene

setup_file() {
  make_contract_inputs "$BATS_FILE_TMPDIR"
}

setup() {
  cd "$BATS_TEST_TMPDIR"
}

@test "the table names every program" {
  diff <(contract_programs | cut -d'|' -f1) \
    <(cd "$tm_root/tools/programs" && printf '%s\n' tm.cpp tm-*.cpp | sed 's/\.cpp$//')
}

help_is_golden() {
  diff "$tm_root/tests/tools/golden/$program.help" <("$program" --help 2>stderr) ||
    fail "$program --help has changed; scripts/update-golden accepts the new text"
  "$program" --help >/dev/null
  [ ! -s stderr ]
}
@test "1: --help prints the golden text" {
  for_each filter predicate picture source converter loop lister reporter viewer -- help_is_golden
}

version_is_printed() {
  run --separate-stderr "$program" --version
  assert_status 0
  [ -z "$stderr" ]
  [[ $output =~ ^"$program "[0-9]+\.[0-9]+\.[0-9]+(\ \(commit\ [0-9a-f]+\))?$ ]]
}
@test "2: --version prints name and version" {
  for_each filter predicate picture source converter loop lister reporter viewer -- version_is_printed
}

unknown_option_is_refused() {
  run --separate-stderr "$program" "${arguments[@]}" --versoin "$mesh"
  assert_status 2
  one_line "$stderr"
  [ -z "$output" ]
  [[ $stderr == "$program: "*"'--versoin'"*"'--version'"* ]]
}
@test "3: an unknown option is exit 2 and one line that names the nearest" {
  for_each filter predicate picture source converter loop lister reporter viewer -- unknown_option_is_refused
}

stdin_equals_file() {
  "$program" "${arguments[@]}" "$mesh" >named
  "$program" "${arguments[@]}" <"$mesh" >piped
  cat "$mesh" | "$program" "${arguments[@]}" - >dash
  [ -s named ]
  cmp named piped
  cmp named dash
}
@test "4: stdin equals the named file, byte for byte" {
  for_each filter predicate picture converter loop -- stdin_equals_file
}

output_option_equals_stdout() {
  [[ $kind == @(source|lister|reporter) ]] || arguments+=("$mesh")
  "$program" "${arguments[@]}" >expected
  "$program" "${arguments[@]}" -o target >stdout
  [ ! -s stdout ]
  cmp expected target
}
@test "5: -o FILE equals stdout" {
  for_each filter predicate picture source converter loop lister reporter viewer -- output_option_equals_stdout
}

empty_input_is_refused() {
  run --separate-stderr "$program" "${arguments[@]}" -o target </dev/null
  assert_status 3
  one_line "$stderr"
  [ -z "$output" ]
  [ ! -e target ]
  [[ $stderr == "$program: "*empty* ]]
}
@test "6: empty input is exit 3 and says so" {
  for_each filter predicate picture converter loop viewer -- empty_input_is_refused
}

truncated_input_is_refused() {
  head -c -7 "$binary" >truncated.ply
  run --separate-stderr "$program" "${arguments[@]}" -o target truncated.ply
  assert_status 3
  one_line "$stderr"
  [ -z "$output" ]
  [ ! -e target ]
  [[ $stderr == "$program: "* ]]
}
@test "7: truncated binary PLY is exit 3, and nothing is written" {
  for_each filter predicate picture converter loop viewer -- truncated_input_is_refused
}

closed_pipe_is_silent() {
  [[ $kind == @(source|lister|reporter) ]] || arguments+=("$binary")
  # A pipe without a reader. Opening it for reading, too, keeps the second opening from waiting.
  rm -f pipe
  mkfifo pipe
  exec 9<>pipe 7>pipe 9>&-
  code=0
  "$program" "${arguments[@]}" >&7 2>stderr || code=$?
  [ "$code $(cat stderr)" = "141 " ] || fail "exit code $code, $(cat stderr)"
}
@test "8: a closed output pipe ends the program silently" {
  for_each filter predicate picture source converter loop lister reporter viewer -- closed_pipe_is_silent
}

failed_output_is_reported() {
  [[ $kind == @(source|lister|reporter) ]] || arguments+=("$binary")
  code=0
  "$program" "${arguments[@]}" 2>stderr || code=$?
  [ "$code" -eq 5 ] || fail "exit code $code, $(cat stderr)"
  one_line "$(cat stderr)"
}
full_disk_is_reported() { failed_output_is_reported >/dev/full; }
closed_stdout_is_reported() { failed_output_is_reported >&-; }
@test "9: a full disk and a closed stdout are exit 5 and told" {
  for_each filter predicate picture source converter loop lister reporter viewer -- full_disk_is_reported
  for_each filter predicate picture source converter loop lister reporter viewer -- closed_stdout_is_reported
}

header_survives() {
  "$program" "${arguments[@]}" "$mesh" >output.ply
  for line in "format ascii 1.0" "comment made by hand" "property float x" \
    "property float quality" "property int label"; do
    sed '/^end_header/q' output.ply | grep -qx "$line" || fail "lost: $line"
  done
}
@test "10: an unknown property, a comment and the scalar type survive" {
  for_each filter -- header_survives
}

threads_make_no_difference() {
  [[ $kind == @(source|lister|reporter) ]] || arguments+=("$crossing")
  for threads in 1 2 4 8; do
    # Exit code 1 of a predicate is also accepted.
    "$program" "${arguments[@]}" --threads "$threads" >"$threads" || [ $? -eq 1 ]
  done
  [ -s 1 ]
  cmp 1 2
  cmp 1 4
  cmp 1 8
}
@test "11: 1, 2, 4 and 8 threads give the same bytes" {
  for_each filter predicate picture source converter loop reporter viewer -- threads_make_no_difference
}

# The signal comes while the program waits for the rest of its input, or for a reader of its output.
signal_ends_it() {
  rm -rf folder && mkdir folder
  mkfifo folder/fifo
  if [ "$kind" = source ]; then
    "$program" "${arguments[@]}" -o folder/fifo 3>&- 8>&- &
  else
    "$program" "${arguments[@]}" -o folder/target <folder/fifo 3>&- 8>&- &
    exec 9>folder/fifo
    head -c 1000 "$binary" >&9
  fi
  pid=$!
  wait_until_interruptible "$pid"
  before=$SECONDS
  kill -s "$1" "$pid"
  code=0
  wait "$pid" || code=$?
  [ "$code" -eq "$2" ] || fail "exit code $code"
  # The contract promises one second; a loaded machine may take longer.
  [ $((SECONDS - before)) -le 5 ] || fail "took $((SECONDS - before)) seconds"
  # Only the state of a loop may be left.
  [ "$(ls -A -I 'fifo.tm-*' folder)" = fifo ] || fail "left behind: $(ls -A folder)"
}
interrupt_ends_it() { signal_ends_it INT 130; }
termination_ends_it() { signal_ends_it TERM 143; }
@test "12: SIGINT and SIGTERM end it at once, and leave no partial file" {
  for_each filter predicate picture source converter loop viewer -- interrupt_ends_it
  for_each filter predicate picture source converter loop viewer -- termination_ends_it
}
