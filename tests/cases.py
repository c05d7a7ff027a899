# SPDX-License-Identifier: LGPL-2.1-or-later
"""Choose the cases of a parametrised test that run on every FreeCAD."""

from __future__ import annotations

import pytest


def first_everywhere(cases, number=1):
    """Return the cases, which are values or tuples of several values, as pytest's parameters.

    All but the first `number` are marked `long`.
    """
    return [
        pytest.param(*(case if isinstance(case, tuple) else (case,)), marks=pytest.mark.long if place >= number else ())
        for place, case in enumerate(cases)
    ]
