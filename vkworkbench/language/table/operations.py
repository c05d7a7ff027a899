# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with an operation, its tool and its stock, and what its machining time leaves out."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

OPERATIONS: dict[str, str | tuple[str, str]] = {
    "of": QT_TRANSLATE_NOOP("Sentences", "{label}: {sentence}"),
    "inactive": QT_TRANSLATE_NOOP(
        "Sentences", "switched off: it has no toolpath until you switch it on and recompute it"
    ),
    "no-toolpath": QT_TRANSLATE_NOOP("Sentences", "no toolpath: recompute the operation and see FreeCAD's report view"),
    "no-cutting-move": QT_TRANSLATE_NOOP("Sentences", "no cutting move in its toolpath"),
    "not-analysed": QT_TRANSLATE_NOOP("Sentences", "could not be analyzed, please report it with the file: {error}"),
    "called": QT_TRANSLATE_NOOP("Sentences", "called {name}, but its toolpath is {strategy:strategy}"),
    "no-tool": QT_TRANSLATE_NOOP("Sentences", "no tool: give the operation a tool controller"),
    "no-tool-bit": QT_TRANSLATE_NOOP("Sentences", "no tool in {label}: choose a tool bit for it"),
    "no-diameter": QT_TRANSLATE_NOOP("Sentences", "the tool in {label} has no diameter"),
    "tool-diameter": QT_TRANSLATE_NOOP(
        "Sentences", "the tool's diameter must be a positive number of at most a kilometer, not {diameter:mm}"
    ),
    "corner-radius": QT_TRANSLATE_NOOP(
        "Sentences", "the corner radius must lie between 0 and {radius:mm}, not be {corner:mm}"
    ),
    "tip-angle": QT_TRANSLATE_NOOP("Sentences", "the tip angle must lie between 0 and pi, not be {angle:g}"),
    "tip-diameter": QT_TRANSLATE_NOOP(
        "Sentences", "the tip's diameter must lie between 0 and {diameter:mm}, not be {tip:mm}"
    ),
    "no-job": QT_TRANSLATE_NOOP("Sentences", "no stock: put the toolpath into a job"),
    "no-stock": QT_TRANSLATE_NOOP("Sentences", "no stock: give {label} a stock"),
    "stock-not-finite": QT_TRANSLATE_NOOP(
        "Sentences", "the stock's corners must be numbers within a kilometer of the origin"
    ),
    "placement-not-finite": QT_TRANSLATE_NOOP(
        "Sentences", "the operation's placement must be numbers within a kilometer of the origin"
    ),
    "stock-without-volume": QT_TRANSLATE_NOOP(
        "Sentences", "the stock has no volume: its upper corner must exceed its lower corner in x, y and z"
    ),
    "solid-not-closed": QT_TRANSLATE_NOOP("Sentences", "the solid's surface is not closed"),
    "stock-as-box": QT_TRANSLATE_NOOP("Sentences", "the box around the stock of {label} is taken for it: {sentence}"),
    "tool-simplified": QT_TRANSLATE_NOOP("Sentences", "{label} is not simulated exactly, but {instead}"),
    "as-end-mill": QT_TRANSLATE_NOOP("Sentences", "as an end mill of its largest diameter"),
    "as-ball-end": QT_TRANSLATE_NOOP("Sentences", "as a ball end of its tip's diameter"),
    "as-drill": QT_TRANSLATE_NOOP("Sentences", "as a drill"),
    "cost-unknown": QT_TRANSLATE_NOOP("Sentences", "cost unknown for {labels}"),
    "nothing-to-simulate": QT_TRANSLATE_NOOP(
        "Sentences", "there is nothing to simulate: choose a job, or operations with a toolpath"
    ),
    "several-jobs": QT_TRANSLATE_NOOP(
        "Sentences", "these operations belong to several jobs, choose one of them: {labels}"
    ),
    "box-of-cuts": QT_TRANSLATE_NOOP("Sentences", "the cost is that of a box around its cuts"),
    "not-touching": QT_TRANSLATE_NOOP(
        "Sentences", "it does not touch the stock: check its depths, its placement and the stock"
    ),
    "stock-is-model": QT_TRANSLATE_NOOP(
        "Sentences", "it does not touch the stock, which is the finished part: choose a block around it as the stock"
    ),
    "tool-wider-than-stock": QT_TRANSLATE_NOOP(
        "Sentences", "its tool is wider than the stock: check the tool's diameter and the stock"
    ),
    "cutting-untimed": (
        QT_TRANSLATE_NOOP(
            "Sentences", "{length:mm4} of cutting in {count:n} move without a feed rate are not in the time"
        ),
        QT_TRANSLATE_NOOP(
            "Sentences", "{length:mm4} of cutting in {count:n} moves without a feed rate are not in the time"
        ),
    ),
    "rapids-untimed": QT_TRANSLATE_NOOP(
        "Sentences", "{length:mm4} of rapids are not in the time because the tool controller's {name} is 0"
    ),
    "all-rapids-untimed": QT_TRANSLATE_NOOP(
        "Sentences",
        "{length:mm4} of rapids are not in the time because the tool controller's {name} and {other} are 0",
    ),
    "rapids-without-controller": QT_TRANSLATE_NOOP(
        "Sentences",
        "{length:mm4} of rapids are not in the time because the operation has no tool controller: give it one with rapid speeds",
    ),
}
