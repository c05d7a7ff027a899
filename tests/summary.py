# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check the results of run_layers.sh; print a table of FreeCAD versions and layers of tests, and a line with the sums.

    python3 tests/summary.py RESULTS SUITES...       # a folder with one folder for each Debian suite

Exits with 1 if a test failed, a layer of tests did not end by itself, or FreeCAD swallowed an exception: FreeCAD prints
such an exception and continues, so only its log has it. A FreeCAD that could not be installed or run is named; it is
not a failure.
"""

from __future__ import annotations

import re
import sys
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree

LAYERS = "core", "document", "gui"
SWALLOWED = re.compile(r"^.*(Traceback \(most recent call last\)|During initialization the error).*", re.MULTILINE)
STATUS = {"5": "no test was selected", "124": "stopped after too long a time"}


def count(report):
    """Return the numbers of passed, failed and skipped tests in a JUnit file."""
    numbers = Counter()
    for suite in ElementTree.parse(report).iter("testsuite"):
        failed = int(suite.get("failures")) + int(suite.get("errors"))
        skipped = int(suite.get("skipped"))
        numbers += Counter(failed=failed, skipped=skipped, passed=int(suite.get("tests")) - failed - skipped)
    return numbers


def judge(folder, layer):
    """Return the counts of the tests of `layer`, and a description of a problem beyond single tests, or ""."""
    status = (folder / f"{layer}.status").read_text().strip()
    report = folder / f"{layer}.xml"
    numbers = count(report) if report.exists() else Counter()
    problem = ""
    explained = status == "0" or (status in ("1", "2") and numbers["failed"])
    if not report.exists() or not explained:
        problem = STATUS.get(status, f"ended with status {status}")
    elif layer != "core" and not numbers["failed"]:
        swallowed = SWALLOWED.findall((folder / f"{layer}.log").read_text(errors="replace"))
        if swallowed:
            problem = f"FreeCAD swallowed {len(swallowed)} exceptions"
    return numbers, problem


def tail(log):
    """Return the part of a log with the failures."""
    lines = log.read_text(errors="replace").splitlines()
    starts = [n for n, line in enumerate(lines) if re.match(r"=+ (FAILURES|ERRORS) =+|Traceback|Fatal|Timeout", line)]
    ends = [n for n, line in enumerate(lines) if re.match(r"=+ warnings summary =+", line)]
    first = starts[0] if starts else max(len(lines) - 30, 0)
    return "\n".join("    " + line for line in lines[first : ends[0] if ends else None][:200])


def in_words(numbers):
    return ", ".join(f"{numbers[key]} {key}" for key in ("passed", "failed", "skipped") if numbers[key])


def duration(folder, layer):
    """Return the duration of a layer of tests, for example "in 3:05" (minutes and seconds)."""
    return "in {}:{:02}".format(*divmod(int((folder / f"{layer}.seconds").read_text()), 60))


def judge_tools(results):
    """Return the result of ruff, mypy and the check of the model as one line, and True or False for success, or None if they did not run."""
    if (results / "tools.not-run").exists():
        return f"NOT RUN: ruff, mypy and the model: {(results / 'tools.not-run').read_text().strip()}", None
    if not (results / "tools.status").exists():
        return "ruff, mypy and the model: not run", None
    if (results / "tools.status").read_text().strip() == "0":
        return "ruff, mypy and the model: nothing found", True
    log = results / "tools.log"
    print(f"\nruff, mypy or the model: something was found; {log}:", log.read_text(errors="replace"), sep="\n")
    return "ruff, mypy and the model: found something", False


def main(results, suites):
    total = Counter()
    tools, content = judge_tools(results)
    if content is not None:
        total["passed" if content else "failed"] += 1
    rows, absent = [], []
    for folder in [results / suite for suite in suites]:
        reason = folder / "not-tested"
        if reason.exists():
            rows.append([folder.name] + ["not tested"] * len(LAYERS))
            absent.append(f"NOT TESTED: FreeCAD of {folder.name}: {reason.read_text().strip()}")
            continue
        row = [f"{folder.name}: {(folder / 'versions').read_text().strip()}"]
        for layer in LAYERS:
            if not (folder / f"{layer}.status").exists():
                row.append("not run")
                continue
            numbers, problem = judge(folder, layer)
            if problem:
                numbers["failed"] += 1
            if numbers["failed"]:
                print(f"\n{folder.name}, {layer}: {problem or in_words(numbers)}; {folder / layer}.log:")
                print(tail(folder / f"{layer}.log"))
            total += numbers
            row.append("; ".join(filter(None, [f"{in_words(numbers)} {duration(folder, layer)}", problem])))
        rows.append(row)

    table = [["", *LAYERS], *rows]
    widths = [max(len(row[column]) for row in table) for column in range(len(LAYERS) + 1)]
    print()
    for row in table:
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip())
    print(tools, *absent, sep="\n")
    print(
        f"{total['passed']} passed, {total['failed']} failed" + f", {total['skipped']} skipped" * bool(total["skipped"])
    )
    return 1 if total["failed"] or not total["passed"] else 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]), sys.argv[2:]))
