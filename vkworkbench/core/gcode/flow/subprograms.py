# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find the subprograms in the text of an NC program.

M98 calls a program by its number (P word), or a block by its number (Q word). Haas' M97 calls a block by its number (P
word).
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Collection
from functools import cached_property

from vkworkbench.core.gcode.blocks import LARGEST_NUMBER, Lines, split_comments, split_words, whole
from vkworkbench.core.gcode.flow.lines import bare
from vkworkbench.core.gcode.flow.step import Call

PROGRAM_NUMBER = re.compile(r"[O:]\s*(\d{1,8})\b(?!\s*[A-Z]{2})")
_LABEL = re.compile(r"\s*(?:N\s*\d+\s*)?G\s*98\s*L\s*(\d{1,8})", re.IGNORECASE)  # a label of a Heidenhain program
_BLOCK = re.compile(r"\s*(?:/\d?\s*)?N\s*(\d{1,8})(?![\d.])", re.IGNORECASE)
# Codes that call the program whose number is the P word.
_CALLS = frozenset([("M", 98.0), ("M", 198.0), ("G", 65.0), ("G", 66.0)])
_CALL_LETTERS = frozenset("PpOo:")  # A line without P, O and a colon neither calls nor begins a program.
# Patterns that occur only in programs for LinuxCNC, and patterns that occur only in programs for Fanuc controls. In a
# text without a LinuxCNC pattern, a program number (O1000) also indicates a Fanuc control.
_LINUXCNC = re.compile(r"#<|\*\*|EXISTS\[|O(?:\d+|<[^<>]*>)(?:SUB|CALL|IF|WHILE|DO|REPEAT)", re.IGNORECASE)
_FANUC = re.compile(r"GOTO[\d#\[]|\]THEN|DO\d|END\d|G0*65(?!\d)|#0(?!\d)", re.IGNORECASE)
_SIGNS = re.compile(r"[#\[*]|SUB|CALL|DO|GO|END|G\s*0*65|REPEAT", re.IGNORECASE)
_TIMES = 10_000  # M98 P31000 calls program 1000 three times, unless the text contains a program 31000


def calls_block(m_code: float, letters: Collection[str]) -> bool:
    """Return whether a line with an M-code and words with the given letters calls a block of the line's own program."""
    return m_code == 97 or (m_code == 98 and "Q" in letters and "P" not in letters)


class Subprograms:
    """The NC programs and subprograms in a text, which can call each other.

    Parameters
    ----------
    lines : Lines
        All lines of the text.

    Attributes
    ----------
    called : set of int
        Numbers of the programs that another program calls as a subprogram.
    heads : list of int
        Indices of the lines in which a program begins (with the program's number), ascending.
    """

    def __init__(self, lines: Lines) -> None:
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

    @cached_property
    def fanuc(self) -> bool:
        """bool : Whether the text is a program for a Fanuc control."""
        for line in self._lines:
            if _SIGNS.search(line):
                code = bare(line)
                if _LINUXCNC.search(code):
                    return False
                if _FANUC.search(code):
                    return True
        return bool(self.heads)

    def find(self, m_code: float, words: dict[str, float], caller: int) -> tuple[int, int] | None:
        """Return the index of a subprogram's first line, and the number of runs; None for a subprogram in another text.

        Parameters
        ----------
        m_code : float
            The M-code that calls the subprogram.
        words : dict
            The words of the line.
        caller : int
            Index of the line with the call.
        """
        if "P" not in words and not calls_block(m_code, words.keys()):
            return None
        number, times, first = whole(words.get("P", 0.0), LARGEST_NUMBER), 1, None
        # On Fanuc controls, M98 Pp Qq runs program p from block q on, and M98 Qq runs this program from block q on.
        if m_code == 98 and "Q" in words:
            head = self._first.get(number) if "P" in words else self.head(caller)
            first = None if head is None else self._first_block(head, words["Q"])
        elif m_code == 97:
            first = self._first_block(self.head(caller), number)
        elif m_code == 98:  # M198 is not handled, because it calls a program outside of this text
            if number not in self._first:
                times, number = divmod(number, _TIMES)
            first = self._first.get(number)
        if first is None or (m_code == 98 and first == self.head(caller)):  # a program that calls itself never ends
            return None
        return first, whole(words.get("L", times), LARGEST_NUMBER)

    def program(self, number: float) -> int | None:
        """Return the index of the first line of a program; None if the program is not in this text."""
        return self._first.get(whole(number, LARGEST_NUMBER))

    def block(self, number: int, index: int) -> int | None:
        """Return the index of the line with a block number, for a jump from the line `index`; None without such a line.

        The control searches from the line `index` to the end of the program, and then from the program's beginning.
        """
        found = self._blocks.get((self.head(index), number), [])
        after = bisect_right(found, index)
        return found[after % len(found)] if found else None

    def label(self, number: int, index: int, repeats: int) -> Call | None:
        """Return the call of a Heidenhain program's label in the line `index`; None if the label cannot be called.

        The line with label 0 ends a subprogram. The lines between a label and its call are repeated if `repeats` is not
        0.
        """
        first = next((at for at, own in self._labels if own == number != 0), None)
        end = index if repeats else next((at for at, own in self._labels if own == 0 and at > (first or 0)), None)
        if first is None or end is None or end < first or first <= index < end:
            return None
        return Call(first + 1, end, max(repeats, 1))

    def end(self, first: int) -> int:
        """Return the index of the line in which the next program begins, or the number of lines if no program follows.

        The subprogram ends at an M99, or without an M99, before the returned line.
        """
        after = bisect_right(self.heads, first)
        return self.heads[after] if after < len(self.heads) else len(self._lines)

    def head(self, index: int) -> int:
        """Return the index of the line in which the program of a given line begins; -1 if no such line exists."""
        before = bisect_right(self.heads, index)
        return self.heads[before - 1] if before else -1

    def _first_block(self, head: int, number: float) -> int | None:
        found = self._blocks.get((head, whole(number, LARGEST_NUMBER)))
        return found[0] if found else None

    @cached_property
    def _labels(self) -> list[tuple[int, int]]:
        """The lines with labels of a Heidenhain program (G98 L1): index of the line, and number of the label."""
        labels = ((index, _LABEL.match(line)) for index, line in enumerate(self._lines))
        return [(index, int(label[1])) for index, label in labels if label]

    @cached_property
    def _blocks(self) -> dict[tuple[int, int], list[int]]:
        """Indices of the lines with a block number (N), by the index of their program's first line and the number."""
        blocks: dict[tuple[int, int], list[int]] = {}
        for index, line in enumerate(self._lines):
            number = _BLOCK.match(line)
            if number:
                blocks.setdefault((self.head(index), int(number[1])), []).append(index)
        return blocks
