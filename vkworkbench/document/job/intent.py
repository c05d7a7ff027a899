# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether an operation's toolpath contradicts what the operation's kind or pattern says."""

from __future__ import annotations

from vkworkbench import freecad
from vkworkbench.core import Family, Recognition, Strategy
from vkworkbench.document.job.operations import kind

_ALONG = {Family.AROUND, Family.STROKES}  # a contour may be open, and cut in many parts
# An engraving is what its drawing is; a slot is cut to and fro, one way, or again and again.
_ANY_LINES = {Family.ROWS, *_ALONG}
# The families that fit FreeCAD's kinds of operations without patterns. Names within a family do not contradict one
# another: adaptive clearing of a round hole winds as a helix does, and a pocket of one ring is a profile.
_KINDS = {
    "Adaptive": _ALONG, "Deburr": _ALONG, "Drilling": {Family.HOLES}, "Engrave": _ANY_LINES, "Helix": {Family.AROUND},
    "Profile": _ALONG, "Slot": _ANY_LINES, "Tapping": {Family.HOLES}, "ThreadMilling": {Family.AROUND},
    "Vcarve": _ALONG, "Waterline": _ALONG,
}  # fmt: skip
# The families that fit the patterns of pockets, facing and surfaces.
_PATTERNS = {
    "Circular": _ALONG, "CircularZigZag": {Family.ROWS}, "Grid": {Family.ROWS}, "Line": {Family.ROWS}, "Offset": _ALONG,
    "Spiral": _ALONG, "Triangle": {Family.ROWS}, "ZigZag": {Family.ROWS}, "ZigZagOffset": {Family.ROWS, Family.AROUND},
}  # fmt: skip
# Fewer rows or loops may be all there is room for: where the tool is as wide as the ground, every pattern is one line or one loop.
ENOUGH = 3
# What any pattern is in places about as wide as the tool, however many they are: a loop or a line in each, or short strokes.
_IN_NARROW_PLACES = (Strategy.PROFILE, Strategy.ENGRAVING)
SURE = 0.8  # confidence; below it the recognition itself may be wrong


def contradicts(name: str | None, found: Recognition) -> bool:
    """Return whether a toolpath surely belongs to no family that an operation's kind or pattern of this name has.

    How often it is right, `benchmarks/intent.py` prints.
    """
    meant = _KINDS.get(name) or _PATTERNS.get(name)
    few = found.passes is not None and found.passes < ENOUGH
    if not meant or not found.strategy.is_answer or found.confidence < SURE or few:
        return False
    if name in _PATTERNS and found.strategy in _IN_NARROW_PLACES:
        return False
    done = {found.strategy.family, *(span.strategy.family for span in found.spans)} - {Family.NONE}
    return not done & meant


def name_of_intent(obj) -> str | None:
    """Return FreeCAD's own name of an operation's kind or its pattern, whichever says more; None where neither says anything."""
    if kind(obj) in ("dressup", "array"):  # they have no pattern of their own
        return None
    name = freecad.operation_name(obj)
    if name not in _KINDS:
        name = freecad.POCKET_PATTERN.of(obj) or freecad.SURFACE_PATTERN.of(obj)
    return name
