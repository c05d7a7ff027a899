# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cost of one unit of each kind of work of FreeCAD's simulators, on one computer."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Constants:
    """The cost of one unit of work on one computer, seconds and bytes.

    The defaults were measured with FreeCAD 0.20.2, 1.0.0 and 1.1.3 on two Xeon cores without a graphics card;
    ``redraw``, ``frame``, ``draw`` and ``fill`` are guesses for a computer with a graphics card: none was measured.
    ``document/computer/calibration.py`` has the values for software rendering, ``document/computer/measuring.py`` measures the user's computer.

    Attributes
    ----------
    start : float
        Legacy: from the press of fast-forward to the first command, and showing the result.
    tick : float
        Legacy: one command in fast-forward (a timer of 1 ms).
    repaint : float
        Legacy: showing another percent of a fast-forward's progress.
    redraw : float
        Legacy: showing one command in play, without its mesh.
    cell : float
        Legacy: one cell of the grid, each time it becomes a mesh.
    facet : float
        Legacy: one triangle of the mesh.
    display : float
        Legacy: showing one triangle of a mesh.
    profile : float
        Legacy: one test whether a point is inside the tool, when the tool's profile is taken.
    facet_bytes : float
        Legacy: memory of one triangle.
    refresh : float
        OpenGL: the shortest time from one frame to the next (two refreshes of a 60 Hz screen).
    frame, draw : float
        OpenGL: the part of every frame that does not depend on the path, and one draw call.
    fill : float
        OpenGL: filling the whole window once; not in seconds but in draw calls that take as long.
    line_bytes, arc_bytes : float
        OpenGL: memory of a straight motion and of an arc.
    legacy_factor, opengl_factor : float
        The true time is between the estimate divided and multiplied by this.
    """

    start: float = 0.32
    tick: float = 1.087e-3
    repaint: float = 0.0
    redraw: float = 0.025
    cell: float = 27e-9
    facet: float = 1.7e-6
    display: float = 1e-6
    profile: float = 0.1e-3
    facet_bytes: float = 150.0
    refresh: float = 1 / 30
    frame: float = 1e-3
    draw: float = 1.5e-6
    fill: float = 150.0
    line_bytes: float = 900.0
    arc_bytes: float = 7000.0
    legacy_factor: float = 2.0
    opengl_factor: float = 4.0


DEFAULTS = Constants()
