# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare half circles with straight motions by their draw calls in FreeCAD's OpenGL simulator, by quality and tool.

    python3 benchmarks/opengl_draws.py

Prints a table for docs/simulators.md.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from vkworkbench.core import Stock, Tool, linearize
from vkworkbench.core.simulators import Task, opengl_cost

STOCK = Stock((0, 0, 0), (100, 100, 20))
CASES = [(radius, diameter) for radius in (5, 20) for diameter in (6, 12)]  # mm
QUALITIES = 1, 4, 8, 10  # positions of the simulator's quality slider


def draws(command, words, diameter, quality):
    """Return the number of draw calls for one command at constant height."""
    path = linearize([("G0", {"X": 0.0, "Y": 0.0, "Z": 0.0}), (command, words)])
    cost = opengl_cost(Task(path, Tool("endmill", diameter), STOCK), quality=quality)
    return cost.arc_draws if command == "G2" else cost.draws


def main():
    titles = [f"radius {radius} mm, tool {diameter} mm" for radius, diameter in CASES]
    print(f"| quality | {' | '.join(titles)} |")
    print("|---" * (1 + len(CASES)) + "|")
    for quality in QUALITIES:
        straight = draws("G1", {"X": 10.0, "F": 10.0}, 6, quality)
        counts = [
            draws("G2", {"X": 2.0 * r, "Y": 0.0, "I": float(r), "J": 0.0, "F": 10.0}, d, quality) for r, d in CASES
        ]
        print(f"| {quality} | {' | '.join(f'{count / straight:.1f}' for count in counts)} |")


if __name__ == "__main__":
    main()
