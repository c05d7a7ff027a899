# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

import sys

import FreeCAD
import FreeCADGui
import pytest

import vkworkbench
from vkworkbench.document.marks import watcher


def test_main_window_of_freecad_is_there():
    assert FreeCADGui.getMainWindow().isVisible()


# The only modules of the add-on that FreeCAD's start may load. The modules that start with FreeCAD do not import numpy.
AT_START = {
    "vkworkbench", "vkworkbench.freecad", "vkworkbench.preferences", "vkworkbench.document",
    "vkworkbench.document.computer", "vkworkbench.document.computer.idle", "vkworkbench.document.marks", "vkworkbench.document.job", "vkworkbench.document.marks.properties", "vkworkbench.document.job.operations", "vkworkbench.gui", "vkworkbench.gui.qt.plain_text", "vkworkbench.gui.preferences_page", "vkworkbench.gui.form_page", "vkworkbench.gui.machine_page",
    "vkworkbench.gui.qt", "vkworkbench.gui.simulators", "vkworkbench.gui.qt.names", "vkworkbench.gui.qt.document_command", "vkworkbench.gui.qt.sentences", "vkworkbench.gui.simulators.panels", "vkworkbench.gui.simulators.watch", "vkworkbench.gui.qt.text", "vkworkbench.gui.qt.widgets", "vkworkbench.gui.workbench",
}  # fmt: skip


def test_start_loads_only_the_needed_modules():
    loaded = sys.modules_at_start
    ours = {name for name in loaded if name.partition(".")[0] == "vkworkbench"}
    # The preferences page needs sentences from the package `language`, which may therefore be loaded.
    ours = {name for name in ours if not name.startswith("vkworkbench.language")}
    assert "vkworkbench.gui.workbench" in ours
    assert ours <= AT_START
    assert "matplotlib" not in loaded


def test_switching_documents_does_not_compare_marks_again(opened, window, monkeypatch):
    vkworkbench.mark(vkworkbench.analyze(opened))
    window.settle()
    other = FreeCAD.newDocument("Other")
    FreeCAD.setActiveDocument(opened.Name)
    window.settle()
    compared = []
    monkeypatch.setattr(watcher, "comparing", lambda document, *_, **__: iter([compared.append(document.Name)]))
    for _ in range(3):
        FreeCAD.setActiveDocument(other.Name)
        FreeCAD.setActiveDocument(opened.Name)
        window.settle()
    assert compared == []
    # A new object could be a copy with a mark in the tree, so marks are compared again.
    opened.addObject("App::FeaturePython", "New")
    FreeCAD.setActiveDocument(other.Name)
    FreeCAD.setActiveDocument(opened.Name)
    window.wait(lambda: compared)
    assert compared == [opened.Name]
    FreeCAD.closeDocument(other.Name)
    FreeCAD.setActiveDocument(opened.Name)


def test_wait_fails_after_its_time_limit(window):
    """Many tests rely on `window.wait` to fail, because they assert the awaited condition in no other way."""
    with pytest.raises(AssertionError, match="in vain"):
        window.wait(lambda: False, seconds=0.05)
