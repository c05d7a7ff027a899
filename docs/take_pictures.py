# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut the pictures of the documents out of the screenshots of the window tests.

    VKWORKBENCH_SCREENSHOTS=yes tests/run.sh gui 1.0.0
    python3 docs/take_pictures.py

The script needs Pillow. docs/draw_strategies.py draws the pictures of the strategies.
"""

from __future__ import annotations

from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
SHOTS = ROOT / "build/tests/trixie/screenshots"
PICTURES = ROOT / "docs/pictures"

# Parts of a screenshot (left, top, right, bottom, px): the small window, the window with a menu, and the results.
SMALL, WIDE, RESULTS = (0, 0, 1024, 700), (0, 0, 1280, 700), (466, 434, 1024, 669)
# For a picture, its screenshot, and the part of the screenshot that is shown; None for the whole screenshot.
TAKEN = {
    "panel": ("panel-why", None),
    "warning": ("warning-play", None),
    "simulation": ("simulation-small", SMALL),
    "simulation-rate": ("simulation-chips-2", SMALL),
    "simulation-crash-2": ("simulation-crash-2", WIDE),
    "simulation-save": ("simulation-save", WIDE),
    "simulation-results": ("simulation-results", RESULTS),
}


def main() -> None:
    """Write each picture that exists in the folder again."""
    for picture in sorted(PICTURES.glob("*.png")):
        name = picture.stem
        shot, box = TAKEN.get(name, (name, SMALL if name.startswith("simulation") else None))
        Image.open(SHOTS / f"{shot}-1.0.png").crop(box).save(picture, optimize=True)


main()
