# Meshes of any size are measured or refused with a message, and no number is nan or inf.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# tetrahedron_of SIZE: prints a tetrahedron as OFF, with edges of about this length.
tetrahedron_of() {
  printf 'OFF\n4 4 0\n'
  printf '%s %s %s\n' 0 0 0 "$1" "$1" 0 "$1" 0 "$1" 0 "$1" "$1"
  printf '3 %s\n' '0 1 2' '0 3 1' '0 2 3' '1 3 2'
}

has_only_numbers() {
  local size code
  for size in 1e-300 1e-160 1e-100 1e77 1e100 1e155 1e300; do
    tetrahedron_of "$size" >sized.off
    code=0
    timeout 60 "$program" "${arguments[@]//TARGET/sized.off}" --report report sized.off >out 2>err || code=$?
    case $code in
      0) cat out report >>numbers ;;
      1 | 3 | 4) one_line "$(cat err)" ;;
      *) fail "$size: exit code $code" ;;
    esac
    [ ! -e numbers ] || ! grep -aiwE 'nan|inf' numbers || fail "$size: a number is none"
    rm -f numbers report
  done
}
@test "no program writes nan or inf for meshes of any size" {
  while read -r program arguments; do
    read -ra arguments <<<"$arguments"
    has_only_numbers || fail "$program ${arguments[*]}"
  done <<'TABLE'
tm-align --reference TARGET
tm-carry --from TARGET --closest
tm-cat
tm-checkmanifold
tm-clean
tm-compare --reference TARGET
tm-convert
tm-displace --normal-speed 1%
tm-evolve --step cat --iterations 1 --format off
tm-fill
tm-flow mean-curvature
tm-flow surface-diffusion --span 1e-3
tm-handles
tm-info
tm-intersect
tm-morph --target TARGET --iterations 1 --format off
tm-morph-step --target TARGET
tm-offset --distance 5%
tm-photograph --ring 2 --size 40x30
tm-remesh
tm-repair
tm-render
tm-sample --count 100
tm-sample --distance 5%
tm-select --largest 1
tm-select --around 1,1,1
tm-stitch
tm-transform --center
tm-wrap
TABLE
}

@test "tm-info measures what numbers can hold, and refuses the rest by name" {
  tetrahedron_of 1e100 >large.off
  awk -v a="$(tm-info --get area large.off)" -v v="$(tm-info --get volume <(tetrahedron_of 1e-90))" \
    'BEGIN { exit !(a > 3.4641e200 && a < 3.4642e200 && v > 3.3333e-271 && v < 3.3334e-271) }'
  tm-info --get angle_min large.off | awk '{ exit !($1 > 59.999 && $1 < 60.001) }'
  tetrahedron_of 1e110 >large.off
  for options in '' '--json' '--get volume'; do
    run --separate-stderr tm-info $options large.off
    assert_status 3
    one_line "$stderr"
    [[ $stderr == *"the volume of the mesh is beyond the range of double precision"* ]]
    [ -z "$output" ]
  done
}
