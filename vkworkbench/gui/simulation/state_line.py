# SPDX-License-Identifier: LGPL-2.1-or-later
"""The line below the simulation: what it will cost, how far it is, what it took, and what is to be known of it."""

from __future__ import annotations

import traceback

import FreeCAD

from vkworkbench.core.zbuffer import Estimate
from vkworkbench.gui.qt.names import QWidget
from vkworkbench.gui.qt.plain_text import OneLine
from vkworkbench.gui.qt.sentences import sentence, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.simulation.refining import Refined, Refining
from vkworkbench.language import Message, Unusable


class StateLine(OneLine):
    """Says in a line what the simulation costs."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown = self._expected = ""

    def show_expected(self, cost: Estimate) -> None:
        """Say what the finest picture will cost, before it is begun."""
        self._expected = translate("Vk_Simulate", "finest picture in about {}, {}").format(
            user().time(cost.seconds), user().memory(cost.memory_bytes)
        )
        self._say(self._shown, self._expected)

    def show_progress(self, refining: Refining) -> None:
        """Say how far it is, and how long the finest picture still takes."""
        left, memory = refining.left()
        if left is not None:
            text = translate("Vk_Simulate", "finest picture in about {}, {}")
            self._expected = text.format(user().time(left), user().memory(memory))
        working = translate("Vk_Simulate", "Simulating… {}").format(user().share(refining.share))
        self._say(self._shown, ", ".join(filter(None, (working, self._expected))))

    def show_refined(self, done: Refined) -> None:
        """Say what the picture that is shown is, and what it took."""
        zbuffer = done.simulation.zbuffer
        self._shown = translate("Vk_Simulate", "{} × {} pixels of {}, {} traces, {}, simulated in {}").format(
            user().count(zbuffer.frame.width), user().count(zbuffer.frame.height),
            user().measure(zbuffer.frame.pixel, 2), user().count(done.traces), user().memory(zbuffer.peak.bytes()),
            user().time(done.seconds),
        )  # fmt: skip

    def show_end(self, remarks: tuple[Message, ...], error: Exception | None) -> None:
        """Say what is to be known of the simulation, and what ended it before its finest picture."""
        self._expected = ""
        self._say(self._shown, *map(sentence, remarks), *([told(error)] if error else []))

    def show_error(self, error: Exception) -> None:
        """Say what went wrong beside the simulation."""
        self._say(self._shown, told(error))

    def _say(self, *texts: str) -> None:
        self.show_text("   ".join(filter(None, texts)))


def told(error: Exception) -> str:
    """Return what is told of an error that ended the work."""
    if isinstance(error, Unusable):
        return sentence(error.what)
    FreeCAD.Console.PrintLog("".join(traceback.format_exception(type(error), error, error.__traceback__)))
    return sentence(Message("not-analysed", error=f"{type(error).__name__}: {error}"))
