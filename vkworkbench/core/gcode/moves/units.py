# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether units were mistaken: inches or thousandths read as mm, mm/min as mm/s, where nothing else says it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from vkworkbench.core.toolpath import Toolpath
from vkworkbench.language import Message

INCH = 25.4  # mm

# A toolpath below all of these limits is more often in the wrong unit than really that small (benchmarks/inches.py
# prints how often toolpaths are said to be inches at their true size, and at 1/25.4 of it).
SMALL = 15.0  # mm, longer side of what is cut; a part of 15 inches is a large one
LOW = 4.0  # mm, from the lowest cut to the highest point; tools are lifted higher than this, even over a thin sheet
SLOW = 5.0  # mm/s, median feed; 300 inches a minute are fast
IMPORTED_SLOW = 300.0  # mm/s as FreeCAD imports: it takes the mm or inches a minute of a file for mm/s
# mm/s, 15 m/min. Faster mills exist, but a program whose fastest cut is slower than 250 mm/min is rarer.
PER_MINUTE = 250.0
# mm, longer side of what is cut. A part of 5 mm is small, a mill of 5 m that cuts in whole millimetres rare.
LONG = 5000.0
TOOLS = 4.0  # tool diameters; something wider was made for this tool, so its size is right


def looks_like_inches(toolpath: Toolpath, *, tool_diameter: float | None = None, imported: bool = False) -> bool:
    """Return whether a toolpath looks 25.4 times too small.

    Parameters
    ----------
    toolpath : Toolpath
    tool_diameter : float, optional
        mm, where it is known by other means than the program.
    imported : bool
        Whether FreeCAD imported it, so that its feeds are 60 times too large.
    """
    cuts = ~toolpath.rapid
    if not cuts.any():
        return False
    points = _ends(toolpath)
    size = float(np.ptp(points[:, :2], axis=0).max())
    lift = float(toolpath.points[:, 2].max() - points[:, 2].min())
    if not (0 < size < SMALL and 0 < lift < LOW):  # a single hole, or a laser, has no size, or no lift
        return False
    if tool_diameter and size > TOOLS * tool_diameter:
        return False
    return float(np.median(toolpath.feed[cuts])) <= (IMPORTED_SLOW if imported else SLOW)


def looks_like_increments(toolpath: Toolpath, *, inches: bool) -> bool:
    """Return whether a toolpath looks as if its words had no decimal point.

    Old controls count such words in least increments (0.001 mm, 0.0001 inches), new ones in whole units.

    Parameters
    ----------
    toolpath : Toolpath
    inches : bool
        Whether its program is in inches.
    """
    if toolpath.rapid.all() or np.ptp(_ends(toolpath)[:, :2], axis=0).max() < LONG:
        return False
    programmed = toolpath.points[1:][(toolpath.sweep == 0) & ~toolpath.cycle] / (INCH if inches else 1.0)
    return bool((np.abs(programmed - programmed.round()) < 1e-6).all())


def _ends(toolpath: Toolpath) -> np.ndarray:
    """Return where the cuts begin and end, (2c, 3) mm."""
    cuts = ~toolpath.rapid
    return np.concatenate((toolpath.points[:-1][cuts], toolpath.points[1:][cuts]))


def in_seconds(toolpath: Toolpath) -> tuple[Toolpath, Message | None]:
    """Return an imported toolpath with its feeds in mm/s, and what is to be said where they were mm/min.

    FreeCAD's importers keep the F words of the file as they are, while the feeds of its own operations are mm/s.
    """
    fastest = float(toolpath.feed.max(initial=0.0))
    if fastest < PER_MINUTE:
        return toolpath, None
    return replace(toolpath, feed=toolpath.feed / 60), Message("feeds-per-minute", feed=fastest)
