# SPDX-License-Identifier: LGPL-2.1-or-later
"""Macros, add-ons and files that could break the views: changed 3D scenes, HTML texts and very many moves."""

from __future__ import annotations

import os
import time
from contextlib import suppress

import FreeCAD
import FreeCADGui as Gui
import Path
import pytest
from cases import first_everywhere
from PySide import QtCore, QtGui
from simulation_window import COMMAND, shown, tabs

import vkworkbench
from vkworkbench.document.job.operations import find
from vkworkbench.document.marks import marks
from vkworkbench.gui.qt import widgets
from vkworkbench.gui.strategies import view as strategy_view

SWITCH = "Show Strategies"


pytestmark = pytest.mark.usefixtures("nothing_swallowed")


def face(document):
    return document.getObjectsByLabel("Face")[0]


def drawn(document):
    return strategy_view.is_shown(document) and not strategy_view.is_drawing()


# Tests that change the scene of the 3D view while strategies are drawn or afterwards


def others_empty_the_groups(document, window):
    """A macro empties the groups in which FreeCAD and the add-on draw."""
    switch = face(document).ViewObject.SwitchNode
    for number in range(switch.getNumChildren()):
        switch.getChild(number).removeAllChildren()


def others_empty_the_switch(document, window):
    face(document).ViewObject.SwitchNode.removeAllChildren()


def others_replace_the_groups(document, window):
    from pivy import coin

    switch = face(document).ViewObject.SwitchNode
    for number in range(switch.getNumChildren()):
        switch.replaceChild(number, coin.SoGroup())


def a_switch_of_nothing(document, window):
    face(document).ViewObject.SwitchNode.whichChild = 99


def a_second_view(document, window):
    Gui.runCommand("Std_ViewCreate")
    window.settle()


def only_a_second_view(document, window):
    Gui.runCommand("Std_ViewCreate")
    window.settle()
    views = widgets.area_of_views()
    next(w for w in views.subWindowList() if w.windowTitle().startswith(document.Label)).close()
    window.settle()


def deleted_and_undone(document, window):
    document.UndoMode = 1
    document.openTransaction("Delete")
    document.removeObject(face(document).Name)
    document.commitTransaction()
    window.idle(0.05)
    document.undo()
    document.redo()
    document.undo()


def deleted_in_a_step_given_up(document, window):
    document.openTransaction("Delete")
    document.removeObject(face(document).Name)
    window.idle(0.05)
    document.abortTransaction()


def moved_into_another_document(document, window):
    other = FreeCAD.newDocument("Other")
    other.moveObject(face(document), False)
    window.settle()
    FreeCAD.closeDocument(other.Name)
    FreeCAD.setActiveDocument(document.Name)


def linked(document, window):
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = face(document)
    document.recompute()


def paths_that_change_all_the_time(document, window):
    op = document.addObject("Path::Feature", "Restless")
    for number in range(30):
        op.Path = Path.Path(f"G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X{number}\nG1 Y{number}")
        document.recompute()
        window.idle(0.01)


def numbers_beyond_measure(document, window):
    for number, value in enumerate(["nan", "inf", "-inf", "1e300", "1e38", "1e-300"]):
        op = document.addObject("Path::Feature", f"Odd{number}")
        op.Path = Path.Path(
            [Path.Command("G0", {"X": 0.0}), Path.Command("G1", {"X": float(value), "Y": 1.0, "F": 1.0})]
        )


def read_again(document, window):
    """FreeCAD's *Revert* replaces all objects by objects of the same names from the file."""
    document.restore()
    window.settle()


def other_fields(document, window):
    """A macro hides the toolpath through its scene node, and then changes its Visibility property."""
    op = face(document)
    op.ViewObject.SwitchNode.whichChild = -1
    op.ViewObject.Visibility = False
    op.ViewObject.Visibility = True


STRANGE = [a_second_view, deleted_and_undone, read_again, moved_into_another_document, others_empty_the_switch,
           others_empty_the_groups, others_replace_the_groups, a_switch_of_nothing, only_a_second_view,
           deleted_in_a_step_given_up, linked, paths_that_change_all_the_time, numbers_beyond_measure, other_fields]  # fmt: skip


@pytest.fixture(scope="module")
def short_job(example_path, kept_document, tmp_path_factory):
    """The file of the example with two operations and their tools."""
    kept_document.close()
    document = FreeCAD.openDocument(str(example_path))
    for operation in find(document):  # `find` lists a dress-up before its base, so it is also removed before its base
        if operation.object.Label not in ("Face", "Bore"):
            document.removeObject(operation.object.Name)
    used = {document.getObjectsByLabel(label)[0].ToolController.Name for label in ("Face", "Bore")}
    for controller in document.Job.Tools.Group:
        if controller.Name not in used:
            tool = controller.Tool.Name
            document.removeObject(controller.Name)
            document.removeObject(tool)
    path = tmp_path_factory.mktemp("short") / "short.FCStd"
    document.saveCopy(str(path))
    FreeCAD.closeDocument(document.Name)
    return path


@pytest.fixture
def tiny(window):
    """A small window, in which the 3D view is drawn quickly."""
    before = window.main.geometry()
    window.main.setGeometry(0, 0, 640, 480)
    yield
    window.main.setGeometry(before)


# The thread that prepares the drawing does not read the scene, so only changes of objects are made meanwhile.
MEANWHILE = [deleted_and_undone, read_again, moved_into_another_document, deleted_in_a_step_given_up,
             paths_that_change_all_the_time, only_a_second_view]  # fmt: skip


@pytest.mark.parametrize(
    ("strange", "when"),
    first_everywhere([*((one, "behind") for one in STRANGE), *((one, "meanwhile") for one in MEANWHILE)], 3),
    ids=lambda one: getattr(one, "__name__", one),
)
def test_show_strategies_survives_changes_of_the_scene(short_job, window, tiny, tmp_path, strange, when):
    copy = tmp_path / "attacked.FCStd"
    copy.write_bytes(short_job.read_bytes())
    document = FreeCAD.openDocument(str(copy))
    window.activate("VkWorkbench")
    window.click(SWITCH)
    if when == "behind":
        window.wait(lambda: drawn(document))
    strange(document, window)
    window.wait(lambda: not strategy_view.is_drawing())
    window.settle()
    assert window.button(SWITCH).isChecked() == strategy_view.is_shown(document)
    if not strategy_view.is_shown(document):  # *Revert* switches the colours off, because the document is a new object
        assert strange is read_again
        window.click(SWITCH)
        window.wait(lambda: drawn(document))
    Gui.updateGui()
    document.recompute()
    Gui.Selection.clearSelection()
    for operation in find(document):
        Gui.Selection.addSelection(operation.object)
    window.wait(lambda: drawn(document))
    if Gui.activeDocument().ActiveView is not None:
        Gui.activeDocument().ActiveView.saveImage(str(tmp_path / "view.png"), 100, 100)
    window.click(SWITCH)  # switch the colours off
    window.wait(lambda: not strategy_view.is_shown(document))
    window.click(SWITCH)  # switch the colours on again
    window.wait(lambda: drawn(document))
    FreeCAD.closeDocument(document.Name)
    window.settle()
    for name in list(FreeCAD.listDocuments()):
        FreeCAD.closeDocument(name)


# HTML texts


@pytest.fixture
def trap(tmp_path):
    """Return a text that loads a picture if a view reads the text as HTML, and a check of whether it was loaded."""
    picture = QtGui.QPixmap(60, 60)
    picture.fill(QtGui.QColor("#ff0000"))
    file = tmp_path / "trap.png"
    assert picture.save(str(file))
    now = time.time()
    # The access time is older than the change, so that the system records the next access.
    os.utime(file, (now - 10_000, now - 5_000))
    before = os.stat(file).st_atime

    class Trap:
        text = f"<img src='{file.as_uri()}'>"

        @staticmethod
        def sprung():
            return os.stat(file).st_atime != before

    return Trap


def rich(text):
    """Return whether QLabel and tooltips would show a text as HTML."""
    return QtCore.Qt.mightBeRichText(text) if hasattr(QtCore.Qt, "mightBeRichText") else QtGui.Qt.mightBeRichText(text)


def seen_as_html(widgets, trap):
    """Return the labels, tooltips and pages that show a text with the trap's picture as HTML."""
    found = []
    for widget in widgets:
        for kind, text in (("tooltip", widget.toolTip()), ("what's this", widget.whatsThis())):
            if trap.text in text and rich(text):
                found.append((type(widget).__name__, widget.objectName(), kind, text))
        if isinstance(widget, QtGui.QLabel) and trap.text in widget.text():
            plain = widget.textFormat() == QtCore.Qt.PlainText
            if not plain and (widget.textFormat() == QtCore.Qt.RichText or rich(widget.text())):
                found.append((type(widget).__name__, widget.objectName(), "label", widget.text()))
        # Qt shows a picture as this character.
        if isinstance(widget, QtGui.QTextEdit) and "\ufffc" in widget.toPlainText():
            found.append((type(widget).__name__, widget.objectName(), "page", widget.toPlainText()))
    return found


def ours(window):
    """Return all widgets in the add-on's docks, tabs, dialogs and lines."""
    roots = tabs(window)
    for widget in QtGui.QApplication.allWidgets():
        with suppress(RuntimeError):  # raised for a deleted widget whose Python object another test still holds
            if widget.objectName().startswith("Vk") or isinstance(widget, QtGui.QProgressDialog):
                roots.append(widget)
    return {id(w): w for root in roots for w in (root, *root.findChildren(QtGui.QWidget))}.values()


@pytest.fixture
def html(opened, trap):
    """A part of the example with HTML labels on the document and all its objects."""
    for operation in find(opened):
        if operation.object.Label in ("Pocket zigzag", "Pocket around island", "Adaptive pocket"):
            opened.removeObject(operation.object.Name)
    for obj in opened.Objects:
        obj.Label = f"{trap.text} {obj.Name}"
    opened.Label = trap.text
    stranger = opened.addObject("Path::Feature", "Stranger")
    stranger.Label = f"{trap.text} stranger"
    stranger.Path = Path.Path("G0 X0 Y0 Z30\nG1 Z15 F100\nG1 X50 A30\nG99.9\n(<img src='x'>)\nG1 Y9")
    opened.Job.Operations.Group += [stranger]
    opened.recompute()
    Gui.Selection.clearSelection()
    return opened


@pytest.mark.long
def test_labels_are_not_html_in_results_and_views(html, window, trap):
    found = []

    def look():
        window.settle()
        found.extend(seen_as_html(ours(window), trap))

    window.click("Analyze Toolpaths")
    window.wait(lambda: marks.is_marked(html.getObject("Stranger")))
    results = window.show_results()
    look()
    model, job = results.model, results.model.index(0, 0)
    for row in range(model.rowCount(job)):
        results.tree.setCurrentIndex(model.index(row, 0, job))
        look()
        for column in range(model.columnCount()):
            for role in (QtCore.Qt.ToolTipRole, QtCore.Qt.WhatsThisRole, QtCore.Qt.StatusTipRole):
                text = model.index(row, column, job).data(role)
                assert not (text and trap.text in text and rich(text)), text
    for operation in find(html)[:2]:
        Gui.Selection.clearSelection()
        Gui.Selection.addSelection(operation.object)
        window.click("Gauss Map")
        window.settle()
        look()
        window.click("Gauss Map")
    window.click(SWITCH)
    window.wait(lambda: drawn(html))
    look()
    window.click(SWITCH)
    assert found == [] and not trap.sprung()


@pytest.mark.long
def test_labels_are_not_html_in_the_simulation(html, window, small, trap):
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    found = seen_as_html(ours(window), trap)
    player = shown(tab, window)
    assert trap.text in player.state.text()  # the line with the simulation's state contains labels of operations
    for widget, where in [(player.state, 5), *((player.time_line, x) for x in range(10, player.time_line.width(), 60))]:
        point = QtCore.QPoint(where, min(45, widget.height() // 2))
        window.ask_for_tooltip(widget, point)
        window.settle()
    for index in range(player.scene_bar.colorings.count()):
        player.scene_bar.colorings.setCurrentIndex(index)
        window.settle()
        found += seen_as_html(ours(window), trap)
    window.screenshot("html-everywhere")
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))
    assert found == [] and not trap.sprung()


# Tests of files with few commands that cause very many moves


def arcs(moves):
    """Return `moves` half circles with a radius of 100 m, each of thousands of chords."""
    return "G0 X0 Y0 Z5\nG1 Z-1 F100\n" + "G2 X200000 Y0 I100000 J0\nG2 X0 Y0 I-100000 J0\n" * (moves // 2)


@pytest.mark.long
@pytest.mark.parametrize("text, trajectories", [
    (arcs(40), 140_000), (arcs(3_000), None), ("G0 Z5\n" + "G83 X1 Y1 Z-100 R1 Q0.1 F10\nX2\n" * 40, 80_000),
], ids=["long arcs", "too many moves", "many pecks"])  # fmt: skip
def test_few_commands_with_many_moves_are_analyzed(opened, window, text, trajectories):
    op = opened.addObject("Path::Feature", "Few")
    op.Path = Path.Path(text)
    opened.Job.Operations.Group = [op]
    opened.recompute()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(op)
    window.click("Analyze Toolpaths")
    window.wait(lambda: marks.is_marked(op))
    window.dismiss()
    known = marks.read(op)
    if trajectories is None:
        assert not known.trajectories and known.remarks
    else:
        assert known.trajectories > trajectories
    window.click("Gauss Map")
    title = window.first(QtGui.QDockWidget, "VkGaussMap").title
    window.wait(lambda: "Few" in title.text() and "Reading" not in title.text())
    window.click("Gauss Map")
    window.click(SWITCH)
    window.wait(lambda: drawn(opened))
    window.click(SWITCH)
    vkworkbench.clear(opened)
