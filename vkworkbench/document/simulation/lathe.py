# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognise jobs of a lathe, which the simulation of a milling machine cannot represent."""

from __future__ import annotations

import numpy as np

from vkworkbench.core import Toolpath

# Minimum number of X positions at which a lathe cuts along Z. Lower: a mill that leaves one slot sideways counts as a
# lathe. Higher: jobs of a lathe with few passes are simulated as milling.
_PASSES = 3
# Rounding of X positions, mm: positions that are rounded to one value count as one position.
_PLACE = 1e-3


def is_turned(toolpath: Toolpath) -> bool:
    """Return whether a toolpath belongs to a lathe.

    The toolpath of a lathe does not move along Y, cuts along -Z at `_PASSES` X positions or more, and leaves each of
    these cuts sideways. In contrast, a drill leaves a hole upwards, and a mill that does not move along Y cuts a longer
    way along X than along Z.
    """
    x, y, z = toolpath.points.T
    if np.ptp(y) > 0:
        return False
    dx, dz = np.abs(np.diff(x)), np.diff(z)
    sideways, feeds = dx > np.abs(dz), ~toolpath.rapid
    passes = np.flatnonzero((feeds & (-dz > dx))[:-1] & sideways[1:])
    at = np.unique(np.rint(x[passes + 1] / _PLACE))
    return len(at) >= _PASSES and bool(-dz[passes].sum() > dx[feeds & sideways].sum())
