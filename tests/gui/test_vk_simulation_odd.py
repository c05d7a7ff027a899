# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulation tab when it is closed at any time, for odd jobs, in every navigation style and with keys only."""

from __future__ import annotations

import gc
import re
import weakref
from types import SimpleNamespace

import FreeCAD
import FreeCADGui as Gui
import numpy as np
import pytest
from cases import first_everywhere
from make_example import cam
from PySide import QtCore, QtGui
from simulation_window import COMMAND, drag, finest, make_small, shown, tabs, working

from vkworkbench.gui.simulation import part_view

MIDDLE, LEFT, RIGHT = QtCore.Qt.MiddleButton, QtCore.Qt.LeftButton, QtCore.Qt.RightButton


pytestmark = pytest.mark.usefixtures("nothing_swallowed")


@pytest.fixture
def bare(desk, window):
    """The example job without operations, for changes that are undone after the test."""
    with desk.changed(desk.bare) as document:
        yield document


def close(tab, window):
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window) and "_run" not in working())


PHASES = {
    "opened": lambda tab: True,
    "coarse": lambda tab: tab.player is not None and tab.player.simulation is not None,
    "read": lambda tab: tab.reading.seen is not None or tab.player is not None,
    "shown": lambda tab: tab.player is not None,
    "told": lambda tab: tab.player is not None and tab.player.drawing.findings is not None,
}


@pytest.mark.parametrize("phase", first_everywhere(PHASES, 2))
@pytest.mark.parametrize("how", ["key", "document"])
def test_tab_can_be_closed_in_every_phase(desk, window, monkeypatch, phase, how):
    monkeypatch.setattr("vkworkbench.gui.simulation.reading._FIRST", 0.0)
    document = desk.kept(desk.small)
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    window.wait(lambda: PHASES[phase](tab))
    if how == "key":
        window.press(tab, QtCore.Qt.Key_Escape)
    else:
        FreeCAD.closeDocument(document.Name)
    window.wait(lambda: not tabs(window) and "_run" not in working())
    window.idle(0.3)  # no event of the closed tab follows


def test_closed_tab_frees_its_memory(desk, window):
    desk.kept(desk.small)
    tab = desk.simulate()
    zbuffer = weakref.ref(shown(tab, window).simulation.zbuffer)
    close(tab, window)
    window.idle()
    gc.collect()
    assert zbuffer() is None


@pytest.mark.long
def test_closed_tab_returns_memory_to_the_system(desk, window, monkeypatch):
    desk.kept(desk.small)  # close the tab of an earlier test now, because its memory is also returned later
    given = []
    monkeypatch.setattr("vkworkbench.document.computer.garbage.give_back", lambda: given.append(True))
    tab = desk.simulate()
    shown(tab, window)
    assert given == []
    close(tab, window)
    window.wait(lambda: given == [True])


@pytest.mark.parametrize("moment", first_everywhere(["during", "before", "after"]))
def test_operation_is_deleted_while_the_tab_is_open(document, window, moment):
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    if moment != "before":
        make_small(tab, window)
        window.wait(lambda: tab.player.simulation is not None)
    if moment == "after":
        shown(tab, window)
    document.removeObject(document.Job.Operations.Group[0].Name)
    window.wait(tab.again.isVisible)
    player = tab.player
    if player is not None:  # the tab still shows the job that it read before the operation was deleted
        finest(player, window)
        player.moment.go_to(0.2 * player.clock.total)
        window.wait(lambda: player.pictures.is_current)
        player.ask(part_view.Surface(0, np.zeros(3)))  # click on a surface whose operation was deleted
        window.idle(0.2)
        player.look("Top")
        player.look(None)
        window.idle(0.3)
    close(tab, window)


@pytest.mark.parametrize("style", sorted(part_view._STYLES))
def test_every_navigation_style_turns_and_moves_the_part(desk, window, style):
    tab = desk.shared(desk.small, at_its_finest=False)
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/View")
    before = group.GetString("NavigationStyle")
    group.SetString("NavigationStyle", f"Gui::{style}NavigationStyle")
    try:
        buttons = {what: b for b, m, what in part_view._STYLES[style] if m == QtCore.Qt.NoModifier}
        none = QtCore.Qt.NoModifier
        assert part_view.action(LEFT, none) == part_view.TURN
        for b, m, what in part_view._STYLES[style]:
            assert part_view.action(b, m) == what
        view, middle = tab.player.view, tab.player.view.rect().center()
        for what, button in buttons.items():
            looked = view.view
            if button in (LEFT, MIDDLE, RIGHT):
                drag(window, view, middle, middle + QtCore.QPoint(60, 20), button)
                now = view.view
                assert (now.offset != looked.offset) == (what == part_view.PAN)
                assert np.allclose(now.direction, looked.direction) == (what == part_view.PAN)
    finally:
        group.SetString("NavigationStyle", before) if before else group.RemString("NavigationStyle")


def lone(document, commands, controller=1):
    """Give the job one operation with these commands; return the operation."""
    import Path

    job = document.Job
    op = document.addObject("Path::FeaturePython", "Odd")
    op.addProperty("App::PropertyLink", "ToolController", "Path")
    if controller is not None:
        op.ToolController = job.Tools.Group[controller]
    op.addProperty("App::PropertyBool", "Active", "Path").Active = True
    op.Path = Path.Path([Path.Command(line) for line in commands])
    job.Operations.Group = [op]
    Gui.Selection.clearSelection()
    return op


SLOT = ["G0 Z30", "G0 X40 Y50", "G1 Z15 F100", "G1 X60 F300", "G0 Z30"]


def empty(document):
    lone(document, [])


def only_comments(document):
    lone(document, ["(nothing)", "M3 S1000"])


def no_tool(document):
    lone(document, SLOT, None)


def no_stock(document):
    lone(document, SLOT)
    document.Job.Stock = None


@pytest.mark.parametrize("odd", first_everywhere([empty, only_comments, no_tool, no_stock], 2))
def test_job_without_a_simulation_shows_a_message(bare, window, odd):
    odd(bare)
    window.click(COMMAND)
    window.wait(window.boxes)
    (text,) = window.dismiss()
    assert len(text) > 20 and "Error" not in text and not tabs(window)


def test_user_chooses_one_of_several_jobs(document, window):
    other = cam("Main.Job").Create("Second", document.Job.Model.Group[0].Objects[:1])
    *others, last = document.Job.Operations.Group
    document.Job.Operations.Group, other.Operations.Group = others, [last]
    Gui.Selection.clearSelection()
    window.click(COMMAND)
    (box,) = (box for box in window.find(QtGui.QInputDialog) if box.isVisible())
    assert box.comboBoxItems() == [f"1. {document.Job.Label}", f"2. {other.Label}"] and not tabs(window)
    window.press(box, QtCore.Qt.Key_Escape)
    window.idle()
    assert not tabs(window) and not window.boxes()
    window.click(COMMAND)
    (box,) = (box for box in window.find(QtGui.QInputDialog) if box.isVisible())
    box.setTextValue(f"2. {other.Label}")
    window.press(box, QtCore.Qt.Key_Return)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    assert tab.copy.names == (last.Name,)


def no_model(document):
    lone(document, SLOT)
    document.Job.Model.Group = []


def one_move(document):
    lone(document, ["G1 X40 Y50 Z15 F100"])


def no_feed(document):
    lone(document, ["G0 Z30", "G0 X40 Y50", "G1 Z15", "G1 X60", "G0 Z30"])


def moves_without_length(document):
    lone(document, ["G1 X40 Y50 Z15 F100"] * 5)


def far_away(document):
    lone(document, ["G0 X1e6 Y1e6 Z30", "G1 Z-1e6 F100", "G1 X-1e6"])


def huge_tool(document):
    op = lone(document, SLOT)
    op.ToolController.Tool.Diameter = 5000.0


def tiny_tool(document):
    op = lone(document, SLOT)
    op.ToolController.Tool.Diameter = 1e-3


def tiny_stock(document):
    lone(document, SLOT)
    import Part

    stock = document.addObject("Part::FeaturePython", "Tiny")
    stock.Shape = Part.makeBox(1e-3, 1e-3, 1e-3)
    document.Job.Stock = stock


def flat_stock(document):
    lone(document, SLOT)
    import Part

    stock = document.addObject("Part::FeaturePython", "Flat")
    stock.Shape = Part.makeBox(1000, 1, 1e-2)
    document.Job.Stock = stock


def large_part(document):
    import Part

    lone(
        document,
        [f"G{0 if place == 0 else 1} X{place} Y{place % 20000} Z-200 F3000" for place in range(0, 60_000, 500)],
    )
    stock = document.addObject("Part::FeaturePython", "Large")
    stock.Shape = Part.makeBox(60_000, 20_000, 3000)
    document.Job.Stock = stock
    document.Job.Model.Group = []


def small_part(document):
    import Part

    lone(
        document, ["G0 Z1", "G1 Z0.15 F10", *(f"G1 X{0.004 * (row % 2)} Y{0.0001 * row}" for row in range(30)), "G0 Z1"]
    )
    document.Job.Operations.Group[0].ToolController.Tool.Diameter = 1e-3
    stock = document.addObject("Part::FeaturePython", "Small")
    stock.Shape = Part.makeBox(0.005, 0.003, 0.2)
    document.Job.Stock = stock


def only_drilling(document):
    lone(document, ["G0 Z30", *(f"G81 X{x} Y{y} Z5 R26 F200" for x in (20, 60, 90) for y in (20, 40)), "G80"], 2)


def all_crashes(document):
    lone(document, [f"G0 X{10 + 100 * (row % 2)} Y{5 + 0.6 * row} Z{23 - 0.06 * row}" for row in range(100)])


def many_operations(document):
    import Path

    first, job = lone(document, SLOT), document.Job
    rows = []
    for row in range(40):  # more operations than a menu or the legend shows
        op = document.addObject("Path::FeaturePython", f"Row{row}")
        op.addProperty("App::PropertyLink", "ToolController", "Path").ToolController = first.ToolController
        op.addProperty("App::PropertyBool", "Active", "Path").Active = True
        op.Path = Path.Path(
            [Path.Command(line) for line in ("G0 Z30", f"G0 X5 Y{2 * row}", "G1 Z20 F100", "G1 X150", "G0 Z30")]
        )
        rows.append(op)
    job.Operations.Group = rows


# Unusual moves and sizes affect only the package's own simulation, so only an unusual model is tested on every FreeCAD.
ODD_JOBS = [no_model, many_operations, one_move, no_feed, tiny_stock, flat_stock, large_part, small_part, only_drilling,
            all_crashes, moves_without_length, far_away, huge_tool, tiny_tool]  # fmt: skip


@pytest.mark.parametrize("odd", first_everywhere(ODD_JOBS))
def test_odd_job_is_shown_without_an_error(bare, window, odd, monkeypatch):
    # Check the job in an image of 800 pixels; the finest image that the budgets allow takes seconds.
    monkeypatch.setattr(
        "vkworkbench.core.zbuffer.cost.axis_view.best_resolution",
        lambda estimates, **budgets: SimpleNamespace(view=estimates[0].view),
    )
    odd(bare)
    window.click(COMMAND)
    window.wait(lambda: tabs(window) or window.boxes())
    if not tabs(window):
        (text,) = window.dismiss()
        assert len(text) > 20 and "Error" not in text
        return
    (tab,) = tabs(window)
    make_small(tab, window)
    if tab.player is None:
        (text,) = window.dismiss()
        assert len(text) > 20 and "Error" not in text
        return
    finest(tab.player, window)
    assert "Error" not in tab.player.state.text()
    player = tab.player
    assert player.play_bar.text.text().startswith("about") == (not player.clock.complete)
    assert not player.clock.complete or odd is not no_feed
    for index in range(player.scene_bar.colorings.count()):
        player.scene_bar.colorings.setCurrentIndex(index)
        window.idle(0.05)
    finest(player, window)
    for index in (1, 2, 0):
        player.scene_bar.chips.setCurrentIndex(index)
        window.idle(0.05)
    for by in (1, 2, 3, -1, -2, -3):
        window.click_on(player.play_bar.steps[by])
    player.moment.play()
    window.idle(0.2)
    player.moment.play()
    for key in (QtCore.Qt.Key_Home, QtCore.Qt.Key_Right, QtCore.Qt.Key_PageUp, QtCore.Qt.Key_End):
        window.press(player.time_line, key)
    middle = player.view.rect().center()
    drag(window, player.view, middle, middle + QtCore.QPoint(50, 20))
    drag(window, player.time_line, QtCore.QPoint(10, 45), QtCore.QPoint(200, 45))
    window.click_at(player.time_line, QtCore.QPoint(100, 45))
    window.wait(lambda: player.pictures.is_current)  # wait for the picture of the view that the mouse has changed
    player.look("Bottom")
    finest(player, window)
    window.screenshot(f"simulation-odd-{odd.__name__}")
    window.click_at(player.view, middle)
    window.idle(0.2)
    close(tab, window)


@pytest.mark.parametrize("how", first_everywhere(["document", "key"]))
def test_tab_is_closed_while_it_plays(desk, window, how):
    document = desk.kept(desk.small)
    tab = desk.simulate()
    window.wait(lambda: tab.player.simulation is not None)
    tab.player.moment.play()
    window.wait(lambda: tab.player.moment.seconds > 0.02 * tab.player.clock.total)
    if how == "key":
        window.press(tab, QtCore.Qt.Key_Escape)
    else:
        FreeCAD.closeDocument(document.Name)
    window.wait(lambda: not tabs(window) and "_run" not in working())
    window.idle(0.3)  # no event of the closed tab follows


def test_simulation_shows_no_millimetres_in_an_inch_schema(desk, bare, window):
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units")
    before = group.GetInt("UserSchema", 0)
    lone(bare, ["G0 Z30", "G0 X40 Y50", "G0 Z14", "G1 X60 F5", "G1 Z5 F50", "G0 Z30"])
    set_schema = getattr(FreeCAD.Units, "setSchema", None)
    group.SetInt("UserSchema", 3)  # imperial decimal
    if set_schema:
        set_schema(3)
    try:
        tab = desk.simulate()
        player = shown(tab, window)
        player.scene_bar.colorings.setCurrentIndex(4)
        player.point(player.faults[0])
        finest(player, window)
        window.screenshot("simulation-inches")
        read = [action.text() for action in player.scene_bar.warnings.menu().actions()]
        read += [player.play_bar.text.text(), player.state.text(), player.scene_bar.tolerance.suffix()]
        read += [name for _, name in player.scene_bar.legend.entries]
        assert (
            len(read) > 8
            and not [text for text in read if re.search(r"\bmm\b|mm³", text)]
            and any("in³" in text for text in read)
        )
        close(tab, window)
    finally:
        group.SetInt("UserSchema", before)
        if set_schema:
            set_schema(before)


@pytest.mark.long
def test_tab_is_usable_with_keys_only(desk, window):
    desk.kept(desk.small)
    window.main.setFocus()
    tab = desk.simulate()
    player = shown(tab, window)
    reached = set()
    for _ in range(40):
        focused = QtGui.QApplication.focusWidget()
        if focused is not None:
            reached.add(focused)
            # The keyboard focus begins on the time line, which is the last control, so go through the controls
            # backwards.
            window.press(focused, QtCore.Qt.Key_Backtab)
        window.idle(0.01)
    wanted = {player.time_line, player.view, player.scene_bar.colorings, player.scene_bar.chips, player.play_bar.speeds}
    assert wanted <= reached
    player.view.setFocus()
    window.press(QtGui.QApplication.focusWidget(), QtCore.Qt.Key_Space)
    window.idle(0.2)
    assert player.moment.plays
    window.press(QtGui.QApplication.focusWidget(), QtCore.Qt.Key_Space)
    done = player.moment.done
    window.press(player.view, QtCore.Qt.Key_Comma)
    assert not player.moment.plays and player.moment.done == max(done - 1, 0)
    close(tab, window)
