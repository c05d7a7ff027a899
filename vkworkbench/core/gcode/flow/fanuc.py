# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognize programs for a Fanuc control, and read the arguments of its macro call G65."""

from __future__ import annotations

import re
from collections.abc import Iterable

from vkworkbench.core.gcode.blocks import Lines
from vkworkbench.core.gcode.flow.lines import bare
from vkworkbench.core.gcode.flow.subprograms import Subprograms
from vkworkbench.core.gcode.flow.variables import Frame, Value

# Signs of LinuxCNC and of Fanuc controls. In a program without signs of LinuxCNC, a program number (O1000) is also a
# sign of a Fanuc control.
_LINUXCNC = re.compile(r"#<|\*\*|EXISTS\[|O(?:\d+|<[^<>]*>)(?:SUB|CALL|IF|WHILE|DO|REPEAT)", re.IGNORECASE)
_FANUC = re.compile(r"GOTO[\d#\[]|\]THEN|DO\d|END\d|G0*65(?!\d)|#0(?!\d)", re.IGNORECASE)
_SIGNS = re.compile(r"[#\[*]|SUB|CALL|DO|GO|END|G\s*0*65|REPEAT", re.IGNORECASE)
_MACRO_LETTERS = {letter: number for number, letter in enumerate("ABC", 1)}
_MACRO_LETTERS.update({"D": 7, "E": 8, "F": 9, "H": 11, "M": 13})
_MACRO_LETTERS.update({letter: number for number, letter in enumerate("QRSTUVWXYZ", 17)})
_MOST_SETS = 10  # largest number of I, J and K words in the line of a macro call


def is_fanuc(lines: Lines, subprograms: Subprograms) -> bool:
    """Return whether a program is written for a Fanuc control."""
    for line in lines:
        if _SIGNS.search(line):
            code = bare(line)
            if _LINUXCNC.search(code):
                return False
            if _FANUC.search(code):
                return True
    return bool(subprograms.heads)


def arguments(words: Iterable[tuple[str, float]]) -> Frame:
    """Return the local variables that the words of Fanuc's macro call G65 set.

    I, J and K words may be repeated. A new set of variables begins at each I, J or K word that breaks the alphabetical
    order.
    """
    numbers: dict[int, Value] = {}
    sets, last = 0, ""
    for letter, value in words:
        if letter in _MACRO_LETTERS:
            numbers[_MACRO_LETTERS[letter]] = value
        elif letter in "IJK":
            sets += letter <= last
            last = letter
            if sets < _MOST_SETS:
                numbers[4 + 3 * sets + "IJK".index(letter)] = value
    return Frame(numbers)
