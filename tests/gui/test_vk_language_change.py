# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user changes FreeCAD's language while the add-on's panels are open."""

import FreeCADGui as Gui
from PySide import QtCore, QtGui

from vkworkbench.gui.qt import docks


def texts_of(root):
    """Return the texts that a panel shows."""
    texts = [root.windowTitle()]
    for kind in (QtGui.QLabel, QtGui.QAbstractButton, QtGui.QLineEdit, QtGui.QComboBox):
        for one in root.findChildren(kind):
            texts += [getattr(one, name)() for name in ("text", "placeholderText", "currentText") if hasattr(one, name)]
    return texts


def test_change_of_language_translates_open_panels(marked, window):
    results = window.show_results()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(marked.getObjectsByLabel("Face")[0])
    window.click("Gauss Map")
    gauss = docks.find(docks.GAUSS_MAP)
    window.wait(lambda: gauss.title.text().startswith("Face"))
    english = set(texts_of(results) + texts_of(gauss))
    assert {"Toolpath Results", "Filter", "Gauss Map", "Save Picture…"} <= english
    try:
        Gui.setLocale("de")
        window.wait(lambda: results.windowTitle() != "Toolpath Results" and "Zickzack" in gauss.title.text())
        window.settle()
        shown = set(texts_of(results) + texts_of(gauss))
        assert not {text for text in shown & english if len(text) > 3}
        assert results.tree.model().rowCount()
        assert results.model.headerData(2, QtCore.Qt.Horizontal) != "Machining\nTime"
        assert "Warum?" in results.details.toPlainText()
    finally:
        Gui.setLocale("en")
        window.wait(lambda: results.windowTitle() == "Toolpath Results")
        window.settle()
        gauss.hide()
