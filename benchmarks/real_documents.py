#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fetch other people's FreeCAD documents with CAM jobs, and use the add-on on each document.

    python3 benchmarks/real_documents.py FOLDER [--from https://raw.githubusercontent.com]

real_documents.csv names documents in public repositories. The documents belong to their owners and stay in FOLDER. Each
document is opened in a separate FreeCAD process (document.py), because FreeCAD may crash if it cannot read a document.
The script prints how many documents were opened, analysed, marked, saved, opened again and simulated, the errors, and
the recognised strategies for each class and pattern of operations.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from collections import Counter, defaultdict
from pathlib import Path

from fetching import HOST, fetch, rows_of

HERE = Path(__file__).resolve().parent
PATIENCE = 600  # time limit for one document, s


def tried(document: Path) -> dict:
    """Return the record that document.py prints for a document; an empty record if FreeCAD does not open it."""
    command = ["freecadcmd", str(HERE / "document.py")]
    environment = {**os.environ, "VKWORKBENCH_DOCUMENT": str(document)}
    try:
        done = subprocess.run(
            command, env=environment, capture_output=True, text=True, errors="replace", timeout=PATIENCE
        )
    except subprocess.TimeoutExpired:
        return {"errors": [f"not done in {PATIENCE} s"]}
    results = [line.partition("RESULT ")[2] for line in done.stdout.splitlines() if "RESULT " in line]
    return json.loads(results[-1]) if results else {}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--from", dest="host", default=HOST)
    options = parser.parse_args()
    records, called = [], defaultdict(Counter)
    for row in rows_of(HERE / "real_documents.csv"):
        try:
            document = fetch(row, options.folder.resolve(), options.host)
        except OSError as error:
            print(f"{row['repository']} {row['path']}: {error}", file=sys.stderr)
            continue
        record = tried(document)
        records.append(record)
        for error in record.get("errors", ()):
            print(f"{row['repository']} {row['path']}: {error}", file=sys.stderr)
        for kind, strategy in record.get("operations", ()):
            called[kind][strategy] += 1
    opened = [record for record in records if record]
    done = [record for record in opened if not record["errors"]]
    refused = Counter(reason.partition(":")[0] for record in done for reason in record["refused"])
    seconds = sorted(record["seconds"] for record in done)
    print(f"{len(opened)} of {len(records)} documents were opened by FreeCAD, errors in {len(opened) - len(done)}")
    print(
        f"{sum(len(record['operations']) for record in done)} operations; saved and opened again, the same is said of all in "
        f"{sum(record['same'] for record in done)} documents"
    )
    if seconds:
        print(f"analysis of a document: {seconds[len(seconds) // 2]:.1f} s in the middle, {seconds[-1]:.1f} s at most")
    print(f"{sum(record['simulated'] for record in done)} jobs simulated; refused: {dict(refused)}")
    print("\nclass and pattern, and what its toolpaths are called")
    for kind, strategies in sorted(called.items()):
        print(f"  {kind:30s} " + ", ".join(f"{strategy} {count}" for strategy, count in strategies.most_common()))


if __name__ == "__main__":
    main()
