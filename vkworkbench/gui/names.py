# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strategies' names as the user reads them; documents, CSV and JSON keep the enum's values."""

from __future__ import annotations

import FreeCAD

from vkworkbench.core import Strategy


def strategy_name(strategy: Strategy) -> str:
    """Return the strategy's name in the user's language."""
    return FreeCAD.Qt.translate("Strategy", strategy.label)
