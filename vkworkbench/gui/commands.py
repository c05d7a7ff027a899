# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands *Analyze Toolpaths* and *Clear Analysis*, which call the functions that macros call."""

from __future__ import annotations

import FreeCAD
import FreeCADGui as Gui

import vkworkbench
from vkworkbench import preferences
from vkworkbench.document.job.operations import is_gone
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.text import is_warned
from vkworkbench.document.simulation.faults import read_with_faults
from vkworkbench.gui import measuring
from vkworkbench.gui.qt import progress
from vkworkbench.gui.qt.document_command import DocumentCommand, selected_operations
from vkworkbench.gui.qt.plain_text import inform, show_status
from vkworkbench.gui.qt.sentences import plural, sentence
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, translate
from vkworkbench.gui.results import command as results
from vkworkbench.gui.tree import column, pills
from vkworkbench.language import Unusable
from vkworkbench.preferences import GROUP


class AnalyzeCommand(DocumentCommand):
    """Analyse the selected operations, or all of the active document, and write marks in the tree."""

    name = "Vk_Analyze"
    menu = QT_TRANSLATE_NOOP("Vk_Analyze", "Analyze Toolpaths")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_Analyze",
        "Recognizes the machining strategy of each selected operation, or of all "
        "operations of the active document. Estimates what simulating each operation "
        "costs, and marks it in the tree.",
    )
    keys = "V, K"

    def Activated(self) -> None:
        document = FreeCAD.ActiveDocument
        if document is None:
            _inform(translate("Vk_Analyze", "No document is open. Open one with a job or a toolpath first."))
            return
        try:
            report = progress.analyze(selected_operations() or document)
        except vkworkbench.Cancelled:
            show_status(translate("Vk_Analyze", "The analysis was cancelled. Nothing has changed."))
            return
        except Unusable as error:
            show_status(sentence(error.what))
            return
        if is_gone(document):  # the document was closed during the analysis
            return
        if not report.operations:
            _inform(translate(
                "Vk_Analyze",
                "There is no operation to analyze in this document. Create a job with operations, or import G-code.",
            ))  # fmt: skip
            return
        for job in _unmarked_jobs(report):
            column.expand(job.Label, job.Document.Label)
        mark(report)
        _show_marks()
        results.refresh()
        measuring.measure_once()
        warned = _warned(report)
        one, more = (
            translate("Vk_Analyze", "{count} operation was analyzed."), translate("Vk_Analyze", "{count} operations were analyzed.")
        )  # fmt: skip
        # Leave out inactive operations and bases of dress-ups, which the total of the job does not include either. If
        # all analysed operations are inactive or bases, the message gives the number of all analysed operations.
        text = plural(one, more, sum(o.counted for o in report.operations) or len(report.operations))
        if warned:
            one, more = (
                translate("Vk_Analyze", "{count} mark has a warning: see Toolpath Results (V, R)."),
                translate("Vk_Analyze", "{count} marks have warnings: see Toolpath Results (V, R)."),
            )
            text += " " + plural(one, more, warned)
        show_status(text)


class ClearCommand(DocumentCommand):
    """Remove the marks in the tree of the selected operations, or of the whole active document."""

    name = "Vk_Clear"
    menu = QT_TRANSLATE_NOOP("Vk_Clear", "Clear Analysis")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_Clear",
        "Removes the marks of the selected operations, or all marks of the active "
        "document. Your own descriptions stay.",
    )

    def Activated(self) -> None:
        if FreeCAD.ActiveDocument is None:
            return
        with column.steady_columns():
            cleared = vkworkbench.clear(selected_operations() or FreeCAD.ActiveDocument)
        removed = translate("Vk_Clear", "The marks were removed.")
        show_status(removed if cleared else translate("Vk_Clear", "There are no marks to remove."))


def mark(report) -> None:
    """Write the marks of a report, and show them as pills in the tree."""
    pills.show()
    with column.steady_columns():
        vkworkbench.mark(report)
    pills.fit_column()


def _unmarked_jobs(report) -> list:
    """Return the jobs of a report without a mark in the tree, whose branches are expanded to show the new marks."""
    documents = FreeCAD.listDocuments()
    jobs = [documents[document].getObject(name) for document, name in report.jobs if document in documents]
    return [job for job in jobs if job is not None and not marks.is_marked(job)]


def _warned(report) -> int:
    """Return how many marks of a report's operations and jobs have a warning sign in the tree."""
    documents, chosen = FreeCAD.listDocuments(), preferences.read()
    names = [*((o.document, o.name) for o in report.operations), *report.jobs]
    objects = (documents[document].getObject(name) for document, name in names if document in documents)
    marked = (read_with_faults(obj) for obj in objects if obj is not None)
    return sum(is_warned(record, chosen) for record in marked if record is not None)


def _show_marks() -> None:
    """Show the Description column of the tree at the first analysis. The user can hide the column again."""
    column.bring_to_view()
    if not FreeCAD.ParamGet(GROUP).GetBool("DescriptionShown", False):
        column.when_seen(_show_description)


def _show_description() -> None:
    remembered = FreeCAD.ParamGet(GROUP)
    if not remembered.GetBool("DescriptionShown", False):
        remembered.SetBool("DescriptionShown", True)
        column.show_description()
        pills.fit_column()


def _inform(text: str) -> None:
    inform(translate("Vk_Analyze", "Toolpath Analysis"), text, Gui.getMainWindow())


AnalyzeCommand.add()
ClearCommand.add()
