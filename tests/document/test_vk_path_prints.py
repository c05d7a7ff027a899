# SPDX-License-Identifier: LGPL-2.1-or-later
"""The caches of path fingerprints and of results for shapes contain only valid entries and a limited number."""

from __future__ import annotations

import FreeCAD
import Part
import Path
import pytest

from vkworkbench.document.job.path_prints import PathPrints
from vkworkbench.document.job.setting import ShapeCache


@pytest.fixture
def prints():
    prints = PathPrints()
    yield prints
    FreeCAD.removeDocumentObserver(prints)


def found(prints, op, fingerprint="f", meanwhile=lambda: None):
    """Compute a path's fingerprint, and call `meanwhile` before it is stored; return the cached fingerprint."""
    whose, token = (op.Document.Name, op.Name), prints.begin(op)
    meanwhile()
    prints.end(whose, token, fingerprint)
    return prints.of(op)


def test_fingerprint_is_kept_until_path_or_placement_changes(small, zigzag_commands, prints):
    op, other = small.add("One", zigzag_commands), small.add("Other", zigzag_commands)
    assert prints.of(op) is None
    assert found(prints, op) == "f" and found(prints, other, "g") == "g"
    op.Label = "Renamed"
    assert prints.of(op) == "f"
    op.Path = Path.Path(op.Path.Commands[:-1])
    assert prints.of(op) is None and prints.of(other) == "g"
    other.Placement.Base = FreeCAD.Vector(1, 0, 0)
    assert prints.of(other) is None


def test_cache_observes_documents_only_once(small, zigzag_commands, prints, monkeypatch):
    heard = []
    monkeypatch.setattr(FreeCAD, "addDocumentObserver", heard.append)
    for name in ("One", "Other"):
        found(prints, small.add(name, zigzag_commands))
    assert heard == [prints]
    monkeypatch.undo()
    FreeCAD.addDocumentObserver(prints)  # The observer is added again, because the fixture removes it at the end.


def test_fingerprint_of_a_path_changed_meanwhile_is_not_stored(small, zigzag_commands, prints):
    op = small.add("One", zigzag_commands)

    def edit():
        op.Path = Path.Path(op.Path.Commands[:-1])

    assert found(prints, op, meanwhile=edit) is None
    assert found(prints, op, "") is None  # the result of a failed computation ("") is not stored
    assert found(prints, op, "g") == "g"


def test_two_computations_store_one_fingerprint(small, zigzag_commands, prints):
    """If a second computation replaced the first, an analysis and the comparison of a mark would restart each other's computation."""
    op = small.add("One", zigzag_commands)
    whose, first, second = (op.Document.Name, op.Name), prints.begin(op), prints.begin(op)
    prints.end(whose, first, "f")
    assert prints.of(op) == "f"
    prints.end(whose, second, "f")
    prints.begin(op)
    assert prints.of(op) == "f"


def test_fingerprints_of_a_closed_document_are_dropped(small, zigzag_commands, prints):
    op = small.add("One", zigzag_commands)
    name = op.Name
    assert found(prints, op) == "f"
    FreeCAD.closeDocument(small.name)
    again = FreeCAD.newDocument(small.name)
    try:
        assert prints.of(again.addObject("Path::Feature", name)) is None
    finally:
        FreeCAD.closeDocument(again.Name)


def test_cache_keeps_the_last_used_shapes():
    shapes, made = [Part.makeBox(1, 1, height) for height in (1, 2, 3)], []
    kept = ShapeCache(2)

    def of(which):
        return kept.of(shapes[which], lambda: made.append(which) or which)

    assert [of(0), of(1), of(0), of(1)] == [0, 1, 0, 1] and made == [0, 1]
    assert [of(2), of(1)] == [2, 1] and made == [0, 1, 2]
    assert of(0) == 0 and made == [0, 1, 2, 0]
    assert [of(1), of(2), of(1)] == [1, 2, 1] and made == [
        0,
        1,
        2,
        0,
        2,
    ]  # in a cache of two results, shape 2 has replaced shape 0, which was not used for the longest time
