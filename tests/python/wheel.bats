# The wheel: what is in it, and that it works in a fresh virtual environment without a network.

load ../helpers/common

# Says what is missing for making a wheel. bats 1.8 counts a skip in setup_file as a failure. A folder
# named build in the current directory is a module for Python, too.
missing() {
  if ! "$python" -c 'import build.__main__, ensurepip' 2>/dev/null; then
    echo "scripts/setup --package installs what makes wheels"
  elif ! ls "$tm_build"/python/transformesh/_transformesh.*.so >/dev/null 2>&1; then
    echo "the Python module is not built"
  fi
}

setup_file() {
  export python=/usr/bin/python3
  [ -z "$(missing)" ] || return 0
  cd "$tm_root"
  "$python" -m build --wheel --no-isolation -o "$BATS_FILE_TMPDIR/dist" -C "build=$tm_build" >"$BATS_FILE_TMPDIR/log" 2>&1 ||
    fail "$(tail -n 20 "$BATS_FILE_TMPDIR/log")"
}

setup() {
  [ -z "$(missing)" ] || skip "$(missing)"
  cd "$BATS_TEST_TMPDIR"
  wheel=$(echo "$BATS_FILE_TMPDIR"/dist/*.whl)
}

@test "its name says for which Python and which glibc it is, and it has at most 10 MB" {
  glibc=$(getconf GNU_LIBC_VERSION | sed 's/glibc //; s/\./_/')
  cp=$("$python" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')
  version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$tm_build/CMakeCache.txt")
  [ "${wheel##*/}" = "transformesh-$version-$cp-$cp-manylinux_${glibc}_$(uname -m).whl" ]
  [ "$(stat -c %s "$wheel")" -le 10000000 ]
}

@test "its module loads no library but those of libc, and shows no symbol but Python's" {
  unzip -q "$wheel"
  readelf --dynamic --wide transformesh/_transformesh.*.so | sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p' >needed
  grep -q '^libc\.so' needed
  run ! grep -vE '^(libc|libm|libpthread|ld-linux[-a-z0-9_]*)\.so\.[0-9]$' needed
  [ "$(nm -D --defined-only transformesh/_transformesh.*.so | awk '{ print $3 }')" = PyInit__transformesh ]
}

@test "RECORD has the hash and the size of every file, and the libraries' licences are there" {
  unzip -q "$wheel"
  while IFS=, read -r name hash size; do
    [ -n "$hash" ] || continue
    [ "$(stat -c %s "$name")" = "$size" ]
    [ "sha256=$(openssl dgst -sha256 -binary "$name" | basenc --base64url | tr -d '=')" = "$hash" ]
  done <transformesh-*.dist-info/RECORD
  [ "$(find . -type f | wc -l)" -eq "$(wc -l <"$(echo transformesh-*.dist-info/RECORD)")" ]
  for package in libgmp-dev libtiff-dev libcgal-dev pybind11-dev GPL-3; do
    [ -s "$(echo transformesh-*.dist-info/licenses/"$package")" ] || fail "$package"
  done
}

@test "a fresh virtual environment without a network installs it and runs the tutorial" {
  "$python" -m venv --system-site-packages fresh
  fresh/bin/pip --isolated install --quiet --no-index "$wheel"
  fresh/bin/python -c 'import transformesh; print(transformesh.__file__)' | grep -q "^$PWD/fresh/"
  awk '/^```python$/ { inside = 1; next } /^```/ { inside = 0 } inside' "$tm_root/docs/python.md" >tutorial.py
  [ "$(wc -l <tutorial.py)" -gt 20 ]
  env -u PYTHONPATH fresh/bin/python tutorial.py >log 2>&1 || fail "$(cat log)"
}
