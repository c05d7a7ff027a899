# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fixtures for the tests inside FreeCAD."""

from __future__ import annotations

import pytest


@pytest.fixture(scope="session")
def example_path(tmp_path_factory):
    """Return the file of the example job, made once with this FreeCAD. Tests open the file and do not write to it."""
    import FreeCAD
    from make_example import make_example

    path = tmp_path_factory.mktemp("example") / "example.FCStd"
    FreeCAD.closeDocument(make_example(path).Name)
    return path


@pytest.fixture
def example(example_path):
    """Yield the example job as a freshly opened document, and close it after the test."""
    import FreeCAD

    doc = FreeCAD.openDocument(str(example_path))
    yield doc
    FreeCAD.closeDocument(doc.Name)
