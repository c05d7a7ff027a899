# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files and names in docs/vocabulary.md exist."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

pytestmark = pytest.mark.sources

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/vocabulary.md").read_text(encoding="utf-8")
ROWS = re.findall(r"^\| ([^|]+) \| [^|]+ \| `([\w/]+\.py)`(?: `(\w+)`)? \|$", PAGE, re.MULTILINE)


def test_every_row_of_the_vocabulary_is_read():
    terms = [line for line in PAGE.splitlines() if line.startswith("| ") and not line.startswith("| term")]
    assert len(ROWS) == len(terms) > 50


def test_each_term_of_the_vocabulary_is_in_its_file():
    texts = {file: (ROOT / "vkworkbench/core" / file).read_text(encoding="utf-8") for _, file, _ in ROWS}
    missing = [(term, file, name) for term, file, name in ROWS if not re.search(rf"\b{name}\b", texts[file])]
    assert missing == []
