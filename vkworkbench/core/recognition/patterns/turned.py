# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise toolpaths of a lathe, which move in X and Z only."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.recognition.thresholds import LATHE, ROUNDING
from vkworkbench.core.toolpath import Toolpath


def is_turned(toolpath: Toolpath) -> bool:
    """Return whether a toolpath looks like the toolpath of a lathe, if no code of its program identifies a lathe.

    Passes of a lathe run along Z at many X positions, and each pass ends with a move in X away from the part. A mill
    that never moves in Y cuts one slot or one row, and its cuts along X are longer than its descents. A mill that
    drills a row of holes moves up again after each descent.

    Parameters
    ----------
    toolpath : Toolpath
        At least one trajectory cuts.
    """
    x, y, z = toolpath.points.T
    if np.ptp(y) > 0:
        return False
    cuts = ~toolpath.rapid
    dx, dz = np.abs(np.diff(x)), np.diff(z)
    steep = np.abs(dz) > dx
    passes = np.flatnonzero(cuts & (-dz > dx))
    passes = passes[passes < len(cuts) - 1]
    passes = passes[~steep[passes + 1]]
    if len(np.unique(np.rint(x[passes + 1] / ROUNDING.PLACE))) < LATHE.PASSES:
        return False
    return bool(-dz[passes].sum() > LATHE.LONGER * dx[cuts & ~steep].sum())
