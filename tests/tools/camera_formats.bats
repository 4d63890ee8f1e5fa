# Camera files of other programs: tm-cameras is compared with readers and writers in Python that follow the
# descriptions of the formats.

load ../helpers/common

setup() {
  cd "$BATS_TEST_TMPDIR" || exit
  needs_command python3
  files="$BATS_TEST_DIRNAME/../helpers/camera_files.py"
}

@test "tm-cameras reads the files of nine programs: the pixels of 20 points agree to 1e-6" {
  for format in transforms meshroom openmvg mvsnet llff neus nvm openmvs; do
    python3 "$files" write $format $format
    tm-cameras --format opencv --folder out-$format --images $format-images $format
    python3 "$files" check opencv out-$format $format
  done
  python3 "$files" write mve mve
  tm-cameras --format transforms --folder out-mve --images mve/views mve
  python3 "$files" check transforms out-mve mve
}

@test "tm-cameras writes transforms.json and Meshroom's and OpenMVS's files" {
  python3 "$files" write transforms in
  for format in transforms meshroom; do
    tm-cameras --format $format --folder out-$format in
    python3 "$files" check $format out-$format transforms
    cmp <(tm-cameras --format $format in) out-$format/*
    # Reads the written files again.
    tm-cameras --format opencv --folder again-$format out-$format
    python3 "$files" check opencv again-$format transforms
  done
  python3 "$files" write openmvs in-openmvs
  tm-cameras --format openmvs --folder out-openmvs in-openmvs
  python3 "$files" check openmvs out-openmvs openmvs
  tm-cameras --format opencv --folder again-openmvs out-openmvs
  python3 "$files" check opencv again-openmvs openmvs
}

@test "a format that cannot hold the distortion says so" {
  python3 "$files" write transforms in
  run --separate-stderr tm-cameras --format openmvs --folder out in
  assert_status 3
  one_line "$stderr"
  [[ $stderr == *distortion* ]]
  [ ! -e out ]
}
