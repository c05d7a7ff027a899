# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences about problems of operations, tools and stocks, and about what machining times do not include."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

OPERATIONS: dict[str, str | tuple[str, str]] = {
    "of": QT_TRANSLATE_NOOP("Sentences", "{label}: {sentence}"),
    "inactive": QT_TRANSLATE_NOOP(
        "Sentences", "The operation is switched off. It has no toolpath until you switch it on and recompute it."
    ),
    "no-toolpath": QT_TRANSLATE_NOOP(
        "Sentences", "The operation has no toolpath. Recompute it and read FreeCAD's report view."
    ),
    "no-cutting-move": QT_TRANSLATE_NOOP("Sentences", "The toolpath has no cutting move."),
    "not-analysed": QT_TRANSLATE_NOOP(
        "Sentences", "The analysis failed. Please report the error together with the file: {error}"
    ),
    "called": QT_TRANSLATE_NOOP(
        "Sentences", "The operation is called {name}, but its toolpath is {strategy:strategy}."
    ),
    "no-tool": QT_TRANSLATE_NOOP("Sentences", "The operation has no tool. Give it a tool controller."),
    "no-tool-possible": QT_TRANSLATE_NOOP("Sentences", "This toolpath has no tool. Import its program into a job."),
    "no-tool-bit": QT_TRANSLATE_NOOP("Sentences", "{label} has no tool. Choose a tool bit for it."),
    "no-diameter": QT_TRANSLATE_NOOP("Sentences", "The tool in {label} has no diameter. Enter one in its tool bit."),
    "tool-diameter": QT_TRANSLATE_NOOP(
        "Sentences", "The tool's diameter must be a positive number of at most a kilometer, not {diameter:mm}."
    ),
    "corner-radius": QT_TRANSLATE_NOOP(
        "Sentences", "The corner radius must be between 0 and {radius:mm}, not {corner:mm}."
    ),
    "tip-angle": QT_TRANSLATE_NOOP("Sentences", "The tip angle must be between 0 and pi, not {angle:g}."),
    "tip-diameter": QT_TRANSLATE_NOOP(
        "Sentences", "The diameter of the tip must be between 0 and {diameter:mm}, not {tip:mm}."
    ),
    "beyond-travel": QT_TRANSLATE_NOOP(
        "Sentences", "The job moves {needed:mm4} along {axis}, but the travel of the machine is {travel:mm4}."
    ),
    "no-job": QT_TRANSLATE_NOOP("Sentences", "The toolpath has no stock. Put it into a job."),
    "no-stock": QT_TRANSLATE_NOOP("Sentences", "{label} has no stock. Give it one in the job's settings."),
    "stock-not-finite": QT_TRANSLATE_NOOP(
        "Sentences", "The corners of the stock must be numbers within a kilometer of the origin."
    ),
    "placement-not-finite": QT_TRANSLATE_NOOP(
        "Sentences", "The placement of the operation must be numbers within a kilometer of the origin."
    ),
    "stock-without-volume": QT_TRANSLATE_NOOP(
        "Sentences", "The stock has no volume. Its upper corner must exceed its lower corner in x, y and z."
    ),
    "solid-not-closed": QT_TRANSLATE_NOOP("Sentences", "The surface of the solid is not closed."),
    "stock-as-box": QT_TRANSLATE_NOOP(
        "Sentences", "The stock of {label} is simulated as the box around it. {sentence}"
    ),
    "tool-simplified": QT_TRANSLATE_NOOP("Sentences", "{label} is simulated only approximately, {instead}."),
    "as-end-mill": QT_TRANSLATE_NOOP("Sentences", "as an end mill with its largest diameter"),
    "as-ball-end": QT_TRANSLATE_NOOP("Sentences", "as a ball end mill with the diameter of its tip"),
    "as-drill": QT_TRANSLATE_NOOP("Sentences", "as a drill"),
    "cost-unknown": QT_TRANSLATE_NOOP("Sentences", "The simulation cost of {labels} is unknown."),
    "document-is-read": QT_TRANSLATE_NOOP(
        "Sentences", "FreeCAD is still reading {document}. Try again when the document is open."
    ),
    "nothing-to-simulate": QT_TRANSLATE_NOOP(
        "Sentences", "There is nothing to simulate. Choose a job, or operations with a toolpath."
    ),
    "several-jobs": QT_TRANSLATE_NOOP(
        "Sentences", "These operations belong to several jobs. Choose operations of one job only: {labels}."
    ),
    "box-of-cuts": QT_TRANSLATE_NOOP("Sentences", "The cost is estimated for a stock that is a box around the cuts."),
    "not-touching": QT_TRANSLATE_NOOP(
        "Sentences", "The operation does not touch the stock. Check its depths, its placement and the stock."
    ),
    "stock-is-model": QT_TRANSLATE_NOOP(
        "Sentences",
        "The operation does not touch the stock, which is the finished part. Choose a block around it as the stock.",
    ),
    "tool-wider-than-stock": QT_TRANSLATE_NOOP(
        "Sentences", "The tool is wider than the stock. Check the tool's diameter and the stock."
    ),
    "cycle-time": QT_TRANSLATE_NOOP(
        "Sentences",
        "FreeCAD's CycleTime for this job is {seconds:clock}. FreeCAD measures arcs wrongly, and leaves out accelerations and dwells.",
    ),
    "cutting-untimed": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "The machining time does not include {length:mm4} of cutting in {count:n} move without a feed rate.",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "The machining time does not include {length:mm4} of cutting in {count:n} moves without a feed rate.",
        ),
    ),
    "rapids-untimed": QT_TRANSLATE_NOOP(
        "Sentences",
        "The machining time does not include {length:mm4} of rapids, because the tool controller's {name} is 0.",
    ),
    "all-rapids-untimed": QT_TRANSLATE_NOOP(
        "Sentences",
        "The machining time does not include {length:mm4} of rapids, because the tool "
        "controller's {name} and {other} are 0.",
    ),
    "rapids-without-controller": QT_TRANSLATE_NOOP(
        "Sentences",
        "The machining time does not include {length:mm4} of rapids, because the "
        "operation has no tool controller. Choose your machine in the preferences, page Machine.",
    ),
}
