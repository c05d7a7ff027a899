# SPDX-License-Identifier: LGPL-2.1-or-later
"""The memory of a simulation: what is said, what is taken, and what is refused."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from zbuffer_reference.paths import BOX, TOOLS, surface, toolpath

from vkworkbench.core import View
from vkworkbench.core.zbuffer import OverBudget
from vkworkbench.core.zbuffer.simulate import simulate

ROOT = Path(__file__).resolve().parents[3]
# Runs in a process of its own, so that nothing from before is given back or used again.
MEASURE = """
import sys
from pathlib import Path
import numpy as np
sys.path[:0] = [{root!r}, {root!r} + "/tests"]
from vkworkbench.core import View
from vkworkbench.core.zbuffer import Cut, memory_needed, simulate
from zbuffer_reference.paths import BOX, TOOLS, surface, toolpath

def memory(line):
    status = Path("/proc/self/status").read_text()
    return 1024 * next(int(entry.split()[1]) for entry in status.splitlines() if entry.startswith(line + ":"))

trajectories, direction, width, height, tool = {case!r}
path, tool, view = toolpath(surface(None, trajectories)), TOOLS[tool], View(direction, width, height)
Path("/proc/self/clear_refs").write_text("5")
before = memory("VmRSS")
simulate(path, tool=tool, stock=BOX, view=view)
taken = memory("VmHWM") - before
# Only now: memory that it gives back would be used again, and not be seen to be taken.
print(memory_needed([Cut(path, tool)], stock=BOX, view=view), taken)
"""


def case(trajectories, direction, width, height):
    points = surface(None, trajectories)
    return toolpath(points), {"tool": TOOLS[2], "stock": BOX, "view": View(direction, width, height)}


@pytest.mark.skipif(not Path("/proc/self/clear_refs").exists(), reason="the peak is read from Linux's /proc")
@pytest.mark.parametrize(
    "which",
    [
        (10_000, (0, 0, -1), 480, 360, 2),
        (3_000, (1, 1, -1), 400, 300, 2),
        (3_000, (1, 1, -1), 400, 300, 3),
        (3_000, (0, 1, 0), 400, 300, 2),
        (100_000, (0, 0, -1), 120, 90, 2),
    ],
    ids=["records", "oblique", "oblique, bull nose", "side", "trajectories"],
)
def test_what_is_said_is_what_the_process_takes(which):
    script = MEASURE.format(root=str(ROOT), case=which)
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    expected, taken = (float(v) for v in run.stdout.split())
    assert taken < expected < 1.6 * taken


def test_too_large_a_simulation_is_refused_before_it_starts():
    path, solids = case(2000, (0, 0, -1), 400, 300)
    with pytest.raises(OverBudget) as refused:
        simulate(path, **solids, memory_budget=1e6)
    error = refused.value
    assert isinstance(error, ValueError)
    assert error.allowed == 1e6 and error.needed > 1e7
    assert "1.0 MB" in str(error) and "smaller image" in str(error)
    assert simulate(path, **solids, memory_budget=error.needed * 1.01).traces > 0


def test_a_huge_image_is_refused_by_default():
    path, solids = case(2000, (0, 0, -1), 20_000, 16_000)
    with pytest.raises(OverBudget):
        simulate(path, **solids)


def test_the_records_hold_eight_bytes_each():
    path, solids = case(2000, (0, 0, -1), 200, 150)
    z = simulate(path, **solids)
    pieces = z.traces + z.dexels
    assert z.records.far.nbytes + z.records.owner.nbytes == 8 * pieces
    assert z.memory_bytes == 8 * pieces + 8 * 200 * 150 + 4
    assert np.array_equal(np.diff(z.records.index.astype(int)).sum(), pieces)
