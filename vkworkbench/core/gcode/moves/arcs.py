# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the centre, exact sweep and chords of G2/G3 arcs, for many arcs at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

KILOMETRE = 1e6  # mm; an arc with this radius or a larger radius is read as a line.
# Largest radius of an arc of more than half a turn, mm. An arc with a larger radius is read as a line, because rounding
# probably moved its centre to the wrong side of the chord.
LARGEST_CIRCLE = 1e4
# Rad, largest angle of a chord; with larger angles, the chords of tiny circles have too few directions.
LARGEST_STEP = np.pi / 4
SMALLEST_STEP = 1e-9  # rad, smallest angle of a chord; smaller chords would need too much memory.
SAME_POINT = 1e-6  # mm, largest distance between equal points; FreeCAD saves 6 decimals.
SAME_DIRECTION = 5e-7  # rad; an arc with a smaller sweep can be a full circle, as in grbl.
ROUNDED = 0.02  # mm, largest rounding error of an end point, for a program in inches with three decimals.


@dataclass(frozen=True)
class Arcs:
    """Geometry of m arcs; each arc is described in its own plane.

    Attributes
    ----------
    centre : (m, 2) float64
        Centre of each arc in its plane, mm.
    sweep : (m,) float64
        Exact angle from start to end, rad, counter-clockwise positive; 0 if the arc is read as a line.
    radius : (m, 2) float64
        Radius at the start and at the end, mm.
    degenerate : (m,) bool
        Whether the centre is missing or impossible, so that the arc is read as a line.
    """

    centre: np.ndarray
    sweep: np.ndarray
    radius: np.ndarray
    degenerate: np.ndarray

    @property
    def gap(self) -> np.ndarray:
        """Distance between the end point of each arc and the circle through its start point, (m,) mm."""
        return np.abs(self.radius[:, 1] - self.radius[:, 0])


def resolve(
    start: np.ndarray,
    end: np.ndarray,
    clockwise: np.ndarray,
    offset: np.ndarray,
    radius_word: np.ndarray,
    absolute_centre: np.ndarray,
) -> Arcs:
    """Compute the centre and the sweep of arcs from their centre words or their radius word.

    Parameters
    ----------
    start, end : (m, 2) float64
        End points of each arc in its plane, mm.
    clockwise : (m,) bool
        Whether each arc is clockwise (G2).
    offset : (m, 2) float64
        Centre words (I, J in G17), mm; NaN where absent.
    radius_word : (m,) float64
        R word, mm; NaN where absent, negative for more than half a turn.
    absolute_centre : (m,) bool
        Whether G90.1 is in force, so that the centre words are coordinates, not offsets from the start.
    """
    chord = end - start
    distance = np.hypot(chord[:, 0], chord[:, 1])
    by_centre = ~np.isnan(offset).all(axis=1)
    words = np.where(np.isnan(offset), np.where(absolute_centre[:, None], start, 0.0), offset)
    centre = np.where(absolute_centre[:, None], words, start + words)

    by_radius = ~by_centre & ~np.isnan(radius_word) & (distance > SAME_POINT)
    size = np.abs(radius_word)
    # A radius that is shorter than half the chord only because of rounding gives a half circle.
    by_radius &= size > 0.5 * distance - np.maximum(1e-3, 1e-4 * distance)
    height = np.sqrt(np.maximum(size**2 - 0.25 * distance**2, 0.0))
    left = np.where(clockwise == (radius_word < 0), 1.0, -1.0) * height / np.where(distance > SAME_POINT, distance, 1.0)
    from_radius = 0.5 * (start + end) + left[:, None] * np.column_stack([-chord[:, 1], chord[:, 0]])
    centre = np.where(by_radius[:, None], from_radius, centre)

    arm, arm_end = start - centre, end - centre
    radius = np.column_stack([np.hypot(arm[:, 0], arm[:, 1]), np.hypot(arm_end[:, 0], arm_end[:, 1])])
    angle = np.arctan2(arm_end[:, 1], arm_end[:, 0]) - np.arctan2(arm[:, 1], arm[:, 0])
    turn = 2 * np.pi
    sweep = np.where(clockwise, -((-angle) % turn), angle % turn)
    # An arc with centre words and almost no sweep is a full circle if its end point differs from its start point only
    # by rounding.
    radial = by_centre & (np.abs(sweep) <= SAME_DIRECTION)
    whole = (distance <= SAME_POINT) | (radial & (distance <= ROUNDED))
    sweep = np.where(whole, np.where(clockwise, -turn, turn), sweep)

    degenerate = ~(by_centre | by_radius) | ~(radius[:, 0] > SAME_POINT)
    flat = (radius[:, 0] >= KILOMETRE) | ((radius[:, 0] > LARGEST_CIRCLE) & (np.abs(sweep) > np.pi))
    return Arcs(centre, np.where(degenerate | flat, 0.0, sweep), radius, degenerate)


def chord_counts(arcs: Arcs, tolerance: float) -> np.ndarray:
    """Return the number of chords for each arc, (m,) int, at least 1.

    The chord error (sagitta) r (1 - cos(step / 2)) = 2 r sin(step / 4)^2 stays at or below `tolerance`, mm.
    """
    largest = np.maximum(arcs.radius.max(axis=1, initial=0.0), SAME_POINT)
    share = np.minimum(tolerance, largest) / (2 * largest)
    step = np.clip(4 * np.arcsin(np.sqrt(share)), SMALLEST_STEP, LARGEST_STEP)
    return np.maximum(np.ceil(np.abs(arcs.sweep) / step - 1e-9), 1).astype(np.int64)


def chords(
    arcs: Arcs,
    counts: np.ndarray,
    start: np.ndarray,
    end: np.ndarray,
    start_height: np.ndarray,
    end_height: np.ndarray,
) -> np.ndarray:
    """Return the end points of all chords in plane coordinates, (sum(counts), 3) mm.

    The radius changes linearly from its value at the start to its value at the end, so that the last chord ends exactly
    at the programmed end point.
    """
    arc = np.repeat(np.arange(len(counts)), counts)
    part = np.arange(len(arc)) - np.repeat(np.cumsum(counts) - counts, counts) + 1
    share = part / counts[arc]
    arm = start - arcs.centre
    angle = np.arctan2(arm[:, 1], arm[:, 0])[arc] + share * arcs.sweep[arc]
    radius = arcs.radius[arc, 0] + share * (arcs.radius[arc, 1] - arcs.radius[arc, 0])
    points = np.empty((len(arc), 3))
    points[:, 0] = arcs.centre[arc, 0] + radius * np.cos(angle)
    points[:, 1] = arcs.centre[arc, 1] + radius * np.sin(angle)
    points[:, 2] = start_height[arc] + share * (end_height - start_height)[arc]
    last = part == counts[arc]
    points[last, :2] = end
    points[last, 2] = end_height
    return points
