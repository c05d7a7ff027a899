# SPDX-License-Identifier: LGPL-2.1-or-later
"""What FreeCAD's simulators take on this computer: measured once, kept in FreeCAD's user data folder."""

from __future__ import annotations

import json
import math
import os
import platform
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import asdict, dataclass, fields, replace
from datetime import date
from pathlib import Path
from statistics import median_low

import FreeCAD
import numpy as np
import Part
from Path import Command as PathCommand
from PathSimulator import PathSim

from vkworkbench import freecad
from vkworkbench.core import Stock
from vkworkbench.core.gcode import linearize
from vkworkbench.core.simulators import (
    DEFAULTS,
    Constants,
    LegacyCost,
    OpenGLCost,
    fit_fast_forward,
    fit_play,
    legacy_work,
    motions,
)
from vkworkbench.core.zbuffer import Speed, measure_speed

# Names of OpenGL renderers on the processor, which wait for no screen, and what a frame and a draw call were measured
# to take there.
_SOFTWARE = ("llvmpipe", "softpipe", "swr", "swiftshader", "gdi generic", "microsoft basic render")
_SOFTWARE_OPENGL = {"frame": 42e-3, "draw": 15e-6}
# What a command of a play takes to show there, and a new percent of a fast-forward: Qt 6, with which FreeCAD 1.1 comes,
# also paints the window on the processor.
_SOFTWARE_PANEL = {"redraw": 40e-3}
_SOFTWARE_PANEL_QT6 = {"redraw": 56e-3, "repaint": 30e-3}
# Making meshes takes this much longer where pictures between them are drawn on the same processor.
_SOFTWARE_MESH = 1.5
# A benchmark cuts in a warm cache; real operations take this much longer (benchmarks/simulators.py).
_COLD_CACHE = 1.5
# With measured constants the true number is within this factor (benchmarks/simulators.py).
_CALIBRATED_FACTOR = 1.3
# What is kept of real runs, and how it is read from the file.
_RUNS = {
    "fast-forward": lambda run: (int(run[0]), float(run[1])),
    "play": lambda run: (int(run[0]), *(float(run[k]) for k in (1, 2, 3))),
    "draw": float,
}
_SHORTEST_PLAY = 20  # commands
_LAST_RUNS = 15
# A frame that takes less than this many refreshes may have waited for the screen.
_SLOW_FRAME = 1.25
# What the benchmark cuts.
_STOCK = Stock((0, 0, 0), (100, 60, 20))
_BOX = Part.makeBox(100, 60, 20)


@dataclass(frozen=True)
class Calibration:
    """Constants measured on one computer with one FreeCAD.

    Attributes
    ----------
    constants : Constants
        What the unit work costs there.
    date : str
        Day of the measurement, ISO 8601.
    freecad, processor, renderer : str
        What it holds for.
    runs : dict of str to tuple
        Of the last real runs: of every "fast-forward" the commands and what it took beyond cutting, s; of every "play"
        the commands, the triangles and what it took to show them and in all, s; what OpenGL's frames said of the
        constant "draw", s.
    """

    constants: Constants
    date: str
    freecad: str
    processor: str
    renderer: str
    runs: dict[str, tuple]


def processor() -> str:
    """Return the name of this computer's processor."""
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def constants(renderer: str = "") -> Constants:
    """Return the constants of this computer, measured ones where there are any.

    Parameters
    ----------
    renderer : str
        OpenGL's name of its renderer; empty where there is no window.
    """
    known = load(renderer)
    return known.constants if known else _for_renderer(DEFAULTS, renderer)


def measured_constants(renderer: str = "") -> Constants:
    """Return the constants of this computer, in a window measured now if they never were.

    Without a window FreeCAD would fill a macro's output with the progress of the benchmark's meshes.

    Parameters
    ----------
    renderer : str
        OpenGL's name of its renderer; empty where there is no window.
    """
    if FreeCAD.GuiUp and load(renderer) is None:
        with suppress(OSError):  # what cannot be kept is measured the next time
            return calibrate(renderer).constants
    return constants(renderer)


def measured_speed() -> Speed:
    """Return how fast this computer simulates in the extended z-buffer, measured now if it never was."""
    known = _speed()
    if known is None:
        known = measure_speed()
        with suppress(OSError):
            _write({_speed_key(): asdict(known)})
    return known


def _speed() -> Speed | None:
    record = _records().get(_speed_key())
    try:
        values = {field.name: float(record[field.name]) for field in fields(Speed)}
    except (TypeError, KeyError, ValueError, AttributeError):
        return None
    return Speed(**values) if all(math.isfinite(v) and v > 0 for v in values.values()) else None


def load(renderer: str = "") -> Calibration | None:
    """Return the calibration of this FreeCAD, processor and renderer; None without a readable one."""
    record = _records().get(_key(renderer))
    try:
        values = {field.name: float(record["constants"][field.name]) for field in fields(Constants)}
        if not all(math.isfinite(value) and value >= 0 for value in values.values()):
            return None
        runs = {name: tuple(map(read, record["runs"].get(name, ()))) for name, read in _RUNS.items()}
        words = (str(record[name]) for name in ("date", "freecad", "processor", "renderer"))
        return Calibration(Constants(**values), *words, runs)
    except (TypeError, KeyError, IndexError, ValueError, AttributeError):
        return None


def calibrate(renderer: str = "") -> Calibration:
    """Measure the extended z-buffer and the legacy simulator on this computer, in half a second, and remember it.

    The steps of a timer and the display cannot be measured without a window: :func:`learn` does.

    Parameters
    ----------
    renderer : str
        OpenGL's name of its renderer; empty where there is no window.

    Returns
    -------
    Calibration

    Raises
    ------
    OSError
        If the user data folder cannot be written.
    """
    _write({_speed_key(): asdict(measure_speed())})
    measured = replace(_for_renderer(_measure(), renderer), legacy_factor=_CALIBRATED_FACTOR)
    known = load(renderer)
    runs = known.runs if known else dict.fromkeys(_RUNS, ())
    version = ".".join(map(str, freecad.version()))
    return _remember(Calibration(measured, date.today().isoformat(), version, processor(), renderer, runs))


def learn(cost: LegacyCost, seconds: float, *, played: bool, renderer: str = "") -> Calibration | None:
    """Learn start, tick and repaint of fast-forward, or the display of play, from a simulation that the user ran.

    What the last fifteen runs say counts, and an odd one among them does no harm.

    Parameters
    ----------
    cost : LegacyCost
        What was predicted with :func:`constants` for what was run.
    seconds : float
        What it took.
    played : bool
        Whether it was played; else it was run in fast-forward.
    renderer : str
        OpenGL's name of its renderer.

    Returns
    -------
    Calibration or None
        The new calibration; None where the run teaches nothing: not calibrated yet, too short a play, or a
        fast-forward faster than it can be.
    """
    known = load(renderer)
    if known is None or (played and cost.shown < _SHORTEST_PLAY):
        return None
    if played:
        display = seconds - cost.play_seconds + cost.display_seconds
        return _learn(known, "play", (cost.shown, cost.drawn, display, seconds))
    panel = seconds - cost.fast_forward_seconds + cost.panel_seconds
    return _learn(known, "fast-forward", (cost.commands, panel)) if panel > 0 else None


def learn_frame(cost: OpenGLCost, seconds: float, *, renderer: str) -> Calibration | None:
    """Learn how fast OpenGL draws from the last frames of a simulation that the user ran.

    Parameters
    ----------
    cost : OpenGLCost
        What was predicted with :func:`constants` for what was run.
    seconds : float
        What a frame with all of it took.
    renderer : str
        OpenGL's name of its renderer.

    Returns
    -------
    Calibration or None
        The new calibration; None where the run teaches nothing: not calibrated yet, or a frame so short that it
        may have waited for the screen.
    """
    known = load(renderer)
    if known is None or seconds < _SLOW_FRAME * known.constants.refresh or not cost.drawing_seconds:
        return None
    slower = seconds / (known.constants.frame + cost.drawing_seconds)
    return _learn(known, "draw", known.constants.draw * slower)


def _learn(known: Calibration, name: str, run: float | tuple) -> Calibration:
    return _remember(replace(known, runs=known.runs | {name: (*known.runs[name], run)[-_LAST_RUNS:]}))


def _remember(calibration: Calibration) -> Calibration:
    """Apply what runs taught, write the calibration to the file, and return it."""
    runs = calibration.runs
    learned = {}
    if runs["fast-forward"]:
        learned |= zip(("start", "tick", "repaint"), fit_fast_forward(*np.array(runs["fast-forward"]).T))
    if runs["play"]:
        learned |= zip(("redraw", "display"), fit_play(*np.array(runs["play"]).T))
    if runs["draw"]:
        draw = median_low(runs["draw"])
        frame = calibration.constants.frame * draw / calibration.constants.draw
        learned |= {"frame": frame, "draw": draw, "opengl_factor": _CALIBRATED_FACTOR}
    calibration = replace(calibration, constants=replace(calibration.constants, **learned))
    _write({_key(calibration.renderer): asdict(calibration)})
    return calibration


def _write(new: dict) -> None:
    """Put records into the file."""
    path = _path()
    path.parent.mkdir(parents=True, exist_ok=True)
    # Another FreeCAD may read it at this moment: it sees the old file or the new one.
    fresh = path.with_suffix(f".{os.getpid()}")
    fresh.write_text(json.dumps(_records() | new, indent=1))
    os.replace(fresh, path)


def _path() -> Path:
    return Path(FreeCAD.getUserAppDataDir()) / "ToolpathAnalysis" / "calibration.json"


def _records() -> dict:
    try:
        records = json.loads(_path().read_text())
    except (OSError, ValueError):
        return {}
    return records if isinstance(records, dict) else {}


def _key(renderer: str) -> str:
    return "; ".join((".".join(map(str, freecad.version())), processor(), renderer))


def _speed_key() -> str:
    """The z-buffer's speed is that of the processor with this numpy, in every FreeCAD."""
    return "; ".join(("z-buffer", np.__version__, processor()))


def _for_renderer(base: Constants, renderer: str) -> Constants:
    if any(name in renderer.lower() for name in _SOFTWARE):
        panel = _SOFTWARE_PANEL_QT6 if freecad.version() >= freecad.QT6_SINCE else _SOFTWARE_PANEL
        pictures = {name: _here(seconds, base.cell) for name, seconds in {**_SOFTWARE_OPENGL, **panel}.items()}
        mesh = {"cell": base.cell * _SOFTWARE_MESH, "facet": base.facet * _SOFTWARE_MESH}
        return replace(base, opengl_factor=DEFAULTS.legacy_factor, refresh=0.0, **mesh, **pictures)
    return base


def _here(seconds: float, cell: float) -> float:
    """What takes so long where the defaults were measured, on a processor on which a mesh takes `cell` s a cell."""
    return seconds * cell / DEFAULTS.cell


def _measure() -> Constants:
    """Time small pieces of the legacy simulator's work, each dominated by one constant."""
    # Short moves of a tool smaller than a cell and of a few cells; long ones; short ones of a wide tool.
    pieces = [_cut(0.08, 0.1, 400), _cut(0.9, 0.1, 300), _cut(8.0, 80.0, 4), _cut(12.0, 0.1, 12)]
    work = np.array([counts for counts, _ in pieces])
    seconds = np.array([taken for _, taken in pieces])
    call, ring, line, cap = np.maximum(np.linalg.solve(work, seconds), 0) * _COLD_CACHE

    flat = PathSim()
    flat.BeginSimulation(_BOX, 0.12)  # a grid as large as in use: a smaller one stays in the cache
    cell = _best(flat.GetResultMesh) / (834 * 501)
    rough = _rough()
    rough_seconds = _best(rough.GetResultMesh)
    facets = sum(mesh.CountFacets for mesh in rough.GetResultMesh())
    facet = max(rough_seconds - cell * 51 * 61, 0) / facets

    radius, step = 2.0, 0.1
    tool = Part.makeCylinder(radius, 20)
    profile = _best(lambda: flat.SetToolShape(tool, step)) / (3 * radius / step)
    return replace(
        DEFAULTS, start=_here(DEFAULTS.start, cell), call=call, ring=ring, line=line, cap=cap, cell=cell, facet=facet,
        profile=profile,
    )  # fmt: skip


def _cut(diameter: float, length: float, count: int) -> tuple[list[float], float]:
    """Cut moves to and fro; return how many calls, rings, steps along and around that is, and the time."""
    resolution = 0.1
    words = [{"X": 10.0 + length * (i % 2), "Y": 30.0, "Z": 15.0} for i in range(count + 1)]
    commands = [PathCommand("G1", word) for word in words[1:]]
    sim = PathSim()
    sim.BeginSimulation(_BOX, resolution)
    sim.SetToolShape(Part.makeCylinder(diameter / 2, 20), diameter)  # a coarse profile: it is not timed here
    start = FreeCAD.Placement(FreeCAD.Vector(10, 30, 15), FreeCAD.Rotation())

    def run():
        position = start
        for command in commands:
            position = sim.ApplyCommand(position, command)

    made = motions(linearize([("G1", word) for word in words]))
    work = legacy_work(made, diameter=diameter, stock=_STOCK, accuracy=resolution)
    counts = [work.calls, work.rings, work.line_steps, work.cap_steps]
    return [float(count.sum()) for count in counts], _best(run)


def _rough() -> PathSim:
    """A stock of 50 x 60 cells of different heights, whose mesh joins none of them."""
    sim = PathSim()
    sim.BeginSimulation(Part.makeBox(50, 60, 20), 1.0)
    sim.SetToolShape(Part.makeCylinder(0.55, 20), 1.0)
    place = FreeCAD.Placement(FreeCAD.Vector(0, 0, 20), FreeCAD.Rotation())
    for x in range(0, 50, 2):
        for y in range(0, 60, 2):
            place = sim.ApplyCommand(place, PathCommand("G0", {"X": x + 0.5, "Y": y + 0.5, "Z": 20.0}))
            place = sim.ApplyCommand(place, PathCommand("G1", {"Z": 3.0 + (7 * x + 3 * y) % 13}))
            place = sim.ApplyCommand(place, PathCommand("G0", {"Z": 20.0}))
    return sim


def _best(work: Callable[[], object]) -> float:
    """Return the shorter time of two runs, s."""
    times = []
    for _ in range(2):
        begin = time.perf_counter()
        work()
        times.append(time.perf_counter() - begin)
    return min(times)
