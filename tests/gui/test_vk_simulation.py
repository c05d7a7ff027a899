# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulation in a tab of FreeCAD's window, as a person uses it: click, drag, play, ask."""

from __future__ import annotations

import FreeCAD
import FreeCADGui as Gui
import numpy as np
import pytest
from PySide import QtCore, QtGui
from simulation_window import COMMAND, drag, finest, shown, tabs, working

import vkworkbench
from vkworkbench.gui.simulation.drawing import Drawing
from vkworkbench.gui.simulation.faults import differences
from vkworkbench.gui.simulation.legend import Legend
from vkworkbench.gui.simulation.state_line import StateLine


@pytest.fixture
def simulated(opened, window, small):
    """The example's job, simulated by a click, at its finest."""
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    yield shown(tab, window)
    if tab.isVisible():
        window.press(tab, QtCore.Qt.Key_Escape)
        window.wait(lambda: not tabs(window))


def test_a_click_shows_the_part(simulated, window):
    window.screenshot("simulation-small")
    assert simulated.job.operations[0].label == "Face"
    view = simulated.view
    assert view.owner_at(view.rect().center()) is not None
    shown = view.grab().toImage()
    colors = {shown.pixel(x, y) for x in range(0, shown.width(), 7) for y in range(0, shown.height(), 7)}
    assert len(colors) > 50


def test_dragging_on_the_time_line_shows_any_moment_at_once_there_and_back(simulated, window):
    line, view = simulated.time_line, simulated.view
    part = view.grab().toImage()
    middle = line.height() - 20

    def at(share):
        return QtCore.QPoint(int(share * (line.width() - 1)), middle)

    drag(window, line, at(0.95), at(0.3))
    window.wait(lambda: not simulated._stale)
    assert simulated.moment.seconds == pytest.approx(0.3 * simulated.clock.total, rel=0.01)
    assert 0 < simulated.moment.done < simulated.simulation.trajectories
    window.screenshot("simulation-moment")
    early = view.grab().toImage()
    assert early != part
    window.press(line, QtCore.Qt.Key_End)
    window.wait(lambda: not simulated._stale)
    assert view.grab().toImage() == part


def test_steps_go_to_commands_and_operations(simulated, window):
    window.press(simulated.time_line, QtCore.Qt.Key_Home)
    first = [len(cut.toolpath) for cut in simulated.job.cuts]
    window.click_on(simulated.play_bar.steps[3])
    assert simulated.moment.done == first[0]
    window.click_on(simulated.play_bar.steps[1])
    assert simulated.moment.done == first[0] + 1
    window.click_on(simulated.play_bar.steps[3])
    assert simulated.moment.done == first[0] + first[1]
    window.click_on(simulated.play_bar.steps[-2])
    done = simulated.moment.done
    command = simulated.job.cuts[1].toolpath.command
    assert command[done - first[0]] != command[done - first[0] - 1]
    window.click_on(simulated.play_bar.steps[-3])
    assert simulated.moment.done == first[0]
    window.wait(lambda: not simulated._stale)
    assert simulated.job.operations[0].label in simulated.play_bar.text.text()


def test_a_play_shows_the_machines_time(simulated, window):
    simulated.play_bar.speeds.setCurrentIndex(3)  # a thousand times
    window.click_on(simulated.play_bar.play_button)
    window.wait(lambda: simulated.moment.seconds > 0.2 * simulated.clock.total, 60)
    window.click_on(simulated.play_bar.play_button)
    paused = simulated.moment.seconds
    window.idle(0.3)
    assert simulated.moment.seconds == paused < simulated.clock.total
    assert simulated.clock.ends[simulated.moment.done] <= paused <= simulated.clock.ends[simulated.moment.done + 1]


def test_the_part_tells_what_made_a_surface(simulated, window):
    simulated.look("Top")
    finest(simulated, window)
    view = simulated.view
    window.click_at(view, view.rect().center())
    window.idle()
    window.wait(simulated.isVisible)  # FreeCAD 1.1 brings the 3D view to the front
    (chosen,) = Gui.Selection.getSelection()
    operation, command = simulated.simulation.source(simulated.moment.done - 1)
    assert chosen.Name == operation.name
    window.wait(lambda: not simulated._stale)
    assert f"command {command + 1}: {chosen.Path.Commands[command].toGCode()}" in simulated.play_bar.text.text()
    assert view.owner_at(view.rect().center()) == simulated.moment.done - 1
    window.screenshot("simulation-asked")


def test_turning_moving_and_zooming_with_the_mouse(simulated, window):
    view = simulated.view
    before = view.view
    middle = view.rect().center()
    drag(window, view, middle, middle + QtCore.QPoint(90, 30))
    assert view.is_turned
    window.screenshot("simulation-turning")
    finest(simulated, window)
    assert not view.is_turned and not np.allclose(view.view.direction, before.direction)
    drag(window, view, middle, middle + QtCore.QPoint(50, 0), QtCore.Qt.MiddleButton)
    assert view.view.offset[0] == pytest.approx(-50 * view.view.pixel, rel=0.1)
    simulated.look("Top")
    assert view.view.offset == (0, 0)
    finest(simulated, window)


def test_colours_and_chips(simulated, window):
    pictures = set()
    for index in range(simulated.scene_bar.colorings.count()):
        simulated.scene_bar.colorings.setCurrentIndex(index)
        window.wait(lambda: not simulated._stale)
        pictures.add(bytes(simulated.view._scene.image.tobytes()))
        assert simulated.scene_bar.legend.entries
        window.screenshot(f"simulation-color-{index}")
    assert len(pictures) == simulated.scene_bar.colorings.count()
    simulated.moment.go_to(0.5 * simulated.clock.total)
    for index in (1, 2):
        simulated.scene_bar.chips.setCurrentIndex(index)
        window.wait(lambda: not simulated._stale)
        window.screenshot(f"simulation-chips-{index}")
        pictures.add(bytes(simulated.view._scene.image.tobytes()))
    assert len(pictures) == simulated.scene_bar.colorings.count() + 2


def test_differences_to_the_model_are_coloured_and_their_worst_places_shown(simulated, window):
    simulated.look("Top")
    finest(simulated, window)
    bar, view = simulated.scene_bar, simulated.view
    assert not bar.tolerance.isVisible() and not bar.worst.isVisible()
    bar.colorings.setCurrentIndex(bar.colorings.count() - 1)
    finest(simulated, window)
    assert bar.tolerance.isVisible() and bar.worst.isEnabled()
    window.screenshot("simulation-difference")
    kinds = [fault.what.code for fault in differences(simulated.drawing.told, bar.tolerance_mm)]
    assert kinds and set(kinds) == {"leaves-material"}  # the sound example leaves inside corners, and gouges nothing
    before = view.grab().toImage()
    bar.worst.menu().actions()[0].trigger()
    window.wait(lambda: not simulated._stale)
    assert simulated.moment.seconds == simulated.clock.total and view.grab().toImage() != before  # a ring is around it
    window.screenshot("simulation-worst")
    fine = len(bar.worst.menu().actions())
    bar.tolerance.setValue(2.0)
    window.wait(lambda: not simulated._stale)
    assert fine <= 20 and [fault.what.arguments["depth"] > 2 for fault in differences(simulated.drawing.told, 2.0)] == [
        True
    ] * len(bar.worst.menu().actions())
    simulated.moment.go_to(0.0)
    window.wait(lambda: not simulated._stale)
    assert view.grab().toImage() != before


def test_a_click_on_a_trajectory_in_the_time_line_lights_its_cut(simulated, window):
    line = simulated.time_line
    simulated.look("Top")
    finest(simulated, window)
    cuts = simulated.clock.cuts
    number = int(np.argmax(np.where(cuts.rapid, 0, np.diff(simulated.clock.ends) * (simulated.volumes > 0))))
    middle = (simulated.clock.ends[number] + simulated.clock.ends[number + 1]) / 2
    simulated.moment.go_to(middle)
    for _ in range(12):  # until it is wide enough to be hit
        wheel(line, QtCore.QPoint(round(line.x_of(middle)), line.height() - 8))
    simulated.play_bar.speeds.setCurrentIndex(0)  # real time
    simulated.moment.play()
    window.idle(0.2)
    assert simulated.moment.plays and simulated.moment.noticed is None
    where = QtCore.QPoint(round(line.x_of(middle)), line.height() - 8)
    window.click_at(line, where)
    window.wait(lambda: not simulated._stale)
    assert simulated.moment.noticed == number == simulated.moment.done - 1 and not simulated.moment.plays
    lit = (simulated.view._scene.image.astype(int) - simulated.view._scene.image.max(axis=-1, keepdims=True))[..., 2]
    assert (lit < -100).any()  # much less blue than red: the colour of what is lit
    assert "removes" in simulated.play_bar.text.text()
    window.screenshot("simulation-lit")


def wheel(widget, where):
    """Turn the wheel by a notch, away from the user."""
    place = QtCore.QPointF(where)
    event = QtGui.QWheelEvent(place, QtCore.QPointF(widget.mapToGlobal(where)), QtCore.QPoint(), QtCore.QPoint(0, 120),
                              QtCore.Qt.NoButton, QtCore.Qt.NoModifier, QtCore.Qt.NoScrollPhase, False)  # fmt: skip
    QtGui.QApplication.sendEvent(widget, event)


def test_it_is_read_on_light_and_dark_themes(opened, window, small, theme):
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    player = shown(tab, window)
    player.moment.go_to(0.4 * player.clock.total)
    window.wait(lambda: not player._stale)
    window.screenshot(f"simulation-{theme}")
    corners = [
        widget.grab().toImage().pixelColor(2, 2).lightness() for widget in (player.view, player.scene_bar, player)
    ]
    line = player.time_line.grab().toImage()
    beside = line.pixelColor(int(0.9 * line.width()), line.height() - 2).lightness()
    assert all((value < 100) == (theme == "dark") for value in (*corners, beside))
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))


def test_exports(simulated, window, tmp_path):
    from vkworkbench.gui.simulation import exports

    simulated.moment.go_to(0.4 * simulated.clock.total)
    exports.write_frames(simulated, tmp_path, 4)
    frames = sorted(tmp_path.glob("*.png"))
    assert [f.name for f in frames] == ["0000.png", "0001.png", "0002.png", "0003.png"]
    assert QtGui.QImage(str(frames[0])) != QtGui.QImage(str(frames[3])) and not QtGui.QImage(str(frames[1])).isNull()
    assert simulated.moment.seconds == pytest.approx(0.4 * simulated.clock.total)
    exports.write_rates(simulated, tmp_path / "rates.csv")
    lines = (tmp_path / "rates.csv").read_text().splitlines()
    assert len(lines) == 1 + simulated.simulation.trajectories and lines[1].startswith("Face,0,")


def test_it_says_that_a_toolpath_has_changed_and_simulates_it_again(simulated, opened, window):
    (before,) = tabs(window)
    face = opened.getObjectsByLabel("Face")[0]
    assert not before.again.isVisible()
    face.Path = type(face.Path)(face.Path.Commands[:-20])
    assert before.again.isVisible()
    window.click_on(before.again)
    window.wait(lambda: tabs(window) and tabs(window) != [before])
    (tab,) = tabs(window)
    assert len(shown(tab, window).job.cuts[0].toolpath) < len(simulated.job.cuts[0].toolpath)
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))


def test_closing_ends_the_work(opened, window):
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    window.wait(lambda: tab.player is not None and tab.player._work.works)
    assert "_run" in working()
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window) and "_run" not in working(), 5)


def test_closing_the_document_closes_the_tab(window, example_path):
    document = FreeCAD.openDocument(str(example_path))
    window.activate("VkWorkbench")
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    FreeCAD.closeDocument(document.Name)
    window.wait(lambda: not tabs(window))


CRASH = """(a slot that begins with a rapid move into the stock)
G0 Z30
G0 X40 Y50
G0 Z14
G1 X60 F300
G0 Z30"""


def make_crash(opened):
    """Make the job one operation that crashes and gouges; return it."""
    import Path

    job = opened.getObject("Job")
    op = opened.addObject("Path::FeaturePython", "Slot")
    op.addProperty("App::PropertyLink", "ToolController", "Path").ToolController = job.Tools.Group[1]
    op.addProperty("App::PropertyBool", "Active", "Path").Active = True
    op.Path = Path.Path([Path.Command(line) for line in CRASH.splitlines()])
    job.Operations.Group = [op]
    return op


def test_a_crash_is_found_in_three_clicks(opened, window):
    op = make_crash(opened)
    Gui.Selection.clearSelection()
    window.click(COMMAND)  # the first click
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    player = shown(tab, window)
    warnings = player.scene_bar.warnings
    assert warnings.isVisible()
    window.screenshot("crash-1")
    texts = []

    def choose():
        menu = warnings.menu()
        texts.extend(action.text() for action in menu.actions())
        window.screenshot("crash-2")
        window.click_at(menu, menu.actionGeometry(menu.actions()[0]).center())  # the third

    QtCore.QTimer.singleShot(300, choose)
    window.click_on(warnings)  # the second
    text, gouge = texts
    assert "command 5" in gouge and "into the model" in gouge
    assert (
        text.startswith("Slot, command 4 (G0") and "Z14" in text and "a rapid move removes 2" in text
    )  # 7.5 mm below 6 mm
    window.wait(lambda: not player._stale)
    assert player.simulation.source(player.moment.done - 1) == (player.job.operations[0], 3)
    assert "command 4: G0" in player.play_bar.text.text()
    window.screenshot("crash-3")
    (row,) = vkworkbench.analyze(op).operations
    assert [remark.code for remark in row.remarks if remark.code == "simulated"]
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))


def test_nothing_to_simulate_is_said(window):
    document = FreeCAD.newDocument()
    window.activate("VkWorkbench")
    window.click(COMMAND)
    window.wait(window.boxes)
    assert not tabs(window)
    assert window.dismiss()
    FreeCAD.closeDocument(document.Name)


def test_what_has_been_read_is_seen_before_all_is_read(opened, window, small, monkeypatch):
    monkeypatch.setattr("vkworkbench.gui.simulation.reading._SOON", 0.0)
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    window.wait(lambda: tab.player is not None)
    scene, _ = tab.reading.seen
    assert (scene.owner >= 0).any() and len(np.unique(scene.image)) > 20
    assert tab.player.view._scene is scene  # goes on being seen
    window.click_at(tab.player.view, tab.player.view.rect().center())  # which has no answer yet
    finest(shown(tab, window), window)
    assert tab.player.view._scene is not scene
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))


def test_the_cost_is_told_before_the_first_picture_and_what_it_was_after_the_last(opened, window, small, monkeypatch):
    told = []

    def expected(line, cost, original=StateLine.show_expected):
        original(line, cost)
        told.append((cost, line.text(), tabs(window)[0].player.simulation))

    monkeypatch.setattr(StateLine, "show_expected", expected)
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    player = shown(tab, window)
    (cost, text, simulation), *_ = told
    assert simulation is None and text.startswith("finest picture in about") and "MB" in text
    zbuffer = player.simulation.zbuffer
    assert cost.memory_bytes == pytest.approx(zbuffer.memory_bytes, rel=0.3)
    assert f"{zbuffer.traces:,} traces" in player.state.text() and "simulated in" in player.state.text()
    assert "about" not in player.state.text()
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))


def test_what_any_moment_needs_is_made_before_its_picture_is_shown(opened, window, small, monkeypatch):
    made = []

    def show(drawing, done, original=Drawing.take):
        made.append("_by_owner" in vars(done.simulation.zbuffer.surface))
        original(drawing, done)

    monkeypatch.setattr(Drawing, "take", show)
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    shown(tab, window)
    assert made and all(made)
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))


def test_an_operation_that_is_gone_while_the_job_is_copied_is_no_error(opened, window):
    window.click(COMMAND)
    (tab,) = tabs(window)
    opened.removeObject(opened.Job.Operations.Group[-1].Name)
    window.wait(tab.again.isVisible)
    window.idle(0.3)
    assert tab.player is None
    window.click_on(tab.again)
    window.wait(lambda: tabs(window) and tabs(window) != [tab])
    (tab,) = tabs(window)
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))


@pytest.mark.parametrize("width", [220, 420, 900])
def test_the_legend_is_whole_in_a_narrow_tab(simulated, window, width):
    bar = simulated.scene_bar
    window.main.resize(1024, 700)
    legend = Legend(window.main)
    for index in range(bar.colorings.count()):
        bar.colorings.setCurrentIndex(index)
        window.idle(0.1)
        entries = bar.legend.entries
        legend.show_entries(entries)
        legend.resize(width, legend.height())
        window.idle(0.05)
        places = legend._places()
        assert [color for color, *_ in places] == [color for color, _ in entries]
        inside = QtCore.QRectF(legend.rect()).adjusted(-1, -1, 1, 1)
        assert all(inside.contains(place) for _, place, _ in places), (index, legend.size())
        for number, (_, one, _) in enumerate(places):
            assert not any(one.adjusted(0.5, 0.5, -0.5, -0.5).intersects(other) for _, other, _ in places[:number])
    legend.deleteLater()


def test_no_gouge_is_forgotten_while_one_looks_from_where_it_is_not_seen(opened, window, small):
    op = make_crash(opened)

    def faults():
        (row,) = vkworkbench.analyze(op).operations
        return [remark.arguments["count"] for remark in row.remarks if remark.code == "simulated"]

    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    (tab,) = tabs(window)
    player = shown(tab, window)
    assert {fault.what.code for fault in player.faults} == {"rapid-cuts", "cuts-model"} and faults() == [2]
    judged = player.drawing.told
    player.look("Bottom")
    window.wait(lambda: player.drawing.told is not judged, 60)
    assert faults() == [2]  # a coarse picture does not look for gouges
    finest(player, window)
    assert player.drawing.told.judged and {fault.what.code for fault in player.faults} == {"rapid-cuts"}
    assert faults() == [2]  # it is there all the same
    window.press(tab, QtCore.Qt.Key_Escape)
    window.wait(lambda: not tabs(window))
