# SPDX-License-Identifier: LGPL-2.1-or-later
"""Protect texts from documents, so that spreadsheets do not calculate them as formulas."""

from __future__ import annotations

import re
from typing import Any

# A spreadsheet calculates a text that begins with =, +, - or @ as a formula. Spaces and invisible characters before the
# sign are skipped. East Asian spreadsheets also accept the full-width signs.
_FORMULA = re.compile(r"[\s\x00-\x1f\ufeff\u200b-\u200f\u2060]*[=+\-@＝＋－＠]")


def as_cell(value: Any) -> Any:
    """Return a text that spreadsheets do not calculate as a formula.

    A value that is not a text is returned unchanged.
    """
    if isinstance(value, str) and _FORMULA.match(value):
        return "'" + value
    return value
