# SPDX-License-Identifier: LGPL-2.1-or-later
"""The time of the legacy simulator's panel beyond cutting and making meshes: predicted, and learned from real runs.

A fast-forward starts once, takes a tick of a timer for every command and repaints for every new percent of its
progress. A play redraws the window for every command, and every triangle of its mesh.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from vkworkbench.core.simulators.constants import DEFAULTS, Constants
from vkworkbench.core.simulators.real_runs import Lesson, Seen

_PERCENTS = 100
# How far the constants usually lie from their defaults, and their least values, s: of start, tick (a timer of 1 ms)
# and repaint in fast-forward; of redraw and display in play.
_USUAL_FAST_FORWARD, _LEAST_FAST_FORWARD = np.array([0.5, 0.3e-3, 0.02]), np.array([0.0, 1e-3, 0.0])
_USUAL_PLAY, _LEAST_PLAY = np.array([0.03, 1e-6]), np.array([1e-3, 0.0])
# The tick is found from fast-forwards of at least so many commands; shorter ones are mostly start and repaint.
_LONG = 500
# Weight of the defaults in the fit, compared with that of a run.
_PRIOR = 0.02
# Relative errors below this count as equal, and rounds of the reweighting.
_EXACT = 0.05
_ROUNDS = 30
# Rounds in which the ticks of short fast-forwards are taken off, as the long ones tell them.
_ROUNDS_OF_TICK = 5
_SHORTEST_PLAY = 20  # commands
_TIMER = 1e-3  # of fast-forward, s: a command waits for it at most so long


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

    The tick is found from long runs only. Short ones differ by a fifth of a second for other reasons, which would make
    the tick wrong, and long runs have thousands of ticks.

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
        Time of each run for redraw and display (the whole less what is predicted of the rest), and the whole, s.

    Returns
    -------
    redraw, display : float
        s, as in :class:`Constants`.
    """
    work, default = np.column_stack((shown, drawn)), np.array([DEFAULTS.redraw, DEFAULTS.display])
    redraw, display = _fit(work, display_seconds, seconds, default, _USUAL_PLAY, _LEAST_PLAY)
    return redraw, display


def _fit(
    work: np.ndarray,
    part_seconds: np.ndarray,
    seconds: np.ndarray,
    default: np.ndarray,
    usual: np.ndarray,
    least: np.ndarray,
) -> tuple[float, ...]:
    """Find the costs of the units of work of k runs, from the time that this work took and the whole time, (k,) s.

    Least absolute deviations by reweighted least squares (Schlossmacher 1973), so that one odd run does no harm. A
    run's error is relative to its time, or to the time fitted if that is longer. The distance from the defaults counts
    as well: runs of one kind determine only one number.
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
    """How often a fast-forward starts, ticks and repaints: (3,), or (k, 3) for k runs."""
    return np.stack((np.ones_like(commands), commands, np.minimum(commands, _PERCENTS)), axis=-1)


def _of(constants: Constants) -> np.ndarray:
    return np.array([constants.start, constants.tick, constants.repaint])


def _fast_forward_of(cost: Any, seen: Seen, constants: Constants) -> tuple[float, ...] | None:
    """Return a fast-forward's commands, its time beyond cutting and mesh and its whole time, s; None where none is left."""
    panel = seen.seconds - cost.fast_forward_seconds + cost.panel_seconds
    return (cost.commands, panel, seen.seconds) if panel > 0 else None


def _fast_forwards(runs: Sequence[Any], constants: Constants) -> dict[str, float]:
    commands, panel, _ = np.array(runs).T
    return dict(zip(("start", "tick", "repaint"), fit_fast_forward(commands, panel)))


def _fast_forward_ratio(run: tuple[float, ...], constants: Constants) -> float:
    commands, panel, seconds = run
    return (seconds - panel + panel_seconds(constants, int(commands))) / seconds


def _play_of(cost: Any, seen: Seen, constants: Constants) -> tuple[float, ...] | None:
    """Return commands, triangles, time of showing and whole time of a play, s; None where it was too short."""
    if cost.shown < _SHORTEST_PLAY:
        return None
    return cost.shown, cost.drawn, seen.seconds - cost.play_seconds + cost.display_seconds, seen.seconds


def _plays(runs: Sequence[Any], constants: Constants) -> dict[str, float]:
    return dict(zip(("redraw", "display"), fit_play(*np.array(runs).T)))


def _play_ratio(run: tuple[float, ...], constants: Constants) -> float:
    shown, drawn, display_seconds, seconds = run
    return (seconds - display_seconds + constants.redraw * shown + constants.display * drawn) / seconds


def _play_waits(cost: Any, constants: Constants) -> float:
    """Every command waits for the timer of the speed slider, and its picture for the screen."""
    return float(cost.shown * max(1 / cost.speed, constants.refresh))


LESSONS = (
    Lesson(
        "fast-forward", _fast_forward_of, 3, _fast_forwards,
        waits=lambda cost, constants: _TIMER * cost.commands, ratio=_fast_forward_ratio, factor="legacy_factor",
    ),
    Lesson("play", _play_of, 4, _plays, waits=_play_waits, ratio=_play_ratio),
)  # fmt: skip
