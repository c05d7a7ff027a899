# SPDX-License-Identifier: LGPL-2.1-or-later
"""Split the text of an NC program into lines, and a line into comments, words and the remaining text."""

from __future__ import annotations

import re
from array import array
from collections.abc import Iterator
from itertools import accumulate

# A word is a letter with a number: G1, X-.5, Z +2, X1.5E-05, X3E-7 (Python and JavaScript write such small numbers;
# X10E5 is two words, as in programs for 3D printers). The letters of LinuxCNC's polar coordinates are @ and ^.
# Fanuc's letters ,R and ,C are for the corner after a move, and ,A is for the direction of a move. Spaces between
# letter and number are allowed (in RS274/NGC by Kramer, Proctor and Messina, 2000).
_WORD = re.compile(r"([A-Z@^]|,[ACR])[ \t]*([-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:E(?:[-+]\d\d+|-[7-9])(?![.\d]))?)", re.ASCII)
_NO_COMMENT = frozenset("(;")
LARGEST_NUMBER = 99_999_999  # upper limit for the numbers of program lines and programs, and for numbers of repetitions


class Lines:
    """The lines of a text, which can end with LF, CR or both.

    Lines are cut out of the text when needed, because a list of all lines would need three times the text's memory.

    Parameters
    ----------
    text : str
        The text of an NC program.

    Attributes
    ----------
    text : str
        The text, in which every line ends with LF.
    """

    def __init__(self, text: str) -> None:
        self.text = text.replace("\r\n", "\n").replace("\r", "\n")
        # For each line, the index of its first character in the text. The last element is the index after the end of
        # the text.
        self._starts = array("q", accumulate((len(line) + 1 for line in self), initial=0))

    def __len__(self) -> int:
        return len(self._starts) - 1

    def __getitem__(self, index: int) -> str:
        return self.between(index, index + 1)

    def __iter__(self) -> Iterator[str]:
        return iter(self.text.split("\n"))

    def between(self, first: int, end: int) -> str:
        """Return the text of the lines from `first` to `end` - 1."""
        return self.text[self._starts[first] : self._starts[end] - 1]

    def size(self, first: int, end: int) -> int:
        """Return the number of characters of the lines from `first` to `end` - 1."""
        return self._starts[end] - self._starts[first]


def split_comments(line: str) -> tuple[str, list[str]]:
    """Return a line without its comments, and the texts of the comments.

    A comment is text in parentheses, which may be nested, or the text after a semicolon.
    """
    if _NO_COMMENT.isdisjoint(line):
        return line, []
    code, comments, depth, begin = [], [], 0, 0
    for at, character in enumerate(line):
        if character == "(":
            if depth == 0:
                code.append(line[begin:at])
                begin = at + 1
            depth += 1
        elif character == ")" and depth:
            depth -= 1
            if depth == 0:
                comments.append(line[begin:at].strip())
                begin = at + 1
        elif character == ";" and depth == 0:
            code.append(line[begin:at])
            comments.append(line[at + 1 :].strip())
            return " ".join(code), comments
    (comments if depth else code).append(line[begin:].strip())
    return " ".join(code), comments


def split_words(code: str) -> tuple[list[tuple[str, float]], str]:
    """Return the words of a line, which must be in capitals and without comments, and the rest of the line's text."""
    parts = _WORD.split(code)
    rest = "".join(parts[::3]).strip()
    if rest:  # read the line again without spaces, because controls ignore spaces even within a number
        squeezed = _WORD.split("".join(code.split()))
        if not any(squeezed[::3]):
            parts, rest = squeezed, ""
    return list(zip(parts[1::3], map(float, parts[2::3]))), rest


def whole(value: float, most: int) -> int:
    """Limit a value to the range from -1 to `most`, and return the nearest whole number."""
    return round(max(-1.0, min(value, most)))
