# README.md and docs/recipes.md: indented lines run one by one, sessions print the output shown, and the
# lines of Python run. Blocks of sh are run by pipelines.bats.

load ../helpers/common

recipes=$tm_root/docs/recipes.md

# indented_lines FILE: prints the indented lines outside of fences. Lines that end in a backslash are joined
# with the next.
indented_lines() {
  awk '/^```/ { fenced = !fenced } /^    / && !fenced { print substr($0, 5) }' "$1" |
    sed -e ':more' -e '/\\$/ { N; s/\\\n */ /; b more' -e '}'
}

# block LANGUAGE FILE: prints the lines of all fenced blocks of that language.
block() {
  awk -v fence="^\`\`\`$1\$" '$0 ~ fence { inside = 1; next } /^```/ { inside = 0 } inside' "$2"
}

# Makes the step that the recipe for one's own velocity uses.
write_step() {
  awk '/^STEP$/ { inside = 0 } inside { print } /^cat > twist/ { inside = 1 }' "$recipes" >twist
  chmod +x twist
}

make_photographs() {
  tm-shape dented --faces 5000 -o photographed.ply
  tm-photograph --ring 16 --size 160x120 --write-images photos --write-silhouettes masks -o cameras.txt \
    photographed.ply
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
  write_step
  make_photographs
}

setup() {
  cd "$BATS_FILE_TMPDIR/files"
}

is_there() { # PROGRAM
  command -v "$1" >/dev/null
}

# run_line LINE: runs a line as printed, in a shell that detects failures anywhere in a pipe. Lines are
# skipped if they need a program of others that is not installed.
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
  if [[ $1 == *--f*.mp4* ]] && ! is_there ffmpeg; then
    echo "# ffmpeg is not installed: $1" >&3
    return
  fi
  # tm-view --serve runs until it is stopped; tm-view.bats tests it.
  if [[ $1 == 'tm-view --serve '* ]]; then return; fi
  bash -euo pipefail -c "$1" >log 2>&1 </dev/null || fail "$1: $(cat log)"
}

@test "every block of the README and of the recipes is run by a test" {
  # Blocks of sh and bash are run by pipelines.bats, those of cpp by examples_cpp.bats, and the others
  # below.
  diff <(grep -ohE '^```[a-z]+' "$tm_root/README.md" | sort -u) <(printf '```%s\n' bash console)
  diff <(grep -ohE '^```[a-z]+' "$recipes" | sort -u) <(printf '```%s\n' cpp python sh)
  [ "$(indented_lines "$tm_root/README.md" | wc -l)" -eq 6 ]
  [ "$(indented_lines "$recipes" | wc -l)" -ge 9 ]
}

@test "the README is short" {
  [ "$(wc -l <"$tm_root/README.md")" -le 110 ]
}

@test "the session of the README prints what it shows" {
  block console "$tm_root/README.md" >session
  [ "$(grep -c '^\$ ' session)" -ge 4 ]
  while IFS= read -r -u 7 line; do
    printf '%s\n' "$line"
    # A command of the session that finds an intersection does not end with exit code 0.
    bash -c "${line#\$ }" 2>&1 </dev/null || true
  done 7< <(grep '^\$ ' session) | diff session -
}

@test "each line of the README runs as it is printed" {
  while IFS= read -r -u 7 line; do run_line "$line"; done 7< <(indented_lines "$tm_root/README.md")
  for file in solid.ply part.ply thicker.ply morphed.ply twisted.ply surface.ply; do
    tm-checkmanifold --closed "$file" && tm-intersect --check "$file"
  done
}

@test "every recipe in one line runs as it is printed" {
  # The tests of the installation run this command.
  install='cmake --preset release -DTM_VIEWS=ON && cmake --build build --target installed && sudo cmake --install build'
  indented_lines "$recipes" | grep -qxF "$install"
  while IFS= read -r -u 7 line; do run_line "$line"; done 7< <(indented_lines "$recipes" | grep -vxF "$install")
  tm-checkmanifold --closed next.ply
}

@test "recipes make what they say" {
  # The volume grows by about the distance times the area.
  diagonal=$(tm-info --json body.ply | jq '[.bbox_max, .bbox_min] | transpose | map((.[0] - .[1]) | . * .) | add | sqrt')
  jq -n --argjson before "$(tm-info --json body.ply)" --argjson after "$(tm-info --json thicker.ply)" \
    --argjson distance "$(jq -n "0.02 * $diagonal")" -e '
    ($after.volume - $before.volume) / ($distance * ($after.area + $before.area) / 2) |
      . > 0.97 and . < 1.03'
  # Smoothing keeps the numbers of faces and vertices, and removes noise.
  [ "$(tm-info --get faces smooth.ply)" -eq "$(tm-info --get faces scan.ply)" ]
  jq -n --argjson before "$(tm-info --get area scan.ply)" --argjson after "$(tm-info --get area smooth.ply)" \
    -e '$after < $before'
  tm-info --get faces light.ply | awk '{ exit !($1 > 4950 && $1 < 5050) }'
  for mesh in thicker smooth light; do
    tm-checkmanifold --closed "$mesh.ply" && tm-intersect --check "$mesh.ply"
  done
}

@test "movie files are valid" {
  if is_there ffmpeg; then [ "$(head -c 8 film.mp4 | tail -c 4)" = ftyp ]; fi
}

@test "the lines of Python run as they are printed" {
  ls "$tm_build"/python/transformesh/_transformesh.*.so >/dev/null 2>&1 || skip "the Python module is not built"
  block python "$recipes" >lines.py
  [ "$(wc -l <lines.py)" -ge 3 ]
  python=$(sed -n 's/^Python3_EXECUTABLE:[A-Z]*=//p' "$tm_build/CMakeCache.txt")
  PYTHONPATH=$tm_build/python PYTHONDONTWRITEBYTECODE=1 "$python" lines.py
  tm-checkmanifold --closed union.ply
  tm-intersect --check union.ply
}
