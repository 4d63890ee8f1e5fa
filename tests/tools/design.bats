# docs/design and CONTRIBUTING.md: files and functions that the pages name exist, and design pages are short
# and have a figure.

load ../helpers/common

setup() {
  cd "$tm_root"
  pages=(docs/design/*.md CONTRIBUTING.md)
}

# spans PAGE: prints the texts between backticks outside of fences, one per line.
spans() {
  awk '/^```/ { fenced = !fenced; next } !fenced' "$1" | grep -oE '`[^`]+`' | tr -d '`' | sort -u
}

# every_path: prints all files and folders, with and without extensions.
every_path() {
  find lib include tools tests scripts docs man cmake python npm wasm -path tools/viewer/node_modules -prune -o -print |
    sed -E 'p; s|\.[a-z0-9]+$||'
}

@test "every path that a page names exists" {
  every_path | sort -u >"$BATS_TEST_TMPDIR/paths"
  for page in "${pages[@]}"; do
    while IFS= read -r path; do
      grep -qE "(^|/)${path//./[.]}\$" "$BATS_TEST_TMPDIR/paths" || fail "$page names $path"
    done < <(spans "$page" | grep -E '^[a-z0-9_-]+(/[a-z0-9_.-]+)+/?$' |
      grep -vE '^build' | sed 's|/$||')
  done
}

# The glossary of CONTRIBUTING.md names functions of other libraries as well.
@test "every function, type and key that a design page names is in the sources" {
  for page in docs/design/*.md; do
    while IFS= read -r name; do
      grep -rqwF -- "$name" lib include tools tests scripts python wasm || fail "$page names $name"
    done < <(spans "$page" | grep -E '^[A-Za-z_][A-Za-z0-9_:]*(\(\))?$' | grep -E '_|\(\)|[a-z][A-Z]' |
      sed -E 's/\(\)$//; s/.*:://')
  done
}

@test "every option that a design page names is one of a program" {
  cat tests/tools/golden/*.help >"$BATS_TEST_TMPDIR/help"
  for page in docs/design/*.md; do
    while IFS= read -r option; do
      grep -qE -- "(^|[ ,])$option\\b" "$BATS_TEST_TMPDIR/help" || fail "$page names $option"
    done < <(spans "$page" | grep -oE '(^|[ ])--[a-z-]+' | tr -d ' ')
  done
}

@test "a design page has at most 150 lines; those that follow data have a figure and say what can fail" {
  for page in docs/design/*.md; do
    [ "$(wc -l <"$page")" -le 150 ] || fail "$page is long"
  done
  for page in cleaning rounding open-meshes remeshing evolution morphing reconstruction; do
    grep -qE '^```$|^!\[' "docs/design/$page.md" || fail "$page has no figure"
    grep -qE '^## (What can fail|Limits|What is guaranteed)' "docs/design/$page.md" || fail "$page"
  done
}
