# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pixels of pictures of the window, their colours, and the contrast between two colours."""

from __future__ import annotations

from collections import Counter

import numpy as np
from PySide import QtGui


def pixels(image):
    """Return the colours of a picture as an array of red, green, blue and alpha, (rows, columns, 4)."""
    image = image.convertToFormat(QtGui.QImage.Format_RGBA8888)
    return np.frombuffer(bytes(image.constBits()), np.uint8).reshape(image.height(), image.width(), 4)


def shows(image, color):
    """Return the pixels of a picture that have a colour, (rows, columns) bool."""
    return (pixels(image)[..., :3] == QtGui.QColor(color).getRgb()[:3]).all(axis=2)


def counted(image):
    """Return {colour: number of pixels} of a picture, for example {"#ff0000": 5}."""
    colors, counts = np.unique(pixels(image)[..., :3].reshape(-1, 3), axis=0, return_counts=True)
    return Counter({"#{:02x}{:02x}{:02x}".format(*color): int(count) for color, count in zip(colors.tolist(), counts)})


def luminance(color):
    """Return the relative luminance (WCAG 2.1)."""
    parts = [v / 12.92 if v <= 0.03928 else ((v + 0.055) / 1.055) ** 2.4 for v in QtGui.QColor(color).getRgbF()[:3]]
    return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]


def contrast(one, other):
    """Return the contrast between two colours (WCAG 2.1)."""
    darker, lighter = sorted((luminance(one), luminance(other)))
    return (lighter + 0.05) / (darker + 0.05)
