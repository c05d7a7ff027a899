# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inside pytest, for tests/mutate.py: which lines each test reaches, and mutants that are tried without a new start.

What to do is told by the file that the environment variable MUTATE names, see `mutate.Checkout`.
"""

from __future__ import annotations

import gc
import json
import os
import signal
import sys
import threading
from pathlib import Path
from types import CodeType, FunctionType

ROOT = Path(__file__).resolve().parents[1]
# A test that takes so many seconds, and so many times its own, longer than that fails.
_LEAST, _WAITING, _LONGER = 5, 120, 5
# How a try ends, beside 0, where all tests pass.
_FAILED, _NOT_GRAFTED = 1, 2
ASKED = json.loads(Path(os.environ["MUTATE"]).read_text())


class Reached:
    """Which lines of the code each test reaches, and how long it takes."""

    def __init__(self, out: str) -> None:
        self.out = out
        self.code = f"{ROOT}/vkworkbench/"  # of the copy in which this runs
        self.lines, self.seconds, self.shared = {}, {}, {}
        self.seen = set()  # until the first test runs: what an import reaches

    def _trace(self, frame, _event, _argument):
        if not frame.f_code.co_filename.startswith(self.code):
            return None
        self.seen.add((frame.f_code.co_filename, frame.f_lineno))
        return self._trace

    def pytest_configure(self):
        threading.settrace(self._trace)
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
        seconds = {test: self.seconds.get(test, 0.0) for test in self.lines}
        Path(self.out).write_text(json.dumps({"seconds": seconds, "reached": found}))


class Grafted:
    """Mutants of functions, each tried in a fork of the process in which all tests are collected already."""

    def __init__(self, file: str, tries: list[dict], jobs: int, out: str) -> None:
        self.file, self.tries, self.jobs, self.out = file, tries, jobs, out
        self.failed = False

    def pytest_runtest_logreport(self, report):
        self.failed |= report.failed

    def pytest_runtestloop(self, session):
        items = {item.nodeid: item for item in session.items}
        waiting, running, statuses = list(enumerate(self.tries))[::-1], {}, [_FAILED] * len(self.tries)
        while waiting or running:
            while waiting and len(running) < self.jobs:
                place, mutant = waiting.pop()
                child = os.fork()
                if not child:
                    self._try(mutant["text"], {items[test]: seconds for test, seconds in mutant["tests"].items()})
                running[child] = place
            child, status = os.wait()
            statuses[running.pop(child)] = os.WEXITSTATUS(status) if os.WIFEXITED(status) else _FAILED
        Path(self.out).write_text(json.dumps(statuses))
        return True

    def _try(self, text, tests):
        """Run tests until one fails, and end this process; the system ends it where one takes far too long."""
        status = _FAILED
        try:
            if not graft(self.file, text):
                os._exit(_NOT_GRAFTED)
            for item, following in zip(tests, [*list(tests)[1:], None]):
                signal.setitimer(signal.ITIMER_PROF, _LEAST + _LONGER * tests[item])  # of the processor
                signal.alarm(_WAITING + int(_LONGER * tests[item]))  # where it waits for what never comes
                item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
                if self.failed:
                    break
            status = int(self.failed)
        finally:
            os._exit(status)


def graft(file: str, text: str) -> bool:
    """Give functions and plain constants of a file what they are in another text of it; return whether any differs.

    Not what an import makes of them: classes, what arguments are by default.
    """
    texts = Path(file).read_text(encoding="utf-8"), text
    old, new = (list(_codes(compile(one, file, "exec", dont_inherit=True))) for one in texts)
    instead, differs = dict(zip(old, new)), False
    for function in gc.get_objects():
        if type(function) is FunctionType and function.__code__.co_filename == file:
            differs |= instead[function.__code__] != function.__code__
            function.__code__ = instead[function.__code__]
    module = next((one for one in list(sys.modules.values()) if getattr(one, "__file__", None) == file), None)
    if module is None:  # only the tests load it
        return False
    fresh = {"__name__": module.__name__, "__file__": file}
    exec(new[0], fresh)  # noqa: S102 - the checkout's own source
    for name, value in fresh.items():
        before = vars(module).get(name)
        if _is_plain(value) and repr(value) != repr(before):
            differs = True
            for other in [module] if name.startswith("_") else list(sys.modules.values()):
                if getattr(other, "__dict__", {}).get(name) is before:
                    setattr(other, name, value)
    return differs


def _is_plain(value) -> bool:
    """Whether a value is of numbers and texts only."""
    if isinstance(value, (tuple, list, set, frozenset)):
        return all(map(_is_plain, value))
    if isinstance(value, dict):
        return all(map(_is_plain, value)) and all(map(_is_plain, value.values()))
    return isinstance(value, (int, float, str)) or hasattr(value, "dtype")


def _codes(code: CodeType):
    """A code and all in it, in the order in which they are written."""
    yield code
    for inner in code.co_consts:
        if isinstance(inner, CodeType):
            yield from _codes(inner)


def pytest_configure(config):
    if ASKED["reached"]:
        config.pluginmanager.register(Reached(ASKED["reached"]))
    if ASKED["tries"]:
        config.pluginmanager.register(Grafted(ASKED["file"], ASKED["tries"], ASKED["jobs"], ASKED["out"]))


def pytest_collection_modifyitems(items):
    """Keep the tests that are asked for, in their order."""
    only = {test: place for place, test in enumerate(ASKED["only"])}
    if only:
        items[:] = sorted((item for item in items if item.nodeid in only), key=lambda item: only[item.nodeid])
