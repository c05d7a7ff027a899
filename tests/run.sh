#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Install what is missing, then run the tests on FreeCAD 0.20.2, 1.0.0 and 1.1.3. Installing needs root or sudo.
#
#     tests/run.sh                                # what every change has to pass
#     tests/run.sh everywhere                     # every test on every FreeCAD, before a release
#     tests/run.sh core/paper                     # the tests of one room
#     tests/run.sh gui/test_vk_pills.py 1.1.3     # one file in one FreeCAD
#
#     tests/run.sh [everywhere] [tools|core|document|gui|FOLDER|FILE] [0.20.2|1.0.0|1.1.3] [PYTEST ARGUMENTS]
#
# All tests run on the first FreeCAD with its Python and numpy. The other two leave out the tests that are marked `long`
# or `sources` (see pyproject.toml).
#
# The FreeCADs come from Debian: one from the machine's own release, the others in roots that are made once, in a few
# minutes each, in a cache folder. The tools ruff and mypy come from PyPI. With VKWORKBENCH_SCALE=2, the windows run as on
# a screen whose pixels are half as large. With VKWORKBENCH_SCREENSHOTS=yes, the tests save pictures of the windows. Logs
# and pictures are in build/tests. The last lines of the output name everything that could not be tested.
set -euo pipefail
cd "$(dirname "$0")/.."

# shellcheck source=/dev/null
own=$(. /etc/os-release && echo "${VERSION_CODENAME-}")
layers="tools gui document core" # the core last: it uses all processors, a window only one
suites="bookworm trixie forky"
place=""
everywhere=""
while [ $# -gt 0 ]; do
    case $1 in
        everywhere) everywhere=yes ;;
        tools | core | document | gui) layers=$1 ;;
        core/* | document/* | gui/*)
            [ -e "tests/$1" ] || { echo "There is no tests/$1"; exit 1; }
            place=tests/$1
            layers=${1%%/*}
            case " $suites " in *" $own "*) suites=$own ;; *) suites=bookworm ;; esac
            ;;
        bookworm | 0.20.2) suites=bookworm ;;
        trixie | 1.0.0) suites=trixie ;;
        forky | 1.1.3) suites=forky ;;
        *) break ;;
    esac
    shift
done

cache=${VKWORKBENCH_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/vkworkbench}
results=build/tests
user=$(id -u):$(id -g)

# prepare SUITE COMMAND...: install the packages for SUITE with COMMAND. If COMMAND fails, write the reason to a file.
prepare() {
    local folder=$results/$1
    shift
    mkdir -p "$folder"
    "$@" > "$folder/install.log" 2>&1 && return
    grep -v '^W: ' "$folder/install.log" | tail -n 2 | tr '\n' ' ' > "$folder/not-tested"
    return 1
}

# run SUITE whole|part PYTEST ARGUMENTS...: run the layers on the FreeCAD of SUITE, or write to a file why not.
run() {
    local suite=$1 extent=$2 root=$cache/roots/$1 folder=$results/$1 status=0
    shift 2
    local command=(tests/run_layers.sh "$folder" "$layers" "$extent" "$place" "$@")
    if [ "$suite" = "$own" ]; then
        "${command[@]}"
        return
    fi
    tests/as_root.sh tests/in_root.sh "$root" "$user" "${command[@]}" 2> "$folder/root.log" || status=$?
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
    "The tests take about 25 minutes on two processors"
# The roots are made with packages of this machine, so the packages are needed even if only the roots are tested.
[ -z "$suites" ] || prepare "own" tests/install.sh || echo "This machine lacks packages: $(cat "$results/own/not-tested")"
[ -x /usr/bin/python3 ] || { echo "There is no /usr/bin/python3: nothing was tested"; exit 1; }

running=()
trap 'for each in "${running[@]}"; do kill -- "-$each" || true; done 2> /dev/null; exit 130' INT TERM
# start COMMAND...: run COMMAND in the background, in its own process group, so that an interruption ends the whole group.
start() {
    set -m
    "$@" &
    set +m
    running+=($!)
}
case " $layers " in *" tools "*) start tests/tools.sh "$results" "$cache" ;; esac
layers=${layers#tools}
extent=whole
for suite in $suites; do
    if [ "$suite" = "$own" ]; then
        mv "$results/own" "$results/$suite"
        [ -e "$results/$suite/not-tested" ] && continue
    else
        prepare "$suite" tests/as_root.sh tests/make_root.sh "$suite" "$cache/roots/$suite" || continue
    fi
    start run "$suite" "$extent" "$@"
    [ -n "$everywhere" ] || extent=part
done
failed=0
for each in "${running[@]}"; do
    wait "$each" || failed=$?
done
[ "$failed" = 0 ] || exit "$failed"
rm -rf "$results/own"
# shellcheck disable=SC2086
/usr/bin/python3 tests/summary.py "$results" $suites
