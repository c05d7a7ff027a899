# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page of vocabulary names files and names that are there."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/vocabulary.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| ([^|]+) \| [^|]+ \| `([\w/]+\.py)`(?: `(\w+)`)? \|$", PAGE, re.MULTILINE)


def test_every_row_of_the_page_is_read():
    terms = [line for line in PAGE.splitlines() if line.startswith("| ") and not line.startswith("| term")]
    assert len(ROWS) == len(terms) > 50


@pytest.mark.parametrize("term, file, name", ROWS, ids=[row[0] for row in ROWS])
def test_a_term_is_computed_where_the_page_says(term, file, name):
    assert re.search(rf"\b{name}\b", (ROOT / "vkworkbench/core" / file).read_text(encoding="utf-8")), (
        f"{file} has no {name}"
    )
