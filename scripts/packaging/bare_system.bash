# Sourced by the scripts that try packages: a bare Debian in a temporary folder, $bare_root.

bare_root=

# make_bare_system bookworm: needs root, debootstrap and a mirror.
make_bare_system() {
  bare_root=$(mktemp -d)
  debootstrap --variant=minbase "$1" "$bare_root" >"$bare_root.log" || {
    tail -n 3 "$bare_root.log" >&2
    return 1
  }
  rm "$bare_root.log"
  mount -t proc proc "$bare_root/proc"
}

# Unmounts everything that is mounted in the bare system before removing it.
remove_bare_system() {
  [ -n "$bare_root" ] || return 0
  umount "$bare_root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$bare_root"
  bare_root=
}

# bare 'a | b': runs a line in the bare system.
bare() {
  chroot "$bare_root" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C \
    DEBIAN_FRONTEND=noninteractive bash -euo pipefail -c "$1"
}
