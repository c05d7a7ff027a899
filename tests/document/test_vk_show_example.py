# SPDX-License-Identifier: LGPL-2.1-or-later
"""The README's first command (examples/show_example.py) opens a window and writes the promised files."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.long
def test_show_example_writes_table_document_and_picture(tmp_path):
    home, output = tmp_path / "home", tmp_path / "output"
    output.mkdir()
    subprocess.run([str(ROOT / "tests/make_home.sh"), str(home)], check=True, timeout=300)
    environment = {**os.environ, "HOME": str(home), "XDG_RUNTIME_DIR": str(home / "run"), "VKWORKBENCH_OUTPUT": str(output),
                   "VKWORKBENCH_LEAVE": "1"}  # fmt: skip
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24", "freecad", str(ROOT / "examples/show_example.py")]
    done = subprocess.run(command, env=environment, stdin=subprocess.DEVNULL, text=True, timeout=300, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)  # fmt: skip
    assert done.returncode == 0, done.stdout[-3000:]
    table = (output / "report.txt").read_text(encoding="utf-8")
    assert "Pocket zigzag         zigzag" in table and "O1234                 spiral" in table
    assert "The operation is called ZigZag, but its toolpath is contour-parallel." in table
    assert all((output / name).stat().st_size > 1000 for name in ("marked.FCStd", "tree.png"))
