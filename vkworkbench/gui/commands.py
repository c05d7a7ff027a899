# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands a user clicks: each calls what a macro calls."""

from __future__ import annotations

import FreeCAD
import FreeCADGui as Gui

import vkworkbench
from vkworkbench import preferences
from vkworkbench.document.job.operations import is_gone
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.text import is_warned
from vkworkbench.document.simulation.faults import read_with_faults
from vkworkbench.gui.qt import progress
from vkworkbench.gui.qt.document_command import DocumentCommand, selected_operations
from vkworkbench.gui.qt.plain_text import inform
from vkworkbench.gui.qt.sentences import plural
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, translate
from vkworkbench.gui.results import command as panel_command
from vkworkbench.gui.tree import column as tree
from vkworkbench.gui.tree import pills
from vkworkbench.preferences import GROUP


class AnalyzeCommand(DocumentCommand):
    """Analyse the selected operations, or all of the active document, and mark them."""

    name = "Vk_Analyze"
    menu = QT_TRANSLATE_NOOP("Vk_Analyze", "Analyze toolpaths")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_Analyze",
        "Recognizes the machining strategy of each selected operation, or of all operations of the active "
        "document, estimates what simulating it costs, and marks it in the tree.",
    )
    keys = "V, K"

    def Activated(self) -> None:
        document = FreeCAD.ActiveDocument
        if document is None:
            _tell(translate("Vk_Analyze", "No document is open. Open one with a job or a toolpath first."))
            return
        try:
            report = progress.analyze(selected_operations() or document)
        except vkworkbench.Cancelled:
            _status(translate("Vk_Analyze", "Analysis cancelled, nothing changed."))
            return
        if is_gone(document):  # closed meanwhile: nothing is left to mark, and nobody asks for it any more
            return
        if not report.operations:
            _tell(translate(
                "Vk_Analyze",
                "There is no operation to analyze in this document. Create a job with operations, or import G-code.",
            ))  # fmt: skip
            return
        for job in _unmarked_jobs(report):
            tree.expand(job.Label, job.Document.Label)
        mark(report)
        _show_marks()
        panel_command.show()
        warned = _warned(report)
        one, more = (
            translate("Vk_Analyze", "{count} operation analyzed"), translate("Vk_Analyze", "{count} operations analyzed")
        )  # fmt: skip
        # As their job counts them: one that is switched off, or that a dress-up stands for, only where it is alone.
        text = plural(one, more, sum(o.counted for o in report.operations) or len(report.operations))
        if warned:
            one, more = (
                translate("Vk_Analyze", "{count} has a warning"), translate("Vk_Analyze", "{count} have warnings")
            )  # fmt: skip
            text += ", " + plural(one, more, warned)
        _status(text)


class ClearCommand(DocumentCommand):
    """Remove the marks of the selected operations, or of the whole active document."""

    name = "Vk_Clear"
    menu = QT_TRANSLATE_NOOP("Vk_Clear", "Clear analysis")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_Clear",
        "Removes the marks of the selected operations, or all marks of the active document; your own "
        "descriptions stay.",
    )

    def Activated(self) -> None:
        if FreeCAD.ActiveDocument is None:
            return
        with tree.steady_columns():
            cleared = vkworkbench.clear(selected_operations() or FreeCAD.ActiveDocument)
        one, more = translate("Vk_Clear", "{count} mark removed"), translate("Vk_Clear", "{count} marks removed")
        _status(plural(one, more, cleared))


def mark(report) -> None:
    """Write the marks and show them as pills, without a visible delay."""
    pills.show()
    with tree.steady_columns():
        vkworkbench.mark(report)
    pills.fit_column()


def _unmarked_jobs(report) -> list:
    """Return the jobs of the report that have no mark yet: the user sees in the tree where marks stand, once."""
    documents = FreeCAD.listDocuments()
    jobs = [documents[document].getObject(name) for document, name in report.jobs if document in documents]
    return [job for job in jobs if job is not None and not marks.is_marked(job)]


def _warned(report) -> int:
    """Return how many of the operations just marked have a warning sign."""
    documents, chosen = FreeCAD.listDocuments(), preferences.read()
    objects = (documents[o.document].getObject(o.name) for o in report.operations if o.document in documents)
    marked = (read_with_faults(obj) for obj in objects if obj is not None)
    return sum(is_warned(record, chosen) for record in marked if record is not None)


def _show_marks() -> None:
    """Show the Description column the first time that a tree is seen, and say so; afterwards it is the user's own."""
    tree.bring_to_view()
    if not FreeCAD.ParamGet(GROUP).GetBool("DescriptionShown", False):
        tree.when_seen(_show_description)


def _show_description() -> None:
    remembered = FreeCAD.ParamGet(GROUP)
    if not remembered.GetBool("DescriptionShown", False):
        remembered.SetBool("DescriptionShown", True)
        was_hidden = tree.show_description()
        pills.fit_column()
        if was_hidden:
            _tell(translate(
                "Vk_Analyze",
                "The marks are in the tree's Description column, which is now visible. You can hide it again in the "
                "tree's context menu: Tree settings, Show description.",
            ))  # fmt: skip


def _tell(text: str) -> None:
    inform(translate("Vk_Analyze", "Toolpath analysis"), text, Gui.getMainWindow())


def _status(text: str) -> None:
    Gui.getMainWindow().statusBar().showMessage(text, 10_000)


AnalyzeCommand.add()
ClearCommand.add()
