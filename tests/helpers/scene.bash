# Writes scenes as text files: cameras, and masks of simple objects. The default scene has three
# cameras at distance 10 around a cube.

# mask FIRST LAST [LEVEL]: prints a black image of 9x9 pixels with a square of intensity LEVEL, from
# pixel FIRST to LAST along both axes.
mask() {
  awk -v first="$1" -v last="$2" -v intensity="${3:-255}" 'BEGIN {
    print "P2 9 9 255"
    for (y = 0; y < 9; ++y) {
      for (x = 0; x < 9; ++x)
        printf "%d ", (x >= first && x <= last && y >= first && y <= last) ? intensity : 0
      print ""
    }
  }'
}

# make_scene FOLDER: writes par.txt and the folder masks.
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

# make_balls FOLDER [K1]: writes par.txt with nine cameras around three balls, at three heights and
# uneven angles, and the masks view0.pgm to view8.pgm of 64x48 pixels. K1 is the radial distortion of
# the lens.
make_balls() {
  mkdir -p "$1/masks"
  awk -v folder="$1" -v k1="${2:-0}" 'BEGIN {
    ball("0 0 0 0.8"); ball("0.9 0.5 0.3 0.5"); ball("-0.4 -0.9 0.6 0.35")
    par = folder "/par.txt"
    print 9 >par
    for (v = 0; v < 9; ++v) view(v, 0.698 * v + 0.25 * (v % 2) - 0.2 * (v % 4), 0.5 * (v % 3) - 0.4)
  }
  function ball(text,   part, i) {
    split(text, part, " ")
    for (i = 1; i <= 4; ++i) b[balls, i] = part[i]
    ++balls
  }
  # The camera is 8 from the origin and looks there, y down.
  function view(v, azimuth, height,   name, i, x, y, ca, sa, ch, sh, file) {
    ca = cos(azimuth); sa = sin(azimuth); ch = cos(height); sh = sin(height)
    r[1] = -sa; r[2] = ca; r[3] = 0
    r[4] = ca * sh; r[5] = sa * sh; r[6] = -ch
    r[7] = -ca * ch; r[8] = -sa * ch; r[9] = -sh
    name = "view" v ".pgm"; file = folder "/masks/" name
    printf "%s 120 0 31.5 0 120 23.5 0 0 1", name >par
    for (i = 1; i <= 9; ++i) printf " %.12g", r[i] >par
    print " 0 0 8" >par
    print "P2 64 48 255" >file
    for (y = 0; y < 48; ++y) for (x = 0; x < 64; ++x)
      print hits((x - 31.5) / 120, (y - 23.5) / 120) ? 255 : 0 >file
    close(file)
  }
  function hits(x, y,   i, k, cx, cy, cz, along, off, size, bent_x, bent_y) {
    bent_x = x; bent_y = y
    for (i = 0; i < 40 && k1 != 0; ++i) {
      size = 1 + k1 * (x * x + y * y)
      x = bent_x / size; y = bent_y / size
    }
    size = x * x + y * y + 1
    for (k = 0; k < balls; ++k) {
      for (i = 0; i < 3; ++i) c[i] = r[3 * i + 1] * b[k, 1] + r[3 * i + 2] * b[k, 2] + r[3 * i + 3] * b[k, 3]
      cx = c[0]; cy = c[1]; cz = c[2] + 8
      along = (x * cx + y * cy + cz) / size
      off = (cx - along * x) ^ 2 + (cy - along * y) ^ 2 + (cz - along) ^ 2
      if (off < b[k, 4] ^ 2) return 1
    }
    return 0
  }'
}

# changed_mask EXPRESSION: reads a mask and writes it with other intensities. EXPRESSION is an awk
# expression of the intensity l and the number of the pixel i.
changed_mask() {
  awk -v seed=1 'NR == 1 { print; next } { l = $1; ++i; print int('"$1"') }'
}
