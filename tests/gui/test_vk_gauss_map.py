# SPDX-License-Identifier: LGPL-2.1-or-later
"""The Gauss map view: it follows the selection, steps through k and is saved."""

import time
import xml.etree.ElementTree

import FreeCAD
import FreeCADGui as Gui
import numpy as np
import Path
import pytest
from PySide import QtCore, QtGui


def select(obj):
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(obj)


def labelled(document, label):
    return document.getObjectsByLabel(label)[0]


class View:
    """The dock and its parts, as a user finds them."""

    def __init__(self, window):
        self.window = window
        self.dock = window.main.findChild(QtGui.QDockWidget, "VkGaussMap")
        self.title = self.dock.title
        self.slider, self.number, self.chooser = self.dock.slider, self.dock.number, self.dock.chooser

    @property
    def canvas(self):
        return next(w for w in self.dock.findChildren(QtGui.QWidget) if type(w).__name__ == "GaussCanvas")

    def picture(self):
        """The canvas's pixels, (rows, columns, 4), once they are drawn."""
        self.window.wait(lambda: self.canvas._still is not None)
        self.window.idle(0.1)
        return np.array(self.canvas.buffer_rgba())


def same(picture, other):
    return picture.tobytes() == other.tobytes()  # pytest would print arrays whole


@pytest.fixture
def view(opened, window):
    """The view, opened by its button, with a zigzag selected."""
    select(labelled(opened, "Face"))
    window.click("Gauss map")
    view = View(window)
    window.wait(lambda: view.title.text().startswith("Face"))
    yield view
    if view.dock.isVisible():
        window.click("Gauss map")


def test_a_zigzag_stays_on_level_0(view, window):
    signature = view.canvas.signature
    assert len(signature) > 20 and (signature.level == 0).all()
    assert view.title.text().count("level n = 0") == 2  # of the operation, and of its longest area
    assert view.slider.value() == view.slider.maximum() == len(signature)
    view.picture()
    window.screenshot("gauss-map-zigzag")


def test_it_follows_the_selection(view, opened, window):
    shown = view.picture()
    select(labelled(opened, "Bore"))
    window.wait(lambda: view.title.text().startswith("Bore"))
    assert np.abs(view.canvas.signature.level).max() >= 3  # winding
    assert not same(view.picture(), shown)
    window.screenshot("gauss-map-helix")

    shown = view.picture()
    Gui.Selection.clearSelection()
    window.idle()
    assert same(view.picture(), shown)  # nothing selected: it stays

    select(labelled(opened, "Drill holes"))
    window.wait(lambda: "no cutting move has a direction" in view.title.text())
    assert not view.canvas.isVisible() and not view.slider.isVisible()
    select(labelled(opened, "Adaptive pocket"))
    window.wait(view.canvas.isVisible)
    view.picture()
    window.screenshot("gauss-map-adaptive")


def test_slider_and_number_step_through_k(view, window):
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
    # Each of the three plots follows.
    changed = (pictures[0] != pictures[2]).any(axis=(0, 2))
    assert all(part.any() for part in np.array_split(changed, 3))
    # Where it was before, it looks as it did.
    view.slider.setValue(last)
    assert same(view.picture(), pictures[0])


def test_areas_are_chosen(view, opened, window):
    select(labelled(opened, "Pocket around island"))
    window.wait(lambda: view.title.text().startswith("Pocket around island"))
    assert view.chooser.count() > 1
    lengths = [view.dock._areas.area_length[view.chooser.itemData(row)] for row in range(view.chooser.count())]
    assert lengths == sorted(lengths, reverse=True)
    before = view.picture()
    view.chooser.setFocus()
    window.press(view.chooser, QtCore.Qt.Key_End)
    assert view.chooser.currentIndex() == view.chooser.count() - 1
    assert not same(view.picture(), before)
    window.screenshot("gauss-map-area")


def test_an_edit_is_shown(view, opened, window):
    face = labelled(opened, "Face")
    points = [(0, 0), (30, 0), (30, 2), (0, 2), (0, 4), (30, 4)]
    commands = [Path.Command("G0", {"X": 0, "Y": 0, "Z": 0})]
    commands += [Path.Command("G1", {"X": x, "Y": y}) for x, y in points[1:]]
    face.Path = Path.Path(commands)
    window.wait(lambda: len(view.canvas.signature) == 5)
    opened.removeObject(face.Name)
    window.wait(lambda: "Select an operation" in view.title.text())
    assert not view.canvas.isVisible()


def test_hidden_it_does_nothing_and_shown_again_it_is_up_to_date(view, opened, window):
    window.click("Gauss map")
    assert not view.dock.isVisible()
    select(labelled(opened, "Bore"))
    window.idle()
    assert view.title.text().startswith("Face")
    window.click("Gauss map")
    window.wait(lambda: view.title.text().startswith("Bore"))


@pytest.mark.parametrize("suffix", ["png", "svg"])
def test_save_the_picture(view, window, tmp_path, suffix):
    path = tmp_path / f"picture.{suffix}"
    seen = []

    def answer():
        dialogs = [w for w in QtGui.QApplication.topLevelWidgets()
                   if isinstance(w, QtGui.QFileDialog) and w.isVisible()]
        if not dialogs:
            QtCore.QTimer.singleShot(50, answer)
            return
        seen.append(dialogs[0].windowTitle())
        name = dialogs[0].findChild(QtGui.QLineEdit)
        name.setText(str(path))
        window.press(name, QtCore.Qt.Key_Return)

    before = view.picture()
    QtCore.QTimer.singleShot(50, answer)
    window.click_on(view.dock.saver)
    assert seen and path.exists()
    if suffix == "png":
        assert path.read_bytes().startswith(b"\x89PNG")
        image = QtGui.QImage(str(path))
        assert image.width() > 1000 and len({image.pixel(x, image.height() // 2) for x in range(image.width())}) > 3
    else:
        assert xml.etree.ElementTree.parse(path).getroot().tag.endswith("svg")
    view.picture()
    window.press(view.slider, QtCore.Qt.Key_Left)  # the view works on
    assert not same(view.picture(), before)


def test_other_documents_close(view, opened, window):
    other = FreeCAD.newDocument("Other")
    FreeCAD.closeDocument(other.Name)
    assert view.canvas.isVisible()


def test_narrow_and_floating(view, window):
    view.dock.setFloating(True)
    view.dock.resize(520, 700)
    view.picture()
    window.screenshot("gauss-map-narrow")
    figure = view.canvas.figure
    tops = sorted(axes.get_position().y0 for axes in figure.axes)
    assert tops[0] < 0.4 < tops[-1]  # two above, one below
    window.main.removeDockWidget(view.dock)
    window.main.addDockWidget(QtCore.Qt.BottomDockWidgetArea, view.dock)
    results = window.main.findChild(QtGui.QDockWidget, "VkResults")
    if results is not None:
        window.main.tabifyDockWidget(results, view.dock)
    view.dock.setFloating(False)
    view.dock.show()
    window.wait(lambda: view.dock.width() > 1000)


def test_dark_window(view, opened, window):
    QtGui.QApplication.instance().setStyleSheet("QWidget { color: #e0e0e0; background-color: #2b2b2b; }")
    try:
        window.idle()
        select(labelled(opened, "Bore"))
        window.wait(lambda: view.title.text().startswith("Bore"))
        picture = view.picture()
        assert np.median(picture[..., :3]) < 80
        window.screenshot("gauss-map-dark")
    finally:
        QtGui.QApplication.instance().setStyleSheet("")


def test_half_a_million_trajectories_stay_usable(view, opened, window):
    rows = np.arange(250_000)
    xs = np.where(rows % 2 == 0, 100.0, 0.0)
    commands = [Path.Command("G0", {"X": 0, "Y": 0, "Z": 0})]
    for row, x in enumerate(xs.tolist()):
        commands.append(Path.Command("G1", {"X": x}))
        commands.append(Path.Command("G1", {"Y": row * 0.05}))
    long = opened.addObject("Path::Feature", "Long")
    long.ViewObject.Visibility = False
    long.Path = Path.Path(commands)
    select(long)
    window.wait(lambda: view.title.text().startswith("Long"), 60)
    assert view.slider.maximum() > 490_000
    view.picture()
    window.screenshot("gauss-map-500000")
    assert "Gauss map of the last 1,000" in view.dock.legend.text()
    taken = []
    for _ in range(6):
        begin = time.perf_counter()
        window.press(view.slider, QtCore.Qt.Key_PageDown)
        window.press(view.slider, QtCore.Qt.Key_PageUp)
        window.idle(0)
        taken.append((time.perf_counter() - begin) / 2)
    print(f"a step takes {min(taken) * 1e3:.0f} ms")
    assert min(taken) < 0.25
