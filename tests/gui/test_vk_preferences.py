# SPDX-License-Identifier: LGPL-2.1-or-later
"""The add-on's page in FreeCAD's preferences dialog."""

from dataclasses import replace

import FreeCAD
import FreeCADGui as Gui
import pytest
from cases import first_everywhere
from preferences_dialog import in_preferences
from PySide import QtCore, QtGui

from vkworkbench import freecad, preferences
from vkworkbench.document.computer import calibration
from vkworkbench.preferences import Preferences

CANCEL, OK = "Cancel", "OK"
pytestmark = pytest.mark.usefixtures("default_preferences")


def check(window, box):
    """Toggle a check box with the space key, because a click in the middle of the widget may miss box and text."""
    box.setFocus()
    window.press(box, QtCore.Qt.Key_Space)


@pytest.fixture
def with_page(window):
    """Return a function that opens the preferences, calls a function with the form, and presses a button."""

    def open_and(work, button=OK):
        def answer(dialog, form):
            try:
                work(form)
            finally:
                box = dialog.findChild(QtGui.QDialogButtonBox)
                texts = {b.text().replace("&", ""): b for b in box.buttons()}
                window.click_on(texts[button])

        in_preferences(window, answer)

    return open_and


def test_page_shows_defaults_and_keeps_changes(opened, with_page, window):
    def look(form):
        assert form.isVisible()
        assert form.image_width.value() == 800 and form.image_height.value() == 600
        assert form.tolerance.property("rawValue") == pytest.approx(0.01)
        assert form.view_direction.currentText() == "Top" and form.mark_simulator.currentIndex() == 0
        assert form.show_pills.isChecked() and not form.analyze_after_recompute.isChecked()
        assert form.memory_budget.value() == 1000 and form.time_budget.value() == 600
        window.screenshot("preferences")

    with_page(look)
    assert preferences.read() == Preferences()

    def change(form):
        form.image_width.selectAll()
        window.type(form.image_width, "1600")
        check(window, form.analyze_after_recompute)
        form.mark_simulator.setFocus()
        window.press(form.mark_simulator, QtCore.Qt.Key_Down)
        form.view_direction.setFocus()
        window.press(form.view_direction, QtCore.Qt.Key_End)
        edit = form.tolerance.findChild(QtGui.QLineEdit)
        edit.selectAll()
        window.type(edit, "0.005 mm")
        window.press(edit, QtCore.Qt.Key_Tab)

    with_page(change)
    expected = Preferences(image_width=1600, analyze_after_recompute=True, mark_simulator="z-buffer",
                           view_direction="Isometric", tolerance=0.005)  # fmt: skip
    assert preferences.read() == expected

    def look_again(form):
        assert form.image_width.value() == 1600 and form.analyze_after_recompute.isChecked()
        assert form.tolerance.property("rawValue") == pytest.approx(0.005)
        assert "0.005" in form.tolerance.findChild(QtGui.QLineEdit).text()
        check(window, form.show_pills)

    with_page(look_again, CANCEL)
    assert preferences.read() == expected


@pytest.mark.parametrize("schema", first_everywhere([3, 0, 5, 7]))  # unit schemas: inches, mm, two other imperial
def test_ok_button_keeps_unchanged_preferences_exactly(schema, with_page, window):
    before = Preferences(tolerance=0.0123, time_budget=33.37, legacy_accuracy=0.137, result_columns="length")
    preferences.write(tolerance=0.0123, time_budget=33.37, legacy_accuracy=0.137, result_columns="length")
    now, units = FreeCAD.Units.getSchema(), FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units")
    FreeCAD.Units.setSchema(schema)
    try:
        with_page(lambda form: None)
        assert preferences.read() == before
        with_page(lambda form: check(window, form.analyze_after_recompute))
        assert preferences.read() == replace(before, analyze_after_recompute=True)
    finally:
        FreeCAD.Units.setSchema(now)
        units.SetInt("UserSchema", now)


def test_preferences_page_shows_freecads_units(with_page, window):
    units = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Units")
    schema = FreeCAD.Units.getSchema()
    FreeCAD.Units.setSchema(3)  # unit schema "imperial decimal"
    try:
        texts = []
        with_page(lambda form: texts.append(form.tolerance.findChild(QtGui.QLineEdit).text()), CANCEL)
    finally:
        FreeCAD.Units.setSchema(schema)
        units.SetInt("UserSchema", schema)
    assert texts[0].endswith(("in", '"', "thou"))


@pytest.mark.long
def test_pills_can_be_switched_off(with_page, window, opened):
    from vkworkbench.gui.tree import column as tree
    from vkworkbench.gui.tree import pills

    pills.show()
    delegates = lambda: [type(v.itemDelegateForColumn(tree.DESCRIPTION)).__name__ for v in tree.trees()]  # noqa: E731
    assert "PillDelegate" in delegates()
    with_page(lambda form: check(window, form.show_pills))
    assert "PillDelegate" not in delegates()


@pytest.mark.long  # only this test really measures; other tests replace the measurement
def test_calibrate_button_measures_and_shows_the_date(with_page, restored_calibration, window):
    restored_calibration.unlink()
    seen = []

    def click(form):
        seen.append(form.calibrated.text())
        window.click_on(form.calibrate)
        window.wait(lambda: form.calibrated.text() != seen[0])
        seen.append(form.calibrated.text())
        window.settle()
        window.screenshot("preferences-calibrated")

    with_page(click)
    assert seen[0].startswith("Never calibrated") and seen[1].startswith("Last calibrated on")
    assert (
        calibration.load() is not None and calibration.processor() in seen[1] and preferences.read().renderer in seen[1]
    )
    with_page(lambda form: seen.append(form.calibrated.text()))
    assert seen[2] == seen[1]


@pytest.mark.parametrize("points", first_everywhere([14, 0]))
def test_fields_are_high_enough_in_freecads_dialog_size(points, with_page, window, default_speeds):
    """FreeCAD 1.x opens its dialog with 819 x 500 pixels for every page."""
    application = QtGui.QApplication.instance()
    before, larger, squeezed = application.font(), QtGui.QFont(application.font()), []
    larger.setPointSize(points or larger.pointSize())

    def look(form):
        window.click_on(form.calibrate)
        window.wait(lambda: form.calibrated.text().startswith("Last calibrated on"))
        form.window().resize(819, 500)
        window.settle()
        window.screenshot(f"preferences-819x500-{points}")
        for widget in form.findChildren(QtGui.QWidget):
            if widget.isVisible() and widget.objectName() in vars(Preferences()):
                # A theme may make combo boxes lower than their size hint.
                chooses = isinstance(widget, QtGui.QComboBox)
                least = widget.fontMetrics().height() if chooses else widget.sizeHint().height()
                squeezed.extend([widget.objectName()] * (widget.height() < least))
        if freecad.version() >= (1, 0):  # FreeCAD 0.20 makes the dialog so large that no page is scrolled
            (area,) = (one for one in form.window().findChildren(QtGui.QScrollArea) if one.isAncestorOf(form))
            squeezed.extend(["sideways"] * (area.horizontalScrollBar().maximum() > 0))
        label = form.calibrated
        squeezed.extend(["calibrated"] * (label.height() < label.heightForWidth(label.width())))

    application.setFont(larger)
    try:
        with_page(look, CANCEL)
    finally:
        application.setFont(before)
    assert squeezed == []


def test_failed_calibration_shows_a_message(with_page, window, monkeypatch):
    def fail(going_on):
        raise OSError("the folder cannot be written")

    monkeypatch.setattr(calibration, "calibrate", fail)

    def click(form):
        window.click_on(form.calibrate)
        said.extend(window.dismiss())

    said = []
    with_page(click)
    assert said == ["the folder cannot be written"]


def test_preferences_group_has_an_icon():
    assert not Gui.getIcon("preferences-toolpath_analysis").isNull()
