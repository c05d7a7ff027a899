# SPDX-License-Identifier: LGPL-2.1-or-later
"""Report the words that can change a machine's motion, but that `linearize` does not read."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from vkworkbench.core.gcode.moves.codes import (
    CANCEL,
    COMMENT,
    COMPENSATION,
    CYCLES,
    DWELL,
    FEED,
    INVERSE_TIME,
    PER_TURN,
    PROBES,
    RAPID,
    name_of,
)
from vkworkbench.core.gcode.moves.words import Words
from vkworkbench.language import Message

ROTARY = "ABC"
# Letters that are not reported: `linearize` reads the words with these letters, or they do not change the tool's path.
_READ = frozenset("XYZIJKRQF" + "GMNSTDH" + "LP")
_INCHES = 200
_CORNERS = frozenset("IJKR")  # With I, J, K or R in a straight move, some controls round or chamfer the next corner.
# Largest P word of a dwell that is read as seconds. A larger P word is read as ms, as on Fanuc controls.
_MOST_SECONDS = 60.0
# Longest dwell, s: eleven days. A longer dwell is an error, and would be infinite if its number has 400 digits.
_LONGEST = 1e6
_M_CODE = re.compile(r"\s*[Mm]0*(2|30|97|98|198)(?:\.0*)?\s*", re.ASCII)


def unread(words: Words, motion: np.ndarray) -> Iterator[tuple[np.ndarray, Message]]:
    """Yield a message for each kind of word that is not read, with the commands that contain the word.

    Parameters
    ----------
    words : Words
        The words of n commands.
    motion : (n,) int
        The G-code of each command's motion, as ten times its number (10 for G1); negative if the command is not a
        motion.

    Yields
    ------
    (m,) int, Message
        Indices of the commands with a word of this kind (empty if there are none), and the message.
    """
    codes, moves = words.codes, motion >= 0
    for letter in sorted(words.letters - _READ):
        if letter in ROTARY:
            turned = _changed(words, letter)
            yield turned[motion[turned] > 0], Message("rotary-cuts", letter=letter)
            yield turned[motion[turned] <= 0], Message("rotary-not-read", letter=letter)
        else:
            yield np.flatnonzero(moves & _given(words, letter)), Message("word-not-read", letter=letter)
    for letter in sorted(words.letters & _CORNERS):
        yield (
            np.flatnonzero(np.isin(motion, (RAPID, FEED)) & _given(words, letter)),
            Message("word-not-read", letter=letter),
        )
    for letter in "XYZ":  # FreeCAD keeps the words of the line G1 X45 (side) as parameters of the comment
        rows = np.flatnonzero(((codes == COMMENT) | (codes == CANCEL)) & _given(words, letter)).tolist()
        rows = [row for row in rows if words.names[row].lstrip()[0] in "(Gg"]
        yield np.array(rows, np.int64), Message("word-not-read", letter=letter)
    in_cycle = np.isin(motion, CYCLES)
    for letter in "KL" if in_cycle.any() else ():
        yield np.flatnonzero(in_cycle & (words.column(letter)[0] > 1)), Message("repeats-not-read", letter=letter)
    dwelling, seconds = dwells(words, motion)
    yield dwelling[np.isnan(seconds)], Message("dwell-untimed")
    yield np.flatnonzero(np.isin(codes, PROBES)), Message("probing-untimed")
    yield words.rows_of(_INCHES), Message("inches-not-read")
    for code in COMPENSATION:
        yield words.rows_of(code), Message("compensation-not-read", name=name_of(code))
    for code in (INVERSE_TIME, PER_TURN):
        yield words.rows_of(code), Message("feed-mode-not-read", name=name_of(code))
    m_codes = {name: match[1] for name in set(words.names) if (match := _M_CODE.fullmatch(name))}
    if m_codes:
        called = np.array([m_codes.get(name, "") for name in words.names])
        yield np.flatnonzero(np.isin(called, ("97", "98", "198"))), Message("subprogram-not-read")
        ends = np.flatnonzero((called == "2") | (called == "30"))
        if len(ends):
            yield ends[0] + np.flatnonzero(moves[ends[0] :]), Message("goes-on")


def dwells(words: Words, motion: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return the indices of the commands that dwell, (m,) int, and their times, (m,) s; NaN without a usable time."""
    p = words.column("P")[0]
    rows = np.union1d(words.rows_of(DWELL), np.flatnonzero(np.isin(motion, CYCLES) & (p > 0)))
    seconds = np.full(len(rows), np.nan)
    for letter in "XUP":
        given = words.column(letter)[0][rows]
        seconds = np.where(given >= 0, _in_seconds(given) if letter == "P" else given, seconds)
    return rows, seconds


def dwell_of(values: Mapping[str, float]) -> float | None:
    """Return the time of a dwell from the words of its line, s; None without a usable time."""
    if "P" in values:
        given = [float(_in_seconds(values["P"]))]
    else:
        given = [values[letter] for letter in "XUF" if letter in values]
    return next((seconds for seconds in given if 0 <= seconds <= _LONGEST), None)


def _in_seconds(p: Any) -> Any:
    return np.where(p > _MOST_SECONDS, p / 1000, p)


def _given(words: Words, letter: str) -> np.ndarray:
    values, unusable = words.column(letter)
    return ~np.isnan(values) | unusable


def _changed(words: Words, letter: str) -> np.ndarray:
    """Return the indices of the commands that turn a rotary axis, (m,) int. The axis is at 0 until its first word."""
    values, unusable = words.column(letter)
    rows = np.flatnonzero(~np.isnan(values) | unusable)
    return rows[np.diff(values[rows], prepend=0.0) != 0]
