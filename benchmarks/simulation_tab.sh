#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Run simulation_tab.py in windows of the FreeCADs that tests/run.sh has installed, each with a home of its own.
#
#     benchmarks/simulation_tab.sh [0.20.2|1.0.0|1.1.3]
set -euo pipefail
cd "$(dirname "$0")/.."

if [ "${1-}" = here ]; then
    home=$(mktemp -d)
    trap 'rm -rf "$home"' EXIT
    tests/make_home.sh "$home"
    env -i HOME="$home" XDG_RUNTIME_DIR="$home/run" PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
        PYTHONDONTWRITEBYTECODE=1 QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 QTWEBENGINE_DISABLE_SANDBOX=1 \
        VKWORKBENCH_PATIENCE="${VKWORKBENCH_PATIENCE:-600}" \
        xvfb-run -a -s "-screen 0 1280x1024x24 -dpi 96 -ac" freecad "$PWD/benchmarks/simulation_tab.py" \
        < /dev/null 2> build/simulation_tab.log | grep -a 'trajectories$\|first picture\|imulat\|before: ' || true
    exit
fi

case ${1-} in
    "") suites="bookworm trixie forky" ;;
    0.20.2) suites=bookworm ;;
    1.0.0) suites=trixie ;;
    1.1.3) suites=forky ;;
    *) sed -n '3,5s/^# \?//p' "$0" && exit 2 ;;
esac
mkdir -p build
cache=${VKWORKBENCH_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/vkworkbench}
# shellcheck source=/dev/null
own=$(. /etc/os-release && echo "${VERSION_CODENAME-}")
for suite in $suites; do
    if [ "$suite" = "$own" ]; then
        benchmarks/simulation_tab.sh here
    else
        tests/as_root.sh tests/in_root.sh "$cache/roots/$suite" "$(id -u):$(id -g)" benchmarks/simulation_tab.sh here
    fi
done
