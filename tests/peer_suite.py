# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own CAM tests with and without this add-on, test by test. peer_suite.sh runs this file.

In FreeCAD's window: run TestPathApp (0.20) or TestCAMApp (1.x) and write the result of each test to the file in
the environment variable VK_PEER_RESULTS. Where VK_PEER_ADDON is set, the add-on has to be installed and is active:
the watcher watches, and after every recompute all operations of the document are analysed and marked, as if the
user did it at once.

    python3 tests/peer_suite.py WITHOUT.json WITH.json      # compares, exits with 1 where they differ
"""

from __future__ import annotations

import importlib.util
import json
import os
import sys
import time
import traceback
import types
import unittest
from collections import Counter
from pathlib import Path


class Recorder(unittest.TextTestResult):
    """Keep the outcome of every test by its name. The subtests of a test have a common outcome."""

    def __init__(self, *args):
        super().__init__(*args)
        self.outcome = {}

    def startTest(self, test):
        super().startTest(test)
        self.outcome[test.id()] = "passed"

    def _worse(self, test, what, error=None):
        self.outcome[test.id()] = f"{what}: {error[0].__name__}" if error else what

    def addError(self, test, err):
        super().addError(test, err)
        self._worse(test, "error", err)

    def addFailure(self, test, err):
        super().addFailure(test, err)
        self._worse(test, "failed", err)

    def addSubTest(self, test, subtest, err):
        super().addSubTest(test, subtest, err)
        if err:
            self._worse(test, "failed", err)

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        self._worse(test, "skipped")

    def addExpectedFailure(self, test, err):
        super().addExpectedFailure(test, err)
        self._worse(test, "expected failure")

    def addUnexpectedSuccess(self, test):
        super().addUnexpectedSuccess(test)
        self._worse(test, "unexpected success")


class MarkAtOnce:
    """Analyse and mark every document after each of its recomputes."""

    def __init__(self):
        self.marked, self.analyzed, self.errors, self.busy = 0, 0, [], False

    def slotRecomputedDocument(self, document):
        if self.busy:
            return
        self.busy = True
        try:
            import vkworkbench

            report = vkworkbench.analyze(document)
            self.analyzed += len(report.operations)
            self.marked += vkworkbench.mark(report)
        except Exception:
            self.errors.append(traceback.format_exc())
        finally:
            self.busy = False


def run(results, addon):
    """Run FreeCAD's tests and write the result of each test."""
    import FreeCAD
    import FreeCADGui as Gui

    old = FreeCAD.Version()[0] == "0"
    Gui.activateWorkbench("PathWorkbench" if old else "CAMWorkbench")
    assert ("VkWorkbench" in Gui.listWorkbenches()) == ("vkworkbench" in sys.modules) == addon
    # TestCAMApp of 1.0 imports imghdr without using it, and Python 3.13 has no imghdr.
    if importlib.util.find_spec("imghdr") is None:
        sys.modules["imghdr"] = types.ModuleType("imghdr")

    observer = None
    if addon:
        from vkworkbench.document import upkeep

        upkeep.watch()
        observer = MarkAtOnce()
        FreeCAD.addDocumentObserver(observer)
    module = "TestPathApp" if old else "TestCAMApp"
    suite = unittest.defaultTestLoader.loadTestsFromName(module)
    start = time.time()
    found = unittest.TextTestRunner(resultclass=Recorder, verbosity=0).run(suite)
    data = {"module": module, "seconds": time.time() - start, "tests": found.outcome}
    if observer:
        data |= {"analyzed": observer.analyzed, "marked": observer.marked, "errors": observer.errors}
    with open(results, "w", encoding="utf-8") as file:
        json.dump(data, file, indent=1)


def compare(without, with_addon):
    """Print how two runs differ. Return 1 if they differ, or if the add-on failed or marked nothing."""
    sides = []
    for path in (without, with_addon):
        with open(path, encoding="utf-8") as file:
            sides.append(json.load(file))
    plain, marked = (side["tests"] for side in sides)
    different = [name for name in sorted(plain | marked) if plain.get(name) != marked.get(name)]
    for name in different:
        print(f"  {name}: {plain.get(name)} without the add-on, {marked.get(name)} with it")
    for error in sides[1]["errors"][:3]:
        print(error)
    counts = ", ".join(f"{n} {what}" for what, n in Counter(o.split(":")[0] for o in plain.values()).most_common())
    print(
        f"{sides[0]['module']}: {len(plain)} tests without the add-on ({counts}), {len(marked)} with it, {len(different)} "
        f"different; {sides[1]['analyzed']} analyses and {sides[1]['marked']} marks meanwhile, "
        f"{len(sides[1]['errors'])} errors of the add-on; {sides[0]['seconds']:.0f} s and {sides[1]['seconds']:.0f} s"
    )
    return 1 if different or sides[1]["errors"] or not plain or not sides[1]["marked"] else 0


def inside():
    """Run the tests inside FreeCAD."""
    run(os.environ["VK_PEER_RESULTS"], bool(os.environ.get("VK_PEER_ADDON")))
    return 0


if "VK_PEER_RESULTS" in os.environ:
    sys.path.insert(0, str(Path(__file__).parent))
    from inside_freecad import run_and_leave

    run_and_leave(inside)
elif __name__ == "__main__":
    sys.exit(compare(*sys.argv[1:]))
