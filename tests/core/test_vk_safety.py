# SPDX-License-Identifier: LGPL-2.1-or-later
"""The package does not evaluate text, use the network or start programs, and CSV cells stay text."""

from __future__ import annotations

import ast
import csv
import re
import sys
from pathlib import Path

import pytest

from vkworkbench.report import Report

ROOT = Path(__file__).parents[2]
SOURCES = [*(ROOT / "vkworkbench").rglob("*.py"), ROOT / "Init.py", ROOT / "InitGui.py"]
CALLS = {"eval", "exec", "compile", "__import__", "system", "popen", "urlopen", "urlretrieve"}
MODULES = {"socket", "ssl", "http", "urllib", "ftplib", "smtplib", "requests", "asyncio", "subprocess",
           "ctypes", "pickle", "marshal", "shelve", "xmlrpc", "telnetlib", "webbrowser", "QtNetwork",
           "QtWebEngineWidgets"}  # fmt: skip
# The add-on starts worker processes and unpickles only their messages. garbage.py calls the C library's malloc_trim.
ALLOWED = {
    "vkworkbench/worker.py": {"ctypes", "pickle", "subprocess"},
    "vkworkbench/document/computer/garbage.py": {"ctypes"},
}


def named(tree):
    """Yield the functions called by a plain name or as a function of a module, and every imported module and name."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Call):
            if isinstance(node.func, ast.Name):
                yield node.func.id
            elif isinstance(node.func, ast.Attribute) and isinstance(node.func.value, ast.Name):
                # The method exec of Qt dialogs, and functions of the module re, are allowed.
                if node.func.attr != "exec" and node.func.value.id != "re":
                    yield node.func.attr
        elif isinstance(node, ast.Import):
            for alias in node.names:
                yield from alias.name.split(".")
        elif isinstance(node, ast.ImportFrom):
            yield from (node.module or "").split(".")
            yield from (alias.name for alias in node.names)


@pytest.mark.sources
def test_package_has_no_evaluation_and_no_network(parse):
    found = {str(path.relative_to(ROOT)): (CALLS | MODULES).intersection(named(parse(path))) for path in SOURCES}
    assert {name: what for name, what in found.items() if what} == ALLOWED


@pytest.mark.sources
def test_search_finds_forbidden_functions_and_modules():
    code = "import os.path, urllib.request\nfrom PySide import QtNetwork\n"
    code += "eval('1')\nos.system('x')\nre.compile('x')\nbox.exec()"
    assert (CALLS | MODULES) & set(named(ast.parse(code))) == {"urllib", "QtNetwork", "eval", "system"}


FORMULAS = [
    "=1+1",
    "+1",
    "-1",
    "@SUM(A1)",
    "\t=1",
    "\r=1",
    "\n=1",
    " =1",
    "\ufeff=1",
    "\u200b=1",
    "\x00=1",
    "＝1",
    "=",
    "\r\n\t @x",
]
PLAIN = ["1+1", "a=b", "", "'=1", "x-y", "e@mail", "a\n=b", "Ж"]


@pytest.mark.parametrize("text", FORMULAS + PLAIN)
def test_cells_that_begin_like_a_formula_become_text(text, tmp_path):
    if "\0" in text and sys.version_info < (3, 11):
        pytest.skip("csv reads NUL since Python 3.11")

    class Row:
        messages, simulated = (), None
        document, job = "Doc", "Job"

        def as_dict(self):
            return {"label": text, "length": -1.5, "cautions": [text], "machining_notes": [text], "spans": [],
                    "messages": {}, "simulated": None}  # fmt: skip

    Report((Row(),), {}, {}).to_csv(tmp_path / "r.csv")
    with open(tmp_path / "r.csv", newline="", encoding="utf-8") as file:
        (row,) = csv.DictReader(file)
    for cell in (row["label"], row["cautions"], row["machining_notes"]):
        assert cell == ("'" + text if text in FORMULAS else text)
    assert float(row["length"]) == -1.5  # A number gets no apostrophe, even if it is negative.


@pytest.mark.sources
def test_message_boxes_and_tooltips_are_made_in_plain_text(parse):
    """Only plain_text.py makes message boxes and tooltips; elsewhere, Qt could read a text of a document as HTML."""
    for path in (ROOT / "vkworkbench" / "gui").rglob("*.py"):
        named_there = {node.id for node in ast.walk(parse(path)) if isinstance(node, ast.Name)}
        assert {"QMessageBox", "QToolTip"} & named_there == set() or path.name == "plain_text.py", path.name


@pytest.mark.sources
def test_no_deleted_freecad_widget_is_referenced():
    # PySide keeps a reference to widgets found by findChild or connected to `destroyed`. See gui/qt/widgets.py.
    keeping = re.compile(r"getMainWindow\(\)\.findChild|\bwindow\.findChildren|\.destroyed\b")
    gui = ROOT / "vkworkbench" / "gui"
    found = {
        str(path.relative_to(gui)): keeping.findall(path.read_text(encoding="utf-8")) for path in gui.rglob("*.py")
    }
    assert {name: what for name, what in found.items() if what} == {"qt/widgets.py": ["getMainWindow().findChild"] * 2}
