# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether an operation's toolpath does what the operation's kind and pattern say."""

from __future__ import annotations

from vkworkbench import freecad
from vkworkbench.core import Recognition, Strategy
from vkworkbench.document.operations import kind

_S = Strategy
# The strategies that fit FreeCAD's kinds of operations without patterns.
_KINDS = {
    "Adaptive": {_S.ADAPTIVE, _S.PROFILE}, "Deburr": {_S.PROFILE, _S.ENGRAVING}, "Drilling": {_S.DRILLING},
    "Engrave": {_S.ENGRAVING, _S.PROFILE}, "Helix": {_S.HELIX},
    "Profile": {_S.PROFILE, _S.ENGRAVING, _S.CONTOUR_PARALLEL}, "Tapping": {_S.DRILLING}, "ThreadMilling": {_S.HELIX},
    "Vcarve": {_S.ENGRAVING, _S.PROFILE}, "Waterline": {_S.WATERLINE},
}  # fmt: skip
# The strategies that fit the patterns of pockets, facing and surfaces; FreeCAD cuts a pocket's "Line" to and fro.
_PATTERNS = {
    "Circular": {_S.CONTOUR_PARALLEL}, "CircularZigZag": {_S.ZIGZAG}, "Grid": {_S.ZIGZAG, _S.ONE_WAY},
    "Line": {_S.ONE_WAY, _S.ZIGZAG}, "Offset": {_S.CONTOUR_PARALLEL, _S.PROFILE, _S.SPIRAL}, "Spiral": {_S.SPIRAL},
    "Triangle": {_S.ZIGZAG, _S.ONE_WAY}, "ZigZag": {_S.ZIGZAG}, "ZigZagOffset": {_S.ZIGZAG},
}  # fmt: skip


def contradicted(obj, found: Recognition) -> str | None:
    """Return the kind or the pattern of an operation if its toolpath does something else.

    Parameters
    ----------
    obj : DocumentObject
        The operation, or a dress-up of it.
    found : Recognition
        What its toolpath does.

    Returns
    -------
    str or None
        FreeCAD's own name of its kind or its pattern; None where they agree, or where neither says anything.
    """
    if kind(obj) in ("dressup", "array"):
        return None
    name = freecad.operation_name(obj)
    meant = _KINDS.get(name)
    if meant is None:
        name = freecad.POCKET_PATTERN.of(obj) or freecad.SURFACE_PATTERN.of(obj)
        meant = _PATTERNS.get(name)
    if meant is None or not found.strategy.is_answer:
        return None
    done = {found.strategy, *(span.strategy for span in found.spans)}
    return None if done & meant else name
