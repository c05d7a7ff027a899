#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# run_layers.sh RESULTS LAYERS whole|part PLACE [PYTEST ARGUMENTS]
#
# Run the tests of each layer in LAYERS with the FreeCAD and Python of this system. If PLACE is not empty, run only the
# tests in the file or folder PLACE. "part" leaves out the tests that are marked `long` or `sources`. For each layer, write
# the log, the JUnit report, the exit status and the duration in seconds to the folder RESULTS, for summary.py.
set -euo pipefail

results=$1
layers=$2
extent=$3
place=$4
shift 4
cd "$(dirname "$0")/.."
trap 'exit 130' INT TERM # the first process of a root would otherwise ignore them

# The whole tests of the first FreeCAD take the longest, so the parts on the other FreeCADs give way to them.
[ "$extent" = whole ] || renice -n 5 $$ > /dev/null

echo "FreeCAD $(dpkg-query -W -f '${source:Upstream-Version}' freecad | cut -d+ -f1)," \
    "$(/usr/bin/python3 -c 'import platform, numpy
print(f"Python {platform.python_version()}, numpy {numpy.__version__}")')" > "$results/versions"

scale=${VKWORKBENCH_SCALE:-1} # screen pixels for each pixel of a window, as on a fine screen
for layer in $layers; do
    echo "    ${results##*/} $layer"
    home=$(mktemp -d)
    tests/make_home.sh "$home"
    limit=(timeout --foreground -k 10 3600) # s; in the foreground, so that Ctrl-C reaches the tests
    options=(--junit-xml="$results/$layer.xml")
    [ "$extent" = whole ] || options+=(-m "not long and not sources")
    case $layer in
        core) command=("${limit[@]}" /usr/bin/python3 -m pytest -n "$(nproc)") ;;
        document) command=("${limit[@]}" freecadcmd "$PWD/tests/in_freecad.py") ;;
        gui) command=(xvfb-run -a -s "-screen 0 $((1280 * scale))x$((1024 * scale))x24 -dpi 96 -ac" "${limit[@]}" freecad "$PWD/tests/in_freecad.py") ;;
    esac
    # pytest captures no output of the FreeCAD layers, so that their logs show the exceptions that FreeCAD swallows.
    [ "$layer" = core ] || options+=(-s)
    options+=("$@")
    status=0
    began=$SECONDS
    # As root, FreeCAD starts only if the sandbox of its browser is off. Under Xvfb, FreeCAD needs OpenGL in software.
    env -i HOME="$home" XDG_RUNTIME_DIR="$home/run" PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
        PYTHONPYCACHEPREFIX="$PWD/build/bytecode/${results##*/}" HYPOTHESIS_STORAGE_DIRECTORY="$home/hypothesis" \
        QT_QPA_PLATFORM=xcb QT_SCALE_FACTOR="$scale" LIBGL_ALWAYS_SOFTWARE=1 QTWEBENGINE_DISABLE_SANDBOX=1 \
        VKWORKBENCH_SCREENSHOTS="${VKWORKBENCH_SCREENSHOTS:+$PWD/$results/screenshots}" \
        PYTEST_ADDOPTS="'${place:-tests/$layer}' ${options[*]@Q}" \
        "${command[@]}" < /dev/null > "$results/$layer.log" 2>&1 || status=$?
    echo "$status" > "$results/$layer.status"
    echo "$((SECONDS - began))" > "$results/$layer.seconds"
    rm -rf "$home"
done
