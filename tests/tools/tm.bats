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
  [ "$output" = "tm: there is no program 'nothing'; list all programs with tm" ]
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

@test "the command of each job runs" {
  tm-shape sphere --faces 1000 -o a.ply
  tm-shape box 1 1 3 --faces 1000 -o b.ply
  tm-convert a.ply -o in.stl
  tm | sed '/^$/,$d' >list
  [ "$(wc -l <list)" -eq 12 ]
  while read -r -u 8 line; do
    command=${line:26}
    case $command in
      # The viewer serves until it is stopped, and a morph takes long, so only their help is run.
      tm-view* | tm-morph*) ${command%% *} --help >/dev/null 2>&1 || [ "${command%% *}" = tm-view ] ;;
      *) bash -euo pipefail -c "$command" >log 2>&1 </dev/null || fail "$command: $(cat log)" ;;
    esac
  done 8<list
}

@test "words of other programs open the page that explains them" {
  mkdir bin
  cp "$tm_build/bin/tm" "$tm_build/bin/tm-remesh" bin
  run --separate-stderr bin/tm decimate
  assert_status 0
  [ "$stderr" = "tm: decimate: tm-remesh --faces 5000 a.ply" ]
  [ "$output" = "$(tm-remesh --help)" ]
}

@test "an option of another program is shown there, and each of these is in the help" {
  run --separate-stderr tm-clean --faces 500 x.ply
  assert_status 2
  [[ $stderr == *"see tm-remesh --faces" ]]
  run --separate-stderr tm-info --weld x.ply
  [[ $stderr == *"see tm-stitch --tolerance" ]]
  while read -r program option; do
    "$program" --help | grep -q -- " $option " || fail "$program has no $option"
  done < <(sed -n 's/^    {"[a-z-]*", "\(.*\)"},/\1/p' "$tm_root/tools/frame/other_programs.cpp")
}
