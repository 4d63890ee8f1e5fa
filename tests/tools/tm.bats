# tm: the programs of the suite, and their man pages.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

@test "every program is listed with what the page says under NAME" {
  tm >list
  for page in "$tm_root"/man/tm-*.1.md; do
    line=$(grep -m 1 -- ' - ' "$page")
    grep -qE "^${line%% - *} +${line#* - }$" list || fail "$line"
  done
  [ "$(grep -c '^tm-' list)" -eq "$(find "$tm_root/man" -name 'tm-*.1.md' | wc -l)" ]
}

@test "a name opens its page, with and without tm-" {
  needs_command man
  needs_command pandoc
  for name in clean tm-clean; do
    tm "$name" | grep -q 'tm-clean - removes self-intersections'
  done
  tm tm | grep -q 'DATA MODEL'
}

@test "without man the help is shown" {
  mkdir bin
  cp "$tm_build/bin/tm" "$tm_build/bin/tm-clean" bin
  diff <(bin/tm clean) <(tm-clean --help)
}

@test "an unknown name and two names are refused" {
  run tm claen
  assert_status 2
  [ "$output" = "tm: there is no program 'claen'; did you mean 'tm-clean'?" ]
  run tm nothing
  assert_status 2
  [ "$output" = "tm: there is no program 'nothing'; tm lists those that there are" ]
  run tm clean cat
  assert_status 2
  [[ $output == *"'cat' is a second one" ]]
}

@test "a program prints its completion for three shells, and no other" {
  for shell in bash zsh fish; do
    tm-clean --completion "$shell" | grep -q tm-clean
  done
  run tm-clean --completion tcsh
  assert_status 2
}
