# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute the paper's V_k vector method: directions and turns of trajectories, and phi, the sum of the turns.

The method is described in sections 2 and 3 of the paper. The input is a `Toolpath`, or the vertices of a polyline.
`Areas` contains the monotonous areas of a toolpath, with their directions, turns, phi and loops. `Signature` contains
the levels (numbers of whole turns), V_k and the Gauss map of one area. `PaperVerdict` contains the strategy by the
paper's own rule. The functions in `picture` compute the lines that the panel *Gauss Map* draws.
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
