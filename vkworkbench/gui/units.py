# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lengths as FreeCAD shows them: in the units and with the decimals of its preferences."""

from __future__ import annotations

import FreeCAD


def length(millimetres: float) -> str:
    """Return a length, e.g. ``"12.50 mm"`` or ``"0.49 in"``."""
    return FreeCAD.Units.Quantity(float(millimetres), FreeCAD.Units.Length).UserString
