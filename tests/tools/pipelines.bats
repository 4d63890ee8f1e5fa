# Runs the pipelines of docs/recipes.md exactly as printed, and checks their results.

load ../helpers/common

setup_file() {
  export folder=$BATS_FILE_TMPDIR/recipes
  mkdir "$folder"
  cd "$folder"
  awk '/^```sh$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$tm_root/docs/recipes.md" \
    >"$BATS_FILE_TMPDIR/recipes.sh"
  bash "$BATS_FILE_TMPDIR/recipes.sh" >"$BATS_FILE_TMPDIR/stdout" 2>"$BATS_FILE_TMPDIR/stderr" || {
    cat "$BATS_FILE_TMPDIR/stderr"
    return 1
  }
}

setup() {
  cd "$folder"
}

volume() { tm-info --get volume "$1"; }

# expect EXPRESSION NUMBER...: checks an awk expression of the numbers $1 and so on.
expect() { # EXPRESSION NUMBER...
  local expression=$1
  shift
  echo "$*" | awk "{ exit !($expression) }" || fail "not so: $expression, with $*"
}

@test "to install are three lines: two scripts, and the folder of the programs" {
  awk '/^```bash$/ { inside = 1; next } /^```/ { inside = 0 } inside { sub(/ *#.*/, ""); print }' \
    "$tm_root/README.md" >lines
  diff lines - <<'LINES'
scripts/quickstart
scripts/check
export PATH=$PWD/build/bin:$PATH
LINES
  [ -x "$tm_root/scripts/quickstart" ] && [ -x "$tm_root/scripts/check" ]
}

@test "the README names every program and no other" {
  diff <(grep -oE '^\| `tm-[a-z-]+`' "$tm_root/README.md" | grep -oE 'tm-[a-z-]+' | sort) \
    <(cd "$tm_root" && ls tools/programs/tm-*.cpp | sed 's|.*/||; s/\.cpp$//' | sort)
}

@test "every result is a closed manifold without a self-intersection" {
  for mesh in union intersection difference body result now twisted turned repaired; do
    tm-checkmanifold --closed "$mesh.ply" >/dev/null || fail "$mesh.ply is not closed and manifold"
    tm-intersect --check "$mesh.ply" >/dev/null || fail "$mesh.ply intersects itself"
  done
}

@test "volumes of union, intersection and difference add up" {
  expect '($1 + $2 - $3 - $4) ^ 2 < 1e-24' "$(volume a.ply)" "$(volume b.ply)" \
    "$(volume union.ply)" "$(volume intersection.ply)"
  expect '($1 - $2 - $3) ^ 2 < 1e-24' "$(volume a.ply)" "$(volume intersection.ply)" \
    "$(volume difference.ply)"
  # The box sticks out of the sphere at both ends, so it drills a hole through it.
  [ "$(tm-info --get genus difference.ply)" -eq 1 ]
}

@test "the neck pinches off, and both balls stay" {
  [ "$(tm-info --get components body.ply)" -eq 2 ]
  expect '$1 > 0.2' "$(volume body.ply)"
}

@test "the morph finds three holes and the target" {
  [ "$(tm-info --get genus result.ply)" -eq 3 ]
  grep -q '"converged": true' report.json
  expect '$1 < $2' "$(tm-compare --reference target.ply result.ply | awk '/^hausdorff:/ { print $2 }')" \
    "$(tm-info --get edge_mean result.ply)"
  expect '$1 < $2' "$(volume now.ply)" "$(volume source.ply)"
}

@test "the box is twisted: its corners turn with their height, the volume stays" {
  expect '$1 > 0.97 * $2 && $1 < 1.03 * $2' "$(volume twisted.ply)" "$(volume twist.ply)"
  # The velocity is perpendicular to the radius, so corners move outwards slightly.
  expect '$1 > $4 && $2 > $5' "$(tm-info --get bbox_max twisted.ply)" \
    "$(tm-info --get bbox_max twist.ply)"
}

@test "the scan is repaired, and picture files are valid" {
  [ "$(tm-info --get components repaired.ply)" -eq 1 ]
  for picture in intersections evolution; do
    [ "$(head -c 4 "$picture.png" | tail -c 3)" = PNG ]
  done
}

@test "the Makefile made all files" {
  for shape in torus torus-knot bowl; do
    tm-checkmanifold --closed "$shape.clean.ply" >/dev/null
  done
  [ "$(tm-info --get genus torus.clean.ply)" -eq 1 ]
}
