# The state of a run of tm-morph. Sourced by it, after loop-state.bash.
# shellcheck shell=bash disable=SC2154,SC2034

readonly round=iteration
readonly csv_header=iteration,faces,pairs,components,genus,moved_fraction,\
max_clamp_share,rms_distance_to_target,max_distance_to_target,rms_distance_from_target,\
max_distance_from_target,mean_edge,seconds_step,seconds_clean,seconds_remesh,seconds,scale

describe_settings() {
  settings="source $source target $(readlink -f "$target") alpha $alpha time-step $time_step \
distance $distance smooth $smooth min-edge $min_edge max-edge $max_edge gap-edges $gap_edges \
reference-edge $reference_edge scales $scales"
}

close_state() {
  rm -f "$state"/mesh-*.ply "$state"/{state,verdict,settings,topology,target.ply,last.ply} \
    "$state"/{start,target,step,clean,remesh,final,distances,comparison}.{json,messages}
  rmdir "$state" || fail 5 "cannot remove the folder '$state'"
}

start_state() {
  first_step tm-clean --outermost --threads "$threads" -q --format ply \
    --reference-edge "$reference_edge" --report "$state/start.json" -o "$state/mesh-0.ply" "$source"
  # The target as the steps use it: read once, whatever its format, with the normals of its points.
  first_step tm-morph-step --threads "$threads" --target "$target" --distance "$distance" --alpha 0 \
    --gap-edges "$gap_edges" --write-target "$state/target.ply" -o /dev/null "$state/mesh-0.ply"
  find_target_topology >"$state/topology"
  iteration=0 scale=$((scales - 1))
  state_line="iteration 0 scale $scale idle 0 checked -9"
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

write_state() { append_state "$state_line stop ${stop:-no}"; }

resume_state() {
  state_line=$(tail -n 1 "$state/state")
  stop=${state_line##* stop } stop=${stop% end} stop=${stop#no}
  state_line=${state_line% stop *}
  read -r _ iteration _ scale _ <<<"$state_line"
}
