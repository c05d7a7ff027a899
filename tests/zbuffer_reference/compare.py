# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrays of depths compared at once: pytest.approx takes their numbers one by one."""

from __future__ import annotations

import numpy as np


def close(one, other, absolute, relative=0.0):
    """Whether two arrays of one shape differ nowhere by more than either of the tolerances, as with pytest.approx."""
    return one.shape == other.shape and bool(
        (np.abs(one - other) <= np.maximum(absolute, relative * np.abs(other))).all()
    )
