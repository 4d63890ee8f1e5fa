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

# python_lines PAGE: its Python lines, one after the other.
python_lines() {
  awk '/^```python$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$tm_root/docs/$1"
}

@test "the tutorial runs as it is printed" {
  python_lines python.md >tutorial.py
  [ "$(wc -l <tutorial.py)" -gt 20 ]
  "$python" tutorial.py >log 2>&1 || fail "$(cat log)"
}

@test "a film of a velocity in Python takes fifteen lines, which run as they are printed" {
  python_lines evolution.md >tutorial.py
  [ "$(sed '/^sheet = /q' tutorial.py | grep -c .)" -le 15 ]
  # Seven panels side by side, none of which is empty.
  cat >>tutorial.py <<'PYTHON'
assert sheet.shape == (300, 1500, 4)
for panel in np.array_split(sheet, len(frames), axis=1):
    assert panel[150].std(axis=0).max() > 5
# The film shows the sheet half way, of more area than the ball.
areas = [tm.info(frame)["area"] for frame in frames]
assert max(areas) == areas[3] > 1.5 * areas[0]
PYTHON
  "$python" tutorial.py >log 2>&1 || fail "$(cat log)"
}

@test "every function has types and a docstring" {
  "$python" - "$tm_build/python/transformesh/_transformesh.pyi" <<'PYTHON'
import ast, inspect, sys
import transformesh

compiled = {node.name for node in ast.parse(open(sys.argv[1]).read()).body if isinstance(node, ast.ClassDef)}
errors = {name for name in transformesh.__all__ if inspect.isclass(getattr(transformesh, name))
          and issubclass(getattr(transformesh, name), transformesh.Error)}
classes = compiled | errors
functions = {name for name in transformesh.__all__ if inspect.isfunction(getattr(transformesh, name))}
assert classes | functions == set(transformesh.__all__), (classes | functions) ^ set(transformesh.__all__)
for name in transformesh.__all__:
    assert getattr(transformesh, name).__doc__, name
for name in functions:
    signature = inspect.signature(getattr(transformesh, name))
    assert signature.return_annotation is not inspect.Signature.empty, name
    for parameter in signature.parameters.values():
        assert parameter.annotation is not inspect.Parameter.empty, (name, parameter)
PYTHON
}
