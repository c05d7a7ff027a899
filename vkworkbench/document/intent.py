# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an operation is called, by its kind and its pattern, and whether its toolpath does that."""

from __future__ import annotations

from vkworkbench.core import Recognition, Strategy
from vkworkbench.document.operations import kind

_S = Strategy
# What the operations of FreeCAD make whose kind says it all, by the last part of their module's name.
_KINDS = {
    "Adaptive": {_S.ADAPTIVE, _S.PROFILE}, "Deburr": {_S.PROFILE, _S.ENGRAVING}, "Drilling": {_S.DRILLING},
    "Engrave": {_S.ENGRAVING, _S.PROFILE}, "Helix": {_S.HELIX},
    "Profile": {_S.PROFILE, _S.ENGRAVING, _S.CONTOUR_PARALLEL}, "Tapping": {_S.DRILLING}, "ThreadMilling": {_S.HELIX},
    "Vcarve": {_S.ENGRAVING, _S.PROFILE}, "Waterline": {_S.WATERLINE},
}  # fmt: skip
# Patterns of pockets, facing and surfaces; FreeCAD's lines of a pocket are cut to and fro.
_PATTERNS = {
    "Circular": {_S.CONTOUR_PARALLEL}, "CircularZigZag": {_S.ZIGZAG}, "Grid": {_S.ZIGZAG, _S.ONE_WAY},
    "Line": {_S.ONE_WAY, _S.ZIGZAG}, "Offset": {_S.CONTOUR_PARALLEL, _S.PROFILE, _S.SPIRAL}, "Spiral": {_S.SPIRAL},
    "Triangle": {_S.ZIGZAG, _S.ONE_WAY}, "ZigZag": {_S.ZIGZAG}, "ZigZagOffset": {_S.ZIGZAG},
}  # fmt: skip
_PATTERN_PROPERTIES = ("ClearingPattern", "OffsetPattern", "CutPattern")  # 1.1, before, 3D surface


def contradicted(obj, found: Recognition) -> str | None:
    """Return what an operation is called where its toolpath does something else.

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
    while kind(obj) == "dressup" and hasattr(obj.Base, "isDerivedFrom"):
        obj = obj.Base
    name = type(getattr(obj, "Proxy", None)).__module__.rpartition(".")[2].removeprefix("Path")
    meant = _KINDS.get(name)
    if meant is None:
        name = next((getattr(obj, p) for p in _PATTERN_PROPERTIES if hasattr(obj, p)), None)
        meant = _PATTERNS.get(name)
    if meant is None or not found.strategy.is_answer:
        return None
    done = {found.strategy, *(span.strategy for span in found.spans)}
    return None if done & meant else name
