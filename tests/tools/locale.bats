# Decimal commas and the Turkish i change nothing, in any program or script.

load ../helpers/common
load ../helpers/contract
load ../helpers/locales
load ../helpers/scene

setup_file() {
  make_contract_inputs "$BATS_FILE_TMPDIR"
  export LOCPATH=$BATS_FILE_TMPDIR
  make_locales "$LOCPATH" de_DE tr_TR
}

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# Writes the output and the messages of a run to files whose names begin with NAME. Seconds, which vary, are
# removed.
run_as() { # NAME COMMAND...
  local name=$1
  shift
  "$@" -v --report report >"$name.out" 2>"$name.err" || [ $? -eq 1 ]
  jq 'del(.timings, .peak_memory_bytes)' report >"$name.json"
  sed -i -E 's/[0-9.]+ s\b//; s/(seconds[a-z_]*:) .*/\1/' "$name.err"
}

locale_makes_no_difference() {
  [ "$kind" = source ] || arguments+=("$crossing")
  run_as C "$program" "${arguments[@]}"
  [ -s C.out ]
  for name in de_DE tr_TR; do
    LC_ALL=$name.UTF-8 run_as "$name" "$program" "${arguments[@]}"
    for part in out err json; do cmp "C.$part" "$name.$part"; done
  done
}
@test "every program has the same output and messages in every locale" {
  for_each filter predicate picture source converter loop -- locale_makes_no_difference
}

options_are_read() {
  for name in de_DE tr_TR; do
    LC_ALL=$name.UTF-8 "$program" --help | cmp - "$tm_root/tests/tools/golden/$program.help"
  done
}
@test "every program has the same help in every locale" {
  for_each filter predicate picture source converter loop -- options_are_read
}

@test "text formats and options are read and written the same in every locale" {
  for name in C.UTF-8 de_DE.UTF-8 tr_TR.UTF-8; do
    for format in off obj stl ply-ascii; do
      LC_ALL=$name tm-displace --normal-speed 0.25x --alpha .5 -o "$name.ply" "$mesh"
      LC_ALL=$name tm-convert -q -o "$name.${format%-ascii}" "$name.ply"
      LC_ALL=$name tm-convert -q --format ply-ascii -o "$name.$format.back" "$name.${format%-ascii}"
      cmp "C.UTF-8.$format.back" "$name.$format.back"
    done
    LC_ALL=$name tm-evolve --step 'tm-displace --normal-speed 0.01' --iterations 2 --csv "$name.csv" \
      --min-edge 0.5x -o "$name.evolved.ply" "$mesh"
    sed -i -E 's/(,[0-9.]+){5}$//' "$name.csv"
    cmp C.UTF-8.csv "$name.csv"
    cmp C.UTF-8.evolved.ply "$name.evolved.ply"
  done
}

@test "scripts work equally in every locale" {
  for script in $(grep -rlE '^#!/usr/bin/env bash' "$tm_root"/scripts "$tm_root/tests/corpus"); do
    grep -qxE 'export LC_ALL=C|\. .*/common.bash"?' "$script" || fail "$script sets no locale"
  done
  mkdir case
  echo case,1,1.5,1,1,1.25,1,true,1,1,0,1,1,1,1,yes >case/row.csv
  for name in C.UTF-8 de_DE.UTF-8 tr_TR.UTF-8; do
    LC_ALL=$name "$tm_root/scripts/experiments/page" "$name" "$PWD" case
    cmp C.UTF-8/table.csv "$name/table.csv"
    mkdir "$name/shapes"
    (cd "$name/shapes" && LC_ALL=$name "$tm_root/scripts/experiments/shapes" case-a >said)
    diff -r C.UTF-8/shapes "$name/shapes"
  done
}
