# SPDX-License-Identifier: LGPL-2.1-or-later
"""The printed figures in the documents are in the blocks that their commands write, and the commands exist."""

from __future__ import annotations

import re
import subprocess
import sys

import pytest

from docs import print_figures

pytestmark = pytest.mark.sources

PLACES = [
    (document.name, place["command"], place["text"])
    for document in print_figures.documents()
    for place in print_figures.PLACE.finditer(document.read_text(encoding="utf-8"))
]


def test_each_printed_block_of_a_document_has_an_end():
    for document in print_figures.documents():
        text = document.read_text(encoding="utf-8")
        opened = len(re.findall(r"^<!-- printed by:", text, re.MULTILINE))
        assert opened == text.count("<!-- end -->") == len(print_figures.PLACE.findall(text)), document.name


def test_script_of_each_printed_block_exists():
    wrong = []
    for document, command, text in PLACES:
        scripts = re.findall(r"[\w./-]+\.(?:py|sh)\b", command.replace("$PWD/", ""))
        missing = [script for script in scripts if not (print_figures.ROOT / script).is_file()]
        if missing or not scripts or not re.search(r"\d", text):
            wrong.append((document, command, f"missing: {missing}" if missing else "no script, or nothing printed"))
    assert wrong == []
    assert len(PLACES) > 0


@pytest.mark.parametrize("before", ["", "\n```text\nof before\n```\n\n"])
def test_printed_figures_replace_old_figures(tmp_path, before):
    document = tmp_path / "page.md"
    places = "<!-- printed by: echo '| a | 1 |' -->\n{}<!-- end -->\n<!-- printed by: echo 2 -->\n{}<!-- end -->\n"
    document.write_text("# Page\n" + places.format(before, before) + "The rest.\n", encoding="utf-8")
    assert run(document).returncode == 0
    table, words = "\nPrinted by `echo '| a | 1 |'`:\n\n| a | 1 |\n\n", "\n```text\n$ echo 2\n2\n```\n\n"
    assert document.read_text(encoding="utf-8") == "# Page\n" + places.format(table, words) + "The rest.\n"


@pytest.mark.parametrize("command", ["echo 3; false", "true", "echo $NOT_SET_ANYWHERE", "false | echo 4"])
def test_failing_command_leaves_the_document_unchanged(tmp_path, command):
    document = tmp_path / "page.md"
    document.write_text(f"<!-- printed by: {command} -->\n\n| 5 |\n\n<!-- end -->\n", encoding="utf-8")
    before = document.read_bytes()
    assert run(document).returncode == 1
    assert document.read_bytes() == before


def run(document):
    return subprocess.run([sys.executable, print_figures.__file__, str(document)], capture_output=True)
