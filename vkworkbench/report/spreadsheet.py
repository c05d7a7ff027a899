# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts of documents as cells that spreadsheets do not calculate."""

from __future__ import annotations

import re
from typing import Any

# Spreadsheets calculate a text that begins with one of these signs, after characters that they skip. East Asian
# spreadsheets accept the full-width signs, too.
_FORMULA = re.compile(r"[\s\x00-\x1f\ufeff\u200b-\u200f\u2060]*[=+\-@＝＋－＠]")


def as_cell(value: Any) -> Any:
    """Return a text that spreadsheets do not calculate as a formula. Other values are returned unchanged."""
    if isinstance(value, str) and _FORMULA.match(value):
        return "'" + value
    return value
