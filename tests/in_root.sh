#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# in_root.sh ROOT USER COMMAND...: run COMMAND in this checkout as USER (uid:gid), but in the Debian root ROOT. Needs root.
# The checkout is read-only there but for build/. Processes, mounts and /tmp end with the command; there is no network.
set -euo pipefail

if [ "$1" != --inside ]; then
    exec unshare --mount --net --pid --fork --kill-child "$0" --inside "$@"
fi
root=$2
user=$3
shift 3

cd "$(dirname "$0")/.."
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mount -t tmpfs tmpfs "$root/tmp"
mount --bind /etc/passwd "$root/etc/passwd" # FreeCAD needs the user to have a name
mount --bind . "$root/mnt"
mount -o remount,bind,ro "$root/mnt"
mount --bind build "$root/mnt/build"
exec chroot --userspec="$user" "$root" env --chdir=/mnt "$@"
