# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where the subprograms of an NC program's text are, which are called by M98 with their number or a block's (Q), by Haas' M97 with a block's."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Collection
from functools import cached_property

from vkworkbench.core.gcode.blocks import LARGEST_NUMBER, split_comments, split_words, whole

PROGRAM_NUMBER = re.compile(r"[O:]\s*(\d{1,8})\b(?!\s*[A-Z]{2})")
_BLOCK = re.compile(r"\s*(?:/\d?\s*)?N\s*(\d{1,8})(?![\d.])", re.IGNORECASE)
_CALLS = frozenset([("M", 98.0), ("M", 198.0), ("G", 65.0), ("G", 66.0)])  # of the program whose number is the P word
_CALL_LETTERS = frozenset("PpOo:")  # of calls, and of the programs in which they stand
_TIMES = 10_000  # P31000 is three times 1000 where there is no 31000


def calls_block(m_code: float, letters: Collection[str]) -> bool:
    """Return whether an M-code calls a block of its own program, by the words beside it."""
    return m_code == 97 or (m_code == 98 and "Q" in letters and "P" not in letters)


class Subprograms:
    """The programs in a text.

    Parameters
    ----------
    lines : list of str

    Attributes
    ----------
    called : set of int
        Numbers of the programs that others call as subprograms.
    heads : list of int
        Indices of the lines with a program's number.
    """

    def __init__(self, lines: list[str]) -> None:
        self._lines = lines
        self._first: dict[int, int] = {}
        self.heads: list[int] = []
        caller = -1
        calls: list[tuple[int, int]] = []
        for index, line in enumerate(lines):
            if _CALL_LETTERS.isdisjoint(line):
                continue
            code = split_comments(line)[0].strip().upper()
            program = PROGRAM_NUMBER.match(code)
            if program:
                caller = int(program[1])
                self._first.setdefault(caller, index)
                self.heads.append(index)
            words, _ = split_words(code)
            number = dict(words).get("P")
            if number is not None and not _CALLS.isdisjoint(words):
                calls.append((caller, whole(number, LARGEST_NUMBER)))
        called = ((caller, number if number in self._first else number % _TIMES) for caller, number in calls)
        self.called = {number for caller, number in called if number != caller}

    def find(self, m_code: float, words: dict[str, float], caller: int) -> tuple[int, int] | None:
        """Return the index of a subprogram's first line, and how often it is to be run; None where it is not in this text.

        Parameters
        ----------
        m_code : float
            Of the call.
        words : dict
            The words beside it.
        caller : int
            Index of the line with the call.
        """
        if "P" not in words and not calls_block(m_code, words.keys()):
            return None
        number, times, first = whole(words.get("P", 0.0), LARGEST_NUMBER), 1, None
        if m_code == 98 and "Q" in words:  # Fanuc: from that block on, of this program where P names no other
            head = self._first.get(number) if "P" in words else self._head(caller)
            first = None if head is None else self._blocks.get((head, whole(words["Q"], LARGEST_NUMBER)))
        elif m_code == 97:
            first = self._blocks.get((self._head(caller), number))
        elif m_code == 98:  # M198 calls from another place
            if number not in self._first:
                times, number = divmod(number, _TIMES)
            first = self._first.get(number)
        if first is None or (m_code == 98 and first == self._head(caller)):  # which would call itself for ever
            return None
        return first, whole(words.get("L", times), LARGEST_NUMBER)

    def end(self, first: int) -> int:
        """Return the index of the line before which a subprogram ends, at the latest: that of the next program's number."""
        after = bisect_right(self.heads, first)
        return self.heads[after] if after < len(self.heads) else len(self._lines)

    def _head(self, index: int) -> int:
        """Return the index of the line with the number of the program in which a line stands; -1 where there is none."""
        before = bisect_right(self.heads, index)
        return self.heads[before - 1] if before else -1

    @cached_property
    def _blocks(self) -> dict[tuple[int, int], int]:
        """Index of the first line of each number, of each program on its own."""
        blocks: dict[tuple[int, int], int] = {}
        for index, line in enumerate(self._lines):
            number = _BLOCK.match(line)
            if number:
                blocks.setdefault((self._head(index), int(number[1])), index)
        return blocks
