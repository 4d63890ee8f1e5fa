# How the frame writes the outputs of every program, shown with tm-convert.

load ../helpers/common
load ../helpers/contract

setup() {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >t.ply
}

@test "-o onto the input itself works, and a failure leaves the file as it was" {
  cp t.ply same.ply
  tm-convert --format off -o same.ply same.ply
  [ "$(head -n 1 same.ply)" = OFF ]
  head -c 100 t.ply >broken.ply
  cp broken.ply before
  run tm-convert -o broken.ply broken.ply
  assert_status 3
  cmp broken.ply before
}

@test "a FIFO as target is written and stays a FIFO" {
  mkfifo fifo
  tm-convert --no-provenance -o fifo t.ply 3>&- &
  cmp fifo t.ply
  wait $!
  [ -p fifo ]
}

@test "a symbolic link as target stays, also one that leads to no file yet" {
  mkdir scratch
  ln -s scratch/out.ply link.ply
  for _ in 1 2; do
    tm-convert --no-provenance -o link.ply t.ply
    [ -L link.ply ]
    cmp scratch/out.ply t.ply
    rm t.ply && tetrahedron >t.ply
  done
}

@test "a chain of links is followed to its end, and all links stay" {
  mkdir far
  ln -s b a
  ln -s far/c b
  ln -s ../d far/c
  for _ in 1 2; do
    tm-convert --no-provenance -o a t.ply
    [ -L a ] && [ -L b ] && [ -L far/c ]
    [ ! -L d ]
    cmp d t.ply
  done
}

@test "links that run in a circle are exit 5, and stay" {
  ln -s a a
  ln -s c b
  ln -s b c
  for name in a b; do
    for options in "-o $name" "-o out.ply --report $name"; do
      run --separate-stderr tm-convert $options t.ply
      assert_status 5
      one_line "$stderr"
      [[ $stderr == *"cannot write '$name': Too many levels of symbolic links"* ]] || fail "$stderr"
      [ -L a ] && [ -L b ] && [ -L c ]
      [ ! -e out.ply ]
    done
  done
}

@test "links that run in a circle are no input" {
  ln -s a a
  for program in tm-convert tm-cameras tm-wrap 'tm-compare --reference t.ply' 'tm-morph-step --target t.ply'; do
    run --separate-stderr $program a
    assert_status 3
    one_line "$stderr"
    [[ $stderr == *"Too many levels of symbolic links"* ]] || fail "$stderr"
  done
}

@test "devices and descriptors as targets are written directly" {
  tm-convert -o /dev/null t.ply
  [ -c /dev/null ]
  tm-convert --no-provenance -o /dev/stdout t.ply | cmp - t.ply
  tm-convert --no-provenance -o /dev/stdout t.ply >out.ply
  cmp out.ply t.ply
  echo before >out.ply
  tm-convert --no-provenance -o /dev/stdout t.ply >>out.ply
  cmp <(echo before | cat - t.ply) out.ply
  ln -s /dev/fd/7 link
  tm-convert --no-provenance -o link t.ply 7>out.ply
  [ -L link ]
  cmp out.ply t.ply
  tm-convert -q -o >(cat >piped; touch piped-is-done) --no-provenance \
    --report >(cat >report; touch report-is-done) t.ply
  while [ ! -e piped-is-done ] || [ ! -e report-is-done ]; do sleep 0.02; done
  cmp piped t.ply
  [ "$(jq -r .tool report)" = tm-convert ]
  run --separate-stderr tm-convert -o /dev/full t.ply
  assert_status 5
  one_line "$stderr"
}

@test "a folder that does not exist or may not be written is exit 5" {
  run --separate-stderr tm-convert -o none/out.ply t.ply
  assert_status 5
  one_line "$stderr"
  mkdir locked && chmod a-w locked
  [ ! -w locked ] || skip "root may write everywhere"
  run --separate-stderr tm-convert -o locked/out.ply t.ply
  assert_status 5
  one_line "$stderr"
}

@test "when one output fails no other appears" {
  run --separate-stderr tm-convert -o out.ply --report /dev/full t.ply
  assert_status 5
  [ ! -e out.ply ]
  run --separate-stderr tm-convert --report report.json t.ply -o /dev/full
  assert_status 5
  [ ! -e report.json ]
  run --separate-stderr tm-convert --report /dev/full t.ply
  assert_status 5
  [ -z "$output" ]
  [ -z "$(find . -name '*.tmp')" ]
}

@test "more output than ulimit allows is exit 5, and nothing is left behind" {
  tm-shape sphere -o large.ply
  mkdir folder
  run --separate-stderr bash -c 'ulimit -f 10; exec tm-convert -o folder/out.ply large.ply'
  assert_status 5
  one_line "$stderr"
  [ -z "$(ls -A folder)" ]
}

@test "a hangup ends a program with 129, unless nohup has it ignored" {
  mkfifo fifo
  for start in exec 'exec nohup'; do
    bash -c "$start tm-convert --no-provenance -o out.ply fifo" 3>&- >/dev/null 2>&1 &
    pid=$!
    exec 9>fifo
    wait_until_interruptible "$pid"
    kill -HUP "$pid"
    sleep 0.2
    cat t.ply >&9 || true
    exec 9>&-
    code=0
    wait "$pid" || code=$?
    if [ "$start" = exec ]; then
      [ "$code" -eq 129 ] || fail "exit code $code"
      [ ! -e out.ply ]
    else
      [ "$code" -eq 0 ] || fail "exit code $code under nohup"
      cmp out.ply t.ply
    fi
  done
}

@test "closed descriptors are reported" {
  for redirection in '>&-' '<&-'; do
    code=0
    bash -c "tm-convert <t.ply $redirection" 2>stderr || code=$?
    [ "$code" -eq 5 ] || [ "$redirection $code" = "<&- 3" ] || fail "$redirection: exit code $code"
    one_line "$(cat stderr)"
  done
  tm-convert -o out.ply t.ply 2>&-
  [ -s out.ply ]
}

@test "--help also fails on a full disk" {
  run --separate-stderr bash -c 'tm-convert --help >/dev/full'
  assert_status 5
}

@test "outputs of one place by two names are refused before either is written" {
  mkdir folder
  for report in ./x.ply folder/../x.ply "$PWD/x.ply"; do
    run --separate-stderr tm-convert -o x.ply --report "$report" t.ply
    assert_status 2
    one_line "$stderr"
    [[ $stderr == *"have the same file"* ]] || fail "$stderr"
    [ ! -e x.ply ]
  done
  cp t.ply x.ply
  run --separate-stderr tm-convert -o x.ply --report ./x.ply t.ply
  assert_status 2
  cmp t.ply x.ply
  tm-convert -o /dev/null --report /dev/../dev/null t.ply
}

@test "no output replaces an input, except a main output of the same kind" {
  cp t.ply other.ply
  ln -s t.ply link.ply
  ln t.ply hard.ply
  sum=$(cat t.ply other.ply | cksum)
  refused() { # COMMAND...
    run --separate-stderr "$@"
    assert_status 2
    one_line "$stderr"
    [[ $stderr == *"is an input, which would be lost: name another output"* ]] || fail "$stderr"
    [ "$(cat t.ply other.ply | cksum)" = "$sum" ]
    [ ! -e x.ply ]
  }
  mkdir frames
  ln t.ply frames/frame-00001.ply
  refused tm-evolve frames/frame-00001.ply --flow rotation --time 1 --frames frames -o x.ply
  cmp t.ply frames/frame-00001.ply
  refused tm-convert t.ply --report t.ply
  refused tm-convert link.ply --report ./t.ply
  refused tm-convert t.ply --report link.ply -o x.ply
  refused bash -c 'tm-convert --report t.ply <t.ply'
  refused tm-info t.ply -o t.ply
  refused tm-info t.ply --per-vertex t.ply
  refused tm-compare t.ply other.ply -o other.ply
  refused tm-compare t.ply --reference other.ply --per-vertex other.ply
  refused tm-align t.ply --reference other.ply --write-matrix other.ply
  refused tm-intersect t.ply --pairs t.ply
  refused tm-intersect t.ply --segments t.ply
  ln -s t.ply picture.png
  refused tm-repair t.ply --picture picture.png
  refused tm-morph-step t.ply --target other.ply --write-target t.ply
  refused tm-select --plane 0,0,1,0.1 t.ply --section t.ply
  refused tm-evolve t.ply --step tm-convert -o x.ply --csv t.ply
  refused tm-evolve t.ply --step tm-convert -o x.ply --events t.ply
  refused tm-morph t.ply --target other.ply -o x.ply --report other.ply
  cp t.ply part-001.ply
  refused tm-select part-001.ply --split part -o x.ply
  echo 'x = union t.ply other.ply' >script
  refused tm-boolean --script script --report other.ply -o x.ply
  # A hard link is another name of the same data, which stay under the name of the input.
  tm-convert -q t.ply --report hard.ply -o /dev/null
  tm-convert -q t.ply --report /dev/null -o /dev/null
  tm-convert -q t.ply -o /dev/null --report /dev/stderr
  [ "$(cat t.ply other.ply | cksum)" = "$sum" ]
}

@test "an option that writes one format refuses names of another" {
  refused() { # ENDING COMMAND...
    run --separate-stderr "${@:2}"
    assert_status 2
    one_line "$stderr"
    [[ $stderr == *"ends in $1, which is not an output format; take ."* ]] || fail "$stderr"
    [ ! -e "side$1" ]
  }
  refused .jpg tm-repair t.ply --picture side.jpg -o x.ply
  refused .png tm-select --plane 0,0,1,0.1 t.ply --section side.png -o x.ply
  refused .obj tm-intersect t.ply --segments side.obj
  refused .stl tm-morph-step t.ply --target t.ply --write-target side.stl -o x.ply
  refused .jpg tm-info t.ply --per-vertex side.jpg
  refused .jpg tm-compare t.ply --reference t.ply --per-vertex side.jpg
  [ ! -e x.ply ]
}

@test "two options name the same output file" {
  ln -s x.ply link
  for pair in '--report x.ply --segments ./x.ply' '--pairs x.ply --segments link' '-o x.ply --pairs x.ply'; do
    run --separate-stderr tm-intersect $pair t.ply
    assert_status 2
    [[ $stderr == *" have the same file: give each its own" ]] || fail "$stderr"
    [ ! -e x.ply ]
  done
}
