# SPDX-License-Identifier: LGPL-2.1-or-later
"""The strategies' names as the user reads them; documents, CSV and JSON keep the enum's values."""

from __future__ import annotations

from vkworkbench.core import Strategy
from vkworkbench.gui.text import translate


def strategy_name(strategy: Strategy) -> str:
    """Return the strategy's name in the user's language."""
    return {
        Strategy.ZIGZAG: translate("Strategy", "zigzag"),
        Strategy.ONE_WAY: translate("Strategy", "one-way"),
        Strategy.CONTOUR_PARALLEL: translate("Strategy", "contour-parallel"),
        Strategy.PROFILE: translate("Strategy", "profile"),
        Strategy.WATERLINE: translate("Strategy", "waterline"),
        Strategy.SPIRAL: translate("Strategy", "spiral"),
        Strategy.HELIX: translate("Strategy", "helix"),
        Strategy.ADAPTIVE: translate("Strategy", "adaptive"),
        Strategy.DRILLING: translate("Strategy", "drilling"),
        Strategy.ENGRAVING: translate("Strategy", "engraving"),
        Strategy.MIXED: translate("Strategy", "mixed"),
        Strategy.UNKNOWN: translate("Strategy", "unknown"),
        Strategy.EMPTY: translate("Strategy", "empty"),
    }[strategy]
