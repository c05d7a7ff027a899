# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the reliability of verdicts: accuracy in the paper's two classes, and calibration of the confidence."""

from __future__ import annotations

import numpy as np

from vkworkbench.core import Family, Strategy

BACK_AND_FORTH = {s.value for s in Strategy if s.family is Family.ROWS}
# The strategy adaptive is in neither of the paper's two classes.
AROUND = {s.value for s in Strategy if s.family is Family.AROUND} - {"adaptive"}
HIGH = 0.9  # a confidence of at least this counts as high


def two_class(strategy: str, accepted: set[str], got: str) -> bool | None:
    """Return whether the strategy `got` is accepted, or is in the right class: rows, or contours around an area.

    The result is None if the right strategy is neither in rows nor contours around an area.
    """
    if not (accepted <= BACK_AND_FORTH or strategy in {"contour-parallel", "spiral", "waterline"}):
        return None
    return got in accepted or got in (BACK_AND_FORTH if strategy in BACK_AND_FORTH else AROUND)


def how_sure(confidence: np.ndarray, right: np.ndarray) -> str:
    """Return a text on how well the confidences (n,) agree with whether the verdicts are right (n,) bool."""
    high = right[confidence >= HIGH]
    return (
        f"calibration error {calibration_error(confidence, right):.3f}; "
        f"where it says {HIGH} and more, {high.mean() if len(high) else 0:.3f} of {len(high)} are right"
    )


def calibration_error(confidence: np.ndarray, right: np.ndarray, bins: int = 10) -> float:
    """Return the expected calibration error: the weighted mean of |confidence - share of right verdicts| over bins.

    The bins have equal widths, and the weight of a bin is the number of its verdicts.
    """
    of = np.minimum((confidence * bins).astype(int), bins - 1)
    errors = [(of == k).mean() * abs(confidence[of == k].mean() - right[of == k].mean()) for k in set(of.tolist())]
    return float(sum(errors))
