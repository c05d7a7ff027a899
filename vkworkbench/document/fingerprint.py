# SPDX-License-Identifier: LGPL-2.1-or-later
"""Fingerprints that tell whether a mark still describes the operation it stands on.

They hold what the analysis depends on and nothing else, to the digits a file keeps: so they survive renaming,
saving, reopening, and another FreeCAD version.
"""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Callable

from vkworkbench.core import Stock, Tool
from vkworkbench.document.setting import read_stock, read_tool

# mm, added before a stock's corners are rounded to hundredths: no measure in mm or inches is then on a border between
# two of them, where another version's last digit would decide.
_ASIDE = 3.7e-4

# A computer that allows no SHA-1 for secrets allows it here; Python 3.8 does not know the difference.
_NO_SECRET = {"usedforsecurity": False} if sys.version_info >= (3, 9) else {}


def path_fingerprint(obj) -> str:
    """Return the fingerprint of an object's path and where it is placed."""
    return text_fingerprint(obj.Path.toGCode(), obj.Placement)


def text_of(commands: list) -> str:
    """Return the text of a path's commands; to write very many of them at once would hold up other threads."""
    return "".join([f"{command.toGCode()}\n" for command in commands])


def text_fingerprint(text: str, placement) -> str:
    """Return the fingerprint of a path's text and where it is placed."""
    text = text.replace("-0.000000", "0.000000")
    if "(" in text:
        text = "\n".join([line for line in text.split("\n") if not line.startswith("(")])
    if not placement.isIdentity():
        text += repr([round(value, 6) for value in (*placement.Base, *placement.Rotation.Q)])
    return _digest(text)


def setting_fingerprint(tool: Tool | None, stock: Stock | None) -> str:
    """Return the fingerprint of tool and stock, None where one cannot be read."""
    parts = [None, None]
    if tool is not None:
        angle = None if tool.tip_angle is None else round(tool.tip_angle, 4)
        parts[0] = (tool.shape, round(tool.diameter, 4), round(tool.corner_radius, 4), angle)
        if tool.tip:
            parts[0] += (round(tool.tip, 4),)
    if stock is not None:
        parts[1] = [round(float(value) + _ASIDE, 2) + 0.0 for value in (*stock.lower, *stock.upper)]
    return _digest(repr(parts))


def read_setting_fingerprint(obj, job) -> str:
    """Return the fingerprint of the tool and the stock that an operation and its job have now."""
    return setting_fingerprint(_or_none(read_tool, obj), _or_none(read_stock, job))


def _or_none(read: Callable, source):
    try:
        return read(source)
    except ValueError:
        return None


def _digest(text: str) -> str:
    return hashlib.sha1(text.encode(), **_NO_SECRET).hexdigest()[:16]
