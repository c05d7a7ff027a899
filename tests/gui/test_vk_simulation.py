# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulation tab as a user works with it: click, drag, play, and find the cut that made a surface."""

from __future__ import annotations

import threading
from dataclasses import replace
from itertools import product
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui
import Mesh
import numpy as np
import pytest
from cases import first_everywhere
from pictures import pixels
from PySide import QtCore, QtGui
from simulation_window import COMMAND, close, drag, finest, shown, tabs, working

import vkworkbench
from vkworkbench.core import linearize
from vkworkbench.document.marks import marks
from vkworkbench.document.simulation.simulate import simulate_read
from vkworkbench.gui.qt.plain_text import OneLine
from vkworkbench.gui.qt.sentences import user
from vkworkbench.gui.simulation import controls, exports, simulating
from vkworkbench.gui.simulation import player as playing
from vkworkbench.gui.simulation.faults import differences
from vkworkbench.gui.simulation.pictures import SMOOTH, Drawing, Picture
from vkworkbench.gui.simulation.widgets import Legend, StateLine


@pytest.fixture
def whole(desk, window):
    """The player with the finest picture of the whole example; other tests may have used it."""
    return desk.shared(desk.example).player


@pytest.fixture
def whole_from_above(desk, window):
    """A player of the whole example, seen from above."""
    return desk.shared(desk.example, "Top").player


@pytest.fixture
def simulated(desk, window):
    """A small player with the finest picture of four operations; other tests may have used it."""
    return desk.shared(desk.small).player


# Tests with the whole example


def test_click_shows_the_simulated_part(whole, window):
    window.screenshot("simulation-small")
    assert whole.job.operations[0].label == "Face"
    view = whole.view
    assert view.surface_at(view.rect().center()) is not None
    assert len(np.unique(pixels(view.grab().toImage())[::4, ::4].reshape(-1, 4), axis=0)) > 50


def test_dragging_on_the_time_line_changes_the_shown_time(whole, window):
    line, view = whole.time_line, whole.view
    part = view.grab().toImage()
    middle = line.height() - 20

    def at(share):
        return QtCore.QPoint(int(share * (line.width() - 1)), middle)

    drag(window, line, at(0.95), at(0.3))
    window.wait(lambda: whole.pictures.is_current)
    assert whole.moment.seconds == pytest.approx(0.3 * whole.clock.total, rel=0.01)
    assert 0 < whole.moment.done < whole.simulation.trajectories
    window.screenshot("simulation-moment")
    early = view.grab().toImage()
    assert early != part
    window.press(line, QtCore.Qt.Key_End)
    window.wait(lambda: whole.pictures.is_current)
    assert view.grab().toImage() == part


def test_exports_save_pictures_and_removal_rates(whole, window, tmp_path):
    (save,) = [button for button in whole.findChildren(QtGui.QToolButton) if button.text() == "Save"]
    QtCore.QTimer.singleShot(300, lambda: (window.screenshot("simulation-save"), save.menu().close()))
    window.click_on(save)
    whole.moment.go_to(0.4 * whole.clock.total)
    exports.write_frames(whole, tmp_path, 4, lambda _: True)
    frames = sorted(tmp_path.glob("*.png"))
    assert [f.name for f in frames] == ["0000.png", "0001.png", "0002.png", "0003.png"]
    assert QtGui.QImage(str(frames[0])) != QtGui.QImage(str(frames[3])) and not QtGui.QImage(str(frames[1])).isNull()
    assert whole.moment.seconds == pytest.approx(0.4 * whole.clock.total)
    exports.write_rates(whole, tmp_path / "rates.csv")
    lines = (tmp_path / "rates.csv").read_text().splitlines()
    assert len(lines) == 1 + whole.simulation.trajectories and lines[1].startswith("Face,1,")
    first = whole.job.cuts[0].toolpath.command[0]
    assert lines[1].split(",")[2] == str(first + 1)  # commands are numbered from 1, as in the text below the part


def test_chips_are_drawn_on_the_simulated_part(whole, window):
    whole.moment.go_to(0.5 * whole.clock.total)
    whole.scene_bar.colorings.setCurrentIndex(4)
    finest(whole, window)
    part = whole.view._scene.image
    whole.scene_bar.chips.setCurrentIndex(2)
    window.wait(lambda: whole.pictures.is_current)
    window.screenshot("simulation-chips-2")
    assert (whole.view._scene.image != part).any()


def test_mouse_turns_moves_and_zooms_the_part(whole, window):
    view = whole.view
    before = view.view
    middle = view.rect().center()
    drag(window, view, middle, middle + QtCore.QPoint(90, 30))
    assert not np.allclose(view.view.direction, before.direction)
    finest(whole, window)
    window.screenshot("simulation-turned")
    drag(window, view, middle, middle + QtCore.QPoint(50, 0), QtCore.Qt.MiddleButton)
    assert view.view.offset[0] == pytest.approx(-50 * view.view.pixel * view.devicePixelRatioF(), rel=0.1)
    whole.look("Top")
    assert view.view.offset == (0, 0)
    finest(whole, window)


def test_click_on_a_surface_selects_its_operation(whole_from_above, window):
    player = whole_from_above
    view = player.view
    # Before FreeCAD 1.1 forwards a click, it checks the position of the pointer instead of the position of the event.
    QtGui.QCursor.setPos(view.mapToGlobal(view.rect().center()))
    window.click_at(view, view.rect().center())
    window.idle()
    window.idle(1.0)  # s; a quarter of a second after a selection, FreeCAD 1.1 brings its 3D view to the front
    window.wait(lambda: not player.visibleRegion().isEmpty())
    (chosen,) = Gui.Selection.getSelection()
    operation, command = player.simulation.source(player.moment.done - 1)
    assert chosen.Name == operation.name
    window.wait(lambda: player.pictures.is_current)
    assert f"command {command + 1}: {code_of(chosen, command)}" in player.play_bar.text.text()
    assert view.surface_at(view.rect().center()).owner == player.moment.done - 1
    window.screenshot("simulation-asked")


def code_of(op, command):
    """Return the G-code of a command, rounded to micrometres."""
    command = op.Path.Commands[command]
    words = {letter: 60 * value if letter == "F" else value for letter, value in command.Parameters.items()}
    return " ".join([command.Name, *(f"{letter}{round(value, 3) + 0.0:.10g}" for letter, value in words.items())])


def test_differences_to_the_model_have_colours_and_places(whole_from_above, window):
    player = whole_from_above
    bar, view = player.scene_bar, player.view
    assert not bar.tolerance.isVisible() and not bar.worst.isVisible()
    bar.colorings.setCurrentIndex(bar.colorings.count() - 1)
    finest(player, window)
    assert bar.tolerance.isVisible() and bar.worst.isEnabled()
    window.screenshot("simulation-difference")
    kinds = [fault.what.code for fault in differences(player.drawing.findings, bar.tolerance_mm)]
    # The correct example leaves material in inside corners, and gouges nothing.
    assert kinds and set(kinds) == {"leaves-material"}
    found = differences(player.drawing.findings, bar.tolerance_mm)
    deepest = max(found, key=lambda fault: fault.what.arguments["depth"])
    # Two clicks of the user are enough to show the largest difference.
    assert player.play_bar.text.text() == player.known.text_with_place(deepest)
    assert view._place_shown == deepest.place
    before = view.grab().toImage()
    bar.worst.menu().actions()[-1].hover()
    # An entry under the mouse pointer shows a ring on the part before it is clicked.
    assert len(found) > 1 and view.grab().toImage() != before
    bar.worst.menu().actions()[0].trigger()
    window.wait(lambda: player.pictures.is_current)
    assert player.moment.seconds == player.clock.total and view._place_shown == found[0].place
    window.screenshot("simulation-worst")
    fine = len(bar.worst.menu().actions())
    bar.tolerance.setValue(2.0)
    window.wait(lambda: player.pictures.is_current and not player.is_busy)
    assert fine <= 20 and [
        fault.what.arguments["depth"] > 2 for fault in differences(player.drawing.findings, 2.0)
    ] == [True] * len(bar.worst.menu().actions())
    player.moment.go_to(0.0)
    window.wait(lambda: player.pictures.is_current)
    assert view.grab().toImage() != before


def test_click_in_the_time_line_highlights_the_cut(whole_from_above, window):
    player = whole_from_above
    line = player.time_line
    cuts = player.clock.cuts
    number = int(np.argmax(np.where(cuts.rapid, 0, np.diff(player.clock.ends) * (player.volumes > 0))))
    middle = (player.clock.ends[number] + player.clock.ends[number + 1]) / 2
    player.moment.go_to(middle)
    for _ in range(12):  # zoom in until the move is wide enough on the time line for a click
        window.wheel(line, QtCore.QPoint(round(line.x_of(middle)), line.height() - 8))
    player.play_bar.speeds.setCurrentIndex(0)  # play at the speed of the machine
    player.moment.play()
    window.idle(0.2)
    assert player.moment.plays and player.moment.noticed is None
    where = QtCore.QPoint(round(line.x_of(middle)), line.height() - 8)
    window.click_at(line, where)
    window.wait(lambda: player.pictures.is_current)
    assert player.moment.noticed == number == player.moment.done - 1 and not player.moment.plays
    lit = (player.view._scene.image.astype(int) - player.view._scene.image.max(axis=-1, keepdims=True))[..., 2]
    assert (lit < -100).any()  # the highlighted cut has a colour with much less blue than red
    assert "Removed: " in player.play_bar.text.text()
    window.screenshot("simulation-lit")


def forget_a_retract(op):
    """Replace a pocket's longest retract by a rapid at cutting depth; return the command's index and G-code."""
    import Path

    commands = op.Path.Commands
    toolpath = linearize(commands)
    across = np.hypot(*np.diff(toolpath.points, axis=0)[:, :2].T) * toolpath.rapid * (toolpath.command > 5)
    longest = int(np.argmax(across))
    number, (x, y, _), (*_, depth) = (
        toolpath.command[longest],
        toolpath.points[longest + 1],
        toolpath.points[longest - 1],
    )
    rapid = Path.Command("G0", {"X": x, "Y": y, "Z": depth})
    op.Path = Path.Path([*commands[: number - 1], rapid, *commands[number + 1 :]])
    return number - 1, code_of(op, number - 1)


def test_crash_is_found_in_three_clicks(desk, window):
    document = desk.open(desk.example)
    op = document.getObjectsByLabel("Pocket around island")[0]
    number, code = forget_a_retract(op)
    player = shown(desk.simulate(), window)
    warnings = player.scene_bar.warnings
    assert warnings.isVisible()
    window.screenshot("simulation-crash-1")
    texts = []

    def choose():
        menu = warnings.menu()
        texts.extend(action.text() for action in menu.actions())
        window.screenshot("simulation-crash-2")
        window.click_at(menu, menu.actionGeometry(menu.actions()[0]).center())  # second click: choose the crash

    QtCore.QTimer.singleShot(300, choose)
    window.click_on(warnings)  # first click: open the menu of warnings
    assert texts[0].startswith(f"Pocket around island, command {number + 1} ({code}): A rapid move removes ")
    window.wait(lambda: player.pictures.is_current)
    source = player.simulation.source(player.moment.done - 1)
    assert source == (player.job.operations[2], number)
    assert f"command {number + 1}: {code}" in player.play_bar.text.text()
    _, fault = texts[0].split("): ")
    assert player.play_bar.text.text().endswith(fault)  # the text under the part and the warning have the same volume
    window.screenshot("simulation-crash-3")
    assert [chosen.Name for chosen in Gui.Selection.getSelection()] == [op.Name]
    window.wait(lambda: player.known._holds)  # wait until the document was compared with the simulated job
    (row,) = vkworkbench.analyze(op).operations
    assert [remark.code for remark in row.remarks if remark.code == "simulated"]
    close(window)
    Gui.Selection.clearSelection()
    window.analyze(document)
    window.dismiss()
    verdict = marks.read(document.getObject("Job")).verdict
    assert str(verdict).startswith("1 rapid cuts into material.") and not verdict.is_sound
    panel = window.show_results()
    Gui.Selection.addSelection(op)
    window.idle(0.5)
    window.screenshot("simulation-results")
    panel.hide()


# Tests that share one tab with four operations


def test_shown_part_is_saved_and_added_as_a_mesh(simulated, window, tmp_path):
    menu = next(b for b in simulated.findChildren(QtGui.QToolButton) if b.text() == "Save").menu()
    entries = {action.text(): action for action in menu.actions()}
    path = tmp_path / "part.stl"
    window.answer_file_dialog(path, entries["Shown Part as STL…"].trigger)
    simulated.moment.go_to(0.5 * simulated.clock.total)
    entries["Shown Part as Mesh in the Document"].trigger()
    document = FreeCAD.getDocument(simulated.job.operations[0].document)
    added = document.Objects[-1].Mesh
    finished = Mesh.Mesh(str(path))
    removed = simulated.volumes[simulated.moment.done :].sum()
    assert added.isSolid() and finished.isSolid()
    assert added.Volume - finished.Volume == pytest.approx(removed, rel=0.01)
    document.undo()
    assert not [obj for obj in document.Objects if obj.TypeId == "Mesh::Feature"]


def test_step_buttons_go_to_commands_and_operations(simulated, window):
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
    window.wait(lambda: simulated.pictures.is_current)
    assert simulated.job.operations[0].label in simulated.play_bar.text.text()
    assert simulated.clock.complete and simulated.play_bar.text.text()[0].isdigit()


def test_play_shows_the_machines_time(simulated, window):
    simulated.play_bar.speeds.setCurrentIndex(2)  # play at 100 times the speed of the machine
    window.click_on(simulated.play_bar.play_button)
    window.wait(lambda: simulated.moment.seconds > 0.2 * simulated.clock.total)
    window.click_on(simulated.play_bar.play_button)
    paused = simulated.moment.seconds
    window.idle(0.3)
    assert simulated.moment.seconds == paused < simulated.clock.total
    assert simulated.clock.ends[simulated.moment.done] <= paused <= simulated.clock.ends[simulated.moment.done + 1]


def test_colourings_and_chips_change_the_picture(simulated, window):
    pictures = set()
    for index in range(simulated.scene_bar.colorings.count()):
        simulated.scene_bar.colorings.setCurrentIndex(index)
        finest(simulated, window)
        pictures.add(bytes(simulated.view._scene.image.tobytes()))
        assert simulated.scene_bar.legend.entries
        window.screenshot(f"simulation-color-{index}")
    assert len(pictures) == simulated.scene_bar.colorings.count()
    simulated.moment.go_to(0.5 * simulated.clock.total)
    simulated.scene_bar.colorings.setCurrentIndex(4)
    finest(simulated, window)
    for index in (1, 2):
        simulated.scene_bar.chips.setCurrentIndex(index)
        window.wait(lambda: simulated.pictures.is_current)
        pictures.add(bytes(simulated.view._scene.image.tobytes()))
    assert len(pictures) == simulated.scene_bar.colorings.count() + 2


def test_tab_and_marks_show_the_same_machining_times(simulated, desk, monkeypatch):
    report = vkworkbench.analyze(desk.document)
    clock = user().clock
    for block, operation in zip(simulated.time_line._blocks, report.operations):
        assert block.tooltip.endswith(", " + clock(operation.machining_seconds))
    whole = clock(sum(operation.machining_seconds for operation in report.operations))
    assert simulated._moment_text().startswith(f"{whole} of {whole} ")
    monkeypatch.setattr(playing.Clock, "total", 119.6)  # s, rounded as in a mark
    simulated.moment.seconds = 119.6
    assert simulated._moment_text().startswith("2:00 of 2:00 ")


def test_time_line_explains_its_colours(simulated, window):
    line = simulated.time_line
    # Y positions of the pointer: over the curve, then over the operations.
    for y, expected in (
        (6, True),
        (line.height() - 14, False),
    ):
        QtGui.QToolTip.hideText()
        window.mouse_move(line, QtCore.QPoint(line.width() // 2, y), QtCore.Qt.NoButton)
        window.wait(QtGui.QToolTip.isVisible)
        assert ("Orange: cuts air." in QtGui.QToolTip.text()) == expected
    QtGui.QToolTip.hideText()


def test_legend_calls_the_model_missing_only_after_last_picture(simulated):
    drawing = simulated.drawing
    simulated.scene_bar.colorings.setCurrentIndex(simulated.scene_bar.colorings.count() - 1)
    said, simulated_ = [], drawing.simulated
    for is_finest in (False, True):
        drawing.simulated = replace(simulated_, seen=None, is_finest=is_finest)
        drawing.color()
        said.append(drawing._coloring().legend()[0][1])
    drawing.simulated = simulated_
    assert said == ["The model is shown with the finest picture.", "There is no closed model."]


def test_default_folder_of_exports_is_the_documents_folder(simulated, desk, tmp_path, monkeypatch):
    asked = []

    def choose(parent, title, path, forms):
        asked.append(path)
        return str(tmp_path / "chosen"), forms

    monkeypatch.setattr(exports.QFileDialog, "getSaveFileName", choose)
    exports.save_picture(simulated)
    exports.save_rates(simulated)
    beside = Path(desk.document.FileName).parent
    assert asked == [str(beside / f"{desk.document.Name}.png"), str(beside / f"{desk.document.Name}.csv")]
    assert (tmp_path / "chosen.png").exists() and (tmp_path / "chosen.csv").exists()


def test_events_do_not_wait_for_pictures_or_faults(simulated, window, monkeypatch):
    going_on = threading.Event()

    def waiting(original):
        def held(*arguments):
            assert going_on.wait(60) and threading.current_thread() is not threading.main_thread()
            return original(*arguments)

        return held

    monkeypatch.setattr(Picture, "draw", waiting(Picture.draw))
    monkeypatch.setattr(playing, "judge", waiting(playing.judge))
    before, total = simulated.view._scene, simulated.clock.total
    simulated.scene_bar.colorings.setCurrentIndex(4)
    for share in (0.2, 0.4, 0.3):
        simulated.moment.go_to(share * total)
        window.idle(0.1)
    assert simulated.view._scene is before and simulated.is_busy and not simulated.pictures.is_current
    going_on.set()
    window.wait(lambda: simulated.pictures.is_current and not simulated.is_busy)
    monkeypatch.undo()
    picture = simulated.drawing.picture(simulated.moment, simulated.view.frame, simulated.view.background)
    expected = picture.draw(SMOOTH).scene
    assert (simulated.view._scene.image == expected.image).all() and simulated.moment.seconds == 0.3 * total


def test_error_in_a_picture_is_shown_and_the_next_is_drawn(simulated, window, monkeypatch):
    with monkeypatch.context() as broken:
        broken.setattr(Picture, "draw", lambda picture: 1 / 0)
        simulated.moment.go_to(0.5 * simulated.clock.total)
        window.wait(lambda: simulated.pictures.is_current)
        assert "ZeroDivisionError" in simulated.state.text()
    simulated.moment.go_to(0.0)
    window.wait(lambda: simulated.pictures.is_current)
    assert simulated.view._scene.owner.max() == -1


def test_legend_is_complete_in_a_narrow_tab(simulated, window):
    bar = simulated.scene_bar
    legend = Legend(window.main)
    legends = [(("#808080", "The model is shown with the finest picture. "[:length] * 5),) for length in range(1, 41)]
    for index in range(bar.colorings.count()):
        bar.colorings.setCurrentIndex(index)
        window.wait(lambda: simulated.pictures.is_current)
        legends.append(bar.legend.entries)
    for width, entries in product((220, 420, 900), legends):
        legend.show_entries(entries)
        legend.resize(width, legend.height())
        window.idle(0.01)
        places = legend._places()
        assert [color for color, *_ in places] == [color for color, _ in entries]
        inside = QtCore.QRectF(legend.rect()).adjusted(-1, -1, 1, 1)
        assert all(inside.contains(place) for _, place, _ in places), (entries, legend.size())
        for number, (_, one, _) in enumerate(places):
            assert not any(one.adjusted(0.5, 0.5, -0.5, -0.5).intersects(other) for _, other, _ in places[:number])
        for (_, name), (_, one, _), (_, after, _) in zip(entries, places, places[1:]):
            # The colours of one scale are side by side.
            assert name or (one.right(), one.top()) == (after.left(), after.top())
    legend.deleteLater()


# Tests that open their own tabs and documents


def test_tab_is_readable_on_light_and_dark_themes(desk, window, theme):
    desk.kept(desk.small)
    player = shown(desk.simulate(), window)
    player.moment.go_to(0.4 * player.clock.total)
    window.wait(lambda: player.pictures.is_current)
    window.screenshot(f"simulation-{theme}")
    corners = [
        widget.grab().toImage().pixelColor(2, 2).lightness() for widget in (player.view, player.scene_bar, player)
    ]
    for button in (player.play_bar.play_button, *player.play_bar.steps.values()):
        shown_of = button.grab().toImage()
        light = [shown_of.pixelColor(x, shown_of.height() // 2).lightness() for x in range(4, shown_of.width() - 4)]
        assert max(light) - min(light) > 90  # the button's symbol contrasts with the button
    line = player.time_line.grab().toImage()
    beside = line.pixelColor(int(0.9 * line.width()), line.height() - 2).lightness()
    assert all((value < 100) == (theme == "dark") for value in (*corners, beside))
    close(window)


def test_changed_toolpath_is_shown_and_simulated_again(desk, document, window):
    before = desk.simulate()
    length = len(shown(before, window).job.cuts[0].toolpath)
    face = document.getObjectsByLabel("Face")[0]
    assert not before.again.isVisible()
    face.Path = type(face.Path)(face.Path.Commands[:-20])
    window.wait(before.again.isVisible)
    window.click_on(before.again)
    window.wait(lambda: tabs(window) and tabs(window) != [before])
    (tab,) = tabs(window)
    assert len(shown(tab, window).job.cuts[0].toolpath) < length


def test_closing_the_tab_ends_its_work(desk, window, monkeypatch):
    begun = []

    def endless(*arguments):
        while True:
            begun.append(arguments)
            simulate_read(*arguments)

    monkeypatch.setattr(simulating, "simulate_read", endless)
    desk.kept(desk.small)
    tab = desk.simulate()
    window.wait(lambda: tab.player._work.works and "endless" in working())
    window.press(tab, QtCore.Qt.Key_Escape)
    until_closed = len(begun)
    window.wait(lambda: not tabs(window) and "_run" not in working())
    assert len(begun) <= until_closed + 1  # at most one step of the work begins after closing the tab


def test_closing_the_document_closes_the_tab(desk, document, window):
    window.click(COMMAND)
    window.wait(lambda: tabs(window))
    FreeCAD.closeDocument(document.Name)
    window.wait(lambda: not tabs(window))


def test_job_with_nothing_to_simulate_shows_a_message(desk, window):
    desk.close()
    window.activate("VkWorkbench")
    document = FreeCAD.newDocument()
    window.click(COMMAND)
    window.wait(window.boxes)
    assert not tabs(window)
    assert window.dismiss()
    FreeCAD.closeDocument(document.Name)


@pytest.mark.long
def test_part_is_shown_while_reading_continues(desk, window, monkeypatch):
    monkeypatch.setattr("vkworkbench.gui.simulation.reading._FIRST", 0.0)
    desk.kept(desk.small)
    tab = desk.simulate()
    scene, _ = tab.reading.seen
    assert (scene.owner >= 0).any() and len(np.unique(scene.image)) > 20
    assert tab.player.view._scene is scene  # the player first shows the last preview from reading the job
    # A click before the first simulation has no effect.
    window.click_at(tab.player.view, tab.player.view.rect().center())
    finest(shown(tab, window), window)
    assert tab.player.view._scene is not scene


@pytest.mark.long
def test_cost_is_shown_before_and_after_the_simulation(desk, window, monkeypatch):
    told = []

    def progress(line, simulating, original=StateLine.show_progress):
        original(line, simulating)
        told.append((simulating.expected, line.text()))

    monkeypatch.setattr(StateLine, "show_progress", progress)
    desk.kept(desk.small)
    player = shown(desk.simulate(), window)
    cost, text = next((cost, text) for cost, text in told if cost is not None)
    assert "The finest picture takes about" in text and "MB" in text and "Simulating… " in text
    zbuffer = player.simulation.zbuffer
    assert cost.memory_bytes == pytest.approx(zbuffer.peak.bytes(), rel=0.3)
    assert f"{zbuffer.traces:,} traces" in player.state.toolTip() and "simulated in" in player.state.toolTip()
    assert "about" not in player.state.text() and "…" not in player.state.text()
    checked = f"checked to {player.drawing.findings.facts.verdict.pixel:.2g} mm"
    assert told[0][1].startswith("Nothing is checked yet.") and checked in player.state.text()
    assert player.state.text() in player.state.toolTip().replace("\xa0", " ")


@pytest.mark.long
def test_surface_is_computed_before_the_picture(desk, window, monkeypatch):
    made = []

    def show(drawing, done, original=Drawing.take):
        if isinstance(done, simulating.Simulated):
            made.append("_by_owner" in vars(done.simulation.zbuffer.surface))
        original(drawing, done)

    monkeypatch.setattr(Drawing, "take", show)
    desk.kept(desk.small)
    shown(desk.simulate(), window)
    assert made and all(made)


def test_operation_deleted_while_copied_is_not_an_error(desk, document, window):
    window.click(COMMAND)
    (tab,) = tabs(window)
    document.removeObject(document.Job.Operations.Group[-1].Name)
    window.wait(tab.again.isVisible)
    window.idle(0.3)
    assert tab.player is None
    window.click_on(tab.again)
    window.wait(lambda: tabs(window) and tabs(window) != [tab])
    (tab,) = tabs(window)


CRASH = """(a slot that begins with a rapid move into the stock)
G0 Z30
G0 X40 Y50
G0 Z14
G1 X60 F300
G0 Z30"""


def make_crash(document):
    """Replace the operations of the job by one that crashes and gouges; return it."""
    import Path

    job = document.getObject("Job")
    op = document.addObject("Path::FeaturePython", "Slot")
    op.addProperty("App::PropertyLink", "ToolController", "Path").ToolController = job.Tools.Group[1]
    op.addProperty("App::PropertyBool", "Active", "Path").Active = True
    op.Path = Path.Path([Path.Command(line) for line in CRASH.splitlines()])
    job.Operations.Group = [op]
    return op


@pytest.mark.long
def test_faults_are_the_same_in_every_view(desk, document, window):
    op = make_crash(document)
    player = shown(desk.simulate(), window)
    found = player.faults
    assert {fault.what.code for fault in found} == {"rapid-cuts", "cuts-model"}
    for side in ("Bottom", "Front", "Isometric"):
        player.look(side)
        finest(player, window)
        assert player.faults is found
    window.wait(lambda: player.known._holds)  # wait until the document was compared with the simulated job
    (row,) = vkworkbench.analyze(op).operations
    (told,) = [remark for remark in row.remarks if remark.code == "simulated"]
    assert told.arguments["count"] == len({fault.command for fault in found})


# Tests of single widgets, without a simulated job


@pytest.mark.parametrize("wide", [True, False])
def test_text_of_a_combo_box_is_complete_or_ends_in_an_ellipsis(window, wide):
    box, text = controls._combo(""), "Difference to the Model"
    box.setParent(window.main)
    box.addItem(text)
    box.show()
    window.idle(0.1)  # s; wait until Qt applies FreeCAD's theme, whose borders are wider
    box.resize(box.sizeHint().width() - (0 if wide else 40), box.sizeHint().height())
    window.idle()
    option = QtGui.QStyleOptionComboBox()
    box.initStyleOption(option)
    style = box.style()
    field = style.subControlRect(QtGui.QStyle.CC_ComboBox, option, QtGui.QStyle.SC_ComboBoxEditField, box)
    seen, found = box.grab(field).toImage(), []
    for words in (text, *(f"{text[:length]}…" for length in range(len(text)))):
        box.setItemText(0, words)
        if box.fontMetrics().horizontalAdvance(words) <= field.width() and box.grab(field).toImage() == seen:
            found.append(words)
    assert found and (text in found) == wide
    box.hide()  # the shown widget would cover a part of later pictures until Qt deletes the widget
    box.deleteLater()


@pytest.mark.parametrize("wide", first_everywhere([False, True]))
def test_line_of_text_is_complete_or_ends_in_an_ellipsis(window, wide):
    line, text = OneLine(window.main), "1,024 × 768 pixels of 0.1 mm, 90,000 traces <b>"
    line.show_text(text)
    whole = line.sizeHint()
    line.resize(whole.width() - (0 if wide else 90), whole.height())
    line.show()
    window.idle()
    seen, found = line.grab().toImage(), []
    for words in (text, *(f"{text[:length]}…" for length in range(len(text)))):
        line.show_text(words)
        if line.sizeHint().width() <= line.width() and line.grab().toImage() == seen:
            found.append(words)
    assert found and (text in found) == wide
    line.show_text(text)
    line.setTextInteractionFlags(QtCore.Qt.TextSelectableByMouse)
    line.setSelection(0, len(text))
    assert line.selectedText() == text  # the user can copy the whole text, including the part that is not shown
    line.hide()  # otherwise the widget would cover a part of later pictures until Qt deletes the widget
    line.deleteLater()
