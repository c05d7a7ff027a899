# SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutation testing: change one thing in a file, run the tests that reach that line, and see whether one of them fails.

    python3 tests/mutate.py [FILES] [--count 20] [--seed 0] [--jobs 2] [--tests TESTS ...]

FILES are files of vkworkbench/core or vkworkbench/document, by default all of them; of each, COUNT mutants are drawn
(all with --count 0). Tests of a file are those of its room: tests/core/ROOM, or tests/document inside the FreeCAD of
this machine; --tests takes fewer, which is quicker while one writes them. A mutant is killed where a test fails, or
runs ten times as long as before. Prints the mutants that live, and the rate of those killed by file. Other rooms' tests
may kill some of those that live, and some are no change at all: the rate is a lower bound. The checkout is not touched:
copies of it are.
"""

from __future__ import annotations

import argparse
import ast
import copy
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path
from threading import local
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[1]
ROOMS = "core", "document"
COPIED = "vkworkbench", "tests", "toolpaths", "examples", "resources", "docs", "benchmarks", "pyproject.toml"
COPIED += "package.xml", "Init.py", "InitGui.py", "README.md"
# Tests of the files that stand in no room.
OF_ALL_ROOMS = {"solids": ["tests/core/zbuffer"], "stocks": ["tests/core/zbuffer"]}
LEAST_SECONDS = 30
SWAPS = {
    ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot, ast.IsNot: ast.Is, ast.In: ast.NotIn, ast.NotIn: ast.In,
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Mult, ast.Mod: ast.Mult,
    ast.BitAnd: ast.BitOr, ast.BitOr: ast.BitAnd, ast.And: ast.Or, ast.Or: ast.And,
}  # fmt: skip
TURNED = {ast.Lt: ast.GtE, ast.LtE: ast.Gt, ast.Gt: ast.LtE, ast.GtE: ast.Lt}
NAMES = {"min": "max", "max": "min", "minimum": "maximum", "maximum": "minimum", "any": "all", "all": "any"}


class Mutant(NamedTuple):
    """A change of one place in a file."""

    line: int
    what: str
    text: str  # of the whole file


def mutants(source: str) -> list[Mutant]:
    """All mutants of a file."""
    tree = ast.parse(source)
    lines = source.splitlines(keepends=True)
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line.encode()))
    data = source.encode()
    found = []
    for node in _mutable(tree):
        for other in _changes(node):
            begin, end = starts[node.lineno - 1] + node.col_offset, starts[node.end_lineno - 1] + node.end_col_offset
            old, new = data[begin:end].decode(), ast.unparse(other)
            if isinstance(other, ast.expr) and not isinstance(other, (ast.Constant, ast.Name, ast.Attribute)):
                new = f"({new})"
            text = (data[:begin] + new.encode() + data[end:]).decode()
            shown = f"{' '.join(old.split())} -> {new}"
            found.append(Mutant(node.lineno, shown, text))
    return [mutant for mutant in found if _compiles(mutant.text)]


def _mutable(tree: ast.AST) -> Iterator[ast.AST]:
    """The nodes where behaviour is written: no annotations, docstrings or wording."""
    todo = list(ast.iter_child_nodes(tree))
    while todo:
        node = todo.pop()
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            continue  # a docstring
        if isinstance(node, (ast.JoinedStr, ast.Raise)):
            continue  # wording
        yield node
        for name, value in ast.iter_fields(node):
            if name not in ("annotation", "returns", "decorator_list"):
                todo += [one for one in (value if isinstance(value, list) else [value]) if isinstance(one, ast.AST)]


def _changes(node: ast.AST) -> Iterator[ast.AST]:
    """What a node is changed to."""
    other = copy.deepcopy(node)
    if isinstance(node, ast.Compare):
        kind = type(node.ops[0])
        # A measured length is never exactly a threshold: only of counts is the bound itself a case.
        tables = (SWAPS, TURNED) if kind not in TURNED or _counts(node) else (TURNED,)
        for table in tables:
            if kind in table:
                other.ops[0] = table[kind]()
                yield copy.deepcopy(other)
    elif isinstance(node, (ast.BinOp, ast.BoolOp, ast.AugAssign)) and type(node.op) in SWAPS:
        other.op = SWAPS[type(node.op)]()
        yield other
    elif isinstance(node, ast.UnaryOp) and isinstance(node.op, (ast.Not, ast.USub, ast.Invert)):
        yield other.operand
    elif isinstance(node, ast.Constant) and isinstance(node.value, bool):
        other.value = not node.value
        yield other
    elif isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        other.value = node.value + 1 if isinstance(node.value, int) else node.value * 2 if node.value else 1.0
        yield other
    elif isinstance(node, ast.Name) and node.id in NAMES:
        other.id = NAMES[node.id]
        yield other
    elif isinstance(node, ast.Attribute) and node.attr in NAMES:
        other.attr = NAMES[node.attr]
        yield other
    elif isinstance(node, ast.Return) and node.value is not None and not isinstance(node.value, ast.Constant):
        other.value = ast.Constant(None)
        yield other


def _counts(node: ast.Compare) -> bool:
    """Whether whole numbers are compared, as far as one sees."""
    return any(
        (isinstance(side, ast.Constant) and isinstance(side.value, int))
        or (isinstance(side, ast.Call) and isinstance(side.func, ast.Name) and side.func.id == "len")
        for side in (node.left, *node.comparators)
    )


def _compiles(text: str) -> bool:
    try:
        compile(text, "mutant", "exec")
    except SyntaxError:
        return False
    return True


def tests_of(file: Path) -> list[str]:
    """The tests of a file's room, as pytest takes them."""
    parts = file.relative_to(ROOT / "vkworkbench").parts
    if parts[0] == "document":
        return ["tests/document"]
    if len(parts) == 3:
        return [f"tests/core/{parts[1]}"]
    own = sorted((ROOT / "tests/core").glob("test_vk_*.py"))
    return [*(str(path.relative_to(ROOT)) for path in own), *OF_ALL_ROOMS.get(file.stem, [])]


class Checkout:
    """A copy of the checkout in which tests are run."""

    def __init__(self, folder: Path) -> None:
        self.root = folder / "checkout"
        self.home = folder / "home"
        for name in COPIED:
            kind = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
            self.root.mkdir(parents=True, exist_ok=True)
            kind(ROOT / name, self.root / name)
        subprocess.run([str(self.root / "tests/make_home.sh"), str(self.home)], check=True)

    def run(
        self, tests: list[str], *, only: list[str] = (), reached: Path | None = None, limit: float | None = None
    ) -> bool:
        """Whether the tests pass, `only` some of them in this order where it tells any.

        With `reached`, write there which lines of core and document each of them reaches.
        """
        chosen = self.home / "only.json"  # too many for a command line
        chosen.write_text(json.dumps(list(only)))
        inside = "document" in tests[0]
        environment = {
            **os.environ, "HOME": str(self.home), "PYTHONPATH": "tests", "PYTHONDONTWRITEBYTECODE": "1",
            "ONLY": str(chosen), "REACHED": str(reached or ""),
            "HYPOTHESIS_STORAGE_DIRECTORY": str(self.home / "hypothesis"),
        }  # fmt: skip
        arguments = ["-q", "-p", "mutate", *([] if reached else ["-x"]), *tests]
        command = ["/usr/bin/python3", "-m", "pytest", *arguments]
        if inside:
            command = ["freecadcmd", "tests/in_freecad.py"]
            environment["PYTEST_ADDOPTS"] = " ".join(f"'{argument}'" for argument in arguments)
        try:
            ended = subprocess.run(
                command, cwd=self.root, env=environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=limit
            )
        except subprocess.TimeoutExpired:
            return False
        if reached and ended.returncode:
            sys.exit(f"the tests fail without a mutant: {ended.stdout.decode()[-2000:]}")
        return ended.returncode == 0

    def lives(self, mutant: Mutant, file: Path, tests: list[str], limit: float) -> bool:
        """Whether the tests pass with a mutant in its file's place."""
        own = self.root / file.relative_to(ROOT)
        original = own.read_text(encoding="utf-8")
        own.write_text(mutant.text, encoding="utf-8")
        try:
            return self.run(sorted({test.partition("::")[0] for test in tests}), only=tests, limit=limit)
        finally:
            own.write_text(original, encoding="utf-8")


class Reached:
    """As pytest's plugin: which lines of the code each test reaches, and how long it takes."""

    def __init__(self, out: str) -> None:
        self.out = out
        self.code = tuple(f"{ROOT}/vkworkbench/{room}/" for room in ROOMS)  # of the copy in which this runs
        self.lines, self.seconds, self.shared, self.first = {}, {}, {}, set()
        self.seen = self.first  # until the first test runs: what an import reaches is reached by all

    def _trace(self, frame, _event, _argument):
        if not frame.f_code.co_filename.startswith(self.code):
            return None
        self.seen.add((frame.f_code.co_filename, frame.f_lineno))
        return self._trace

    def pytest_configure(self):
        sys.settrace(self._trace)

    def pytest_runtest_setup(self, item):
        # A fixture may be shared by all tests of its file, whichever of them is the first.
        self.seen = self.shared.setdefault(item.nodeid.split("::")[0], set())

    def pytest_runtest_call(self, item):
        self.seen = self.lines.setdefault(item.nodeid, set())
        sys.settrace(self._trace)  # hypothesis and doctests may have set another

    def pytest_runtest_logreport(self, report):
        self.seconds[report.nodeid] = self.seconds.get(report.nodeid, 0.0) + report.duration

    def pytest_sessionfinish(self):
        sys.settrace(None)
        found = {}
        for test, lines in self.lines.items():
            for file, line in lines | self.shared.get(test.split("::")[0], set()):
                found.setdefault(file, {}).setdefault(test, []).append(line)
        imported = {}
        for file, line in self.first:
            imported.setdefault(file, []).append(line)
        seconds = {test: self.seconds.get(test, 0.0) for test in self.lines}
        Path(self.out).write_text(json.dumps({"seconds": seconds, "imported": imported, "reached": found}))


def pytest_configure(config):
    """As pytest's plugin (-p mutate), set up what notes the lines."""
    if os.environ.get("REACHED"):
        config.pluginmanager.register(Reached(os.environ["REACHED"]))


def pytest_collection_modifyitems(items):
    """As pytest's plugin, keep the tests that are asked for, in their order."""
    only = {test: place for place, test in enumerate(json.loads(Path(os.environ["ONLY"]).read_text()))}
    if only:
        items[:] = sorted((item for item in items if item.nodeid in only), key=lambda item: only[item.nodeid])


def sample(file: Path, count: int, seed: int) -> list[Mutant]:
    """Mutants of a file, the same for the same seed."""
    every = mutants(file.read_text(encoding="utf-8"))
    chosen = random.Random(f"{seed} {file.name}")
    return every if not count or len(every) <= count else chosen.sample(every, count)


def reach(tests: tuple[str, ...], checkout: Checkout) -> dict:
    """Which lines of which file each of the tests reaches, and its seconds."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        checkout.run(list(tests), reached=Path(out.name))
        return json.loads(Path(out.name).read_text())


def judge(file: Path, chosen: list[Mutant], known: dict, checkouts: list[Checkout]) -> list[Mutant]:
    """The mutants that live, by what `reach` knows of their tests."""
    name = str(checkouts[0].root / file.relative_to(ROOT))
    quickest = sorted(known["seconds"], key=known["seconds"].get)
    imported, reached = known["imported"].get(name, ()), known["reached"].get(name, {})
    own, free = local(), list(checkouts)

    def lives(mutant: Mutant) -> bool:
        if not hasattr(own, "checkout"):
            own.checkout = free.pop()
        tests = [test for test in quickest if mutant.line in reached.get(test, ())]
        if not tests and mutant.line in imported:
            tests = quickest
        limit = LEAST_SECONDS + 10 * sum(known["seconds"][test] for test in tests)
        return not tests or own.checkout.lives(mutant, file, tests, limit)

    with ThreadPoolExecutor(len(checkouts)) as pool:
        return [mutant for mutant, alive in zip(chosen, pool.map(lives, chosen)) if alive]


def main() -> int:
    """Print the mutants that live, and the rates."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", type=Path)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--tests", nargs="+")
    chosen = parser.parse_args()
    files = [file.resolve() for file in chosen.files]
    for room in ROOMS:
        files += [] if chosen.files else sorted((ROOT / "vkworkbench" / room).rglob("*.py"))
    killed = total = 0
    with tempfile.TemporaryDirectory() as folder:
        checkouts = [Checkout(Path(folder, str(job))) for job in range(chosen.jobs)]
        known = cache(lambda tests: reach(tests, checkouts[0]))
        for file in files:
            drawn = sample(file, chosen.count, chosen.seed)
            if not drawn:
                continue
            alive = judge(file, drawn, known(tuple(chosen.tests or tests_of(file))), checkouts)
            name = file.relative_to(ROOT)
            for mutant in alive:
                print(f"    {name}:{mutant.line}: {mutant.what}")
            killed, total = killed + len(drawn) - len(alive), total + len(drawn)
            print(f"{name}: {len(drawn) - len(alive)} of {len(drawn)}", flush=True)
    print(f"{killed} of {total} mutants killed, {killed / max(total, 1):.2f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
