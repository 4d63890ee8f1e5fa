# The texts of errors, warnings and notes of library and programs, in one file that is read as a diff.

load ../helpers/common

collect() {
  (cd "$tm_root" && find lib tools -name '*.cpp' -o -name '*.h' | grep -v node_modules | sort |
    xargs python3 scripts/checks/messages.py tests/tools/golden/*.help --)
}

@test "the messages are those of the golden file; scripts/update-golden accepts changes" {
  collect | diff "$tm_root/tests/tools/golden/messages.txt" -
}

@test "literals that are joined are one message, and expressions are ellipses" {
  cd "$BATS_TEST_TMPDIR"
  cat >sample.cpp <<'CPP'
void f() {
  throw InputError(Kind::open, "face " + std::to_string(f) + " has no edge" " at all", {.faces = {f}});
  note(counted(n, "vertex") + " of the mesh dropped");
  run(is_open ? "the mesh is open" : "the mesh is closed");  // a comment of "some words here"
  options.add("edge", "an option of the help");
}
CPP
  echo 'shows an option of the help' >help
  python3 "$tm_root/scripts/checks/messages.py" help -- sample.cpp | diff - <(cat <<'LINES'
sample.cpp: face … has no edge at all
sample.cpp: … vertex of the mesh dropped
sample.cpp: the mesh is open
sample.cpp: the mesh is closed
LINES
)
}

@test "messages end without a full stop" {
  run ! grep -E '[^.]\.$' <(grep -v ': Exit codes:' "$tm_root/tests/tools/golden/messages.txt")
}
