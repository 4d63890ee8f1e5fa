# The command line of tm-morph: what it takes, what it says of itself, and what it refuses. Sourced by
# it, after loop.bash.
# shellcheck shell=bash disable=SC2154,SC2034

readonly long_options='--target --output --iterations --alpha --time-step --distance --smooth
  --min-edge --max-edge --gap-edges --reference-edge --scales --resume --frames --every --csv --format --report
  --threads --progress --no-progress --quiet --verbose --help --version'

print_help() {
  cat <<'HELP'
Usage: tm-morph [OPTION]... SOURCE --target FILE -o OUT

Evolves a mesh until it lies on a target.

Options:
  --target FILE           mesh or points to move towards
  --iterations N          stop after so many (default 1000)
  --alpha NUMBER          clamp on the movement, as a fraction of the mean edge
                          at the vertex (default 0.2)
  --time-step NUMBER      share of the distance to go in one step (default 1)
  --distance auto|surface|points|vertex
                          to the target's faces, or to the planes at its nearest
                          vertices or vertex; auto: surface where it has faces,
                          else points (default auto)
  --smooth KIND           smoothing of tm-remesh (default 0.1)
  --min-edge LENGTH       collapse shorter edges (default 0.7x)
  --max-edge LENGTH       split longer edges (default 1.5x)
  --gap-edges NUMBER      so many edges across the target's gaps and walls: shorter
                          ones where it is narrow; 0: the same everywhere
                          (default 0)
  --reference-edge auto|LENGTH
                          length that x refers to; auto: the source's mean edge
                          (default auto)
  --scales N              coarse to fine: begin with edges 2^(N-1) times as long
                          and halve them as the mesh comes to rest (default 1)
  --resume                continue a run that was stopped, where there is one
  --frames FOLDER         keep meshes there as frame-00000.ply and so on
  --every N               every how many iterations (default 10)
  --csv FILE              write a line per iteration

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

A LENGTH is 0.02 (input units), 1% (of the bounding box's diagonal) or 0.7x (of
the reference edge).

Exit codes: 0 done, 2 usage, 3 bad input, 4 goal not reached, 5 output failed,
            6 out of memory.
HELP
}

set_defaults() {
  source='' target='' output=- iterations=1000 alpha=0.2 time_step=1 distance=auto smooth=0.1
  min_edge=0.7x max_edge=1.5x gap_edges=0 reference_edge=auto scales=1
  resume=no frames='' every=10 csv='' format='' report='' threads=0
  progress='' quiet=no verbose=no
}

parse() {
  while [ $# -gt 0 ]; do
    local option=$1
    shift
    if [[ $option == --*=* ]]; then
      set -- "${option#*=}" "$@"
      option=${option%%=*}
    fi
    case $option in
      --target | --output | -o | --iterations | --alpha | --time-step | --distance | --smooth | \
        --min-edge | --max-edge | --gap-edges | --reference-edge | --scales | --frames | --every | --csv | \
        --format | --report | --threads)
        [ $# -gt 0 ] || fail 2 "$option needs a value"
        set_option "$option" "$1"
        shift
        ;;
      --resume) resume=yes ;;
      --progress) set_progress yes ;;
      --no-progress) set_progress no ;;
      -q | --quiet) quiet=yes ;;
      -v | --verbose) verbose=yes ;;
      -h | --help) print_and_exit print_help ;;
      --version) print_and_exit print_version ;;
      -?*) fail 2 "unknown option '$option'; did you mean '$(nearest_option "$option")'?" ;;
      *)
        [ -z "$source" ] || fail 2 "one source at most, but '$option' is a second one"
        source=$option
        ;;
    esac
  done
}

set_option() {
  case $1 in
    --target) target=$2 ;;
    --output | -o) output=$2 ;;
    --iterations) iterations=$2 ;;
    --alpha) alpha=$2 ;;
    --time-step) time_step=$2 ;;
    --distance) distance=$2 ;;
    --smooth) smooth=$2 ;;
    --min-edge) min_edge=$2 ;;
    --max-edge) max_edge=$2 ;;
    --gap-edges) gap_edges=$2 ;;
    --reference-edge) reference_edge=$2 ;;
    --scales) scales=$2 ;;
    --frames) frames=$2 ;;
    --every) every=$2 ;;
    --csv) csv=$2 ;;
    --format) format=$2 ;;
    --report) report=$2 ;;
    --threads) threads=$2 ;;
  esac
}

check_options() {
  check_verbosity
  if [ -z "$source" ]; then
    [ ! -t 0 ] || fail 2 "no source named; try $name --help"
    source=-
  fi
  [ -n "$target" ] || fail 2 "--target FILE is needed: what to move towards"
  [ "$target" != - ] || fail 2 "--target: name a file: standard input is for the source"
  if [ ! -r "$target" ] || [ -d "$target" ]; then fail 3 "cannot read the target '$target'"; fi
  [ "$output" != - ] || [ ! -t 1 ] || [ "$format" = ply-ascii ] || [ "$format" = off ] ||
    fail 2 "not writing binary PLY to a terminal: name a file with -o"
  [ "$output" != - ] || [ "$resume" = no ] || fail 2 "--resume needs -o OUT: what to continue"
  need_integer --iterations "$iterations" 1
  need_integer --scales "$scales" 1
  [ "$scales" -le 10 ] || fail 2 "--scales: $scales is more than 10; edges would be 2^$((scales - 1)) times as long"
  need_integer --every "$every" 1
  need_integer --threads "$threads" 0
  check_outputs --output "$output" --report "$report" --csv "$csv"
}

print_version() {
  find_filters "${filters[@]}"
  tm-morph-step --version | sed "s/^tm-morph-step/$name/"
}
