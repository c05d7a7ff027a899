# SPDX-License-Identifier: LGPL-2.1-or-later
"""Plugin of pytest for tests/mutate.py: record the lines that each test reaches, or try mutants in forked processes.

The environment variable MUTATE names a JSON file with the requests, see `mutate.Checkout.run`.
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
# A test fails after _LEAST s plus _LONGER times its usual duration of processor time, or after _WAITING s plus _LONGER
# times its usual duration of clock time.
_LEAST, _WAITING, _LONGER = 5, 120, 5
# Exit statuses of a forked process. The status 0 means that all tests passed.
_FAILED, _NOT_GRAFTED = 1, 2
ASKED = json.loads(Path(os.environ["MUTATE"]).read_text())


class Reached:
    """Record the lines of code that each test reaches, and the duration of each test."""

    def __init__(self, out: str) -> None:
        self.out = out
        self.code = f"{ROOT}/vkworkbench/"  # folder of the mutated package, in the copy of the checkout
        self.lines, self.seconds, self.shared = {}, {}, {}
        self.seen = set()  # lines that the running test has reached; before the first test, those of the imports

    def _trace(self, frame, _event, _argument):
        if not frame.f_code.co_filename.startswith(self.code):
            return None
        self.seen.add((frame.f_code.co_filename, frame.f_lineno))
        return self._trace

    def pytest_configure(self):
        threading.settrace(self._trace)
        sys.settrace(self._trace)

    def pytest_runtest_setup(self, item):
        # Lines that a fixture reaches count for all tests of the file, because the tests may share the fixture.
        self.seen = self.shared.setdefault(item.nodeid.split("::")[0], set())

    def pytest_runtest_call(self, item):
        self.seen = self.lines.setdefault(item.nodeid, set())
        sys.settrace(self._trace)  # set for each test, because hypothesis and doctests replace the trace function

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
    """Try each mutant in a fork of this process, in which all tests are already collected."""

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
        """Run tests until one fails, then exit. A timer ends the process if a test takes far too long."""
        status = _FAILED
        try:
            if not graft(self.file, text):
                os._exit(_NOT_GRAFTED)
            for item, following in zip(tests, [*list(tests)[1:], None]):
                signal.setitimer(signal.ITIMER_PROF, _LEAST + _LONGER * tests[item])  # processor time
                signal.alarm(_WAITING + int(_LONGER * tests[item]))  # clock time, for a test that waits forever
                item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
                if self.failed:
                    break
            status = int(self.failed)
        finally:
            os._exit(status)


def graft(file: str, text: str) -> bool:
    """Replace the functions and plain constants of a loaded file by the versions in `text`; return whether any differs.

    Objects that are made during the import, such as classes and default arguments, are not replaced.
    """
    texts = Path(file).read_text(encoding="utf-8"), text
    old, new = (list(_codes(compile(one, file, "exec", dont_inherit=True))) for one in texts)
    instead, differs = dict(zip(old, new)), False
    for function in gc.get_objects():
        if type(function) is FunctionType and function.__code__.co_filename == file:
            differs |= instead[function.__code__] != function.__code__
            function.__code__ = instead[function.__code__]
    module = next((one for one in list(sys.modules.values()) if getattr(one, "__file__", None) == file), None)
    if module is None:  # only tests load this file, outside sys.modules
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
    """Return whether a value consists of numbers, texts and arrays only."""
    if isinstance(value, (tuple, list, set, frozenset)):
        return all(map(_is_plain, value))
    if isinstance(value, dict):
        return all(map(_is_plain, value)) and all(map(_is_plain, value.values()))
    return isinstance(value, (int, float, str)) or hasattr(value, "dtype")


def _codes(code: CodeType):
    """Yield a code object and all code objects inside it, in the order of the source."""
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
    """Keep the requested tests, in the requested order."""
    only = {test: place for place, test in enumerate(ASKED["only"])}
    if only:
        items[:] = sorted((item for item in items if item.nodeid in only), key=lambda item: only[item.nodeid])
