# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the strategy of a toolpath with the strategies that fit its operation's kind or pattern in FreeCAD."""

from __future__ import annotations

from vkworkbench import freecad
from vkworkbench.core import Family, Recognition, Strategy
from vkworkbench.document.job.operations import kind

# Families of similar strategies that fit an operation along a contour, which can be open or cut in many strokes.
_ALONG = {Family.AROUND, Family.STROKES}
# An engraving follows any drawing. A slot is cut back and forth, one way, or repeatedly.
_ANY_LINES = {Family.ROWS, *_ALONG}
# Families of strategies that fit FreeCAD's operations without patterns. Strategies of one family do not contradict each
# other: adaptive clearing of a round hole winds like a helix, and a pocket with a single ring is a profile.
_KINDS = {
    "Adaptive": _ALONG, "Deburr": _ALONG, "Drilling": {Family.HOLES}, "Engrave": _ANY_LINES, "Helix": {Family.AROUND},
    "Profile": _ALONG, "Slot": _ANY_LINES, "Tapping": {Family.HOLES}, "ThreadMilling": {Family.AROUND},
    "Vcarve": _ALONG, "Waterline": _ALONG,
}  # fmt: skip
# Families of strategies that fit the patterns of pockets, facing and surfaces.
_PATTERNS = {
    "Circular": _ALONG, "CircularZigZag": {Family.ROWS}, "Grid": {Family.ROWS}, "Line": {Family.ROWS}, "Offset": _ALONG,
    "Spiral": _ALONG, "Triangle": {Family.ROWS}, "ZigZag": {Family.ROWS}, "ZigZagOffset": {Family.ROWS, Family.AROUND},
}  # fmt: skip
# Minimum number of rows or loops for a contradiction, except for operations that drill holes. With a lower value,
# correct operations are reported, because in a pocket about as wide as the tool every pattern gives one line or one
# loop.
MIN_PASSES = 3
# Strategies that never contradict a pattern. In narrow places, about as wide as the tool, every pattern gives a loop, a
# line or short strokes.
_IN_NARROW_PLACES = (Strategy.PROFILE, Strategy.ENGRAVING)
MIN_CONFIDENCE = 0.8  # minimum confidence for a contradiction; lower: wrong recognitions are reported as contradictions


def contradicts(name: str | None, found: Recognition) -> bool:
    """Return whether a toolpath surely contradicts the kind or the pattern with this name.

    `benchmarks/intent.py` prints how often `contradicts` is right.
    """
    meant = _KINDS.get(name) or _PATTERNS.get(name)
    few = meant != {Family.HOLES} and found.passes is not None and found.passes < MIN_PASSES
    if not meant or not found.strategy.is_answer or found.confidence < MIN_CONFIDENCE or few:
        return False
    if name in _PATTERNS and found.strategy in _IN_NARROW_PLACES:
        return False
    done = {found.strategy.family, *(span.strategy.family for span in found.spans)} - {Family.NONE}
    return not done & meant


def name_of_intent(obj) -> str | None:
    """Return FreeCAD's name for an operation's kind; if many strategies fit the kind, the name of its pattern or None.

    None is also returned for an experimental waterline operation of FreeCAD that clears each depth with rows.
    """
    if kind(obj) in ("dressup", "array"):  # dress-ups and arrays have no pattern
        return None
    name = freecad.operation_name(obj)
    if name == "Waterline" and freecad.ALGORITHM.of(obj) == "Experimental":
        return name if _PATTERNS.get(freecad.SURFACE_PATTERN.of(obj), _ALONG) == _ALONG else None
    if name not in _KINDS:
        name = freecad.POCKET_PATTERN.of(obj) or freecad.SURFACE_PATTERN.of(obj)
    return name
