# SPDX-License-Identifier: LGPL-2.1-or-later
"""Labels that look like HTML are shown as they are."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

import vkworkbench
from vkworkbench.gui import progress

HTML = "<b>bold</b><img src='x.png'>"


def test_progress_shows_labels_as_text(opened, window, monkeypatch):
    seen = []

    def analyze(what, *, progress, cancelled):
        progress(0, 2, HTML)
        dialog = window.main.findChildren(QtGui.QProgressDialog)[-1]  # those of other tests end with the event loop
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
    window.click("Gauss map")
    title = window.main.findChild(QtGui.QDockWidget, "VkGaussMap").title
    window.wait(lambda: title.text().startswith(HTML))
    assert title.textFormat() == QtCore.Qt.PlainText
    window.click("Gauss map")
