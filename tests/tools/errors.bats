# Errors: sentences of the library name no program and no option, and the remedies of the programs are true.
load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
}

# rows: prints the table of remedies, a line `KIND|OPTION|TEXT` for each row.
rows() {
  # The line end of echo ends the last row.
  { sed -n '/table{/,/^};/p' "$tm_root/tools/frame/advice.cpp" | grep -v '^ *//' | tr '\n' ' '; echo; } |
    sed -E 's/Advice\{ *Kind::/\n/g; s/" +"//g' |
    sed -nE 's/^([a-z_]+), "([a-z-]*)", *"(.*)"\}.*/\1|\2|\3/p'
}

# takes PROGRAM OPTION: tests whether the program lists the option in its help.
takes() {
  "$1" --help | grep -qE -- "^ +(-[a-z], )?$2( |\$)"
}

@test "names of kinds are in the order of the kinds" {
  sed -nE '/^enum class/,/^};/ s/^  ([a-z_]+)\b.*/\1/p' "$tm_root/include/transformesh/error_kind.h" >kinds
  sed -n '/kind_names{/,/};/p' "$tm_root/lib/support/errors.cpp" | grep -oE '"[a-z_]+"' | tr -d '"' >names
  [ "$(wc -l <kinds)" -gt 40 ]
  cmp kinds names
}

@test "every program and option that a remedy names exists" {
  rows >table
  [ "$(wc -l <table)" -eq "$(grep -c 'Advice{' "$tm_root/tools/frame/advice.cpp")" ]
  while IFS='|' read -r kind own text; do
    programs=''
    if [ -n "$own" ]; then
      for program in "$tm_build"/bin/tm-*; do
        if takes "$program" "--$own"; then programs+=" $program"; fi
      done
      [ -n "$programs" ] || fail "$kind: no program has --$own"
    fi
    # An option belongs to the program that the text names before the option, or else to the programs that offer
    # the remedy.
    for word in $(grep -oE -- '\btm-[a-z-]+|--[a-z][a-z-]*' <<<"$text"); do
      case $word in
        tm-*)
          [ -x "$tm_build/bin/$word" ] || fail "$kind: there is no $word"
          programs=$word
          ;;
        *)
          [ -n "$programs" ] || fail "$kind: $word is of no program"
          for program in $programs; do
            takes "$program" "$word" || fail "$kind: $program has no $word"
          done
          ;;
      esac
    done
  done <table
}

@test "a remedy follows the sentence of an error, of a note and of a report" {
  tm-shape sphere --faces 200 -o ball.ply
  tm-stitch -q --flip ball.ply -o inside_out.ply
  run --separate-stderr tm-clean inside_out.ply
  assert_status 4
  [ "$stderr" = "tm-clean: no point has a winding number >= 1: the mesh is inside out, or the difference of its parts is empty; if the mesh is inside out, reverse it with tm-stitch --flip" ]
  tm-stitch -q --flip inside_out.ply | tm-clean >/dev/null

  tm-convert -o soup.stl ball.ply
  run --separate-stderr tm-info soup.stl
  [[ $stderr == *"read as a soup of separate triangles; join them with tm-stitch" ]] || fail "$stderr"
  # tm-clean joins the faces of a soup itself, and does not advise tm-stitch.
  run --separate-stderr tm-clean soup.stl -o clean.ply
  [[ $stderr != *"join them with tm-stitch"* ]] || fail "$stderr"
  run --separate-stderr tm-checkmanifold --closed soup.stl
  assert_status 1
  [[ $output == *"as in a soup of triangles; join them with tm-stitch"* ]] || fail "$output"
}

@test "a loop offers remedies by its own options, also if an iteration fails" {
  tm-shape sphere --faces 200 -o ball.ply
  run --separate-stderr tm-evolve ball.ply --step 'tm-displace --normal-speed -1x' --iterations 50 --min-edge 500% \
    --max-edge 1000% -o out.ply
  assert_status 4
  [[ $stderr == *"so nothing would be left; use a smaller --min-edge"* ]] || fail "$stderr"
}
