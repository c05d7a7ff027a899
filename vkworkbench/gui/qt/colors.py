# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours, and their contrast with the background. The colours of strategies are in core/strategy.py."""

from __future__ import annotations

from vkworkbench.gui.qt.names import QColor, QPalette

TEXT = "#ffffff"  # colour of texts on the colour of any strategy
TOTAL = "#62748d"  # background of the pill with a job's total
# Colours of the background and of the text of warnings and errors.
WARNING = ("#f9a825", "#1a1a1a")
ERROR = ("#c62828", "#ffffff")
BURDEN = {"NEAR": WARNING, "OVER": ERROR}  # colours of a simulation time that is near or over the time budget
RAPID = "#8c8c8c"
LINK = "#2f7fd6"  # colour of links, which `readable` adapts to the background
NOTE_SIGN, WARNING_SIGN, ERROR_SIGN = "#62748d", "#c77700", "#d9363e"

TEXT_CONTRAST, LINE_CONTRAST = 4.6, 3.1  # contrast ratios slightly above WCAG 2.1's minimum for text and for lines
_STEP = 0.04  # share of white or black that `readable` adds to a colour in each step
_LIGHT, _DARK = QColor("#ffffff"), QColor("#1e1e1e")


def readable(ink: QColor, back: QColor, least: float = TEXT_CONTRAST) -> str:
    """Return a colour, made lighter or darker until its contrast with the background is at least `least`."""
    end = max((QColor("white"), QColor("black")), key=lambda color: contrast(color, back))
    share = 0.0
    while share < 1 and contrast(ink, back) < least:
        share += _STEP
        mixed = [min(a + (b - a) * share, 1.0) for a, b in zip(ink.getRgbF()[:3], end.getRgbF()[:3])]
        ink = QColor.fromRgbF(*mixed)
    return ink.name()


def paper(palette: QPalette) -> QColor:
    """Return a background on which the text colour of a palette is readable: the base colour if possible.

    The style sheets of FreeCAD 1.1's themes can set a light text colour while the base colour stays white.
    """
    text, own = palette.text().color(), palette.base().color()
    if contrast(text, own) >= LINE_CONTRAST:
        return own
    return max((_LIGHT, _DARK), key=lambda color: contrast(text, color))


def contrast(one: QColor, other: QColor) -> float:
    """Return the contrast ratio of two colours, from 1 to 21 (WCAG 2.1)."""
    darker, lighter = sorted((_luminance(one), _luminance(other)))
    return (lighter + 0.05) / (darker + 0.05)


def _luminance(color: QColor) -> float:
    linear = [v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4 for v in color.getRgbF()[:3]]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
