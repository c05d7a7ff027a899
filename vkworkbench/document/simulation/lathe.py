# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise jobs of a lathe, which the simulation of a milling machine cannot represent."""

from __future__ import annotations

import numpy as np

from vkworkbench.core import Toolpath

# Minimum number of X positions of passes along Z. With a lower minimum, a mill that leaves one slot sideways counts as
# a lathe.
_PASSES = 3
# mm. Positions that differ by less count as one position.
_PLACE = 1e-3


def is_turned(toolpath: Toolpath) -> bool:
    """Return whether a toolpath in X and Z alone cuts down at `_PASSES` X positions and leaves each pass sideways.

    A drill leaves a hole upwards, and a mill that never moves along Y cuts farther along X than along Z.
    """
    x, y, z = toolpath.points.T
    if np.ptp(y) > 0:
        return False
    dx, dz = np.abs(np.diff(x)), np.diff(z)
    sideways, feeds = dx > np.abs(dz), ~toolpath.rapid
    passes = np.flatnonzero((feeds & (-dz > dx))[:-1] & sideways[1:])
    at = np.unique(np.rint(x[passes + 1] / _PLACE))
    return len(at) >= _PASSES and bool(-dz[passes].sum() > dx[feeds & sideways].sum())
