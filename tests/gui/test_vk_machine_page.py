# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page *Machine* in FreeCAD's preferences."""

import pytest
from PySide import QtCore, QtGui

import vkworkbench
from vkworkbench import preferences
from vkworkbench.core import MACHINES
from vkworkbench.document.marks import marks
from vkworkbench.gui import machine_page
from vkworkbench.gui.results import measured
from vkworkbench.gui.results.details import MEASURED
from vkworkbench.gui.tree.explanation import explanation
from vkworkbench.preferences import OWN, Preferences

TYPICAL = list(MACHINES)
pytestmark = pytest.mark.usefixtures("default_preferences")


@pytest.fixture
def page(window, nothing_swallowed):
    page = machine_page.MachinePage()
    page.loadSettings()
    page.form.show()
    yield page
    page.form.close()


def test_machine_page_has_no_machine_by_default(page):
    page.saveSettings()
    assert page.form.machine.currentIndex() == 0
    assert preferences.read() == Preferences() and preferences.read().planned_machine is None


@pytest.mark.parametrize("name", TYPICAL)
def test_typical_machine_fills_the_form(name, page):
    page.form.machine.setCurrentIndex(1 + TYPICAL.index(name))
    machine = MACHINES[name]
    assert page.form.rate_z.value() == pytest.approx(60 * machine.rates[2])
    assert page.form.acceleration_x.value() == machine.accelerations[0]
    page.saveSettings()
    assert preferences.read().machine == name and preferences.read().planned_machine == machine


def test_changed_value_is_saved_as_the_users_own_machine(page, window):
    page.form.machine.setCurrentIndex(1)
    page.form.acceleration_x.setValue(400)
    page.saveSettings()
    assert preferences.read().machine == OWN
    assert preferences.read().planned_machine.accelerations == (400.0, 250.0, 100.0)
    page.loadSettings()
    assert page.form.machine.currentIndex() == page.form.machine.count() - 1
    assert page.form.acceleration_x.value() == 400


def test_time_factor_keeps_the_typical_machine(page):
    page.form.machine.setCurrentIndex(1)
    page.form.time_factor.setValue(1.25)
    page.saveSettings()
    assert preferences.read().machine == TYPICAL[0] and preferences.read().planned_machine.factor == 1.25


@pytest.fixture
def paste(page, monkeypatch):
    """Return a function that pastes a text as grbl's settings, and returns the warnings."""

    def pasted(text):
        warnings = []
        answer = staticmethod(lambda *arguments: (text, True))
        monkeypatch.setattr(machine_page.QInputDialog, "getMultiLineText", answer)
        monkeypatch.setattr(machine_page, "warn", lambda *warning: warnings.append(warning))
        page.form.grbl.click()
        return warnings

    return pasted


def test_settings_of_grbl_fill_the_form(page, paste):
    assert paste("$11=0.02\n$110=1500\n$112=300\n$120=80") == []
    page.saveSettings()
    machine = preferences.read().planned_machine
    assert machine.rates == pytest.approx((25, 50, 5)) and machine.accelerations == (80.0, 250.0, 100.0)
    assert machine.deviation == 0.02


def test_text_that_is_not_from_grbl_is_refused(page, paste):
    before = page.chosen()
    ((_, text, _),) = paste("hello")
    assert "$110=3000" in text and page.chosen() == before


def test_machine_page_has_a_label_for_each_field(page, window):
    window.screenshot("preferences-machine")
    assert page.form.windowTitle() == "Machine"
    labels = {label.buddy().objectName() for label in page.form.findChildren(QtGui.QLabel) if label.buddy()}
    assert labels == {name for name, _ in page.widgets()}


def test_next_analysis_uses_the_machine(page, opened, window):
    constant = vkworkbench.analyze(opened)
    page.form.machine.setCurrentIndex(1)
    page.saveSettings()
    planned = vkworkbench.analyze(opened)
    pairs = [(a.machining_seconds, b.machining_seconds) for a, b in zip(constant.operations, planned.operations)]
    assert all(after > before > 0 for before, after in pairs)
    vkworkbench.mark(planned)
    face = opened.getObjectsByLabel("Face")[0]
    assert marks.read(face).machining_seconds == pytest.approx(planned.operations[0].machining_seconds)


def row_page(window, label):
    """Select an operation or job in the results, and return the panel and the text of its details."""
    panel = window.show_results()
    model = panel.tree.model()
    (index,) = model.match(model.index(0, 0), QtCore.Qt.DisplayRole, label, 1, QtCore.Qt.MatchRecursive)
    panel.tree.setCurrentIndex(index)
    window.settle()
    return panel, panel.details.toPlainText()


@pytest.mark.long
def test_measured_time_changes_the_time_factor(page, opened, window, monkeypatch):
    vkworkbench.mark(vkworkbench.analyze(opened))
    assert "At constant feed" in row_page(window, "Job")[1]
    assert "at constant feed" in explanation(marks.read(opened.Job), preferences.read())
    page.form.machine.setCurrentIndex(1)
    page.saveSettings()
    vkworkbench.mark(vkworkbench.analyze(opened))
    steps, before = opened.UndoCount, marks.read(opened.Job)
    panel, text = row_page(window, "Job")
    assert "constant feed" not in text and "tool changes and starts of the spindle take" in text
    assert "Tool changes and starts" in explanation(before, preferences.read())
    answers = iter([("soon", True), ("17:30", False), ("2:00:00", True)])
    monkeypatch.setattr(measured.QInputDialog, "getText", staticmethod(lambda *asked, **text: next(answers)))
    warnings = []
    monkeypatch.setattr(measured, "warn", lambda *warning: warnings.append(warning))
    for _ in range(2):
        panel._open(MEASURED)
        assert preferences.read().time_factor == 1.0
    panel._open(MEASURED)
    window.settle()
    assert len(warnings) == 1 and preferences.read().time_factor == pytest.approx(7200 / before.machining_seconds)
    assert marks.read(opened.Job).machining_seconds == pytest.approx(7200)
    assert "2:00:00" in row_page(window, "Job")[1] and opened.UndoCount == steps
    panel.hide()
