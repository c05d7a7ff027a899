# SPDX-License-Identifier: LGPL-2.1-or-later
"""Marks kept up to date: all documents are watched from the first mark on, and analysed again if the user wishes."""

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
    """An observer that also analyses again, once the watcher has found what is outdated; a window does that itself."""

    def slotRecomputedDocument(self, document) -> None:
        super().slotRecomputedDocument(document)
        if not FreeCAD.GuiUp and preferences.read().analyze_after_recompute:
            from vkworkbench.document import analysis  # loads FreeCAD's simulators

            idle.work(analyzing_again(document, analysis.analyze))


_upkeep: Upkeep | None = None
# Preferences on which the text of a mark depends.
IN_MARKS = frozenset({"mark_simulator", "time_budget"})


def watch() -> None:
    """Keep the marks of all documents up to date from now on; called again it does nothing."""
    global _upkeep
    if _upkeep is None:
        _upkeep = Upkeep()
        FreeCAD.addDocumentObserver(_upkeep)
        if not FreeCAD.GuiUp:  # the window waits until all preferences are changed
            preferences.observe(lambda name: name in IN_MARKS and follow_preferences())


def follow_preferences() -> None:
    """Let the marks of all open documents say what the preferences ask for."""
    chosen = preferences.read()
    for document in FreeCAD.listDocuments().values():
        for obj in filter(may_have_mark, document.Objects):
            marks.follow(obj, chosen)


def mark(report: Report) -> int:
    """Write a report's findings on its operations and the totals on their jobs, and keep them up to date.

    One undo step a document.

    Returns
    -------
    int
        How many operations were marked; one that was deleted since the analysis is passed over.
    """
    watch()
    return marking.mark(report)


def analyzing_again(document, analyze: Callable) -> Iterator[None]:
    """Analyse the operations whose marks are outdated, and mark them: work for when FreeCAD is idle.

    Parameters
    ----------
    document : Document
    analyze : callable
        Does what ``vkworkbench.analyze`` does; what the user cancels stays outdated.
    """
    outdated = [o.object for o in find(document) if marks.is_outdated(o.object)]
    if outdated:
        with suppress(Cancelled):
            marking.mark(analyze(outdated), undo_step=False)
    yield
