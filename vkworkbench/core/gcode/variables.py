# SPDX-License-Identifier: LGPL-2.1-or-later
"""Replace variables by numbers: #1=-3, then G1 Z#1.

Exporters for circuit boards write depths and feed rates as variables at the top of the program, where users can change
them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable

from vkworkbench.core.gcode.blocks import split_comments

# Words for jumps, loops and calls, after which the value of a variable may differ from its last assignment in the text.
FLOW = re.compile(r"\b(IF|THEN|ELSE|WHILE|GOTO|DO\s*\d|END\s*\d|ENDIF|ENDWHILE|REPEAT)|^O\s*[\d<].*\b(SUB|CALL|DO)\b")
_NAME = r"(?<!#)#\s*(\d+|<[^<>]*>)"
_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"
_USED = re.compile(rf"([-+]?)\s*{_NAME}")
_SET = re.compile(rf"{_NAME}\s*=")
_SET_ALONE = re.compile(rf"(?:N\s*\d+\s*)?{_NAME}\s*=\s*(.*)")
_BRACKETS = re.compile(rf"\[\s*({_NUMBER})\s*\]")


class Variables:
    """The numbers assigned to the variables of a program, up to the current line.

    Parameters
    ----------
    lines : iterable of str
        The whole program.
    """

    def __init__(self, lines: Iterable[str]) -> None:
        self._lines = lines
        self._straight: bool | None = None
        self._numbers: dict[str, str] = {}

    def put_in(self, code: str) -> str:
        """Return a line with its variables replaced by their numbers; empty if the line only assigns a number.

        A variable without a known number is not replaced. A line that assigns anything else than a number is returned
        unchanged, and so is every line of a program with jumps or loops.

        Parameters
        ----------
        code : str
            The line in capitals, without comments.
        """
        if self._straight is None:
            self._straight = not any(FLOW.search(split_comments(line)[0].strip().upper()) for line in self._lines)
        if not self._straight:
            return code
        alone = _SET_ALONE.fullmatch(code)
        if alone:
            number = self._filled_in(alone[2]).strip()
            if re.fullmatch(_NUMBER, number):
                self._numbers[_plain(alone[1])] = number
                return ""
        for name in _SET.findall(code):
            self._numbers.pop(_plain(name), None)
        return code if alone else self._filled_in(code)

    def _filled_in(self, code: str) -> str:
        return _BRACKETS.sub(r"\1", _USED.sub(self._number, code))

    def _number(self, used: re.Match[str]) -> str:
        number = self._numbers.get(_plain(used[2]))
        if number is None:
            return used[0]
        negative = (used[1] == "-") != (number[0] == "-")
        return ("-" if negative else "") + number.lstrip("+-")


def _plain(name: str) -> str:
    """Return the name of a variable without spaces, because LinuxCNC ignores spaces in names."""
    return "".join(name.split())
