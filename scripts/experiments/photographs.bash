# Middlebury photographs, and functions for experiments with photographs. Set `name` before sourcing.
# shellcheck shell=bash disable=SC2154,SC2034

shared=$(readlink -f "${TM_DATA:-$here/../../../shared/data}/mvs") || true
readonly shared

# name_files SCENE: sets the variables $cameras and $images to paths of files, and $masks and
# $options if the scene has masks and options.
name_files() { # SCENE
  masks='' options=()
  case $1 in
    dino)
      cameras="$shared/dinoSparse_transformesh/camera*.txt"
      images="$shared/dinoSparse_transformesh/dinoSR*.png"
      masks="$shared/dinoSparse_transformesh/*mask.png"
      # Plaster with little texture; views 45 degrees apart show different sides of the legs.
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

# timed COMMAND...: runs a command, and sets $cpu to the CPU seconds of all its processes, from the
# second line that `times` prints.
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
