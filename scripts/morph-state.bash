# The state of a run of tm-morph: a folder beside the output, from which --resume continues. Sourced
# by it, after loop.bash. Each line of its file `state` is complete once it ends, and describes the
# mesh after an iteration: mesh-0.ply after even ones, mesh-1.ply after odd ones.
# shellcheck shell=bash disable=SC2154,SC2034

readonly csv_header=iteration,faces,pairs,components,genus,moved_fraction,\
max_clamp_share,rms_distance_to_target,max_distance_to_target,rms_distance_from_target,\
max_distance_from_target,mean_edge,seconds_step,seconds_clean,seconds_remesh,seconds,scale

open_state() {
  if [ "$output" = - ]; then
    state=$(mktemp -d "${TMPDIR:-/tmp}/$name.XXXXXX")
  else
    state=$output.$name
    mkdir -p "$state" || fail 5 "cannot make the folder '$state'"
  fi
  settings="source $source target $(readlink -f "$target") alpha $alpha time-step $time_step \
distance $distance smooth $smooth min-edge $min_edge max-edge $max_edge gap-edges $gap_edges \
reference-edge $reference_edge scales $scales"
  if [ "$resume" = yes ] && [ -s "$state/state" ]; then
    resume_state
  else
    rm -f "$state"/mesh-*.ply "$state"/state
    start_state
  fi
}

# Of a run that writes to stdout nothing can be continued.
on_exit() {
  if [ "$output" = - ] && [ -n "$state" ] && [ -d "$state" ]; then close_state; fi
}

close_state() {
  rm -f "$state"/mesh-*.ply "$state"/{state,next,settings,topology,target.ply,last.ply} \
    "$state"/{start,target,step,clean,remesh,final,distances,comparison}.{json,messages}
  rmdir "$state" || fail 5 "cannot remove the folder '$state'"
}

start_state() {
  tm-clean --outermost --threads "$threads" -q --format ply --reference-edge "$reference_edge" \
    --report "$state/start.json" -o "$state/mesh-0.ply" "$source" || {
    local code=$?
    close_state
    exit "$code"
  }
  # The target as the steps use it: read once, whatever its format, with the normals of its points.
  tm-morph-step --threads "$threads" --target "$target" --distance "$distance" --alpha 0 \
    --gap-edges "$gap_edges" --write-target "$state/target.ply" -o /dev/null "$state/mesh-0.ply" || {
    local code=$?
    close_state
    exit "$code"
  }
  find_target_topology >"$state/topology"
  iteration=0 scale=$((scales - 1))
  state_line="iteration 0 scale $scale idle 0 checked -9"
  printf '%s\n' "$settings" >"$state/settings"
  printf '%s stop no end\n' "$state_line" >"$state/state"
  start_csv
  keep_frame
}

# Components and genus that the result should have: those of the target without its cavities.
# Nothing for points, open meshes and those that cross themselves.
find_target_topology() {
  if has_faces "$state/target.ply" &&
    tm-checkmanifold --closed --threads "$threads" "$state/target.ply" >/dev/null &&
    tm-clean --outermost --threads "$threads" -q --report "$state/target.json" -o /dev/null \
      "$state/target.ply"; then
    awk "$read_reports"'
      END { if (value["target.result.pairs"] == 0)
        print value["target.result.components"], value["target.result.genus"] }' "$state/target.json"
  fi 2>/dev/null
}

read_target_facts() {
  target_topology=$(cat "$state/topology")
  target_has_faces=no
  ! has_faces "$state/target.ply" || target_has_faces=yes
}

has_faces() { LC_ALL=C grep -aqm 1 '^element face [1-9]' "$1"; }

start_csv() {
  [ -z "$csv" ] || printf '%s\n' "$csv_header" >"$csv" || fail 5 "cannot write '$csv'"
}

resume_state() {
  [ "$(cat "$state/settings")" = "$settings" ] ||
    fail 2 "'$state' is of a run with other settings ($(cat "$state/settings")); leave out --resume"
  # Without what follows the last end of a line: it was being written.
  sed -n '/^iteration .* end$/p' "$state/state" >"$state/state.new"
  mv "$state/state.new" "$state/state"
  state_line=$(tail -n 1 "$state/state")
  stop=${state_line##* stop } stop=${stop% end} stop=${stop#no}
  state_line=${state_line% stop *}
  read -r _ iteration _ scale _ <<<"$state_line"
  # Lines of an iteration that was not finished.
  if [ -n "$csv" ] && [ -e "$csv" ]; then
    awk -F, -v last="$iteration" 'NR == 1 || $1 <= last' "$csv" >"$csv.new"
    mv "$csv.new" "$csv"
  else
    start_csv
  fi
  detail "continuing after iteration $iteration"
}
