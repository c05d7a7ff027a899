# SPDX-License-Identifier: LGPL-2.1-or-later
"""Readers of other languages without Qt: they take their words from the translations' sources."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

from vkworkbench.language import Reader

FOLDER = Path(__file__).resolve().parents[1] / "resources" / "translations"
LANGUAGES = ["de", "fr", "es-ES", "zh-CN"]


class Translated(Reader):
    """Who reads one of the languages."""

    def __init__(self, language: str) -> None:
        self.texts = {}
        for context in ElementTree.parse(FOLDER / f"VkWorkbench_{language}.ts").getroot().iter("context"):
            for message in context.iter("message"):
                key = context.findtext("name"), message.findtext("source")
                self.texts[key] = message.findtext("translation")

    def translate(self, context, text):
        return self.texts.get((context, text), text)


class German(Translated):
    decimal, thousands = ",", "."

    def __init__(self):
        super().__init__("de")


class Inches(Reader):
    def length_unit(self, millimetres):
        return 25.4, "in"
