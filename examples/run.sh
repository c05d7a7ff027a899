#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Install the missing packages (needs root or sudo), build the example job in FreeCAD, and analyse and mark its operations.
# The script prints the table, and writes the marked document and a picture of the tree to build/example. With a display,
# the script opens the job in FreeCAD, with the add-on and with separate settings.
set -euo pipefail
cd "$(dirname "$0")/.."

output=$PWD/build/example
rm -rf "$output"
mkdir -p "$output"
echo "Preparing FreeCAD. If FreeCAD is missing, installing it takes some minutes"
tests/install.sh > "$output/install.log" 2>&1 || { tail "$output/install.log"; exit 1; }

home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
tests/make_home.sh "$home"
export VKWORKBENCH_OUTPUT=$output LC_ALL=C.UTF-8 QTWEBENGINE_DISABLE_SANDBOX=1
if [ -n "${DISPLAY-}" ]; then
    export XAUTHORITY=${XAUTHORITY-$HOME/.Xauthority}
    freecad=(freecad)
else
    export VKWORKBENCH_LEAVE=1 QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1
    freecad=(timeout 600 xvfb-run -a -s "-screen 0 1280x1024x24" freecad)
fi
if ! HOME=$home "${freecad[@]}" "$PWD/examples/show_example.py" > "$output/freecad.log" 2>&1; then
    tail -n 20 "$output/freecad.log"
    exit 1
fi
cat "$output/report.txt"
echo "Marked document: $output/marked.FCStd"
echo "Picture of the tree: $output/tree.png"
