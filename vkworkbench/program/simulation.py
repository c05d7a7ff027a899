# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate an NC program in a file, without FreeCAD."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from vkworkbench import preferences
from vkworkbench.core import (
    Cut,
    Cylinder,
    Mesh,
    Solid,
    Stock,
    Tool,
    Toolpath,
    View,
    ZBuffer,
    simulate_job,
    stock_around,
)
from vkworkbench.core.gcode import INCH, Section, at_line, read_program
from vkworkbench.core.zbuffer import (
    TOLERANCE,
    OverBudget,
    axis_view,
    check_crashes,
    facts,
    holder_collisions,
    measure_volumes,
    trajectory_table,
)
from vkworkbench.given import check_file_name, of_kind
from vkworkbench.language import Message, Unusable
from vkworkbench.program.analysis import divide_program, label_of
from vkworkbench.program.files import read_bytes, text_of
from vkworkbench.report import SimulatedPart, SimulationFacts, how_many


def simulate(
    path: str | os.PathLike[str],
    *,
    tool: Tool | Mapping[int, Tool] | None = None,
    stock: Solid | None = None,
    view: View | str | None = None,
    clamps: Mapping[str, Solid] | None = None,
    memory_budget: float | None = None,
    going_on: Callable[[float], None] = lambda _: None,
) -> ProgramSimulation:
    """Simulate an NC program, without FreeCAD.

    Parameters
    ----------
    path : path
        File of the program.
    tool : Tool, or mapping of int to Tool, optional
        The tool of the whole program, or tools by their numbers in the program. Tools that are not given are read from
        the program's comments. Operations with an unknown tool are not simulated, and remarks name these operations.
    stock : Solid, optional
        The default is a box around the cuts. A remark states that the default was used.
    view : View or str, optional
        The image, or the name of a view direction such as ``"Isometric"``. None stands for the view in the preferences.
    clamps : mapping of str to Solid, optional
        Solids that no tool may touch, by their names.
    memory_budget : float, optional
        Memory limit, bytes. None stands for the limit in the preferences.
    going_on : callable, optional
        Called many times a second with the completed share, 0 to 1. If `going_on` raises an exception, the simulation
        ends.

    Returns
    -------
    ProgramSimulation
        The simulation after the last trajectory.

    Raises
    ------
    Unusable
        If the file cannot be read, is not a milling program, has no cut, or has no known tool. The exception's message
        says what to do.
    OverBudget
        If the simulation would exceed the memory limit.
    ValueError
        If the direction is unknown, or the budget is not a number of bytes.
    TypeError
        If an argument has another type.
    """
    check_file_name(path)
    of_kind("tool", tool, (Tool, Mapping, type(None)), "a Tool(shape, diameter, ...), or tools by their numbers")
    for one in tool.values() if isinstance(tool, Mapping) else ():
        of_kind("each tool", one, Tool, "a Tool(shape, diameter, ...)")
    of_kind("clamps", clamps, (Mapping, type(None)), "solids by their names")
    for name, clamp in (clamps or {}).items():
        of_kind("the name of a clamp", name, str, "a text")
        of_kind("each clamp", clamp, (Stock, Cylinder, Mesh), "a solid: a Stock(lower, upper), a Cylinder or a Mesh")
    of_kind("view", view, (View, str, type(None)), "a View or the name of a direction")
    chosen = preferences.read()
    if isinstance(view, str):
        if view not in preferences.DIRECTIONS:
            raise ValueError(f"there is no direction {view!r}: choose among {', '.join(preferences.DIRECTIONS)}")
        view = replace(chosen.view, direction=preferences.DIRECTIONS[view])
    read = _read(Path(path), tool, chosen)
    if stock is None:
        stock = _box_around(read.cuts)
        read = replace(read, remarks=(*read.remarks, Message("stock-around-cuts")))
    budget = chosen.memory_budget_bytes if memory_budget is None else memory_budget
    zbuffer = simulate_job(read.cuts, stock=stock, view=view or chosen.view, memory_budget=budget, going_on=going_on)
    return ProgramSimulation(read, stock, dict(clamps or {}), budget, zbuffer)


@dataclass(frozen=True, eq=False)
class ReadProgram:
    """An NC program after reading, ready for simulation."""

    path: Path
    # labels, lines: label of each operation, and the range of its lines as text.
    labels: tuple[str, ...]
    lines: tuple[str, ...]
    cuts: tuple[Cut, ...]  # Moves and tool of each operation. Commands are lines of the text, counted from 1.
    remarks: tuple[Message, ...]  # remarks on ignored commands, operations that are left out, and assumptions


def _read(path: Path, tool: Tool | Mapping[int, Tool] | None, chosen: preferences.Preferences) -> ReadProgram:
    program = read_program(text_of(read_bytes(path)))
    if program.other:
        raise Unusable(program.other)
    divided = divide_program(program, chosen.tolerance)
    remarks = [at_line(problem) for problem in divided.toolpath.problems if not problem.of_time]
    if divided.inches:
        remarks.append(Message("inches-simulated"))
    labels, lines, cuts = [], [], []
    for part, section in divided.parts:
        if not len(part):
            continue
        label, own = label_of(section, path), _tool_of(section, tool, divided.inches)
        if own is None:
            remarks.append(Message("section-without-tool", label=label, line=section.first))
            continue
        labels.append(label)
        lines.append(f"lines {section.first}-{section.last}")
        moves = replace(part, points=INCH * part.points, feed=INCH * part.feed) if divided.inches else part
        cuts.append(Cut(moves, replace(own, **_missing(own, chosen.holder))))
    if not any((~cut.toolpath.rapid).any() for cut in cuts):
        raise Unusable(remarks[-1] if remarks and not cuts else Message("no-cutting-move"))
    return ReadProgram(path, tuple(labels), tuple(lines), tuple(cuts), tuple(remarks))


def _tool_of(section: Section, given: Tool | Mapping[int, Tool] | None, inches: bool) -> Tool | None:
    """Return the tool of an operation in millimetres: the given tool, or the tool that the comments describe."""
    if isinstance(given, Tool):
        return given
    if given and section.number in given:
        return given[section.number]
    tool = section.tool
    return tool.scaled(INCH) if tool is not None and inches else tool


def _missing(tool: Tool, holder: dict[str, float]) -> dict[str, float]:
    return holder if tool.holder_diameter is None else {}


def _box_around(cuts: tuple[Cut, ...]) -> Stock:
    """Return a box around all cuts as the stock.

    The top of the box is at the height 0 if all cuts are at or below 0 and at least half of the horizontal rapids are
    at or above 0. In all other cases, the top of the box is at the height of the highest cut.
    """
    cutting = [cut for cut in cuts if not cut.toolpath.rapid.all()]
    boxes = [stock_around(cut.toolpath, cut.tool) for cut in cutting]
    lower, upper = np.min([box.lower for box in boxes], axis=0), np.max([box.upper for box in boxes], axis=0)
    highest = max(map(_highest_cut, cutting))
    rapids = np.concatenate([_rapid_heights(cut.toolpath) for cut in cuts])
    top = 0.0 if highest <= 0 and 2 * np.count_nonzero(rapids >= 0) >= len(rapids) else highest
    upper[2] = max(top, lower[2] + (upper - lower)[:2].min() / 1000)
    return Stock(lower, upper)


def _sideways(toolpath: Toolpath) -> np.ndarray:
    return (np.diff(toolpath.points[:, :2], axis=0) != 0).any(axis=1)


def _highest_cut(cut: Cut) -> float:
    """Return the height of the highest feed move, mm.

    The height of a sloped move is the height of its lower end, because ramps begin above the material.

    Vertical moves count only if the operation has no other feed moves.
    """
    toolpath = cut.toolpath
    feeds, lower = ~toolpath.rapid, np.minimum(toolpath.points[:-1, 2], toolpath.points[1:, 2])
    level = feeds & _sideways(toolpath)
    return float(lower[level if level.any() else feeds].max())


def _rapid_heights(toolpath: Toolpath) -> np.ndarray:
    """Return the height of the lower end of each rapid that moves horizontally, mm."""
    heights = np.minimum(toolpath.points[:-1, 2], toolpath.points[1:, 2])
    return heights[toolpath.rapid & _sideways(toolpath)]


@dataclass(frozen=True, eq=False)
class ProgramSimulation(SimulatedPart):
    """A simulated NC program after `step` of its trajectories.

    Attributes
    ----------
    program : ReadProgram
    stock : Solid
    clamps : dict of str to Solid
    memory_budget : float
        Memory limit, bytes.
    zbuffer : ZBuffer
        Depth of every pixel and the trajectory that cut it, dexels and traces.
    """

    program: ReadProgram
    stock: Solid
    clamps: dict[str, Solid]
    memory_budget: float
    zbuffer: ZBuffer

    def __repr__(self) -> str:
        return f"<Simulation of {how_many(len(self.program.cuts), 'operation')}, {self.step} of {self.trajectories} trajectories>"

    def facts(self, *, tolerance: float = TOLERANCE) -> SimulationFacts:
        """Return the facts of each operation and of the program: removed volumes, air cuts, crashes and collisions.

        The results do not depend on the view and on `step`. Commands are lines of the program, counted from 1.
        """
        program, zbuffer = self.program, self._along_axis
        seconds = preferences.read().time_budget
        collisions = holder_collisions(zbuffer.cuts, self.stock, clamps=self.clamps)
        checked = check_crashes(program.cuts, self.stock, seconds=seconds)
        measured = measure_volumes(program.cuts, self.stock, seconds=seconds)
        found = facts(zbuffer, checked, measured, tolerance=tolerance, collisions=collisions)
        names = tuple((str(program.path), lines) for lines in program.lines)
        operations, table = tuple(zip(program.labels, found.cuts)), trajectory_table(zbuffer, measured)
        prints = ("",) * len(operations)
        verdict = replace(found.verdict, lines=True, unread=program.remarks)
        return SimulationFacts(operations, found.job, names, prints, table, program.remarks, verdict)

    @cached_property
    def _along_axis(self) -> ZBuffer:
        """The simulation along the tool axis, with an image as fine as is useful and as the limits allow."""
        seconds, begin = preferences.read().time_budget, time.monotonic()
        view = axis_view(self.program.cuts, self.stock, memory_bytes=self.memory_budget, seconds=seconds / 2)
        while True:
            try:
                return simulate_job(self.program.cuts, stock=self.stock, view=view, memory_budget=self.memory_budget)
            except OverBudget as refused:
                if refused.size is None or time.monotonic() - begin > seconds:
                    raise
                view = view.of_size(*refused.size)

    def _of_solid(self) -> ZBuffer:
        """Return the z-buffer along the tool axis, in which the walls of the solid are vertical."""
        return self.zbuffer if not self.zbuffer.frame.direction[:2].any() else self._along_axis.at(self.step)
