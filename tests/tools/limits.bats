# --max-memory and --max-time, which every program has.

load ../helpers/common
load ../helpers/contract
load ../helpers/scene

setup_file() {
  make_contract_inputs "$BATS_FILE_TMPDIR"
}

setup() {
  cd "$BATS_TEST_TMPDIR"
}

memory_is_limited() {
  rm -rf folder && mkdir folder
  [ "$kind" = source ] || arguments+=("$mesh")
  [ "$program" != tm-shape ] || arguments+=(--faces 100000)
  code=0
  "$program" "${arguments[@]}" --max-memory 200K -o folder/out 2>stderr || code=$?
  [ "$code" -eq 6 ] || fail "exit code $code, $(cat stderr)"
  one_line "$(cat stderr)"
  grep -q 'out of memory: more is needed than the 200K that --max-memory allows' stderr
  [ -z "$(ls -A folder)" ]
  "$program" "${arguments[@]}" --max-memory 1.5GiB -o folder/out 2>/dev/null
}
@test "--max-memory ends every program with exit 6 and a line, and nothing is written" {
  for_each filter predicate picture source converter loop -- memory_is_limited
}

# The time ends while the program waits for the rest of its input, or for a reader of its output.
time_is_limited() {
  rm -rf folder && mkdir folder
  mkfifo folder/fifo
  code=0
  if [ "$kind" = source ]; then
    "$program" "${arguments[@]}" --max-time 0.5 -o folder/fifo 2>stderr 3>&- || code=$?
  else
    exec 9<>folder/fifo
    head -c 1000 "$binary" >&9
    "$program" "${arguments[@]}" --max-time 0.5 -o folder/out folder/fifo 2>stderr 3>&- || code=$?
    exec 9>&-
  fi
  [ "$code" -eq 4 ] || fail "exit code $code, $(cat stderr)"
  one_line "$(cat stderr)"
  grep -q "$program: stopped after 0.5 s, the limit of --max-time; " stderr
  [ "$(ls -A folder)" = fifo ] || fail "left behind: $(ls -A folder)"
}
@test "--max-time ends every program with exit 4 and a line, and nothing is written" {
  for_each filter predicate picture source converter loop -- time_is_limited
}

@test "invalid limits are exit 2" {
  for option in '--max-memory 5X' '--max-memory 0' '--max-memory -1' '--max-memory much' \
    '--max-time -1' '--max-time soon' '--max-time 1e10'; do
    run --separate-stderr tm-convert $option "$mesh"
    assert_status 2
    one_line "$stderr"
  done
}

@test "limits change no byte, and are not part of the provenance" {
  tm-convert --format ply "$mesh" >expected
  tm-convert --format ply --max-memory 1G --max-time 1000 "$mesh" | cmp - expected
}

@test "running out of memory anywhere is exit 6, and never a signal" {
  for size in 0.5M 1M 2M 3M 5M 8M 12M 20M; do
    for program in tm-clean tm-remesh tm-wrap tm-render "tm-morph --target $mesh --iterations 1"; do
      code=0
      $program --max-memory "$size" -o out --threads 1 "$crossing" 2>stderr || code=$?
      [ "$code" -eq 6 ] || [ "$code" -eq 0 ] || fail "$program with $size: exit code $code"
      rm -rf out out.tm-morph
    done
  done
}

@test "a loop that ran out of time continues, and its step ends with it" {
  step='if [ $TM_ITERATION -eq 2 ]; then echo $$ >pid; sleep 1000; fi; cat'
  run --separate-stderr tm-evolve --step "$step" --iterations 3 --max-time 1 -o out.ply "$mesh"
  assert_status 4
  [[ $stderr == *"stopped after 1 s, the limit of --max-time; --resume continues" ]] || fail "$stderr"
  [ ! -e out.ply ]
  sleep 0.2
  # A program without a waiting parent stays as a zombie.
  state=$(awk '/^State:/ { print $2 }' "/proc/$(cat pid)/status" 2>/dev/null) || true
  [[ -z $state || $state == Z ]] || fail "it is in state $state"
  [ -d out.ply.tm-evolve ]
}
