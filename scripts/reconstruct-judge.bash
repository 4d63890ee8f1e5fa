# How far a run of tm-reconstruct has come: after every pass from the filters' reports, and where it
# began too coarse from a closer look. Sourced by it, after loop.bash.
# shellcheck shell=bash disable=SC2154,SC2034

# Awk: what the reports of a pass say.
# shellcheck disable=SC2016
readonly judge_values='
  function step(key) { return value["step.result." key] + 0 }
  function clean(key) { return value["clean.result." key] + 0 }
  function read_values() {
    now = step("last_dissimilarity"); share = step("mean_share"); outside = step("outside")
    coverage = step("last_coverage"); pixels = step("last_pixels")
    faces = value["clean.output.faces"]; components = clean("components"); genus = clean("genus")
    if (of_coverage == "none") { of_coverage = step("coverage"); of_pixels = step("pixels") }
  }'

# Awk: a line for the CSV file, and progress.
# shellcheck disable=SC2016
readonly judge_lines='
  function csv_line() {
    return sprintf("%d,%s,%s,%d,%d,%d,%d,%.6f,%d,%.4f,%.5f,%d,%.3f,%.3f,%.3f,%.3f", iteration, scale,
      edge, faces, clean("pairs"), components, genus, now, pixels, coverage, share, outside,
      own_seconds("remesh"), own_seconds("step"), own_seconds("clean"), seconds)
  }
  function progress_line() {
    return sprintf("pass %d, scale %.2f: %s, %s, genus %d, dissimilarity %.4f", iteration, scale,
      counted(faces, "face"), counted(components, "part"), genus, now)
  }'

# From the reports: a line for the CSV file, one of progress, and what to do next, `stay` or `refine`, the
# dissimilarity, how many vertices are outside of silhouettes, the coverage and the pixels that the
# level began with, components and genus, the scale at which coverage was lost since then or `no`,
# whether the surface is at rest, and the scale, below 2, at which components or holes came or went,
# or `no`. A level is done when vertices hardly move any more or
# photographs agree hardly better than after the pass before, or after --passes; but while vertices
# come in from outside of silhouettes or the topology changes, not before twice as many. A surface
# that photographs agree on because less of it is compared is not at rest: see lost_coverage of
# tm-photo-step. Ends the process.
judge() {
  exec awk -v iteration="$iteration" -v seconds="$seconds" -v scale="$scale" -v edge="$level_edge" -v before="$dissimilarity" \
    -v outside_before="$outside" -v topology_before="$topology" -v of_coverage="$of_coverage" \
    -v of_pixels="$of_pixels" -v pass="$pass" -v passes="$passes" \
    "$read_reports$counted$judge_values$judge_lines"'
    END {
      read_values()
      print csv_line()
      print progress_line()
      is_lost = coverage < 0.9 * of_coverage || pixels < 0.5 * of_pixels
      is_at_rest = !is_lost && (share < 0.015 || (before != "none" && now > 0.99 * before))
      enters = outside > 0.002 * value["step.output.vertices"] && \
        (outside_before == "none" || outside < 0.9 * outside_before)
      topology = components "/" genus
      is_other = topology_before != "none" && topology != topology_before
      changes = enters || is_other
      is_done = (is_at_rest && !changes) || pass + 1 >= (changes ? 2 * passes : passes)
      print is_done ? "refine" : "stay", now, outside, of_coverage, of_pixels, topology,
        is_lost ? scale : "no", is_at_rest && !changes ? "yes" : "no",
        is_other && scale < 1.99 ? scale : "no"
    }' "$state"/{remesh,step,clean}.json
}

# How many pixels photographs can compare on a mesh, at this scale.
coverage() { # MESH
  photo_step --alternate --alpha 0 --scale "$scale" --report "$state/coverage.json" -o /dev/null "$1"
  awk "$read_reports"' END { print value["coverage.result.pixels"] }' "$state/coverage.json"
}

# Where edges were too long, thin parts of the object are gone, and with them the pixels that showed
# them. A start that was only too large loses few.
is_torn() {
  [ "$coarsest" = auto ] || return 1
  local before after
  before=$(coverage "$state/start.ply")
  after=$(coverage "$state/mesh-$((iteration % 2)).ply")
  awk -v before="$before" -v after="$after" 'BEGIN { exit !(after < 0.95 * before) }'
}
