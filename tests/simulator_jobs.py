# SPDX-License-Identifier: LGPL-2.1-or-later
"""Stock, tool and paths for the tests of the simulators' costs."""

import numpy as np

from vkworkbench.core import Stock, Tool

STOCK = Stock((0, 0, 0), (100, 60, 20))
TOOL = Tool("endmill", 6.0)


def zigzag(rows, depth=15.0, width=80.0, pitch=2.0):
    """Return the commands of rows in alternating directions at one depth."""
    commands = [("(zigzag)", {}), ("G0", {"X": 10.0, "Y": 5.0, "Z": 25.0}), ("G1", {"Z": depth, "F": 10.0})]
    for row in range(rows):
        commands.append(("G1", {"X": 10.0 + width * ((row + 1) % 2)}))
        commands.append(("G1", {"Y": 5.0 + pitch * (row + 1)}))
    return commands


def surface(rows=60, points=60):
    """Return the commands of rows over a dome."""
    commands = [("G0", {"X": 20.0, "Y": 10.0, "Z": 25.0})]
    for row in range(rows):
        y = 10 + 40 * row / rows
        along = np.linspace(20, 80, points)[:: 1 if row % 2 == 0 else -1]
        heights = 18 - ((along - 50) ** 2 + (y - 30) ** 2) / 100
        commands += [("G1", {"X": x, "Y": y, "Z": z}) for x, z in zip(along.tolist(), heights.tolist())]
    return commands
