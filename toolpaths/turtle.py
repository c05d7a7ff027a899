# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw Lindenmayer systems by turtle graphics."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

MOST = 4000  # steps


def grow(word: str, rules: Mapping[str, str], degrees: float, times: int, forward: str) -> np.ndarray:
    """Return the path of a turtle, (n, 2), that follows a word after `times` rewritings by the rules.

    The turtle moves one step at each letter in `forward`, and turns by `degrees` at "+" and "-".
    """
    for _ in range(times):
        word = "".join(rules.get(letter, letter) for letter in word)
    turn = np.cumsum([(letter == "+") - (letter == "-") for letter in word])
    step = np.exp(1j * np.radians(degrees) * turn)[[letter in forward for letter in word]][:MOST]
    at = np.append(0, np.cumsum(step))
    return np.column_stack([at.real, at.imag])
