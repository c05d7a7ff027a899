# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulation tab while view, document or window size change, and the pictures that it saves."""

from __future__ import annotations

from itertools import combinations

import FreeCAD
import numpy as np
import pytest
from cases import first_everywhere
from PySide import QtCore, QtGui
from simulation_window import COMMAND, SMALL, close, drag, finest, make_small, shown, tabs

import vkworkbench
from vkworkbench.gui.qt import widgets
from vkworkbench.gui.simulation import exports
from vkworkbench.gui.simulation.faults import KnownFaults


@pytest.fixture
def tab(desk, window):
    """The tab with the finest picture of four operations; other tests may have used it."""
    return desk.shared(desk.small)


# Tests that change the view


def test_turning_and_playing_do_not_simulate_again(tab, window, monkeypatch, tmp_path):
    player = tab.player
    findings, faults, simulation = player.drawing.findings, player.faults, player.simulation
    monkeypatch.setattr(player, "simulate", lambda: pytest.fail("simulated again"))
    middle = player.view.rect().center()
    shown = []
    for change in (
        lambda: drag(window, player.view, middle, middle + QtCore.QPoint(90, 30)),
        lambda: window.wheel(player.view, middle, 12),
        lambda: drag(window, player.view, middle, middle + QtCore.QPoint(30, 0), QtCore.Qt.MiddleButton),
        lambda: player.look("Bottom"),
        lambda: player.look("Front"),
        lambda: player.look("Isometric"),
        lambda: player.moment.go_to(0.3 * player.clock.total),
        lambda: player.setFixedSize(420, 400),
        lambda: player.scene_bar.colorings.setCurrentIndex(5),
    ):
        change()
        finest(player, window)
        shown.append(player.view._scene.image.tobytes())
        assert player.simulation is simulation and player.drawing.findings is findings
        assert [(f.trajectory, f.what) for f in player.faults] == [(f.trajectory, f.what) for f in faults]
        size = player.view.view
        # Each picture has as many pixels as the view.
        assert player.view._scene.pixels.shape == (size.height, size.width)
    assert len(set(shown)) == len(shown)


def test_command_of_several_moves_shows_its_whole_volume(tab, window):
    player = tab.player
    command = next(
        (first, end)
        for first in np.flatnonzero(player.volumes > 0)
        for own, end in [player.moment.of_command(int(first))]
        if own == first and (player.volumes[first:end] > 0).sum() > 3
    )
    first, end = map(int, command)
    player.moment.after(end - 1)
    window.wait(lambda: player.pictures.is_current)
    volume = float(player.play_bar.text.text().split("Removed: ")[1].split()[0])
    assert volume == pytest.approx(player.volumes[first:end].sum(), rel=0.06)
    assert volume > 1.5 * player.volumes[first]


@pytest.mark.long
def test_removal_rates_are_not_saved_before_they_are_known(desk, window):
    desk.kept(desk.small)
    tab = desk.simulate()
    *_, rates = tab.player.scene_bar.results
    assert not rates.isEnabled() and rates.toolTip()
    finest(shown(tab, window), window)
    assert rates.isEnabled() and tab.player.volumes.sum() > 0


# Tests that change the document


def cut_off(document):
    face = document.getObjectsByLabel("Face")[0]
    face.Path = type(face.Path)(face.Path.Commands[:-20])


def larger_stock(document):
    document.Job.Stock.ExtZpos = 3.0
    document.recompute()


def moved(document):
    face = document.getObjectsByLabel("Face")[0]
    face.Placement = FreeCAD.Placement(FreeCAD.Vector(0, 0, 1), FreeCAD.Rotation())


def another_operation(document):
    import Path

    face = document.getObjectsByLabel("Face")[0]
    op = document.addObject("Path::FeaturePython", "Added")
    op.addProperty("App::PropertyLink", "ToolController", "Path").ToolController = face.ToolController
    op.addProperty("App::PropertyBool", "Active", "Path").Active = True
    op.Path = Path.Path([Path.Command(line) for line in ("G0 Z30", "G0 X40 Y50", "G1 Z15 F1", "G1 X60 F3", "G0 Z30")])
    document.Job.Operations.Group += [op]


def other_order(document):
    document.Job.Operations.Group = document.Job.Operations.Group[::-1]


def switched_off(document):
    document.getObjectsByLabel("Face")[0].Active = False


CHANGES = [larger_stock, switched_off, cut_off, moved, another_operation, other_order]


@pytest.mark.parametrize("change", first_everywhere(CHANGES, 2))
def test_change_is_shown_until_it_is_undone(desk, document, window, change):
    tab = desk.simulate()
    window.wait(lambda: tab.player.known._holds)  # wait until the document was compared with the simulated job
    job = tab.player.job
    document.UndoMode = 1
    document.openTransaction("change")
    change(document)
    document.commitTransaction()
    window.wait(tab.again.isVisible)
    document.undo()
    document.recompute()
    window.wait(lambda: not tab.again.isVisible())
    document.redo()
    window.wait(tab.again.isVisible)
    window.click_on(tab.again)
    window.wait(lambda: tabs(window) and tabs(window) != [tab])
    (again,) = tabs(window)
    window.wait(lambda: again.player is not None and again.player.known._holds)
    now = again.player.job
    names, before = ([op.name for op in simulated.operations] for simulated in (now, job))
    expected = {"another_operation": [*before, "Added"], "other_order": before[::-1], "switched_off": before[1:]}
    assert names == expected.get(change.__name__, before)
    if change is larger_stock:
        assert now.stock.upper[2] > job.stock.upper[2] + 1
    assert not again.again.isVisible()


def test_change_of_an_object_not_simulated_is_ignored(desk, document, window):
    tab = desk.simulate()
    window.wait(lambda: tab.player.known._holds)
    face = document.getObjectsByLabel("Face")[0]
    face.Path = type(face.Path)(face.Path.Commands)
    face.Label = "Another name"
    document.addObject("Part::Box", "Beside")
    document.recompute()
    assert not tab.player.known._holds
    window.wait(lambda: tab.player.known._holds)  # wait until the document was compared with the simulated job
    assert not tab.again.isVisible()


def crash(document):
    """Let the job begin with a rapid move through the stock; return the new operation."""
    another_operation(document)
    op = document.Added
    op.Path = type(op.Path)(
        [type(op.Path.Commands[0])(line) for line in ("G0 X40 Y50 Z30", "G0 Z14", "G0 X60", "G0 Z30")]
    )
    document.Job.Operations.Group = [op, *document.Job.Operations.Group[:-1]]
    return op


def told(op):
    (row,) = vkworkbench.analyze(op).operations
    return [remark.code for remark in row.remarks if remark.code == "simulated"]


@pytest.mark.long
def test_outdated_tab_reports_no_faults(desk, document, window):
    document.UndoMode = 1
    op = crash(document)
    tab = desk.simulate()
    player = shown(tab, window)
    window.wait(lambda: player.known._holds)  # wait until the document was compared with the simulated job
    assert told(op) == ["simulated"]
    document.openTransaction("change")
    cut_off(document)
    document.commitTransaction()
    assert told(op) == []
    player.look("Top")
    finest(player, window)
    assert tab.again.isVisible() and player.faults and told(op) == []
    document.undo()
    window.wait(lambda: not tab.again.isVisible())
    assert told(op) == ["simulated"]  # after the undo, the faults are valid and reported again


@pytest.mark.long
def test_change_while_the_job_is_read_is_noticed(desk, document, window, monkeypatch):
    kept = []
    monkeypatch.setattr(
        KnownFaults, "_publish", lambda known, tell=KnownFaults._publish: kept.append(known._holds) or tell(known)
    )
    op = crash(document)
    window.click(COMMAND)
    (tab,) = tabs(window)
    window.wait(lambda: op.Name in tab.copy._settings)
    assert tab.player is None
    op.Path = type(op.Path)(op.Path.Commands[:1])
    make_small(tab, window)
    shown(tab, window)
    window.wait(tab.again.isVisible)
    assert tab.player.faults and kept and not any(kept) and told(op) == []


def test_error_while_the_job_is_copied_is_shown(desk, window, monkeypatch):
    def copied(*_):
        raise RuntimeError("no path")

    monkeypatch.setattr("vkworkbench.document.simulation.copy._copied", copied)
    desk.kept(desk.small)
    window.click(COMMAND)
    window.wait(window.boxes)
    (text,) = window.dismiss()
    assert "RuntimeError: no path" in text and not tabs(window)


# Window sizes


def rows(player):
    bar, play = player.scene_bar, player.play_bar
    known = (
        bar.controls,
        bar.differences,
        bar.legend,
        player.view,
        play.controls,
        play.text,
        player.time_line,
        player.state,
    )
    return [row for row in known if row.isVisible()]


def rect(widget, within):
    return QtCore.QRect(widget.mapTo(within, QtCore.QPoint(0, 0)), widget.size())


@pytest.fixture(scope="module", params=first_everywhere([14, None]))
def low_tab(request, desk):
    """A tab that shows differences and warnings in the usual font, or in a font of 14 points."""
    tab, points = desk.shared(desk.small, direction="Top"), request.param
    player, bar = tab.player, tab.player.scene_bar
    font = player.font()
    if points:
        font.setPointSize(points)
        for widget in player.findChildren(QtGui.QWidget):
            widget.setFont(font)
    bar.colorings.setCurrentIndex(bar.colorings.count() - 1)
    bar.warnings.setText("⚠ Warnings: 555")
    yield tab, points
    close(desk.window)


@pytest.mark.parametrize("height", [170, 200, 260, 330, 480])
def test_controls_do_not_overlap_in_a_low_and_narrow_tab(low_tab, window, height):
    tab, points = low_tab
    player, bar = tab.player, tab.player.scene_bar
    player.setFixedSize(550, height)
    finest(player, window)
    bar.warnings.show()
    window.idle(0.2)
    seen = rows(player)
    assert {player.view, player.time_line, bar.controls, player.play_bar.controls} <= set(seen)
    assert (player.state in seen) == (height == 480)
    for one, other in combinations(seen, 2):
        assert not rect(one, player).intersects(rect(other, player)), (one, other)
    assert all(player.rect().contains(rect(row, player)) for row in seen)
    shown_buttons = [button for button in bar.findChildren(QtGui.QToolButton) if button.isVisible()]
    assert len(shown_buttons) >= 3
    assert all(button.width() >= button.sizeHint().width() for button in shown_buttons)
    if bar.differences.isVisible():
        assert bar.tolerance.width() >= bar.tolerance.sizeHint().width()
    window.screenshot(f"simulation-low-{height}-{points or 'usual'}")


def test_controls_of_colouring_by_difference_are_shown_with_it(tab, window):
    bar = tab.player.scene_bar
    tab.player.setFixedSize(360, 400)  # px, a size with room for the row of controls for differences from the model
    assert not bar.differences.isVisible()
    bar.colorings.setCurrentIndex(bar.colorings.count() - 1)
    assert bar.differences.isVisible()
    finest(tab.player, window)
    texts = [action.text() for action in bar.worst.menu().actions()]
    assert texts and len(set(texts)) == len(texts)
    bar.colorings.setCurrentIndex(0)
    assert not bar.differences.isVisible()
    finest(tab.player, window)


def test_results_leave_room_for_the_tab_in_a_small_window(desk, window):
    desk.kept(desk.small)
    results = window.show_results()
    window.main.setGeometry(0, 0, *SMALL)
    window.settle()
    before = results.height()
    desk.simulate()
    window.idle(0.1)
    assert results.height() < before and results.isVisible()
    assert results.height() <= results.minimumSizeHint().height() + 2
    window.screenshot("simulation-beside-results")
    close(window)
    results.close()


# Keys


def test_keys_of_the_time_line_work_in_the_whole_tab(tab, window):
    player = tab.player
    focused = QtGui.QApplication.focusWidget()
    assert focused == player.time_line
    for widget in (tab, player.view):
        widget.setFocus()
        for key, share in ((QtCore.Qt.Key_Home, 0.0), (QtCore.Qt.Key_PageUp, 0.05), (QtCore.Qt.Key_Right, 0.055),
                           (QtCore.Qt.Key_PageDown, 0.005), (QtCore.Qt.Key_Left, 0.0), (QtCore.Qt.Key_End, 1.0)):  # fmt: skip
            window.press(QtGui.QApplication.focusWidget(), key)
            assert player.moment.seconds == pytest.approx(share * player.clock.total, abs=1e-6)


def test_space_plays_after_returning_to_the_tab(tab, window):
    area = widgets.area_of_views()
    other = next(sub for sub in area.subWindowList() if sub.windowTitle() != tab.windowTitle())
    area.setActiveSubWindow(other)
    window.idle(0.3)
    assert not tab.player.time_line.hasFocus()
    tab.come_to_front()
    window.wait(tab.player.time_line.hasFocus)
    window.press(QtGui.QApplication.focusWidget(), QtCore.Qt.Key_Space)
    assert tab.player.moment.plays


# Tests that save pictures of the whole job


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """The folder that the user chooses; *Save pictures* saves four pictures."""
    monkeypatch.setattr(exports, "_FRAMES", 4)
    monkeypatch.setattr(exports.QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path))
    return tmp_path


def test_saved_pictures_get_their_own_folder(tab, desk, window, folder):
    player = tab.player
    (folder / "0000.png").write_text("somebody's")
    player.moment.go_to(0.4 * player.clock.total)
    window.wait(lambda: player.pictures.is_current)
    before, said = player.view.grab().toImage(), player.play_bar.text.text()
    for name in (f"{desk.document.Name} pictures", f"{desk.document.Name} pictures 2"):
        exports.save_frames(player)
        assert sorted(path.name for path in (folder / name).iterdir()) == [f"000{k}.png" for k in range(4)]
        status = window.main.statusBar().currentMessage()
        assert status == f"4 of 4 pictures are saved in {folder / name}."
    assert (folder / "0000.png").read_text() == "somebody's"
    assert player.play_bar.text.text() == said and player.view.grab().toImage() == before
    assert window.progress_dialog() is None


def test_saving_waits_for_finest_picture_and_esc_cancels_it(tab, desk, window, folder, monkeypatch):
    player = tab.player
    player.simulate()
    assert player.refines
    write, busy = exports.write_frames, []

    def given_up(player, to, number, going_on):
        def asked(done):
            busy.append(player.refines)
            if done == 2:
                (dialog,) = [w for w in player.findChildren(QtGui.QProgressDialog) if w.isVisible()]
                window.press(dialog, QtCore.Qt.Key_Escape)
            return going_on(done)

        return write(player, to, number, asked)

    monkeypatch.setattr(exports, "write_frames", given_up)
    exports.save_frames(player)
    assert len(busy) == 3 and not any(busy)
    assert len(list((folder / f"{desk.document.Name} pictures").iterdir())) == 2
    assert window.main.statusBar().currentMessage().startswith("2 of 4 pictures")


def test_read_only_folder_shows_a_message(tab, window, folder, monkeypatch):
    monkeypatch.setattr(exports.QFileDialog, "getExistingDirectory", lambda *_: str(folder / "nowhere"))
    exports.save_frames(tab.player)
    (text,) = window.dismiss()
    assert text.startswith(str(folder / "nowhere")) and "cannot be written" in text
