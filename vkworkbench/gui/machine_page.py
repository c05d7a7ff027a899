# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page *Machine* in FreeCAD's preferences: machining times, travel and tool holder."""

from __future__ import annotations

from dataclasses import replace

from vkworkbench.gui.form_page import FormPage
from vkworkbench.gui.qt.names import QInputDialog
from vkworkbench.gui.qt.plain_text import warn
from vkworkbench.gui.qt.text import translate
from vkworkbench.preferences import OWN, Preferences, choices

# Names of the preferences with the values of a machine, except its time factor.
_VALUES = (
    "rate_x", "rate_y", "rate_z", "acceleration_x", "acceleration_y", "acceleration_z", "corner_deviation", "lookahead",
    "tool_change", "spindle_start",
)  # fmt: skip


class MachinePage(FormPage):
    """The page *Machine*. A chosen typical machine fills the form; changing a value chooses the user's own machine."""

    def __init__(self, parent=None) -> None:
        super().__init__("machine.ui")
        self._filling = False
        self.form.machine.currentIndexChanged.connect(self._fill_typical)
        self.form.grbl.clicked.connect(self._paste_grbl)
        for name in _VALUES:
            getattr(self.form, name).valueChanged.connect(lambda value: self._choose_own())

    def fill(self, values: Preferences) -> None:
        self._filling = True
        super().fill(values)
        self._filling = False

    def _fill_typical(self, index: int) -> None:
        name = choices("machine")[index]
        if not self._filling and name not in ("", OWN):
            self._fill_machine(name, Preferences(machine=name).planned_machine)

    def _choose_own(self) -> None:
        if not self._filling:
            self.form.machine.setCurrentIndex(choices("machine").index(OWN))

    def _fill_machine(self, name: str, machine) -> None:
        self.fill(Preferences(**self.chosen()).with_machine(name, machine))

    def _paste_grbl(self) -> None:
        title = translate("VkMachine", "grbl Settings")
        label = translate("VkMachine", "The lines that grbl answers to the command $$:")
        text, accepted = QInputDialog.getMultiLineText(self.form, title, label)
        if not accepted:
            return
        from vkworkbench.core import machine_of_grbl

        try:
            machine = machine_of_grbl(text, replace(Preferences(**self.chosen()), machine=OWN).planned_machine)
        except ValueError:
            warn(title, translate(
                "VkMachine", "There is no line such as $110=3000. Paste the lines that grbl answers to the command $$."
            ), self.form)  # fmt: skip
        else:
            self._fill_machine(OWN, machine)
