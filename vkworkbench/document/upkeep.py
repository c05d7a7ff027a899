# SPDX-License-Identifier: LGPL-2.1-or-later
"""Keep marks in the tree up to date: watch documents, and analyse changed operations again if the user wants it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress

import FreeCAD

from vkworkbench import preferences
from vkworkbench.document.computer import idle
from vkworkbench.document.job.operations import find
from vkworkbench.document.marks import marking, marks
from vkworkbench.document.marks.properties import may_have_mark
from vkworkbench.document.marks.watcher import Watcher
from vkworkbench.report import Cancelled, Report


class Upkeep(Watcher):
    """A watcher that, in FreeCAD without a window, also analyses outdated operations again after a recompute."""

    def slotRecomputedDocument(self, document) -> None:
        super().slotRecomputedDocument(document)
        if not FreeCAD.GuiUp and preferences.read().analyze_after_recompute:
            from vkworkbench.document import analysis  # imported late, because the module loads FreeCAD's simulators

            idle.work(analyzing_again(document, analysis.analyze))


_upkeep: Upkeep | None = None
# Preferences that change the texts of marks in the tree.
IN_MARKS = frozenset({"mark_simulator", "time_budget"})


def watch() -> None:
    """Start to keep the marks of all documents up to date. If the function is called again, it does nothing."""
    global _upkeep
    if _upkeep is None:
        _upkeep = Upkeep()
        FreeCAD.addDocumentObserver(_upkeep)
        if not FreeCAD.GuiUp:  # with a window, `gui.tree.pills` updates the marks after all preferences were written
            preferences.observe(lambda name: name in IN_MARKS and follow_preferences())


def follow_preferences() -> None:
    """Update the marks in the tree of all open documents after a change of the preferences."""
    chosen = preferences.read()
    for document in FreeCAD.listDocuments().values():
        for obj in filter(may_have_mark, document.Objects):
            marks.follow(obj, chosen)


def mark(report: Report) -> int:
    """Mark the operations of a report, and their jobs with totals; keep the marks up to date.

    The marks are one undo step for each document.

    Returns
    -------
    int
        Number of marked operations. Operations deleted since the analysis are skipped.
    """
    watch()
    return marking.mark(report)


def analyzing_again(document, analyze: Callable) -> Iterator[None]:
    """Analyse and mark the operations with outdated marks, in steps that are executed when FreeCAD is idle.

    `analyze` is a function like ``vkworkbench.analyze``. If the user cancels the analysis, the marks stay outdated.
    """
    outdated = [o.object for o in find(document) if marks.is_outdated(o.object)]
    if outdated:
        with suppress(Cancelled):
            marking.mark(analyze(outdated), undo_step=False)
    yield
