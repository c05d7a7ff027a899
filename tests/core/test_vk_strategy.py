# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every strategy has a name in each language, a colour, a sentence, and a section in the docs."""

from __future__ import annotations

import re
from pathlib import Path
from types import SimpleNamespace
from xml.etree import ElementTree

import pytest

from vkworkbench.core import Family, Strategy

ROOT = Path(__file__).parents[2]
DOCUMENT = (ROOT / "docs" / "recognition.md").read_text(encoding="utf-8")
FIELDS = ("value", "label", "family", "color", "about")


def names_in_languages():
    """Yield each language with its translated strategy names by English name."""
    for path in sorted((ROOT / "resources" / "translations").glob("VkWorkbench_*.ts")):
        for context in ElementTree.parse(path).getroot().iter("context"):
            if context.findtext("name") == "Strategy":
                yield path.stem, {m.findtext("source"): m.findtext("translation") for m in context.iter("message")}


LANGUAGES = dict(names_in_languages())


def forgotten(entry):
    """Yield the fields of a strategy's entry that are missing or malformed."""
    for field in FIELDS:
        if not getattr(entry, field, None):
            yield field
            return
    if not re.fullmatch("[a-z]+(-[a-z]+)*", entry.value):
        yield "value"
    if not re.fullmatch("#[0-9a-f]{6}", entry.color):
        yield "color"
    if not re.fullmatch(r"[A-Z].*\.", entry.about):
        yield "about"
    yield from (language for language, names in LANGUAGES.items() if not names.get(entry.label))
    if f'| <a id="{entry.value}"></a>`{entry.value}` | {entry.family.value} | {entry.about} |\n' not in DOCUMENT:
        yield "docs/recognition.md"


@pytest.mark.sources
@pytest.mark.parametrize("strategy", Strategy)
def test_every_strategy_has_all_fields_names_and_docs(strategy):
    assert list(forgotten(strategy)) == []


@pytest.mark.sources
@pytest.mark.parametrize(
    "field, value, missing",
    [
        *((field, None, [field]) for field in FIELDS),
        ("color", "blue", ["color"]),
        ("label", "to and fro", ["VkWorkbench_de", "VkWorkbench_es-ES", "VkWorkbench_fr", "VkWorkbench_zh-CN"]),
        ("value", "to-and-fro", ["docs/recognition.md"]),
        ("about", "Another sentence.", ["docs/recognition.md"]),
        ("family", Family.HOLES, ["docs/recognition.md"]),
    ],
)
def test_missing_field_of_a_strategy_is_found(field, value, missing):
    zigzag = {name: getattr(Strategy.ZIGZAG, name) for name in FIELDS}
    assert list(forgotten(SimpleNamespace(**zigzag))) == []
    assert list(forgotten(SimpleNamespace(**zigzag | {field: value}))) == missing


@pytest.mark.sources
def test_docs_have_exactly_one_section_for_each_strategy():
    assert set(re.findall(r'<a id="([a-z-]+)"></a>', DOCUMENT)) == {strategy.value for strategy in Strategy}


def test_values_of_strategies_do_not_change():
    # Documents store the values, and macros read them. Values may be added, but not changed.
    stored = {"zigzag", "one-way", "contour-parallel", "profile", "waterline", "spiral", "helix", "adaptive",
              "drilling", "engraving", "mixed", "unknown", "empty"}  # fmt: skip
    assert stored <= {strategy.value for strategy in Strategy}
    assert Strategy("one-way") is Strategy.ONE_WAY and f"{Strategy.ONE_WAY}" == Strategy.ONE_WAY == "one-way"


def test_only_unknown_and_empty_are_not_recognised_strategies():
    assert [one.value for one in Strategy if not one.is_answer] == ["unknown", "empty"]
