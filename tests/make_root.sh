#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# make_root.sh SUITE: a Debian root of SUITE with its FreeCAD and what the tests need, made once and kept.
# Prints the root's path on its last line; exits non-zero with a reason where it cannot be made.
set -euo pipefail

suite=$1
cache=${VKWORKBENCH_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/vkworkbench}
root=$cache/roots/$suite
mirror=http://deb.debian.org/debian
packages=$(grep -v '^#' "$(dirname "$0")/packages.txt")

# The stamp holds the package list: a longer list completes an existing root.
if [ "$(cat "$root/.vkworkbench" 2>/dev/null)" != "$packages" ]; then
    if [ ! -x "$root/usr/bin/apt-get" ]; then
        rm -rf "$root"
        mkdir -p "$(dirname "$root")"
        # debootstrap names its scripts by suite; one older than the suite still has sid's.
        debootstrap --variant=minbase "$suite" "$root.new" "$mirror" /usr/share/debootstrap/scripts/sid >&2
        # A testing suite's Release file may have expired on a mirror that is not updated.
        echo 'Acquire::Check-Valid-Until "false";' > "$root.new/etc/apt/apt.conf.d/99vkworkbench"
        printf '#!/bin/sh\nexit 101\n' > "$root.new/usr/sbin/policy-rc.d"
        chmod +x "$root.new/usr/sbin/policy-rc.d"
        mv "$root.new" "$root"
    fi
    cp -L /etc/resolv.conf "$root/etc/resolv.conf"
    chroot "$root" apt-get -q update >&2
    # shellcheck disable=SC2086
    chroot "$root" env DEBIAN_FRONTEND=noninteractive apt-get -qy install --no-install-recommends \
        $(chroot "$root" apt-cache --names-only search . | cut -d' ' -f1 | grep -Fx "$packages") >&2
    echo "$packages" > "$root/.vkworkbench"
fi
echo "$root"
