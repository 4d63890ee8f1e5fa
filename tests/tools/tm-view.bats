load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  [ -e "$tm_build/share/transformesh/viewer.html" ] || skip "the viewer is not built: scripts/setup --browser"
  tm-shape torus --faces 1000 -o a.ply
  tm-shape box 1 2 3 --faces 500 -o b.ply
}

data_of() {
  sed -n 's|^<script id="page" type="application/json">\(.*\)</script>$|\1|p' "$1"
}

@test "meshes one after the other, or side by side; from a pipe too" {
  tm-view a.ply b.ply -o page.html
  data_of page.html | jq -e '[.runs[].meshes[].label] == ["a.ply", "b.ply"] and (.runs | length) == 1'
  tm-view --beside a.ply b.ply >page.html
  data_of page.html | jq -e '[.runs[].name] == ["a.ply", "b.ply"] and .title == "a.ply and 1 more"'
  tm-view <a.ply >page.html
  data_of page.html | jq -e '.title == "standard input" and .runs[0].meshes[0].faces > 900'
  run --separate-stderr tm-view --run x a.ply
  assert_status 2
  run --separate-stderr timeout 5 tm-view --serve a.ply -o page.html
  assert_status 2
  one_line "$stderr"
}

@test "the page of a run is that of tm-report but for its own name" {
  tm-evolve -q --step cat --iterations 2 --every 1 --run r a.ply
  tm-view --run r -o view.html
  tm-report r -o report.html
  cmp <(sed 's/"version":"tm-view/"version":"tm-report/' view.html) report.html
}

# Replaces the user's browser.
fake_opener() { # EXIT CODE
  mkdir -p fake
  printf '#!/bin/sh\nprintf "%%s" "$1" >"%s/opened"\nexit %s\n' "$PWD" "$1" >fake/xdg-open
  chmod +x fake/xdg-open
}

@test "--open writes a temporary page of the user's own and hands it to xdg-open" {
  fake_opener 0
  mkdir pages
  TMPDIR=$PWD/pages PATH=$PWD/fake:$PATH tm-view --open a.ply 2>messages
  page=$(cat opened)
  [[ $page == "$PWD"/pages/tm-view-??????.html ]]
  [ "$(stat -c %a "$page")" = 600 ]
  tm-view a.ply | cmp - "$page"
  grep -q "opened '$page'" messages
  fake_opener 3
  run --separate-stderr env TMPDIR=$PWD/pages PATH=$PWD/fake:$PATH tm-view --open a.ply
  assert_status 4
  one_line "$stderr"
  run --separate-stderr env PATH="$PWD/pages" "$tm_build/bin/tm-view" --open a.ply
  assert_status 4
  [[ $stderr == *"xdg-open is not installed"* ]]
}

serve() { # ARGUMENT...
  tm-view --serve "$@" >address 2>messages 3>&- &
  server=$!
  for _ in $(seq 500); do
    [ ! -s address ] || break
    sleep 0.02
  done
  address=$(cat address)
  [[ $address =~ ^http://127\.0\.0\.1:[0-9]+/[0-9a-f]{32}/$ ]] || fail "$address $(cat messages)"
  root=${address%/*/}/
}

end_server() {
  kill -INT "$server"
  code=0
  wait "$server" || code=$?
  [ "$code" -eq 130 ]
}

code_of() {
  curl -s -o answer -w '%{http_code}' --path-as-is --max-time 10 "$@"
}

@test "--serve answers requests with the token, with its own files only" {
  needs_command curl
  serve a.ply
  [ "$(code_of "$address")" = 200 ]
  grep -q '<title>a.ply</title>' answer
  [ "$(code_of "${address}page.json")" = 200 ]
  block=$(jq -r '.runs[0].meshes[0].block' answer)
  [ "$(code_of "${address}block/$block")" = 200 ]
  [ "$(code_of -I "$address")" = 200 ]
  for place in "$root" "${root}page.json" "${address%?????/}00000/" "${address}a.ply" \
    "${address}../../etc/passwd" "${address}block/../../a.ply" "${address}block/none" "${address}//etc/passwd"; do
    [ "$(code_of "$place")" = 404 ] || fail "$place"
  done
  for method in POST PUT DELETE OPTIONS; do
    [ "$(code_of -X "$method" "$address")" = 405 ]
  done
  # Foreign host names that were made to point here.
  for host in example.org localhost.example.org:80 127.0.0.1.example.org example.org:127.0.0.1; do
    [ "$(code_of -H "Host: $host" "$address")" = 403 ] || fail "$host"
  done
  # A tunnel whose other end has another port.
  for host in localhost:9000 LOCALHOST:80 127.0.0.1:1 localhost; do
    [ "$(code_of -H "Host: $host" "$address")" = 200 ] || fail "$host"
  done
  end_server
  run code_of "$address"
  [ "$status" -ne 0 ]
}

@test "--serve survives silent, malformed and long requests, and listens on loopback only" {
  needs_command curl
  needs_command ss
  serve a.ply
  port=${root#http://127.0.0.1:} port=${port%/}
  exec 7<>"/dev/tcp/127.0.0.1/$port" 8<>"/dev/tcp/127.0.0.1/$port"
  printf 'nonsense\r\n\r\n' >&8
  grep -q '400 Bad Request' <&8
  head -c 100000 /dev/zero | curl -s --max-time 5 -H "X: $(head -c 30000 /dev/zero | tr '\0' x)" "$address" >/dev/null || true
  [ "$(code_of "$address")" = 200 ]
  ss -tlnH "sport = :$port" | grep -q "127.0.0.1:$port"
  run ! bash -c "ss -tlnH 'sport = :$port' | grep -v '127.0.0.1:$port'"
  run --separate-stderr tm-view --serve --port "$port" a.ply
  assert_status 4
  one_line "$stderr"
  end_server
}

@test "--serve --run shows frames as they are written" {
  needs_command curl
  tm-evolve -q --step 'while [ ! -e go-$TM_ITERATION ]; do sleep 0.02; done; cat' --iterations 3 --every 1 \
    --run r a.ply 3>&- &
  loop=$!
  while [ ! -e r/frames/frame-00000.ply ]; do sleep 0.02; done
  serve --run r
  count() { curl -s "${address}page.json" | jq '.runs[0].meshes | length'; }
  wait_for() {
    for _ in $(seq 300); do
      [ "$(count)" -ne "$1" ] || return 0
      sleep 0.05
    done
    fail "$(count) meshes instead of $1"
  }
  wait_for 1
  touch go-1
  wait_for 2
  curl -s "${address}page.json" | jq -e '.runs[0].report == null'
  touch go-2 go-3
  wait "$loop"
  wait_for 4
  curl -s "${address}page.json" >page.json
  jq -e '.live and .runs[0].report.result.iterations == 3 and (.runs[0].log | length) > 0' page.json
  # Every mesh that the page names exists.
  for block in $(jq -r '.runs[0].meshes[].block' page.json); do
    [ "$(code_of "${address}block/$block")" = 200 ]
  done
  # A new run in the same folder.
  tm-evolve -q --step cat --iterations 1 --every 1 --run r b.ply
  wait_for 2
  end_server
  run --separate-stderr timeout 5 tm-view --serve --run nowhere
  assert_status 3
}
