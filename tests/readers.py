# SPDX-License-Identifier: LGPL-2.1-or-later
"""Readers in other languages without Qt: they take their texts from the translation sources."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path
from xml.etree import ElementTree

from vkworkbench.language import Reader

FOLDER = Path(__file__).resolve().parents[1] / "resources" / "translations"
LANGUAGES = ["de", "fr", "es-ES", "zh-CN"]


@lru_cache(maxsize=None)
def translations(language: str) -> dict[tuple[str, str], str]:
    """Return the texts of a language by context and source text."""
    found = {}
    for context in ElementTree.parse(FOLDER / f"VkWorkbench_{language}.ts").getroot().iter("context"):
        for message in context.iter("message"):
            found[context.findtext("name"), message.findtext("source")] = message.findtext("translation")
    return found


class Translated(Reader):
    """A reader of one of the languages."""

    def __init__(self, language: str) -> None:
        self.texts = translations(language)

    def translate(self, context, text):
        return self.texts.get((context, text), text)


class German(Translated):
    decimal, thousands = ",", "."

    def __init__(self):
        super().__init__("de")


class Inches(Reader):
    def length_unit(self, millimetres):
        return 25.4, "in"
