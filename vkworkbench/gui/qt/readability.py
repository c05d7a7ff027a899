# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours that can be read on what is drawn behind them."""

from __future__ import annotations

from vkworkbench.gui.qt.names import QColor, QPalette

TEXT, LINE = 4.6, 3.1  # contrasts, a little above what WCAG 2.1 asks of texts and of lines
_STEP = 0.04  # of the way to white or to black
_LIGHT, _DARK = QColor("#ffffff"), QColor("#1e1e1e")


def readable(ink: QColor, back: QColor, least: float = TEXT) -> str:
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
    if contrast(text, own) >= LINE:
        return own
    return max((_LIGHT, _DARK), key=lambda color: contrast(text, color))


def contrast(one: QColor, other: QColor) -> float:
    """Return the contrast of two colours, 1..21 (WCAG 2.1)."""
    darker, lighter = sorted((_luminance(one), _luminance(other)))
    return (lighter + 0.05) / (darker + 0.05)


def _luminance(color: QColor) -> float:
    linear = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in color.getRgbF()[:3]]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
