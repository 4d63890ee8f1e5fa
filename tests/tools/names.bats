# File names that a shell or a program may misinterpret, for every program and every option that takes a
# file name.

load ../helpers/common
load ../helpers/contract
load ../helpers/scene

# Prints a name of 255 bytes, the longest that file systems allow.
long_name() { # LAST
  printf 'é%.0s' {1..125}
  printf '%s' "$1"
}

setup_file() {
  make_contract_inputs "$BATS_FILE_TMPDIR"
}

setup() {
  cd "$BATS_TEST_TMPDIR"
  # Each name has several special characters, because each takes about ten runs of every program.
  names=('--output=a b%s%n.ply' -q $'two\nlines\xff back\\slash.ply' "'q\"=\$(touch pwned)[a]*?.ply"
    "$(long_name x.ply)")
}

# Prefixes the name with ./ if the program would otherwise take it for an option.
place_of() {
  [[ $1 == -* ]] && printf './'
  printf '%s' "$1"
}

name_is_taken() {
  rm -rf folder && mkdir folder && cd folder
  local input=() name place
  [ "$kind" = source ] || cp "$mesh" input
  for name in "${names[@]}"; do
    # Pictures need a certain ending.
    [ "$kind" != picture ] || name=${name/%.ply/.png}
    place=$(place_of "$name")
    [ "$kind" = source ] || input=("$place")
    [ "$kind" = source ] || mv input "$place"
    "$program" "${arguments[@]}" -q "${input[@]}" >../expected
    [ "$kind" = source ] || [[ $name != -* ]] || input=(-- "$name")
    "$program" "${arguments[@]}" -q --report /dev/null "${input[@]}" | cmp - ../expected
    # Only an output of the same kind may replace the input.
    [ "$kind" = source ] || mv "$place" input
    "$program" "${arguments[@]}" -q --report "$place" "${input[@]:+input}" | cmp - ../expected
    [ "$(jq -r .tool "$place")" = "$program" ]
    case $kind in
      source) ;;
      predicate | picture) input=(input) ;;
      *) mv input "$place" ;;
    esac
    # The second run overwrites existing files.
    for spelling in "-o$place" "--output=$place"; do
      "$program" "${arguments[@]}" -q "$spelling" "${input[@]}"
      cmp "$place" ../expected
      [ "${input[*]}" = input ] || [ "$kind" = source ] || cp "$mesh" "$place"
    done
    [ "${input[*]}" != input ] || mv input "$place"
    # Only the state of a loop may be left.
    rm -rf ./*.tm-*
    [ "$(find . -mindepth 1 -printf x)" = x ] || fail "left behind: $(ls -A)"
    [ "$kind" = source ] && rm "$place" || mv "$place" input
  done
}
@test "every program takes every name for its input, its output and its report" {
  for_each filter predicate picture source converter loop -- name_is_taken
}

@test "a loop takes every name for its output, its log, its frames and its state" {
  for name in "${names[@]}"; do
    place=$(place_of "$name")
    mkdir log
    tm-evolve -q --step cat --iterations 1 -o "$place" --csv "log/$name" --frames "log/frames" "$mesh"
    tm-evolve -q --step cat --iterations 2 --resume -o "$place" --csv "log/$name" "$mesh"
    [ "$(wc -l <"log/$name")" -eq 3 ]
    tm-evolve -q --step cat --iterations 2 --frames "log/frames/$name" -o result "$mesh"
    [ -s "log/frames/$name/frame-00000.ply" ]
    cmp result "$place"
    rm -rf log result.tm-evolve
  done
  # Different outputs have different states.
  long=$(long_name y.ply)
  run tm-evolve -q --step cat --iterations 3 --resume -o "$long" "$mesh"
  assert_status 0
  [ "$(find . -name '*.tm-evolve' -printf x | wc -c)" -eq $((${#names[@]} + 1)) ]
}

# Prints the exit code of writing a camera file whose images have names like NAME. A file that is written
# must be readable.
camera_file_code() { # NAME FORMAT
  rm -rf shots && mkdir shots
  for i in 0 1 2; do cp "images/view000$i.png" "shots/$1$i.png"; done
  if ! tm-cameras --images shots --format "$2" -o written matrices 2>stderr; then
    one_line "$(cat stderr)"
    echo 3
  else
    tm-cameras --images shots --format "$2" written 2>stderr | cmp - written && echo 0
  fi
}
@test "camera files hold the names of images, or the reason is reported" {
  tm-photograph -q --ring 3 --size 40x30 --write-images images -o /dev/null "$mesh"
  for i in 0 1 2; do printf '%s\n' "100 0 20 ${i}00" '0 100 15 0' '0 0 1 5'; done >matrices
  for name in 'alpha=0.2' 'back\slash' $'no\xffutf' '%s%n' '[a]' '--output=x' '-q'; do
    for format in middlebury colmap matrices; do
      [ "$(camera_file_code "$name" "$format")" = 0 ] || fail "$format: $name: $(cat stderr)"
    done
  done
  [ "$(camera_file_code 'a b' middlebury)" = 3 ]
  [ "$(camera_file_code 'a b' colmap)" = 0 ]
  for name in $'two\nlines' $'carriage\rreturn' ' a' ; do
    for format in middlebury colmap matrices; do
      [ "$(camera_file_code "$name" "$format")" = 3 ] || fail "$format: $name"
    done
  done
}

needs_no_temporary_folder() {
  [ "$kind" = source ] || arguments+=("$mesh")
  TMPDIR=$PWD/none "$program" -q "${arguments[@]}" >without
  "$program" -q "${arguments[@]}" | cmp - without
}
@test "no program needs a folder for temporary files" {
  for_each filter predicate picture source converter loop -- needs_no_temporary_folder
}

@test "a name that is too long is exit 5 before anything is done" {
  mkdir empty
  cd empty
  long=$(long_name longer.ply)
  for options in -o --report; do
    code=0
    tm-convert "$options" "$long" "$mesh" >../stdout 2>../stderr || code=$?
    [ "$code" -eq 5 ]
    one_line "$(cat ../stderr)"
    [ ! -s ../stdout ]
  done
  for options in -o '-o out.ply --csv'; do
    code=0
    tm-evolve --step cat --iterations 1 $options "$long" "$mesh" 2>../stderr || code=$?
    [ "$code" -eq 5 ]
    one_line "$(cat ../stderr)"
    [ -z "$(ls -A)" ] || fail "left behind: $(ls -A)"
  done
}
