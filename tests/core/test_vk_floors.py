# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check the imports of every file, including imports inside functions, against the layers of the package.

A layer is called a floor: a module imports only from its own floor and the floors below. A package with an ``__all__``
is called a room, and the package's public names are the room's face: other rooms import only these names. Imports form
no circles, and only the listed modules import FreeCAD, Qt or numpy.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

import pytest

pytestmark = pytest.mark.sources

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = "vkworkbench"
# The floors (layers of the package), from the lowest to the highest. Modules on one floor may import one another.
FLOORS = (
    ("language",),
    ("worker", "given"),
    ("core.toolpath", "core.strategy", "core.machine", "core.machining_time", "core.steady"),
    ("core.tool", "core.view", "core.hull", "core.solids", "core.stocks"),
    ("core.gcode",),
    ("core.paper",),
    ("core.recognition.thresholds",),
    ("core.recognition.patterns",),
    ("core.recognition.verdict",),
    ("core.recognition.programs",),
    ("core.recognition",),
    ("core.zbuffer.sweeps",),
    ("core.zbuffer.rays",),
    ("core.zbuffer.culling",),
    ("core.zbuffer.memory",),
    ("core.zbuffer.simulator",),
    ("core.zbuffer.findings", "core.zbuffer.cost"),
    ("core.zbuffer",),
    ("core.rendering",),
    ("core.simulators",),
    ("core",),
    ("report",),
    ("freecad",),
    ("preferences",),
    ("program",),
    ("document.computer", "document.job"),
    ("document.marks",),
    ("document.simulation",),
    ("document",),
    # The empty name is the package itself, with the names for macros, and `__main__` is the command line.
    ("", "__main__"),
    ("gui.qt",),
    ("gui.tree", "gui.gauss", "gui.strategies"),
    ("gui.results", "gui.simulation"),
    ("gui.simulators",),
    ("gui",),
)
# Third-party modules that a module may import. If several prefixes of a module's name are listed, the longest prefix
# applies.
OUTSIDE = {
    "": set(),
    "core": {"numpy"},
    "worker": {"numpy"},
    "given": {"numpy"},
    "report.simulation_facts": {"numpy"},
    "report.simulated_part": {"numpy"},
    "freecad": {"FreeCAD"},
    "preferences": {"FreeCAD"},
    "program": {"numpy", "distributed"},
    "document": {"numpy", "FreeCAD", "Mesh", "MeshPart", "Part", "Path"},
    "gui": {"numpy", "FreeCAD", "FreeCADGui", "pivy"},
    "gui.qt.names": {"PySide"},
}


def read(folder: str) -> dict[str, str]:
    """Return the source texts below a folder by module name, such as ``"vkworkbench.core.paper.areas"``."""
    found = {}
    for path in sorted((ROOT / folder).rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path.read_text(encoding="utf-8")
    return found


@lru_cache(maxsize=None)
def parsed(code: str) -> ast.Module:
    return ast.parse(code)


@lru_cache(maxsize=None)
def import_nodes(code: str) -> list[ast.Import | ast.ImportFrom]:
    """Return all imports of a file. Imports are statements, so the search skips expressions."""
    todo: list[ast.AST] = [parsed(code)]
    for node in todo:
        for part in ("body", "orelse", "handlers", "finalbody", "cases"):
            todo += getattr(node, part, ())
    return [node for node in todo if isinstance(node, (ast.Import, ast.ImportFrom))]


def names_of_face(code: str) -> set[str]:
    """Return the names in a package's ``__all__``, or an empty set if there is no ``__all__``."""
    for node in parsed(code).body:
        if isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "__all__":
            return {element.value for element in node.value.elts}
    return set()


class House:
    """Source files by module name, the public names of their packages, and a resolver for imported names."""

    def __init__(self, files: dict[str, str]) -> None:
        self.files = files
        packages = {name.rpartition(".")[0] for name in files if "." in name}
        faces = {name: names_of_face(files[name]) for name in packages if name in files}
        self.faces = {name: names for name, names in faces.items() if names and name != PACKAGE}

    def imports(self, code: str) -> Iterator[tuple[int, str]]:
        """Yield the line and module of each import. A name in a package's ``__all__`` counts as the package."""
        for node in import_nodes(code):
            if isinstance(node, ast.Import):
                yield from ((node.lineno, alias.name) for alias in node.names)
            else:
                for alias in node.names:
                    inner = f"{node.module}.{alias.name}"
                    is_module = inner in self.files and alias.name not in self.faces.get(node.module, ())
                    yield node.lineno, inner if is_module and not node.level else f"{'.' * node.level}{node.module}"

    def room_of(self, module: str) -> str | None:
        """Return the room of a module: the innermost package with an ``__all__`` around the module, or None."""
        parts = module.split(".")
        packages = (".".join(parts[:count]) for count in range(len(parts) - 1, 0, -1))
        return next((package for package in packages if package in self.faces), None)


def within(module: str) -> str:
    """Return the name of a module relative to the package."""
    return ".".join(module.split(".")[1:]) if module.split(".", maxsplit=1)[0] == PACKAGE else module


@lru_cache(maxsize=None)
def floor_of(module: str) -> int | None:
    """Return the index of a module's floor, or None if no floor lists the module."""
    own = within(module)
    fits = [
        (len(room), height)
        for height, rooms in enumerate(FLOORS)
        for room in rooms
        if own == room or (room and room != "core" and own.startswith(f"{room}."))
    ]
    return max(fits)[1] if fits else None


def allowed_outside(module: str) -> set[str]:
    own = within(module)
    return OUTSIDE[max((name for name in OUTSIDE if not name or f"{own}.".startswith(f"{name}.")), key=len)]


def is_own(module: str) -> bool:
    return module == PACKAGE or module.startswith(f"{PACKAGE}.")


def offences(files: dict[str, str]) -> Iterator[str]:
    """Yield a description of each forbidden import."""
    house = House(files)
    graph: dict[str, set[str]] = {}
    for module, code in files.items():
        here = floor_of(module)
        if here is None:
            yield f"{module}: stands on no floor"
            continue
        graph[module] = set()
        for line, target in house.imports(code):
            where = f"{module}:{line}"
            if target.startswith("."):
                yield f"{where}: a relative import"
            elif not is_own(target):
                top = target.partition(".")[0]
                if top not in sys.stdlib_module_names and top not in allowed_outside(module):
                    yield f"{where}: {top} does not belong here"
            else:
                graph[module].add(target)
                if (floor_of(target) or 0) > here:
                    yield f"{where}: {target} stands above"
                yield from past_face(house, module, where, target)
    yield from circles(graph)


def past_face(house: House, module: str, where: str, target: str) -> Iterator[str]:
    """Yield a description if `module` imports an internal module of another room instead of the room's face."""
    room = house.room_of(target)
    if room is not None and target not in house.faces and not module.startswith(f"{room}."):
        if module != room:
            yield f"{where}: {target} is behind the face of {room}"


def circles(graph: dict[str, set[str]]) -> Iterator[str]:
    """Yield each circle of imports once."""
    done: set[str] = set()

    def visit(module: str, way: list[str]) -> Iterator[str]:
        if module in way:
            yield "a circle: " + " > ".join([*way[way.index(module) :], module])
        elif module not in done:
            for target in sorted(graph.get(module, ())):
                yield from visit(target, [*way, module])
            done.add(module)

    for module in sorted(graph):
        yield from visit(module, [])


FILES = read(PACKAGE)


@pytest.mark.long
def test_imports_respect_floors_and_public_names_of_rooms():
    assert list(offences(FILES)) == []


@pytest.mark.parametrize(
    "module, line, offence",
    [
        ("core.paper.areas", "from vkworkbench.core.recognition import recognize", "stands above"),
        ("core.gcode.moves.arcs", "def f():\n    from vkworkbench.core import recognize", "stands above"),
        ("language.message", "from vkworkbench import report", "stands above"),
        ("report.report", "from vkworkbench.document import marks", "stands above"),
        ("document.marks.marks", "from vkworkbench.gui.qt.sentences import sentence", "stands above"),
        ("document.marks.marks", "import vkworkbench", "stands above"),
        ("core.recognition.patterns.rows", "from vkworkbench.core.recognition.verdict import rules", "stands above"),
        ("gui.gauss.dock", "def f():\n    from vkworkbench.gui.results import panel", "stands above"),
        ("core.recognition.patterns.rows", "from vkworkbench.core.paper.areas import axis_of", "behind the face"),
        ("gui.results.panel", "from vkworkbench.core.solids import Tool", "behind the face of vkworkbench.core"),
        ("gui.results.panel", "import vkworkbench.language.message", "behind the face of vkworkbench.language"),
        ("core.gcode.moves.words", "from vkworkbench.core.gcode.moves.linearize import linearize", "a circle"),
        ("document.marks.marks", "def f():\n    from vkworkbench.document.marks import marking", "a circle"),
        ("core.paper.areas", "from .signature import signature", "a relative import"),
        ("core.solids", "import FreeCAD", "FreeCAD does not belong here"),
        ("core.solids", "import scipy.spatial", "scipy does not belong here"),
        ("language.message", "import numpy as np", "numpy does not belong here"),
        ("report.total", "import numpy as np", "numpy does not belong here"),
        ("document.marks.marks", "from PySide import QtCore", "PySide does not belong here"),
        ("gui.results.panel", "def f():\n    from PySide import QtCore", "PySide does not belong here"),
        ("attic", "import os", "stands on no floor"),
        ("core.attic", "import os", "stands on no floor"),
    ],
)
def test_forbidden_import_is_found(module, line, offence):
    name = f"{PACKAGE}.{module}"
    found = list(offences(FILES | {name: FILES.get(name, "") + f"\n{line}\n"}))
    assert len(found) >= 1 and all(one.startswith((name, "a circle")) for one in found)
    assert any(offence in one for one in found), found


def test_names_for_macros_are_defined_in_their_modules():
    import vkworkbench

    for name, module in vkworkbench._HOMES.items():
        assert name in {getattr(node, "name", None) for node in parsed(FILES[module]).body} | names_of_face(
            FILES[module]
        )


def offences_of_tests(tests: dict[str, str], benchmarks: set[str]) -> Iterator[str]:
    """Yield the tests' imports of benchmarks, and of internal modules from rooms other than the test's folder."""
    house = House(FILES)
    for module, code in tests.items():
        for line, target in house.imports(code):
            if target.partition(".")[0] in benchmarks:
                yield f"{module}:{line}: {target} is a benchmark"
            elif is_own(target):
                room = (house.room_of(target) or "").rpartition(".")[2]
                if room not in module.split("."):
                    yield from past_face(house, module, f"{module}:{line}", target)


BENCHMARKS = {"benchmarks", *(path.stem for path in (ROOT / "benchmarks").glob("*.py"))}


@pytest.mark.long
def test_tests_import_no_benchmarks_and_no_internal_modules():
    assert list(offences_of_tests(read("tests"), BENCHMARKS)) == []
    line = "def f():\n    import {}\n"
    for module, offence in (
        ("recognition", "is a benchmark"),
        ("benchmarks.loads", "is a benchmark"),
        ("vkworkbench.core.gcode.moves.words", "behind the face"),
        ("vkworkbench.core.solids", None),
        ("vkworkbench.core.paper.areas", None),
    ):
        found = list(offences_of_tests({"tests.core.paper.test_vk_x": line.format(module)}, BENCHMARKS))
        assert [offence in one for one in found] == ([True] if offence else [])


def test_benchmarks_have_no_import_circle():
    files = read("benchmarks")
    graph = {name: {f"benchmarks.{target}" for _, target in House({}).imports(code)} for name, code in files.items()}
    assert list(circles(graph)) == []
    assert list(circles(graph | {"benchmarks.measuring": {"benchmarks.simulators"}})) != []


def without_assertion(code: str) -> list[str]:
    """Return the tests that assert nothing. `window.wait`, `assert_...` and `pytest.raises` assert."""
    found = []
    for test in ast.walk(ast.parse(code)):
        if isinstance(test, ast.FunctionDef) and test.name.startswith("test_"):
            names = {node.attr for node in ast.walk(test) if isinstance(node, ast.Attribute)}
            names |= {node.id for node in ast.walk(test) if isinstance(node, ast.Name)}
            asserts = names & {"wait", "raises", "fail"} or any(name.startswith("assert_") for name in names)
            if not asserts and not any(isinstance(node, ast.Assert) for node in ast.walk(test)):
                found.append(test.name)
    return found


def test_every_gui_test_has_an_assertion():
    found = {name: without_assertion(code) for name, code in read("tests/gui").items()}
    assert len(found) > 20 and not any(found.values()), found
    assert without_assertion("def test_a():\n    f()\ndef test_b():\n    window.wait(f)") == ["test_a"]
