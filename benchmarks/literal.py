# SPDX-License-Identifier: LGPL-2.1-or-later
"""Measure the effect of each change to the paper's rule on the synthetic zigzags and contours of toolpaths/.

    python3 benchmarks/literal.py [SEEDS]

The script prints how many toolpaths of the paper's two classes are recognised rightly, wrongly, or not at all, by the
paper's own rule and after each change. docs/method.md explains the changes.
"""

import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from toolpaths import synthetic
from vkworkbench.core import Family, linearize, recognize
from vkworkbench.core.paper import TURN, level_of, monotonous_areas, paper_verdict

ROWS = {
    "zigzag": synthetic.zigzag,
    "zigzag with lifts": lambda rng: synthetic.zigzag(rng, lifted=True),
    "zigzag with a contour": lambda rng: synthetic.zigzag(rng, with_contour=True),
    "raster": synthetic.raster,
}
AROUND = {
    "contours, lifts between": synthetic.nested,
    "contours outward": lambda rng: synthetic.nested(rng, outward=True),
    "contours, clockwise": lambda rng: synthetic.nested(rng, ccw=False),
    "spiral": synthetic.spiral,
}


def phi_to_the_letter(alpha):
    """Return the paper's cumulative angular function (sections 3.1, 3.2). Rounding decides the sign of half turns."""
    turn = np.diff(alpha % TURN)
    turn = np.where(turn > np.pi, turn - TURN, np.where(turn < -np.pi, turn + TURN, turn))
    return np.append(0.0, np.cumsum(turn))


def told(low, high):
    """Return the class by the paper's two inequalities for phi: rows, around, or "" if neither inequality holds."""
    reached = max(high, -low)
    return "around" if reached > TURN + 1e-6 else "rows" if reached <= np.pi + 1e-6 else ""


def answers(toolpath):
    """Yield the answer of the paper's rule, and the answer after each change to the rule."""
    move = np.diff(toolpath.points[:, :2], axis=0)[~toolpath.rapid]
    move = move[np.hypot(*move.T) > 1e-9]
    phi = phi_to_the_letter(np.arctan2(move[:, 1], move[:, 0]))
    yield "literal, the whole operation", told(phi.min(), phi.max())
    areas = monotonous_areas(toolpath)
    own = areas.signature(int(np.argmax(areas.area_length)))
    phi = phi_to_the_letter(own.alpha)
    yield "its longest monotonous area", told(phi.min(), phi.max())
    yield "by its level n, truncated", "around" if np.trunc(phi / TURN).any() else "rows"
    yield "by its level n, rounded down", "around" if np.floor(phi / TURN).any() else "rows"
    verdict = paper_verdict(areas)
    yield "half turns without a sign", told(*verdict.phi_range)
    low, high = own.phi_range
    yield "with the closing turn", told(low, high)
    yield "a contour from 2 pi on, not beyond", "around" if level_of(max(high, -low)) else told(low, high)
    yield "phi's range, not its bounds", "around" if high - low > TURN - 1e-6 else "rows"
    family = recognize(toolpath).strategy.family
    yield "the recognition", {Family.ROWS: "rows", Family.AROUND: "around"}.get(family, "")


def main(seeds=20):
    """Print the table."""
    counts = {}
    for truth, kinds in (("rows", ROWS), ("around", AROUND)):
        for make in kinds.values():
            for seed in range(seeds):
                for step, answer in answers(linearize(make(np.random.default_rng(seed)))):
                    own = counts.setdefault(step, {"rows": [0, 0, 0], "around": [0, 0, 0]})[truth]
                    own[0 if answer == truth else 2 if not answer else 1] += 1
    print(f"{'':36}{'zigzags':>24}{'contours':>24}")
    print(f"{'':36}" + f"{'right':>8}{'wrong':>8}{'open':>8}" * 2)
    for step, own in counts.items():
        print(f"{step:36}" + "".join(f"{number:8}" for truth in own.values() for number in truth))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:2]))
