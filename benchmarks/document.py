# SPDX-License-Identifier: LGPL-2.1-or-later
"""Use the add-on on one document inside FreeCAD, as a user would; real_documents.py runs this script.

    VKWORKBENCH_DOCUMENT=FILE.FCStd freecadcmd $PWD/benchmarks/document.py

The script analyses and marks the document, saves and opens a copy, analyses the copy, and simulates each job. The
script prints one JSON record after the word RESULT, with the operations by FreeCAD's class and pattern, and all errors.
"""

from __future__ import annotations

import json
import os
import sys
import tempfile
import time
import traceback
from pathlib import Path

import FreeCAD

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent / "tests")]
from inside_freecad import run_and_leave

import vkworkbench
from vkworkbench import freecad
from vkworkbench.document.job.operations import find, jobs_of
from vkworkbench.language import Unusable


def told(report) -> dict[str, tuple[str, str]]:
    """Return the strategy and the warnings of each operation, by the operation's name."""
    return {o.name: (str(o.recognition and o.recognition.strategy), o.error) for o in report.operations}


def kinds(document) -> dict[str, str]:
    """Return the class of each operation and the pattern that is set in FreeCAD, by the operation's name."""
    found = {}
    for operation in find(document):
        obj = operation.object
        pattern = freecad.POCKET_PATTERN.of(obj) or freecad.SURFACE_PATTERN.of(obj) or ""
        found[obj.Name] = f"{freecad.operation_name(obj)} {pattern}".strip()
    return found


def main() -> int:
    document = FreeCAD.openDocument(os.environ["VKWORKBENCH_DOCUMENT"])
    record = {"simulated": 0, "refused": [], "errors": []}
    try:
        began = time.monotonic()
        report = vkworkbench.analyze(document)
        record["seconds"] = time.monotonic() - began
        of, said = kinds(document), told(report)
        record["operations"] = [[of[name], strategy] for name, (strategy, _) in said.items()]
        vkworkbench.mark(report)
        with tempfile.TemporaryDirectory() as folder:
            document.saveAs(f"{folder}/saved.FCStd")
            FreeCAD.closeDocument(document.Name)
            document = FreeCAD.openDocument(f"{folder}/saved.FCStd")
        record["same"] = told(vkworkbench.analyze(document)) == said
        for job in jobs_of(find(document)).values():
            try:
                vkworkbench.simulate(job).facts()
                record["simulated"] += 1
            except Unusable as error:
                record["refused"].append(str(error))
    except Exception:
        record["errors"].append(traceback.format_exc())
    print("RESULT", json.dumps(record), flush=True)
    return 0


run_and_leave(main)
