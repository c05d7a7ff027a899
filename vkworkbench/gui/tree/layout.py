# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a mark is laid out in a cell of the tree: what is shown of it in how much room.

First comes the strategy, then the time; the rest gives way.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from vkworkbench.document.marks.record import Record
from vkworkbench.document.marks.text import (
    PLAY,
    Burden,
    burden,
    is_unsure,
    is_warned,
    time_of,
)  # fmt: skip
from vkworkbench.gui.qt.colors import BURDEN, ERROR, TEXT, TOTAL, WARNING
from vkworkbench.gui.qt.sentences import said, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.tree.notices import Level, kind_of, level_of_remarks
from vkworkbench.preferences import Preferences
from vkworkbench.report import is_switched_off

_PADDING = 6  # px within a pill, left and right
_SPACE = "\u00a0"  # is not stretched or cut off at a line's end


@dataclass(frozen=True)
class Piece:
    """What is painted over a gap in the text: a pill, the outline of one, or a sign.

    Attributes
    ----------
    kind : {"filled", "outlined", "warning", "error"}
    text : str
        On a pill.
    color, ink : str
        Of the pill and of what is on it.
    left, width : int
        px from the begin of the text.
    """

    kind: str
    text: str
    color: str
    ink: str
    left: int
    width: int


class Layout:
    """One way to show a mark.

    Attributes
    ----------
    text : str
        What the style paints, with gaps.
    pieces : list of Piece
    needed : int
        px that must not be cut off.
    """

    def __init__(self, metrics) -> None:
        self.text, self.pieces, self.needed = "", [], 0
        self._metrics = metrics

    def add(self, kind: str, text: str, color: str, ink: str = TEXT) -> None:
        """Add something that is painted over a gap."""
        self._part()
        left, metrics = self._metrics.horizontalAdvance(self.text), self._metrics
        if kind == "outlined":  # not filled, so its text has the usual colour
            padding = _SPACE * math.ceil(_PADDING / metrics.horizontalAdvance(_SPACE))
            self.text += f"{padding}{text}{padding}"
        else:
            width = metrics.horizontalAdvance(text) + 2 * _PADDING if text else metrics.height()
            self.text += _SPACE * math.ceil(width / metrics.horizontalAdvance(_SPACE))
        self.needed = metrics.horizontalAdvance(self.text)
        self.pieces.append(Piece(kind, text, color, ink, left, self.needed - left))

    def say(self, text: str) -> None:
        """Add a text that must not be cut off."""
        self._part()
        self.text += text
        self.needed = self._metrics.horizontalAdvance(self.text)

    def say_more(self, text: str) -> None:
        """Add a text of which the style may leave out the end."""
        if text:
            self._part()
            self.text += _SPACE + text

    def _part(self) -> None:
        self.text += _SPACE if self.text else ""


def layouts(record: Record, words: str, chosen: Preferences, metrics, most_of_remark: int | None) -> list[Layout]:
    """Return the ways to show a mark, the one that tells most first.

    Parameters
    ----------
    record : Record
    words : str
        The user's own, behind the mark.
    chosen : Preferences
    metrics : QFontMetrics
    most_of_remark : int or None
        Characters of a remark, all of it if None.
    """
    reader = user()
    about, (seconds, _) = time_of(record, chosen, reader), record.cost(chosen.simulator) or (None, None)
    plain = reader.time(seconds, record.factor(chosen.simulator)) if about else ""
    name = pill_text(record)
    is_error = _is_error(record)
    has_pill = not is_error or record.strategy is None or record.strategy.is_answer
    remark = "" if is_switched_off(record) else "; ".join(map(said, record.remarks))  # the pill says it
    if most_of_remark is not None:
        remark = remark[:most_of_remark]
    outdated = translate("Pills", "outdated") if record.outdated else ""
    rest = "  ".join(filter(None, [outdated, remark, words]))

    def begun() -> Layout:
        layout = Layout(metrics)
        if is_error:
            layout.add("error", "", *ERROR)
        if has_pill:
            _add_pill(layout, record, name)
        return layout

    full, shorter, shortest = begun(), begun(), begun()
    if has_pill:
        _add_time(full, record, chosen, about and f"{PLAY} {about}")
        _add_time(shorter, record, chosen, plain and f"{PLAY} {plain}")
        _add_time(shortest, record, chosen, plain)
    if not is_error and is_warned(record, chosen):
        full.add("warning", "", *WARNING)
    full.say_more(rest)
    return [full, *([shorter, shortest, begun()] if has_pill else [])]


def _is_error(record: Record) -> bool:
    """Whether nothing is known of an operation's simulation."""
    return bool(record.remarks) and level_of_remarks(record) is Level.ERROR


def _add_pill(layout: Layout, record: Record, name: str) -> None:
    color = record.strategy.color if record.strategy else TOTAL
    layout.add("outlined" if record.outdated else "filled", name, color)


def _add_time(layout: Layout, record: Record, chosen: Preferences, time: str) -> None:
    heavy = burden(record, chosen)
    if time and heavy is Burden.FINE:
        layout.say(time)
    elif time:
        layout.add("filled", time, *BURDEN[heavy.name])


def pill_text(record: Record) -> str:
    """Return what stands in a mark's pill, in the user's language."""
    if record.strategy is None:
        one, more = translate("Pills", "{} operation"), translate("Pills", "{} operations")
        return (one if record.operations == 1 else more).format(user().count(record.operations))
    name = kind_of(record)
    return f"{name} {user().share(record.confidence)}" if is_unsure(record) else name
