#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Try random programs, documents and clicks in the FreeCADs that tests/run.sh has installed. Exit with 1 if one failed.
#
#     tests/fuzz.sh [0.20.2|1.0.0|1.1.3] [--seed N] [--minutes M] [--sessions S] [programs|documents|window]
#
# "programs" analyses random NC programs in the core, in all seven views. "documents" changes random documents, marks,
# settings and calibrations without a window. "window" also uses the panel, pills, Gauss map, strategies and simulation.
# Each of the three takes M minutes, by default 10. A failure prints its seed N; `--seed N --sessions 1` repeats only this
# failure. The logs are in build/fuzz.
set -euo pipefail
cd "$(dirname "$0")/.."

suites="bookworm trixie forky" seed=0 minutes=10 sessions="" layers="programs documents window"
while [ $# -gt 0 ]; do
    case $1 in
        0.20.2 | bookworm) suites=bookworm ;;
        1.0.0 | trixie) suites=trixie ;;
        1.1.3 | forky) suites=forky ;;
        --seed) seed=$2 && shift ;;
        --minutes) minutes=$2 && shift ;;
        --sessions) sessions=$2 && shift ;;
        programs | documents | window) layers=$1 ;;
        here) here=$2 && shift ;;
        *) sed -n '3,11s/^# \?//p' "$0" && exit 2 ;;
    esac
    shift
done

if [ -z "${here-}" ]; then
    cache=${VKWORKBENCH_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/vkworkbench}
    # shellcheck source=/dev/null
    own=$(. /etc/os-release && echo "${VERSION_CODENAME-}")
    status=0
    for suite in $suites; do
        results=build/fuzz/$suite
        mkdir -p "$results"
        # shellcheck disable=SC2086
        arguments=(tests/fuzz.sh here "$results" --seed "$seed" --minutes "$minutes" ${sessions:+--sessions $sessions})
        [ "$layers" = "${layers%% *}" ] && arguments+=("$layers")
        if [ "$suite" = "$own" ]; then
            "${arguments[@]}" || status=1
        else
            tests/as_root.sh tests/in_root.sh "$cache/roots/$suite" "$(id -u):$(id -g)" "${arguments[@]}" || status=1
        fi
    done
    exit "$status"
fi

echo "FreeCAD $(dpkg-query -W -f '${source:Upstream-Version}' freecad | cut -d+ -f1), from seed $seed"
status=0
for layer in $layers; do
    home=$(mktemp -d)
    tests/make_home.sh "$home"
    log=$PWD/$here/$layer.log
    ended=0
    case $layer in
        # shellcheck disable=SC2086
        programs) command=(/usr/bin/python3 tests/fuzz.py --seed "$seed" --minutes "$minutes" ${sessions:+--count $sessions}) ;;
        documents) command=(freecadcmd "$PWD/tests/fuzz_documents.py") ;;
        window) command=(xvfb-run -a -s "-screen 0 1280x1024x24 -ac" freecad "$PWD/tests/fuzz_documents.py") ;;
    esac
    env -i HOME="$home" XDG_RUNTIME_DIR="$home/run" PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 \
        PYTHONDONTWRITEBYTECODE=1 QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 QTWEBENGINE_DISABLE_SANDBOX=1 \
        VKWORKBENCH_FUZZ="$seed $minutes $sessions" VKWORKBENCH_FUZZ_LOG="$log" "${command[@]}" \
        < /dev/null > "$log" 2>&1 || ended=$?
    # freecadcmd always exits with 0, so only the last line of the log shows that the run was completed.
    if [ "$ended" != 0 ] || ! tail -n 1 "$log" | grep -qa ' failed$\|^peak memory'; then
        status=1
        echo "$layer failed, see $log"
    fi
    grep -a '^seed .* commands:\|^FAILED\|^AssertionError' "$log" | cut -c 1-300 | head -n 20 || true
    tail -n 1 "$log" | cut -c 1-300
    rm -rf "$home"
done
exit "$status"
