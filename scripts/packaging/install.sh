#!/bin/sh
# Installs the programs, man pages and completions that lie beside this script, or removes them.
#   ./install.sh                             into /usr/local as root, else into ~/.local
#   ./install.sh --prefix DIR                into DIR
#   ./install.sh [--prefix DIR] --uninstall  removes what was installed there, and nothing else
set -eu
LC_ALL=C
export LC_ALL

# This file lists all installed files, with paths relative to DIR, so that --uninstall can remove
# them.
list=share/transformesh/installed-files

say() { printf 'install.sh: %s\n' "$*" >&2; }
usage() { sed -n '2,/^set/ s/^# \{0,1\}//p' "$from/install.sh"; }

parse() {
  while [ $# -gt 0 ]; do
    case $1 in
      --prefix)
        [ -n "${2-}" ] || { say "--prefix needs a folder" && exit 2; }
        prefix=$2
        shift
        ;;
      --prefix=?*) prefix=${1#--prefix=} ;;
      --uninstall) action=uninstall ;;
      --help) usage && exit 0 ;;
      *)
        say "unknown argument '$1'; there are --prefix DIR, --uninstall and --help"
        exit 2
        ;;
    esac
    shift
  done
}

files() { (cd "$from" && find bin share ! -type d | sort && echo "$list"); }

# copy FILE: installs a file. The new file replaces the old file in one step, so that programs that
# are running are not disturbed.
copy() {
  mkdir -p "$prefix/${1%/*}" || { say "cannot write to $prefix" && exit 1; }
  rm -f "$prefix/$1.new"
  cp -P "$from/$1" "$prefix/$1.new"
  mv -f "$prefix/$1.new" "$prefix/$1"
}

# Removes files that an earlier release has installed and that this release does not have.
remove_outdated() {
  [ -e "$prefix/$list" ] || return 0
  while IFS= read -r file; do
    [ -e "$from/$file" ] || [ "$file" = "$list" ] || rm -f "$prefix/$file"
  done <"$prefix/$list"
}

install() {
  files | while IFS= read -r file; do
    [ "$file" = "$list" ] || copy "$file"
  done
  remove_outdated
  mkdir -p "$prefix/${list%/*}"
  files >"$prefix/$list"
  say "installed $(find "$from/bin" ! -type d | wc -l | tr -d ' ') programs in $prefix/bin"
  case :$PATH: in
    *:"$prefix/bin":*) say "now try: tm" ;;
    *) say "to use them: export PATH=\"$prefix/bin:\$PATH\"" ;;
  esac
}

# Prints the folders of the installed files and all folders above, the deepest first.
folders() {
  while IFS= read -r file; do
    while [ "$file" != "${file%/*}" ]; do
      file=${file%/*}
      printf '%s\n' "$file"
    done
  done <"$prefix/$list" | sort -u -r
}

uninstall() {
  [ -e "$prefix/$list" ] || { say "nothing to remove: $prefix/$list is missing" && exit 1; }
  all_folders=$(folders)
  while IFS= read -r file; do rm -f "$prefix/$file"; done <"$prefix/$list"
  # Folders that contain other files remain, because rmdir fails.
  printf '%s\n' "$all_folders" | while IFS= read -r folder; do
    rmdir "$prefix/$folder" 2>/dev/null || true
  done
  say "removed the programs from $prefix"
}

from=$(CDPATH='' cd -- "$(dirname -- "$0")" && pwd)
action=install
prefix=$HOME/.local
[ "$(id -u)" -ne 0 ] || prefix=/usr/local
parse "$@"
"$action"
