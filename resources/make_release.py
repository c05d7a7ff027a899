# SPDX-License-Identifier: LGPL-2.1-or-later
"""Build the zip file of a release, without tests, benchmarks and the guide's pictures, and print its size.

    python3 resources/make_release.py [FOLDER] [--repository URL [--branch main]]     # FOLDER is build/ by default

The script does not need FreeCAD. The zip file contains one folder, which a user unpacks into FreeCAD's Mod folder; the
folder may be renamed. With --repository, the script writes the addresses of the repository, its issues, its README and
its guide into package.xml, where FreeCAD's Addon Manager reads them. The addresses have the form of GitHub's addresses.
"""

from __future__ import annotations

import argparse
import re
import sys
import zipfile
from pathlib import Path
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parent.parent
FOLDER = "ToolpathAnalysis"
SHIPPED = (
    "*.py", "package.xml", "*.md", "LICENSE", "docs/*.md", "vkworkbench/**/*.py", "vkworkbench/**/*.npz",
    "examples/macros/*.py", "resources/icons/*", "resources/ui/*", "resources/translations/*.qm",
)  # fmt: skip


def release_files() -> list[Path]:
    """Return the files of a release, relative to the checkout."""
    files = {path for pattern in SHIPPED for path in ROOT.glob(pattern)}
    shown = re.findall(r"\]\((docs/pictures/[^)]+)\)", (ROOT / "README.md").read_text(encoding="utf-8"))
    return sorted(path.relative_to(ROOT) for path in files | {ROOT / picture for picture in shown})


def with_urls(package: str, repository: str, branch: str = "main") -> str:
    """Return the text of package.xml with the addresses of another repository.

    Raises
    ------
    ValueError
        If `repository` is not a web address.
    """
    repository = re.sub(r"(\.git)?/*$", "", repository)
    if not re.fullmatch(r"https://[\w.-]+(/[\w.~-]+)+", repository):
        raise ValueError(f"{repository!r} is no address such as https://example.org/owner/name")
    urls = (
        f'  <url type="repository" branch="{branch}">{repository}</url>\n'
        f'  <url type="bugtracker">{repository}/issues</url>\n'
        f'  <url type="readme">{repository}/raw/{branch}/README.md</url>\n'
        f'  <url type="documentation">{repository}/blob/{branch}/docs/guide.md</url>\n'
    )
    bare = re.sub(r"  <url .*</url>\n", "", package)
    return bare.replace("  <icon>", f"{urls}  <icon>", 1)


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
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT / "build")
    parser.add_argument("--repository", metavar="URL")
    parser.add_argument("--branch", default="main")
    chosen = parser.parse_args()
    package = ROOT / "package.xml"
    text = package.read_text(encoding="utf-8")
    if chosen.repository:
        try:
            package.write_text(with_urls(text, chosen.repository, chosen.branch), encoding="utf-8")
        except ValueError as error:
            parser.error(str(error))
    elif "<url" not in text:
        print("package.xml names no repository: before you publish, run this with --repository", file=sys.stderr)
    made = make_release(chosen.folder)
    print(f"{made}: {made.stat().st_size / 1e3:.0f} kB, {len(release_files())} files")
