#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# in_root.sh ROOT USER COMMAND...: run COMMAND in this checkout as USER (uid:gid), in the Debian root ROOT. Needs root.
# COMMAND can write only to build/ in the checkout, and has no network. When COMMAND ends, its processes and mounts end, and
# its /tmp is removed. Most containers allow no mounts. There, COMMAND runs in a copy of the checkout, whose folder build/ is
# copied back afterwards. If this is not possible either, the script prints the reason in one line and exits with 125.
set -euo pipefail

cd "$(dirname "$0")/.."
if [ "$1" != --inside ]; then
    unshare --mount --net --pid --fork true 2> /dev/null &&
        exec unshare --mount --net --pid --fork --kill-child "tests/$(basename "$0")" --inside "$@"
    root=$1
    user=$2
    shift 2
    exec 9> "$root.in-use"
    flock 9 # there is one place for the copy
    find "$root/mnt" -mindepth 1 -delete
    tar -c --exclude=./build --exclude=./.git . | tar -x -C "$root/mnt"
    find build -maxdepth 2 -type d -exec mkdir -p "$root/mnt/{}" \; # others may be writing files there
    chown -R "$user" "$root/mnt/build"
    if [ ! -e "$root/proc/self/exe" ]; then
        mount -t proc proc "$root/proc" 2> /dev/null || { # FreeCAD asks it where it is
            echo "Neither mounts nor /proc of its own are allowed here" >&2
            exit 125
        }
        trap 'umount "$root/proc"' EXIT
    fi
    cp "$root/etc/passwd" "$root/etc/passwd.own"
    cp /etc/passwd "$root/etc/passwd"
    status=0
    chroot --userspec="$user" "$root" env --chdir=/mnt "$@" || status=$?
    mv "$root/etc/passwd.own" "$root/etc/passwd"
    cp -a "$root/mnt/build/." build
    exit "$status"
fi
root=$2
user=$3
shift 3

mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mount -t tmpfs tmpfs "$root/tmp"
mount --bind /etc/passwd "$root/etc/passwd" # FreeCAD needs the user to have a name
mount --bind . "$root/mnt"
mount -o remount,bind,ro "$root/mnt"
mount --bind build "$root/mnt/build"
exec chroot --userspec="$user" "$root" env --chdir=/mnt "$@"
