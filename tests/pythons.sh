#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# Run the core, and the document layer on stubs of FreeCAD, on every Python from 3.8 with its oldest and newest numpy.
#
#     tests/pythons.sh                                # all environments
#     tests/pythons.sh 3.8=1.17.5 3.13= -- -k gcode   # two environments (3.13 with the newest numpy), with pytest arguments
#
# uv makes the environments in the cache folder. It uses the Pythons of PATH and of pyenv, and downloads others. The last
# lines name the environments that could not be made, which were not tested.
set -uo pipefail
cd "$(dirname "$0")/.."

asked=()
while [ $# -gt 0 ] && [ "$1" != -- ]; do asked+=("$1"); shift; done
[ $# = 0 ] || shift
[ ${#asked[@]} -gt 0 ] || asked=(3.8=1.17.5 3.8= 3.9=1.19.5 3.10=1.21.6 3.11=1.23.5 3.12=1.26.4 3.13=2.1.3 3.13= 3.14=)

cache=${VKWORKBENCH_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/vkworkbench}/pythons
logs=build/pythons
mkdir -p "$cache" "$logs"
if [ ! -x "$cache/uv/bin/uv" ]; then
    rm -rf "$cache/uv"
    python3 -m venv "$cache/uv" && "$cache/uv/bin/pip" -q install uv || { echo "uv cannot be installed"; exit 1; }
fi
for folder in "${PYENV_ROOT:-$HOME/.pyenv}"/versions/*/bin; do PATH=$folder:$PATH; done
unset PYTHONPATH

# make PYTHON NUMPY VENV: make an environment, or write to its log why it could not be made.
make() {
    "$cache/uv/bin/uv" venv -q --clear --python "$1" "$3" &&
        "$cache/uv/bin/uv" pip install -q --python "$3/bin/python" "numpy${2:+==$2}" pytest pytest-xdist hypothesis
}

# report: print the failures in the log.
report() {
    failed=1
    grep -E '^(FAILED|ERROR)|Error' "$log" | tail -n 20
}

failed=0
missing=()
for pair in "${asked[@]}"; do
    python=${pair%%=*}
    numpy=${pair#*=}
    venv=$cache/$python-${numpy:-newest}
    log=$logs/$python-${numpy:-newest}.log
    if ! make "$python" "$numpy" "$venv" > "$log" 2>&1; then
        missing+=("Python $python, numpy ${numpy:-newest}: $(grep -v '^ *$' "$log" | tail -n 1)")
        continue
    fi
    "$venv/bin/python" -c 'import platform, numpy; print(f"Python {platform.python_version()}, numpy {numpy.__version__}:")'
    "$venv/bin/python" -m pytest -q -n 2 -m "not sources and not long" "$@" >> "$log" 2>&1 || report
    grep -v '^ *$' "$log" | tail -n 1
    "$venv/bin/python" tests/stubbed_freecad.py >> "$log" 2>&1 || report
    grep -v '^ *$' "$log" | tail -n 1
done
for each in "${missing[@]}"; do echo "NOT TESTED: $each"; done
exit "$failed"
