load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR"
  tetrahedron >t.ply
}

# Prints the number of elements of this name that a PLY header announces.
count() {
  sed -n "s/^element $1 //p" "$2"
}

@test "elements follow each other, and faces refer to their own vertices" {
  tm-cat t.ply t.ply t.ply >all.ply
  [ "$(count vertex all.ply) $(count face all.ply)" = "12 12" ]
  [ "$(tail -n 1 all.ply)" = "3 9 11 10" ]
  sed -n '/^end_header/,$p' all.ply | sed -n 6,9p >second
  sed -n '/^end_header/,$p' t.ply | sed -n 2,5p | cmp - second
}

@test "stdin may be one of several inputs" {
  tm-cat t.ply - t.ply <t.ply >all.ply
  [ "$(count vertex all.ply)" -eq 12 ]
}

@test "one mesh stays as it is" {
  tm-cat --no-provenance t.ply | cmp - t.ply
  tm-cat --no-provenance <t.ply | cmp - t.ply
}

@test "columns are united, and missing values are zero" {
  sed '/^property double z/a property float quality' t.ply |
    sed '/^end_header/,$ s/^\(. . .\)$/\1 7/' >quality.ply
  tm-cat t.ply quality.ply >all.ply
  [ "$(grep -c '^property float quality' all.ply)" -eq 1 ]
  sed -n '/^end_header/,$p' all.ply | sed -n 2,9p | cut -d' ' -f4 | tr -d '\n' | grep -qx 00007777
}

@test "coordinates are double as soon as one input has doubles" {
  tm-convert --float -o float.ply t.ply
  tm-cat float.ply t.ply | grep -qx "property double x"
  tm-cat float.ply float.ply | grep -qx "property float x"
  tm-cat --float float.ply t.ply | grep -qx "property float x"
}

@test "comments of all inputs are kept once, and the reference edge of the first" {
  sed '2a comment one\ncomment both\ncomment tm:reference-edge 1' t.ply >one.ply
  sed '2a comment two\ncomment both\ncomment tm:reference-edge 2' t.ply >two.ply
  tm-cat --no-provenance one.ply two.ply | grep '^comment' >comments
  printf 'comment %s\n' one both "tm:reference-edge 1" two | cmp - comments
}

@test "further elements are kept" {
  sed '/^end_header/i element label 1\nproperty int number' t.ply | sed '$a 5' >label.ply
  tm-cat label.ply t.ply label.ply >all.ply
  [ "$(count label all.ply)" -eq 2 ]
  tail -n 2 all.ply | tr '\n' ' ' | grep -qx '5 5 '
}

@test "edges of sections refer to their own vertices" {
  tm-select --plane 0,0,1,0.25 --section sec.ply t.ply -o cut.ply
  tm-cat --format ply-ascii sec.ply sec.ply >all.ply
  [ "$(count edge all.ply)" -gt 2 ]
  # Each segment has two vertices of its own.
  tail -n "$(count edge all.ply)" all.ply | tr ' ' '\n' >numbers
  seq 0 $(($(count vertex all.ply) - 1)) | cmp - numbers
}

@test "a broken input among several is named" {
  head -c 150 t.ply >broken.ply
  run --separate-stderr tm-cat t.ply broken.ply -o all.ply
  assert_status 3
  [[ $stderr == *broken.ply* ]]
  [ ! -e all.ply ]
}

@test "values of narrow and wide types survive; a list beside a number is reported" {
  cd "$BATS_TEST_TMPDIR"
  # labeled TYPE VALUE: writes a tetrahedron with a label at each vertex
  labeled() {
    tetrahedron | awk -v type="$1" -v value="$2" '
      /^element face/ { print "property " type " label" }
      { print (NF == 3 && !/^[a-z]/) ? $0 " " value : $0 }'
  }
  labeled short 5 >short.ply
  labeled int 70000 >int.ply
  labeled double 0.1 >double.ply
  labeled "list uchar int" "1 9" >list.ply
  tm-cat short.ply int.ply double.ply >all.ply
  grep -qx "property double label" all.ply
  [ "$(awk 'NF == 4 && !/^[a-z]/ && $1 != 3 { print $4 }' all.ply | uniq | paste -s -d' ')" = "5 70000 0.1" ]
  run --separate-stderr tm-cat short.ply list.ply -o out.ply
  assert_status 0
  one_line "$stderr"
  [[ $stderr == "tm-cat: vertex property 'label' is a list in one input"* ]]
}

@test "groups of OBJ keep their names, and equal numbers of others do not mix" {
  cd "$BATS_TEST_TMPDIR"
  printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\ng wing\nf 1 2 3\ng tail\nf 3 2 1\n' >a.obj
  printf 'v 0 0 1\nv 1 0 1\nv 0 1 1\ng tail\nf 1 2 3\ng nose\nf 3 2 1\ng 2\nf 1 2 3\n' >b.obj
  tm-cat --no-provenance a.obj b.obj | tm-convert --no-provenance --format obj >all.obj
  grep -E '^[gf]' all.obj | tr '\n' ' ' >groups
  diff -b groups - <<<'g wing f 1 2 3 g tail f 3 2 1 f 4 5 6 g nose f 6 5 4 g 4 f 4 5 6'
}

@test "colors of bytes and of decimals get one scale, also through VTP" {
  cd "$BATS_TEST_TMPDIR"
  printf 'v %s 1 0.5 0\n' '0 0 0' '1 0 0' '0 1 0' >c.obj
  echo 'f 1 2 3' >>c.obj
  tm-convert --no-provenance --format ply-ascii c.obj |
    sed -E 's/^property double (red|green|blue)/property uchar \1/; s/ 1 0\.5 0$/ 255 51 0/' >c.ply
  tm-convert --no-provenance --format ply-ascii c.obj |
    sed -E '/^property double (red|green|blue)/d; s/ 1 0\.5 0$//' >plain.ply
  # colors FILE...: prints the colors of the vertices of the joined files, each once
  colors() {
    tm-cat -q --format ply-ascii "$@" | tee all.ply |
      awk 'NF == 6 && $1 != "comment" { print $4, $5, $6 }' | uniq | paste -s -d,
  }
  [ "$(colors c.obj c.ply)" = "1 0.5 0,1 0.2 0" ]
  grep -qx "property double red" all.ply
  [ "$(colors c.ply c.obj)" = "1 0.2 0,1 0.5 0" ]
  [ "$(colors plain.ply c.ply c.obj)" = "1 1 1,1 0.2 0,1 0.5 0" ]
  [ "$(colors c.ply plain.ply)" = "255 51 0,255 255 255" ]
  tm-convert --format vtp c.obj -o c.vtp
  [ "$(colors c.vtp c.ply)" = "1 0.5 0,1 0.2 0" ]
}
