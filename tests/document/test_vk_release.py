# SPDX-License-Identifier: LGPL-2.1-or-later
"""The release zip contains the files for users, and works when installed in a new home folder."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import FreeCAD
import pytest

RESOURCES = Path(__file__).resolve().parents[2] / "resources"
sys.path.append(str(RESOURCES))
import make_release

MACRO = """
import sys, traceback
import FreeCAD, Path
try:
    import vkworkbench
    document = FreeCAD.newDocument()
    op = document.addObject("Path::Feature", "Rows")
    y = [5.0 * (row // 2) for row in range(1, 40)]
    op.Path = Path.Path([Path.Command("G1", {"X": 60.0 * ((row // 2) % 2), "Y": y, "Z": -1.0, "F": 10.0})
                         for row, y in enumerate(y)])
    report = vkworkbench.analyze(document)
    print("FOUND", vkworkbench.__file__, report.operations[0].strategy, vkworkbench.mark(report))
except BaseException:
    traceback.print_exc()
sys.stdout.flush()
"""


@pytest.fixture(scope="module")
def archive(tmp_path_factory):
    return make_release.make_release(tmp_path_factory.mktemp("release"))


def test_release_has_only_the_files_for_users(archive):
    with zipfile.ZipFile(archive) as file:
        names = {name.split("/", 1)[1] for name in file.namelist()}
    assert {"InitGui.py", "Init.py", "package.xml", "LICENSE", "README.md", "vkworkbench/__init__.py"} <= names
    assert "vkworkbench/core/recognition/verdict/model.npz" in names
    assert any(name.endswith(".qm") for name in names) and any(name.endswith(".ui") for name in names)
    assert not any(name.startswith(("tests/", "benchmarks/", "toolpaths/", ".")) for name in names)
    # The zip contains the macros that the guide describes, but not the example job.
    assert {name for name in names if name.startswith("examples/")} == {
        f"examples/macros/{path.name}" for path in (RESOURCES.parent / "examples" / "macros").glob("*.py")
    }


def test_package_xml_has_the_repository_address(tmp_path):
    text = (RESOURCES.parent / "package.xml").read_text(encoding="utf-8")
    # Writing a repository address again replaces the former address.
    for place in (
        "https://example.org/one/first",
        "https://example.org/other/second.git/",
    ):
        text = make_release.with_urls(text, place, "trunk")
    place = "https://example.org/other/second"
    package = tmp_path / "package.xml"
    package.write_text(text, encoding="utf-8")
    urls = {url["type"]: url["location"] for url in FreeCAD.Metadata(str(package)).Urls}
    assert urls == {
        "repository": place,
        "bugtracker": f"{place}/issues",
        "readme": f"{place}/raw/trunk/README.md",
        "documentation": f"{place}/blob/trunk/docs/guide.md",
    }
    assert f'<url type="repository" branch="trunk">{place}</url>' in text
    for none in ("example.org/one", "https://example.org", 'https://example.org/"><x/>'):
        with pytest.raises(ValueError, match="is no address"):
            make_release.with_urls(text, none)


@pytest.mark.long
def test_release_script_writes_the_repository_address(tmp_path):
    for file in [*make_release.release_files(), Path("resources/make_release.py")]:
        (tmp_path / "checkout" / file).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(RESOURCES.parent / file, tmp_path / "checkout" / file)

    def release(*arguments):
        command = ["python3", str(tmp_path / "checkout/resources/make_release.py"), str(tmp_path), *arguments]
        return subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=300)

    refused = release("--repository", "http://example.org/owner/name")
    assert refused.returncode == 2 and "is no address such as https://" in refused.stderr
    assert not list(tmp_path.glob("*.zip"))
    untold = release()
    assert untold.returncode == 0 and "names no repository" in untold.stderr
    # The second release, made without an address, has the address of the first.
    for told in (
        release("--repository", "https://example.org/owner/name"),
        release(),
    ):
        assert (told.returncode, told.stderr) == (0, "")
        with zipfile.ZipFile(next(tmp_path.glob("*.zip"))) as file:
            package = Path(file.extract(f"{make_release.FOLDER}/package.xml", tmp_path))
        urls = {url["type"]: url["location"] for url in FreeCAD.Metadata(str(package)).Urls}
        assert set(urls) == {"repository", "bugtracker", "readme", "documentation"}
        assert all(url.startswith("https://example.org/owner/name") for url in urls.values())


def test_release_works_from_a_read_only_folder(archive, tmp_path):
    """The name of the folder has spaces and letters beyond ASCII; in all other tests it is ToolpathAnalysis."""
    home, folder = tmp_path / "Hæuser und Höfe", "Fräsen mit Überblick 刀具"
    places = [home / ".local/share/FreeCAD/Mod" / folder, home / ".local/share/FreeCAD/v1-1/Mod" / folder]
    for place in places:
        with zipfile.ZipFile(archive) as file:
            file.extractall(tmp_path / "unpacked")
        place.parent.mkdir(parents=True)
        (tmp_path / "unpacked" / make_release.FOLDER).rename(place)
        for path in [place, *place.rglob("*")]:
            path.chmod(path.stat().st_mode & ~0o222)
    before = sorted(home.glob(".local/share/FreeCAD/**/Mod/**/*"))
    (home / "run").mkdir(mode=0o700)
    macro = tmp_path / "macro.py"
    macro.write_text(MACRO)
    environment = {"HOME": str(home), "XDG_RUNTIME_DIR": str(home / "run"), "PATH": os.environ["PATH"],
                   "LC_ALL": "C.UTF-8"}  # fmt: skip
    done = subprocess.run(["freecadcmd", str(macro)], env=environment, stdin=subprocess.DEVNULL, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=300, check=False)  # fmt: skip
    assert "Traceback" not in done.stdout, done.stdout
    (found,) = [line for line in done.stdout.splitlines() if line.startswith("FOUND")]
    assert f"Mod/{folder}/" in found and found.endswith(" zigzag 1")
    written = [path for path in sorted(home.glob(".local/share/FreeCAD/**/Mod/**/*")) if path not in before]
    # Tests that run as root can write into read-only folders.
    assert all("__pycache__" in path.parts for path in written)
