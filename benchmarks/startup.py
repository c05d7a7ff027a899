# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure how long FreeCAD takes to start with the add-on and without it, alternately.

    xvfb-run -a python3 benchmarks/startup.py [ROUNDS]        # 8 rounds

Each start is a separate process. FreeCAD with and without the add-on have separate home folders. A start ends when
FreeCAD's event loop runs.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LEAVE = """import os
from PySide import QtCore
QtCore.QTimer.singleShot(0, lambda: os._exit(0))
"""


def home(folder: Path, with_addon: bool) -> Path:
    """Return a home folder like the home folder of the tests, with or without the add-on."""
    subprocess.run([ROOT / "tests" / "make_home.sh", folder], check=True)
    if not with_addon:
        for link in folder.glob(".local/share/FreeCAD/**/ToolpathAnalysis"):
            link.unlink()
    return folder


def start(folder: Path, script: Path) -> float:
    """Start FreeCAD and return the time until its event loop runs, s."""
    environment = {
        **os.environ, "HOME": str(folder), "XDG_RUNTIME_DIR": str(folder / "run"), "LC_ALL": "C.UTF-8",
        "LIBGL_ALWAYS_SOFTWARE": "1", "QT_QPA_PLATFORM": "xcb", "QTWEBENGINE_DISABLE_SANDBOX": "1",
    }  # fmt: skip
    begin = time.perf_counter()
    subprocess.run(["freecad", script], env=environment, check=True, capture_output=True, timeout=300)
    return time.perf_counter() - begin


def main(rounds: int) -> None:
    """Print the start times with and without the add-on."""
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "leave.py"
        script.write_text(LEAVE)
        homes = {name: home(Path(folder) / name, name == "with") for name in ("with", "without")}
        for place in homes.values():
            start(place, script)  # the first start writes caches
        taken = {name: [] for name in homes}
        for number in range(rounds):
            for name in sorted(homes, reverse=bool(number % 2)):
                taken[name].append(start(homes[name], script))
    for name, seconds in taken.items():
        print(f"{name:8} the add-on: best {min(seconds):.2f} s, median {statistics.median(seconds):.2f} s")
    print(f"ratio of the best {min(taken['with']) / min(taken['without']):.3f}, of the medians "
          f"{statistics.median(taken['with']) / statistics.median(taken['without']):.3f}")  # fmt: skip


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 8)
