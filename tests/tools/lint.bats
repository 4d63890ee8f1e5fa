# The checks of scripts/lint find the defects that they are meant for, and accept everything else.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  checks=$tm_root/scripts/checks
}

@test "two types of one name in a namespace are found" {
  printf '%s\n' 'namespace a {' 'struct Part { int x; };' 'namespace {' 'struct Own {};' '}' '}' >first.h
  printf '%s\n' 'namespace a {' 'class Part;' 'struct Part::Inner {};' 'namespace {' 'struct Own {};' '}' '}' >second.cpp
  python3 "$checks/duplicate_types.py" first.h second.cpp
  printf '%s\n' 'namespace a {' '// struct Part {' 'enum class Part { x };' '}' >third.cpp
  run ! python3 "$checks/duplicate_types.py" first.h second.cpp third.cpp
  [[ $output == *'a::Part is defined in first.h:2 and third.cpp:3'* ]]
  [[ $output != *Own* ]]
}

@test "types of the global namespace, in extern \"C\" and by typedef are found" {
  printf '%s\n' 'extern "C" {' 'struct Part { int x; };' '}' 'namespace a { struct Other {}; }' >first.h
  python3 "$checks/duplicate_types.py" first.h
  printf '%s\n' 'struct Part { long x; };' 'typedef int Other;' >second.h
  run ! python3 "$checks/duplicate_types.py" first.h second.h
  [[ $output == *'second.h:2: a typedef'*'Part is defined in first.h:2 and second.h:1'* ]]
  [[ $output != *a::Other* ]]
}

@test "algorithms of std::ranges that the WebAssembly build does not have are found" {
  printf '%s\n' 'bool is_in = std::ranges::find(a, 3) != a.end();' 'std::ranges::sort(a);' >first.cpp
  "$checks/ranges.sh" first.cpp
  echo 'std::ranges::rotate(a, a.begin() + 1);' >second.cpp
  run ! "$checks/ranges.sh" first.cpp second.cpp
  [[ $output == *'second.cpp uses std::ranges::rotate, which'* ]]
  [[ $output != *first.cpp* ]]
}

@test "names of options and programs in strings are found" {
  printf '%s\n' '// mend it by tm-stitch --orient' 'int f(int i) { return --i; }' \
    'const char* page = "<!--tm:title-->";' 'const char* text = "not oriented";' >clean.cpp
  python3 "$checks/options.py" clean.cpp
  echo 'const char* text = "orient it with tm-stitch --orient";' >option.cpp
  run ! python3 "$checks/options.py" option.cpp
  [[ $output == *'option.cpp:1: a string names tm-stitch'*'option.cpp:1: a string names --orient'* ]]
}

@test "names of options are found behind digit separators and escapes, and in raw strings" {
  printf '%s\n' "int a = 1'000; char b = '\"'; const char* c = \"use --first\";" \
    'const char* d = "line\n--second";' 'const char* e = R"(use --third)";' >option.cpp
  run ! python3 "$checks/options.py" option.cpp
  [[ $output == *'option.cpp:1: a string names --first'*'2: a string names --second'*'3: a string names --third'* ]]
}

@test "public headers that are long, or include what is private, are found" {
  mkdir -p include/transformesh
  printf '%s\n' '#pragma once' '#include <vector>' '#include <Eigen/Core>' >include/transformesh/a.h
  "$tm_root/scripts/lint" --headers "$PWD/include"
  printf '%s\n' '#pragma once' '#include "mesh/private.h"' >include/transformesh/b.h
  seq -f '// %g' 61 >include/transformesh/c.h
  run ! "$tm_root/scripts/lint" --headers "$PWD/include"
  [[ $output == *'b.h includes a header that is not public'* ]]
  [[ $output == *'c.h has more than 60 lines'* ]]
}

@test "private includes are found however they are written, and headers in subfolders" {
  mkdir -p include/transformesh/inner
  printf '%s\n' '#pragma once' '#  include  <CGAL/number_utils.h>' >include/transformesh/a.h
  printf '%s\n' '#pragma once' '#include <CGAL>' >include/transformesh/b.h
  printf '%s\n' '#pragma once' >include/transformesh/inner/c.h
  run ! "$tm_root/scripts/lint" --headers "$PWD/include"
  [[ $output == *'a.h includes a header that is not public'* ]]
  [[ $output == *'b.h includes a header that is not public'* ]]
  [[ $output == *'c.h is not in'* ]]
}

# A repository with one commit.
make_repository() {
  git init -q repository
  cd repository
  git config user.email x@example.com
  git config user.name x
  printf '%s\n' '/// Of old.' 'int old;' >old.h
  git add old.h
  git commit -qm 'Begin'
  begin=$(git rev-parse HEAD)
}

@test "comments that begin with a word that refers to something else are found" {
  make_repository
  printf '%s\n' '/// Number of faces.' 'int a;  ///< of old' '/// Where old is, e.g. here. Then more.' >new.h
  printf '%s\n' 'int a;  // it is old' "/// Reference: A $(printf 'word %.0s' {1..40})" >other.h
  run ! python3 "$checks/prose.py" "$begin" old.h new.h other.h
  [[ $output == *"old.h:1: begins with 'Of'"*"new.h:2: begins with 'of'"*"new.h:3: begins with 'Where'"* ]]
  [[ $output == *"other.h:1: begins with 'it'"* ]]
  [ "$(wc -l <<<"$output")" -eq 4 ]
}

@test "constants of the library without a comment are found" {
  make_repository
  mkdir lib
  printf '%s\n' 'constexpr double a = 0.5;' '' '/// Chosen on spheres.' 'constexpr int b = 3;' \
    'constexpr int c = 4;' 'constexpr int d = 5;  // six would not fit' 'constexpr int e = b * c;' '' \
    'static constexpr std::size_t f =' '    2 * b;' 'constexpr Color white{255, 255, 255};' \
    'constexpr double half(double x) { return x / 2; }' >lib/constants.h
  cp lib/constants.h elsewhere.h
  run ! python3 "$checks/prose.py" "$begin" lib/constants.h elsewhere.h
  [ "$(wc -l <<<"$output")" -eq 2 ]
  [[ $output == *'lib/constants.h:1: a constant without a reason'*'lib/constants.h:9: '* ]]
}

@test "sentences of more than thirty words and long subjects are found" {
  make_repository
  words=$(printf 'word %.0s' {1..28})
  printf '%s\n' "# Title" "" "A ${words}ends." "" '```' "A ${words}${words}ends" '```' >text.md
  python3 "$checks/prose.py" "$begin" text.md
  printf '%s\n' "A ${words}word" "ends. Short." >text.md
  git commit -q --allow-empty -m "$(printf 'x%.0s' {1..72})"
  run ! python3 "$checks/prose.py" "$begin" text.md
  [ "$(wc -l <<<"$output")" -eq 1 ]
  [[ $output == *'text.md:1: a sentence of 31 words'* ]]
  git commit -q --allow-empty -m "$(printf 'x%.0s' {1..73})"
  run ! python3 "$checks/prose.py" "$begin"
  [[ $output == *'a subject of 73 characters'* ]]
}

@test "strings, here-documents and HTML comments are not prose; list items are sentences of their own" {
  make_repository
  words=$(printf 'word %.0s' {1..20})
  printf '%s\n' 'cat <<END' "# Of $words$words" 'END' "x='" "# Of old" "'" >text.bash
  printf '%s\n' 'const char* raw = R"(' "// Of old." ')";' >text.cpp
  printf '%s\n' "# Title" "<!-- $words" "$words -->" "(A ${words}.) B $words." >text.md
  printf '%s\n' '/// Reads:' "/// - one $words" "/// - two $words" >list.h
  python3 "$checks/prose.py" "$begin" text.bash text.cpp text.md list.h
}
