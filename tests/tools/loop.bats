# Rules of the contract that apply only to loops, in addition to contract.bats.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tm-shape torus --faces 1000 -o torus.ply
  tm-shape sphere --around torus.ply --faces 1000 -o sphere.ply
}

@test "tm-morph: every output has a name of its own, and folders of files are not made" {
  refused() { # CODE MESSAGE ARGUMENT...
    run --separate-stderr tm-morph sphere.ply --target torus.ply --iterations 1 "${@:3}"
    assert_status "$1"
    one_line "$stderr"
    [[ $stderr == "tm-morph: "*"$2"* ]] || fail "$stderr"
    [ ! -e x.ply ] && [ ! -e x.ply.tm-morph ] && [ ! -e nodir ]
  }
  refused 2 '--output and --report have the same file' -o x.ply --report x.ply
  refused 2 '--output and --report have the same file' -o x.ply --report ./x.ply
  refused 2 '--csv and --output have the same file' -o x.ply --csv x.ply
  refused 2 '--csv and --report have the same file' -o x.ply --csv log --report log
  refused 2 '--report: name a file' -o x.ply --report -
  refused 2 'either --quiet or --verbose' -o x.ply -q -v
  refused 2 'either --progress or --no-progress' -o x.ply --progress --no-progress
  for place in -o '-o x.ply --report' '-o x.ply --csv'; do
    refused 5 "cannot write 'nodir/y': No such file" $place nodir/y
    refused 5 "cannot write '.': Is a directory" $place .
  done
  run --separate-stderr tm-morph sphere.ply --target - -o x.ply <torus.ply
  assert_status 2
  [[ $stderr == *"--target: name a file"* ]]
}

@test "tm-morph: unwritable output is exit 5, unwritable messages are ignored" {
  for option in --help --version; do
    run --separate-stderr bash -c "tm-morph $option >/dev/full"
    assert_status 5
    one_line "$stderr"
    run --separate-stderr bash -c "tm-morph $option >&-"
    assert_status 5
  done
  tm-morph sphere.ply --target torus.ply --iterations 1 -o one.ply 2>messages
  # The message has the singular for a single iteration.
  grep -q 'after 1 iteration: ' messages
  bash -c 'tm-morph sphere.ply --target torus.ply --iterations 1 -o closed.ply >&- 2>&- <&-'
  bash -c 'tm-morph sphere.ply --target torus.ply --iterations 1 -o full.ply 2>/dev/full'
  bash -c 'tm-morph sphere.ply --target torus.ply --iterations 1 -o lines.ply --progress 2>/dev/full'
  cmp one.ply closed.ply
  cmp one.ply full.ply
  cmp one.ply lines.ply
}

@test "tm-morph: a hangup is an interruption, with exit code 129 and the command that continues" {
  tm-morph sphere.ply --target torus.ply --alpha 0.01 --smooth tangential -o out.ply --csv log.csv 2>messages 3>&- &
  while [ ! -e log.csv ] || [ "$(wc -l <log.csv)" -lt 4 ]; do sleep 0.01; done
  kill -HUP $!
  wait $! || code=$?
  [ "$code" -eq 129 ]
  grep -q 'interrupted by SIGHUP; --resume continues' messages
}

@test "tm-reconstruct: outputs share no file, folders of files are not made, and stdin is nothing to read twice" {
  refused() { # CODE MESSAGE ARGUMENT...
    run --separate-stderr tm-reconstruct --cameras par.txt --images images --silhouettes masks "${@:3}"
    assert_status "$1"
    one_line "$stderr"
    [[ $stderr == "tm-reconstruct: "*"$2"* ]] || fail "$stderr"
    [ ! -e x.ply ] && [ ! -e x.ply.tm-reconstruct ] && [ ! -e nodir ]
  }
  refused 2 '--output and --report have the same file' -o x.ply --report x.ply
  refused 2 '--csv and --report have the same file' -o x.ply --report log --csv log
  refused 2 'either --quiet or --verbose' -o x.ply -q -v
  refused 5 "cannot write 'nodir/x.ply'" -o nodir/x.ply
  for place in cameras images silhouettes start sequence; do
    refused 2 "--$place: name a file" -o x.ply --$place -
  done
  run --separate-stderr bash -c 'tm-reconstruct --help >/dev/full'
  assert_status 5
}

# A run whose step waits until the test lets it continue.
start_waiting_run() { # ARGUMENT...
  rm -f began go
  tm-evolve -q --no-provenance --step 'touch began; while [ ! -e go ]; do sleep 0.02; done; cat' --iterations 1 \
    "$@" sphere.ply 3>&- &
  while [ ! -e began ]; do sleep 0.02; done
}

@test "a second run with the same output is refused, unless the first was killed" {
  start_waiting_run -o out.ply
  for options in '-o out.ply' '-o ./out.ply --resume' '-o out.ply --restart'; do
    run --separate-stderr tm-evolve --step cat --iterations 1 $options sphere.ply
    assert_status 5
    one_line "$stderr"
    [[ $stderr == *"another run is writing the same output"* ]] || fail "$stderr"
  done
  tm-evolve -q --no-provenance --step cat --iterations 1 -o other.ply sphere.ply
  touch go
  wait $!
  cmp out.ply other.ply

  start_waiting_run -o out.ply --restart
  kill -KILL $!
  wait $! || true
  touch go
  tm-evolve -q --no-provenance --step cat --iterations 1 -o out.ply --restart sphere.ply
  cmp out.ply other.ply
}

@test "tm-morph and tm-reconstruct refuse a second run with the same output" {
  mkfifo fifo
  tm-morph fifo --target torus.ply --iterations 1 -q -o out.ply 3>&- 9>&- &
  while [ ! -e out.ply.tm-morph ]; do sleep 0.02; done
  run --separate-stderr tm-morph sphere.ply --target torus.ply --iterations 1 -o out.ply
  assert_status 5
  cat sphere.ply >fifo
  wait $!
  tm-morph sphere.ply --target torus.ply --iterations 1 -q -o alone.ply
  cmp out.ply alone.ply

  mkdir photos
  tm-photograph -q --ring 12 --size 80x60 --write-images photos -o photos.txt torus.ply
  reconstruct() {
    tm-reconstruct -q --images photos --coarsest 1 --passes 1 --iterations 1 --robust 0 \
      --start sphere.ply -o seen.ply "$@"
  }
  reconstruct --cameras fifo 3>&- &
  while [ ! -e seen.ply.tm-reconstruct ]; do sleep 0.02; done
  run --separate-stderr reconstruct --cameras photos.txt
  assert_status 5
  one_line "$stderr"
  cat photos.txt >fifo
  wait $! || true
}

@test "a run that fails or is interrupted before its first iteration leaves no state" {
  mkdir folder
  run --separate-stderr tm-evolve --step cat --iterations 1 -o folder/out.ply /dev/null
  assert_status 3
  [ -z "$(ls -A folder)" ]
  mkfifo fifo
  tm-evolve --step cat --iterations 1 -o folder/out.ply fifo 3>&- &
  while [ ! -e folder/out.ply.tm-evolve ]; do sleep 0.02; done
  kill -TERM $!
  wait $! || code=$?
  [ "$code" -eq 143 ]
  [ -z "$(ls -A folder)" ]
}

@test "loops write to descriptors and pipes too, without a state" {
  evolve() { tm-evolve -q --step cat --iterations 3 "$@" sphere.ply; }
  evolve -o expected --csv log
  cut -d, -f1-5 log >rows
  [ "$(wc -l <rows)" -eq 4 ]
  rm -r expected.tm-evolve
  evolve -o /dev/stdout | cmp - expected
  echo before >appended
  evolve -o /dev/stdout >>appended
  cmp <(echo before | cat - expected) appended
  evolve -o >(cat >piped; touch piped-is-done) --report >(cat >report; touch report-is-done)
  while [ ! -e piped-is-done ] || [ ! -e report-is-done ]; do sleep 0.02; done
  cmp piped expected
  [ "$(jq -r .tool report)" = tm-evolve ]
  evolve -o out --csv /dev/stderr 2>messages
  cut -d, -f1-5 messages | cmp - rows
  evolve -o /dev/null --csv /dev/fd/7 7>messages
  cut -d, -f1-5 messages | cmp - rows
  evolve -o out --csv >(cut -d, -f1-5 >piped-rows; touch rows-are-done) --restart
  while [ ! -e rows-are-done ]; do sleep 0.02; done
  cmp piped-rows rows
  mkfifo fifo
  evolve -o out --csv fifo 3>&- &
  cut -d, -f1-5 fifo | cmp - rows
  wait $!
  [ ! -e /dev/stdout.tm-evolve ] && [ ! -e /dev/null.tm-evolve ]
  run --separate-stderr evolve -o /dev/stdout --resume
  assert_status 2
  one_line "$stderr"
}

@test "when the report fails no output appears, named or on standard output" {
  evolve() { tm-evolve -q --step cat --iterations 1 "$@" sphere.ply; }
  run --separate-stderr evolve -o out.ply --report /dev/full
  assert_status 5
  one_line "$stderr"
  [ ! -e out.ply ]
  run --separate-stderr evolve --report /dev/full
  assert_status 5
  [ -z "$output" ]
  run --separate-stderr evolve -o out.ply --csv /dev/full --restart
  assert_status 5
  one_line "$stderr"
  [ ! -e out.ply ]
}
