# A scene that is all text: three cameras around a cube, 10 away, and what they see of it.

# mask FIRST LAST [LEVEL]: an image of 9x9 pixels, black but for a square of LEVEL, from pixel FIRST
# to LAST each way.
mask() {
  awk -v first="$1" -v last="$2" -v level="${3:-255}" 'BEGIN {
    print "P2 9 9 255"
    for (y = 0; y < 9; ++y) {
      for (x = 0; x < 9; ++x)
        printf "%d ", (x >= first && x <= last && y >= first && y <= last) ? level : 0
      print ""
    }
  }'
}

# make_scene FOLDER: par.txt and the folder masks.
make_scene() {
  mkdir -p "$1/masks"
  cat >"$1/par.txt" <<'PAR'
3
a.pgm 10 0 4 0 10 4 0 0 1 0 1 0 0 0 -1 -1 0 0 0 0 10
b.pgm 10 0 4 0 10 4 0 0 1 -1 0 0 0 0 -1 0 -1 0 0 0 10
c.pgm 10 0 4 0 10 4 0 0 1 1 0 0 0 -1 0 0 0 -1 0 0 10
PAR
  local name
  for name in a b c; do mask 2 6 >"$1/masks/$name.pgm"; done
}
