#!/bin/bash
# Tries ./bootstrap in a bare Debian 12: tests/debian_root.sh FOLDER WORD...   e.g. tests/debian_root.sh /tmp/bare test
# FOLDER gets a new root (debootstrap, minimal variant) and a copy of this tree; needs root. MIRROR names another mirror.
set -euo pipefail
source_tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
root=${1:?which folder?}
shift

if [[ ! -e $root/etc/debian_version ]]; then
  debootstrap --variant=minbase bookworm "$root" ${MIRROR:+"$MIRROR"}
fi
rm -rf "$root/swellflow"
mkdir -p "$root/swellflow"
tar -C "$source_tree" --exclude=.git --exclude='./build*' --exclude=./results -cf - . | tar -C "$root/swellflow" -xf -

echo "127.0.0.1 localhost $(hostname)" >"$root/etc/hosts"

for folder in proc sys dev; do mount --bind /$folder "$root/$folder"; done
trap 'umount "$root"/{proc,sys,dev}' EXIT
# As on a new machine: no variables but these, no terminal, no standard input.
env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin chroot "$root" /swellflow/bootstrap "$@" </dev/null
