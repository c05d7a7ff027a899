# SPDX-License-Identifier: LGPL-2.1-or-later
"""Analyse the file of an NC program, which titles and tool changes divide into operations.

The report has one row for each operation.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from vkworkbench import preferences
from vkworkbench.core import Machine, Machining, Problem, Stock, Tool, Toolpath, machining, recognize, stock_around
from vkworkbench.core.gcode import (
    DOUBTFUL,
    INCH,
    Program,
    Section,
    at_line,
    looks_like_inches,
    looks_like_increments,
    read_program,
    split_sections,
    tells_inches,
)
from vkworkbench.core.recognition import recognize_inches, unknown
from vkworkbench.core.simulators import Conditions, Task, predict
from vkworkbench.language import Message, Unusable
from vkworkbench.preferences import Preferences
from vkworkbench.program.files import find_programs, read_bytes, text_of
from vkworkbench.report import Cancelled, OperationReport, Report, extent_of, setup_of, with_travel, without_results


def is_path(what) -> bool:
    """Return whether an argument is a path, or a list of paths."""
    if isinstance(what, (str, os.PathLike)):
        return True
    return (
        isinstance(what, (list, tuple)) and len(what) > 0 and all(isinstance(one, (str, os.PathLike)) for one in what)
    )


def analyze(
    what: str | os.PathLike | Iterable[str | os.PathLike],
    *,
    progress: Callable[[int, int, str], None] | None = None,
    cancelled: Callable[[], bool] | None = None,
    machine: Machine | str | os.PathLike | None = None,
) -> Report:
    """Analyse NC programs without FreeCAD. `vkworkbench.analyze` explains the parameters, the result and the errors.

    All NC programs in a folder are analysed, and the report names the other files of the folder. Each program is a job
    of the report, with one row for each operation, see `analyze_file`. `progress` and `cancelled` are called before
    each file.
    """
    left_out: list[Path] = []
    paths = list(find_programs([what] if isinstance(what, (str, os.PathLike)) else what, left_out))
    chosen = preferences.read().for_machine(machine)
    rows: list[OperationReport] = []
    for done, path in enumerate(paths):
        if cancelled is not None and cancelled():
            raise Cancelled("the analysis was cancelled; nothing has been changed")
        if progress is not None:
            progress(done, len(paths), path.name)
        rows += analyze_file(path, chosen)
    return replace(report_of(rows, chosen), left_out=tuple(map(str, left_out)))


def report_of(rows: Iterable[OperationReport], chosen: Preferences) -> Report:
    """Return a report on one or more NC programs, whose operations are the rows."""
    rows = tuple(rows)
    return Report(rows, {(row.document, row.job): row.job for row in rows if row.counted}, chosen.budget)


def analyze_file(path: Path, chosen: Preferences) -> tuple[OperationReport, ...]:
    """Analyse one program, and return a row for each operation with a cut.

    A row's document is the path of the file, and its job is the file's name. The row's name and the commands of its
    spans are line numbers, counted from 1. A program without a cut has one row. A file that cannot be read has one row,
    whose remarks contain the reason and which the total does not include.
    """
    try:
        rows = _rows(path, chosen)
        return tuple(with_travel(rows, rows, chosen.travel))
    except Unusable as error:
        return (unread(path, error.what),)
    except MemoryError:
        return (unread(path, Message("memory-short")),)
    except Exception as error:  # an error in this add-on must not stop the analysis of the other files
        return (unread(path, Message("not-analysed", error=f"{type(error).__name__}: {error}")),)


def unread(path: Path, why: Message) -> OperationReport:
    """Return the report's row for a file that has no results, with the reason as a remark."""
    return without_results(
        why, document=str(path), name="", label=path.name, job=path.name, counted=False, fingerprint=""
    )


@dataclass(frozen=True)
class _Whole:
    """Data that all operations of a program have in common."""

    path: Path
    other: Message | None
    rotary: tuple[int, ...]  # see the attributes `other` and `rotary` of `Program`
    chosen: Preferences
    stock: Stock | None  # a box around all cuts; None if no tool is known
    inches: bool  # whether the program is in inches but its numbers were read as millimetres
    remarks: tuple[Message, ...]  # remarks that are added to every operation
    # Whether no title and no tool change divides the program. An undivided program can contain several operations.
    undivided: bool


@dataclass(frozen=True)
class Divided:
    """A program that is divided into its operations."""

    toolpath: Toolpath  # the moves of the whole program; commands are lines, counted from 1
    parts: tuple[tuple[Toolpath, Section], ...]  # the moves of each operation
    # Whether the program is in inches but its numbers were read as millimetres. If True, the tools are too small by the
    # factor 25.4, like the moves.
    inches: bool


def divide_program(program: Program, tolerance: float) -> Divided:
    """Divide a program at its titles and tool changes.

    `tolerance` is the largest distance between an arc and its chords, mm.
    """
    sections, toolpath = split_sections(program), program.toolpath(tolerance=tolerance)
    inches = not program.unit_told and (
        looks_like_inches(toolpath) or any(tells_inches(text) for _, _, text in program.comments)
    )
    # Read the tools' sizes in the comments again, because sizes without a unit are in inches, unlike sizes with a unit.
    if inches:
        sections = tuple(map(_scaled_to_millimetres, split_sections(replace(program, inches=True))))
    bounds = np.searchsorted(toolpath.command, [section.first for section in sections[1:]])
    parts = [toolpath.part(int(a), int(b)) for a, b in zip([0, *bounds], [*bounds, len(toolpath)])]
    return Divided(toolpath, tuple(zip(parts, sections)), inches)


def _rows(path: Path, chosen: Preferences) -> list[OperationReport]:
    program = read_program(text_of(read_bytes(path)))
    divided = divide_program(program, chosen.tolerance)
    toolpath, inches = divided.toolpath, divided.inches
    cutting = [(part, section) for part, section in divided.parts if not part.rapid.all()]
    if not cutting:
        return [_without_cuts(path, program, toolpath)]
    remarks = [Message("inches-as-millimetres")] if inches else []
    if not (inches or program.unit_told) and looks_like_inches(toolpath, small=DOUBTFUL):
        remarks.append(Message("unit-doubtful"))
    if looks_like_increments(toolpath, inches=program.inches):
        remarks.append(Message("increments-as-units"))
    stock = _stock(toolpath, [section.tool for _, section in cutting])
    whole = _Whole(
        path, program.other, program.rotary, chosen, stock, inches, tuple(remarks),
        undivided=len(cutting) == 1 and not cutting[0][1].title,
    )  # fmt: skip
    del program  # Free memory: the program's commands need more memory than the toolpath.
    ends = [*(section.first for _, section in cutting[1:]), math.inf]
    rows, first = [], 0.0
    for (part, section), end in zip(cutting, ends):
        problems = [within for problem in toolpath.problems if (within := problem.within(first, end))]
        dwells = toolpath.dwells[(first <= toolpath.dwells[:, 0]) & (toolpath.dwells[:, 0] < end)]
        rows.append(_row(whole, replace(part, dwells=dwells), section, problems))
        first = end
    return rows


def _without_cuts(path: Path, program: Program, toolpath: Toolpath) -> OperationReport:
    """Return the report's row for an NC program without a cut."""
    row = unread(path, program.other or Message("no-cutting-move"))
    row = replace(row, remarks=(*row.remarks, *map(at_line, toolpath.problems)))
    if program.other:
        return replace(row, counted=True)
    # If a command was ignored, the program possibly has cuts.
    counted = all(problem.of_time for problem in toolpath.problems)
    return replace(row, counted=counted, recognition=recognize(toolpath), trajectories=len(toolpath),
                   machining=_machining(toolpath, toolpath.problems, None))  # fmt: skip


def _row(whole: _Whole, part: Toolpath, section: Section, problems: list[Problem]) -> OperationReport:
    """Return the report's row for one operation with its problems."""
    chosen, stock, tool = whole.chosen, whole.stock, section.tool
    remarks = [*whole.remarks, *map(at_line, problems)]
    unlike_milling = whole.other or _rotary(whole.rotary, section)
    row = replace(
        unread(whole.path, unlike_milling or Message("no-cutting-move")),
        name=f"lines {section.first}-{section.last}",
        label=label_of(section, whole.path),
        counted=True,
        trajectories=len(part),
    )
    if unlike_milling:
        return replace(row, recognition=unknown(part, unlike_milling), remarks=(*row.remarks, *remarks))
    hidden = replace(part, problems=tuple(problems)).hidden_cuts
    if hidden:
        found = unknown(part, at_line(hidden))
    elif whole.inches:
        found = recognize_inches(part, tool_diameter=tool and INCH * tool.diameter, program=whole.undivided)
    else:
        found = recognize(part, tool_diameter=tool and tool.diameter, program=whole.undivided)
    costs, advice = {}, {}
    if tool and stock:
        conditions = Conditions(
            view=chosen.view, memory_budget=chosen.memory_budget_bytes, time_budget=chosen.time_budget
        )
        costs, advice = predict(Task(part, tool, stock, recognition=found), conditions)
    else:
        remarks.append(Message("tool-not-told"))
    return replace(
        row,
        extent=extent_of(part),
        recognition=found,
        machining=_machining(part, problems, chosen.planned_machine),
        setup=setup_of("" if section.number is None else f"T{section.number}", chosen.planned_machine),
        costs=costs,
        advice=advice,
        remarks=tuple(remarks),
    )


def label_of(section: Section, path: Path) -> str:
    """Return the label of an operation: the title, or else the tool's number, or else the name of the file."""
    return section.title or (path.stem if section.number is None else f"T{section.number}")


def _scaled_to_millimetres(section: Section) -> Section:
    """Return a section with its tool scaled down by 25.4, for programs whose inches were read as millimetres."""
    return section if section.tool is None else replace(section, tool=section.tool.scaled(1 / INCH))


def _rotary(lines: tuple[int, ...], section: Section) -> Message | None:
    """Return a message if a rotary axis turns during a cut of the operation; None otherwise."""
    line = next((line for line in lines if section.first <= line <= section.last), None)
    return None if line is None else Message("rotary", line=line)


def _machining(part: Toolpath, problems: Iterable[Problem], machine: Machine | None) -> Machining:
    """Return the lengths and times of machining one operation.

    Without a machine, the time of rapids is unknown, because NC programs do not contain the speed of rapids.
    """
    found = machining(part, machine=machine)
    left_out = [message for message in found.left_out if message.code == "cutting-untimed"]
    if found.rapid_length and machine is None:
        left_out.append(Message("rapids-not-told", length=found.rapid_length))
    left_out += [at_line(problem) for problem in problems if problem.takes_time]
    return replace(found, left_out=tuple(left_out))


def _stock(toolpath: Toolpath, tools: list[Tool | None]) -> Stock | None:
    """Return a box around all cuts of a program; None if no tool is known."""
    known = [tool for tool in tools if tool]
    return stock_around(toolpath, max(known, key=lambda tool: tool.diameter)) if known else None
