# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of the Gauss map, adapted to the background so that they are readable."""

from __future__ import annotations

from dataclasses import dataclass

from vkworkbench.gui.qt.colors import LINE_CONTRAST, TEXT_CONTRAST, readable
from vkworkbench.gui.qt.names import QColor


@dataclass(frozen=True)
class Theme:
    """The colours of the Gauss map, as ``"#rrggbb"``."""

    back: str  # colour of the background
    text: str  # colour of texts and of the shown area
    # Colour of the curve of the level n (number of whole turns), of the limits of phi, and of the toolpath outside the
    # shown area.
    faint: str
    v: str  # colour of V_k, the sum of the first k moves, and of its angle theta
    # counter_clockwise, clockwise: colours of the two senses of rotation, which colour-blind users can distinguish.
    counter_clockwise: str
    clockwise: str


def theme_on(back: QColor) -> Theme:
    """Return the colours for a background."""
    inks = ("#303030", "#808080", "#009e73", "#0072b2", "#d55e00")
    least = (TEXT_CONTRAST + 2, LINE_CONTRAST, *3 * (TEXT_CONTRAST,))
    return Theme(back.name(), *(readable(QColor(ink), back, contrast) for ink, contrast in zip(inks, least)))
