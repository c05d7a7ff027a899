#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# make_home.sh HOME: make HOME a home folder in which FreeCAD finds this checkout as an add-on and opens no dialogs.
set -euo pipefail

cd "$(dirname "$0")/.."
mkdir -p "$1"
mkdir -m 700 "$1/run" # for XDG_RUNTIME_DIR
for folder in FreeCAD FreeCAD/v1-1; do # the second since 1.1
    mkdir -p "$1/.local/share/$folder/Mod" "$1/.config/$folder"
    ln -s "$PWD" "$1/.local/share/$folder/Mod/ToolpathAnalysis"
    cp tests/user.cfg "$1/.config/$folder"
done
