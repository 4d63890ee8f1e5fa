# Functions for scripts that test packages in a minimal Debian, which is installed in the temporary
# folder $bare_root.

bare_root=

# make_bare_system SUITE: installs a minimal Debian, for example bookworm, in $bare_root. Needs
# root, debootstrap and a mirror of Debian.
make_bare_system() {
  bare_root=$(mktemp -d)
  debootstrap --variant=minbase "$1" "$bare_root" >"$bare_root.log" || {
    tail -n 3 "$bare_root.log" >&2
    return 1
  }
  rm "$bare_root.log"
  mount -t proc proc "$bare_root/proc"
}

# Removes the minimal Debian, after everything that is mounted in it is unmounted.
remove_bare_system() {
  [ -n "$bare_root" ] || return 0
  umount "$bare_root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$bare_root"
  bare_root=
}

# bare 'a | b': runs a line of bash in the minimal Debian.
bare() {
  chroot "$bare_root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C \
    DEBIAN_FRONTEND=noninteractive bash -euo pipefail -c "$1"
}
