# Installed files work without the sources: programs, man pages, completions, and the library in the project
# of a user.

load ../helpers/common

setup_file() {
  cmake --install "$tm_build" --prefix "$BATS_FILE_TMPDIR/before" >/dev/null
  # Moves the installation: nothing may depend on its original folder.
  mv "$BATS_FILE_TMPDIR/before" "$BATS_FILE_TMPDIR/installed tree"
}

setup() {
  cd "$BATS_TEST_TMPDIR"
  prefix="$BATS_FILE_TMPDIR/installed tree"
  PATH="$prefix/bin:$PATH"
}

programs() {
  (cd "$tm_root/tools/programs" && printf '%s\n' tm.cpp tm-*.cpp | sed 's/\.cpp$//')
}

@test "every program is installed, with its completions" {
  diff <(programs | sort) <(ls "$prefix/bin" | sort)
  for program in $(programs); do
    [ -s "$prefix/share/bash-completion/completions/$program" ]
    [ -s "$prefix/share/zsh/site-functions/_$program" ]
    [ -s "$prefix/share/fish/vendor_completions.d/$program.fish" ]
  done
}

# first_command_targets: prints the CMake targets that scripts/quickstart builds.
first_command_targets() {
  sed -n 's/^ *cmake --build build --target \([^-]*\).*$/\1/p' "$tm_root/scripts/quickstart" | grep -oE '[^ ]+' | sort -u
}

# Links the installed files of the build folder into FOLDER, without those that targets other than TARGET...
# make.
link_what_is_built() { # FOLDER TARGET...
  local folder=$1
  shift
  ninja -C "$tm_build" -t targets all | sed -n 's/: [^ ]*$//p' | sort -u >every
  ninja -C "$tm_build" -t commands "$@" | grep -oE '[^ ]+' | sed "s|^$tm_build/||" | sort -u >built
  (cd "$tm_build" && find . -name cmake_install.cmake -o -name '*Targets*.cmake' -path '*/Export/*') |
    sed 's|^\./||' >scripts
  (cd "$tm_build" && xargs grep -ho "\"$tm_build/[^\"]*\"" <"$OLDPWD/scripts") | tr -d '"' |
    sed "s|^$tm_build/||" | sort -u | comm -23 - <(comm -23 every built) >installed
  while IFS= read -r file; do
    mkdir -p "$folder/$(dirname "$file")"
    ln -s "$tm_build/$file" "$folder/$file"
  done < <(sort -u installed scripts | while IFS= read -r file; do
    [ ! -f "$tm_build/$file" ] || printf '%s\n' "$file"
  done)
  while IFS= read -r script; do
    rm "$folder/$script"
    sed "s|$tm_build/|$folder/|g" "$tm_build/$script" >"$folder/$script"
  done <scripts
}

@test "the README's first command builds the program tm and all that is installed" {
  grep -qx 'CMAKE_GENERATOR:INTERNAL=Ninja' "$tm_build/CMakeCache.txt" || skip "the build is not Ninja's"
  mapfile -t targets < <(first_command_targets)
  [ ${#targets[@]} -gt 0 ]
  link_what_is_built "$PWD/build" "${targets[@]}"
  DESTDIR=$PWD/root cmake --install build --prefix /usr/local >log 2>&1 || fail "$(tail -n 5 log)"
  diff <(cd root/usr/local && find . -type l -o -type f | sort) <(cd "$prefix" && find . -type l -o -type f | sort)
  root/usr/local/bin/tm | grep -q tm-clean
}

@test "core needs no library of images, and has these programs" {
  "$tm_build/bin-test/core_alone"
  nm -C "$tm_build/bin-test/core_alone" | grep -q 'transformesh::clean('
  local disabled=()
  for package in JPEG PNG TIFF; do disabled+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON"); done
  cmake -S "$tm_root" -B core -G Ninja -DTM_VIEWS=OFF -DTM_SHOW=OFF "${disabled[@]}" >log 2>&1 ||
    fail "$(cat log)"
  ninja -C core -t targets all | sed -n 's|^bin/\(tm[^:]*\): .*|\1|p' | sort >built
  diff built - <<END
tm
tm-align
tm-boolean
tm-carry
tm-cat
tm-checkmanifold
tm-clean
tm-compare
tm-convert
tm-displace
tm-evolve
tm-fill
tm-flow
tm-handles
tm-info
tm-intersect
tm-morph
tm-morph-step
tm-offset
tm-remesh
tm-repair
tm-sample
tm-select
tm-shape
tm-stitch
tm-tile
tm-transform
END
}

@test "a pipeline runs from there" {
  pipe "'$prefix/bin/tm-shape' sphere --faces 500 | '$prefix/bin/tm-clean' | '$prefix/bin/tm-info' --get components"
  assert_status 0
  [ "$output" = 1 ]
}

@test "pages are made from there, where the viewer was built, and its licence is with it" {
  [ -e "$tm_build/share/transformesh/viewer.html" ] || skip "the viewer is not built: scripts/setup --browser"
  "$prefix/bin/tm-shape" sphere --faces 500 | "$prefix/bin/tm-view" >page.html
  grep -q '<title>standard input</title>' page.html
  grep -q 'three.js authors' "$prefix/share/transformesh/viewer-three.LICENSE"
}

# Finds a man page with only the folder of the programs in PATH.
page_of() {
  env -u MANPATH PATH="$1:/usr/bin:/bin" man -w "$2"
}

@test "man finds the pages once the programs are in PATH, installed or just built" {
  needs_command man
  needs_command pandoc
  for program in $(programs); do
    [ "$(page_of "$prefix/bin" "$program")" = "$prefix/share/man/man1/$program.1" ]
    [ "$(page_of "$tm_build/bin" "$program")" = "$tm_build/share/man/man1/$program.1" ]
  done
  [ "$(page_of "$prefix/bin" tm.7)" = "$prefix/share/man/man7/tm.7" ]
}

# complete PROGRAM WORD...: prints the completions that bash offers for the last word.
complete_in_bash() {
  bash --norc -c '
    source "$0/share/bash-completion/completions/$1"
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
    "$(complete -p "$1" | sed -E "s/.*-F ([^ ]+).*/\1/")"
    printf "%s\n" "${COMPREPLY[@]}"' "$prefix" "$@"
}

@test "bash completes options, choices, meshes, files and folders" {
  mkdir folder
  touch a.ply b.off c.txt d.STL
  [ "$(complete_in_bash tm-clean --lev)" = --level ]
  [ "$(complete_in_bash tm-clean --format ply-)" = "ply-ascii
ply-be" ]
  [ "$(complete_in_bash tm-clean '' | sort)" = "a.ply
b.off
folder" ]
  [ "$(complete_in_bash tm-clean --report '' | sort | tr '\n' ' ')" = "a.ply b.off c.txt d.STL folder " ]
  [ "$(complete_in_bash tm-morph --frames '')" = folder ]
  [ "$(complete_in_bash tm-report '')" = folder ]
  [ -z "$(complete_in_bash tm-clean --threads '')" ]
  [ "$(complete_in_bash tm-shape dumb)" = dumbbell ]
  [ "$(complete_in_bash tm cle)" = "" ]
  [ "$(complete_in_bash tm tm-cle)" = tm-clean ]
  for program in $(programs); do
    complete_in_bash "$program" -- | grep -qx -- --output || fail "$program"
  done
}

@test "zsh reads the completions" {
  needs_command zsh
  export HOME=$PWD
  for program in $(programs); do
    # Prints the function by which zsh completes the program, and checks that zsh loads it without an error.
    zsh -fc 'fpath=("$1" $fpath); autoload -Uz compinit; compinit -u -D
      print -- "$_comps[$2]"; autoload +X "_$2"' - "$prefix/share/zsh/site-functions" "$program" >taken
    [ "$(<taken)" = "_$program" ]
    zsh -n "$prefix/share/zsh/site-functions/_$program"
  done
}

@test "fish completes options and choices" {
  needs_command fish
  for program in $(programs); do
    fish --no-execute "$prefix/share/fish/vendor_completions.d/$program.fish"
  done
  export HOME=$PWD
  fish --no-config -c 'source $argv[1]; complete -C "tm-clean --format ply-"' \
    "$prefix/share/fish/vendor_completions.d/tm-clean.fish" >offered
  cut -f1 offered | diff - <(printf '%s\n' ply-ascii ply-be)
}

# Writes two intersecting balls, which the project cleans.
two_balls() {
  tm-shape two-spheres --faces 500 -o balls.ply
}

@test "a project finds the library with find_package, and evolves with a velocity of its own" {
  two_balls
  cmake -S "$tm_root/tests/install/project" -B built -DCMAKE_BUILD_TYPE=Release \
    "-DCMAKE_PREFIX_PATH=$prefix" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON >log 2>&1 || fail "$(cat log)"
  grep -q "include" built/compile_commands.json
  run ! grep -q "$tm_root/lib" built/compile_commands.json
  cmake --build built >>log 2>&1 || fail "$(cat log)"
  built/outside balls.ply grown.ply
  tm-checkmanifold --closed grown.ply >/dev/null
  tm-intersect --check grown.ply >/dev/null
  awk -v before="$(tm-info --get volume balls.ply)" -v after="$(tm-info --get volume grown.ply)" \
    'BEGIN { exit !(after > 1.1 * before) }'
}

@test "the same with pkg-config, and no header of CGAL is reached" {
  needs_command pkg-config
  two_balls
  pc=$(find "$prefix" -name transformesh.pc)
  export PKG_CONFIG_PATH=${pc%/*}
  flags=$(pkg-config --cflags --libs transformesh)
  # pkg-config quotes its words for a shell.
  eval "g++ -std=c++20 -H -o outside '$tm_root/tests/install/project/outside.cpp' $flags" 2>headers ||
    fail "$(tail -5 headers)"
  run ! grep -q CGAL headers
  ./outside balls.ply grown.ply
  [ "$(tm-info --get components grown.ply)" -ge 1 ]
}

@test "the Python module is installed" {
  folder=$(find "$prefix" -name '_transformesh.*.so')
  [ -n "$folder" ] || skip "the Python module is not built"
  folder=${folder%/transformesh/*}
  python=$(sed -n 's/^Python3_EXECUTABLE:[A-Z]*=//p' "$tm_build/CMakeCache.txt")
  PYTHONPATH=$folder "$python" -c 'import transformesh as tm
assert tm.info(tm.clean(tm.shape("two-spheres", faces=500)))["components"] == 1'
  [ -e "$folder/transformesh/py.typed" ]
}

@test "exactly the headers of include/transformesh are installed" {
  diff <(cd "$tm_root/include" && find . -type f | sort) <(cd "$prefix/include" && find . -type f | sort)
}

# public_headers: the names of the installed headers without .h, except the one that includes all others.
public_headers() {
  (cd "$prefix/include/transformesh" && printf '%s\n' *.h) | sed 's/\.h$//' | grep -vx transformesh
}

# headers_of CLIENT: the names of the library's headers that the client includes, except shapes.
headers_of() {
  sed -n 's|^#include <transformesh/\(.*\)\.h>$|\1|p' "$1" | grep -vx shapes || true
}

@test "a client of each public header compiles, links and runs from the installed tree" {
  clients=$tm_root/tests/install/clients
  diff <(public_headers) <(cd "$clients" && printf '%s\n' *.cpp | sed 's/\.cpp$//')
  for header in $(public_headers | grep -vx shapes); do
    [ "$(headers_of "$clients/$header.cpp")" = "$header" ] || fail "$header.cpp includes other headers"
  done
  [ -z "$(headers_of "$clients/shapes.cpp")" ]
  cmake -S "$clients" -B built -G Ninja "-DCMAKE_PREFIX_PATH=$prefix" >log 2>&1 || fail "$(cat log)"
  cmake --build built >>log 2>&1 || fail "$(grep -E 'FAILED|error' log)"
  for header in $(public_headers); do
    timeout 60 "built/client_$header" || fail "the client of $header.h returns $?"
  done
}
