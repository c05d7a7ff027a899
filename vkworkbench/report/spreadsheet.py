# SPDX-License-Identifier: LGPL-2.1-or-later
"""Protect texts from documents, so that spreadsheets do not calculate them as formulas."""

from __future__ import annotations

import re
from typing import Any

# Spreadsheets calculate a text that begins with one of the signs at the end of this pattern. They skip the characters
# before the sign. East Asian spreadsheets also accept the full-width signs.
_FORMULA = re.compile(r"[\s\x00-\x1f\ufeff\u200b-\u200f\u2060]*[=+\-@＝＋－＠]")


def as_cell(value: Any) -> Any:
    """Return a text that spreadsheets do not calculate as a formula. Other values are returned unchanged."""
    if isinstance(value, str) and _FORMULA.match(value):
        return "'" + value
    return value
