# docs/features.md: every yes for this suite names existing tests, and every statement about others a page.

load ../helpers/common

page=$tm_root/docs/features.md

# Prints the second cell of every row, which is that of this suite.
our_cells() {
  awk -F' *[|] *' '/^\| [^|]/ && $3 != "tm" { print $3 }' "$page"
}

# Prints the lines `7. file: name` without the number.
named_tests() {
  sed -nE 's/^[0-9]+\. `([^`]+)`: (.*)/\1\t\2/p' "$page"
}

# Tests whether the file has a test of this name.
has_test() { # FILE NAME
  case $1 in
    *.bats) grep -qF "@test \"$2\" {" "$tm_root/$1" ;;
    *.cpp) grep -qF "TEST_CASE(\"$2\")" "$tm_root/$1" ;;
    *.py) grep -qF "def $2(" "$tm_root/$1" ;;
    *) false ;;
  esac
}

@test "ours is a yes with the numbers of its tests, or a plain no" {
  [ "$(our_cells | wc -l)" -gt 40 ]
  our_cells | grep -q '^no$'
  run ! grep -vE '^(no|yes [0-9]+(, [0-9]+)*)$' <(our_cells)
  # Tests are numbered consecutively, and every number refers to a test.
  diff <(our_cells | grep -oE '[0-9]+' | sort -nu) <(sed -nE 's/^([0-9]+)\. .*/\1/p' "$page")
  diff <(named_tests | wc -l) <(our_cells | grep -oE '[0-9]+' | sort -nu | wc -l)
}

@test "every test that backs a yes exists" {
  while IFS=$'\t' read -r file name; do
    has_test "$file" "$name" || fail "$file has no test '$name'"
  done < <(named_tests)
  run ! has_test tests/tools/tm-clean.bats "two balls become three"
}

@test "what is said of others links to a page; everything else is a question mark" {
  awk -F' *[|] *' '/^\| [^|]/ && $3 != "tm" { for (i = 4; i < NF; ++i) print $i }' "$page" >cells
  [ -s cells ]
  run ! grep -vE '^(\?|\[[^]]+\]\[[a-z0-9-]+\])$' cells
  diff <(grep -oE '\]\[[a-z0-9-]+\]' cells | tr -d '[]' | sort -u) \
    <(sed -nE 's|^\[([a-z0-9-]+)\]: https://.*|\1|p' "$page" | sort)
}

@test "every row has a cell for everyone, and the README leads to the page" {
  run ! awk -F'|' '/^\|/ && NF != 10 { print; found = 1 } END { exit !found }' "$page"
  grep -qF '(docs/features.md)' "$tm_root/README.md"
}

setup() {
  cd "$BATS_TEST_TMPDIR"
}
