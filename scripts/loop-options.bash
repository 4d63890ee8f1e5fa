# The command lines of the loops, as far as they are the same: what every loop takes, how it is parsed,
# what is said and what is refused. Sourced by them, after loop.bash. A loop's own file of options sets
# own_options, those with a value, and help_note; and has print_own_options, take_operand for what is
# no option, set_defaults and check_options. The value of --an-option goes to the variable an_option.
# shellcheck shell=bash disable=SC2154,SC2034

readonly shared_options='--frames --every --csv --format --report --threads'
readonly shared_flags='--progress --no-progress --quiet --verbose --help --version'

set_shared_defaults() {
  output=- resume=no frames='' csv='' format='' report='' threads=0 progress='' quiet=no verbose=no
}

print_help() {
  print_own_options
  print_shared_options
}

print_shared_options() {
  cat <<HELP

Common options:
  -o, --output FILE       where to write; - is stdout (default -)
  --format ply|ply-ascii|ply-be|off
                          format of the output (default ply)
  --report FILE           also write a JSON report there
  --threads N             threads to use, 0: one per core (default 0)
  --progress              report progress on stderr, also where it is not a
                          terminal
  --no-progress           never report progress
  -q, --quiet             print errors only
  -v, --verbose           print the settings and what was done
  -h, --help              print this text
  --version               print the version

$help_note

Exit codes: 0 done, 2 usage, 3 bad input, 4 goal not reached, 5 output failed,
            6 out of memory.
HELP
}

# The version of the first of the filters, which are built together.
print_version() {
  find_filters "${filters[@]}"
  "${filters[0]}" --version | sed "s/^${filters[0]}/$name/"
}

parse() {
  while [ $# -gt 0 ]; do
    local option=$1
    shift
    if [[ $option == --*=* ]]; then
      set -- "${option#*=}" "$@"
      option=${option%%=*}
    fi
    if takes_value "$option"; then
      [ $# -gt 0 ] || fail 2 "$option needs a value"
      set_option "$option" "$1"
      shift
    elif [[ $option == -?* ]]; then
      set_flag "$option"
    else
      take_operand "$option"
    fi
  done
}

takes_value() { # OPTION
  local known
  for known in -o $own_options $shared_options; do
    [ "$1" != "$known" ] || return 0
  done
  return 1
}

set_option() { # OPTION VALUE
  local variable=${1#--}
  if [ "$1" = -o ]; then variable=output; fi
  printf -v "${variable//-/_}" '%s' "$2"
}

set_flag() { # OPTION
  case $1 in
    --resume) resume=yes ;;
    --progress) set_progress yes ;;
    --no-progress) set_progress no ;;
    -q | --quiet) quiet=yes ;;
    -v | --verbose) verbose=yes ;;
    -h | --help) print_and_exit print_help ;;
    --version) print_and_exit print_version ;;
    *) fail 2 "unknown option '$1'; did you mean '$(nearest_option "$1")'?" ;;
  esac
}

# --progress or --no-progress, and --quiet or --verbose, as the filters have them.
set_progress() { # yes|no
  [ "${progress:-$1}" = "$1" ] || fail 2 'give either --progress or --no-progress, not both'
  progress=$1
}
check_verbosity() {
  [ "$quiet$verbose" != yesyes ] || fail 2 'give either --quiet or --verbose, not both'
}

# The known option with the smallest edit distance to $1.
nearest_option() {
  awk -v word="$1" -v options="$own_options --resume $shared_options $shared_flags" '
    function distance(a, b,   i, j, row, corner, above) {
      for (j = 0; j <= length(b); ++j) row[j] = j
      for (i = 1; i <= length(a); ++i) {
        corner = row[0]; row[0] = i
        for (j = 1; j <= length(b); ++j) {
          above = row[j]
          corner += substr(a, i, 1) != substr(b, j, 1)
          if (row[j] + 1 < corner) corner = row[j] + 1
          if (row[j - 1] + 1 < corner) corner = row[j - 1] + 1
          row[j] = corner; corner = above
        }
      }
      return row[length(b)]
    }
    BEGIN {
      least = 1e9
      for (n = split(options, known, /[ \n]+/); n > 0; --n)
        if ((d = distance(word, known[n])) <= least) { least = d; best = known[n] }
      print best
    }'
}

need_integer() { # OPTION VALUE MINIMUM
  if ! [[ $2 =~ ^[0-9]{1,9}$ ]] || [ "$2" -lt "$3" ]; then
    fail 2 "$1: '$2' is not a whole number of at least $3"
  fi
}

# Standard output takes no binary data to a terminal, and is nothing to be continued.
check_stdout() {
  [ "$output" != - ] || [ ! -t 1 ] || [ "$format" = ply-ascii ] || [ "$format" = off ] ||
    fail 2 "not writing binary PLY to a terminal: name a file with -o"
  [ "$output" != - ] || [ "$resume" = no ] || fail 2 "--resume needs -o OUT: what to continue"
}

# Before any work is done: each output has a name of its own, and a place to be written to.
check_outputs() { # OPTION FILE...
  local -A places=()
  while [ $# -gt 0 ]; do
    if [ -n "$2" ] && [ "$2" != - ]; then
      local place
      place=$(readlink -m -- "$2")
      if [ -n "${places[$place]-}" ] && { [ -f "$place" ] || [ ! -e "$place" ]; }; then
        fail 2 "give either ${places[$place]} or $1 its own file, not both"
      fi
      places[$place]=$1
      check_writable "$2" "$place"
    elif [ "$2" = - ] && [ "$1" != --output ]; then
      fail 2 "$1: name a file, as standard output is the mesh's"
    elif [ "$1" = --output ] && [ -z "$2" ]; then
      fail 5 'cannot write a file without a name'
    fi
    shift 2
  done
}

# As the filters do: folders of files are not made, and what is not a regular file is written directly.
check_writable() { # NAME PLACE
  local folder=${2%/*}
  if [ -d "$2" ] || [[ $1 == */ ]]; then
    fail 5 "cannot write '$1': Is a directory"
  elif [ -e "$2" ] && [ ! -f "$2" ]; then
    return
  elif [ ! -d "${folder:-/}" ]; then
    fail 5 "cannot write '$1': No such file or directory"
  elif [ ! -w "${folder:-/}" ] || [ ! -x "${folder:-/}" ]; then
    fail 5 "cannot write '$1': Permission denied"
  fi
}
