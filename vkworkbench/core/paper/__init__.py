# SPDX-License-Identifier: LGPL-2.1-or-later
"""The V_k vector method: what the directions of the trajectories say (paper, sections 2 and 3).

In: `Toolpath`, or the vertices of a polyline.
Out: `Moves`, the monotonous areas with directions, turns and phi; `Signature` of a polyline with levels, V_k and
the Gauss map; what the picture of them is drawn from.
"""

from vkworkbench.core.paper.areas import EXACT, TURN, Moves, axis_of, monotonous_areas, wrap
from vkworkbench.core.paper.picture import Areas, image_arcs, seen, thinned, turns_of
from vkworkbench.core.paper.signature import Signature, signature

__all__ = [
    "EXACT", "TURN", "Areas", "Moves", "Signature", "axis_of", "image_arcs", "monotonous_areas", "seen", "signature",
    "thinned", "turns_of", "wrap",
]  # fmt: skip
