# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the core says, in the user's language.

Documents, CSV and JSON keep the core's English sentences, the same for every user of a file; only what is shown is
translated. A sentence is known by its pattern: what stands in braces is a number or another piece of a sentence.
"""

from __future__ import annotations

import re
from functools import lru_cache

import FreeCAD

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

# What a piece looks like where it is not simply one word, e.g. a number.
_PIECES = {
    "more": r"(?:, \S+ mm apart)?(?: at \S+ depths)?",
    "turning": r"(?:, (?:counter-)?clockwise)?",
    "others": r"(?: and \S+ more)?",
    **dict.fromkeys(
        ("seen", "strategy", "strategies", "sentence", "label", "labels", "code", "reason", "instead", "way", "time",
         "longer", "memory", "allowed"),
        ".+?",
    ),
}  # fmt: skip

# The first that fits is taken: what is more special stands before what is more general.
_SENTENCES = (
    QT_TRANSLATE_NOOP("Sentences", "{sentence} only for {share} of the length: {strategy}"),
    QT_TRANSLATE_NOOP(
        "Sentences", "phi stays between {low} and {high} turns over {count} rows{more}, {seen}: {strategy}"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "phi stays between {low} and {high} turns over {count} open strokes{more}, {seen}: {strategy}",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences", "phi stays between {low} and {high} turns over one open stroke{more}, {seen}: {strategy}"
    ),
    QT_TRANSLATE_NOOP("Sentences", "phi stays at 0 over {count} rows{more}, {seen}: {strategy}"),
    QT_TRANSLATE_NOOP("Sentences", "phi stays at 0 over {count} open strokes{more}, {seen}: {strategy}"),
    QT_TRANSLATE_NOOP("Sentences", "phi stays at 0 over one open stroke{more}, {seen}: {strategy}"),
    QT_TRANSLATE_NOOP(
        "Sentences", "phi reaches {high} turns over {count} loops{more}, {seen}: {strategy}{turning}"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences", "phi reaches {high} turns over one loop{more}, {seen}: {strategy}{turning}"
    ),
    QT_TRANSLATE_NOOP("Sentences", "phi lies between {low} and {high} turns, {seen}: {strategy}"),
    QT_TRANSLATE_NOOP(
        "Sentences", "phi has no direction to turn, the moves are vertical at {count} points: {strategy}"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences", "phi has no direction to turn, the moves are vertical at one point: {strategy}"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{count} sections parted by tool changes, titles or drilling show {strategies}: {strategy}",
    ),
    QT_TRANSLATE_NOOP("Sentences", "nothing cuts: there are only rapid moves"),
    QT_TRANSLATE_NOOP("Sentences", "nothing cuts: there are no moves"),
    QT_TRANSLATE_NOOP("Sentences", "some"),
    # Pieces of these.
    QT_TRANSLATE_NOOP("Sentences", ", {step} mm apart at {depths} depths"),
    QT_TRANSLATE_NOOP("Sentences", ", {step} mm apart"),
    QT_TRANSLATE_NOOP("Sentences", " at {depths} depths"),
    QT_TRANSLATE_NOOP("Sentences", ", counter-clockwise"),
    QT_TRANSLATE_NOOP("Sentences", ", clockwise"),
    QT_TRANSLATE_NOOP("Sentences", "{count} bites of one sense overlap"),
    QT_TRANSLATE_NOOP("Sentences", "rows ({rows} of the length) and loops ({loops}) share the area"),
    QT_TRANSLATE_NOOP("Sentences", "descending at a constant radius"),
    QT_TRANSLATE_NOOP("Sentences", "the sense of nested loops alternates"),
    QT_TRANSLATE_NOOP("Sentences", "evenly spaced in the plane, not in depth"),
    QT_TRANSLATE_NOOP("Sentences", "whose shape changes with the depth"),
    QT_TRANSLATE_NOOP("Sentences", "a winding with a helical entry or bites out of the corners"),
    QT_TRANSLATE_NOOP("Sentences", "one winding that never closes"),
    QT_TRANSLATE_NOOP("Sentences", "nested"),
    QT_TRANSLATE_NOOP("Sentences", "small loops move along"),
    QT_TRANSLATE_NOOP("Sentences", "an open pass lies inside a contour"),
    QT_TRANSLATE_NOOP("Sentences", "no nested offsets"),
    QT_TRANSLATE_NOOP("Sentences", "half-turns alternate in sign"),
    QT_TRANSLATE_NOOP("Sentences", "all rows run the same way"),
    QT_TRANSLATE_NOOP("Sentences", "open contours change with the depth"),
    QT_TRANSLATE_NOOP("Sentences", "one open contour"),
    QT_TRANSLATE_NOOP("Sentences", "an open contour comes again"),
    QT_TRANSLATE_NOOP("Sentences", "open strokes as long as the part"),
    QT_TRANSLATE_NOOP("Sentences", "short strokes that fill nothing"),
    # What is wrong with an operation.
    QT_TRANSLATE_NOOP("Sentences", "no cutting move in its toolpath"),
    QT_TRANSLATE_NOOP("Sentences", "inactive: switch it on and recompute it"),
    QT_TRANSLATE_NOOP("Sentences", "no toolpath: recompute the operation and see FreeCAD's report view"),
    QT_TRANSLATE_NOOP("Sentences", "no tool: give the operation a tool controller"),
    QT_TRANSLATE_NOOP("Sentences", "no tool in {label}: choose a tool bit for it"),
    QT_TRANSLATE_NOOP("Sentences", "the tool in {label} has no diameter"),
    QT_TRANSLATE_NOOP(
        "Sentences", "{label}: the tool's diameter must be a positive number, not {diameter} mm"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences", "{label}: the corner radius must lie between 0 and {radius} mm, not be {corner} mm"
    ),
    QT_TRANSLATE_NOOP("Sentences", "{label}: the tip angle must lie between 0 and pi, not be {angle}"),
    QT_TRANSLATE_NOOP("Sentences", "no stock: put the toolpath into a job"),
    QT_TRANSLATE_NOOP("Sentences", "no stock: give {label} a stock"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{label}: the stock has no volume: its upper corner must exceed its lower corner in x, y and z",
    ),
    QT_TRANSLATE_NOOP("Sentences", "{label}: the stock's corners must be finite numbers"),
    QT_TRANSLATE_NOOP("Sentences", "cost unknown for {labels}"),
    QT_TRANSLATE_NOOP("Sentences", "the cost is that of a box around its cuts"),
    QT_TRANSLATE_NOOP("Sentences", "it does not touch the stock: check its depths, its placement and the stock"),
    QT_TRANSLATE_NOOP("Sentences", "its tool is wider than the stock: check the tool's diameter and the stock"),
    # What the machining time leaves out.
    QT_TRANSLATE_NOOP(
        "Sentences", "{length} mm of cutting in {count} move without a feed rate are not in the time"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences", "{length} mm of cutting in {count} moves without a feed rate are not in the time"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences", "{length} mm of rapids are not in the time because the tool controller's {name} is 0"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{length} mm of rapids are not in the time because the tool controller's {name} and {other} are 0",
    ),
    # What is wrong with its commands.
    QT_TRANSLATE_NOOP("Sentences", "{sentence} (command {command})"),
    QT_TRANSLATE_NOOP("Sentences", "{sentence} ({count} times, first at command {command})"),
    QT_TRANSLATE_NOOP("Sentences", "words without a motion before them ignored"),
    QT_TRANSLATE_NOOP("Sentences", "feed rate that is no usable number ignored"),
    QT_TRANSLATE_NOOP("Sentences", "centre word (I, J, K) that is no usable number ignored"),
    QT_TRANSLATE_NOOP("Sentences", "{letter} word that is no usable number ignored"),
    QT_TRANSLATE_NOOP("Sentences", "position beyond a kilometre cut off there"),
    QT_TRANSLATE_NOOP("Sentences", "drilling cycle without a depth (Z): no hole"),
    QT_TRANSLATE_NOOP("Sentences", "drilling cycle without R: it starts where it stands"),
    QT_TRANSLATE_NOOP("Sentences", "drilling cycle outside the XY plane read as in XY"),
    QT_TRANSLATE_NOOP("Sentences", "arc before its start is known ignored"),
    QT_TRANSLATE_NOOP("Sentences", "arc without a usable centre or radius read as a line"),
    QT_TRANSLATE_NOOP("Sentences", "arc whose end is not on its circle read with a changing radius"),
    QT_TRANSLATE_NOOP("Sentences", "unknown code {code} ignored"),
    QT_TRANSLATE_NOOP("Sentences", "{count} more unknown codes ignored"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "the arcs and cycles would need {count} moves at a tolerance of {tolerance} mm; use a larger "
        "tolerance",
    ),
    # The recommended image and accuracy.
    QT_TRANSLATE_NOOP("Sentences", "{width} x {height} pixels of {pixel} mm, limited by the {limit}"),
    QT_TRANSLATE_NOOP("Sentences", "memory"),
    QT_TRANSLATE_NOOP("Sentences", "time"),
    QT_TRANSLATE_NOOP("Sentences", "passes {step} mm apart ask for {pixel} mm"),
    QT_TRANSLATE_NOOP("Sentences", "{pixel} mm would do for passes {step} mm apart"),
    QT_TRANSLATE_NOOP("Sentences", "no resolution helps, not even a single pixel fits"),
    QT_TRANSLATE_NOOP(
        "Sentences", "no resolution helps, the trajectories alone take {time}: simulate fewer operations"
    ),
    QT_TRANSLATE_NOOP("Sentences", "the heaviest is {label} with {time}"),
    QT_TRANSLATE_NOOP(
        "Sentences", "position {position} of {positions}, cells of {cell} mm, plays in {time}"
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "no accuracy helps, playing takes {longer} even at the coarsest: use fast-forward, about {time} at the "
        "finest",
    ),
    # What goes wrong in FreeCAD's simulators.
    QT_TRANSLATE_NOOP(
        "Sentences", "The legacy simulator hangs on an arc {reason} (command {command}{others}): {instead}."
    ),
    QT_TRANSLATE_NOOP("Sentences", "without an X or Y word"),
    QT_TRANSLATE_NOOP("Sentences", "without a Z word"),
    QT_TRANSLATE_NOOP("Sentences", "without a centre"),
    QT_TRANSLATE_NOOP("Sentences", "that is a full circle"),
    QT_TRANSLATE_NOOP("Sentences", "that sweeps no angle"),
    QT_TRANSLATE_NOOP("Sentences", " and {count} more"),
    QT_TRANSLATE_NOOP("Sentences", "use the OpenGL simulator for this operation"),
    QT_TRANSLATE_NOOP("Sentences", "leave this operation out of the simulation"),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The legacy simulator cuts {count} ramp at a wrong depth, up to {error} mm {way} (command {command}):"
        " do not judge depths by it.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The legacy simulator cuts {count} ramps at a wrong depth, up to {error} mm {way} (command "
        "{command}): do not judge depths by it.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "too deep"),
    QT_TRANSLATE_NOOP("Sentences", "too high"),
    QT_TRANSLATE_NOOP(
        "Sentences", "Playing takes about {longer} in the legacy simulator: fast-forward takes about {time}."
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "Playing takes about {time} in the OpenGL simulator at its fastest: simulate fewer operations at a "
        "time.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "{count} moves are shorter than a cell of the legacy simulator ({cell} mm), each takes its time and "
        "none is seen by itself: a coarser tolerance of the operation loses nothing there.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The OpenGL simulator takes about {time} for every picture at the end, {share} % of it for arcs: "
        "simulate this operation alone.",
    ),
    QT_TRANSLATE_NOOP(
        "Sentences",
        "The {simulator} simulator takes about {memory} for this operation, more than the {allowed} allowed: "
        "{instead}.",
    ),
    QT_TRANSLATE_NOOP("Sentences", "choose a smaller image in the preferences"),
    QT_TRANSLATE_NOOP("Sentences", "move its accuracy slider to the left"),
    QT_TRANSLATE_NOOP("Sentences", "simulate fewer operations at a time"),
)  # fmt: skip


def in_user_language(sentence: str) -> str:
    """Return a sentence of the core, or several with semicolons between them, as the user reads it.

    What is not known stays as it is.
    """
    found = fitting(sentence)
    if found is not None:
        template, pieces = found
        shown = {name: in_user_language(piece) for name, piece in pieces.items()}
        return FreeCAD.Qt.translate("Sentences", template).format(**shown)
    if "; " in sentence:
        return "; ".join(map(in_user_language, sentence.split("; ")))
    if ", " in sentence:  # a list of strategies
        return ", ".join(map(in_user_language, sentence.split(", ")))
    return _strategy_names().get(sentence, sentence)


def fitting(sentence: str) -> tuple[str, dict[str, str]] | None:
    """Return the template of a sentence and what stands in its braces; None where there is none."""
    for template, pattern in _patterns():
        match = pattern.fullmatch(sentence)
        if match:
            return template, match.groupdict()
    return None


@lru_cache(maxsize=None)
def _patterns() -> list[tuple[str, re.Pattern]]:
    patterns = []
    for template in _SENTENCES:
        parts = re.split(r"\{(\w+)\}", template)  # text, name, text, name, ..., text
        parts[0::2] = map(re.escape, parts[0::2])
        parts[1::2] = [f"(?P<{name}>{_PIECES.get(name, chr(92) + 'S+')})" for name in parts[1::2]]
        patterns.append((template, re.compile("".join(parts))))
    return patterns


def _strategy_names() -> dict[str, str]:
    from vkworkbench.core import Strategy
    from vkworkbench.gui.names import strategy_name

    return {strategy.value: strategy_name(strategy) for strategy in Strategy}
