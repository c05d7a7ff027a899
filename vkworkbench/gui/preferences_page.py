# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page in FreeCAD's preferences for vkworkbench/preferences.py. Loads no numpy before it is shown."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import freecad, preferences
from vkworkbench.gui.qt.names import QDate, QLocale, Qt
from vkworkbench.gui.qt.plain_text import WholeText, as_plain, warn
from vkworkbench.gui.qt.sentences import user
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, translate
from vkworkbench.preferences import Preferences

UI = Path(__file__).resolve().parents[2] / "resources" / "ui" / "preferences.ui"
TITLE = QT_TRANSLATE_NOOP(
    "QObject", "Toolpath Analysis"
)  # title of the group; its icon is preferences-toolpath_analysis.svg


class PreferencesPage:
    """A page with a form that FreeCAD loads and saves."""

    def __init__(self, parent=None) -> None:
        self.form = Gui.PySideUic.loadUi(str(UI))
        for preference in fields(Preferences):
            widget, limits = getattr(self.form, preference.name, None), preference.metadata
            if "least" in limits and widget is not None:
                widget.setProperty("minimum", limits["least"])
                widget.setProperty("maximum", limits["most"])
        self._offer_simulators()
        as_plain(self.form.calibrated)
        self._whole = WholeText(self.form.calibrated)
        self.form.calibrate.clicked.connect(self._calibrate)

    def _offer_simulators(self) -> None:
        """List the simulators of this FreeCAD version, and hide preferences of missing ones."""
        from vkworkbench.core.simulators import LEGACY, OPENGL, SIMULATORS, available

        present = available(freecad.version())
        own = translate("VkPreferences", "FreeCAD's default ({simulator})")
        self.form.mark_simulator.addItem(own.format(simulator=user().simulator(freecad.own_simulator())))
        self.form.mark_simulator.addItems([user().simulator(simulator.name) for simulator in present])
        accuracy, quality = (
            translate("VkPreferences", "{simulator}: accuracy"),
            translate("VkPreferences", "{simulator}: quality"),
        )
        self.form.legacy_accuracy_label.setText(accuracy.format(simulator=user().simulator(LEGACY.name)))
        self.form.opengl_quality_label.setText(quality.format(simulator=user().simulator(OPENGL.name)))
        for simulator in SIMULATORS:
            if simulator not in present:
                for name in simulator.preferences:
                    getattr(self.form, name).hide()
                    getattr(self.form, f"{name}_label").hide()

    def loadSettings(self) -> None:
        self._show(preferences.read())
        self._say_last_calibration()

    def saveSettings(self) -> None:
        """Save changed values only: a number that the page shows rounded, for example in inches, is not changed."""
        now = self._chosen()
        preferences.write(**{name: value for name, value in now.items() if value != self._shown[name]})
        self._shown = now
        from vkworkbench.gui.tree import pills

        pills.show()

    def resetSettingsToDefaults(self) -> None:
        self._show(Preferences())
        preferences.write(**{name: getattr(Preferences(), name) for name, _ in self._widgets()})

    def _show(self, values: Preferences) -> None:
        for name, widget in self._widgets():
            value = getattr(values, name)
            if hasattr(widget, "setChecked"):
                widget.setChecked(value)
            elif hasattr(widget, "setCurrentIndex"):
                widget.setCurrentIndex(_choices(name).index(value))
            else:
                widget.setProperty("value", _as_length(value) if _is_length(widget) else value)
        self._shown = self._chosen()

    def _chosen(self) -> dict:
        chosen = {}
        for name, widget in self._widgets():
            if hasattr(widget, "isChecked"):
                chosen[name] = widget.isChecked()
            elif hasattr(widget, "currentIndex"):
                chosen[name] = _choices(name)[widget.currentIndex()]
            else:
                chosen[name] = widget.property("rawValue" if _is_length(widget) else "value")
        return chosen

    def _widgets(self):
        """Yield the names of the preferences on the page, and their widgets."""
        for preference in fields(Preferences):
            widget = getattr(self.form, preference.name, None)
            if widget is not None:
                yield preference.name, widget

    def _calibrate(self) -> None:
        from vkworkbench.gui.qt import progress
        from vkworkbench.report import Cancelled

        try:
            progress.calibrate(self.form)
        except Cancelled:
            pass  # the previous calibration stays
        except OSError as error:
            warn(translate("VkPreferences", "Calibrate"), str(error), self.form)
        self._say_last_calibration()

    def _say_last_calibration(self) -> None:
        self.form.calibrated.setText(self._last_calibration())
        self._whole.fit()

    def _last_calibration(self) -> str:
        from vkworkbench.core.simulators import LEGACY
        from vkworkbench.document.computer import calibration

        known = calibration.load(preferences.read().renderer)
        if known is None:
            return translate(
                "VkPreferences",
                "Never calibrated on this computer. The times of FreeCAD's simulators are right "
                "to within a factor of 2.",
            )
        text = translate(
            "VkPreferences",
            "Last calibrated on {date}. The times of the {simulator} are right to within a "
            "factor of {factor}. Measured with FreeCAD {freecad} on {processor}, display "
            "{renderer}.",
        )
        return text.format(
            date=_local_date(known.date), factor=user().number(known.constants.legacy_factor, 2),
            simulator=user().simulator(LEGACY.name), freecad=known.freecad, processor=known.processor, renderer=known.renderer or "?",
        )  # fmt: skip


def _choices(name: str) -> tuple[str, ...]:
    """Return the possible values of a preference, in the order of the form."""
    return next(preference.metadata["choices"]() for preference in fields(Preferences) if preference.name == name)


def _is_length(widget) -> bool:
    return widget.property("rawValue") is not None


def _as_length(millimetres: float):
    """Return a length in FreeCAD's units, with four decimals."""
    quantity = FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length)
    quantity.Format = {**quantity.Format, "Precision": 4}
    return quantity


def _local_date(iso: str) -> str:
    return QLocale().toString(QDate.fromString(iso, Qt.ISODate), QLocale.ShortFormat)
