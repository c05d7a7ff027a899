#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Run FreeCAD's own CAM tests with this add-on and without it, and compare them test by test.
#
#     tests/peer_suite.sh                 # every FreeCAD that tests/run.sh has installed; takes root or sudo
#     tests/peer_suite.sh here RESULTS    # the FreeCAD of this system
#
# The logs and the outcome of each test are in build/peer.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ "${1-}" != here ]; then
    cache=${VKWORKBENCH_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/vkworkbench}
    sudo=()
    [ "$(id -u)" = 0 ] || sudo=(sudo)
    status=0
    mkdir -p build/peer/own
    tests/peer_suite.sh here build/peer/own || status=1
    for root in "$cache"/roots/*/; do
        results=build/peer/$(basename "$root")
        mkdir -p "$results"
        "${sudo[@]}" tests/in_root.sh "$root" "$(id -u):$(id -g)" tests/peer_suite.sh here "$results" || status=1
    done
    exit "$status"
fi

results=$2
for addon in "" 1; do
    name=without
    [ -z "$addon" ] || name=with
    home=$(mktemp -d)
    tests/make_home.sh "$home"
    # The run without the add-on has the same settings, but no link to the add-on.
    [ -n "$addon" ] || rm "$home"/.local/share/FreeCAD/{,v1-1/}Mod/ToolpathAnalysis
    rm -f "$results/$name.json"
    env -i HOME="$home" XDG_RUNTIME_DIR="$home/run" PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
        PYTHONDONTWRITEBYTECODE=1 PYTHONHASHSEED=0 QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 \
        QTWEBENGINE_DISABLE_SANDBOX=1 VK_PEER_RESULTS="$PWD/$results/$name.json" VK_PEER_ADDON="$addon" \
        timeout -k 10 900 xvfb-run -a -s "-screen 0 1280x1024x24 -ac" \
        freecad "$PWD/tests/peer_suite.py" < /dev/null > "$results/$name.log" 2>&1 ||
        { tail -n 20 "$results/$name.log"; exit 1; }
    rm -rf "$home"
done
echo "FreeCAD $(dpkg-query -W -f '${source:Upstream-Version}' freecad | cut -d+ -f1)"
/usr/bin/python3 tests/peer_suite.py "$results/without.json" "$results/with.json"
