# Time steps one after the other, for tm-reconstruct: each begins with the surface of the one before,
# and is made anew from its visual hull where the result is not as good as that of the time step that
# was last made from a hull. Sourced by tm-reconstruct, which is run for every surface.
# shellcheck shell=bash disable=SC2154,SC2034

readonly sequence_header=step,name,start,accepted,fault,faces,components,genus,dissimilarity,coverage,\
silhouette_agreement,least_silhouette_agreement,passes,seconds

check_sequence() {
  [ "$output" != - ] || fail 2 "--sequence needs -o FOLDER: where to write the surfaces"
  [[ $images == *'{}'* ]] || fail 2 "--images '$images' holds no {}, which stands for a time step"
  [ "${silhouettes:-{\}}" != "${silhouettes//'{}'/}" ] ||
    fail 2 "--silhouettes '$silhouettes' holds no {}, which stands for a time step"
  [ -z "$frames" ] || fail 2 "--frames is not for a --sequence, whose results are its frames"
}

# The time steps in natural order: lines of a file, folders in a folder, what a pattern matches.
list_steps() {
  if [ -d "$sequence" ]; then
    find "$sequence" -mindepth 1 -maxdepth 1 -type d | sort -V
  elif [ -f "$sequence" ]; then
    grep -v '^ *$' "$sequence" || true
  else
    compgen -G "$sequence" | sort -V || true
  fi
}

# Its settings, and a line for each time step that is done: what follows its last "end" was being
# written. Surfaces that are being made are there too.
open_sequence() {
  local settings
  mapfile -t steps < <(list_steps)
  [ ${#steps[@]} -gt 0 ] || fail 3 "--sequence '$sequence': there is no time step"
  check_names
  mkdir -p "$output" || fail 5 "cannot make the folder '$output'"
  state=$output/.$name
  settings="sequence $sequence cameras $cameras images $images silhouettes ${silhouettes:-none} \
show $silhouettes_show threshold ${threshold:-auto} keep $keep start ${start:-hull} clip $clip track $track \
coarsest $coarsest edge $edge last-edge $last_edge passes $passes iterations $iterations pairs $pairs \
robust $robust stiffness $stiffness pull $pull format ${format:-ply}"
  if [ "$resume" = yes ] && [ -s "$state/settings" ]; then
    check_settings
    keep_complete_lines "$state/steps"
  else
    rm -rf "$state"
    mkdir -p "$state" || fail 5 "cannot make the folder '$state'"
    : >"$state/steps"
    printf '%s\n' "$settings" >"$state/settings"
  fi
}

step_name() { # STEP
  local base=${1%/}
  printf '%s\n' "${base##*/}"
}

check_names() {
  local twice each
  twice=$(for each in "${steps[@]}"; do step_name "$each"; done | sort | uniq -d | head -n 1)
  [ -z "$twice" ] || fail 2 "--sequence '$sequence': two time steps are called '$twice'"
}

# tm-reconstruct for one surface, in the background; its messages are shown where they end the loop.
reconstruct_one() { # ARGUMENT...
  exec "$here/$name" -q --threads "$threads" --cameras "${cameras//'{}'/$step}" \
    --images "${images//'{}'/$step}" "${masks[@]}" --keep "$keep" --edge "$edge" \
    --last-edge "$last_edge" --passes "$passes" --iterations "$iterations" --pairs "$pairs" \
    --window "$window" --robust "$robust" --stiffness "$stiffness" --pull "$pull" --resume "$@" 2>"$state/messages"
}

run_self() { # ARGUMENT...
  local code=0
  run_group reconstruct_one "$@" || code=$?
  [ "$code" -eq 0 ] || cat "$state/messages" >&2
  return "$code"
}

# Sets masks: those given, or the outlines of this time step's hull, which show the object at least.
make_masks() {
  masks=(--silhouettes "${silhouettes//'{}'/$step}" --silhouettes-show "$silhouettes_show")
  if [ -n "$silhouettes" ]; then return; fi
  masks=(--silhouettes "$state/outlines" --silhouettes-show least)
  rm -rf "$state/outlines"
  mkdir "$state/outlines"
  tm-hull --threads "$threads" -q --cameras "${cameras//'{}'/$step}" \
    --images "${images//'{}'/$step}" --threshold "${threshold:-auto}" --keep "$keep" \
    --write-outlines "$state/outlines" -o /dev/null || exit $?
}

# Makes a surface and measures how far it agrees with the masks. Sets start_of_step.
make_surface() { # hull|before|given OPTION...
  local of=$1
  shift
  detail "$step: from $of"
  run_self "$@" --report "$state/$of.json" -o "$state/$of.ply" || return $?
  tm-photograph --threads "$threads" -q --cameras "${cameras//'{}'/$step}" \
    --compare-silhouettes "${masks[1]}" --report "$state/silhouettes-$of.json" -o /dev/null \
    "$state/$of.ply" || return $?
  start_of_step=$of
}

# What is wrong with a surface, as words without spaces; nothing where it is as good as the last one
# from a hull was. Of two surfaces the one with fewer faults, then the one photographs agree on more.
faults() { # hull|before|given
  awk -v of="$1" -v reference="$reference" "$read_reports"'
    function of_result(key) { return value[of ".result." key] + 0 }
    END {
      if (reference == "none") exit
      split(reference, before, " ")
      if (of_result("dissimilarity") > 1.3 * before[1]) printf "dissimilarity "
      if (of_result("coverage") < 0.9 * before[2]) printf "coverage "
      least = value["silhouettes-" of ".result.least_silhouette_agreement"] + 0
      if (least < before[3] - 0.03) printf "silhouettes "
    }' "$state/$1.json" "$state/silhouettes-$1.json"
}

is_hull_better() { # FAULTS-OF-BEFORE
  local of_hull
  of_hull=$(faults hull)
  awk -v hull="$(wc -w <<<"$of_hull")" -v tracked="$(wc -w <<<"$1")" "$read_reports"'
    END {
      exit !(hull < tracked || (hull == tracked && \
        value["hull.result.dissimilarity"] + 0 < value["before.result.dissimilarity"] + 0))
    }' "$state"/{hull,before}.json
}

# A surface that was lost altogether has all faults; no dissimilarity is above 2.
make_tracked() {
  local code=0
  make_surface before --start "$before" --clip nothing --coarsest "$track" || code=$?
  if [ "$code" -eq 0 ]; then return; fi
  if [ "$code" -ne 3 ] && [ "$code" -ne 4 ]; then exit "$code"; fi
  say "time step $number, $(step_name "$step"): the surface before is lost"
  rm -rf "$state/before.ply.$name"
  printf '{\n  "result": {\n    "dissimilarity": 3\n  }\n}\n' >"$state/before.json"
  : >"$state/silhouettes-before.json"
}

# From the surface before, where there is one, and from the hull where that one has faults.
make_step() {
  local found=''
  make_masks
  if [ "$before" = none ] && [ -n "$start" ]; then
    make_surface given --start "$start" --clip "$clip" --coarsest "$coarsest" || exit $?
  elif [ "$before" = none ]; then
    make_surface hull --coarsest "$coarsest" || exit $?
  else
    make_tracked
    found=$(faults before)
    if [ -n "$found" ]; then
      make_surface hull --coarsest "$coarsest" || exit $?
      is_hull_better "$found" || start_of_step=before
    fi
  fi
  fault=${found% }
}

# Publishes the surface, then the line that says so.
finish_step() {
  local file
  file=$output/$(step_name "$step").$extension
  output=$file write_mesh "$state/$start_of_step.ply" tm-convert --no-provenance || exit $?
  cp "$state/$start_of_step.ply" "$state/last.new" && mv "$state/last.new" "$state/last-$number.ply"
  seconds_since "$started"
  awk -v number="$number" -v step_name="$(step_name "$step")" -v of="$start_of_step" \
    -v fault="$fault" -v seconds="$seconds" "$read_reports"'
    function of_result(key) { return value[of ".result." key] }
    function silhouettes(key) { return value["silhouettes-" of ".result." key] }
    END {
      gsub(" ", "+", fault)
      printf "%d,%s,%s,%s,%s,%d,%d,%d,%.6f,%.4f,%.4f,%.4f,%d,%.3f end\n", number, step_name, of,
        fault == "" || of != "before" ? "yes" : "no", fault, value[of ".output.faces"],
        of_result("components"), of_result("genus"), of_result("dissimilarity"),
        of_result("coverage"), silhouettes("silhouette_agreement"),
        silhouettes("least_silhouette_agreement"), of_result("passes"), seconds
    }' "$state/$start_of_step.json" "$state/silhouettes-$start_of_step.json" >>"$state/steps" ||
    fail 5 "cannot write to '$state'"
  rm -f "$state/last-$((number - 1)).ply" "$state"/{hull,before,given}.ply
}

write_sequence_csv() {
  [ -n "$csv" ] || return 0
  if ! { echo "$sequence_header" && sed 's/ end$//' "$state/steps"; } >"$csv.new" ||
    ! mv "$csv.new" "$csv"; then
    fail 5 "cannot write '$csv'"
  fi
}

# What a surface is measured by: the last one that was made from a hull, or given.
read_reference() {
  reference=$(awk -F, '$3 != "before" { print $9, $10, $12 + 0; found = 1 }
    END { if (!found) print "none" }' "$state/steps" | tail -n 1)
}

show_step() {
  if [ "$progress" = no ]; then return; fi
  tail -n 1 "$state/steps" | awk -F, -v name="$name" -v count="${#steps[@]}" "$counted"'{
    printf "%s: time step %d of %d, %s, from %s: %s, components %d, genus %d, dissimilarity %.4f%s\n",
      name, $1, count, $2, $3, counted($6, "face"), $7, $8, $9, $5 == "" ? "" : "; lost by tracking: " $5 }' >&2
}

reconstruct_sequence() {
  local done_steps
  find_filters "${filters[@]}" tm-photograph
  case $format in off) extension=off ;; *) extension=ply ;; esac
  open_sequence
  done_steps=$(wc -l <"$state/steps")
  [ "$done_steps" -eq 0 ] || detail "continuing after time step $done_steps"
  for ((number = done_steps + 1; number <= ${#steps[@]}; ++number)); do
    step=${steps[number - 1]} before=none started=$EPOCHREALTIME
    if [ "$number" -gt 1 ]; then before=$state/last-$((number - 1)).ply; fi
    read_reference
    make_step
    finish_step
    write_sequence_csv
    show_step
  done
  write_sequence_csv
  report_sequence
  rm -rf "$state"
}

report_sequence() {
  local summary
  seconds_since "$begun"
  summary=$(awk -F, -v name="$name" -v report="$report" -v seconds="$seconds" \
    -v version="$("$here/$name" --version | awk '{ print $2; exit }')" "$counted"'
    { ++count; tracked += $3 == "before"; accepted += $4 == "yes" }
    END {
      printf("%s, %d tracked, %d as good as from the hull\n", counted(count, "time step"), tracked,
        accepted)
      if (report == "") exit
      printf("{\n  \"tool\": \"%s\",\n  \"version\": \"%s\",\n  \"result\": {\n", name, version) >report
      printf("    \"time_steps\": %d,\n    \"tracked\": %d,\n    \"accepted\": %d\n  },\n", count,
        tracked, accepted) >report
      printf("  \"timings\": {\n    \"total\": %s\n  }\n}\n", seconds) >report
    }' "$state/steps") || fail 5 "cannot write '$report'"
  say "$summary"
}
