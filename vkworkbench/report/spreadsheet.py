# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of documents as cells of a table that no spreadsheet calculates."""

from __future__ import annotations

import re
from typing import Any

# A text that spreadsheets take for a formula: one of these signs, after characters that they skip. East Asian ones
# take the full-width signs as well.
_FORMULA = re.compile(r"[\s\x00-\x1f\ufeff\u200b-\u200f\u2060]*[=+\-@＝＋－＠]")


def as_cell(value: Any) -> Any:
    """Return a text that no spreadsheet takes for a formula; other values as they are."""
    if isinstance(value, str) and _FORMULA.match(value):
        return "'" + value
    return value
