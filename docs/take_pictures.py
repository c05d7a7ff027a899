# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut the pictures of the documents out of the screenshots of the window tests.

    VKWORKBENCH_SCREENSHOTS=yes tests/run.sh gui 1.0.0
    python3 docs/take_pictures.py

Needs Pillow. docs/draw_strategies.py draws the pictures of the strategies.
"""

from __future__ import annotations

from pathlib import Path

from PIL import Image

ROOT = Path(__file__).resolve().parents[1]
SHOTS = ROOT / "build/tests/trixie/screenshots"
PICTURES = ROOT / "docs/pictures"

# The parts of the small window with the menu and with the results: left, top, right, bottom, pixels.
SMALL, WIDE, RESULTS = (0, 0, 1024, 700), (0, 0, 1280, 700), (466, 434, 1024, 669)
# Picture: screenshot, and the part of it that is shown if not all is shown.
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
    """Take each picture that there is."""
    for picture in sorted(PICTURES.glob("*.png")):
        name = picture.stem
        shot, box = TAKEN.get(name, (name, SMALL if name.startswith("simulation") else None))
        Image.open(SHOTS / f"{shot}-1.0.png").crop(box).save(picture, optimize=True)


main()
