# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute how many times as many pixels a budget allows, and the size of such an image."""

from __future__ import annotations

from collections.abc import Callable
from math import log2, sqrt

from vkworkbench.core.view import LONGEST_SIDE, MOST_PIXELS, Frame, View

# Largest growth that is considered, given as an exponent of 2; the growth is the factor for the number of pixels.
_LARGEST_GROWTH = 40


def growth_within(taken: Callable[[float], float], allowed: float, least: float) -> float:
    """Return the largest factor for the number of pixels that stays within a budget, by bisection.

    The factor for the number of pixels is called growth. `taken` returns the time or memory that a growth needs; a
    larger growth must not need less. The result is 0 if the smallest growth, `least`, already needs more than
    `allowed`.
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
    """Return width and height of an image with at most `growth` times as many pixels and about the same shape.

    The image has at least one pixel and stays within the size limits of `View`.
    """
    largest = MOST_PIXELS / (image.width * image.height), (LONGEST_SIDE / max(image.width, image.height)) ** 2
    growth = min(growth, *largest)
    pixels = growth * image.width * image.height
    # The shorter side of the image has at least one pixel. In a narrow image, the longer side must therefore be shorter
    # than its share of the growth would allow.
    width = max(1, int(image.width * sqrt(growth)))
    height = max(1, int(min(image.height * sqrt(growth), pixels / width)))
    return max(1, int(min(width, pixels / height))), height
