# What tm-morph says at the end: a line on stderr, and the report. Sourced by it, after loop.bash.
# shellcheck shell=bash disable=SC2154,SC2034

# Awk: the line, and the entries of the report.
# shellcheck disable=SC2016
readonly report_functions='
  function result(key) { return value["distances.result." key] }
  function summary(   how) {
    how = stop == "converged" ? "converged" : \
      stop == "stalled" ? "no longer improving" : "iteration limit reached"
    return sprintf("%s after %s: %s, components %d, genus %d, " \
      "rms distance %.3g to and %.3g from the target%s", how, counted(iterations, "iteration"),
      counted(value["final.output.faces"], "face"), value["final.result.components"], value["final.result.genus"],
      result("rms_distance_to_target"), result("rms_distance_from_target"),
      fault == "" ? "" : "; " fault)
  }
  function write_result(   expected) {
    entry("converged", stop == "converged" ? "true" : "false")
    entry("stop", "\"" stop "\"")
    entry("iterations", iterations)
    entry("components", value["final.result.components"])
    entry("genus", value["final.result.genus"])
    entry("rms_distance_to_target", result("rms_distance_to_target"))
    entry("max_distance_to_target", result("max_distance_to_target"))
    entry("rms_distance_from_target", result("rms_distance_from_target"))
    entry("max_distance_from_target", result("max_distance_from_target"))
    if ("comparison.hausdorff" in value) {
      entry("hausdorff_to_target", value["comparison.hausdorff_to_reference"])
      entry("hausdorff_from_target", value["comparison.hausdorff_from_reference"])
    }
    if (split(topology, expected, " ") == 2) {
      entry("target_components", expected[1])
      entry("target_genus", expected[2])
    }
    entry("fault", "\"" fault "\"")
  }'

write_report() {
  local summary
  # shellcheck disable=SC2016
  summary=$(awk -v stop="${stop:-iteration_limit}" -v iterations="$iteration" -v name="$name" \
    -v report="$report" -v seconds="$seconds" -v fault="$fault" \
    -v topology="$target_topology" "$read_reports$write_entries$counted$report_functions"'
    END {
      print summary()
      if (report == "") exit
      begin_report()
      write_result()
      end_report(result("mean_edge"))
    }' "$state"/{final,distances,comparison}.json) || return
  say "$summary"
}
