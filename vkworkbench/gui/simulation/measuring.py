# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the distance between two points on the part, and the depth of a point below the top of the stock."""

from __future__ import annotations

import numpy as np

from vkworkbench.gui.qt.sentences import user
from vkworkbench.gui.qt.text import translate

_DIGITS = 4  # number of digits of a shown length


class Measuring:
    """The points that the user measures; `top` is the height of the top of the stock, mm."""

    def __init__(self, top: float) -> None:
        self._top = top
        self.points: tuple[np.ndarray, ...] = ()  # the measured points (3,), at most two, mm

    def add(self, point: np.ndarray) -> None:
        """Add a point to the measurement. A third point starts a new measurement."""
        self.points = (*self.points, point) if len(self.points) == 1 else (point,)

    def depth(self, point: np.ndarray) -> str:
        """Return the depth of a point below the top of the stock, as text."""
        return translate("Vk_Simulate", "Depth below the stock's top: {}").format(_length(self._top - point[2]))

    def text(self) -> str:
        """Return the measured distance as text; with fewer than two points, ask for the next click."""
        if not self.points:
            return translate("Vk_Simulate", "Measuring: click on the first point.")
        if len(self.points) == 1:
            next_point = translate("Vk_Simulate", "Click on the second point.")
            return f"{self.depth(self.points[0])}   {next_point}"
        apart = self.points[1] - self.points[0]
        return translate("Vk_Simulate", "Distance: {}   ΔX {}   ΔY {}   ΔZ {}").format(
            *map(_length, (np.linalg.norm(apart), *apart))
        )


def _length(millimetres: float) -> str:
    """Return a length as text, rounded to micrometres."""
    return user().measure(round(float(millimetres), 3) + 0.0, _DIGITS)
