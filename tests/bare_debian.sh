# A bare Debian 12 in a folder, and commands in it; to be sourced. Needs root and debootstrap. MIRROR names another mirror.

# bare_debian ROOT: makes it when it is not there, and keeps the kernel's folders mounted until the script ends.
bare_debian() {
  local root=$1 folder
  [[ -e $root/etc/debian_version ]] || debootstrap --variant=minbase bookworm "$root" ${MIRROR:+"$MIRROR"}
  echo "127.0.0.1 localhost $(hostname)" >"$root/etc/hosts"
  for folder in proc sys dev; do mount --bind /$folder "$root/$folder"; done
  # shellcheck disable=SC2064  # the folder of now
  trap "umount '$root'/{proc,sys,dev}" EXIT
}

# in_bare_debian ROOT COMMAND...: as on a new machine: no variables but these, no terminal, no standard input.
in_bare_debian() {
  local root=$1
  shift
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot "$root" "$@" </dev/null
}
