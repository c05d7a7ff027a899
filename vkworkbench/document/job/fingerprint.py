# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fingerprints of operations: a mark in the tree is outdated when its operation has another fingerprint.

A fingerprint is a hash of the inputs on which the analysis depends, rounded to the digits that a file stores. Renaming,
saving, reopening and another FreeCAD version do not change the fingerprint.
"""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Callable, Iterable, Iterator
from itertools import islice

from vkworkbench import freecad, preferences
from vkworkbench.core import Stock, Tool
from vkworkbench.core.gcode import used_up
from vkworkbench.document.job.clamps import clamps_of, shapes_of
from vkworkbench.document.job.operations import find, job_of, names_of, through_bases
from vkworkbench.document.job.path_prints import PATH_PRINTS
from vkworkbench.document.job.previous import previous_job
from vkworkbench.document.job.setting import exact_box, rapid_feeds, read_stock, read_tool
from vkworkbench.document.job.solids import form_of_stock, measures_of, shapes_of_model

# Offset that is added to the coordinates of a stock's corners before they are rounded to 0.01 mm, in mm. Without the
# offset, usual lengths in mm or inches can be halfway between two rounded values, and their last digit, which differs
# between FreeCAD versions, decides the rounding.
_OFFSET = 3.7e-4

#: Maximum number of commands that are converted to text in one call, which holds the GIL for a tenth of a second.
AT_ONCE = 50_000
_PIECE = 10_000  # number of commands that one call converts to text if a path is longer than AT_ONCE

# Systems that forbid SHA-1 for security accept it with the argument `usedforsecurity`, which Python 3.8 does not have.
_NOT_FOR_SECURITY = {"usedforsecurity": False} if sys.version_info >= (3, 9) else {}


def path_fingerprint(obj) -> str:
    """Return the fingerprint of an object's path and placement."""
    for _ in finding_path_fingerprint(obj):
        pass
    return PATH_PRINTS.of(obj)


def finding_path_fingerprint(obj) -> Iterator[None]:
    """Compute the fingerprint of an object's path in steps of milliseconds; only copying the path takes longer."""
    while PATH_PRINTS.of(obj) is None:  # the path can change while its fingerprint is computed
        token = PATH_PRINTS.begin(obj)
        path, placement, whose = obj.Path, obj.Placement, names_of(obj)
        yield
        digest = hashlib.sha1(**_NOT_FOR_SECURITY)
        for text in _texts(path, None):
            digest.update(_without_comments(text).encode())
            yield
            if PATH_PRINTS.of(obj) is not None:
                return
        digest.update(_place(placement).encode())
        PATH_PRINTS.end(whose, token, digest.hexdigest()[:16])


def text_of(path, commands: list | None = None) -> str:
    """Return the G-code of a path. For a long path, passing a copy of the path's commands saves time."""
    return "".join(_texts(path, commands))


def _texts(path, commands: list | None) -> Iterator[str]:
    """Yield the G-code of a path; of a long path in parts, because FreeCAD holds the GIL while it writes a text."""
    if path.Size <= AT_ONCE:
        yield path.toGCode()
        return
    lines = (f"{command.toGCode()}\n" for command in (used_up(path.Commands) if commands is None else commands))
    while piece := "".join(islice(lines, _PIECE)):
        yield piece


def fingerprint_of(path: str, setting: str) -> str:
    """Return the fingerprint of an operation from the fingerprints of its path ("" for an unreadable path) and its setting."""
    return f"{path}:{setting}"


def path_and_setting(fingerprint: str) -> tuple[str, str]:
    """Split the fingerprint of an operation into the fingerprints of its path and setting."""
    path, _, setting = fingerprint.partition(":")
    return path, setting


def text_fingerprint(text: str, placement) -> str:
    """Return the fingerprint of a path's text and placement."""
    return _digest(_without_comments(text) + _place(placement))


def _without_comments(text: str) -> str:
    text = text.replace("-0.000000", "0.000000")
    if "(" in text:
        text = "\n".join([line for line in text.split("\n") if not line.startswith("(")])
    return text


def _place(placement) -> str:
    if placement.isIdentity():
        return ""
    return repr([round(value, 6) for value in (*placement.Base, *placement.Rotation.Q)])


def setting_fingerprint(
    tool: Tool | None, stock: Stock | None, form: Iterable = (), rapids: tuple[float, float] = (0.0, 0.0)
) -> str:
    """Return the fingerprint of tool, stock and rapid speeds.

    `tool` is None for an unreadable tool. `stock` is the exact box around the stock; None for an unreadable stock.
    `form` is the form of a stock that is not a box, from `form_of_stock`. `rapids` are the speeds from `rapid_feeds`,
    mm/s.
    """
    parts = [None, None]
    if tool is not None:
        angle = None if tool.tip_angle is None else round(tool.tip_angle, 4)
        parts[0] = (tool.shape, round(tool.diameter, 4), round(tool.corner_radius, 4), angle)
        if tool.tip:
            parts[0] += (round(tool.tip, 4),)
        if tool.body_sizes:
            parts[0] += ({name: round(size, 4) for name, size in tool.body_sizes.items()},)
    if stock is not None:
        parts[1] = [round(float(value) + _OFFSET, 2) + 0.0 for value in (*stock.lower, *stock.upper)]
        parts[1] += form
    if any(rapids):
        parts.append([round(speed, 3) for speed in rapids])
    return _digest(repr(parts))


def surroundings_fingerprint(job) -> str:
    """Return the fingerprint of a job's model, clamps and previous job, and of the holder in the preferences.

    The verdict of a simulation depends on the model, clamps, previous job and holder; the analysis does not. The
    fingerprint is empty without a job.
    """
    if job is None:
        return ""
    shapes = [
        [_shape_print(shape) for shape in some if shape is not None and not shape.isNull()]
        for some in (shapes_of_model(job), shapes_of(clamps_of(job)))
    ]
    parts = [sorted(preferences.read().holder.items()), shapes]
    previous = previous_job(job)
    if previous is not None:  # the recursion ends, because `set_previous_job` does not allow circles of jobs
        posted = [operation.object for operation in find(previous) if operation.counted]
        parts += [(path_fingerprint(obj), read_setting_fingerprints(obj, previous)[0]) for obj in posted]
        parts.append(surroundings_fingerprint(previous))
    return _digest(repr(parts))


def _shape_print(shape) -> tuple:
    corners = [coordinate for corner in exact_box(shape) for coordinate in corner]
    return (*(round(value + _OFFSET, 2) + 0.0 for value in corners), *measures_of(shape))


def read_setting_fingerprints(obj, job) -> tuple[str, str]:
    """Return the fingerprint of an operation's current tool and stock, and the fingerprint of the tool alone."""
    tool, stock = _or_none(read_tool, obj), _or_none(read_stock, job)
    form = form_of_stock(job, stock) if stock else ()
    rapids = rapid_feeds(obj)
    return setting_fingerprint(tool, stock, form, rapids), setting_fingerprint(tool, None, (), rapids)


class Settings:
    """Fingerprints of the current settings (tool and stock) of operations. Each pair of tool and stock is read once.

    If the document was just opened (`opened`), a fingerprint without a stock is valid, too, because FreeCAD adds a
    stock to each opened job without a stock.
    """

    def __init__(self, *, opened: bool = False) -> None:
        self._opened = opened
        self._known: dict[tuple, tuple[str, ...]] = {}

    def of(self, obj) -> tuple[str, ...]:
        """Return the fingerprints that are valid for an operation's tool and stock."""
        job, controller = job_of(obj), through_bases(obj, freecad.CONTROLLER)
        key = tuple(getattr(one, "Name", None) for one in (job, controller))
        if key not in self._known:
            whole, of_tool = read_setting_fingerprints(obj, job)
            self._known[key] = (whole, of_tool) if self._opened else (whole,)
        return self._known[key]


def _or_none(read: Callable, source):
    try:
        return read(source)
    except ValueError:
        return None


def _digest(text: str) -> str:
    return hashlib.sha1(text.encode(), **_NOT_FOR_SECURITY).hexdigest()[:16]
