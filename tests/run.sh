#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Run all tests on FreeCAD 0.20.2, 1.0.0 and 1.1.3, after installing what is missing of them. Takes root or sudo.
#
#     tests/run.sh [tools|core|document|gui] [0.20.2|1.0.0|1.1.3|bookworm|trixie|forky] [PYTEST ARGUMENTS]
#
# The FreeCADs come from Debian: the machine's own release and roots of the others, made once, a few minutes each, in a
# cache folder; ruff and mypy, the tools, come from PyPI. VKWORKBENCH_SCALE=2 runs the windows as on a screen with twice
# as fine pixels. What could not be tested is named at the end. Logs and pictures are in build/tests.
set -euo pipefail
cd "$(dirname "$0")/.."

layers="tools core document gui"
suites="bookworm trixie forky"
while [ $# -gt 0 ]; do
    case $1 in
        tools | core | document | gui) layers=$1 ;;
        bookworm | 0.20.2) suites=bookworm ;;
        trixie | 1.0.0) suites=trixie ;;
        forky | 1.1.3) suites=forky ;;
        *) break ;;
    esac
    shift
done

cache=${VKWORKBENCH_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/vkworkbench}
results=build/tests
# shellcheck source=/dev/null
own=$(. /etc/os-release && echo "${VERSION_CODENAME-}")
user=$(id -u):$(id -g)

# prepare SUITE COMMAND...: run COMMAND, which installs what SUITE needs; note a failure's reason where it has none.
prepare() {
    local folder=$results/$1
    shift
    mkdir -p "$folder"
    "$@" > "$folder/install.log" 2>&1 && return
    grep -v '^W: ' "$folder/install.log" | tail -n 2 | tr '\n' ' ' > "$folder/not-tested"
    return 1
}

# run SUITE PYTEST ARGUMENTS...: run the layers on the FreeCAD of SUITE, and note the reason where it cannot be run.
run() {
    local suite=$1 root=$cache/roots/$1 folder=$results/$1 status=0
    shift
    if [ "$suite" = "$own" ]; then
        tests/run_layers.sh "$folder" "$layers" "$@"
        return
    fi
    tests/as_root.sh tests/in_root.sh "$root" "$user" tests/run_layers.sh "$folder" "$layers" "$@" \
        2> "$folder/root.log" || status=$?
    if [ "$status" = 125 ]; then
        mv "$folder/root.log" "$folder/not-tested"
    elif [ "$status" != 0 ]; then
        cat "$folder/root.log"
        return "$status"
    fi
}

mkdir -p build
exec 9> build/tests.lock
flock --nonblock 9 || { echo "Waiting for another run of the tests in this checkout"; flock 9; }

rm -rf "$results"
[ "$layers" != tools ] || suites=""
[ -z "$suites" ] || echo "Preparing the FreeCADs of: $suites. One that is missing takes some minutes and 2 GB." \
    "All their tests take about three quarters of an hour on two processors"
# Whatever its own release, the machine makes the roots.
[ -z "$suites" ] || prepare "own" tests/install.sh || echo "This machine lacks packages: $(cat "$results/own/not-tested")"
[ -x /usr/bin/python3 ] || { echo "There is no /usr/bin/python3: nothing was tested"; exit 1; }
case " $layers " in *" tools "*) tests/tools.sh "$results" "$cache" ;; esac
layers=${layers#tools}

# Side by side: a window waits as long as it works.
running=()
trap 'for each in "${running[@]}"; do kill -- "-$each" || true; done 2> /dev/null; exit 130' INT TERM
for suite in $suites; do
    if [ "$suite" = "$own" ]; then
        mv "$results/own" "$results/$suite"
        [ -e "$results/$suite/not-tested" ] && continue
    else
        prepare "$suite" tests/as_root.sh tests/make_root.sh "$suite" "$cache/roots/$suite" || continue
    fi
    set -m # a group of processes of its own, which an interruption ends whole
    run "$suite" "$@" &
    set +m
    running+=($!)
done
failed=0
for each in "${running[@]}"; do
    wait "$each" || failed=$?
done
[ "$failed" = 0 ] || exit "$failed"
rm -rf "$results/own"
# shellcheck disable=SC2086
/usr/bin/python3 tests/summary.py "$results" $suites
