# What tm-reconstruct says at the end: a line on stderr, and the report. Sourced by it, after loop.bash.
# shellcheck shell=bash disable=SC2154,SC2034

# The last mesh, cleaned once more, and how well photographs agree on it and on the start.
finish() {
  local mesh=$state/mesh-$((iteration % 2)).ply
  tm-clean -q --threads "$threads" --outermost --report "$state/final.json" \
    -o "$state/last.ply" "$mesh" || stop_after_failure $?
  local of
  for of in start last; do
    photo_step --alpha 0 --report "$state/$of.json" -o /dev/null "$state/$of.ply" ||
      stop_after_failure $?
  done
  write_mesh "$state/last.ply" tm-convert --no-provenance || exit $?
  seconds_since "$begun"
  write_report || fail 5 "cannot write '$report'"
  close_state
}

# What keeps the result from being converged, if anything.
fault() {
  if [ "$lost" != no ]; then
    echo "photographs compare less of the surface after scale $lost than before"
  elif [ "$rest" != yes ]; then
    echo "the surface was not at rest after the last pass"
  elif [ "$late" != no ]; then
    echo "components or holes came or went as late as at scale $late: maybe films that no photograph shows"
  fi
}

write_report() {
  local summary
  summary=$(awk -v passes="$iteration" -v name="$name" -v report="$report" -v seconds="$seconds" \
    -v pixel="$pixel_size" -v fault="$(fault)" "$read_reports$write_entries$counted"'
    END {
      printf("%s: %s, components %d, genus %d; dissimilarity from %.4f to %.4f%s\n",
        counted(passes, "pass"), counted(value["final.output.faces"], "face"),
        value["final.result.components"], value["final.result.genus"],
        value["start.result.dissimilarity"], value["last.result.dissimilarity"],
        fault == "" ? "" : "; " fault)
      if (report == "") exit
      begin_report()
      entry("views", value["last.result.views"])
      entry("pixel_size", pixel)
      entry("passes", passes)
      entry("converged", fault == "" ? "true" : "false")
      entry("fault", "\"" fault "\"")
      entry("components", value["final.result.components"])
      entry("genus", value["final.result.genus"])
      entry("first_dissimilarity", value["start.result.dissimilarity"])
      entry("dissimilarity", value["last.result.dissimilarity"])
      entry("first_coverage", value["start.result.coverage"])
      entry("coverage", value["last.result.coverage"])
      entry("first_pixels", value["start.result.pixels"])
      entry("pixels", value["last.result.pixels"])
      end_report(value["last.result.mean_edge"])
    }' "$state"/{start,last,final}.json) || return
  say "$summary"
}
