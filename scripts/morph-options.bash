# The command line of tm-morph: what it takes, what it says of itself, and what it refuses. Sourced by
# it, before loop-options.bash.
# shellcheck shell=bash disable=SC2154,SC2034

readonly own_options='--target --output --iterations --alpha --time-step --distance --smooth
  --min-edge --max-edge --gap-edges --reference-edge --scales'
readonly help_note="A LENGTH is 0.02 (input units), 1% (of the bounding box's diagonal) or 0.7x (of
the reference edge)."

print_own_options() {
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
HELP
}

set_defaults() {
  source='' target='' iterations=1000 alpha=0.2 time_step=1 distance=auto smooth=0.1
  min_edge=0.7x max_edge=1.5x gap_edges=0 reference_edge=auto scales=1 every=10
}

take_operand() { # SOURCE
  [ -z "$source" ] || fail 2 "one source at most, but '$1' is a second one"
  source=$1
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
  check_stdout
  need_integer --iterations "$iterations" 1
  need_integer --scales "$scales" 1
  [ "$scales" -le 10 ] || fail 2 "--scales: $scales is more than 10; edges would be 2^$((scales - 1)) times as long"
  need_integer --every "$every" 1
  need_integer --threads "$threads" 0
  check_outputs --output "$output" --report "$report" --csv "$csv"
}
