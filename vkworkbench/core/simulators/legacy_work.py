# SPDX-License-Identifier: LGPL-2.1-or-later
"""The work that FreeCAD's legacy simulator does to cut its grid of heights, counted exactly.

It walks every move in steps of 0.6 cell. The counts follow VolSim.cpp and PathSimulatorGui.py of FreeCAD 0.20.2, 1.0.0 and
1.1.3, which agree.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.simulators.motions import Motions
from vkworkbench.core.stocks import Solid

# A step of the walk along a move, in cells (SIM_WALK_RES in VolSim.h).
_WALK = 0.6
# Rings at the end of a move that are counted one by one; a tool of a metre has fewer on a stock of a hand's width.
_RINGS_COUNTED = 20_000


@dataclass(frozen=True)
class LegacyWork:
    """The work of cutting with the legacy simulator, counted exactly.

    Attributes
    ----------
    calls, rings, line_steps, cap_steps : (m,) float64
        For each motion: straight moves, rings of their end caps, steps along the moves and around the rings.
    cells : int
        Cells of the grid.
    resolution : float
        Edge of a cell, mm.
    """

    calls: np.ndarray
    rings: np.ndarray
    line_steps: np.ndarray
    cap_steps: np.ndarray
    cells: int
    resolution: float


def legacy_work(made: Motions, *, diameter: float, stock: Solid, accuracy: float = 0.1) -> LegacyWork:
    """Count what the legacy simulator does to cut (``ApplyLinearTool`` in VolSim.cpp).

    Every move, rapids and moves outside the stock included, walks ``2 r / 0.6`` lines of ``L / 0.6`` steps (r and L in
    cells) and ends in rings that fill half a disc, or a whole one where the move is vertical. An arc is cut in
    ``ceil(sqrt(radius / resolution) sweep)`` straight moves (``PerformCutVoxel`` in PathSimulatorGui.py).

    Parameters
    ----------
    made : Motions
        From :func:`motions`.
    diameter : float
        Widest diameter of the tool, its shank included, mm.
    stock : Solid
        Box with ``lower`` and ``upper`` corners, mm.
    accuracy : float
        Edge of a cell in percent of the stock's longer side: 1.1 - 0.1 times the slider's position, 0.1 to 1.

    Returns
    -------
    LegacyWork

    Raises
    ------
    ValueError
        If the tool or the stock has no size, or the accuracy is not positive.
    """
    side = np.asarray(stock.upper, float)[:2] - np.asarray(stock.lower, float)[:2]
    if not (np.isfinite(side).all() and (side > 0).all()):
        raise ValueError("the stock has no extent in X and Y")
    if not (np.isfinite(diameter) and diameter > 0):
        raise ValueError(f"the tool diameter must be a positive number of mm, not {diameter}")
    if not (np.isfinite(accuracy) and accuracy > 0):
        raise ValueError(f"the accuracy must be a positive number of percent, not {accuracy}")
    resolution = 0.01 * accuracy * side.max()
    cells = int((np.floor(side / resolution) + 1).prod())
    radius = diameter / 2 / resolution

    arc = np.flatnonzero(made.radius)
    calls, chord = np.ones(len(made.radius)), made.level
    if len(arc):
        arc_radius, sweep = made.radius[arc], made.sweep[arc]
        calls[arc] = np.maximum(np.ceil(np.sqrt(arc_radius / resolution) * np.abs(sweep) - 1e-9), 1.0)
        chord = chord.copy()
        chord[arc] = 2 * arc_radius * np.abs(np.sin(sweep / calls[arc] / 2))
    # Lengths are in cells across and, by an oversight of FreeCAD's, in mm upwards.
    chord = chord / resolution
    length = np.hypot(chord, made.move[:, 2] / calls)
    vertical = chord < 1e-5
    lines = np.floor(2 * radius / _WALK) + 1
    line_steps = np.where(vertical, 0.0, calls * (np.floor(length / _WALK) + 1) * lines)
    rings, half, whole = _rings(radius)
    cap_steps = calls * np.where(vertical, whole, half)
    return LegacyWork(calls, calls * rings, line_steps, cap_steps, cells, float(resolution))


def _rings(radius: float) -> tuple[float, float, float]:
    """Return the numbers of rings in a disc of `radius` cells, and of steps around half of and around all of them."""
    rings = max(np.ceil((radius + 1e-9 - 0.5) / _WALK), 0.0)
    ring = 0.5 + _WALK * np.arange(min(rings, _RINGS_COUNTED))
    half, whole = np.ceil(np.pi * ring / _WALK).sum(), np.ceil(2 * np.pi * ring / _WALK).sum()
    if rings > len(ring):  # of many each takes half a step more than its length, on average
        circles = np.pi * ((rings - 1) * rings / 2 + rings * 0.5 / _WALK)
        half, whole = circles + rings / 2, 2 * circles + rings / 2
    return float(rings), float(half), float(whole)
