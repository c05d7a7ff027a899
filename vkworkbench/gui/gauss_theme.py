# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that are readable on what is drawn behind them: those of the Gauss map, and what texts are drawn on."""

from __future__ import annotations

from dataclasses import dataclass

from vkworkbench.gui.qt import QColor, QPalette

_TEXT, _LINE = 4.6, 3.1  # contrasts, a little above what WCAG 2.1 asks of texts and of lines
_STEP = 0.04  # of the way to white or to black
_LIGHT, _DARK = QColor("#ffffff"), QColor("#1e1e1e")


@dataclass(frozen=True)
class Theme:
    """Names of colours.

    Attributes
    ----------
    back : str
        Of the window behind the picture.
    text : str
        Also of the area that is shown.
    faint : str
        Of levels and of the rest of the toolpath.
    v : str
        Of V_k and its angle.
    counter_clockwise, clockwise : str
        Told apart also by the colour-blind.
    """

    back: str
    text: str
    faint: str
    v: str
    counter_clockwise: str
    clockwise: str


def theme_on(back: QColor) -> Theme:
    """Return the colours for a background."""
    inks = ("#303030", "#808080", "#009e73", "#0072b2", "#d55e00")
    least = (_TEXT + 2, _LINE, _TEXT, _TEXT, _TEXT)
    return Theme(back.name(), *(readable(QColor(ink), back, contrast) for ink, contrast in zip(inks, least)))


def readable(ink: QColor, back: QColor, least: float = _TEXT) -> str:
    """Return a colour, made lighter or darker until its contrast with the background is enough."""
    end = max((QColor("white"), QColor("black")), key=lambda color: contrast(color, back))
    share = 0.0
    while share < 1 and contrast(ink, back) < least:
        share += _STEP
        mixed = [min(a + (b - a) * share, 1.0) for a, b in zip(ink.getRgbF()[:3], end.getRgbF()[:3])]
        ink = QColor.fromRgbF(*mixed)
    return ink.name()


def paper(palette: QPalette) -> QColor:
    """Return what a widget paints its text on: its own base, where the text can be read on it.

    A style sheet may set the colour of texts alone, as that of FreeCAD 1.1's themes does: light ones, and the base is white.
    """
    text, own = palette.text().color(), palette.base().color()
    if contrast(text, own) >= _LINE:
        return own
    return max((_LIGHT, _DARK), key=lambda color: contrast(text, color))


def contrast(one: QColor, other: QColor) -> float:
    """Return the contrast of two colours, 1..21 (WCAG 2.1)."""
    darker, lighter = sorted((_luminance(one), _luminance(other)))
    return (lighter + 0.05) / (darker + 0.05)


def _luminance(color: QColor) -> float:
    linear = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in color.getRgbF()[:3]]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
