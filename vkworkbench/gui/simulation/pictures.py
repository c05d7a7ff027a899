# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures of the moment that is shown, drawn in a thread: the window goes on meanwhile, and so may the moment."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np

from vkworkbench.gui.qt.background import Background
from vkworkbench.gui.qt.names import QObject, Signal
from vkworkbench.gui.simulation.coloring import Entries
from vkworkbench.gui.simulation.drawing import Drawing, Drawn
from vkworkbench.gui.simulation.moment import Moment
from vkworkbench.gui.simulation.part_view import PartView

_LOOK = 3  # ms between two looks whether a picture has been drawn


class Pictures(QObject):
    """Shows the picture of a moment, and a new one whenever it has changed.

    Parameters
    ----------
    drawing : Drawing
    moment : Moment
    view : PartView

    Attributes
    ----------
    begun : Signal
        A picture of another moment, or of this one anew, was begun.
    failed : Signal of Exception
    """

    begun, failed = Signal(), Signal(object)

    def __init__(self, drawing: Drawing, moment: Moment, view: PartView, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._drawing, self._moment, self._view = drawing, moment, view
        self._background = Background(self, _LOOK)
        self._changed = False  # since the latest picture was begun
        self._legend: Callable[[], Entries] | None = None  # that is shown

    @property
    def is_current(self) -> bool:
        """Whether what is seen is the moment, as all is chosen."""
        return not (self._changed or self._background.works)

    def draw(self) -> None:
        """Draw the moment anew at the next `begin`, or when the picture that is being drawn is there."""
        self._changed = True

    def begin(self) -> None:
        """Begin a picture, where one is due and none is being drawn."""
        if not self._changed or self._background.works:
            return
        self._changed = False
        if self._drawing.simulation is None:
            return
        picture = self._drawing.picture(self._moment, self._view.background)
        show = partial(self._show, self._moment.tool_tip())
        self._background.start("", lambda _: [picture.draw()], show, self._ended)
        self.begun.emit()

    def show_now(self) -> None:
        """Show the moment at once, however long its picture takes."""
        self._background.give_up()
        self._changed = False
        picture = self._drawing.picture(self._moment, self._view.background)
        self._show(self._moment.tool_tip(), picture.draw())
        self.begun.emit()

    def end(self) -> None:
        """Draw no more."""
        self._background.give_up()

    def _show(self, tool: tuple[int, np.ndarray], drawn: Drawn) -> None:
        self._view.show_scene(drawn.scene, drawn.frame)
        number, tip = tool
        self._view.show_tool(self._drawing.job.cuts[number].tool, tip)
        if drawn.legend is not self._legend:
            self._legend = drawn.legend
            self._drawing.bar.legend.show_entries(drawn.legend())

    def _ended(self, error: Exception | None) -> None:
        if error is not None:
            self.failed.emit(error)
        self.begin()
