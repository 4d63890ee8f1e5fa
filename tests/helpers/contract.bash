# Table of all programs, and inputs, for the checks of the behavior that all programs have in common
# (tests/tools/contract.bats).

# Prints lines of the form name|kind|arguments. The arguments do not name the input. In the
# arguments, MESH stands for the input mesh, and SCENE for a folder with par.txt and masks, and with
# photos.txt and photos of the mesh. RUN stands for the folder of a run, TILES for a folder of clean
# tiles. The input of a converter is the file $NAME_input, for example $tm_cameras_input. A loop is
# a filter whose output is always PLY; its state may stay beside a named output.
contract_programs() {
  cat <<'TABLE'
tm|lister|
tm-align|filter|--reference MESH
tm-boolean|filter|union
tm-cameras|converter|
tm-carry|filter|--from MESH --closest
tm-cat|filter|
tm-checkmanifold|predicate|
tm-clean|filter|
tm-color|filter|--cameras SCENE/photos.txt --images SCENE/photos
tm-compare|predicate|--reference MESH
tm-convert|filter|
tm-dense|source|--cameras SCENE/photos.txt --images SCENE/photos --edge 0.1
tm-displace|filter|--normal-speed 0.01
tm-evolve|loop|--step cat --iterations 1
tm-fill|filter|
tm-flow|filter|mean-curvature
tm-handles|filter|
tm-hull|source|--cameras SCENE/par.txt --silhouettes SCENE/masks --resolution 20
tm-info|predicate|
tm-intersect|filter|
tm-morph-step|filter|--target MESH
tm-morph|loop|--target MESH --iterations 1
tm-offset|filter|--distance 5%
tm-photo-step|filter|--cameras SCENE/photos.txt --images SCENE/photos --max-angle 60
tm-photograph|converter|--size 40x30 --ring 3
tm-reconstruct|source|--cameras SCENE/photos.txt --images SCENE/photos --silhouettes SCENE/outlines --coarsest 1 --edge 5 --passes 1 --iterations 1 --robust 0
tm-remesh|filter|
tm-render|picture|
tm-repair|filter|
tm-report|reporter|RUN
tm-sample|filter|--count 200
tm-select|filter|--largest 1
tm-shape|source|sphere --faces 500
tm-stitch|filter|
tm-tile|source|join TILES
tm-transform|filter|--scale 2 --rotate 1,2,3,40
tm-view|viewer|
tm-wrap|converter|
TABLE
}

# torus COLUMNS ROWS [SHIFT]: prints a closed mesh of 2 * COLUMNS * ROWS faces as ASCII PLY. It has
# float coordinates, a comment, and properties that no program knows.
torus() {
  awk -v columns="$1" -v rows="$2" -v shift="${3:-0}" 'BEGIN {
    print "ply\nformat ascii 1.0\ncomment made by hand"
    print "element vertex " columns * rows
    print "property float x\nproperty float y\nproperty float z\nproperty float quality"
    print "element face " 2 * columns * rows
    print "property list uchar int vertex_indices\nproperty int label\nend_header"
    pi = atan2(0, -1)
    for (i = 0; i < columns; ++i)
      for (j = 0; j < rows; ++j) {
        u = 2 * pi * i / columns
        v = 2 * pi * j / rows
        r = 2 + cos(v)
        printf "%.5f %.5f %.5f %d\n", r * cos(u) + shift, r * sin(u), sin(v), i
      }
    for (i = 0; i < columns; ++i)
      for (j = 0; j < rows; ++j) {
        a = i * rows + j
        b = (i + 1) % columns * rows + j
        c = (i + 1) % columns * rows + (j + 1) % rows
        d = i * rows + (j + 1) % rows
        print 3, a, b, c, j
        print 3, a, c, d, j
      }
  }'
}

# Prints two cameras as Middlebury parameters.
two_cameras() {
  printf '%s\n' 2 "a.png 300 0 79.5 0 300 59.5 0 0 1 1 0 0 0 1 0 0 0 1 0 0 5" \
    "b.png 300 0 79.5 0 300 59.5 0 0 1 0.8 0 -0.6 0 1 0 0.6 0 0.8 0 0 5"
}

# make_contract_inputs FOLDER: makes the inputs for for_each. Requires scene.bash.
make_contract_inputs() {
  export mesh=$1/torus.ply crossing=$1/crossing.ply binary=$1/binary.ply scene=$1/scene
  export tm_cameras_input=$1/cameras_par.txt tm_photograph_input=$mesh tm_wrap_input=$mesh
  make_scene "$scene"
  two_cameras >"$tm_cameras_input"
  torus 24 12 >"$mesh"
  mkdir "$scene/photos"
  tm-photograph --ring 12 --size 80x60 --write-images "$scene/photos" \
    --write-silhouettes "$scene/outlines" -o "$scene/photos.txt" "$mesh"
  tm-convert --no-provenance --format ply -o "$binary" "$mesh"
  export run=$1/run
  tm-evolve -q --step cat --iterations 1 --run "$run" "$mesh"
  export tiles=$1/tiles
  tm-tile split --tiles 2 -o "$tiles" "$binary"
  for tile in 0 1; do tm-clean "$tiles/tile-$tile.ply" -o "$tiles/clean-$tile.ply"; done
  torus 24 12 1.1 | tm-cat --no-provenance --format ply -o "$crossing" "$mesh" -
}

# for_each KIND... -- FUNCTION: calls FUNCTION for every program of these kinds, with $program, $kind
# and the array $arguments set. Fails, naming the program, if FUNCTION fails. Prints the names of
# programs of other kinds, to which the check does not apply.
for_each() {
  local kinds=" " failed=0 rest row input mesh_input=$mesh binary_input=$binary
  local crossing_input=$crossing mesh binary crossing
  while [ "$1" != -- ]; do
    kinds+="$1 "
    shift
  done
  while IFS='|' read -r -u 8 program kind rest; do
    if [[ $kinds != *" $kind "* ]]; then
      echo "# $program: not for a $kind" >&3
      continue
    fi
    if [[ $kind == @(reporter|viewer) && ! -e $tm_build/share/transformesh/viewer.html &&
      $2 != @(help_is_golden|version_is_printed|unknown_option_is_refused) ]]; then
      echo "# $program: the viewer is not built" >&3
      continue
    fi
    mesh=$mesh_input binary=$binary_input crossing=$crossing_input
    if [ "$kind" = converter ]; then
      input=${program//-/_}_input
      mesh=${!input} binary=${!input} crossing=${!input}
    fi
    read -ra row <<<"$rest"
    arguments=("${row[@]/MESH/$mesh}")
    arguments=("${arguments[@]/SCENE/$scene}")
    arguments=("${arguments[@]/RUN/$run}")
    arguments=("${arguments[@]/TILES/$tiles}")
    # The function is not called in a condition, in which bash would ignore `set -e`.
    set +e
    (
      set -e
      "$2"
    )
    if [ $? -ne 0 ]; then
      echo "$program ${arguments[*]}: failed" >&2
      failed=1
    fi
    set -e
  done 8< <(contract_programs)
  return "$failed"
}

# Waits until a process, started in the background, catches SIGINT.
wait_until_interruptible() {
  local caught
  for _ in $(seq 1000); do
    kill -0 "$1" || fail "process $1 has ended early"
    caught=$(awk '/^SigCgt:/ { print substr($2, length($2)) }' "/proc/$1/status" 2>/dev/null)
    # SIGINT is signal 2, the second bit of the mask of caught signals.
    if [[ $caught == [2367abef] ]]; then return; fi
    sleep 0.01
  done
  fail "process $1 never caught SIGINT"
}
