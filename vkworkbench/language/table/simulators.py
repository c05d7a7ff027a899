# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences about problems of simulators, and about the recommended image."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

SIMULATORS: dict[str, str | tuple[str, str]] = {
    # Sentences about problems of FreeCAD's simulators.
    "legacy-hangs": QT_TRANSLATE_NOOP(
        "Sentences", "The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}). {instead}"
    ),
    "legacy-ramp": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to "
            "{error:mm2} {way} (command {command:#}). Do not judge depths by it.",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to "
            "{error:mm2} {way} (command {command:#}). Do not judge depths by it.",
        ),
    ),
    "legacy-long-play": QT_TRANSLATE_NOOP(
        "Sentences",
        "Playing takes about {longer:estimate} in the {simulator:simulator}. Use fast-forward, which takes about {time:estimate}.",
    ),
    "opengl-long-play": QT_TRANSLATE_NOOP(
        "Sentences",
        "Playing takes about {time:estimate} in the {simulator:simulator} at its fastest. "
        "Simulate fewer operations at a time.",
    ),
    "legacy-short-moves": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}). It "
            "takes time, but cannot be seen. Choose a coarser tolerance for the operation.",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "{count:n} moves are shorter than a cell of the {simulator:simulator} "
            "({cell:mm2}). They take time, but cannot be seen. Choose a coarser tolerance "
            "for the operation.",
        ),
    ),
    "opengl-arcs": QT_TRANSLATE_NOOP(
        "Sentences",
        "The {simulator:simulator} slows to about {frames:g1} frames per second at the end of "
        "this job, mostly because of arcs. Simulate fewer operations at a time.",
    ),
    "memory": QT_TRANSLATE_NOOP(
        "Sentences",
        "The {simulator:simulator} takes about {memory:bytes} for this operation, which "
        "is over your {allowed:bytes} limit. {instead}",
    ),
    # Arcs that make the legacy simulator hang.
    "arc-without-xy": QT_TRANSLATE_NOOP("Sentences", "without an X or Y word"),
    "arc-without-z": QT_TRANSLATE_NOOP("Sentences", "without a Z word"),
    "arc-without-centre": QT_TRANSLATE_NOOP("Sentences", "without a center"),
    "arc-full-circle": QT_TRANSLATE_NOOP("Sentences", "that is a full circle"),
    "arc-without-sweep": QT_TRANSLATE_NOOP("Sentences", "that sweeps no angle"),
    "and-more": (QT_TRANSLATE_NOOP("Sentences", " and 1 more"), QT_TRANSLATE_NOOP("Sentences", " and {count:n} more")),
    "too-deep": QT_TRANSLATE_NOOP("Sentences", "too deep"),
    "too-high": QT_TRANSLATE_NOOP("Sentences", "too high"),
    # Warnings when the user starts one of FreeCAD's simulators.
    "started-hangs": QT_TRANSLATE_NOOP(
        "Sentences",
        "The {simulator:simulator} hangs on this simulation: command {command:#} of "
        "{label}{others} is an arc {reason}.",
    ),
    "and-other-operations": (
        QT_TRANSLATE_NOOP("Sentences", " (also in another operation)"),
        QT_TRANSLATE_NOOP("Sentences", " (also in {count:n} other operations)"),
    ),
    "started-takes": QT_TRANSLATE_NOOP(
        "Sentences", "Playing this simulation takes {bound} {time:estimate} in the {simulator:simulator}."
    ),
    "bound-about": QT_TRANSLATE_NOOP("Sentences", "about"),
    "bound-least": QT_TRANSLATE_NOOP("Sentences", "at least"),
    "over-budget": QT_TRANSLATE_NOOP(
        "Sentences",
        "The {simulator:simulator} takes {bound} {time:estimate}, which is over your {allowed:s} limit. {better}",
    ),
    "ours-instead": QT_TRANSLATE_NOOP(
        "Sentences", "Simulate Toolpaths shows the finished part at once, coarse at first."
    ),
    # Why the total of a job is not the sum of its operations.
    "more-than-sum": QT_TRANSLATE_NOOP(
        "Sentences", "More than the sum: the {simulator:simulator} slows down with every cut."
    ),
    "less-than-sum": QT_TRANSLATE_NOOP(
        "Sentences", "Less than the sum: the {simulator:simulator} simulates all operations in one run."
    ),
    "setups-in-total": QT_TRANSLATE_NOOP(
        "Sentences", "More than the sum: tool changes and starts of the spindle take {time:clock}."
    ),
    # Advice.
    "use-opengl": QT_TRANSLATE_NOOP("Sentences", "Use the {simulator:simulator} for this operation."),
    "leave-out": QT_TRANSLATE_NOOP("Sentences", "Leave this operation out of the simulation."),
    "fewer-operations": QT_TRANSLATE_NOOP("Sentences", "Simulate fewer operations at a time."),
    "smaller-image": QT_TRANSLATE_NOOP("Sentences", "Choose a smaller image in the preferences."),
    "coarser-accuracy": QT_TRANSLATE_NOOP("Sentences", "Move its accuracy slider to the left."),
    # Sentences about simulations for which the z-buffer needs too much memory.
    "zbuffer-memory": QT_TRANSLATE_NOOP(
        "Sentences",
        "The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels "
        "and {traces:n} elements of traces, which is over your {allowed:bytes} limit. "
        "{instead}",
    ),
    "image-fits": QT_TRANSLATE_NOOP(
        "Sentences",
        "Choose an image of {width:n} x {height:n} pixels of {pixel:mm2} in the "
        "preferences, or simulate fewer operations.",
    ),
    # The recommended image of the z-buffer.
    "image": QT_TRANSLATE_NOOP(
        "Sentences", "{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}.{passes}"
    ),
    "limit-memory": QT_TRANSLATE_NOOP("Sentences", "memory"),
    "limit-time": QT_TRANSLATE_NOOP("Sentences", "time"),
    "passes-need": QT_TRANSLATE_NOOP("Sentences", " Passes {step:mm3} apart need {cell:mm2}."),
    "passes-seen": QT_TRANSLATE_NOOP("Sentences", " For passes {step:mm3} apart, {cell:mm2} is fine enough."),
    "no-image": QT_TRANSLATE_NOOP("Sentences", "None, because not even a single pixel fits into the memory."),
    "no-image-in-time": QT_TRANSLATE_NOOP(
        "Sentences", "None, because the moves alone take {time:s}. Simulate fewer operations.{heaviest}"
    ),
    "heaviest": QT_TRANSLATE_NOOP("Sentences", " The slowest is {label} with {time:s}."),
}
