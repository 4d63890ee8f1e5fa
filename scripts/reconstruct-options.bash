# The command line of tm-reconstruct: what it takes, what it says of itself, and what it refuses.
# Sourced by it, before loop-options.bash.
# shellcheck shell=bash disable=SC2154,SC2034

readonly own_options='--cameras --images --silhouettes --silhouettes-show --threshold --keep --start
  --clip --sequence --track --output --coarsest
  --edge --last-edge --passes --iterations --pairs --window --robust --stiffness --pull'
readonly help_note='WHERE is a file, a folder or a quoted pattern, see tm-cameras.'

print_own_options() {
  cat <<'HELP'
Usage: tm-reconstruct [OPTION]... --cameras WHERE --images WHERE -o OUT

Reconstructs a closed surface from calibrated photographs.

Options:
  --cameras WHERE         file, folder or pattern of cameras
  --images WHERE          photographs
  --silhouettes WHERE     masks: not black where the object is
  --silhouettes-show exact|least
                          the object, or only some of it: then they pull outwards
                          alone (default exact)
  --threshold auto|LEVEL  without masks: grey level above which photographs show
                          the object (default auto; with --start, none)
  --keep largest|all|SHARE
                          components of the hull: of at least this share of the
                          largest one's volume (default largest)
  --start FILE            begin with this mesh, not with the visual hull
  --clip hull|nothing     of that mesh, keep what is within the hull of exact
                          silhouettes, or all (default hull)
  --sequence WHERE        reconstruct one time step after the other: a file with
                          a name per line, a folder of folders, or a pattern;
                          {} in other places stands for the name
  --track NUMBER          as --coarsest, for time steps that begin with the
                          surface of the one before (default 4)
  --coarsest auto|NUMBER  how much smaller photographs are at first; auto: up to
                          11.3, less where thin parts would get lost (default
                          auto)
  --edge NUMBER           length of edges, in pixels of the scale (default 3)
  --last-edge NUMBER      then shorten them to this in steps of the square root
                          of 2, at full scale (default: as --edge)
  --passes N              at most so many at each scale (default 4)
  --iterations N          steps between two cleanings (default 5)
  --pairs N               neighbors with which each view is compared (default 4)
  --window N              radius of compared windows, 1 to 5 pixels (default 3)
  --robust auto|NUMBER    at last, windows that disagree this many times as much as
                          the mean pull by a quarter, 0: all alike; auto: 1 where
                          photographs agree well, else 0 (default auto)
  --stiffness NUMBER      resistance to bending (default 1)
  --pull NUMBER           how much silhouettes pull (default 0.5)
  --resume                continue a run that was stopped, where there is one
  --frames FOLDER         keep meshes there as frame-00000.ply and so on
  --every N               every how many passes (default 1)
  --csv FILE              write a line per pass
HELP
}

need_number() { # OPTION VALUE MINIMUM
  if ! [[ $2 =~ ^[0-9]*\.?[0-9]+$ ]] || awk -v a="$2" -v b="$3" 'BEGIN { exit a + 0 >= b }'; then
    fail 2 "$1: '$2' is not a number of at least $3"
  fi
}

set_defaults() {
  cameras='' images='' silhouettes='' silhouettes_show=exact threshold='' keep=largest start=''
  clip=hull sequence='' track=4 coarsest=auto edge=3 last_edge='' passes=4 iterations=5 pairs=4
  window=3 robust=auto stiffness=1 pull=0.5 every=1
}

take_operand() {
  fail 2 "unexpected '$1': photographs are named by --images"
}

# What is read again and again cannot be a pipe.
refuse_standard_input() {
  local option
  for option in cameras images silhouettes start sequence; do
    [ "${!option}" != - ] || fail 2 "--$option: name a file: standard input is read once only"
  done
}

check_options() {
  check_verbosity
  [ -n "$cameras" ] || fail 2 "--cameras WHERE is needed: the cameras of the photographs"
  [ -n "$images" ] || fail 2 "--images WHERE is needed: the photographs"
  refuse_standard_input
  if [ -n "$start" ]; then
    if [ ! -r "$start" ] || [ -d "$start" ]; then fail 3 "cannot read '$start'"; fi
  fi
  check_stdout
  [[ $silhouettes_show =~ ^(exact|least)$ ]] ||
    fail 2 "--silhouettes-show: '$silhouettes_show' is neither exact nor least"
  [[ $clip =~ ^(hull|nothing)$ ]] || fail 2 "--clip: '$clip' is neither hull nor nothing"
  need_number --track "$track" 1
  [ -z "$sequence" ] || check_sequence
  [ "$coarsest" = auto ] || need_number --coarsest "$coarsest" 1
  need_number --edge "$edge" 1
  need_number --last-edge "${last_edge:=$edge}" 1
  need_integer --passes "$passes" 1
  need_integer --iterations "$iterations" 1
  [[ $window =~ ^[1-5]$ ]] || fail 2 "--window: '$window' is not a whole number from 1 to 5"
  [ "$robust" = auto ] || need_number --robust "$robust" 0
  need_integer --every "$every" 1
  need_integer --threads "$threads" 0
  if [ -z "$sequence" ]; then
    check_outputs --output "$output" --report "$report" --csv "$csv"
  else
    check_outputs --report "$report" --csv "$csv"
  fi
}
