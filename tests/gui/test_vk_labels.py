# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels that look like HTML are shown as plain text."""

import FreeCADGui as Gui
import pytest
from PySide import QtCore, QtGui

import vkworkbench
from vkworkbench.core.zbuffer import Speed
from vkworkbench.document.computer import calibration
from vkworkbench.gui import preferences_page
from vkworkbench.gui.qt import plain_text, progress

HTML = "<b>bold</b><img src='x.png'>"


def test_progress_shows_labels_as_text(opened, window, monkeypatch):
    seen = []

    def analyze(what, *, progress, cancelled):
        progress(0, 2, HTML)
        (dialog,) = (d for d in window.find(QtGui.QProgressDialog) if d.labelText() == HTML)
        label = dialog.findChild(QtGui.QLabel)
        seen.append((label.text(), label.textFormat()))

    monkeypatch.setattr(vkworkbench, "analyze", analyze)
    progress.analyze(opened)
    assert seen == [(HTML, QtCore.Qt.PlainText)]


def test_gauss_map_shows_labels_as_text(opened, window):
    face = opened.getObjectsByLabel("Face")[0]
    face.Label = HTML
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(face)
    window.click("Gauss Map")
    dock = window.first(QtGui.QDockWidget, "VkGaussMap")
    title = dock.title
    window.wait(lambda: title.text().startswith(HTML))
    assert title.textFormat() == QtCore.Qt.PlainText
    dock.hide()


def test_middle_of_a_long_label_is_left_out_of_sentences():
    label = "Roughing of the pocket on the left side, with the long end mill"
    assert plain_text.shortened(label) == "Roughing of the pock…th the long end mill"
    assert plain_text.shortened(label[:40]) == label[:40]


@pytest.fixture
def trap(tmp_path, window):
    """Return a label that is HTML with a red picture of 60 x 60 pixels."""
    picture = QtGui.QPixmap(60, 60)
    picture.fill(QtGui.QColor("#ff0000"))
    assert picture.save(str(tmp_path / "red.png"))
    return f"<img src='{(tmp_path / 'red.png').as_uri()}'>"


def is_shown_as_it_is(html, text):
    """Return whether Qt shows this tooltip as plain text."""
    document = QtGui.QTextDocument()
    document.setHtml(html)
    shown = document.toPlainText()
    return html.startswith("<p ") and text in shown and "\ufffc" not in shown  # Qt shows a picture as this character


def test_tooltips_show_labels_as_text(opened, window, trap):
    face = opened.getObjectsByLabel("Face")[0]
    face.Label = trap
    face.ToolController.Label = f"{trap} tool"
    face.ToolController.Tool.Diameter = 0
    window.click("Analyze Toolpaths")
    window.wait(lambda: "⟦" in face.Label2)
    window.dismiss()
    model = window.show_results().model
    job = model.index(0, 0)
    row = next(i for i in range(model.rowCount(job)) if model.index(i, 0, job).data() == trap)
    tooltips = [model.index(row, column, job).data(QtCore.Qt.ToolTipRole) for column in range(model.columnCount())]
    assert is_shown_as_it_is(tooltips[0], trap) and is_shown_as_it_is(tooltips[5], trap)
    assert all(tooltip == "" or "<img" not in tooltip for tooltip in tooltips)
    assert is_shown_as_it_is(window.tooltip(trap), trap)


def test_message_boxes_show_html_as_text(window, trap):
    for show in (plain_text.inform, plain_text.warn):
        box = show("Title", trap, window.main)
        assert (box.text(), box.textFormat(), box.isModal()) == (trap, QtCore.Qt.PlainText, False)
    assert window.dismiss() == [trap, trap]


def test_preferences_show_the_processor_name_as_text(window, trap, monkeypatch):
    monkeypatch.setattr(calibration, "processor", lambda: trap)
    monkeypatch.setattr(calibration, "load", lambda: calibration.Calibration(Speed(), "2026-01-01"))
    page = preferences_page.PreferencesPage()
    page.loadSettings()
    label = page.form.calibrated
    assert trap in label.text() and label.textFormat() == QtCore.Qt.PlainText
    page.form.deleteLater()


def test_label_with_whole_text_is_as_high_as_the_text(window):
    box = QtGui.QWidget()
    column = QtGui.QVBoxLayout(box)
    label = QtGui.QLabel("What it says takes several lines where there is little room. " * 4)
    label.setWordWrap(True)
    whole = plain_text.WholeText(label)
    column.addWidget(label)
    column.addStretch(1)
    try:
        heights = []
        for width in (160, 900):
            box.resize(width, 600)
            box.show()
            window.settle()
            heights.append(label.height())
            assert label.height() >= label.heightForWidth(label.width())
        label.setText("Short.")
        whole.fit()
        window.settle()
        line = label.fontMetrics().lineSpacing()
        assert heights[0] > 3 * line and heights[1] < heights[0] / 2 and label.height() < 2 * line
    finally:
        box.hide()  # an open message box would cover the window until Qt deletes the box
        box.deleteLater()
