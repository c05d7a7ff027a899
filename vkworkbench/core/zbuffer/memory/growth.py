# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much larger an image may become within a budget, and what size it then has."""

from __future__ import annotations

from collections.abc import Callable
from math import log2, sqrt

from vkworkbench.core.view import Frame, View

# No image grows by more than two to this.
_LARGEST_GROWTH = 40


def growth_within(taken: Callable[[float], float], allowed: float, least: float) -> float:
    """How many times as many pixels take what is allowed; 0 where even `least` times as many take more. By bisection.

    `taken` returns what that many times as many pixels take: the more pixels, the more.
    """
    if taken(least) > allowed:
        return 0.0
    low = high = log2(least)
    while high < _LARGEST_GROWTH and taken(2**high) <= allowed:
        low, high = high, high + 2
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if taken(2**middle) <= allowed else (low, middle)
    return 2**low


def size_of(image: View | Frame, growth: float) -> tuple[int, int]:
    """Return width and height of an image of no more than `growth` times as many pixels, one at least, of about its shape."""
    pixels = growth * image.width * image.height
    # A strip is no narrower than a pixel: its length follows from that.
    width = max(1, int(image.width * sqrt(growth)))
    height = max(1, int(min(image.height * sqrt(growth), pixels / width)))
    return max(1, int(min(width, pixels / height))), height
