# SPDX-License-Identifier: LGPL-2.1-or-later
"""Detect wrong units in NC programs without a unit: inches or thousandths read as mm, and mm/min read as mm/s."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from vkworkbench.core.toolpath import Toolpath
from vkworkbench.language import Message

INCH = 25.4  # mm

# A toolpath below all three limits (SMALL, LOW and SLOW) is more often read in the wrong unit than really this small.
# benchmarks/inches.py prints how often toolpaths look like inches, at their exact size and at 1/25.4 of this size.
SMALL = 15.0  # mm, longer side of the cuts in X and Y; few parts are larger than 15 inches.
# Like SMALL, but below this limit a remark says that the unit is doubtful. With a higher limit, more parts in mm get
# this remark. If the limit is lower, more large parts in inches get no remark.
DOUBTFUL = 40.0
# mm, height from the lowest cut to the highest point; most programs in mm lift the tool farther above the cuts.
LOW = 4.0
SLOW = 5.0  # mm/s, median feed rate; few programs in inches are faster than 300 inches/min (read as 5 mm/s).
IMPORTED_SLOW = 300.0  # SLOW for toolpaths from FreeCAD's import, which reads mm/min or inches/min as mm/s.
# If the fastest feed, mm/s, reaches this limit, all feeds are read as mm/min. Some mills cut faster than 250 mm/s
# (15 m/min), but even fewer programs cut more slowly than 250 mm/min throughout.
PER_MINUTE = 250.0
# If the longer side of the cuts, mm, reaches this limit, the words can be increments of 0.001 mm. If the limit is
# lower, large parts in whole millimetres are read as increments. If this limit is higher, small parts in increments are
# missed.
LONG = 5000.0
TOOLS = 4.0  # times the tool's diameter; if the cuts are larger than this, lengths were probably read in the right unit


def looks_like_inches(
    toolpath: Toolpath, *, tool_diameter: float | None = None, imported: bool = False, small: float = SMALL
) -> bool:
    """Return whether a toolpath looks 25.4 times too small.

    Parameters
    ----------
    toolpath : Toolpath
    tool_diameter : float, optional
        Diameter of the tool, mm, if known from another source than the program.
    imported : bool
        Whether FreeCAD imported the toolpath, so that the feeds are 60 times too large.
    small : float
        Upper limit for the longer side of the cuts in X and Y, mm.
    """
    cuts = ~toolpath.rapid
    if not cuts.any():
        return False
    points = _ends(toolpath)
    size = float(np.ptp(points[:, :2], axis=0).max())
    lift = float(toolpath.points[:, 2].max() - points[:, 2].min())
    # The unit cannot be found from a single hole, whose size is 0, or a program for a laser, whose lift is 0.
    if not (0 < size < small and 0 < lift < LOW):
        return False
    if tool_diameter and size > TOOLS * tool_diameter:
        return False
    return float(np.median(toolpath.feed[cuts])) <= (IMPORTED_SLOW if imported else SLOW)


def looks_like_increments(toolpath: Toolpath, *, inches: bool) -> bool:
    """Return whether a program's lengths are probably increments, because its words have no decimal points.

    Old controls read lengths without a decimal point as multiples of 0.001 mm or 0.0001 inches. New controls read
    lengths without a decimal point in mm or inches.

    Parameters
    ----------
    toolpath : Toolpath
    inches : bool
        Whether the program is in inches.
    """
    if toolpath.rapid.all() or np.ptp(_ends(toolpath)[:, :2], axis=0).max() < LONG:
        return False
    programmed = toolpath.points[1:][(toolpath.sweep == 0) & ~toolpath.cycle] / (INCH if inches else 1.0)
    return bool((np.abs(programmed - programmed.round()) < 1e-6).all())


def _ends(toolpath: Toolpath) -> np.ndarray:
    """Return the start points and the end points of all c cuts, (2c, 3) mm."""
    cuts = ~toolpath.rapid
    return np.concatenate((toolpath.points[:-1][cuts], toolpath.points[1:][cuts]))


def in_seconds(toolpath: Toolpath) -> tuple[Toolpath, Message | None]:
    """Return an imported toolpath with its feeds in mm/s, and a message if the feeds were in mm/min, else None.

    FreeCAD's importers do not convert the F words of a file, while FreeCAD's own operations have feeds in mm/s.
    """
    fastest = float(toolpath.feed.max(initial=0.0))
    if fastest < PER_MINUTE:
        return toolpath, None
    return replace(toolpath, feed=toolpath.feed / 60), Message("feeds-per-minute", feed=fastest)
