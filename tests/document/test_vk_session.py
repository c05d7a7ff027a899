# SPDX-License-Identifier: LGPL-2.1-or-later
"""Results of this session are kept while the document is open and the operation is unchanged."""

from __future__ import annotations

from types import SimpleNamespace

import FreeCAD

from vkworkbench.document.job import results


def row(document, name, fingerprint="f"):
    return SimpleNamespace(document=document, name=name, fingerprint=fingerprint)


def test_last_result_is_returned_for_its_fingerprint(small):
    op = small.add("Op", [])
    assert results.latest_row(op, "f") is None
    before, after = row(small.name, op.Name), row(small.name, op.Name, "g")
    results.remember([before, row(small.name, "Other", "g")])
    assert results.latest_row(op, "f") is before and results.latest_row(op, "g") is None
    results.remember([after])
    assert results.latest_row(op, "g") is after and results.latest_row(op, "f") is None


def test_new_document_of_the_same_name_has_no_old_results(small):
    op = small.add("Op", [])
    results.remember([row(small.name, op.Name)])
    FreeCAD.closeDocument(small.name)
    again = FreeCAD.newDocument(small.name)
    try:
        assert again.Name == small.name
        assert results.latest_row(again.addObject("Path::Feature", "Op"), "f") is None
    finally:
        FreeCAD.closeDocument(again.Name)


def test_new_results_are_preferred_to_remembered_results(small):
    old = [row(small.name, "A"), row(small.name, "B")]
    results.remember(old)
    new = row(small.name, "B", "g")
    known = results.latest_rows([new])
    assert (known[small.name, "A"], known[small.name, "B"]) == (old[0], new)
    assert results.latest_rows([])[small.name, "B"] is old[1]  # the stored result of operation B stays
