# The calls of docs/reference.md run as they are printed, in one folder.

load ../helpers/common

# blocks LANGUAGE: prints the lines of the page's blocks in a language.
blocks() {
  awk -v fence="\`\`\`$1" '$0 == fence { inside = 1; next } /^```/ { inside = 0 } inside' "$tm_root/docs/reference.md"
}

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  blocks sh >commands
  bash -e commands >stdout 2>stderr || fail "$(cat stderr)"
}

setup() {
  cd "$BATS_FILE_TMPDIR"
}

@test "reference: there are twenty calls, numbered, and each mesh that they write is there" {
  diff <(grep -oE '# [0-9]+' commands | tr -d '# ') <(seq 20)
  for file in $(grep -oE -- '-o [a-z]+\.[a-z]+' commands | cut -d ' ' -f 2); do
    [ -s "$file" ] || fail "$file"
  done
}

@test "reference: results are what the comments say" {
  run ! tm-intersect --check two.ply
  tm-intersect --check solid.ply
  for file in solid repaired filled cut even light close thick morphed; do
    tm-checkmanifold --closed "$file.ply" >/dev/null || fail "$file.ply is not closed"
  done
  run ! tm-checkmanifold --closed half.ply
  [ "$(tm-info --get faces light.ply)" -le 500 ]
  [ "$(tm-info --get genus morphed.ply)" = 1 ]
  awk -v one="$(tm-info --get volume solid.ply)" -v more="$(tm-info --get volume scaled.ply)" \
    'BEGIN { exit !(more / one > 25.4 ^ 3 * 0.999999 && more / one < 25.4 ^ 3 * 1.000001) }'
  [ "$(head -c 4 picture.png | tail -c 3)" = PNG ]
}

@test "reference: the lines of Python run" {
  ls "$tm_build"/python/transformesh/_transformesh.*.so >/dev/null 2>&1 || skip "the Python module is not built"
  python=$(sed -n 's/^Python3_EXECUTABLE:[A-Z]*=//p' "$tm_build/CMakeCache.txt")
  blocks python >lines.py
  PYTHONPATH=$tm_build/python PYTHONDONTWRITEBYTECODE=1 "$python" lines.py >log 2>&1 || fail "$(cat log)"
}
