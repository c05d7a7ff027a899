# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the legacy simulator's panel takes in a fast-forward beyond cutting: what it costs, and learning it from runs.

It starts once, takes a tick of a timer for every command and repaints for every new percent of its progress.
"""

from __future__ import annotations

import numpy as np

from vkworkbench.core.simulators import DEFAULTS, Constants

_PERCENTS = 100
# How far start, tick and repaint usually lie from the defaults, and what they are at least, s (the tick is that of a
# timer of 1 ms); the weight of that against a run.
_USUAL = np.array([0.5, 0.2e-3, 0.02])
_LEAST = np.array([0.0, 1e-3, 0.0])
_PRIOR = 0.02
# Relative errors below this count as equal, and rounds of the reweighting.
_EXACT = 0.05
_ROUNDS = 30


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

    Least absolute deviations by reweighted least squares (Schlossmacher 1973), so that an odd run does no harm, of the
    relative errors, and of the defaults: runs of one length tell one number, and short ones nothing of the tick.

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
    relative, usual = _work(commands) * _USUAL / seconds[:, None], _of(DEFAULTS) / _USUAL
    weight, prior = np.ones(len(seconds)), np.full(3, np.sqrt(_PRIOR))
    for _ in range(_ROUNDS):
        rows = np.vstack((relative * weight[:, None], np.diag(prior)))
        found = np.linalg.lstsq(rows, np.append(weight, prior * usual), rcond=None)[0]
        weight = 1 / np.sqrt(np.maximum(np.abs(relative @ found - 1), _EXACT))
        prior = np.sqrt(_PRIOR / np.maximum(np.abs(found - usual), 1))
    return tuple(np.maximum(found * _USUAL, _LEAST).tolist())


def _work(commands: int | np.ndarray) -> np.ndarray:
    """How often start, tick and repaint are due: (3,), or (k, 3) for k runs."""
    return np.stack((np.ones_like(commands), commands, np.minimum(commands, _PERCENTS)), axis=-1)


def _of(constants: Constants) -> np.ndarray:
    return np.array([constants.start, constants.tick, constants.repaint])
