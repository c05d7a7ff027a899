# SPDX-License-Identifier: LGPL-2.1-or-later
"""The oldest Python that the add-on supports is declared in package.xml, and the code uses no newer features.

FreeCAD 0.20 and 0.21 for Windows contain Python 3.8, and Ubuntu's packages use 3.10.
"""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
OLDEST = (3, 8)
FILES = sorted([ROOT / "Init.py", ROOT / "InitGui.py", *(ROOT / "vkworkbench").rglob("*.py")])
# Names that newer Python versions added: methods of str, functions of the standard library, and arguments.
LATER = {"pairwise", "batched", "bit_count", "hardlink_to", "TaskGroup", "StrEnum", "ExceptionGroup", "add_note", "kw_only", "slots",
         "root_dir", "EncodingWarning", "walk_up"}  # fmt: skip


# Types that accept no type parameters at run time in Python 3.8.
GENERIC = {"dict", "frozenset", "list", "set", "tuple", "type"}


def newer(source: str) -> list[str]:
    """Return the uses of newer Python features in a source text, by line.

    A union of types `X | Y` outside annotations is not found. A union of types outside annotations can only be found by
    running the code.
    """
    try:
        tree = ast.parse(source, feature_version=OLDEST)
    except SyntaxError as error:
        return [f"{error.lineno}: {error.msg}"]
    found = []
    lazy = any(isinstance(node, ast.ImportFrom) and node.module == "__future__" for node in tree.body)
    if not lazy and any(
        isinstance(node, ast.BinOp) for annotation in _annotations(tree) for node in ast.walk(annotation)
    ):
        found.append("1: annotations are evaluated")
    generic = GENERIC | {
        alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and node.module == "collections.abc"
        for alias in node.names
    }
    annotated = {id(node) for annotation in _annotations(tree) for node in ast.walk(annotation)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Match):
            found.append(f"{node.lineno}: match")
        elif (
            isinstance(node, ast.Subscript) and id(node) not in annotated and getattr(node.value, "id", None) in generic
        ):
            found.append(f"{node.lineno}: {node.value.id}[]")
        elif isinstance(node, ast.Attribute) and node.attr in LATER:
            found.append(f"{node.lineno}: {node.attr}")
        elif isinstance(node, ast.keyword) and node.arg in LATER | {"strict"}:
            found.append(f"{node.value.lineno}: {node.arg}=")
    return found


def _annotations(tree: ast.AST) -> list[ast.expr]:
    nodes = [(getattr(node, "annotation", None), getattr(node, "returns", None)) for node in ast.walk(tree)]
    return [annotation for both in nodes for annotation in both if isinstance(annotation, ast.expr)]


@pytest.mark.sources
def test_code_uses_no_newer_python():
    found = {str(path.relative_to(ROOT)): newer(path.read_text(encoding="utf-8")) for path in FILES}
    assert {name: what for name, what in found.items() if what} == {}


@pytest.mark.sources
@pytest.mark.parametrize("source, what", [
    ("from collections.abc import Callable\nA = Callable[[int], int]", "2: Callable[]"), ("A = list[int]", "1: list[]"),
    ("match 1:\n    case 1: pass", "2: "), ("x.bit_count()", "1: bit_count"), ("zip(a, b, strict=True)", "1: strict="),
    ("x: int | None = None", "1: annotations"), ("try:\n    pass\nexcept* ValueError:\n    pass", ""),
    ("@dataclass(slots=True)\nclass A: pass", "1: slots="),
])  # fmt: skip
def test_newer_python_features_are_found(source, what):
    assert newer(source) and newer(source)[0].startswith(what)


@pytest.mark.sources
def test_package_declares_oldest_python():
    text = (ROOT / "package.xml").read_text(encoding="utf-8")
    assert re.findall(r"<pythonmin>(.*?)</pythonmin>", text) == [".".join(map(str, OLDEST))] * 1


@pytest.mark.long
def test_document_code_runs_in_python_3_8_without_freecad():
    """Without FreeCAD, vkworkbench/document can run in the oldest Python: python3.8 tests/stubbed_freecad.py."""
    done = subprocess.run(
        [sys.executable, ROOT / "tests" / "stubbed_freecad.py"], capture_output=True, text=True, timeout=300
    )
    assert done.returncode == 0, done.stderr
    assert "operations analysed and marked" in done.stdout
