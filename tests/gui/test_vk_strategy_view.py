# SPDX-License-Identifier: LGPL-2.1-or-later
"""*Show strategies* colours the toolpaths in the 3D view, changes no document, and leaves no nodes in the scene."""

import threading
import time

import FreeCAD
import FreeCADGui as Gui
import Path
import pytest
from make_example import cam
from pictures import counted
from PySide import QtCore, QtGui

from vkworkbench.core import Strategy, linearize, recognize
from vkworkbench.gui.qt import colors
from vkworkbench.gui.strategies import lines as strategy_lines
from vkworkbench.gui.strategies import view as strategy_view

SWITCH = "Show Strategies"


@pytest.fixture
def switched_on(opened, window):
    """The example seen from above, with coloured toolpaths."""
    Gui.activeView().viewTop()
    Gui.SendMsgToActiveView("ViewFit")
    window.settle()
    window.click(SWITCH)
    window.wait(lambda: drawn(opened))
    window.settle()
    yield opened
    if strategy_view.is_shown(opened):
        window.click(SWITCH)


def drawn(document):
    return strategy_view.is_shown(document) and not strategy_view.is_drawing()


def labelled(document, label):
    (obj,) = document.getObjectsByLabel(label)
    return obj


def seen(tmp_path):
    """Return {colour: number of pixels} of the 3D view."""
    return counted(picture(tmp_path))


def picture(tmp_path):
    path = str(tmp_path / "view.png")
    Gui.activeView().saveImage(path, 700, 600, "#ffffff")
    return QtGui.QImage(path)


def nodes(document):
    """Return the number of coloured toolpaths in the scene of the 3D view."""
    from pivy import coin

    search = coin.SoSearchAction()
    search.setName("VkStrategies")
    search.setInterest(coin.SoSearchAction.ALL)
    search.setSearchingAll(True)
    search.apply(Gui.getDocument(document.Name).ActiveView.getSceneGraph())
    return len(list(search.getPaths()))


def test_trajectories_have_the_colours_of_their_strategies():
    commands = [("G0", {"Z": 5.0}), ("G0", {"X": 0.0, "Y": 0.0}), ("G1", {"Z": -1.0})]
    for row in range(20):
        commands += [("G1", {"X": 60.0 * (row % 2 == 0)}), ("G1", {"Y": 2.0 * row + 2})]
    toolpath = linearize([*commands, ("G0", {"Z": 5.0})])
    spans = recognize(toolpath, tool_diameter=5).spans
    color = strategy_lines.colored(toolpath, spans)
    assert ((color == -1) == toolpath.rapid).all()
    assert (color == list(Strategy).index(Strategy.ZIGZAG)).sum() >= 39
    assert set(strategy_lines.colored(toolpath, ())) == {-1, list(Strategy).index(Strategy.UNKNOWN)}


def test_colours_are_visible_until_switched_off(opened, window, switched_on, tmp_path):
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


@pytest.fixture
def reopened(kept_document):
    """Open the example again, so that FreeCAD does not show the document as modified."""
    kept_document.close()


def test_document_is_not_changed(reopened, opened, window):
    before = [(obj.Name, obj.Label2, tuple(obj.PropertiesList), list(obj.State)) for obj in opened.Objects]
    undo = opened.UndoCount
    window.click(SWITCH)
    window.wait(lambda: drawn(opened))
    window.click(SWITCH)
    window.wait(lambda: not strategy_view.is_shown(opened))
    assert [(obj.Name, obj.Label2, tuple(obj.PropertiesList), list(obj.State)) for obj in opened.Objects] == before
    assert opened.UndoCount == undo and not Gui.getDocument(opened.Name).Modified


def test_hidden_and_deleted_operations_lose_their_colours(opened, window, switched_on, tmp_path):
    count = nodes(opened)
    assert count >= 8
    labelled(opened, "Adaptive pocket").ViewObject.Visibility = False
    window.settle()
    assert seen(tmp_path)[Strategy.ADAPTIVE.color] == 0
    labelled(opened, "Adaptive pocket").ViewObject.Visibility = True
    opened.removeObject(labelled(opened, "Adaptive pocket").Name)
    window.settle()
    assert nodes(opened) == count - 1


def test_selected_operation_has_wider_lines(opened, window, switched_on, tmp_path):
    color = Strategy.HELIX.color
    before = seen(tmp_path)[color]
    Gui.Selection.addSelection(labelled(opened, "Bore"))
    window.settle()
    window.screenshot("strategies-selected")
    assert seen(tmp_path)[color] > 1.3 * before > 0
    Gui.Selection.clearSelection()
    assert seen(tmp_path)[color] == before


def test_changed_toolpath_is_coloured_again(opened, window, switched_on):
    drill = labelled(opened, "Drill holes")
    before = strategy_view._shown[opened.Name].lines[drill.Name]
    opened.openTransaction("Depth")
    drill.setExpression("FinalDepth", None)
    drill.FinalDepth = drill.FinalDepth.Value + 1
    opened.recompute()
    opened.commitTransaction()
    window.wait(lambda: drawn(opened))
    after = strategy_view._shown[opened.Name].lines[drill.Name]
    assert after is not before
    window.settle()
    assert nodes(opened) == len(strategy_view._shown[opened.Name].lines)


@pytest.mark.long
def test_strategies_are_switched_on_for_each_document(opened, window, switched_on):
    assert window.button(SWITCH).isChecked()
    other = FreeCAD.newDocument("Other")
    window.wait(lambda: not window.button(SWITCH).isChecked())
    FreeCAD.closeDocument(other.Name)
    FreeCAD.setActiveDocument(opened.Name)
    window.wait(lambda: window.button(SWITCH).isChecked())


def test_document_without_toolpaths_shows_a_message(window):
    document = FreeCAD.newDocument("Empty")
    window.activate("VkWorkbench")
    window.click(SWITCH)
    window.wait(window.boxes)
    assert ["no toolpath to color" in text for text in window.dismiss()] == [True]
    assert not window.button(SWITCH).isChecked() and not strategy_view.is_shown(document)
    FreeCAD.closeDocument(document.Name)


def test_closed_document_is_removed_from_the_strategy_view(example_path, window):
    document = FreeCAD.openDocument(str(example_path))
    window.activate("VkWorkbench")
    name = document.Name
    window.click(SWITCH)
    window.wait(lambda: drawn(document))
    FreeCAD.closeDocument(name)
    window.settle()
    assert name not in strategy_view._shown


@pytest.mark.long
def test_operation_without_a_view_proxy_is_skipped(opened, window):
    """An operation made by a macro has no view proxy, so FreeCAD makes no node for the lines of its toolpath."""
    profile = cam("Op.Profile").Create("Macro", parentJob=opened.getObject("Job"))
    profile.ToolController = opened.getObject("Job").Tools.Group[0]
    opened.recompute()
    assert profile.Path.Size > 2 and profile.ViewObject.SwitchNode.getNumChildren() == 0
    window.click(SWITCH)
    window.wait(lambda: drawn(opened))
    assert nodes(opened) == len(strategy_view._shown[opened.Name].lines) >= 8
    profile.touch()
    opened.recompute()  # while strategies are shown, an operation is drawn again after each recompute
    window.wait(lambda: drawn(opened))
    window.click(SWITCH)
    window.wait(lambda: not strategy_view.is_shown(opened))
    assert nodes(opened) == 0


@pytest.mark.long
def test_rapids_from_the_origin_are_grey(opened, window, tmp_path):
    def red(there):
        # The colours in which FreeCAD draws rapids: the first before FreeCAD 1.1, the second since.
        return there["#aa0000"] + there["#e03131"]

    Gui.activeView().viewIsometric()
    Gui.SendMsgToActiveView("ViewFit")
    window.settle()
    assert red(seen(tmp_path)) > 100
    window.click(SWITCH)
    window.wait(lambda: drawn(opened))
    window.settle()
    there = seen(tmp_path)
    assert red(there) == 0 and there[colors.RAPID] > 100


@pytest.mark.long
def test_legend_has_the_visible_colours(opened, window, tmp_path):
    Gui.SendMsgToActiveView("ViewFit")
    window.click(SWITCH)
    window.wait(lambda: drawn(opened))
    found = legend_colors(tmp_path)
    for strategy in (Strategy.ZIGZAG, Strategy.ADAPTIVE, Strategy.HELIX):
        assert strategy.color in found, strategy
    assert colors.RAPID in found and Strategy.ENGRAVING.color not in found
    labelled(opened, "Adaptive pocket").ViewObject.Visibility = False
    opened.removeObject(labelled(opened, "Bore").Name)
    window.settle()
    found = legend_colors(tmp_path)
    assert not {Strategy.ADAPTIVE.color, Strategy.HELIX.color} & found and Strategy.ZIGZAG.color in found


def legend_colors(tmp_path):
    """Return the colours in the lower left corner of the 3D view, where the example has no toolpath."""
    return set(counted(picture(tmp_path).copy(0, 350, 60, 250)))


@pytest.mark.long
def test_legend_does_not_enlarge_the_scene(opened, window, switched_on):
    from pivy import coin

    def box_of(name):
        search = coin.SoSearchAction()
        search.setName(name)
        search.apply(Gui.activeView().getSceneGraph())
        box = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(700, 600))
        box.apply(search.getPath())
        return box.getBoundingBox()

    assert box_of("VkLegend").isEmpty() and not box_of("VkStrategies").isEmpty()


@pytest.fixture
def long(opened):
    """The example with 40,000 commands in each of five operations, which need more than one step of drawing."""
    lines = ["G0 Z30", "G0 X10 Y10", "G1 Z18 F10"]
    for number in range(40_000):
        row, step = divmod(number, 500)
        x = 10 + 0.2 * (step if row % 2 == 0 else 499 - step)
        lines.append(f"G1 X{x:.3f} Y{10 + 0.3 * row:.3f}")
    path = Path.Path("\n".join(lines))
    for obj in opened.getObject("Job").Operations.Group[:5]:
        obj.Path = path
    return opened


@pytest.mark.long
def test_events_are_handled_while_200_000_commands_are_drawn(long, window):
    beats, begin = [], time.monotonic()
    timer = QtCore.QTimer()
    timer.timeout.connect(lambda: beats.append(time.monotonic() - begin))
    timer.start(5)
    window.click(SWITCH)
    window.wait(lambda: beats and drawn(long))
    timer.stop()
    gaps = [b - a for a, b in zip([0.0, *beats], beats)]
    print(f"drawn after {beats[-1]:.2f} s, in which the window lived {len(beats)} times, the longest pause "
          f"{max(gaps):.3f} s")  # fmt: skip
    assert len(beats) > 12
    shown = strategy_view._shown[long.Name].lines
    assert {s for lines in shown.values() for s in lines.strategies} >= {Strategy.ZIGZAG, Strategy.DRILLING}
    window.click(SWITCH)


@pytest.mark.long
def test_cancelled_drawing_ends_its_thread(long, window, monkeypatch):
    def again_and_again(source, going_on):
        while True:  # draw without end, because a fast computer could finish one drawing before the click
            yield from strategy_lines.drawings(source, going_on)

    monkeypatch.setattr(strategy_view, "drawings", again_and_again)
    before = threading.active_count()
    window.click(SWITCH)
    window.wait(lambda: threading.active_count() > before)
    busy = strategy_view._drawer.busy
    window.wait(busy.isVisible)
    assert "operations left" in busy.label.text()
    window.screenshot("strategies-busy")
    window.click_on(busy.button)
    assert not strategy_view.is_shown(long) and not strategy_view.is_drawing() and not busy.isVisible()
    assert not window.button(SWITCH).isChecked() and nodes(long) == 0
    window.wait(lambda: threading.active_count() == before)
