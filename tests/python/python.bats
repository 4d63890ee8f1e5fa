# The Python module: its functions make what the programs make, byte for byte.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  [ -e "$tm_build/python/transformesh/__init__.py" ] || skip "the Python module is not built"
  ls "$tm_build"/python/transformesh/_transformesh.*.so >/dev/null 2>&1 || skip "the Python module is not built"
  export PYTHONPATH=$tm_build/python PYTHONDONTWRITEBYTECODE=1
  python=$(sed -n 's/^Python3_EXECUTABLE:[A-Z]*=//p' "$tm_build/CMakeCache.txt")
}

@test "pytest" {
  "$python" -m pytest -q -p no:cacheprovider "$tm_root/tests/python" >log 2>&1 || fail "$(cat log)"
  grep -q ' passed' log
}

@test "the tutorial runs as it is printed" {
  # Its Python lines, one after the other.
  awk '/^```python$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$tm_root/docs/python.md" >tutorial.py
  [ "$(wc -l <tutorial.py)" -gt 20 ]
  "$python" tutorial.py >log 2>&1 || fail "$(cat log)"
}

@test "every function has a type in the stubs and a docstring" {
  "$python" - "$tm_build/python/transformesh/__init__.pyi" <<'PYTHON'
import ast, sys
import transformesh

stubs = {node.name for node in ast.parse(open(sys.argv[1]).read()).body
         if isinstance(node, (ast.FunctionDef, ast.ClassDef))}
public = {name for name in transformesh.__all__}
assert stubs == public, stubs ^ public
for name in public:
    assert getattr(transformesh, name).__doc__, name
PYTHON
}
