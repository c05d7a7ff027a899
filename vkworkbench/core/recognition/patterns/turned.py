# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a toolpath looks like one of a lathe: it turns in X and Z, and nothing moves in Y."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.recognition.thresholds import LATHE, ROUNDING
from vkworkbench.core.toolpath import Toolpath


def is_turned(toolpath: Toolpath) -> bool:
    """Tell whether a toolpath may be a lathe's whose program has no code that says so.

    A lathe's passes run along Z at many X, and each leaves the part in X from where it ends. A mill that never moves in Y
    cuts one slot or one row: it goes down to cut along X, farther than down. One that drills in a row comes up again.

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
    passes = passes[cuts[passes + 1] & ~steep[passes + 1]]
    if len(np.unique(np.rint(x[passes + 1] / ROUNDING.PLACE))) < LATHE.PASSES:
        return False
    return bool(-dz[passes].sum() > LATHE.LONGER * dx[cuts & ~steep].sum())
