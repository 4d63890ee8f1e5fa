# What tm-morph says at the end: a line on stderr, and the report. Sourced by it, after loop.bash.
# shellcheck shell=bash disable=SC2154,SC2034

# Awk: the line, and the entries of the report.
# shellcheck disable=SC2016
readonly report_functions='
  function result(key) { return value["distances.result." key] }
  function summary(   how) {
    how = stop == "converged" ? "converged" : \
      stop == "stalled" ? "no longer improving" : "iteration limit reached"
    return sprintf("%s after %d iterations: %d faces, components %d, genus %d, " \
      "rms distance %.3g to and %.3g from the target%s", how, iterations,
      value["final.output.faces"], value["final.result.components"], value["final.result.genus"],
      result("rms_distance_to_target"), result("rms_distance_from_target"),
      fault == "" ? "" : "; " fault)
  }
  function entry(key, text) { printf "    \"%s\": %s,\n", key, text >report }
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
    printf "    \"mean_edge\": %s\n", result("mean_edge") >report
  }'

write_report() {
  # shellcheck disable=SC2016
  awk -v stop="${stop:-iteration_limit}" -v iterations="$iteration" -v name="$name" \
    -v report="$report" -v quiet="$quiet" -v seconds="$seconds" -v fault="$fault" \
    -v topology="$target_topology" "$read_reports$report_functions"'
    END {
      if (quiet != "yes") print name ": " summary() >"/dev/stderr"
      if (report == "") exit
      printf "{\n  \"tool\": \"%s\",\n  \"version\": \"%s\",\n", name, value["final.version"] >report
      printf "  \"output\": {\n    \"vertices\": %d,\n    \"faces\": %d\n  },\n",
        value["final.output.vertices"], value["final.output.faces"] >report
      printf "  \"result\": {\n" >report
      write_result()
      printf "  },\n  \"timings\": {\n    \"total\": %s\n  }\n}\n", seconds >report
    }' "$state"/{final,distances,comparison}.json
}
