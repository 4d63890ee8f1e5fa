load ../helpers/common

setup() { cd "$BATS_TEST_TMPDIR"; }

# value KEY FILE: prints a number of a report.
value() {
  awk -v key="\"$1\":" '$1 == key { gsub(",", "", $2); print $2 }' "$2"
}

# A textured sphere with a dent that no silhouette shows, photographed by a ring of cameras.
photograph_truth() {
  tm-shape dented --faces 5000 -o truth.ply
  mkdir photos masks
  tm-photograph --size 160x120 --ring 16 --write-images photos --write-silhouettes masks \
    -o par.txt truth.ply
}

# accuracy FILE: prints the distance from the truth that 90 % of the mesh do not exceed.
accuracy() { tm-compare --reference truth.ply "$1" | awk '$1 == "accuracy:" { print $2 }'; }

# less A B: tests whether A < B.
less() { awk -v a="$1" -v b="$2" 'BEGIN { exit !(a < b) }'; }

@test "steps at finer and finer scales lead from the hull to the true surface" {
  photograph_truth
  tm-hull --cameras par.txt --silhouettes masks --resolution 40 -o hull.ply
  tm-cameras --list --images photos --report cameras.json -o /dev/null par.txt
  pixel=$(value pixel_size cameras.json)
  cp hull.ply a.ply
  for scale in 4 2.83 2 1.41 1; do
    low=$(awk "BEGIN { print 2 * $pixel * $scale }")
    tm-remesh --iterations 2 --min-edge "$low" --max-edge "$(awk "BEGIN { print 2 * $low }")" \
      --feature-angle 180 a.ply |
      tm-photo-step --cameras par.txt --images photos --silhouettes masks --scale "$scale" \
        --iterations 6 --alternate --report "$scale.json" | tm-clean -o b.ply
    mv b.ply a.ply
    [ "$(value lost_coverage "$scale.json")" = false ]
  done
  less "$(value last_dissimilarity 4.json)" "$(value dissimilarity 4.json)"
  less "$(accuracy a.ply)" "$(awk "BEGIN { print 0.5 * $(accuracy hull.ply) }")" ||
    fail "from $(accuracy hull.ply) to $(accuracy a.ply)"
  tm-checkmanifold --closed a.ply
  tm-intersect --check a.ply
}

@test "the true surface nearly stays, for any gains and offsets of the photographs" {
  photograph_truth
  mkdir lit
  tm-photograph --cameras par.txt --size 160x120 --gain 0.2 --offset 10 --write-images lit \
    -o /dev/null truth.ply
  for photos in photos lit; do
    tm-photo-step --cameras par.txt --images "$photos" --report $photos.json -o $photos.ply truth.ply
    less "$(value max_displacement $photos.json)" "$(value pixel_size $photos.json)"
  done
  awk -v a="$(value dissimilarity photos.json)" -v b="$(value dissimilarity lit.json)" \
    'BEGIN { exit !(a < 1.1 * b && b < 1.1 * a) }'
}

@test "--alpha 0 measures and moves nothing; silhouettes pull back what is outside" {
  photograph_truth
  tm-photo-step --cameras par.txt --images photos --alpha 0 --no-provenance truth.ply |
    cmp - truth.ply
  tm-displace --normal-speed 3% --alpha 10 truth.ply >fat.ply
  for pull in 0 1; do
    tm-photo-step --cameras par.txt --images photos --silhouettes masks --pull $pull --stiffness 0 \
      --iterations 8 --report $pull.json fat.ply >$pull.ply
  done
  less "$(value outside 1.json)" "$(awk "BEGIN { print 0.5 * $(value outside 0.json) }")" ||
    fail "outside: $(value outside 1.json), not pulled $(value outside 0.json)"
}

@test "--step paper goes t times the derivative per area" {
  photograph_truth
  step=(tm-photo-step --cameras par.txt --images photos --step paper --smooth 0 --alpha 10)
  "${step[@]}" --time-step 1e-9 --report once.json truth.ply >once.ply
  "${step[@]}" --time-step 2e-9 --report twice.json truth.ply >twice.ply
  awk -v a="$(value rms_displacement once.json)" -v b="$(value rms_displacement twice.json)" \
    'BEGIN { exit !(a > 0 && b / a > 1.99 && b / a < 2.01) }'
}

@test "photographs that cannot be compared are exit 3" {
  photograph_truth
  run --separate-stderr tm-photo-step --cameras par.txt --images photos --max-angle 5 truth.ply
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *"16 views"* ]]
  run --separate-stderr tm-photo-step --cameras par.txt --images photos <(tm-shape sphere --center 99,0,0)
  assert_status 3
  one_line "$stderr"
  rm photos/"$(ls photos | head -n 1)"
  run --separate-stderr tm-photo-step --missing refuse --cameras par.txt --images photos truth.ply
  assert_status 3
  one_line "$stderr"
  [ -z "$output" ]
  # The camera is left out by default, and a note says so.
  tm-photo-step --cameras par.txt --images photos truth.ply -o moved.ply 2>notes
  grep -q 'left out' notes
  run tm-photo-step --images photos truth.ply
  assert_status 2
}

@test "angles choose the pairs, windows and interpolation the measure" {
  photograph_truth
  step=(tm-photo-step --cameras par.txt --images photos --alpha 0 -o /dev/null truth.ply)
  "${step[@]}" --report usual.json
  for options in "--min-angle 40" "--window 2" "--interpolation bilinear"; do
    # shellcheck disable=SC2086
    "${step[@]}" $options --report other.json
    [ "$(value dissimilarity other.json)" != "$(value dissimilarity usual.json)" ] ||
      fail "$options changes nothing"
    less "$(value dissimilarity other.json)" 0.5
  done
  run --separate-stderr "${step[@]}" --min-angle 49 --max-angle 49.5
  assert_status 3
  one_line "$stderr"
}

@test "--robust changes where vertices go, not the measure, for any number of threads" {
  photograph_truth
  tm-displace --normal-speed 1% --alpha 10 -o near.ply truth.ply
  step=(tm-photo-step --cameras par.txt --images photos --iterations 2 --no-provenance near.ply)
  "${step[@]}" --report usual.json -o usual.ply
  "${step[@]}" --robust 0.1 --threads 1 --report robust.json -o robust.ply
  "${step[@]}" --robust 0.1 --threads 2 -o again.ply
  cmp robust.ply again.ply
  run cmp -s robust.ply usual.ply
  assert_status 1
  [ "$(value dissimilarity robust.json)" = "$(value dissimilarity usual.json)" ]
  [ "$(value energy robust.json)" = "$(value energy usual.json)" ]
  for wrong in -1 0.0001 2000; do
    run --separate-stderr "${step[@]}" --robust $wrong
    assert_status 2
    one_line "$stderr"
  done
}

@test "angles that no pair can have are refused, and both options named" {
  for angles in '--min-angle 60' '--max-angle 4' '--min-angle 20 --max-angle 10'; do
    run --separate-stderr tm-photo-step --cameras none --images none $angles < <(tetrahedron)
    [[ $stderr == *--min-angle*--max-angle* ]] || fail "$stderr"
    assert_status 2
    one_line "$stderr"
  done
}
