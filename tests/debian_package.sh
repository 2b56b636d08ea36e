#!/bin/bash
# Installs a .deb in a bare Debian 12 by apt, runs cases there as an ordinary user, and removes it again: tests/debian_package.sh FOLDER FILE.deb
# FOLDER gets a new root (debootstrap, minimal variant); needs root. MIRROR names another mirror.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/bare_debian.sh"
root=${1:?which folder?}
package=${2:?which package?}

bare_debian "$root"
cp "$package" "$root/tmp/swellflow.deb"
in_bare_debian "$root" apt-get update -q
in_bare_debian "$root" apt-get install -y -q --no-install-recommends /tmp/swellflow.deb
in_bare_debian "$root" sh -c 'id -u user >/dev/null 2>&1 || useradd --create-home user'
# A flow with its check, and objects on two ranks.
in_bare_debian "$root" runuser -l user -c 'swellflow-case channel -var cells 16 --check && swellflow-case cavity_swelling --np 2 -var t_end 0.5 && ls results'
in_bare_debian "$root" apt-get autoremove -y -q --purge swellflow
left=$(find "$root/usr" -path '*swellflow*')
[[ -z $left ]] || { printf 'left behind:\n%s\n' "$left"; exit 1; }
echo "installed by apt, run and removed: $(basename "$package")"
