# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every text of the code and the form is in the sources of the translations, and is translated."""

import ast
import re
from functools import lru_cache
from pathlib import Path
from xml.etree import ElementTree

import pytest

pytestmark = pytest.mark.sources

ROOT = Path(__file__).resolve().parents[2]
FOLDER = ROOT / "resources" / "translations"
LANGUAGES = ["de", "fr", "es-ES", "zh-CN"]
MARKED = {"translate", "QT_TRANSLATE_NOOP"}


@pytest.fixture(scope="module")
def texts_of_code(parse):
    """Return contexts and texts of all calls that mark a text for translation. The arguments must be literals."""
    texts = []
    for path in (ROOT / "vkworkbench").rglob("*.py"):
        for node in ast.walk(parse(path)):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in MARKED:
                arguments = [a.value if isinstance(a, ast.Constant) else None for a in node.args]
                assert len(arguments) == 2 and all(isinstance(a, str) for a in arguments), f"{path}:{node.lineno}"
                texts.append(tuple(arguments))
    return texts


def texts_of_forms():
    for path in (ROOT / "resources" / "ui").glob("*.ui"):
        form = ElementTree.parse(path).getroot()
        for text in form.iter("string"):
            if text.get("notr") != "true" and text.text:
                yield form.findtext("class"), text.text


@lru_cache(maxsize=None)
def messages(name):
    """Return the translations by context and text. An unfinished translation is None."""
    found = {}
    for context in ElementTree.parse(FOLDER / name).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            text = None if translation.get("type") else translation.text
            found[context.findtext("name"), message.findtext("source")] = text
    return found


@pytest.mark.parametrize("name", ["VkWorkbench.ts", *(f"VkWorkbench_{language}.ts" for language in LANGUAGES)])
def test_translation_sources_equal_texts_in_code(name, texts_of_code):
    # If this test fails, run resources/update_translations.sh.
    assert set(messages(name)) == {*texts_of_code, *texts_of_forms()}


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_text_is_translated(language):
    for (_, text), translation in messages(f"VkWorkbench_{language}.ts").items():
        assert translation, text
        # A translation keeps the placeholders, the … of commands that open a dialog, the tags and the line breaks.
        for pattern in (r"\{[^{}]*\}", "…$", r"</?\w+>", "\n"):
            expected, found = (sorted(re.findall(pattern, t)) for t in (text, translation))
            assert found == expected, (text, translation)


@pytest.mark.parametrize("language", LANGUAGES)
def test_translations_differ_from_the_source(language):
    translated = messages(f"VkWorkbench_{language}.ts")
    same = [text for (_, text), translation in translated.items() if translation == text]
    assert len(same) < 0.05 * len(translated), same


def test_every_text_of_the_window_is_translatable(parse):
    """Titles, tooltips and labels must not be bare literals."""
    setters = {"setText", "setToolTip", "setWindowTitle", "setTitle", "QPushButton", "QLabel", "showMessage", "addItem"}
    for path in (ROOT / "vkworkbench" / "gui").rglob("*.py"):
        for node in ast.walk(parse(path)):
            if isinstance(node, ast.Call) and node.args:
                name = getattr(node.func, "attr", getattr(node.func, "id", ""))
                first = node.args[0]
                bare = (
                    isinstance(first, ast.Constant)
                    and isinstance(first.value, str)
                    and re.search("[a-z]{3}", first.value)
                )
                assert not (name in setters and bare), f"{path}:{node.lineno}"
