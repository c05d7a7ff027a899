# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Gauss map panel follows the selection, steps through the sums of vectors V_k, and saves its picture."""

import csv
import pathlib
import threading
import time
from contextlib import contextmanager
from xml.etree import ElementTree

import FreeCAD
import FreeCADGui as Gui
import numpy as np
import Path
import pytest
from cases import first_everywhere
from pictures import pixels
from PySide import QtCore, QtGui

import vkworkbench
from vkworkbench import freecad
from vkworkbench.gui.gauss import dock as gauss_map
from vkworkbench.gui.qt import background
from vkworkbench.gui.qt.colors import contrast
from vkworkbench.language import ENGLISH

try:  # PySide2 first, because FreeCAD crashes if PySide6 is imported while FreeCAD uses PySide2
    from PySide2.QtTest import QTest
except ImportError:
    from PySide6.QtTest import QTest


def select(obj):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)


def labelled(document, label):
    return document.getObjectsByLabel(label)[0]


class View:
    """Find the Gauss map's panel, its plots and its buttons."""

    def __init__(self, window):
        self.window = window
        self.dock = window.first(QtGui.QDockWidget, "VkGaussMap")
        self.title = self.dock.title
        self.slider, self.number, self.chooser = self.dock.slider, self.dock.number, self.dock.chooser

    @property
    def canvas(self):
        return next(w for w in self.dock.findChildren(QtGui.QWidget) if type(w).__name__ == "GaussCanvas")

    @property
    def signature(self):
        return self.canvas.figure.signature

    def picture(self):
        """Return the pixels of the canvas, (rows, columns, 4)."""
        self.window.wait(lambda: not self.dock._background.works)
        self.window.settle()
        return pixels(self.canvas.grab().toImage())


def same(picture, other):
    return picture.tobytes() == other.tobytes()  # if arrays differ, pytest would print them completely


@pytest.fixture(scope="module", autouse=True)
def closed_in_the_end(window):
    yield
    for dock in window.find(QtGui.QDockWidget, "VkGaussMap"):
        dock.close()


@pytest.fixture
def view(opened, window):
    """The open panel, with a zigzag selected."""
    select(labelled(opened, "Face"))
    if not any(dock.isVisible() for dock in window.find(QtGui.QDockWidget, "VkGaussMap")):
        window.click("Gauss Map")
    view = View(window)
    window.wait(lambda: view.title.text().startswith("Face") and not view.dock._background.works)
    return view


def test_zigzag_makes_no_full_turn_in_the_gauss_map(view, window):
    signature = view.signature
    assert len(signature) > 20 and (signature.level == 0).all()
    # The title has the level (number of whole turns) of the operation, and of the area if its level differs.
    assert view.title.text().count("level n = 0") >= 1
    assert view.title.text().startswith("Face: zigzag 9")
    assert view.slider.value() == view.slider.maximum() == len(signature)
    view.picture()
    window.screenshot("gauss-map-zigzag")


def test_gauss_map_follows_the_selection(view, opened, window):
    shown = view.picture()
    select(labelled(opened, "Bore"))
    window.wait(lambda: view.title.text().startswith("Bore"))
    assert np.abs(view.signature.level).max() >= 3  # the toolpath of the bore is a helix with several full turns
    assert not same(view.picture(), shown)
    window.screenshot("gauss-map-helix")

    shown = view.picture()
    Gui.Selection.clearSelection()
    window.settle()
    assert same(view.picture(), shown)  # without a selection, the panel still shows the last operation

    select(labelled(opened, "Drill holes"))
    window.wait(lambda: "No move cuts sideways" in view.title.text())
    assert not view.canvas.isVisible() and not view.slider.isVisible()
    select(labelled(opened, "Adaptive pocket"))
    window.wait(view.canvas.isVisible)
    view.picture()
    window.screenshot("gauss-map-adaptive")


def test_gauss_map_names_an_inactive_operation(view, opened, window):
    face = labelled(opened, "Face")
    face.Active = False
    opened.recompute()
    window.wait(lambda: "switch it on" in view.title.text())
    assert view.title.text().startswith("Face: The operation is switched off.") and not view.canvas.isVisible()
    face.Active = True
    opened.recompute()
    window.wait(view.canvas.isVisible)


def test_slider_and_number_step_through_vectors(view, window):
    last = view.slider.maximum()
    pictures = [view.picture()]
    window.press(view.slider, QtCore.Qt.Key_Left)
    assert view.number.value() == last - 1 and f"k = {last - 1} / {last}" in view.dock.values.text()
    pictures.append(view.picture())
    for _ in range(40):
        window.press(view.slider, QtCore.Qt.Key_PageDown)
    assert view.number.value() == 1
    pictures.append(view.picture())
    window.press(view.number, QtCore.Qt.Key_Up)
    assert view.slider.value() == 2
    pictures.append(view.picture())
    assert not any(same(a, b) for a, b in zip(pictures, pictures[1:]))
    # The step to another vector changes all three plots, which are side by side.
    changed = (pictures[0] != pictures[2]).any(axis=(0, 2))
    assert all(part.any() for part in np.array_split(changed, 3))
    # Showing the same vector again gives an identical picture.
    view.slider.setValue(last)
    assert same(view.picture(), pictures[0])


def test_chosen_area_is_shown_in_the_gauss_map(view, opened, window):
    select(labelled(opened, "Pocket around island"))
    window.wait(lambda: view.title.text().startswith("Pocket around island"))
    assert view.chooser.count() > 1
    areas = view.dock._reading.areas
    lengths = [areas.area_length[view.chooser.itemData(row)] for row in range(view.chooser.count())]
    assert lengths[1:] == sorted(lengths[1:], reverse=True)
    # The first area in the list explains the strategy: its largest phi is the phi in the mark in the tree.
    assert view.signature.phi_range[1] == pytest.approx(view.dock._reading.recognition.phi_range[1], abs=1e-9)
    before = view.picture()
    view.chooser.setFocus()
    window.press(view.chooser, QtCore.Qt.Key_End)
    assert view.chooser.currentIndex() == view.chooser.count() - 1
    assert not same(view.picture(), before)
    window.screenshot("gauss-map-area")


def test_changed_path_is_shown_in_the_gauss_map(view, opened, window):
    face = labelled(opened, "Face")
    points = [(0, 0), (30, 0), (30, 2), (0, 2), (0, 4), (30, 4)]
    commands = [Path.Command("G0", {"X": 0, "Y": 0, "Z": 0})]
    commands += [Path.Command("G1", {"X": x, "Y": y}) for x, y in points[1:]]
    face.Path = Path.Path(commands)
    window.wait(lambda: len(view.signature) == 5)
    opened.removeObject(face.Name)
    window.wait(lambda: "Select an operation" in view.title.text())
    assert not view.canvas.isVisible()


def test_hidden_gauss_map_is_updated_when_shown_again(view, opened, window):
    view.dock.hide()
    assert not view.dock.isVisible()
    select(labelled(opened, "Bore"))
    window.settle()
    assert view.title.text().startswith("Face")
    window.click("Gauss Map")
    window.wait(lambda: view.title.text().startswith("Bore"))


@pytest.mark.parametrize("suffix", ["png", "svg"])
def test_picture_of_the_gauss_map_is_saved(view, window, tmp_path, suffix):
    path = tmp_path / f"picture.{suffix}"
    before = view.picture()
    assert window.answer_file_dialog(path, lambda: window.click_on(view.dock.saver))
    assert path.exists()
    # An SVG or PDF file contains its title as text.
    assert suffix == "png" or "Face: zigzag" in path.read_text(encoding="utf-8")
    if suffix == "png":
        assert path.read_bytes().startswith(b"\x89PNG")
        image = QtGui.QImage(str(path))
        assert image.width() > 1000 and len({image.pixel(x, image.height() // 2) for x in range(image.width())}) > 3
    else:
        assert ElementTree.parse(path).getroot().tag.endswith("svg")
    view.picture()
    window.press(view.slider, QtCore.Qt.Key_Left)  # after saving, the slider still steps through the vectors
    assert not same(view.picture(), before)


def test_gauss_map_stays_when_another_document_is_closed(view, opened, window):
    other = FreeCAD.newDocument("Other")
    FreeCAD.closeDocument(other.Name)
    assert view.canvas.isVisible()


def test_gauss_map_is_empty_for_another_active_document(view, opened, window):
    other = FreeCAD.newDocument("Other")
    try:
        window.settle()
        FreeCAD.setActiveDocument(other.Name)  # an earlier event may have activated the example again
        window.wait(lambda: "Select an operation" in view.title.text())
        assert not view.canvas.isVisible()
    finally:
        FreeCAD.closeDocument(other.Name)
    FreeCAD.setActiveDocument(opened.Name)
    select(labelled(opened, "Face"))
    window.wait(view.canvas.isVisible)


def test_small_window_is_not_enlarged_by_the_gauss_map(view, opened, window):
    before = window.main.geometry()
    try:
        window.main.setGeometry(0, 0, 1024, 600)
        select(labelled(opened, "Bore"))
        window.wait(lambda: view.title.text().startswith("Bore"))
        window.settle()
        assert window.main.height() <= 600 and window.main.width() <= 1024
        figure, area = view.canvas.figure, view.canvas.rect()
        assert all(area.contains(plot.place.toRect()) for plot in (figure.path, figure.circle, figure.graph))
        values = view.dock.values
        assert values.height() >= values.heightForWidth(values.width())
        window.screenshot("gauss-map-1024")
    finally:
        window.main.setGeometry(before)
        window.settle()


def test_name_of_the_threshold_of_phi_does_not_cover_curves(view, opened, window):
    select(labelled(opened, "Bore"))
    window.wait(lambda: view.title.text().startswith("Bore"))
    picture, figure, ratio = view.picture(), view.canvas.figure, view.canvas.devicePixelRatioF()
    ink = np.array(QtGui.QColor(figure._strong(view.canvas.theme)).getRgb()[:3])
    rows = np.flatnonzero(
        (picture[..., :3] == ink).all(axis=2)[:, int(figure.graph.place.left() * ratio) :].any(axis=1)
    )
    line = view.canvas.fontMetrics().height()
    top = figure.graph.place.top()
    assert ((rows / ratio > top - 2 * line - 4) & (rows / ratio < top - line - 4)).any()


def test_narrow_floating_panel_has_two_rows_of_plots(view, window):
    view.dock.setFloating(True)
    view.dock.resize(520, 700)
    view.picture()
    window.screenshot("gauss-map-narrow")
    figure = view.canvas.figure
    assert figure.path.place.bottom() < figure.graph.place.top()  # the graph is below the other two plots
    window.main.removeDockWidget(view.dock)
    window.main.addDockWidget(QtCore.Qt.BottomDockWidgetArea, view.dock)
    results = window.first(QtGui.QDockWidget, "VkResults")
    if results is not None:
        window.main.tabifyDockWidget(results, view.dock)
    view.dock.setFloating(False)
    view.dock.show()
    window.wait(lambda: not view.dock.isFloating() and view.dock.isVisible())


@pytest.mark.parametrize("pack", first_everywhere(["FreeCAD Dark", "FreeCAD Light"]))
def test_gauss_map_is_readable_in_themes(view, opened, window, pack):
    with in_theme(window, pack):
        select(labelled(opened, "Pocket around island"))
        window.wait(lambda: view.title.text().startswith("Pocket around island"))
        picture = view.picture()[..., :3].astype(int)
        window.screenshot("gauss-map-" + pack.lower().replace(" ", "-"))
        back = QtGui.QColor(view.canvas.theme.back)
        assert (np.median(picture, axis=(0, 1)) == back.getRgb()[:3]).all()
        # The background of the picture is the background of the dock beside it.
        beside = view.dock._body.mapTo(view.dock, QtCore.QPoint(2, 2))
        assert view.dock.grab(QtCore.QRect(beside, QtCore.QSize(1, 1))).toImage().pixelColor(0, 0) == back
        for name in ("text", "v", "counter_clockwise", "clockwise", "faint"):
            ink = QtGui.QColor(getattr(view.canvas.theme, name))
            least = 3 if name == "faint" else 4.5
            assert contrast(ink, back) > least, (name, ink.name(), back.name())
    # The picture follows the theme without a click.
    window.wait(lambda: view.canvas.theme.back != back.name() or pack == "FreeCAD Light")


@contextmanager
def in_theme(window, pack):
    """Set a theme of FreeCAD through its preferences; before FreeCAD 1.1, set the theme's style sheet."""
    application = QtGui.QApplication.instance()
    group = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/MainWindow")
    before = application.styleSheet(), group.GetString("Theme"), group.GetString("StyleSheet")
    if freecad.version() >= (1, 1):
        group.SetString("Theme", pack)
        group.SetString("StyleSheet", "FreeCAD.qss")
        window.wait(lambda: application.styleSheet() != before[0] or before[1] in ("", pack))
    else:
        application.setStyleSheet(shipped_sheet(pack))
    window.settle()
    try:
        yield
    finally:
        group.SetString("Theme", before[1])
        group.SetString("StyleSheet", before[2])
        window.settle()
        application.setStyleSheet(before[0])
        window.settle()


def shipped_sheet(pack):
    """Return the style sheet of a theme with its accent colours; FreeCAD 0.20 has a similar style sheet."""
    sheets = pathlib.Path(FreeCAD.getResourceDir()) / "Gui" / "Stylesheets"
    like = {"FreeCAD Dark": "Dark-blue.qss", "FreeCAD Light": "Light-blue.qss"}[pack]
    path = sheets / f"{pack}.qss" if (sheets / f"{pack}.qss").exists() else sheets / like
    text = path.read_text()
    for number, color in enumerate(("#4aa5ff", "#b4d3ff", "#557bb6"), 1):
        text = text.replace(f"@ThemeAccentColor{number}", color)
    return text.replace("qss:", sheets.as_posix() + "/")


@pytest.mark.long
@pytest.mark.parametrize("label", ["Face", "Pocket zigzag", "Pocket around island", "Bore", "Adaptive pocket"])
def test_gauss_map_shows_the_numbers_of_mark_and_table(view, opened, window, label, tmp_path):
    report = vkworkbench.analyze(opened.getObjectsByLabel(label)[0])
    report.to_csv(str(tmp_path / "report.csv"))
    (row,) = csv.DictReader(
        (tmp_path / "report.csv").open(newline=""),
        delimiter=";" if ";" in (tmp_path / "report.csv").read_text().splitlines()[0] else ",",
    )
    select(labelled(opened, label))
    window.wait(lambda: view.title.text().startswith(f"{label}: ") and not view.dock._background.works)
    shown, found = view.dock._reading.recognition, report.operations[0].recognition
    assert (shown.strategy, shown.confidence, shown.phi_range, shown.level, shown.reversals, shown.reason) == (
        found.strategy, found.confidence, found.phi_range, found.level, found.reversals, found.reason)  # fmt: skip
    first, second, *rest = view.title.text().split("\n")
    (third,) = rest or [second]
    assert not rest or second not in third  # the third line of the title does not repeat the second line
    assert first == f"{label}: {found.strategy.value} {found.confidence:.0%}. {found.reason.replace('Phi', 'φ')}"
    assert "φ" in first and "phi" not in view.title.text().lower()  # the title writes phi as φ
    assert f"level n = {row['level']}," in second
    assert second.startswith("φ between {} and {} turns".format(*map(ENGLISH.turns, found.phi_range)))
    # The drawn range of phi is the area's range, including the turn from a loop's last side to its first side.
    figure, signature = view.canvas.figure, view.signature
    assert (figure.phi.min(), figure.phi.max()) == signature.phi_range
    assert f"{ENGLISH.turns(figure.phi.max())} turns, level n = {signature.top_level}," in third
    assert signature.top_level in (figure.level.min(), figure.level.max())
    low, high = figure.graph.window[0][1], figure.graph.window[1][1]
    assert low < min(figure.phi.min(), figure.limits[0]) and high > max(figure.phi.max(), figure.limits[1])


def test_gauss_map_shows_the_papers_condition_on_phi(view, opened, window):
    named = {}
    for label in ("Face", "Pocket around island", "Bore", "Drill holes"):
        select(labelled(opened, label))
        window.wait(lambda label=label: view.title.text().startswith(label) and not view.dock._background.works)
        if view.canvas.isVisible():
            named[label] = view.canvas.figure.bound
    assert named["Pocket around island"] == "|n| ≥ 1: contour-parallel"
    assert named["Bore"] == "|n| ≥ 1: helix"
    assert named["Face"] == "n = 0: zigzag"


def test_phi_of_a_zigzag_is_a_quarter_turn_inside_its_limits(view, opened, window):
    select(labelled(opened, "Pocket zigzag"))
    window.wait(lambda: view.title.text().startswith("Pocket zigzag") and not view.dock._background.works)
    figure = view.canvas.figure
    low, high = figure.limits
    assert low + np.pi / 2 < figure.phi.min() and figure.phi.max() < high - np.pi / 2
    assert figure.bound.endswith(": zigzag")


@pytest.mark.long
def test_plots_are_at_least_80_pixels_high(view, opened, window):
    before = window.main.geometry()
    try:
        for size in ((1024, 700), (1366, 768)):
            window.main.setGeometry(0, 0, *size)
            view.picture()
            figure = view.canvas.figure
            assert min(plot.place.height() for plot in (figure.path, figure.circle, figure.graph)) >= 80
            window.screenshot(f"gauss-map-{size[0]}")
    finally:
        window.main.setGeometry(before)
        window.settle()


def test_wheel_zooms_and_mouse_moves_a_plot(view, window):
    window.settle()  # wait for the layout, which would otherwise move the plot under the mouse during the test
    canvas, plot, pictures = view.canvas, view.canvas.figure.path, [view.picture()]
    plots = canvas.figure.path, canvas.figure.graph
    before, whole = plot.window, [np.array([one.lower, one.upper]) for one in plots]
    at = plot.place.center().toPoint()
    under = plot.data(QtCore.QPointF(at))
    for _ in range(3):
        window.wheel(canvas, at)
    assert (plot.window[1] - plot.window[0] < 0.6 * (before[1] - before[0])).all()
    assert plot.data(QtCore.QPointF(at)) == pytest.approx(under)  # after zooming, the same point is under the mouse
    pictures.append(view.picture())
    end = at + QtCore.QPoint(30, 20)
    QTest.mousePress(canvas, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, at)
    move = QtGui.QMouseEvent(QtCore.QEvent.MouseMove, QtCore.QPointF(end), QtCore.QPointF(canvas.mapToGlobal(end)),
                             QtCore.Qt.NoButton, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier)  # fmt: skip
    QtGui.QApplication.sendEvent(canvas, move)
    QTest.mouseRelease(canvas, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, end)
    assert plot.data(QtCore.QPointF(end)) == pytest.approx(under)
    pictures.append(view.picture())
    window.screenshot("gauss-map-zoomed")
    assert not same(pictures[0], pictures[1]) and not same(pictures[1], pictures[2])
    graph = view.canvas.figure.graph
    window.wheel(canvas, graph.place.center().toPoint(), -1)
    QTest.mouseDClick(canvas, QtCore.Qt.LeftButton, QtCore.Qt.NoModifier, at)
    assert [np.array_equal([one.lower, one.upper], was) for one, was in zip((plot, graph), whole)] == [True, False]


@pytest.mark.long
def test_gauss_map_of_100_000_trajectories_stays_responsive(view, opened, window):
    rows = np.arange(50_000)
    xs = np.where(rows % 2 == 0, 100.0, 0.0)
    commands = [Path.Command("G0", {"X": 0, "Y": 0, "Z": 0})]
    for row, x in enumerate(xs.tolist()):
        commands.append(Path.Command("G1", {"X": x}))
        commands.append(Path.Command("G1", {"Y": row * 0.05}))
    long = opened.addObject("Path::Feature", "Long")
    long.ViewObject.Visibility = False
    long.Path = Path.Path(commands)
    beats, begin = [], time.monotonic()
    timer = QtCore.QTimer()
    timer.timeout.connect(lambda: beats.append(time.monotonic() - begin))
    timer.start(5)
    select(long)
    busy = view.dock.busy
    busy._later.setInterval(0)  # show the progress line at once, because a fast computer soon ends the task
    # Wait for "Long", because on a busy computer the panel can still be reading the operation Face.
    window.wait(lambda: busy.isVisible() and "Long" in busy.label.text())
    window.click_on(busy.button)  # cancel the reading of the operation Long
    assert "Select an operation" in view.title.text() and not busy.isVisible()
    beats.clear()
    begin = time.monotonic()
    select(long)
    window.wait(lambda: view.title.text().startswith("Long"))
    timer.stop()
    assert view.slider.maximum() > 98_000
    view.picture()
    window.screenshot("gauss-map-100000")
    assert "Gauss map of the last 1,000" in view.dock.legend.text()
    taken = []
    for _ in range(6):
        begin = time.perf_counter()
        window.press(view.slider, QtCore.Qt.Key_PageDown)
        window.press(view.slider, QtCore.Qt.Key_PageUp)
        window.idle(0)
        taken.append((time.perf_counter() - begin) / 2)
    print(f"a step takes {min(taken) * 1e3:.0f} ms; while it was read, the window lived {len(beats)} times, the longest "
          f"pause {max(b - a for a, b in zip([0.0, *beats], beats)):.3f} s")  # fmt: skip
    busy._later.setInterval(background._DELAY)
    assert len(beats) > 5


@pytest.mark.parametrize("label", ["Face", "Pocket around island"])
def test_plots_are_not_cut_off_in_a_narrow_dock(opened, view, label):
    select(labelled(opened, label))
    view.picture()
    canvas, width = view.canvas, 420  # about the width in px of a dock beside the 3D view
    image = QtGui.QImage(width + 200, 120, QtGui.QImage.Format_RGB32)
    image.fill(QtGui.QColor(canvas.theme.back))
    painter = QtGui.QPainter(image)
    painter.setFont(canvas.font())
    canvas.figure.lay_out(width, image.height(), QtGui.QFontMetrics(canvas.font()))
    canvas.figure.paint_still(painter, canvas.theme)
    painter.end()
    drawn = (pixels(image) != pixels(image)[0, -1]).any(axis=(0, 2))
    assert drawn.nonzero()[0].max() < width


def test_save_is_disabled_until_the_operation_is_read(opened, view, window, monkeypatch):
    go_on, drawn = threading.Event(), gauss_map._drawn

    def slowly(*what):
        go_on.wait(60)
        yield from drawn(*what)

    monkeypatch.setattr(gauss_map, "_drawn", slowly)
    assert view.dock.saver.isEnabled()
    select(labelled(opened, "Bore"))
    window.wait(lambda: not view.dock.saver.isEnabled())
    assert view.dock._background.works
    go_on.set()
    window.wait(lambda: view.title.text().startswith("Bore") and view.dock.saver.isEnabled())


def test_save_is_disabled_until_the_area_is_read(opened, view, window, monkeypatch):
    go_on, figure = threading.Event(), gauss_map.GaussFigure

    def slowly(*what):
        go_on.wait(60)
        return figure(*what)

    select(labelled(opened, "Pocket around island"))
    window.wait(lambda: view.title.text().startswith("Pocket around island") and view.dock.saver.isEnabled())
    monkeypatch.setattr(gauss_map, "GaussFigure", slowly)
    monkeypatch.setattr(gauss_map, "_QUICK", 0)
    before = view.canvas.figure
    view.chooser.setCurrentIndex(1)
    assert view.dock._background.works and not view.dock.saver.isEnabled() and view.chooser.isEnabled()
    view.dock.busy.button.click()  # after a cancel, the panel shows the former area
    assert not view.dock._background.works and view.dock.saver.isEnabled()
    assert view.canvas.isVisible() and view.canvas.figure is before and view.chooser.currentIndex() == 0
    view.chooser.setCurrentIndex(1)
    go_on.set()
    window.wait(view.dock.saver.isEnabled)
    assert view.canvas.figure is not before


def test_dock_without_a_picture_hides_its_controls(window):
    dock = gauss_map.GaussMapDock(None)
    dock.setObjectName("")  # the Gauss map panel of the window already has the name
    try:
        assert all(widget.isHidden() for widget in (dock.slider, dock.number, dock.saver, dock.chooser))
    finally:
        Gui.Selection.removeObserver(dock)
        FreeCAD.removeDocumentObserver(dock)
        dock.deleteLater()
        QtCore.QCoreApplication.sendPostedEvents(dock, QtCore.QEvent.DeferredDelete)
