# SPDX-License-Identifier: LGPL-2.1-or-later
"""One colour for each strategy, wherever it is shown: tree, panel, Gauss map, 3D view.

All have the same relative luminance, 0.17 (WCAG 2.1): white text on them has a contrast above 4.5, and they
stand out from light and from dark windows alike. A colour never stands alone: there is always the strategy's name.
"""

from __future__ import annotations

from vkworkbench.core import Strategy

COLORS: dict[Strategy, str] = {
    Strategy.ZIGZAG: "#1173d4",
    Strategy.ONE_WAY: "#037e96",
    Strategy.CONTOUR_PARALLEL: "#13851c",
    Strategy.PROFILE: "#b75804",
    Strategy.WATERLINE: "#038269",
    Strategy.SPIRAL: "#8b7003",
    Strategy.HELIX: "#507f0e",
    Strategy.ADAPTIVE: "#df2424",
    Strategy.DRILLING: "#9b4ed2",
    Strategy.ENGRAVING: "#d3258b",
    Strategy.MIXED: "#976851",
    Strategy.UNKNOWN: "#737373",
    Strategy.EMPTY: "#737373",
}
TEXT = "#ffffff"  # on any of them
TOTAL = "#62748d"  # of a job
RAPID = "#8c8c8c"
