# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the legacy simulator's panel takes beyond cutting and making meshes: what it costs, and learning it from runs.

A fast-forward starts once, takes a tick of a timer for every command and repaints for every new percent of its
progress. A play redraws the window for every command, and every triangle of its mesh.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from vkworkbench.core.simulators.constants import DEFAULTS, Constants
from vkworkbench.core.simulators.simulator import Lesson

_PERCENTS = 100
# How far the constants usually lie from the defaults, and what they are at least (the tick is that of a timer of 1 ms),
# s: start, tick and repaint of fast-forward; redraw and display of play.
_USUAL_FAST_FORWARD, _LEAST_FAST_FORWARD = np.array([0.5, 0.3e-3, 0.02]), np.array([0.0, 1e-3, 0.0])
_USUAL_PLAY, _LEAST_PLAY = np.array([0.03, 1e-6]), np.array([1e-3, 0.0])
# Commands of a fast-forward that tells how long a tick is; a shorter one is mostly start and repaint.
_LONG = 500
# The weight of the defaults against a run.
_PRIOR = 0.02
# Relative errors below this count as equal, and rounds of the reweighting.
_EXACT = 0.05
_ROUNDS = 30
# How often the short fast-forwards are looked at with the tick that the long ones told.
_ROUNDS_OF_TICK = 5
_SHORTEST_PLAY = 20  # commands


def panel_seconds(constants: Constants, commands: int) -> float:
    """What fast-forward takes beyond cutting, tool profile and mesh, s.

    Parameters
    ----------
    constants : Constants
    commands : int
        Comments included.
    """
    return float(_work(commands) @ _of(constants))


def fit_fast_forward(commands: np.ndarray, seconds: np.ndarray) -> tuple[float, float, float]:
    """Find start, tick and repaint that explain real fast-forwards.

    Short ones have no say in the tick: what makes them differ by a fifth of a second would make a tick wrong that long
    ones have thousands of.

    Parameters
    ----------
    commands : (k,) ndarray
    seconds : (k,) ndarray
        What each run took beyond cutting, tool profile and mesh.

    Returns
    -------
    start, tick, repaint : float
        s, as in :class:`Constants`.
    """
    work, ticks = _work(commands), np.where(commands >= _LONG, commands, 0)
    default, usual, least = _of(DEFAULTS), _USUAL_FAST_FORWARD, _LEAST_FAST_FORWARD
    voting = np.column_stack((work[:, 0], ticks, work[:, 2]))
    found = tuple(default.tolist())
    for _ in range(_ROUNDS_OF_TICK):
        found = _fit(voting, seconds - found[1] * (commands - ticks), seconds, default, usual, least)
    return found


def fit_play(
    shown: np.ndarray, drawn: np.ndarray, display_seconds: np.ndarray, seconds: np.ndarray
) -> tuple[float, float]:
    """Find redraw and display that explain real plays.

    Parameters
    ----------
    shown, drawn : (k,) ndarray
        Commands, and triangles of all their meshes.
    display_seconds, seconds : (k,) ndarray
        What each run took to show them, as far as the rest is known, and in all.

    Returns
    -------
    redraw, display : float
        s, as in :class:`Constants`.
    """
    work, default = np.stack((shown, drawn), axis=-1), np.array([DEFAULTS.redraw, DEFAULTS.display])
    return _fit(work, display_seconds, seconds, default, _USUAL_PLAY, _LEAST_PLAY)


def _fit(work, part_seconds, seconds, default, usual, least) -> tuple[float, ...]:
    """Find what units of work cost, from the work of k runs, the part of their time that it took, and that time.

    Least absolute deviations by reweighted least squares (Schlossmacher 1973), so that an odd run does no harm, from
    the runs, relative to their time or to the time found if that is more, and from the defaults: runs of one kind
    tell one number.
    """
    found = default / usual
    for _ in range(_ROUNDS):
        longer = work @ (found * usual) - part_seconds
        scale = seconds + np.maximum(longer, 0)
        weight = 1 / (scale * np.sqrt(np.maximum(np.abs(longer) / scale, _EXACT)))
        prior = np.sqrt(_PRIOR / np.maximum(np.abs(found - default / usual), 1))
        rows = np.vstack((work * usual * weight[:, None], np.diag(prior)))
        found = np.linalg.lstsq(rows, np.concatenate((part_seconds * weight, prior * default / usual)), rcond=None)[0]
    return tuple(np.maximum(found * usual, least).tolist())


def _work(commands: int | np.ndarray) -> np.ndarray:
    """How often start, tick and repaint are due: (3,), or (k, 3) for k runs."""
    return np.stack((np.ones_like(commands), commands, np.minimum(commands, _PERCENTS)), axis=-1)


def _of(constants: Constants) -> np.ndarray:
    return np.array([constants.start, constants.tick, constants.repaint])


def _fast_forward_of(cost, seconds: float, constants: Constants) -> tuple[int, float] | None:
    """Commands of a fast-forward and what it took beyond cutting; None where it was faster than it can be."""
    panel = seconds - cost.fast_forward_seconds + cost.panel_seconds
    return (cost.commands, panel) if panel > 0 else None


def _play_of(cost, seconds: float, constants: Constants) -> tuple[int, float, float, float] | None:
    """Commands and triangles of a play, what it took to show them, and in all; None where it was too short."""
    if cost.shown < _SHORTEST_PLAY:
        return None
    return cost.shown, cost.drawn, seconds - cost.play_seconds + cost.display_seconds, seconds


def _fast_forwards(runs: Sequence, constants: Constants) -> dict[str, float]:
    return dict(zip(("start", "tick", "repaint"), fit_fast_forward(*np.array(runs).T)))


def _plays(runs: Sequence, constants: Constants) -> dict[str, float]:
    return dict(zip(("redraw", "display"), fit_play(*np.array(runs).T)))


def _read_numbers(count: int):
    """How a run is read of which the file has so many numbers, the first of them whole."""
    return lambda run: (int(run[0]), *(float(run[k]) for k in range(1, count)))


LESSONS = (
    Lesson("fast-forward", _fast_forward_of, _read_numbers(2), _fast_forwards),
    Lesson("play", _play_of, _read_numbers(4), _plays),
)
