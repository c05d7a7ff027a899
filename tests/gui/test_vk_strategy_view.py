# SPDX-License-Identifier: LGPL-2.1-or-later
"""Strategies in the 3D view: the colours that are seen, that nothing is changed, and that nothing stays behind."""

from collections import Counter

import FreeCAD
import FreeCADGui as Gui
import pytest
from make_example import cam
from PySide import QtGui

from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.gui import colors, strategy_view

SWITCH = "Show strategies"


@pytest.fixture
def switched_on(opened, window):
    """The example seen from above, its toolpaths coloured."""
    Gui.activeView().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    window.idle(0.3)
    window.click(SWITCH)
    window.wait(lambda: strategy_view.is_shown(opened))
    window.idle(0.5)
    yield opened
    if strategy_view.is_shown(opened):
        window.click(SWITCH)


def labelled(document, label):
    (obj,) = document.getObjectsByLabel(label)
    return obj


def seen(tmp_path):
    """How many pixels of the 3D view have which colour."""
    path = str(tmp_path / "view.png")
    Gui.activeView().saveImage(path, 700, 600, "#ffffff")
    image = QtGui.QImage(path)
    return Counter(image.pixelColor(x, y).name() for x in range(image.width()) for y in range(image.height()))


def nodes(document):
    """How many coloured toolpaths hang in the 3D view."""
    from pivy import coin

    search = coin.SoSearchAction()
    search.setName("VkStrategies")
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(Gui.getDocument(document.Name).ActiveView.getSceneGraph())
    return len(list(search.getPaths()))


def test_every_trajectory_has_the_colour_of_its_span():
    commands = [("G0", {"Z": 5.0}), ("G0", {"X": 0.0, "Y": 0.0}), ("G1", {"Z": -1.0})]
    for row in range(20):
        commands += [("G1", {"X": 60.0 * (row % 2 == 0)}), ("G1", {"Y": 2.0 * row + 2})]
    toolpath = linearize([*commands, ("G0", {"Z": 5.0})])
    spans = recognize(toolpath, tool_diameter=5).spans
    parts = dict(strategy_view.colored_parts(toolpath, spans))
    assert sorted(i for part in parts.values() for i in part) == list(range(len(toolpath)))
    assert list(parts[colors.RAPID]) == [i for i in range(len(toolpath)) if toolpath.rapid[i]]
    assert len(parts[Strategy.ZIGZAG.color]) >= 39
    assert set(dict(strategy_view.colored_parts(toolpath, ()))) == {colors.RAPID, Strategy.UNKNOWN.color}


def test_the_colours_are_seen_and_go_again(opened, window, switched_on, tmp_path):
    window.screenshot("strategies-top")
    there = seen(tmp_path)
    for strategy in (Strategy.ZIGZAG, Strategy.CONTOUR_PARALLEL, Strategy.ADAPTIVE):
        assert there[strategy.color] > 20, strategy
    Gui.activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    window.screenshot("strategies")
    window.click(SWITCH)
    window.wait(lambda: not strategy_view.is_shown(opened))
    assert nodes(opened) == 0
    gone = seen(tmp_path)
    assert gone[Strategy.ZIGZAG.color] == gone[Strategy.ADAPTIVE.color] == 0


def test_the_document_is_not_changed(opened, window):
    before = [(obj.Name, obj.Label2, tuple(obj.PropertiesList), list(obj.State)) for obj in opened.Objects]
    undo = opened.UndoCount
    window.click(SWITCH)
    window.wait(lambda: strategy_view.is_shown(opened))
    window.click(SWITCH)
    window.wait(lambda: not strategy_view.is_shown(opened))
    assert [(obj.Name, obj.Label2, tuple(obj.PropertiesList), list(obj.State)) for obj in opened.Objects] == before
    assert opened.UndoCount == undo and not Gui.getDocument(opened.Name).Modified


def test_an_operation_takes_its_colours_along(opened, window, switched_on, tmp_path):
    count = nodes(opened)
    assert count >= 8
    labelled(opened, "Adaptive pocket").ViewObject.Visibility = False
    window.idle()
    assert seen(tmp_path)[Strategy.ADAPTIVE.color] == 0
    labelled(opened, "Adaptive pocket").ViewObject.Visibility = True
    opened.removeObject(labelled(opened, "Adaptive pocket").Name)
    window.idle()
    assert nodes(opened) == count - 1


def test_the_selected_operation_is_wider(opened, window, switched_on, tmp_path):
    color = Strategy.HELIX.color
    before = seen(tmp_path)[color]
    Gui.Selection.addSelection(labelled(opened, "Bore"))
    window.idle()
    window.screenshot("strategies-selected")
    assert seen(tmp_path)[color] > 1.3 * before > 0
    Gui.Selection.clearSelection()
    assert seen(tmp_path)[color] == before


def test_a_changed_toolpath_is_coloured_anew(opened, window, switched_on):
    drill = labelled(opened, "Drill holes")
    _, before = strategy_view._drawn[opened.Name][drill.Name]
    opened.openTransaction("Depth")
    drill.setExpression("FinalDepth", None)
    drill.FinalDepth = drill.FinalDepth.Value + 1
    opened.recompute()
    opened.commitTransaction()
    _, after = strategy_view._drawn[opened.Name][drill.Name]
    assert after is not before
    window.idle()
    assert nodes(opened) == len(strategy_view._drawn[opened.Name])


def test_each_document_has_its_own_switch(opened, window, switched_on):
    assert window.button(SWITCH).isChecked()
    other = FreeCAD.newDocument("Other")
    window.wait(lambda: not window.button(SWITCH).isChecked())
    FreeCAD.closeDocument(other.Name)
    FreeCAD.setActiveDocument(opened.Name)
    window.wait(lambda: window.button(SWITCH).isChecked())


def test_closing_the_document_forgets_it(example_path, window):
    document = FreeCAD.openDocument(str(example_path))
    window.activate("VkWorkbench")
    name = document.Name
    window.click(SWITCH)
    window.wait(lambda: strategy_view.is_shown(document))
    FreeCAD.closeDocument(name)
    window.idle()
    assert name not in strategy_view._drawn


def test_an_operation_that_freecad_does_not_draw_is_passed_over(opened, window):
    """One that a macro made has no view proxy, and FreeCAD gives it nothing that lines could hang below."""
    profile = cam("Op.Profile").Create("Macro", parentJob=opened.getObject("Job"))
    profile.ToolController = opened.getObject("Job").Tools.Group[0]
    opened.recompute()
    assert profile.Path.Size > 2 and profile.ViewObject.SwitchNode.getNumChildren() == 0
    window.click(SWITCH)
    window.wait(lambda: strategy_view.is_shown(opened))
    assert nodes(opened) == len(strategy_view._drawn[opened.Name]) >= 8
    profile.touch()
    opened.recompute()  # drawn anew while it is shown
    window.idle()
    window.click(SWITCH)
    window.wait(lambda: not strategy_view.is_shown(opened))
    assert nodes(opened) == 0
