# SPDX-License-Identifier: LGPL-2.1-or-later
"""Predict the cost of FreeCAD's OpenGL simulator (``CAMSimulator.PathSim``) from exact counts of its draw calls.

For each frame, the simulator draws all motions from the first to the present one nine times. The draw calls are counted
as in MillPathSegment.cpp and MillSimulation.cpp of FreeCAD 1.0.0.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from vkworkbench.core.simulators.constants import DEFAULTS, Constants
from vkworkbench.core.simulators.motions import Motions
from vkworkbench.core.simulators.simulator import Caution, Conditions, Task
from vkworkbench.core.tool import Tool
from vkworkbench.language import Message

NAME = "OpenGL"
SINCE = (1, 0)
SLOWEST_FRAME = 0.1  # longest time of a frame for which the user gets no message, s (ten frames per second)

# Smallest and largest angle of an arc that one chord replaces, rad (MillPathSegment.cpp).
_SMALLEST_STEP, _LARGEST_STEP = np.pi / 90, np.pi / 2
# How often a motion is drawn in one frame: in four rendering passes with two stencil steps each, and in one pass for
# the colour (MillSimulation.cpp).
_PASSES = 9
# Assumed height of the tool in the simulator's picture, mm. FreeCAD's tool bits are 20 to 50 mm long.
_TOOL_HEIGHT = 30.0
# The first view of the simulator looks along Y and 30 degrees (_TILT) down, from a distance of 1.6 times the stock's
# longer side. The window is assumed to have the ratio 4:3; its height shows an angle of 0.7 rad (SimDisplay.cpp).
_TILT = np.pi / 6
# Area visible in the window, divided by the square of the stock's longer side.
_WINDOW = 4 / 3 * (2 * 1.6 * np.tan(0.35)) ** 2
# _CORNER_PIECE: length of the segments in which a rounded corner of the tool is drawn, mm (SimulatorGL.py).
# _LONGER_PER_SEGMENT: a flat tool's outline has two segments, and each additional segment increases the drawing time by
# this share (benchmarks/simulators.py).
_CORNER_PIECE = 0.5
_LONGER_PER_SEGMENT = 0.1
# Number of parts into which an operation is divided to estimate how much longer its frames take after other operations.
_PARTS = 32


def opengl_speeds(version: tuple[int, ...]) -> tuple[int, ...]:
    """Return the numbers of simulation steps per frame that the speed button offers in a version of FreeCAD."""
    return (1, 5, 10, 25, 50) if tuple(version[:2]) >= (1, 1) else (1, 10, 40)


@dataclass(frozen=True, eq=False)
class OpenGLWork:
    """The numbers of simulation steps and draw calls in the OpenGL simulator, counted exactly."""

    # (m,) float64: number of simulation steps in which each motion is played. The speed of a play is given in steps per
    # frame.
    steps: np.ndarray
    draws: np.ndarray  # (m,) float64: number of draw calls for each motion in every frame after the motion is finished
    # (m,) float64: area drawn for each motion in one rendering pass, as it appears in the first view, mm^2.
    area: np.ndarray
    # (m,) bool: whether each motion is an arc. While an arc is played, only its finished part is drawn; a straight
    # motion is always drawn completely.
    arc: np.ndarray


def opengl_work(made: Motions, *, diameter: float, quality: int = 10) -> OpenGLWork:
    """Count the steps and draw calls as the OpenGL simulator does (``MillPathSegment`` and ``RenderSimulation``).

    `diameter` is the diameter of the tool, mm, and `quality` the position of the quality slider, 1 to 10.
    """
    # The simulator computes its resolution before it knows the stock, so it always uses a stock size of 100 mm.
    resolution = min(max(100 * 0.05 / quality, 0.5), 4.0)
    small_step = np.pi / (8 if quality >= 8 else 4 if quality >= 4 else 2)

    arc = made.radius > 0
    small = made.radius <= diameter / 2
    ratio = np.divide(resolution, made.radius, out=np.ones(len(arc)), where=made.radius > resolution)
    step = np.where(small, small_step, np.clip(np.arcsin(ratio), _SMALLEST_STEP, _LARGEST_STEP))
    chords = np.floor(np.abs(made.sweep) / step) + np.where(small, 1, 2)
    lines = np.maximum(np.floor(np.linalg.norm(made.move, axis=1) / resolution), 1)
    draws = _PASSES * np.where(arc, chords, np.where(made.level < 1e-6, 1, 2))
    return OpenGLWork(np.where(arc, chords, lines), draws, _seen(made, diameter, arc & small, chords), arc)


def _seen(made: Motions, diameter: float, small: np.ndarray, chords: np.ndarray) -> np.ndarray:
    """Return the area drawn for each motion, as it appears in the first view, (m,) mm^2.

    A straight motion is drawn as the box that it sweeps and the front half of the tool. A vertical motion is drawn as
    the tool. An arc is drawn as a box for every chord and the tool at the end. A small arc is drawn as the tool at the
    end of every chord.
    """
    disc = np.pi / 4 * diameter**2
    x, y = np.abs(made.move[:, :2]).T
    across = np.divide(y, made.level, out=np.zeros(len(y)), where=made.level > 0)
    # The chords of an arc have all directions. On average, 2 / pi of a chord's length is visible (the mean of |cos|).
    arc, turned = made.radius * np.abs(made.sweep), 2 / np.pi
    kinds = small, made.radius > 0, made.level < 1e-6
    wide = np.select(
        kinds,
        (chords * diameter, turned * (arc + (chords - 1) * diameter) + diameter, diameter),
        x + across * diameter + (1 + across) * diameter / 2,
    )
    flat = np.select(kinds, (chords * disc, arc * diameter + disc, disc), made.level * diameter + disc / 2)
    return _TOOL_HEIGHT * np.cos(_TILT) * wide + np.sin(_TILT) * flat


def outline_segments(tool: Tool) -> int:
    """Return the number of segments in the tool's drawn outline: side, rounded corner, and flat end or cone."""
    corner = int(tool.rounding * np.pi / 2 / _CORNER_PIECE) + 1 if tool.rounding else 0
    return 1 + corner + (tool.rounding < tool.radius)


@dataclass(frozen=True)
class OpenGLCost:
    """The cost of one operation, or of several operations in sequence, in the OpenGL simulator.

    Attributes
    ----------
    drawing_seconds : float
        Time to draw all motions in one frame, without the constant part of the frame's time, s.
    play_seconds : dict of int to float
        Time of a play, s, for each speed in simulation steps per frame.
    memory_bytes : float
        Memory for the buffers of the motions, bytes.
    draws : int
        Number of draw calls of the last frame.
    arc_draws : int
        Number of draw calls for arcs in the last frame.
    steps : int
        Number of simulation steps in which all motions are played.
    constants : Constants
        Times and memory sizes of the simulator's steps, with which the cost was predicted.
    """

    drawing_seconds: float
    play_seconds: dict[int, float]
    memory_bytes: float
    draws: int
    arc_draws: int
    steps: int
    constants: Constants

    @property
    def seconds(self) -> float:
        """float : the time of a play at the highest speed, s, which the user sees as the OpenGL simulator's time."""
        return self.play_seconds[max(self.play_seconds)]

    @property
    def factor(self) -> float:
        """float : the actual time is between the estimate divided by this factor and the estimate times this factor."""
        return self.constants.opengl_factor

    @property
    def frame_seconds(self) -> float:
        """float : time for the last frame of a play, and for each frame while the user turns the finished part, s."""
        return max(self.constants.refresh, self.constants.frame + self.drawing_seconds)


def opengl_cost(
    task: Task, *, speeds: tuple[int, ...] = (1, 5, 10, 25, 50), quality: int = 10, constants: Constants = DEFAULTS
) -> OpenGLCost:
    """Estimate the cost of one operation in the OpenGL simulator.

    For each frame, all motions from the first to the present one are drawn in nine passes. In each drawing pass, a
    straight motion needs two draw calls, a vertical motion one, and an arc one per chord. Therefore the time of a play
    increases with the square of the number of motions. The time to fill the area that a motion covers in the window is
    expressed as additional draw calls. A rounded tool takes longer to draw, because its outline has more segments.

    Parameters
    ----------
    speeds : tuple of int
        Speeds in simulation steps per frame; see :func:`opengl_speeds`.
    quality : int
        Position of the quality slider, 1 to 10.
    constants : Constants
        Times and memory sizes of the simulator's steps.
    """
    tool, stock = task.cutting
    work = opengl_work(task.motions, diameter=tool.diameter, quality=quality)
    steps, draws, arc = work.steps, work.draws, work.arc
    window = _WINDOW * float(np.max((stock.upper - stock.lower)[:2])) ** 2
    longer = 1 + _LONGER_PER_SEGMENT * (outline_segments(tool) - 2)
    drawing = constants.draw * longer * (draws + constants.fill * _PASSES * work.area / window)

    # Compute the mean time of the frames during each motion. A straight motion is drawn completely in its first frame.
    # An arc is drawn chord by chord, so half of the arc is drawn on average.
    before = np.cumsum(drawing) - drawing
    frames = np.maximum(constants.frame + before + np.where(arc, drawing / 2, drawing), constants.refresh)
    total = float((steps * frames).sum())
    return OpenGLCost(
        drawing_seconds=float(drawing.sum()),
        play_seconds={speed: total / speed for speed in speeds},
        memory_bytes=float(np.where(arc, constants.arc_bytes, constants.line_bytes).sum()),
        draws=int(draws.sum()),
        arc_draws=int(draws[arc].sum()),
        steps=int(steps.sum()),
        constants=constants,
    )


def opengl_together(costs: Sequence[OpenGLCost]) -> OpenGLCost:
    """Estimate the cost of playing several operations one after the other in the OpenGL simulator.

    Every frame of an operation also draws all motions of the earlier operations, so playing all operations in one
    simulation takes longer than the sum of the separate plays.

    Parameters
    ----------
    costs : sequence of OpenGLCost
        Costs of at least one operation, in the order of the operations. All costs must be predicted for the same stock
        and speeds.
    """
    constants = costs[0].constants
    part = (np.arange(_PARTS) + 0.5) / _PARTS
    before = longer = 0.0
    for cost in costs:
        alone = constants.frame + cost.drawing_seconds * part
        added = np.maximum(before + alone, constants.refresh) - np.maximum(alone, constants.refresh)
        longer += cost.steps * float(added.mean())
        before += cost.drawing_seconds
    return OpenGLCost(
        drawing_seconds=before,
        play_seconds={s: sum(c.play_seconds[s] for c in costs) + longer / s for s in costs[0].play_seconds},
        memory_bytes=sum(cost.memory_bytes for cost in costs),
        draws=sum(cost.draws for cost in costs),
        arc_draws=sum(cost.arc_draws for cost in costs),
        steps=sum(cost.steps for cost in costs),
        constants=constants,
    )


def cautions(task: Task, cost: OpenGLCost | None, conditions: Conditions) -> list[Caution]:
    """Return a warning if a play at the highest speed takes longer than the time budget."""
    if cost is None or cost.seconds <= conditions.time_budget:
        return []
    return [Caution("long-play", Message("opengl-long-play", simulator=NAME, time=cost.seconds))]


def slow_frames(cost: OpenGLCost) -> Message | None:
    """Return a message if the frames at the end of a job are slow, mostly because of arcs; otherwise None."""
    if cost.frame_seconds <= SLOWEST_FRAME or 2 * cost.arc_draws <= cost.draws:
        return None
    return Message("opengl-arcs", simulator=NAME, frames=1 / cost.frame_seconds)
