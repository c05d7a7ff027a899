#!/usr/bin/env bash
# SPDX-License-Identifier: LGPL-2.1-or-later
# tools.sh RESULTS CACHE: run ruff and mypy with the settings in pyproject.toml, and check that learning again from the table
# gives the shipped model of the recognition. The tools are installed once, in a virtual environment in the folder CACHE.
# The script writes tools.log and tools.status to the folder RESULTS. If the tools cannot be installed, it writes the
# reason to tools.not-run.
set -euo pipefail

results=$1
cache=$2
cd "$(dirname "$0")/.."
mkdir -p "$results" "$cache"

venv=$cache/tools-$(cksum < tests/tools.txt | tr -d ' ')
install() {
    /usr/bin/python3 -c 'import ensurepip' || tests/as_root.sh apt-get -qy install --no-install-recommends python3-venv
    rm -rf "$venv"
    /usr/bin/python3 -m venv "$venv.new"
    "$venv.new/bin/pip" install --quiet --disable-pip-version-check -r tests/tools.txt
    mv "$venv.new" "$venv"
}
echo "    tools"
if [ ! -e "$venv" ] && ! (install) > "$results/tools.log" 2>&1; then
    rm -rf "$venv.new"
    grep -v '^$' "$results/tools.log" | tail -n 1 > "$results/tools.not-run"
    exit 0
fi

status=0
{
    "$venv/bin/python" -m ruff check --no-cache . || status=1
    "$venv/bin/python" -m ruff format --no-cache --check . || status=1
    "$venv/bin/python" -m mypy --cache-dir=/dev/null || status=1
    "$venv/bin/python" -B benchmarks/learn_model.py --check || status=1
} > "$results/tools.log" 2>&1
echo "$status" > "$results/tools.status"
