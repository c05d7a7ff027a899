# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draw a toolpath for each strategy of the guide, and print the guide's table of strategies.

    python3 docs/draw_strategies.py          # writes docs/pictures/strategies/*.svg

The toolpaths come from toolpaths/synthetic.py. If a toolpath is not recognised as its strategy, the script writes
nothing. The view is from the front, from above and a little from the side. Cutting moves have the strategy's colour,
which is visible on light and dark pages; rapids are grey and dashed.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from toolpaths import synthetic
from vkworkbench.core import Strategy, Toolpath, linearize, recognize

FOLDER = ROOT / "docs/pictures/strategies"
WIDTH, HEIGHT, MARGIN = 240, 180, 6  # size and margin of a picture
TURN, RISE = np.radians(20), np.radians(40)  # angles of the viewer from the front and from the horizon
NEAR = 1.5  # points in the image that are closer than this are drawn as one point
RAPID = "#8a8a8a"
# For each strategy, a function that makes toolpaths, and the seed whose path shows the pattern best.
MADE = {
    Strategy.ZIGZAG: (synthetic.zigzag, 5),
    Strategy.ONE_WAY: (synthetic.one_way, 5),
    Strategy.CONTOUR_PARALLEL: (synthetic.nested, 5),
    Strategy.PROFILE: (synthetic.profile, 0),
    Strategy.WATERLINE: (synthetic.waterline, 3),
    Strategy.SPIRAL: (synthetic.spiral, 2),
    Strategy.HELIX: (synthetic.helix, 5),
    Strategy.ADAPTIVE: (synthetic.adaptive, 2),
    Strategy.DRILLING: (synthetic.drilling, 1),
    Strategy.ENGRAVING: (synthetic.letters, 5),
    Strategy.MIXED: (synthetic.pocket_then_profile, 0),
}


def seen(points: np.ndarray) -> np.ndarray:
    """Return the positions (n, 2) of points (n, 3) in the image, x to the right and y down."""
    x, y, z = points.T
    c, s = np.cos(TURN), np.sin(TURN)
    return np.column_stack([c * x + s * y, -(np.sin(RISE) * (c * y - s * x) + np.cos(RISE) * z)])


def thinned(points: np.ndarray) -> list[np.ndarray]:
    """Return points (n, 2) without the inner points at a distance of at most NEAR from the preceding kept point."""
    kept = [points[0]]
    for point in points[1:-1]:
        if np.hypot(*(point - kept[-1])) > NEAR:
            kept.append(point)
    return [*kept, points[-1]]


def drawn(path: Toolpath, color: str) -> str:
    """Return the picture of a toolpath as SVG, from its first to its last cutting move."""
    first, last = np.flatnonzero(~path.rapid)[[0, -1]]
    points, rapid = seen(path.points[first : last + 2]), path.rapid[first : last + 1]
    low, size = points.min(axis=0), np.ptp(points, axis=0)
    scale = min((np.array([WIDTH, HEIGHT]) - 2 * MARGIN) / size)
    points = (points - low - size / 2) * scale + (WIDTH / 2, HEIGHT / 2)
    size = f'viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}"'
    text = [f'<svg xmlns="http://www.w3.org/2000/svg" {size} fill="none" stroke-width="1.2" stroke-linejoin="round">']
    ends = np.flatnonzero(np.diff(rapid)) + 1
    for begin, end in sorted(zip((0, *ends), (*ends, len(rapid))), key=lambda run: not rapid[run[0]]):
        style = f'stroke="{RAPID}" stroke-dasharray="2 3" stroke-width="0.8"' if rapid[begin] else f'stroke="{color}"'
        line = " ".join(f"{x:.1f},{y:.1f}" for x, y in thinned(points[begin : end + 1]))
        text.append(f'<path {style} d="M{line}"/>')
    return "\n".join([*text, "</svg>\n"])


def main() -> None:
    """Write the pictures, and print the table."""
    pictures = {}
    for strategy, (make, seed) in MADE.items():
        path = linearize(make(np.random.default_rng(seed)))
        found = recognize(path)
        if found.strategy is not strategy:
            sys.exit(f"{strategy}: recognised as {found.strategy}, {found.reason}")
        pictures[strategy] = drawn(path, strategy.color)
    FOLDER.mkdir(exist_ok=True)
    print("| | strategy | what it is |\n|---|---|---|")
    for strategy, picture in pictures.items():
        (FOLDER / f"{strategy}.svg").write_text(picture, encoding="utf-8")
        print(f"| ![{strategy}](pictures/strategies/{strategy}.svg) | **{strategy}** | {strategy.about} |")


if __name__ == "__main__":
    main()
