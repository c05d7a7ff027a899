# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operations of an NC program, divided at its titles and tool changes."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from typing import NamedTuple

from vkworkbench.core.gcode.comments.titles import title_before_tool, title_of
from vkworkbench.core.gcode.comments.tool_table import ToldTool, number_named, tool_told
from vkworkbench.core.gcode.moves.codes import MOTION_NAMES
from vkworkbench.core.gcode.moves.program import Program
from vkworkbench.core.tool import Tool

MANY_TITLES = 50  # titles of one form; a program with more numbers its passes, not its operations

_AXES = frozenset("XYZ")
# What pcb-gcode writes in a comment of its own before the one with the number.
_TOOL_SIZE = re.compile(r"\s*tool size\s*", re.IGNORECASE)
# As NX writes them: a tool's name, and its diameter in a comment of its own in the next line.
_TOOL_NAME = re.compile(r"\W*(?:tool(?:\s*(?:name|no\.?|number|type|desc\w*))?\s*[:=#]|T\d+\b)", re.IGNORECASE)
_ITS_DIAMETER = re.compile(r"\W*(?:D|(?:tool\s*)?dia(?:meter)?)\.?\s*[:=]\s*[\d.,]+", re.IGNORECASE)
# Descriptions that are no names.
_NO_NAME = re.compile(r"\s*(?:TOOL/|tool_radius\b|tool size\b)", re.IGNORECASE)
# FreeCAD's tool controllers, as it names them: with them begins what has no other title, also for a control without M6.
_CONTROLLER = re.compile(r"\s*TC: \S")
_MESSAGE = re.compile(r"\s*MSG\b\s*,?\s*", re.IGNORECASE)  # the rest is shown to who works at the machine

# What py2gcode, FreeCAD, and FreeCAD for UCCNC write before an operation and behind it; the comments between tell its
# parameters and passes.
_FROM = re.compile(r"Begin (\w+)|(?i:begin operation|operation start): (\S.*)")
_TO = re.compile(r"End (\w+)|(?i:(?:finish|end) operation|operation done): (\S.*)")


@dataclass(frozen=True)
class Section:
    """One operation of a program, in the order of cutting.

    Attributes
    ----------
    title : str
        What the program calls it, else its tool; empty where it says neither.
    number : int or None
        Number of its tool.
    tool : Tool or None
        What the program's comments say of that tool.
    first, last : int
        First and last line.
    """

    title: str
    number: int | None
    tool: Tool | None
    first: int
    last: int


class _Mark(NamedTuple):
    """A comment, or a tool change.

    Attributes
    ----------
    at, line : int
        The command before which it stands, and its line.
    what : str, float or None
        The comment's text; the number of the tool that is changed to, None where no word tells it.
    called : bool
        Whether it is a comment in a subprogram.
    """

    at: int
    line: int
    what: str | float | None
    called: bool = False

    @property
    def number(self) -> int | None:
        """Of the tool that is changed to."""
        return int(self.what) if isinstance(self.what, (int, float)) else None


@dataclass
class _Group:
    """The comments and the tool change between two cuts.

    Attributes
    ----------
    line : int
        Line of the first of them.
    title : str
        Title in the last comment that is no remark, outside of subprograms.
    called : str
        The first such title within a subprogram.
    headings
        All comments that are no remarks, with the numbers that post processors write before the titles.
    change, number
        Line of the last tool change, None where there is none, and the number of its tool.
    tool, tool_name, told
        The tool that is described without a number, or with the number that is changed to, that comment, and its line.
    known : dict
        The tools described so far, by their numbers.
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
    """Divide a program into its operations, at tool changes and at titles that follow a cut.

    Returns
    -------
    tuple of Section
        At least one; every line with a command is in one of them.
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
    """The comments and tool changes between the cuts of a program, one group for its beginning at least."""

    def __init__(self, program: Program) -> None:
        self._program = program
        marks, cuts = _marks(program), _cuts(program)
        # Tools by the lines of their T words, and of their changes.
        self._named = {
            line: int(name[1:]) for line, name in zip(program.lines.tolist(), program.commands.names) if name[:1] == "T"
        }
        self._changes = {mark.line: mark.number for mark in marks if not isinstance(mark.what, str)}
        self._ended = {ended for _, _, text in program.comments if (ended := _named(_TO, text))}
        self._begun = ""  # the operation that a comment has begun, and none has ended
        self._known: dict[int, Tool] = {}  # the tools described so far
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
        """Take a comment that may be a title, and may name a tool that was described before."""
        group = self.groups[-1]
        if group.number is None:
            number = number_named(text)
            group.tool = (None if number is None else self._known.get(number)) or group.tool
        title = self._operation(text)
        if title and mark.called:
            group.called = group.called or title
        elif title and not _beside_a_move(self._program, mark.at, mark.line):
            group.title, group.headings = title, (*group.headings, text)

    def _operation(self, text: str) -> str:
        """Return the name of an operation in a comment, empty where it is a remark, or within a named operation."""
        begins = _named(_FROM, text)
        if begins in self._ended and not self._begun:
            self._begun = begins
            return begins
        title = "" if self._begun else title_of(text)
        if self._begun and _named(_TO, text) == self._begun:
            self._begun = ""
        return title

    def _tool(self, line: int, told: ToldTool, name: str) -> None:
        """Take what a comment says of a tool: of the one that it numbers, or of the one that follows it."""
        group, number = self.groups[-1], told.number
        change = line if line in self._changes else group.change
        if number is None and change is not None and line not in self._changes:
            number = self._named.get(line)  # behind a change it is got ready
        if number is not None:
            group.known = self._known = {**self._known, number: told.tool}
            group.tool_name = name if number == group.number else group.tool_name
        elif told.from_here or group.tool is None or change not in (None, group.told):
            # What the line of a change tells stays, unless another tool is told to be the one from here on.
            group.tool, group.tool_name, group.told = told.tool, name, line


def _named(pattern: re.Pattern[str], comment: str) -> str:
    """Return the name of the operation in a comment that is of a pattern, with one group for each form; empty in others."""
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
    """Return whether a comment stands in the line of the command before which it is, a move: it says what that is for."""
    return at < len(program.commands) and program.lines[at] == line and not _AXES.isdisjoint(program.commands[at][1])


def _listed(marks: list[_Mark], cuts: list[int]) -> set[tuple[int, str]]:
    """Return the comments between two cuts, with how many cuts are before, that list tools which are changed to later.

    They are said again where they are, of two other tools at least: what one says is often true of several.
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
    """Give comments, a tool's size together with the comment before it, which says what it is, or its name."""
    before, size, next_line = "", False, 0
    for at, line, text in comments:
        joined = before and (size or (line == next_line and _ITS_DIAMETER.match(text)))
        yield at, line, f"{before}: {text}" if joined else text
        size, next_line = _TOOL_SIZE.fullmatch(text) is not None, line + 1
        before = text if size or _TOOL_NAME.match(text) else ""


def _cuts(program: Program) -> list[int]:
    """Return the commands that cut; of a plunge and what is cut from where it leads along the plane, not the plunge."""
    cuts: list[int] = []
    plunge: int | None = None  # where the tool began to go down to where it has not cut yet
    motion, depth = "", 0.0
    for at, (name, words) in enumerate(program.commands):
        motion = name if name in MOTION_NAMES else motion
        if name not in ("", motion) or not motion or _AXES.isdisjoint(words):
            continue
        vertical = _AXES.isdisjoint(words.keys() - {"Z"})
        if plunge is not None:
            if motion == "G1" and vertical and words["Z"] < depth:
                depth = words["Z"]
                continue
            if motion == "G0" or vertical:
                cuts.append(plunge)  # a hole
            plunge = None
        if motion == "G1" and vertical:
            plunge, depth = at, words["Z"]
        elif motion != "G0":
            cuts.append(at)
    return cuts if plunge is None else [*cuts, plunge]


def _form(title: str) -> str:
    return re.sub(r"[\d.,]+", "#", title)
