# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define how much time and memory each step of FreeCAD's simulators needs on one computer."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Constants:
    """The time, s, or the memory, bytes, that each step of FreeCAD's simulators needs on one computer.

    The defaults were measured with FreeCAD 0.20.2, 1.0.0 and 1.1.3 on two Xeon cores without a graphics card. Only
    ``redraw``, ``frame``, ``draw`` and ``fill`` were not measured; they are guesses for a computer with a graphics
    card. ``document/computer/calibration.py`` has the values for drawing with the processor, and scales the times that
    depend on the processor's speed.

    Attributes
    ----------
    start : float
        Legacy simulator: time from the click on fast-forward to the first command, plus the time to show the result.
    tick : float
        Legacy simulator: time of one command in fast-forward, which a timer of 1 ms starts.
    repaint : float
        Legacy simulator: time to show that the progress of a fast-forward has increased by one percent.
    redraw : float
        Legacy simulator: time to show the part after one command while playing, without the time for the mesh.
    cell : float
        Legacy simulator: time for one cell of the grid when the grid is converted to a mesh.
    facet : float
        Legacy simulator: time to compute one triangle of the mesh.
    display : float
        Legacy simulator: time to show one triangle of the mesh.
    profile : float
        Legacy simulator: time to test whether one point is inside the tool; the tool's profile is computed by such
        tests.
    facet_bytes : float
        Legacy simulator: memory for one triangle of the mesh.
    refresh : float
        OpenGL simulator: shortest time between two frames, which is two refreshes of a 60 Hz screen.
    frame, draw : float
        OpenGL simulator: time for a frame without its draw calls, and time for one draw call.
    fill : float
        OpenGL simulator: number of draw calls that take as much time as filling the whole window once.
    line_bytes, arc_bytes : float
        OpenGL simulator: memory for a straight motion, and for an arc.
    legacy_factor, opengl_factor : float
        Uncertainty of a time: the actual time is between the estimate divided by this factor and the estimate times
        this factor.
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
