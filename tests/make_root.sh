#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# make_root.sh SUITE ROOT: install Debian SUITE in the folder ROOT, with FreeCAD and the packages for the tests. Needs root.
# If ROOT is complete, the script does nothing. If ROOT is incomplete, the script completes it, or fails.
set -euo pipefail

suite=$1
root=$2
mirror=http://deb.debian.org/debian

mkdir -p "$(dirname "$root")"
exec 9> "$root.lock"
flock 9 # two runs of the tests may want it at the same time

if [ ! -d "$root" ]; then
    rm -rf "$root.new"
    # debootstrap needs a script for each suite. A debootstrap that is older than the suite uses the script of sid.
    debootstrap --variant=minbase "$suite" "$root.new" "$mirror" /usr/share/debootstrap/scripts/sid
    # A testing suite's Release file may have expired on a mirror that is not updated.
    echo 'Acquire::Check-Valid-Until "false";' > "$root.new/etc/apt/apt.conf.d/99vkworkbench"
    printf '#!/bin/sh\nexit 101\n' > "$root.new/usr/sbin/policy-rc.d" # start no service
    chmod +x "$root.new/usr/sbin/policy-rc.d"
    mv "$root.new" "$root"
fi
cp -L /etc/resolv.conf "$root/etc/resolv.conf"
install -D -t "$root/opt/vkworkbench" "$(dirname "$0")"/{install.sh,packages.txt}
chroot "$root" /opt/vkworkbench/install.sh
