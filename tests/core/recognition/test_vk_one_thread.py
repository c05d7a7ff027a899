# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognition uses one thread. On a busy computer, the threads of BLAS would wait for each other."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

pytestmark = pytest.mark.sources

CORE = Path(__file__).parents[3] / "vkworkbench" / "core"
SOURCES = [*(p for room in ("gcode", "paper", "recognition") for p in (CORE / room).rglob("*.py")), *CORE.glob("*.py")]
BLAS = {"dot", "vdot", "inner", "matmul", "tensordot", "linalg", "polyfit", "corrcoef", "cov", "convolve", "correlate"}
# Recognition does not use solids and views. The matrix products for solids and views (3 numbers) are too small for
# threads.
OTHER = {"solids.py", "stocks.py", "view.py"}


def products(tree):
    """Yield the numbers of the lines on which numpy would call BLAS, for matrix products."""
    for node in ast.walk(tree):
        if isinstance(node, (ast.BinOp, ast.AugAssign)) and isinstance(node.op, ast.MatMult):
            yield node.lineno
        elif isinstance(node, ast.Attribute) and node.attr in BLAS:
            if node.attr in ("dot", "linalg") or (isinstance(node.value, ast.Name) and node.value.id == "np"):
                yield node.lineno


def test_recognition_has_no_matrix_products(parse):
    lines = {str(path.relative_to(CORE)): list(products(parse(path))) for path in SOURCES if path.name not in OTHER}
    assert {name: found for name, found in lines.items() if found} == {}


def test_search_in_source_code_finds_all_matrix_products():
    code = "a @ b\na @= b\nnp.dot(a, b)\na.dot(b)\nnp.linalg.solve(a, b)\nnp.polyfit(x, y, 1)\ndot(a, b)\nnp.einsum('i,i', a, b)"
    assert sorted(products(ast.parse(code))) == [1, 2, 3, 4, 5, 6]
