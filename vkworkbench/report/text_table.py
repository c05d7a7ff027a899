# SPDX-License-Identifier: LGPL-2.1-or-later
"""Helpers for printed tables. Each column is as wide as its widest cell."""

from __future__ import annotations

import re
import sys
from collections.abc import Collection, Iterable, Sequence

_MOST_NAMED = 20  # maximum number of names in the sentence about files that are left out
_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f]+")


def printable(text: str, longest: int = 60) -> str:
    """Return a text of limited length without control characters, which could change the state of the terminal."""
    text = _CONTROL.sub(" ", text)
    return text if len(text) <= longest else text[: longest - 1] + "…"


def how_many(number: int, thing: str) -> str:
    """Return a number with a noun in English, such as ``"1 operation"`` or ``"2 operations"``."""
    return f"{number} {thing}" + ("" if number == 1 else "s")


def files_left_out(paths: Iterable[str]) -> str:
    """Return a sentence with the names of files in folders that are not analysed."""
    names = [printable(path, sys.maxsize) for path in paths]
    more = f", and {len(names) - _MOST_NAMED:,} more" if len(names) > _MOST_NAMED else ""
    return f"Left out, because they do not look like NC programs: {', '.join(names[:_MOST_NAMED])}{more}."


def widths_of(rows: Sequence[Sequence[str]]) -> list[int]:
    """Return the widths of the columns, in characters."""
    return [max(map(len, column)) for column in zip(*rows)]


def line(row: Sequence[str], widths: Sequence[int], left: Collection[int]) -> str:
    """Return a row of the table as a line of text. The columns `left` are left-aligned, all others right-aligned."""
    cells = (cell.ljust(w) if i in left else cell.rjust(w) for i, (cell, w) in enumerate(zip(row, widths)))
    return "  ".join(cells).rstrip()
