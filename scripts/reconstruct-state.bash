# The state of a run of tm-reconstruct. `level` counts the scales, and then the shorter edges at full
# scale. Sourced by it, after loop-state.bash.
# shellcheck shell=bash disable=SC2154,SC2034

readonly round=pass
readonly csv_header=pass,scale,edge,faces,pairs,components,genus,dissimilarity,pixels,coverage,mean_share,\
outside,seconds_remesh,seconds_step,seconds_clean,seconds

describe_settings() {
  settings="cameras $cameras images $images silhouettes ${silhouettes:-none} show $silhouettes_show \
threshold ${threshold:-default} keep $keep start ${start:-hull} clip $clip coarsest $coarsest edge $edge \
last-edge $last_edge passes $passes iterations $iterations pairs $pairs window $window robust $robust \
stiffness $stiffness pull $pull"
}

close_state() {
  rm -f "$state"/{mesh-0,mesh-1,start,hull,both,coarse,last}.ply "$state"/{state,verdict,settings,levels} \
    "$state"/{cameras,start,remesh,step,clean,coverage,final,last,group}.{json,messages}
  rm -rf "$state/outlines"
  rmdir "$state" || fail 5 "cannot remove the folder '$state'"
}

start_state() {
  first_step tm-cameras --list --threads "$threads" --images "$images" \
    --report "$state/cameras.json" -o "$state/levels" "$cameras"
  read_pixel_size
  make_start
  make_levels
  iteration=0 level=1 first=1 lost=no rest=no late=no loss=0
  begin_level
  coarsen_start
}

read_pixel_size() {
  pixel_size=$(awk "$read_reports"' END { print value["cameras.result.pixel_size"] }' \
    "$state/cameras.json")
}

# A line per level: the scale, and the length of edges in the world.
make_levels() {
  local width
  width=$(awk 'NR > 1 && $2 ~ /^[0-9]+x/ { split($2, size, "x"); print size[1]; exit }' \
    "$state/levels")
  awk -v coarsest="$coarsest" -v width="${width:-640}" -v edge="$edge" -v last="$last_edge" \
    -v pixel="$pixel_size" 'BEGIN {
      if (coarsest == "auto") {
        coarsest = width / 28.5
        if (coarsest > 11.3) coarsest = 11.3
      }
      steps = 0
      while (exp(steps / 2 * log(2)) < coarsest * 0.999) ++steps
      for (; steps >= 0; --steps) {
        scale = exp(steps / 2 * log(2))
        printf "%.4f %.9g\n", scale, edge * scale * pixel
      }
      for (edge /= sqrt(2); edge > last * 0.999; edge /= sqrt(2))
        printf "1.0000 %.9g\n", edge * pixel
    }' >"$state/levels.new"
  mv "$state/levels.new" "$state/levels"
}

# The hull; or the mesh given, within the hull where masks show the object exactly. Without masks and
# with a threshold its outlines are those of the object's hull.
make_start() {
  if [ -z "$start" ]; then
    make_hull "$state/start.ply" "$keep"
    return
  fi
  first_step tm-clean --outermost --threads "$threads" -q --format ply --no-provenance \
    -o "$state/start.ply" "$start"
  if [ -n "$silhouettes" ] && [ "$silhouettes_show$clip" = exacthull ]; then
    clip_start
  elif [ -z "$silhouettes" ] && [ -n "$threshold" ]; then
    make_hull /dev/null "$keep"
  fi
}

make_hull() { # FILE COMPONENTS
  local from=(--silhouettes "$silhouettes")
  if [ -z "$silhouettes" ]; then
    mkdir -p "$state/outlines"
    from=(--images "$images" --threshold "${threshold:-auto}" --write-outlines "$state/outlines")
  fi
  first_step tm-hull --threads "$threads" -q --cameras "$cameras" "${from[@]}" \
    --keep "$2" --edge "$(scaled 3 "$pixel_size")" -o "$1"
}

# The exact intersection of start and hull.
clip_start() {
  local code=0
  make_hull "$state/hull.ply" all
  first_step tm-cat -q --threads "$threads" -o "$state/both.ply" "$state"/{start,hull}.ply
  tm-clean --level 2 --outermost --threads "$threads" -q --format ply --no-provenance \
    -o "$state/start.ply" "$state/both.ply" 2>"$state/clean.messages" || code=$?
  if [ "$code" -eq 0 ]; then return; fi
  [ "$code" -eq 4 ] || cat "$state/clean.messages" >&2
  close_state
  [ "$code" -ne 4 ] ||
    fail 4 "nothing of '$start' is within the hull of the silhouettes; see --clip"
  exit "$code"
}

begin_level() {
  pass=0 dissimilarity=none outside=none of_coverage=none of_pixels=none topology=none
}

# Where the last level is at rest and photographs agree on most of it, some more passes, in which
# windows that disagree pull less: sets loss, for --robust of tm-photo-step. Before, these windows are
# needed, as they show where the surface is still far off; and where few agree, it is not the others
# that are wrong.
begin_robust() { # LEVELS
  [ "$level" -eq "$1" ] && [ "$loss" = 0 ] && [ "$rest" = yes ] || return 1
  loss=$(awk -v robust="$robust" -v mean="$dissimilarity" 'BEGIN {
    loss = (robust == "auto" ? mean < 0.25 : robust) * mean
    if (loss > 1000) loss = 1000
    if (loss > 0 && loss < 0.001) loss = 0.001
    printf "%.9g", loss
  }')
  [ "$loss" != 0 ] || return 1
  begin_level
}

# The start, with edges as long as the level has them, as the mesh of this pass. Doubling them again
# and again is much faster than going there at once.
coarsen_start() {
  local goal mean mesh=$state/mesh-$((iteration % 2)).ply
  goal=$(sed -n "${level}p" "$state/levels" | cut -d' ' -f2)
  mean=$(tm-info --get edge_mean "$state/start.ply")
  cp "$state/start.ply" "$mesh"
  while mean=$(awk -v m="$mean" -v g="$goal" 'BEGIN { print 2 * m; exit !(2 * m < g) }'); do
    first_step tm-remesh -q --threads "$threads" --iterations 1 --min-edge "$(scaled 0.7 "$mean")" \
      --max-edge "$(scaled 1.4 "$mean")" -o "$state/coarse.ply" "$mesh"
    mv "$state/coarse.ply" "$mesh"
  done
}

scaled() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.9g", a * b }'; }

write_state() {
  append_state "pass $iteration first $first level $level of_level $pass dissimilarity $dissimilarity \
outside $outside coverage $of_coverage pixels $of_pixels topology $topology lost $lost rest $rest \
late $late loss $loss"
}

resume_state() {
  read -r _ iteration _ first _ level _ pass _ dissimilarity _ outside _ of_coverage _ of_pixels \
    _ topology _ lost _ rest _ late _ loss _ < <(tail -n 1 "$state/state")
  read_pixel_size
}
