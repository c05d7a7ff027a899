# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page *General* in FreeCAD's preferences dialog. This module imports numpy only when the page is shown."""

from __future__ import annotations

from vkworkbench import freecad, preferences
from vkworkbench.gui.form_page import FormPage
from vkworkbench.gui.qt.names import QDate, QLocale, Qt
from vkworkbench.gui.qt.plain_text import WholeText, as_plain, warn
from vkworkbench.gui.qt.sentences import user
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, translate

# Title of the group of pages, from which FreeCAD derives the name of the icon preferences-toolpath_analysis.svg.
TITLE = QT_TRANSLATE_NOOP("QObject", "Toolpath Analysis")


class PreferencesPage(FormPage):
    """The page *General*."""

    def __init__(self, parent=None) -> None:
        super().__init__("preferences.ui")
        self._offer_simulators()
        as_plain(self.form.calibrated)
        self._whole = WholeText(self.form.calibrated)
        self.form.calibrate.clicked.connect(self._calibrate)

    def _offer_simulators(self) -> None:
        """List the simulators of this FreeCAD version, and hide the preferences of simulators that it does not have."""
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
        super().loadSettings()
        self._say_last_calibration()

    def _calibrate(self) -> None:
        from vkworkbench.gui.qt import progress
        from vkworkbench.report import Cancelled

        try:
            progress.calibrate(self.form)
        except Cancelled:
            pass  # after a cancelled calibration, the previous calibration stays valid
        except OSError as error:
            warn(translate("VkPreferences", "Calibrate"), str(error), self.form)
        self._say_last_calibration()

    def _say_last_calibration(self) -> None:
        self.form.calibrated.setText(self._last_calibration())
        self._whole.fit()

    def _last_calibration(self) -> str:
        from vkworkbench.core.simulators import DEFAULTS, LEGACY
        from vkworkbench.document.computer import calibration

        known = calibration.load()
        if known is None:
            return translate(
                "VkPreferences",
                "Never calibrated on this computer. The times of FreeCAD's simulators are right "
                "to within a factor of 2.",
            )
        text = translate(
            "VkPreferences",
            "Last calibrated on {date}. The times of the {simulator} are right to within a "
            "factor of {factor}. Measured on {processor}, display {renderer}.",
        )
        return text.format(
            date=_local_date(known.date), factor=user().number(DEFAULTS.legacy_factor, 2),
            simulator=user().simulator(LEGACY.name), processor=calibration.processor(),
            renderer=preferences.read().renderer or "?",
        )  # fmt: skip


def _local_date(iso: str) -> str:
    return QLocale().toString(QDate.fromString(iso, Qt.ISODate), QLocale.ShortFormat)
