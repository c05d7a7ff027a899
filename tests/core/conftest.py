# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings and order of the core's tests."""

from __future__ import annotations

import ast
from functools import lru_cache

import pytest
from hypothesis import settings

# A busy machine is no failure. The same examples in every run: what it finds is the change's. A third of what
# is usual, for they run with every change; mutants are noticed by these as often as by more.
settings.register_profile("tests", deadline=None, derandomize=True, max_examples=35)
settings.load_profile("tests")


@pytest.fixture(scope="session")
def parse():
    """Return a function that parses a source file, given as a Path, and parses no file twice."""
    return lru_cache(maxsize=None)(lambda path: ast.parse(path.read_text(encoding="utf-8")))


def pytest_collection_modifyitems(items):
    """Begin with the tests that take seconds: the others run beside them on the other processors, and none is waited for."""
    items.sort(key=lambda item: item.get_closest_marker("long") is None)
