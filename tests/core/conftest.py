# SPDX-License-Identifier: LGPL-2.1-or-later
"""Settings and order of the core's tests."""

from __future__ import annotations

import ast
from functools import lru_cache

import pytest
from hypothesis import settings

# There is no deadline, because a test must not fail only because the computer is busy.
# With `derandomize`, Hypothesis tries the same examples in every run, so a new failure is caused by the tested change.
# With 35 examples instead of Hypothesis' default of 100, the tests are quick. More examples do not detect more mutants.
settings.register_profile("tests", deadline=None, derandomize=True, max_examples=35)
settings.load_profile("tests")


@pytest.fixture(scope="session")
def parse():
    """Return a function that parses a source file, given as a Path, and parses no file twice."""
    return lru_cache(maxsize=None)(lambda path: ast.parse(path.read_text(encoding="utf-8")))


def pytest_collection_modifyitems(items):
    """Run the tests marked as long first, so that the last process to finish is not left with a long test."""
    items.sort(key=lambda item: item.get_closest_marker("long") is None)
