# SPDX-License-Identifier: LGPL-2.1-or-later
"""The growth and the size of the largest image within a budget."""

from __future__ import annotations

from collections.abc import Callable
from math import log2, sqrt

from vkworkbench.core.view import LONGEST_SIDE, MOST_PIXELS, Frame, View

# Largest growth, as a power of two.
_LARGEST_GROWTH = 40


def growth_within(taken: Callable[[float], float], allowed: float, least: float) -> float:
    """Return the largest growth of the number of pixels within a budget, by bisection; 0 if `least` is already too large.

    `taken` returns the time or memory for a growth, and must not decrease.
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
    """Return width and height of an image with at most `growth` times as many pixels, at least one, and about the same shape.

    The image is no larger than a `View` may be.
    """
    largest = MOST_PIXELS / (image.width * image.height), (LONGEST_SIDE / max(image.width, image.height)) ** 2
    growth = min(growth, *largest)
    pixels = growth * image.width * image.height
    # The shorter side is at least one pixel, which limits the longer side of a strip.
    width = max(1, int(image.width * sqrt(growth)))
    height = max(1, int(min(image.height * sqrt(growth), pixels / width)))
    return max(1, int(min(width, pixels / height))), height
