# The portable tarball: its contents, its install.sh, and that its programs need no library of the system.

load ../helpers/common

# Says what prevents a tarball. bats 1.8 counts a skip in setup_file as a failure.
missing() {
  if ! grep -qx 'CMAKE_GENERATOR:INTERNAL=Ninja' "$tm_build/CMakeCache.txt"; then
    echo "the build is not Ninja's"
  elif readelf --program-headers --wide "$tm_build/bin/tm-clean" | grep -q INTERP; then
    echo "the programs are not static"
  elif ! command -v pandoc >/dev/null; then
    echo "pandoc is not installed"
  fi
}

setup_file() {
  [ -z "$(missing)" ] || return 0
  # Compresses with the least effort of xz, because this test does not check the size.
  TM_BUILD=$tm_build TM_DIST=$BATS_FILE_TMPDIR TM_XZ_PRESET=0 "$tm_root/scripts/packaging/tarball" \
    >"$BATS_FILE_TMPDIR/name" 2>"$BATS_FILE_TMPDIR/log" || fail "$(cat "$BATS_FILE_TMPDIR/log")"
  tar -xf "$(cat "$BATS_FILE_TMPDIR/name")" -C "$BATS_FILE_TMPDIR"
}

setup() {
  [ -z "$(missing)" ] || skip "$(missing)"
  cd "$BATS_TEST_TMPDIR"
  release=$(echo "$BATS_FILE_TMPDIR"/transformesh-*-linux-"$(uname -m)")
  to="$PWD/a folder of 'mine'"
}

programs() {
  (cd "$tm_root/tools/programs" && printf '%s\n' tm.cpp tm-*.cpp | sed 's/\.cpp$//')
}

@test "the tarball: every program in one static file without symbols, its man page and its completions" {
  diff <(programs | sort) <(ls "$release/bin" | sort)
  [ "$(find "$release/bin" -type f)" = "$release/bin/tm" ]
  readelf --program-headers --sections --wide "$release/bin/tm" >headers
  run ! grep -qE 'INTERP|\.symtab' headers
  for program in $(programs); do
    # The help must be that of the separate executable of the program in the build folder.
    "$release/bin/$program" --help | cmp - <("$tm_build/bin/$program" --help)
    [ -s "$release/share/man/man1/$program.1" ]
    [ -s "$release/share/bash-completion/completions/$program" ]
    [ -s "$release/share/zsh/site-functions/_$program" ]
    [ -s "$release/share/fish/vendor_completions.d/$program.fish" ]
  done
  [ -z "$(find "$release" ! -perm -go=r)" ]
  # Called by a name that is not a program, it lists the programs.
  cp "$release/bin/tm" other-name
  ./other-name | cmp - <("$release/bin/tm")
}

@test "the tarball: the licence of the project, and of each library that the programs contain" {
  cmp "$release/share/doc/transformesh/LICENSE" "$tm_root/LICENSE"
  cd "$release/share/doc/transformesh/licences"
  for text in libcgal-dev libeigen3-dev libboost*-dev nlohmann-json3-dev libgmp-dev libmpfr-dev libjpeg*-dev \
    libpng-dev libtiff-dev libpugixml-dev libminizip-dev zlib1g-dev libc6-dev libstdc++-*-dev GPL-3 LGPL-3; do
    [ -s "$text" ] || fail "$text"
  done
}

@test "install.sh: a pipeline, a man page and a completion from a folder with spaces; nothing stays" {
  "$release/install.sh" --prefix "$to" 2>said
  grep -qF "export PATH=\"$to/bin:\$PATH\"" said
  PATH="$to/bin:$PATH" bash -c 'tm-shape two-spheres --faces 500 | tm-clean | tm-info --get components' >components
  [ "$(<components)" = 1 ]
  if command -v man >/dev/null; then
    [ "$(env -u MANPATH PATH="$to/bin:/usr/bin:/bin" man -w tm-clean)" = "$to/share/man/man1/tm-clean.1" ]
  fi
  bash --norc -c 'source "$1" && complete -p tm-clean' - "$to/share/bash-completion/completions/tm-clean"
  "$release/install.sh" --prefix="$to" --uninstall
  [ -z "$(ls -A "$to")" ]
}

@test "install.sh: files of others stay, and those of a release before go" {
  mkdir -p "$to/bin" "$to/share/man/man1"
  echo mine >"$to/bin/mine"
  "$release/install.sh" --prefix "$to"
  echo old >"$to/share/man/man1/tm-old.1"
  echo share/man/man1/tm-old.1 >>"$to/share/transformesh/installed-files"
  "$release/install.sh" --prefix "$to"
  [ ! -e "$to/share/man/man1/tm-old.1" ]
  "$to/bin/tm-info" --version
  "$release/install.sh" --prefix "$to" --uninstall
  [ "$(cd "$to" && find . ! -type d)" = ./bin/mine ]
}

@test "install.sh: the default is ~/.local, or /usr/local as root; wrong words and places are refused" {
  run -2 "$release/install.sh" --prefx "$to"
  [[ $output == *"unknown argument '--prefx'; there are --prefix DIR, --uninstall and --help" ]]
  run -2 "$release/install.sh" --prefix
  [[ $output == *"--prefix needs a folder" ]]
  run -1 "$release/install.sh" --prefix /dev/null/below
  [[ $output == *"install.sh: cannot write to /dev/null/below" ]]
  run -1 "$release/install.sh" --prefix "$PWD" --uninstall
  [[ $output == *"nothing to remove: $PWD/share/transformesh/installed-files is missing" ]]
  "$release/install.sh" --help | grep -q -- --uninstall
  if [ "$(id -u)" -ne 0 ]; then
    HOME=$PWD/home "$release/install.sh"
    [ -x home/.local/bin/tm ]
  fi
}

@test "the programs run in a root with nothing else in it: no libc, no shell, no /proc" {
  [ "$(id -u)" -eq 0 ] || skip "needs root"
  mkdir root
  cp -P "$release"/bin/tm* root
  chroot root /tm-shape two-spheres --faces 500 >two.ply
  chroot root /tm-clean <two.ply >clean.ply
  chroot root /tm-remesh <clean.ply >even.ply
  chroot root /tm-checkmanifold --closed <even.ply
  tm-clean <two.ply | cmp - clean.ply
}

@test "the same build gives the same tarball" {
  TM_BUILD=$tm_build TM_DIST=$PWD TM_XZ_PRESET=0 "$tm_root/scripts/packaging/tarball" 2>/dev/null
  cmp transformesh-*.tar.xz "$(cat "$BATS_FILE_TMPDIR/name")"
}
