# SPDX-License-Identifier: LGPL-2.1-or-later
"""A page in FreeCAD's preferences dialog. Each widget has the name of its preference."""

from __future__ import annotations

from dataclasses import fields
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui

from vkworkbench import preferences
from vkworkbench.preferences import Preferences

_FORMS = Path(__file__).resolve().parents[2] / "resources" / "ui"


class FormPage:
    """A page of the preferences dialog with a form. FreeCAD calls the page's methods to load and to save the values."""

    def __init__(self, file: str) -> None:
        self.form = Gui.PySideUic.loadUi(str(_FORMS / file))
        for preference in fields(Preferences):
            widget, limits = getattr(self.form, preference.name, None), preference.metadata
            if "least" in limits and widget is not None:
                widget.setProperty("minimum", limits["least"])
                widget.setProperty("maximum", limits["most"])

    def loadSettings(self) -> None:
        self.fill(preferences.read())
        self._shown = self.chosen()

    def saveSettings(self) -> None:
        """Save only the values that the user changed, because the form shows all values rounded, e.g. in inches."""
        now = self.chosen()
        preferences.write(**{name: value for name, value in now.items() if value != self._shown[name]})
        self._shown = now
        from vkworkbench.gui.tree import pills

        pills.show()

    def resetSettingsToDefaults(self) -> None:
        self.fill(Preferences())
        self._shown = self.chosen()
        preferences.write(**{name: getattr(Preferences(), name) for name, _ in self.widgets()})

    def fill(self, values: Preferences) -> None:
        """Show the values of preferences in the form."""
        for name, widget in self.widgets():
            value = getattr(values, name)
            if hasattr(widget, "setChecked"):
                widget.setChecked(value)
            elif hasattr(widget, "setCurrentIndex"):
                widget.setCurrentIndex(preferences.choices(name).index(value))
            else:
                widget.setProperty("value", _as_length(value) if _is_length(widget) else value)

    def chosen(self) -> dict:
        """Return the values in the form, by the names of the preferences."""
        chosen = {}
        for name, widget in self.widgets():
            if hasattr(widget, "isChecked"):
                chosen[name] = widget.isChecked()
            elif hasattr(widget, "currentIndex"):
                chosen[name] = preferences.choices(name)[widget.currentIndex()]
            else:
                chosen[name] = widget.property("rawValue" if _is_length(widget) else "value")
        return chosen

    def widgets(self):
        """Yield the names of the preferences on the page, and their widgets."""
        for preference in fields(Preferences):
            widget = getattr(self.form, preference.name, None)
            if widget is not None:
                yield preference.name, widget


def _is_length(widget) -> bool:
    return widget.property("rawValue") is not None


def _as_length(millimetres: float):
    """Return a length in FreeCAD's units, with four decimals."""
    quantity = FreeCAD.Units.Quantity(millimetres, FreeCAD.Units.Length)
    quantity.Format = {**quantity.Format, "Precision": 4}
    return quantity
