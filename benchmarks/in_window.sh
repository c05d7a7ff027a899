#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Run a benchmark in the windows of the FreeCADs that tests/run.sh has installed, each with its own home folder.
#
#     benchmarks/in_window.sh NAME [0.20.2|1.0.0|1.1.3]
#
# NAME is the name of a file in benchmarks/ without .py, for example pauses. As on a user's first start, Python compiles the
# add-on during the first run.
set -euo pipefail
cd "$(dirname "$0")/.."

script=benchmarks/${1-}.py
[ -f "$script" ] || { sed -n '3,8s/^# \?//p' "$0" && exit 2; }

if [ "${2-}" = here ]; then
    home=$(mktemp -d)
    trap 'rm -rf "$home"' EXIT
    tests/make_home.sh "$home"
    env -i HOME="$home" XDG_RUNTIME_DIR="$home/run" PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
        PYTHONPYCACHEPREFIX="$PWD/build/bytecode" QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 QTWEBENGINE_DISABLE_SANDBOX=1 \
        VKWORKBENCH_PATIENCE="${VKWORKBENCH_PATIENCE:-600}" \
        xvfb-run -a -s "-screen 0 1280x1024x24 -dpi 96 -ac" freecad "$PWD/$script" < /dev/null |
        sed -u '/^FreeCAD .*, Libs: /,/^$/d' # 0.20 says who made it
    exit
fi

case ${2-} in
    "") suites="bookworm trixie forky" ;;
    0.20.2) suites=bookworm ;;
    1.0.0) suites=trixie ;;
    1.1.3) suites=forky ;;
    *) sed -n '3,8s/^# \?//p' "$0" && exit 2 ;;
esac
cache=${VKWORKBENCH_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/vkworkbench}
# shellcheck source=/dev/null
own=$(. /etc/os-release && echo "${VERSION_CODENAME-}")
mkdir -p build
for suite in $suites; do
    # FreeCAD's own messages go into the log.
    if [ "$suite" = "$own" ]; then
        benchmarks/in_window.sh "$1" here
    else
        tests/as_root.sh tests/in_root.sh "$cache/roots/$suite" "$(id -u):$(id -g)" benchmarks/in_window.sh "$1" here
    fi 2> "build/$1-$suite.log"
done
