# The commands of the README that pipelines.bats does not run: its indented lines, each by itself,
# and the lines of Python.

load ../helpers/common

# indented_lines [SECTION]: the indented lines of the README, or of one of its sections.
indented_lines() {
  awk -v section="${1-}" '
    /^```/ { fenced = !fenced }
    /^## / { inside = $0 == "## " section }
    /^    / && !fenced && (inside || section == "") { print substr($0, 5) }' "$tm_root/README.md" |
    # A line that ends in a backslash goes on in the next.
    sed -e ':more' -e '/\\$/ { N; s/\\\n */ /; b more' -e '}'
}

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  mkdir files && cd files
  tm-shape sphere --radius 1 --faces 2000 -o a.ply
  tm-shape box 1 1 3 --faces 1000 -o b.ply
  tm-shape folded --faces 2000 -o broken.stl
  tm-shape sphere --radius 0.3 --faces 500 -o hole.ply
  tm-shape dumbbell --faces 3000 -o body.ply
  tm-shape dented --faces 20000 --noise 10% -o scan.ply
  tm-shape sphere --center 1,0,0 --radius 0.3 --faces 1000 -o ball.ply
  tm-shape genus 2 --faces 1000 -o target.ply
  tm-shape sphere --around target.ply --faces 1000 -o source.ply
  for i in 1 2 3; do
    tm-render --size 80x60 --orbit "$((30 * i)),20" -o "frame-$i.png" b.ply
  done
}

setup() {
  cd "$BATS_FILE_TMPDIR/files"
}

# is_there PROGRAM: whether it is installed; of ImageMagick's convert, whether it is the real one.
is_there() {
  command -v "$1" >/dev/null && { [ "$1" != convert ] || convert -version | grep -q '^Version: ImageMagick'; }
}

# run_line LINE: as it is printed, in a shell that notices a failure anywhere in a pipe. What the
# suite does not have is skipped, by its name, where it is not installed.
run_line() {
  local program=${1%% *}
  if ! is_there "$program"; then
    [[ $program != tm-* ]] || fail "$program is not built"
    echo "# $program is not installed: $1" >&3
    return
  fi
  if [ "$program" = tm-report ] && [ ! -e "$tm_build/share/transformesh/viewer.html" ]; then
    echo "# the viewer is not built: $1" >&3
    return
  fi
  if [[ $1 == *--frames*.mp4* ]] && ! is_there ffmpeg; then
    echo "# ffmpeg is not installed: $1" >&3
    return
  fi
  # What serves until it is stopped is run by tm-view.bats.
  if [[ $1 == 'tm-view --serve '* ]]; then return; fi
  bash -euo pipefail -c "$1" >log 2>&1 </dev/null || fail "$1: $(cat log)"
}

@test "every block of the README is run by a test" {
  # Blocks of sh, and what those of bash are, by pipelines.bats; of cpp by examples_cpp.bats.
  diff <(grep -oE '^```[a-z]+' "$tm_root/README.md" | sort -u) <(printf '```%s\n' bash cpp python sh)
  # All but one of the indented lines belong to the two tests below.
  diff <(indented_lines) <(
    head -n 3 < <(indented_lines)
    echo 'cmake -DTM_VIEWS=ON build && cmake --build build --target installed && sudo cmake --install build'
    indented_lines Pipelines
  )
}

@test "the lines that open the README" {
  while IFS= read -r -u 7 line; do run_line "$line"; done 7< <(indented_lines | head -n 3)
  for file in solid.ply part.ply next.ply; do tm-checkmanifold --closed "$file"; done
}

@test "every recipe in one line runs as it is printed" {
  [ "$(indented_lines Pipelines | wc -l)" -ge 5 ]
  while IFS= read -r -u 7 line; do run_line "$line"; done 7< <(indented_lines Pipelines)
}

@test "recipes make what the README says" {
  # The offset is as much larger as its distance times the area, about.
  diagonal=$(tm-info --json body.ply | jq '[.bbox_max, .bbox_min] | transpose | map((.[0] - .[1]) | . * .) | add | sqrt')
  jq -n --argjson before "$(tm-info --json body.ply)" --argjson after "$(tm-info --json thicker.ply)" \
    --argjson distance "$(jq -n "0.02 * $diagonal")" -e '
    ($after.volume - $before.volume) / ($distance * ($after.area + $before.area) / 2) |
      . > 0.97 and . < 1.03'
  # Smoothing leaves faces and vertices, and takes noise away.
  [ "$(tm-info --get faces smooth.ply)" -eq "$(tm-info --get faces scan.ply)" ]
  jq -n --argjson before "$(tm-info --get area scan.ply)" --argjson after "$(tm-info --get area smooth.ply)" \
    -e '$after < $before'
  tm-info --get faces light.ply | awk '{ exit !($1 > 4950 && $1 < 5050) }'
  for mesh in thicker smooth light; do
    tm-checkmanifold --closed "$mesh.ply" && tm-intersect --check "$mesh.ply"
  done
}

@test "movie files are valid" {
  if is_there convert; then [ "$(head -c 4 film.gif)" = GIF8 ]; fi
  if is_there ffmpeg; then [ "$(head -c 8 film.mp4 | tail -c 4)" = ftyp ]; fi
}

@test "the lines of Python run as they are printed" {
  ls "$tm_build"/python/transformesh/_transformesh.*.so >/dev/null 2>&1 || skip "the Python module is not built"
  awk '/^```python$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$tm_root/README.md" >lines.py
  [ "$(wc -l <lines.py)" -ge 3 ]
  python=$(sed -n 's/^Python3_EXECUTABLE:[A-Z]*=//p' "$tm_build/CMakeCache.txt")
  PYTHONPATH=$tm_build/python PYTHONDONTWRITEBYTECODE=1 "$python" lines.py
  tm-checkmanifold --closed union.ply
  tm-intersect --check union.ply
}
