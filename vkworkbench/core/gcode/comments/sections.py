# SPDX-License-Identifier: LGPL-2.1-or-later
"""Divide an NC program into operations, at its titles and tool changes."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from math import inf
from typing import NamedTuple

import numpy as np

from vkworkbench.core.gcode.comments.titles import title_before_tool, title_of
from vkworkbench.core.gcode.comments.tool_table import ToldTool, number_named, tool_told
from vkworkbench.core.gcode.moves import codes
from vkworkbench.core.gcode.moves.codes import FEED, MODAL, MOTIONS, RAPID
from vkworkbench.core.gcode.moves.program import Program
from vkworkbench.core.gcode.moves.words import Words
from vkworkbench.core.tool import Tool

# Largest number of titles in a program that differ only in the numbers they contain (such as "Pass 1" and "Pass 2"). If
# a program has more such titles, the titles name passes, and do not begin operations.
MANY_TITLES = 50

_AXES = frozenset("XYZ")
# pcb-gcode writes the words "Tool Size" in one comment, and the tool's diameter in the next comment.
_TOOL_SIZE = re.compile(r"\s*tool size\s*", re.IGNORECASE)
# NX writes the tool's name in one comment, and the tool's diameter in a comment in the next line.
_TOOL_NAME = re.compile(r"\W*(?:tool(?:\s*(?:name|no\.?|number|type|desc\w*))?\s*[:=#]|T\d+\b)", re.IGNORECASE)
_ITS_DIAMETER = re.compile(r"\W*(?:D|(?:tool\s*)?dia(?:meter)?)\.?\s*[:=]\s*[\d.,]+", re.IGNORECASE)
# Comments that describe a tool, but do not contain the tool's name.
_NO_NAME = re.compile(r"\s*(?:TOOL/|tool_radius\b|tool size\b)", re.IGNORECASE)
# The name of a FreeCAD tool controller, which begins an operation like a title. In programs for controls without M6,
# only the controller's name shows the tool change.
_CONTROLLER = re.compile(r"\s*TC: \S")
# Estlcam writes "required tools:" in one comment, and then lists each tool of the program in a comment of its own.
_REQUIRED_TOOLS = re.compile(r"\s*required tools:\s*", re.IGNORECASE)
# Fusion lists the tools at the top of the program, and writes the comment on each tool below its tool change.
_TOOL_OF_FUSION = re.compile(r"\s*T\d+\s+D=\S+\s+CR=", re.IGNORECASE)
_MESSAGE = re.compile(r"\s*MSG\b\s*,?\s*", re.IGNORECASE)  # MSG shows the rest of the comment to the operator

# Comments at the beginning and at the end of an operation, written by py2gcode, FreeCAD, and FreeCAD's post processor
# for UCCNC. Comments within the operation describe its parameters and passes, and are not titles.
_FROM = re.compile(r"Begin (\w+)|(?i:begin operation|operation start): (\S.*)")
_TO = re.compile(r"End (\w+)|(?i:(?:finish|end) operation|operation done): (\S.*)")


@dataclass(frozen=True)
class Section:
    """One operation of an NC program, in the order of cutting.

    Attributes
    ----------
    title : str
        Title in the program's comments; without a title, the tool's name; empty if the comments contain neither.
    number : int or None
        The tool's number in T words.
    tool : Tool or None
        The tool that the program's comments describe; None if no comment describes the tool.
    first, last : int
        First and last line of the operation in the text, counted from 1.
    """

    title: str
    number: int | None
    tool: Tool | None
    first: int
    last: int


class _Mark(NamedTuple):
    """A comment or a tool change, with its position in the NC program.

    Attributes
    ----------
    at, line : int
        `at` is the index of the command after the comment, or of the tool change command. `line` is the line of the
        comment or tool change.
    what : str, float or None
        The comment's text, or the number of the new tool; None if no T word names the tool.
    called : bool
        Whether the text is a comment in a subprogram.
    """

    at: int
    line: int
    what: str | float | None
    called: bool = False

    @property
    def number(self) -> int | None:
        """Number of the new tool; None for a comment, or if no T word names the tool."""
        return int(self.what) if isinstance(self.what, (int, float)) else None


@dataclass
class _Group:
    """The comments and the tool change between two cuts.

    Attributes
    ----------
    line : int
        Line of the first comment or tool change.
    title : str
        The last title in a comment outside of subprograms.
    called : str
        The first title in a comment within a subprogram.
    headings
        All comments with a title, with the numbers that post processors write before titles.
    change, number
        Line of the last tool change, and number of the new tool; None if the group has no tool change.
    tool
        The tool that a comment without a tool number describes, or the known tool whose number a comment contains.
    tool_name
        Text of the comment that describes the group's tool.
    told
        Line of the comment that describes `tool`.
    known : dict
        The tools that the comments of this group and of all earlier groups describe, by tool number.
    """

    line: int
    title: str = ""
    called: str = ""
    headings: tuple[str, ...] = ()
    change: int | None = None
    number: int | None = None
    tool: Tool | None = None
    tool_name: str = ""
    told: int | None = None
    known: dict[int, Tool] = field(default_factory=dict)


def split_sections(program: Program) -> tuple[Section, ...]:
    """Divide an NC program into its operations, at tool changes and at titles that follow a cut.

    Returns
    -------
    tuple of Section
        At least one section. Every program line with a command is in exactly one section.
    """
    groups = _Groups(program).groups
    forms = Counter(_form(group.title) for group in groups if group.title and group.change is None)
    passes = {form for form, times in forms.items() if times > MANY_TITLES}
    sections: list[Section] = []
    number = tool = headings = None
    everything = groups[-1].known
    for group in groups:
        title = "" if _form(group.title) in passes else group.title
        if group.change is not None:
            number, tool = group.number, None
        elif sections and (not title or group.headings == headings):
            continue
        headings = group.headings
        tool = group.tool or tool
        known = None if number is None else group.known.get(number) or everything.get(number)
        if number is None and len(everything) == 1:
            (known,) = everything.values()
        if sections:
            sections[-1] = replace(sections[-1], last=group.line - 1)
        sections.append(
            Section(title or group.called or group.tool_name, number, known or tool, group.line, int(program.lines[-1]))
        )
    return tuple(sections)


class _Groups:
    """The groups of comments and tool changes between the cuts of a program; the first group precedes the first cut."""

    def __init__(self, program: Program) -> None:
        self._program = program
        marks, cuts = _marks(program), _cuts(program)
        # The tool number of each T word by the word's line, and the new tool's number of each tool change by the
        # change's line.
        self._named = {
            int(program.lines[at]): int(name[1:]) for at, name in enumerate(program.commands.names) if name[:1] == "T"
        }
        self._changes = {mark.line: mark.number for mark in marks if not isinstance(mark.what, str)}
        self._ended = {ended for _, _, text in program.comments if (ended := _named(_TO, text))}
        self._begun = (
            ""  # Name of the operation whose begin comment was read last; empty after the operation's end comment.
        )
        # The tools that the comments read so far describe.
        self._known: dict[int, Tool] = _only_required_tool(program)
        self._is_fusion = any(_TOOL_OF_FUSION.match(text) for _, _, text in program.comments)
        self.groups = [_Group(min([int(program.lines[0]), *(mark.line for mark in marks[:1])]), known=self._known)]
        listed, before = _listed(marks, cuts), 0
        for mark in marks:
            place = bisect_left(cuts, mark.at)
            if place != before:
                self.groups.append(_Group(mark.line, known=self._known))
                before = place
            if isinstance(mark.what, str):
                self._comment(mark, mark.what, is_listed=(place, mark.what) in listed)
            else:
                self.groups[-1].change, self.groups[-1].number = mark.line, mark.number

    def _comment(self, mark: _Mark, text: str, *, is_listed: bool) -> None:
        told = tool_told(text, inches=self._program.inches, of=self._changes.get(mark.line))
        if told is None or title_before_tool(text) or _CONTROLLER.match(text):
            self._title(mark, text)
        if told is None:
            return
        if told.number is not None or mark.line in self._changes or not is_listed:
            self._tool(mark.line, told, "" if _NO_NAME.match(text) else _MESSAGE.sub("", text))

    def _title(self, mark: _Mark, text: str) -> None:
        """Store a comment's title, and the known tool whose number the comment contains."""
        group = self.groups[-1]
        if group.number is None:
            number = number_named(text)
            group.tool = (None if number is None else self._known.get(number)) or group.tool
        title = self._operation(text)
        if self._is_fusion and group.title and group.change == mark.line - 1:
            return
        if title and mark.called:
            group.called = group.called or title
        elif title and not _beside_a_move(self._program, mark.at, mark.line):
            group.title, group.headings = title, (*group.headings, text)

    def _operation(self, text: str) -> str:
        """Return the title in a comment; empty for a remark, and for a comment within a named operation."""
        begins = _named(_FROM, text)
        if begins in self._ended and not self._begun:
            self._begun = begins
            return begins
        title = "" if self._begun else title_of(text)
        if self._begun and _named(_TO, text) == self._begun:
            self._begun = ""
        return title

    def _tool(self, line: int, told: ToldTool, name: str) -> None:
        """Store the tool that a comment describes under its number, or for the next cuts if the number is missing."""
        group, number = self.groups[-1], told.number
        change = line if line in self._changes else group.change
        if number is None and change is not None and line not in self._changes:
            number = self._named.get(line)  # a T word after a tool change preselects the next tool
        if number is not None:
            group.known = self._known = {**self._known, number: told.tool}
            group.tool_name = name if number == group.number else group.tool_name
        elif told.from_here or group.tool is None or change not in (None, group.told):
            # A later comment does not replace a tool that was described in the line of the tool change, unless the
            # later comment is for CutViewer (`from_here`) or in the line of another tool change.
            group.tool, group.tool_name, group.told = told.tool, name, line


def _only_required_tool(program: Program) -> dict[int, Tool]:
    """Return the tool in a list of required tools (Estlcam), if the list has one entry.

    The tool gets the number -1, which no T word has.
    """
    tools: list[Tool | None] = []
    next_line = -1
    for _, line, text in program.comments:
        if line == next_line:
            told = tool_told(f"{text} cutter", inches=program.inches)
            tools.append(told.tool if told else None)
        next_line = line + 1 if line == next_line or _REQUIRED_TOOLS.fullmatch(text) else -1
    return {-1: tools[0]} if len(tools) == 1 and tools[0] else {}


def _named(pattern: re.Pattern[str], comment: str) -> str:
    """Return the name of an operation that a pattern finds in a comment; empty if the pattern does not match.

    For each form of comments, the pattern has a group that finds the name.
    """
    found = pattern.fullmatch(comment.strip())
    return next(filter(None, found.groups())).strip() if found else ""


def _marks(program: Program) -> list[_Mark]:
    """Return the comments and the tool changes of a program, in the order of its commands and lines."""
    marks = [
        _Mark(*comment, called=number in program.in_calls)
        for number, comment in enumerate(_with_sizes(program.comments))
    ]
    for at, name in enumerate(program.commands.names):
        if name == "M6":
            marks.append(_Mark(at, int(program.lines[at]), program.commands[at][1].get("T")))
    return sorted(marks, key=lambda mark: mark[:2])


def _beside_a_move(program: Program, at: int, line: int) -> bool:
    """Return whether a comment is in the same line as a move; such a comment explains the move.

    Parameters
    ----------
    at : int
        Index of the command that follows the comment.
    line : int
        Line of the comment.
    """
    return at < len(program.commands) and program.lines[at] == line and not _AXES.isdisjoint(program.commands[at][1])


def _listed(marks: list[_Mark], cuts: np.ndarray) -> set[tuple[int, str]]:
    """Return the comments that describe tools of later tool changes.

    Each returned pair is the number of cuts before the comment, and the comment's text.

    A comment lists a later tool if its text is repeated at the change to another tool. A single repeated comment is not
    a list, because one description can fit several tools. Comments between two cuts are a list only if they describe at
    least two other tools.
    """
    placed = [(bisect_left(cuts, mark.at), mark.what) for mark in marks]
    tools = {place: what for place, what in placed if isinstance(what, (int, float))}
    said = [(place, what) for place, what in placed if isinstance(what, str) and place in tools]
    last = {what: tools[place] for place, what in said}
    others: dict[int, set[float]] = {}
    for place, what in said:
        others.setdefault(place, set()).update({last[what]} - {tools[place]})
    return {(place, what) for place, what in said if last[what] != tools[place] and len(others[place]) > 1}


def _with_sizes(comments: Iterable[tuple[int, int, str]]) -> Iterator[tuple[int, int, str]]:
    """Yield the comments; append a comment with only a tool's size to the comment before, which has the tool's name."""
    before, size, next_line = "", False, 0
    for at, line, text in comments:
        joined = before and (size or (line == next_line and _ITS_DIAMETER.match(text)))
        yield at, line, f"{before}: {text}" if joined else text
        size, next_line = _TOOL_SIZE.fullmatch(text) is not None, line + 1
        before = text if size or _TOOL_NAME.match(text) else ""


def _cuts(program: Program) -> np.ndarray:
    """Return the indices of the commands that cut, ascending, (n,) int.

    A plunge counts as a cut only if no cut in the XY plane follows the plunge, as in a drilled hole.
    """
    words = Words(program.commands)
    columns = {letter: words.column(letter) for letter in "XYZ"}
    given = {letter: ~np.isnan(values) | unusable for letter, (values, unusable) in columns.items()}
    motion = np.where(np.isin(words.codes, (*MOTIONS, MODAL)), _held(words.codes, MOTIONS), -1)
    rows = np.flatnonzero((motion >= 0) & np.any(list(given.values()), axis=0))
    motion = motion[rows]
    vertical = (motion == FEED) & ~(given["X"] | given["Y"])[rows]
    heights = _heights(words, rows, motion)
    falls = vertical & (heights[1:] < heights[:-1])
    last = np.flatnonzero(falls & ~np.append(falls[1:], False))
    first = np.flatnonzero(falls & ~np.append(False, falls[:-1]))
    after = np.minimum(last + 1, len(rows) - 1)
    is_hole = (last == len(rows) - 1) | (motion[after] == RAPID) | vertical[after]
    return np.union1d(rows[first[is_hole]], rows[(motion != RAPID) & ~vertical])


def _heights(words: Words, rows: np.ndarray, motion: np.ndarray) -> np.ndarray:
    """Return the tool's height before the first move and after each move, (n + 1,) mm.

    The height is infinite before the first Z word. After a canned cycle, the height is the R plane, because the Z word
    of a cycle is the bottom of the hole.

    Parameters
    ----------
    words : Words
    rows, motion : (n,) int
        The commands of the moves, and their motions.
    """
    relative = _held(words.codes, (codes.ABSOLUTE, codes.RELATIVE))[rows] == codes.RELATIVE
    cycle = np.isin(motion, codes.CYCLES)
    values = np.where(cycle, np.where(relative, np.nan, words.column("R", rows)[0]), words.column("Z", rows)[0])
    sets = ~np.isnan(values)
    heights, height = [inf], 0.0
    for value, is_relative in zip(values[sets].tolist(), relative[sets].tolist()):
        height = height + value if is_relative else value
        heights.append(height)
    return np.array(heights)[np.append(0, np.cumsum(sets))]


def _held(all_codes: np.ndarray, group: tuple[int, ...]) -> np.ndarray:
    """Return the code of a modal group in force at each command, (n,) int; -1 before the first code of the group."""
    last = np.maximum.accumulate(np.where(np.isin(all_codes, group), np.arange(len(all_codes)), -1))
    return np.where(last >= 0, all_codes[last], -1)


def _form(title: str) -> str:
    return re.sub(r"[\d.,]+", "#", title)
