# SPDX-License-Identifier: LGPL-2.1-or-later
"""Build the add-on as its users get it, without tests, benchmarks and the pictures of the guide; print its size.

    python3 resources/make_release.py [FOLDER]       # build/ unless told; needs no FreeCAD

The zip holds one folder, to be unpacked into FreeCAD's Mod folder. It may have any name there.
"""

from __future__ import annotations

import re
import sys
import zipfile
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parent.parent
FOLDER = "ToolpathAnalysis"
SHIPPED = (
    "*.py", "package.xml", "*.md", "LICENSE", "docs/*.md", "vkworkbench/**/*.py",
    "examples/macros/*.py", "resources/icons/*", "resources/ui/*", "resources/translations/*.qm",
)  # fmt: skip


def release_files() -> list[Path]:
    """Return the files of a release, relative to the checkout."""
    files = {path for pattern in SHIPPED for path in ROOT.glob(pattern)}
    shown = re.findall(r"\]\((docs/pictures/[^)]+)\)", (ROOT / "README.md").read_text(encoding="utf-8"))
    return sorted(path.relative_to(ROOT) for path in files | {ROOT / picture for picture in shown})


def make_release(folder: Path) -> Path:
    """Write the zip of this version into `folder` and return its path."""
    package = ElementTree.parse(ROOT / "package.xml").getroot()
    version = package.findtext("{https://wiki.freecad.org/Package_Metadata}version")
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{FOLDER}-{version}.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for file in release_files():
            archive.write(ROOT / file, f"{FOLDER}/{file}")
    return path


if __name__ == "__main__":
    made = make_release(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build")
    print(f"{made}: {made.stat().st_size / 1e3:.0f} kB, {len(release_files())} files")
