# scripts/bench/thingi: every mesh of a folder has a row with the outcome that it should have.

load ../helpers/common

setup() {
  needs_command jq
  cd "$BATS_TEST_TMPDIR"
  mkdir -p "in/of a user"
  # Two spheres that intersect, and a tetrahedron with one face turned.
  tm-shape two-spheres --gap=-0.3 --faces 300 -o "in/of a user/it's.STL"
  tetrahedron | sed 's/^3 0 1 2$/3 0 2 1/' >in/turned.ply
  echo word >in/text.off
  echo "no mesh" >in/readme.txt
}

thingi() {
  "$tm_root/scripts/bench/thingi" in -o out --jobs 2 "$@"
}

# row MESH KEY: prints a value of a mesh's row, found by its name.
row() {
  jq -rs --arg mesh "$1" --arg key "$2" '.[] | select(.mesh == $mesh) | .[$key]' out/rows/*
}

@test "certified, refused and unreadable meshes, in one CSV and one page" {
  run --separate-stderr thingi
  assert_status 0
  [ "${lines[0]}" = "1 certified, 1 refused, 1 unreadable" ]
  [ "$(row "of a user/it's.STL" outcome)" = certified ]
  [ "pairs: $(row "of a user/it's.STL" pairs)" = "$(tm-intersect -q --check "in/of a user/it's.STL")" ]
  [ "$(row turned.ply outcome)" = refused ]
  [[ $(row turned.ply message) == "tm-clean: "* ]]
  [ "$(row text.off step)" = read ]
  [ "$(wc -l <out/table.csv)" -eq 4 ]
  [ "$(grep -c '<td>turned.ply</td>' out/index.html)" -eq 1 ]
  grep -qE 'it&(#39|apos);s.STL' out/index.html
}

@test "a stopped run continues: rows stay, and a mesh that has changed is cleaned again" {
  thingi >first
  rm "out/rows/of a user%2Fit's.STL.json"
  touch -d '1 hour ago' in/* "in/of a user/"*
  echo '{"mesh": "text.off", "outcome": "kept"}' >out/rows/text.off.json
  thingi >second
  [ "$(head -n 1 second)" = "1 certified, 1 kept, 1 refused" ]
  touch -d '1 hour' in/text.off
  thingi | head -n 1 | grep -qx '1 certified, 1 refused, 1 unreadable'
}

@test "shares are disjoint, and the last one has the whole table" {
  thingi --share 1/2 >first
  [ "$(find out/rows -type f | wc -l)" -eq 1 ]
  thingi --share 0/2 | head -n 1 | cmp - <(echo "1 certified, 1 refused, 1 unreadable")
  run thingi --share 2/2
  assert_status 2
}

@test "a wrong result, a crash and a program that hangs are named, and the first two fail" {
  mkdir -p fake/bin
  ln -s "$tm_build"/bin/tm-* fake/bin
  rm fake/bin/tm-clean in/text.off in/turned.ply
  # fake_clean LINE: the programs are the real ones, but for tm-clean, which is this line.
  fake_clean() { printf '#!/bin/bash\n%s\n' "$1" >fake/bin/tm-clean && chmod +x fake/bin/tm-clean && rm -rf out; }
  fake_clean 'while [ "$1" != -o ]; do shift; done; tm-stitch -q "$3" -o "$2"'
  TM_BUILD=$PWD/fake run --separate-stderr thingi
  assert_status 1
  [ "${lines[0]}" = "1 uncertified" ]
  fake_clean 'kill -SEGV $$'
  TM_BUILD=$PWD/fake run --separate-stderr thingi
  assert_status 1
  [ "${lines[0]}" = "1 crashed" ]
  fake_clean 'exec sleep 30'
  TM_BUILD=$PWD/fake run --separate-stderr thingi --seconds 1
  assert_status 0
  [ "${lines[0]}" = "1 unfinished" ]
  [ "$(row "of a user/it's.STL" message)" = "not finished within 1 s" ]
  fake_clean 'echo "no library" >&2; exit 127'
  TM_BUILD=$PWD/fake run --separate-stderr thingi
  [ "$status" -ne 0 ] && [[ $stderr == *"no library"* ]]
  [ -z "$(find out/rows -type f)" ]
}
