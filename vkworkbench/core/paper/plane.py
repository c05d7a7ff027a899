# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the working plane of a motion: XY, ZX or YZ."""

from __future__ import annotations

import numpy as np

from vkworkbench.core.paper.thresholds import MOVES
from vkworkbench.core.toolpath import PLANE_AXES

XY, ZX, YZ = (PLANE_AXES[number] for number in (17, 18, 19))


def plane_of_points(points: np.ndarray) -> tuple[int, ...]:
    """Return the two axes of a polyline's plane, and the axis of the plane's normal.

    The plane is XY, unless Z changes and only one of X and Y changes.
    """
    if points.shape[1] == 3 and len(points):
        still_x, still_y = (points[:, axis].min() == points[:, axis].max() for axis in (0, 1))
        if still_x != still_y and points[:, 2].min() != points[:, 2].max():
            return YZ if still_x else ZX
    return XY


def plane_of_toolpath(points: np.ndarray, rapid: np.ndarray) -> tuple[int, ...]:
    """Return the two axes of a toolpath's working plane, and the axis of the plane's normal.

    The plane is XY, unless all cuts are in one vertical plane and some cuts slope (contouring in G18). In XY, all rows
    of a toolpath in a vertical plane would be on one line. A slot that is cut at several depths, by horizontal passes
    and vertical plunges, has no sloping cuts, so its plane is XY.
    """
    every = len(rapid) // 50 + 1
    few = np.flatnonzero(~rapid[::every]) * every
    for axes in (ZX, YZ):
        u, v, aside = (points[:, axis] for axis in axes)
        if not len(few) or np.ptp(aside[few]) > MOVES.STILL:
            continue
        cutting = np.flatnonzero(~rapid)
        if np.ptp(aside[cutting]) > MOVES.STILL or np.ptp(aside[cutting + 1]) > MOVES.STILL:
            continue
        du, dv = np.abs(u[cutting + 1] - u[cutting]), np.abs(v[cutting + 1] - v[cutting])
        if ((du > MOVES.SLOPED * dv) & (dv > MOVES.SLOPED * du)).any():
            return axes
    return XY
