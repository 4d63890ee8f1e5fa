# How far a run of tm-morph has come: after every iteration from the filters' reports, and by a closer
# look where those say that it is there. Sourced by it, after loop.bash.
# shellcheck shell=bash disable=SC2154,SC2034

# Awk: what the reports say, and what was said before, in `last`.
# shellcheck disable=SC2016
readonly judge_values='
  function result(key) { return value["step.result." key] + 0 }
  function better(key,   current) {
    current = result(key)
    if (!(key in last) || current < 0.99 * last[key]) { last[key] = current; return 1 }
    return 0
  }
  function read_line(line,   words, i) {
    for (i = split(line, words, " "); i > 1; i -= 2) last[words[i - 1]] = words[i] + 0
  }
  function read_values() {
    # Values are text until something is added.
    vertices = value["step.input.vertices"] + 0
    moved = value["step.result.moved"] / vertices
    components = value["clean.result.components"] - value["remesh.result.components_removed"]
    genus = value["clean.result.genus"]
    faces = value["remesh.output.faces"]
    share = result("max_clamp_share")
    rms_to = result("rms_distance_to_target")
    max_to = result("max_distance_to_target")
    rms_from = result("rms_distance_from_target")
    max_from = result("max_distance_from_target")
    edge = result("mean_edge")
  }'

# Awk: the line of the CSV file, and of the progress.
# shellcheck disable=SC2016
readonly judge_messages='
  function csv_line() {
    return sprintf("%d,%d,%d,%d,%d,%.4f,%.4f,%.6g,%.6g,%.6g,%.6g,%.6g,%.3f,%.3f,%.3f,%.3f,%d",
      iteration, faces, value["clean.result.pairs"], components, genus, moved, share, rms_to,
      max_to, rms_from, max_from, edge, own_seconds("step"), own_seconds("clean"),
      own_seconds("remesh"), seconds, scale)
  }
  function progress_line() {
    return sprintf("iteration %d: %s, %s, genus %d, moved %d%%, distance %.3g", iteration,
      counted(faces, "face"), counted(components, "part"), genus, 100 * moved,
      (rms_to > rms_from ? rms_to : rms_from))
  }'

# Awk: what to do next:
#   continue
#   refine     at a coarse scale, when at most one in a hundred vertices would go farther than its
#              clamp, or nothing got better for five iterations
#   examine    no vertex moves more than half its clamp, and the vertices of mesh and target lie on
#              the other: root mean squares below half the mean edge, no point of the target missed
#              by two edges. At most every fifth iteration, as it costs more than one.
#   stalled    none of those distances got better by a hundredth in 20 iterations
#   examine_last   the same, but the vertices lie on the other: at a sharp tip the step and the
#              smoothing may pull a vertex to and fro for ever
# shellcheck disable=SC2016
readonly judge_decision='
  function has_improved(   count) {
    count = better("rms_distance_from_target") + better("max_distance_from_target")
    if (share > 0.5)
      count += better("max_clamp_share") + better("rms_distance_to_target") + \
        better("max_distance_to_target")
    return count > 0
  }
  function decide(   has_settled, is_near) {
    last["idle"] = has_improved() ? 0 : last["idle"] + 1
    # The first step of a scale is made with the edges of the one before.
    has_settled = ++last["age"] > 1
    is_near = rms_to < edge / 2 && rms_from < edge / 2 && max_from < 2 * edge
    if (scale > 0)
      return (has_settled && result("clamped") <= vertices / 100) || last["idle"] >= 5 ? \
        "refine" : "continue"
    if (has_settled && share <= 0.5 && is_near && iteration >= last["checked"] + 5)
      return "examine"
    if (last["idle"] >= 20) return is_near ? "examine_last" : "stalled"
    return "continue"
  }
  function forget_scale(   key) {
    for (key in last) if (key != "checked") delete last[key]
    last["idle"] = 0
  }
  function new_line(   line, key) {
    line = "iteration " iteration " scale " scale " idle " last["idle"]
    delete last["iteration"]; delete last["scale"]; delete last["idle"]
    for (key in last) line = line " " key " " last[key]
    return line
  }'

# From the reports: a line for the CSV file, one of progress, and what to do next, components and
# genus, and the new line of the state. Ends the process.
judge() {
  # shellcheck disable=SC2016
  exec awk -v iteration="$iteration" -v seconds="$seconds" -v line="$state_line" -v scale="$scale" \
    "$read_reports$counted$judge_values$judge_messages$judge_decision"'
    BEGIN { read_line(line) }
    END {
      read_values()
      print csv_line()
      print progress_line()
      next_step = decide()
      if (next_step == "examine") last["checked"] = iteration
      if (next_step == "refine") { forget_scale(); --scale }
      print next_step, components, genus, new_line()
    }' "$state"/{step,clean,remesh}.json
}

# What a closer look at a mesh finds, which misses no bridge between parts of the target: points
# all over the mesh are at most half its longest edge away from the target, which a sharp edge can
# be cut off by, no point of the target is missed by more than that edge, as a thin tip can be, and
# the topology is the target's.
# Sets fault, empty where nothing is wrong, and examined, the iteration. Of points only what is said
# at judge is known.
examine() { # MESH COMPONENTS GENUS
  fault='' examined=$iteration
  if [ "$target_has_faces" = no ]; then
    printf '{\n}\n' >"$state/comparison.json"
    return
  fi
  tm-compare --threads "$threads" --reference "$state/target.ply" --samples "$samples" --json \
    "$1" >"$state/comparison.json"
  local longest distances
  longest=$(tm-info --threads "$threads" --get edge_max "$1")
  distances=$(awk '/"hausdorff/ { gsub(/[",:]/, ""); print $1, $2 }' "$state/comparison.json")
  fault=$(awk -v components="$2" -v genus="$3" -v topology="$target_topology" -v longest="$longest" '
    { distance[$1] = $2 }
    END {
      split(topology, expected, " ")
      if (topology != "" && (components != expected[1] || genus != expected[2]))
        printf "components %d and genus %d, but those of the target are %d and %d: edges have to " \
          "be shorter than half the gaps of the target, and the source has to overlap all of it",
          components, genus, expected[1], expected[2]
      else if (distance["hausdorff_to_reference"] > longest / 2)
        printf "up to %.3g away from the target, more than half the longest edge: take shorter " \
          "edges", distance["hausdorff_to_reference"]
      else if (distance["hausdorff_from_reference"] > longest)
        printf "parts of the target are missed by up to %.3g, more than the longest edge: take " \
          "shorter edges, and a source that overlaps all of the target",
          distance["hausdorff_from_reference"]
    }' <<<"$distances")
}
