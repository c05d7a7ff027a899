# SPDX-License-Identifier: LGPL-2.1-or-later
"""The V_k vector method: directions, turns and phi of the trajectories (paper, sections 2 and 3).

Input: a `Toolpath`, or the vertices of a polyline.
Output: `Areas`, the monotonous areas with their directions, turns, phi and loops; the `Signature` of an area, with
levels, V_k and Gauss map; `PaperVerdict`, the strategy by the paper's own rule; the lines of the Gauss map's picture.
"""

from vkworkbench.core.paper.areas import Areas, monotonous_areas
from vkworkbench.core.paper.complexity import Complexity, complexity
from vkworkbench.core.paper.directions import TURN, axis_of, directions, farthest, level_of
from vkworkbench.core.paper.literal import PaperVerdict, paper_verdict
from vkworkbench.core.paper.loops import OFF_ROUND, closing_turns, is_closed, is_one_turn, winding_turns
from vkworkbench.core.paper.moves import turned
from vkworkbench.core.paper.picture import distinct, image_arcs, links, outline, overlapping, proof, thinned, turns_of
from vkworkbench.core.paper.signature import Signature, signature
from vkworkbench.core.paper.thresholds import TURNS

__all__ = [
    "OFF_ROUND", "TURN", "TURNS", "Areas", "Complexity", "PaperVerdict", "Signature", "axis_of", "closing_turns",
    "complexity", "directions", "distinct", "farthest", "image_arcs", "is_closed", "is_one_turn", "level_of",
    "links", "monotonous_areas", "outline", "overlapping", "paper_verdict", "proof", "signature", "thinned",
    "turned", "turns_of", "winding_turns",
]  # fmt: skip
