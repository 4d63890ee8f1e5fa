# Runs the EXAMPLES of the man pages as they are written.

load ../helpers/common

# Makes the meshes, cameras and photographs that the examples name. The scene is 26.5 times as large as the
# shape of tm-shape, so that its pixels have the size that the page of tm-photo-step states.
make_meshes() {
  tm-shape sphere --faces 1000 -o a.ply
  tm-shape box 1 1 3 --faces 1000 -o b.ply
  tm-shape folded --faces 2000 -o self-intersecting.ply
  tm-shape box --faces 500 -o part.off
  tm-shape torus --faces 2000 -o scan.ply
  for name in mesh part rough large target result; do cp scan.ply "$name.ply"; done
  cp b.ply source.ply
  for name in mesh.off model.stl scan.obj; do tm-convert -o "$name" scan.ply; done
  tm-stitch --flip b.ply | tm-cat -o chair.obj b.ply -
  mkdir frames && cp a.ply b.ply frames
  tm-convert --format ply-ascii scan.ply | awk '
    /^element vertex/ { n = $3 }
    /^element face/ { print "property double size" }
    inside && n-- > 0 { print $0, 0.1; next }
    /^end_header/ { inside = 1 }
    { print }' >sized.ply
  tm-convert --format ply-ascii scan.ply | awk '
    /^element vertex/ { n = $3 }
    inside && n-- > 0 { print $0, $1, $2, $3 }
    /^end_header/ { inside = 1 }' >scan.P3D
}

make_scene_of_photographs() {
  tm-shape dented --faces 3000 --format ply-ascii | awk '
    /^element vertex/ { n = $3 }
    inside && n-- > 0 { print 26.5 * $1, 26.5 * $2, 26.5 * $3; next }
    /^end_header/ { inside = 1 }
    { print }' >sparse.ply
  tm-photograph --size 160x120 --write-images photos --write-silhouettes masks -o par.txt sparse.ply
  tm-hull --cameras par.txt --silhouettes masks -o hull.ply
  for name in dino_par temple_par cameras; do cp par.txt "$name.txt"; done
  for name in images dino temple dance/1/photos dance/2/photos; do
    mkdir -p "$name" && cp photos/* "$name"
  done
  cp -r masks dance/1 && cp -r masks dance/2
  tm-cameras --format matrices --folder matrices par.txt
  for file in matrices/view*.txt; do cp "$file" "dino/camera${file#matrices/view}"; done
  tm-cameras --format colmap --images images --folder sparse/0 par.txt
}

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  mkdir files && cd files
  make_meshes
  make_scene_of_photographs
}

# Prints the indented lines of a page's section EXAMPLES.
examples_of() {
  sed -n '/^# EXAMPLES/,/^# EXIT STATUS/ s/^    //p' "$tm_build/man/$1.md"
}

run_examples() { # PAGE...
  for page in "$@"; do
    cp -r "$BATS_FILE_TMPDIR/files" "$page"
    examples_of "$page" >"$page.sh"
    [ -s "$page.sh" ] || fail "$page has no examples"
    (cd "$page" && bash -euo pipefail "../$page.sh" >../log 2>&1 </dev/null) ||
      fail "$page: $(cat log)"
  done
}

setup() {
  cd "$BATS_TEST_TMPDIR"
}

@test "every page is in one of the tests below" {
  diff <(cd "$tm_root/man" && printf '%s\n' *.md | sed 's/\.md$//' | sort) \
    <(sed -nE '/^  run_examples/,/[^\\]$/ s/run_examples|\\//gp' "$BATS_TEST_FILENAME" |
      xargs -n 1 | grep -v '[{}#]' | sort)
}

# In the examples of these two pages, no movement is clamped.
clamps_nothing() {
  run ! grep clamped log
}

@test "examples of filters" {
  run_examples tm-displace.1
  clamps_nothing
  run_examples tm-cat.1 tm-clean.1 tm-convert.1 tm-morph-step.1 tm-offset.1
  run_examples tm-align.1 tm-boolean.1 tm-carry.1 tm-fill.1 tm-flow.1 tm-handles.1 tm-remesh.1 tm-repair.1 tm-sample.1 tm-select.1 tm-stitch.1 tm-tile.1 tm-transform.1
}

@test "examples of programs that inspect meshes" {
  # The first example asks whether a mesh is free of intersections, which is true.
  run_examples tm-checkmanifold.1 tm-compare.1 tm-info.1 tm-intersect.1 tm-render.1
}

@test "examples of programs that make meshes, and of loops" {
  run_examples tm-evolve.1
  clamps_nothing
  run_examples tm-shape.1 tm-morph.1 tm-run.5 tm.1 tm.7
}

@test "examples of photographs and their cameras" {
  run_examples tm-cameras.1 tm-color.1 tm-dense.1 tm-hull.1 tm-photo-step.1 tm-photograph.1 tm-wrap.1
}

@test "examples of pages" {
  [ -e "$tm_build/share/transformesh/viewer.html" ] || skip "the viewer is not built: scripts/setup --browser"
  run_examples tm-report.1 tm-view.1
}

@test "the help of every program ends with an example that runs" {
  load ../helpers/contract
  cp -r "$BATS_FILE_TMPDIR/files" here
  cd here
  while IFS='|' read -r -u 8 program _; do
    line=$("$program" --help | tail -n 1)
    [[ $("$program" --help | tail -n 2 | head -n 1) == "Example:" && $line == *"$program "* ]] ||
      fail "$program --help ends with no example"
    case $program in
      tm) if ! command -v man || ! command -v pandoc; then continue; fi >/dev/null ;;
      # The examples of tm-reconstruct take minutes, so they are not run here.
      tm-reconstruct) continue ;;
      tm-report | tm-view) [ -e "$tm_build/share/transformesh/viewer.html" ] || continue ;;
    esac
    bash -euo pipefail -c "$line" >log 2>&1 </dev/null || fail "$line: $(cat log)"
  done 8< <(contract_programs)
}

@test "examples of reconstruction" {
  run_examples tm-reconstruct.1
}
