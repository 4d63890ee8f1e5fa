#!/usr/bin/env bats
# Velocities of flows, checked by awk.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# rows MESH: prints x y z vx vy vz of each vertex.
rows() {
  tm-convert -q --no-provenance --format ply-ascii "$1" | awk '
    /^property/ && !lists { if ($2 == "list") lists = 1; else name[++columns] = $3 }
    /^element face/ { lists = 1 }
    /^element vertex/ { count = $3 }
    body && row++ < count {
      for (i = 1; i <= columns; ++i) value[name[i]] = $i
      print value["x"], value["y"], value["z"], value["vx"], value["vy"], value["vz"]
    }
    /^end_header/ { body = 1 }'
}

# uniform_vti NAME VX [TIME]: writes velocities VX 0 0 in the box from -1 to 1.
uniform_vti() {
  {
    echo '<VTKFile type="ImageData" byte_order="LittleEndian">'
    [ -z "${3-}" ] || echo "<FieldData><DataArray Name=\"TimeValue\" type=\"Float64\" format=\"ascii\">$3</DataArray></FieldData>"
    echo '<ImageData WholeExtent="0 1 0 1 0 1" Origin="-1 -1 -1" Spacing="2 2 2">'
    echo '<Piece Extent="0 1 0 1 0 1"><PointData Vectors="v">'
    echo '<DataArray Name="v" type="Float64" NumberOfComponents="3" format="ascii">'
    for _ in 1 2 3 4 5 6 7 8; do echo "$2 0 0"; done
    echo '</DataArray></PointData></Piece></ImageData></VTKFile>'
  } >"$1"
}

@test "Enright's deformation is the formula, by awk, at its time" {
  tm-shape sphere --radius 0.15 --center 0.35,0.35,0.35 --faces 500 -o ball.ply
  tm-flow deformation --time 0.7 ball.ply -o flow.ply
  rows flow.ply >rows.txt
  [ "$(wc -l <rows.txt)" -gt 200 ]
  awk 'function square(x) { return x * x }
    function differs(a, b) { return a - b > 1e-12 || b - a > 1e-12 }
    { pi = atan2(0, -1); c = cos(pi * 0.7 / 3)
      u = 2 * square(sin(pi * $1)) * sin(2 * pi * $2) * sin(2 * pi * $3) * c
      v = -sin(2 * pi * $1) * square(sin(pi * $2)) * sin(2 * pi * $3) * c
      w = -sin(2 * pi * $1) * sin(2 * pi * $2) * square(sin(pi * $3)) * c
      if (differs(u, $4) || differs(v, $5) || differs(w, $6)) exit 1 }' rows.txt
}

@test "a step of mean-curvature flow shrinks a sphere, and --speed is a factor" {
  tm-shape sphere --faces 5000 -o ball.ply
  tm-flow mean-curvature ball.ply --report r.json -o flow.ply
  jq -e '.result | .max_speed > 1.98 and .max_speed < 2.02 and .rms_speed > 1.99 and .fixed == 0' r.json
  tm-flow mean-curvature --speed 3 ball.ply --report r.json -o flow.ply
  jq -e '.result | .rms_speed > 5.97 and .rms_speed < 6.03' r.json
  # The span is the lifetime of the sphere. The closed form of the step on a sphere leaves .35763 of the radius.
  tm-flow mean-curvature --span 0.25 ball.ply | tm-displace --time-step 0.25 --alpha 99 -q -o small.ply
  tm-info --get volume small.ply | awk '{ r = ($1 * 3 / 4 / atan2(0, -1)) ^ (1 / 3); exit !(r > 0.357 && r < 0.359) }'
}

@test "flows at constant volume keep it" {
  tm-shape sphere --noise 5% --faces 3000 -o bumpy.ply
  before=$(tm-info --get volume bumpy.ply) area=$(tm-info --get area bumpy.ply)
  for flow in volume-preserving-curvature surface-diffusion; do
    tm-flow "$flow" --span 0.001 bumpy.ply | tm-displace --time-step 0.001 --alpha 99 -q -o smooth.ply
    tm-info --get volume smooth.ply | awk -v v="$before" '{ d = $1 / v - 1; exit !(d < 1e-9 && d > -1e-9) }'
    tm-info --get area smooth.ply | awk -v a="$area" '{ exit !($1 < 0.999 * a) }'
  done
}

@test "a grid is sampled, and what is outside of it is counted" {
  uniform_vti wind.vti 2
  tm-shape sphere --radius 0.9 --faces 500 -o inside.ply
  run --separate-stderr tm-flow grid --grid wind.vti inside.ply -o flow.ply
  assert_status 0
  [ -z "$stderr" ]
  rows flow.ply | awk '$4 != 2 || $5 != 0 || $6 != 0 { exit 1 }'
  tm-shape sphere --radius 1.5 --faces 500 -o outside.ply
  run --separate-stderr tm-flow grid --grid wind.vti --report r.json outside.ply -o flow.ply
  assert_status 0
  [[ $stderr == *" vertices outside of the grid took the value at the nearest point of the grid" ]]
  expected=$(rows flow.ply | awk '{ for (i = 1; i <= 3; ++i) if ($i > 1 || $i < -1) { ++n; next } } END { print n }')
  [ "$(jq .result.outside r.json)" -eq "$expected" ]
}

@test "files in a folder are time steps, by the times that they state or by --grid-step" {
  mkdir wind
  uniform_vti wind/a-9.vti 0 0
  uniform_vti wind/a-10.vti 4 2
  tm-shape sphere --radius 0.9 --faces 100 -o ball.ply
  has_speed() { # SPEED OPTION...
    tm-flow grid "${@:2}" ball.ply --report r.json -o flow.ply
    jq -e --argjson speed "$1" '.result.max_speed == $speed' r.json
  }
  has_speed 1 --grid wind --time 0.5
  has_speed 2 --grid 'wind/a-*.vti' --time 0.5 --grid-step 1
  run --separate-stderr tm-flow grid --grid wind --time 3 ball.ply -o flow.ply
  assert_status 0
  [[ $stderr == *"after the last one"* ]]
  uniform_vti wind/a-11.vti 4
  run --separate-stderr tm-flow grid --grid wind ball.ply -o none.ply
  assert_status 3
  [[ $stderr == *"one of 3 grids does not state its time: give the time between consecutive grids" ]]
  tm-flow grid --grid wind --grid-step 1 ball.ply -o flow.ply
}

@test "normal motion takes its speed from a column" {
  tm-shape box 1 1 1 --faces 3000 -o box.ply
  tm-flow normal --speed -1 box.ply | tm-displace --time-step 0.01 --alpha 99 -q -o small.ply
  tm-info --get volume small.ply | awk '{ d = $1 - 0.98 ^ 3; exit !(d < 1e-6 && d > -1e-6) }'
  # The column vx is 2 * (z - 0.5), and the normal of the top (0, 0, 1).
  tm-flow shear --speed 2 box.ply | tm-flow normal --column vx --report r.json -o flow.ply
  rows flow.ply | awk '$3 > 0.49 && $1 * $1 < 0.2 && $2 * $2 < 0.2 && ($6 > 1e-6 || $6 < -0.03) { exit 1 }'
  rows flow.ply | awk '$3 < -0.49 && $1 * $1 < 0.2 && $2 * $2 < 0.2 { ++n; if ($6 < 1.96 || $6 > 2.04) exit 1 } END { exit !n }'
  run --separate-stderr tm-flow normal --column nothing box.ply -o none.ply
  assert_status 3
  [[ $stderr == *"no vertex property 'nothing'"* ]]
}

@test "--list names each flow, and each of them runs or says what it needs" {
  tm-flow --list >list
  [ "$(wc -l <list)" -eq 12 ]
  tm-shape sphere --faces 500 -o ball.ply
  uniform_vti wind.vti 1
  while read -r name _; do
    grid=()
    [ "$name" != grid ] || grid=(--grid wind.vti)
    tm-flow -q "$name" "${grid[@]}" ball.ply -o flow.ply || fail "$name"
    [ "$(rows flow.ply | wc -l)" -gt 200 ]
  done <list
}

@test "mistakes are reported, and the advice is true" {
  tm-shape sphere --faces 500 -o ball.ply
  refuses() { # CODE WORDS OPTION...
    run --separate-stderr tm-flow "${@:3}" -o none.ply
    assert_status "$1"
    [[ $stderr == "tm-flow: "*"$2"* ]] || fail "$stderr"
    [ ! -e none.ply ]
  }
  refuses 2 "did you mean 'deformation'" deformaton ball.ply
  refuses 2 "the flow 'abc' has no parameter 'period'" abc --period 2 ball.ply
  refuses 2 "above 0" mean-curvature --speed=-1 ball.ply
  refuses 2 "the flow has no grid: name its files" grid ball.ply
  refuses 2 "but no grids" grid --grid-step 1 ball.ply
  run --separate-stderr tm-flow abc --span 1 ball.ply -o flow.ply
  assert_status 0
  [ "$stderr" = "tm-flow: the flow is not computed in steps: --span has no effect" ]
  refuses 3 "no such file" grid --grid none.vti ball.ply
  refuses 3 "neither" grid --grid ball.ply ball.ply
  tm-select --box=-2,-2,-2,2,2,0 ball.ply -o bowl.ply
  refuses 3 "the mesh is open: it has no volume to keep" volume-preserving-curvature bowl.ply
  tm-flow mean-curvature --report r.json bowl.ply -o flow.ply
  [ "$(jq .result.fixed r.json)" -gt 10 ]
}
