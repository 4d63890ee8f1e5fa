# The Blender add-on in Blender's background mode: results, materials, places of operands, messages.

load ../helpers/common

@test "the commands of the add-on" {
  needs_command blender
  cd "$BATS_TEST_TMPDIR"
  HOME=$PWD blender --background --factory-startup --python-exit-code 1 --python "$tm_root/tests/python/blender_checks.py" \
    -- "$tm_root/python/blender" >log 2>&1 </dev/null || fail "$(tail -n 20 log)"
  grep -q '^all Blender tests passed$' log
}
