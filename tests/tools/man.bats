# Every program has a man page that lists exactly the options of its --help.

load ../helpers/common

programs() {
  (cd "$tm_root/tools/programs" && printf '%s\n' tm.cpp tm-*.cpp | sed 's/\.cpp$//')
}

# Prints the long options that start an entry of the help.
options_of_help() {
  "$1" --help | sed -nE 's/^  (-[a-zA-Z], )?--([a-z0-9-]+).*/\2/p' | sort
}

# Prints the long options in the terms of the page's definition lists, fragments included.
options_of_page() {
  grep -B1 '^:   ' "$tm_build/man/$1.1.md" | grep '^\*\*\\*-' |
    grep -oE '\*\*\\?--[a-z0-9-]+' | sed -E 's/^\*\*\\?--//' | sort
}

@test "every program has a page with exactly its options" {
  for program in $(programs); do
    [ -e "$tm_root/man/$program.1.md" ] || fail "man/$program.1.md is missing"
    diff <(options_of_help "$program") <(options_of_page "$program") ||
      fail "man/$program.1.md (>) differs from $program --help (<)"
  done
}

@test "every page has the fixed sections" {
  for program in $(programs); do
    for section in NAME SYNOPSIS DESCRIPTION OPTIONS REPORT EXAMPLES "EXIT STATUS" "SEE ALSO"; do
      grep -qx "# $section" "$tm_build/man/$program.1.md" || fail "$program.1: no $section"
    done
  done
}

@test "every page becomes a man page that names its program" {
  needs_command pandoc
  for program in $(programs); do
    page=$tm_build/share/man/man1/$program.1
    head -n 20 "$page" | grep -qi "^\.TH .*${program//-/.*}" || fail "$page"
  done
}

@test "every page fits a terminal of 80 columns" {
  needs_command pandoc
  needs_command man
  for page in "$tm_build"/share/man/man*/*.[17]; do
    warnings=$(MANWIDTH=80 man -l --warnings=all "$page" 2>&1 >/dev/null)
    [ -z "$warnings" ] || fail "$page: $warnings"
  done
}

@test "the suite's page names every program" {
  for program in $(programs); do
    grep -q "$program" "$tm_root/man/tm.7.md" || fail "man/tm.7.md does not name $program"
  done
}

# Pages that are being rewritten.
to_do='tm-cameras tm-wrap'

@test "the description of every page says what goes in and out first, and then when to use the program" {
  for program in $(programs); do
    if [[ " $to_do " == *" $program "* ]]; then continue; fi
    sed -n '/^# DESCRIPTION/,/^# OPTIONS/p' "$tm_root/man/$program.1.md" | awk -v RS= '
      NR == 2 { is_first = /^(\*\*split\*\* reads|Reads|Makes|Prints) / }
      NR <= 5 && /^(Use it|To choose)/ { is_used = 1 }
      END { exit !(is_first && is_used) }' || fail "$program.1"
  done
}

@test "no parenthesis of a page is longer than ten words" {
  for page in "$tm_root"/man/*.md "$tm_root"/man/fragments/*.md; do
    if [[ " $to_do " == *" $(basename "$page" .1.md) "* ]]; then continue; fi
    long=$(grep -v '^    ' "$page" | grep -oE '\([^()]*\)' | awk 'NF > 11')
    [ -z "$long" ] || fail "$page: $long"
  done
}
