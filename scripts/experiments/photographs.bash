# The Middlebury photographs, and what experiments with photographs share. Sourced by them after they
# set name.
# shellcheck shell=bash disable=SC2154,SC2034

shared=$(readlink -f "${TM_DATA:-$here/../../../shared/data}/mvs") || true
readonly shared

# Sets cameras, images and, where there are any, masks and options.
name_files() { # SCENE
  masks='' options=()
  case $1 in
    dino)
      cameras="$shared/dinoSparse_transformesh/camera*.txt"
      images="$shared/dinoSparse_transformesh/dinoSR*.png"
      masks="$shared/dinoSparse_transformesh/*mask.png"
      # Plaster, hardly textured; views 45 degrees apart see other sides of the legs.
      options=(--window 5 --pairs 2 --stiffness 3)
      ;;
    temple)
      cameras=$shared/templeSparseRing/templeSR_par.txt
      images="$shared/templeSparseRing/*.png"
      ;;
    *) echo "$name: there is no scene '$1'" >&2 && exit 2 ;;
  esac
}

value() { # KEY REPORT
  awk -v key="\"$1\":" '$1 == key { gsub("[\",]", "", $2); print $2; exit }' "$2"
}

# User and system time of all processes that a command starts, in seconds: the second line of times.
# Sets cpu.
timed() { # COMMAND...
  times >times.begin
  "$@"
  times >times.end
  cpu=$(awk 'FNR == 2 { for (i = 1; i <= 2; ++i) { split($i, part, /[ms]/); sum += 60 * part[1] + part[2] }
    all[++n] = sum; sum = 0 } END { printf "%.1f", all[2] - all[1] }' times.begin times.end)
}

is_clean() { # MESH
  tm-checkmanifold --closed "$1" >/dev/null && tm-intersect --check "$1" >/dev/null
}
