#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# run_layers.sh RESULTS LAYERS [PYTEST ARGUMENTS]: run layers of the tests with the FreeCAD and Python of this system.
# Leaves in RESULTS, a folder, the log, the JUnit report and the exit status of each layer; summary.py judges them.
set -euo pipefail

results=$1
layers=$2
shift 2
cd "$(dirname "$0")/.."
trap 'exit 130' INT TERM # as the first process of a root it would otherwise ignore them

echo "FreeCAD $(dpkg-query -W -f '${source:Upstream-Version}' freecad | cut -d+ -f1)," \
    "$(/usr/bin/python3 -c 'import platform, numpy
print(f"Python {platform.python_version()}, numpy {numpy.__version__}")')" > "$results/versions"

scale=${VKWORKBENCH_SCALE:-1} # pixels of the screen for each of a window's own, as on a fine screen
for layer in $layers; do
    echo "    ${results##*/} $layer"
    home=$(mktemp -d)
    tests/make_home.sh "$home"
    limit=(timeout --foreground -k 10 5000) # s; in the foreground, so that Ctrl-C reaches the tests
    case $layer in
        core) command=("${limit[@]}" /usr/bin/python3 -m pytest -n "$(nproc)") ;;
        document) command=("${limit[@]}" freecadcmd "$PWD/tests/in_freecad.py") ;;
        gui) command=(xvfb-run -a -s "-screen 0 $((1280 * scale))x$((1024 * scale))x24 -dpi 96 -ac" "${limit[@]}" freecad "$PWD/tests/in_freecad.py") ;;
    esac
    status=0
    # pytest captures no output of the FreeCAD layers: their logs have to show what FreeCAD swallows.
    # FreeCAD as root needs its browser's sandbox off, and under Xvfb OpenGL in software.
    env -i HOME="$home" XDG_RUNTIME_DIR="$home/run" PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
        PYTHONPYCACHEPREFIX="$PWD/build/bytecode/${results##*/}" HYPOTHESIS_STORAGE_DIRECTORY="$home/hypothesis" \
        QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR="$scale" LIBGL_ALWAYS_SOFTWARE=1 QTWEBENGINE_DISABLE_SANDBOX=1 \
        VKWORKBENCH_SCREENSHOTS="$PWD/$results/screenshots" \
        PYTEST_ADDOPTS="tests/$layer --junit-xml='$results/$layer.xml' $([ "$layer" = core ] || echo -s) ${*@Q}" \
        "${command[@]}" < /dev/null > "$results/$layer.log" 2>&1 || status=$?
    echo "$status" > "$results/$layer.status"
    rm -rf "$home"
done
