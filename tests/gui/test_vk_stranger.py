# SPDX-License-Identifier: LGPL-2.1-or-later
"""A new user installs the release zip in a new home folder, follows the guide, and starts a simulation."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

TESTS = Path(__file__).resolve().parents[1]
sys.path.append(str(TESTS.parent / "resources"))
import make_release


@pytest.mark.long
def test_new_user_can_follow_the_guide(example_path, tmp_path):
    home = tmp_path / "home"
    for place in (home / ".local/share/FreeCAD/Mod", home / ".local/share/FreeCAD/v1-1/Mod"):
        with zipfile.ZipFile(make_release.make_release(tmp_path)) as file:
            file.extractall(place)
    (home / "run").mkdir(mode=0o700)
    environment = {**os.environ, "HOME": str(home), "XDG_RUNTIME_DIR": str(home / "run"), "QT_SCALE_FACTOR": "1"}
    environment.pop("PYTEST_ADDOPTS", None)
    # The second FreeCAD needs its own screen. On the same screen, the second FreeCAD would wait for the clipboard of
    # this FreeCAD, which waits for the second FreeCAD to end.
    screen = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -dpi 96 -ac"]
    # The output goes to the log of this layer of tests, in which tests/summary.py finds swallowed exceptions.
    command = [*screen, "freecad", str(example_path), str(TESTS / "stranger.py")]
    done = subprocess.run(command, env=environment, cwd=tmp_path, stdin=subprocess.DEVNULL, timeout=280, check=False)
    assert done.returncode == 0
