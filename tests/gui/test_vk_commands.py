# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands in the window: buttons, menus, progress, Esc, and the descriptions in the tree."""

import FreeCAD
import FreeCADGui as Gui
import pytest
from cases import first_everywhere
from PySide import QtCore, QtGui

import vkworkbench
from vkworkbench import freecad
from vkworkbench.document.marks import marks
from vkworkbench.gui.qt import progress
from vkworkbench.gui.results.findings import read_findings
from vkworkbench.gui.results.rows import rows_of
from vkworkbench.gui.tree import column as tree

CAM = "PathWorkbench" if freecad.version() < (1, 0) else "CAMWorkbench"


def marked(document):
    return [obj for obj in document.Objects if marks.is_marked(obj)]


def test_first_analysis_shows_the_description_column(opened, window):
    FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/VkWorkbench").RemBool("DescriptionShown")
    if freecad.version() >= (1, 0):
        FreeCAD.ParamGet("User parameter:BaseApp/Preferences/TreeView").SetBool("HideColumn", True)
    window.click("Analyze Toolpaths")
    window.wait(lambda: marked(opened))
    window.wait(lambda: not window.tree.isColumnHidden(1) and window.tree.columnWidth(1) > 100)
    # The message counts the marks with a warning sign, for example for slow arcs in the OpenGL simulator.
    jobs = rows_of(read_findings(opened))
    told = sum(row.is_warned for job in jobs for row in (job, *job.rows))
    count = vkworkbench.analyze(opened).totals[0].operations
    assert f"⟦{count} operations" in opened.getObject("Job").Label2
    assert told
    warned = " 1 mark has a warning" if told == 1 else f" {told} marks have warnings"
    warned += ": see Toolpath Results (V, R)."
    assert window.main.statusBar().currentMessage() == f"{count} operations were analyzed.{warned}"
    assert window.dismiss() == [] and not any(one.isVisible() for one in window.find(QtGui.QDockWidget, "VkResults"))
    window.tree.expandAll()
    window.see_all()
    window.screenshot("marks")
    shown = window.descriptions()
    assert shown["Face"].startswith("⟦zigzag") and "⟦adaptive" in shown["Adaptive pocket"]
    assert shown["Job"].startswith("⟦") and "operations" in shown["Job"]

    Gui.runCommand("Std_Undo")
    window.wait(lambda: not marked(opened))
    window.click("Analyze Toolpaths")
    window.wait(lambda: marked(opened))
    window.click("Clear Analysis")
    window.wait(lambda: not marked(opened))
    assert "marks were removed." in window.main.statusBar().currentMessage()


def test_long_label_does_not_hide_the_marks(opened, window):
    (face,) = opened.getObjectsByLabel("Face")
    header, before = window.tree.header(), window.tree.header().sectionResizeMode(0)
    face.Label = (
        "Roughing of the outer contour with the long end mill, second clamping, part turned, variant with tags " * 2
    )
    window.analyze(opened)
    window.dismiss()
    window.settle()
    view = window.tree
    assert view.columnWidth(0) < view.sizeHintForColumn(0) / 2
    assert header.sectionViewportPosition(1) + view.columnWidth(1) / 2 < view.viewport().width()
    window.screenshot("long-name")
    wider = view.columnWidth(0) + 100
    view.setColumnWidth(0, wider)  # a user can drag the border of the column
    window.settle()
    assert view.columnWidth(0) == wider
    face.Label = "Face"
    window.click("Analyze Toolpaths")
    window.wait(lambda: header.sectionResizeMode(0) == before and view.columnWidth(0) < 300)


def test_analysis_brings_the_tree_in_front_of_the_tasks(opened, window):
    docks = {dock.objectName(): dock for dock in window.find(QtGui.QDockWidget)}
    if "Tasks" in docks:
        window.main.tabifyDockWidget(docks["Model"], docks["Tasks"])
        docks["Tasks"].setVisible(True)
        window.settle()
        docks["Tasks"].raise_()
    for tabs in window.find(QtGui.QTabWidget):
        if tabs.objectName() == "combiTab":
            tabs.setCurrentIndex(1)
    trees = tree.trees()
    window.wait(lambda: all(view.visibleRegion().isEmpty() for view in trees))
    window.click("Analyze Toolpaths")
    window.wait(lambda: marked(opened))
    window.wait(lambda: any(not view.visibleRegion().isEmpty() for view in trees))


def test_button_and_macro_give_the_same_results(opened, window):
    window.click("Analyze Toolpaths")
    window.wait(lambda: marked(opened))
    for o in vkworkbench.analyze(opened).operations:
        obj = opened.getObject(o.name)
        own = freecad.own_simulator()
        assert (marks.read(obj).cost(own), obj.Strategy) == (o.cost(own), o.strategy.value)


def test_only_selected_operations_are_analyzed(opened, window):
    face = opened.getObjectsByLabel("Face")[0]
    Gui.Selection.addSelection(face)
    window.click("Analyze Toolpaths")
    window.wait(lambda: marked(opened))
    assert marked(opened) == [face]


def test_message_if_there_is_nothing_to_analyze(window):
    document = FreeCAD.newDocument("Empty")
    window.activate("VkWorkbench")
    window.click("Analyze Toolpaths")
    window.wait(window.boxes)
    assert ["no operation" in text for text in window.dismiss()] == [True]
    FreeCAD.closeDocument(document.Name)
    window.wait(lambda: not window.button("Analyze Toolpaths").isEnabled())
    Gui.runCommand("Vk_Analyze")  # a macro can still run a disabled command
    Gui.runCommand("Vk_Clear")


@pytest.mark.parametrize("after", first_everywhere([2, 0]))
def test_document_closed_during_its_analysis_shows_no_message(example_path, window, monkeypatch, after):
    document = FreeCAD.openDocument(str(example_path))
    window.activate("VkWorkbench")
    show, shown = progress._show, []

    def close_meanwhile(dialog, done, *of):
        shown.append(done)
        if done == after:
            FreeCAD.closeDocument(document.Name)
        show(dialog, done, *of)

    monkeypatch.setattr(progress, "_show", close_meanwhile)
    window.main.statusBar().clearMessage()
    Gui.runCommand("Vk_Analyze")
    window.settle()
    assert shown[-1] >= after and not FreeCAD.listDocuments()
    assert window.dismiss() == [] and "analyzed" not in window.main.statusBar().currentMessage()


def test_esc_cancels_the_analysis_without_any_change(opened, window):
    job = opened.getObject("Job")
    for _ in range(20):
        copy = opened.copyObject(opened.getObjectsByLabel("Adaptive pocket")[0], False)
        job.Operations.Group += [copy]
    before = [(obj.Name, obj.Label2, tuple(obj.PropertiesList)) for obj in opened.Objects]
    undo = opened.UndoCount
    pressed = []

    def press_esc():
        dialog = window.progress_dialog()
        if dialog is not None:
            pressed.append(dialog.labelText())
            window.press(dialog, QtCore.Qt.Key_Escape)
        elif not pressed:
            QtCore.QTimer.singleShot(20, press_esc)

    QtCore.QTimer.singleShot(20, press_esc)
    window.click("Analyze Toolpaths")
    window.settle()
    assert pressed and pressed[0]  # the progress dialog showed the operation's name before Esc
    assert "cancelled" in window.main.statusBar().currentMessage()
    assert [(obj.Name, obj.Label2, tuple(obj.PropertiesList)) for obj in opened.Objects] == before
    assert opened.UndoCount == undo


def menu_texts(menu):
    return [action.text().replace("&", "") for action in menu.actions()]


def test_commands_are_in_freecads_own_workbench(opened, window):
    window.activate(CAM)
    assert window.button("Analyze Toolpaths").isVisible() and window.button("Clear Analysis").isVisible()
    menus = [m for m in window.find(QtGui.QMenu) if m.title().replace("&", "") in ("CAM", "Path")]
    assert {"Analyze Toolpaths", "Clear Analysis"} <= set(menu_texts(menus[0]))
    own_toolbars = [t for t in window.find(QtGui.QToolBar) if t.isVisible()]
    assert len(own_toolbars) > 5  # the add-on's toolbar does not replace the toolbars of FreeCAD's workbench
    window.click("Analyze Toolpaths")
    window.wait(lambda: marked(opened))


def test_commands_have_icons_and_tooltips(window):
    window.activate("VkWorkbench")
    for name in ("Analyze Toolpaths", "Clear Analysis"):
        action = window.button(name).defaultAction()
        assert not action.icon().isNull() and action.toolTip() and action.statusTip()


def test_changed_operation_is_shown_as_outdated_in_the_tree(opened, window):
    window.click("Analyze Toolpaths")
    window.wait(lambda: marked(opened))
    drill = opened.getObjectsByLabel("Drill holes")[0]
    opened.openTransaction("Depth")
    drill.setExpression("FinalDepth", None)
    drill.FinalDepth = drill.FinalDepth.Value + 1
    opened.recompute()
    opened.commitTransaction()
    window.wait(lambda: window.descriptions()["Drill holes"].endswith("outdated⟧"))
    window.see_all()
    window.screenshot("outdated")
    Gui.runCommand("Std_Undo")
    window.wait(lambda: not window.descriptions()["Drill holes"].endswith("outdated⟧"))


def test_marks_are_compared_with_operations_of_a_reopened_file(opened, window, tmp_path):
    vkworkbench.mark(vkworkbench.analyze(opened))
    stale = opened.getObjectsByLabel("Face")[0]
    stale.VkWorkbenchMark = stale.VkWorkbenchMark.replace(marks.read(stale).fingerprint, "of:another")
    opened.saveCopy(str(tmp_path / "copy.FCStd"))
    copy = FreeCAD.openDocument(str(tmp_path / "copy.FCStd"))
    window.wait(lambda: marks.is_outdated(copy.getObjectsByLabel("Face")[0]))
    assert not marks.is_outdated(copy.getObjectsByLabel("Bore")[0])
    FreeCAD.closeDocument(copy.Name)
    FreeCAD.setActiveDocument(opened.Name)
