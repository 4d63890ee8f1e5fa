# What the loops keep of the contract of all programs beyond contract.bats.

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
  refused 2 'either --output or --report' -o x.ply --report x.ply
  refused 2 'either --output or --report' -o x.ply --report ./x.ply
  refused 2 'either --output or --csv' -o x.ply --csv x.ply
  refused 2 'either --report or --csv' -o x.ply --csv log --report log
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

@test "tm-morph: text that nobody can read is exit 5, messages that nobody can read are none" {
  for option in --help --version; do
    run --separate-stderr bash -c "tm-morph $option >/dev/full"
    assert_status 5
    one_line "$stderr"
    run --separate-stderr bash -c "tm-morph $option >&-"
    assert_status 5
  done
  tm-morph sphere.ply --target torus.ply --iterations 1 -o one.ply 2>messages
  # A word for one.
  grep -q 'after 1 iteration: ' messages
  bash -c 'tm-morph sphere.ply --target torus.ply --iterations 1 -o closed.ply >&- 2>&- <&-'
  bash -c 'tm-morph sphere.ply --target torus.ply --iterations 1 -o full.ply 2>/dev/full'
  bash -c 'tm-morph sphere.ply --target torus.ply --iterations 1 -o lines.ply --progress 2>/dev/full'
  cmp one.ply closed.ply
  cmp one.ply full.ply
  cmp one.ply lines.ply
}

@test "tm-morph: a hangup is told as an interruption, with 129 and what continues the run" {
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
  refused 2 'either --output or --report' -o x.ply --report x.ply
  refused 2 'either --report or --csv' -o x.ply --report log --csv log
  refused 2 'either --quiet or --verbose' -o x.ply -q -v
  refused 5 "cannot write 'nodir/x.ply'" -o nodir/x.ply
  for place in cameras images silhouettes start sequence; do
    refused 2 "--$place: name a file" -o x.ply --$place -
  done
  run --separate-stderr bash -c 'tm-reconstruct --help >/dev/full'
  assert_status 5
}
