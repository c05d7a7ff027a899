# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read the arguments of a Fanuc control's macro call, G65."""

from __future__ import annotations

from collections.abc import Iterable

from vkworkbench.core.gcode.flow.variables import Frame, Value

_MACRO_LETTERS = {letter: number for number, letter in enumerate("ABC", 1)}
_MACRO_LETTERS.update({"D": 7, "E": 8, "F": 9, "H": 11, "M": 13})
_MACRO_LETTERS.update({letter: number for number, letter in enumerate("QRSTUVWXYZ", 17)})
_MOST_SETS = 10  # largest number of I, J and K words in the line of a macro call


def arguments(words: Iterable[tuple[str, float]]) -> Frame:
    """Return the local variables that the words of Fanuc's macro call G65 set.

    A line can contain several sets of I, J and K words. A new set begins at each I, J or K word whose letter is not
    after the previous word's letter in the alphabet.
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
