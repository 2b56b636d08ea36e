#!/bin/bash
# Tries ./bootstrap in a bare Debian 12: tests/debian_root.sh FOLDER WORD...   e.g. tests/debian_root.sh /tmp/bare test
# FOLDER gets a new root (debootstrap, minimal variant) and a copy of this tree; needs root. MIRROR names another mirror.
set -euo pipefail
source_tree=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$source_tree/tests/bare_debian.sh"
root=${1:?which folder?}
shift

bare_debian "$root"
rm -rf "$root/swellflow"
mkdir -p "$root/swellflow"
tar -C "$source_tree" --exclude=.git --exclude='./build*' --exclude=./results -cf - . | tar -C "$root/swellflow" -xf -
in_bare_debian "$root" /swellflow/bootstrap "$@"
