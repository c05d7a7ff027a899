# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lay out a mark (strategy, times and warning sign) in a cell of FreeCAD's tree.

In a narrow cell the strategy and the warning sign have the highest priority, then the time of the simulation, then the
time on the machine. The pill of a job is shortened to the number of its operations before a time is left out. Remarks and the user's own words are shown as far as there is room.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from vkworkbench.document.marks.record import Record
from vkworkbench.document.marks.text import (
    Burden,
    burden,
    is_unsure,
    is_warned,
    machine_time_of,
    time_of,
)  # fmt: skip
from vkworkbench.gui.qt.colors import BURDEN, ERROR, TEXT, TOTAL, WARNING
from vkworkbench.gui.qt.sentences import sentence, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.tree.notices import Level, kind_of, level_of
from vkworkbench.preferences import Preferences
from vkworkbench.report import is_switched_off

PADDING = 6  # px between the text of a pill and its left and right end
_SPACE = "\u00a0"  # a no-break space, which Qt neither stretches nor drops


@dataclass(frozen=True)
class Piece:
    """A pill (text on a rounded colour), an outlined pill or a sign, which is painted over a gap in the text."""

    kind: str  # {"filled", "outlined", "warning", "error"}
    text: str  # the text on the pill
    # color, ink: colours of the pill and of the text or sign on it.
    color: str
    ink: str
    # left, width: position and size in px, from the beginning of the text.
    left: int
    width: int


class Layout:
    """One way to show a mark in the tree."""

    def __init__(self, metrics) -> None:
        self.text = ""  # the text that Qt's style paints, with gaps for the pieces
        self.pieces: list[Piece] = []
        self.needed = 0  # minimum width of the cell, px; the text beyond this width may be cut off
        self._metrics = metrics
        self._space = metrics.horizontalAdvance(100 * _SPACE) / 100  # px; Qt would round the width of one space

    def add(self, kind: str, text: str, color: str, ink: str = TEXT) -> None:
        """Add a piece (pill or sign), and a gap in the text over which the piece is painted."""
        self._part()
        left, metrics = self._metrics.horizontalAdvance(self.text), self._metrics
        if kind == "outlined":  # the pill's text is part of the cell's text, which Qt's style paints in its own colour
            padding = _SPACE * math.ceil(PADDING / self._space)
            self.text += f"{padding}{text}{padding}"
        else:
            width = metrics.horizontalAdvance(text) + 2 * PADDING if text else metrics.height()
            self.text += _SPACE * math.ceil(width / self._space)
        self.needed = metrics.horizontalAdvance(self.text)
        self.pieces.append(Piece(kind, text, color, ink, left, self.needed - left))

    def say(self, text: str) -> None:
        """Add a text that must not be cut off."""
        self._part()
        self.text += text
        self.needed = self._metrics.horizontalAdvance(self.text)

    def say_more(self, text: str) -> None:
        """Add a text that Qt's style shortens if there is too little room."""
        if text:
            self._part()
            self.text += _SPACE + text

    def _part(self) -> None:
        self.text += _SPACE if self.text else ""


def layouts(record: Record, words: str, chosen: Preferences, metrics, most_of_remark: int | None) -> list[Layout]:
    """Return the layouts of a mark, from the most detailed to the shortest.

    The user's own description (`words`) is shown to the right of the mark. Remarks are shortened to `most_of_remark`
    characters; None stands for no limit.
    """
    name = pill_text(record)
    is_error = _is_error(record)
    has_pill = not is_error or record.strategy is None or record.strategy.is_answer
    # The pill already says that the operation is switched off.
    remark = "" if is_switched_off(record) else " ".join(map(sentence, record.remarks))
    if most_of_remark is not None:
        remark = remark[:most_of_remark]
    outdated = translate("Pills", "outdated") if record.outdated else ""
    rest = "  ".join(filter(None, [outdated, remark, words]))

    def layout(name: str, *times: str) -> Layout:
        shown = Layout(metrics)
        if is_error:
            shown.add("error", "", *ERROR)
        if has_pill:
            _add_pill(shown, record, name)
            _add_times(shown, record, chosen, *times)
        if not is_error and is_warned(record, chosen):
            shown.add("warning", "", *WARNING)
        return shown

    machine, about, plain = _times(record, chosen)
    full = layout(name, machine, about)
    full.say_more(rest)
    short = name if record.strategy is not None else _count_of(record)
    shorter = ((name, machine, plain), (short, machine, plain), (short, "", plain), (short, "", ""))
    return [full, *(layout(*texts) for texts in shorter)] if has_pill else [full]


def _times(record: Record, chosen: Preferences) -> tuple[str, str, str]:
    """Return the time on the machine, and the time of the simulation with and without "about".

    The simulation's time always has its name, because a time alone would be read as the time on the machine.
    """
    reader = user()
    machine = machine_time_of(record, reader)
    about, cost = time_of(record, chosen, reader), record.cost(chosen.simulator)
    if not about:
        return machine, "", ""
    named = translate("Pills", "sim {time}")
    plain = about if record.incomplete else reader.time(cost[0], record.factor(chosen.simulator))
    return machine, named.format(time=about), named.format(time=plain)


def _is_error(record: Record) -> bool:
    """Return whether a remark is an error: then the simulation time of the operation is unknown."""
    return any(level_of(remark, record) is Level.ERROR for remark in record.remarks)


def _add_pill(layout: Layout, record: Record, name: str) -> None:
    color = record.strategy.color if record.strategy else TOTAL
    layout.add("outlined" if record.outdated else "filled", name, color)


def _add_times(layout: Layout, record: Record, chosen: Preferences, machine: str, time: str) -> None:
    if machine:
        layout.say(machine + _SPACE)
    heavy = burden(record, chosen)
    if time and heavy is Burden.FINE:
        layout.say(time)
    elif time:
        layout.add("filled", time, *BURDEN[heavy.name])


def pill_text(record: Record) -> str:
    """Return the text of a mark's pill, in the user's language."""
    if record.strategy is None:
        one, more = translate("Pills", "{} operation"), translate("Pills", "{} operations")
        return (one if record.operations == 1 else more).format(user().count(record.operations)) + _times_posted(record)
    name = kind_of(record)
    return f"{name} {user().share(record.confidence)}" if is_unsure(record) else name


def _count_of(record: Record) -> str:
    """Return the number of a job's operations as text, for a narrow pill."""
    return user().count(record.operations) + _times_posted(record)


def _times_posted(record: Record) -> str:
    """Return the number of a job's work offsets as text, such as " x2"; empty for one work offset."""
    return f" x{record.fixtures}" if record.fixtures > 1 else ""
