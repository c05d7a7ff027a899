# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong in a simulator, and which image is recommended."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

SIMULATORS: dict[str, str | tuple[str, str]] = {
    # What goes wrong.
    "legacy-hangs": QT_TRANSLATE_NOOP(
        "Sentences", "The {simulator:simulator} hangs on an arc {reason} (command {command:#}{others}): {instead}."
    ),
    "legacy-ramp": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "The {simulator:simulator} cuts {count:n} ramp at a wrong depth, up to {error:mm2} {way} (command "
            "{command:#}): do not judge depths by it.",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "The {simulator:simulator} cuts {count:n} ramps at a wrong depth, up to {error:mm2} {way} (command "
            "{command:#}): do not judge depths by it.",
        ),
    ),
    "legacy-long-play": QT_TRANSLATE_NOOP(
        "Sentences",
        "Playing takes about {longer:s} in the {simulator:simulator}: fast-forward takes about {time:s}.",
    ),
    "opengl-long-play": QT_TRANSLATE_NOOP(
        "Sentences",
        "Playing takes about {time:s} in the {simulator:simulator} at its fastest: simulate fewer operations at a time.",
    ),
    "legacy-short-moves": (
        QT_TRANSLATE_NOOP(
            "Sentences",
            "One move is shorter than a cell of the {simulator:simulator} ({cell:mm2}), takes its time and is not seen "
            "by itself: a coarser tolerance of the operation loses nothing there.",
        ),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "{count:n} moves are shorter than a cell of the {simulator:simulator} ({cell:mm2}), each takes its time "
            "and none is seen by itself: a coarser tolerance of the operation loses nothing there.",
        ),
    ),
    "opengl-arcs": QT_TRANSLATE_NOOP(
        "Sentences",
        "The {simulator:simulator} takes about {time:s} for every picture at the end, {percent:n}% of it for arcs: "
        "simulate this operation alone.",
    ),
    "memory": QT_TRANSLATE_NOOP(
        "Sentences",
        "The {simulator:simulator} takes about {memory:bytes} for this operation, more than the {allowed:bytes} "
        "allowed: {instead}.",
    ),
    # Why an arc makes it hang, and how many others do.
    "arc-without-xy": QT_TRANSLATE_NOOP("Sentences", "without an X or Y word"),
    "arc-without-z": QT_TRANSLATE_NOOP("Sentences", "without a Z word"),
    "arc-without-centre": QT_TRANSLATE_NOOP("Sentences", "without a center"),
    "arc-full-circle": QT_TRANSLATE_NOOP("Sentences", "that is a full circle"),
    "arc-without-sweep": QT_TRANSLATE_NOOP("Sentences", "that sweeps no angle"),
    "and-more": (
        QT_TRANSLATE_NOOP("Sentences", " and 1 more"),
        QT_TRANSLATE_NOOP("Sentences", " and {count:n} more"),
    ),
    "too-deep": QT_TRANSLATE_NOOP("Sentences", "too deep"),
    "too-high": QT_TRANSLATE_NOOP("Sentences", "too high"),
    # What is said where the user starts one of FreeCAD's simulators.
    "started-hangs": QT_TRANSLATE_NOOP(
        "Sentences",
        "The {simulator:simulator} hangs on this: command {command:#} of {label}{others} is an arc {reason}.",
    ),
    "and-other-operations": (
        QT_TRANSLATE_NOOP("Sentences", " (also in another operation)"),
        QT_TRANSLATE_NOOP("Sentences", " (also in {count:n} other operations)"),
    ),
    "started-takes": QT_TRANSLATE_NOOP(
        "Sentences", "Playing this takes {bound} {time:s} in the {simulator:simulator}."
    ),
    "fast-forward-takes": QT_TRANSLATE_NOOP("Sentences", "Fast-forward takes {bound} {time:s}."),
    "legacy-takes": QT_TRANSLATE_NOOP("Sentences", "The {simulator:simulator} in fast-forward: {bound} {time:s}."),
    "opengl-takes": QT_TRANSLATE_NOOP("Sentences", "The {simulator:simulator}: {bound} {time:s}."),
    "bound-about": QT_TRANSLATE_NOOP("Sentences", "about"),
    "bound-least": QT_TRANSLATE_NOOP("Sentences", "at least"),
    "over-budget": QT_TRANSLATE_NOOP(
        "Sentences",
        "The {simulator:simulator} takes {bound} {time:s}, longer than the {allowed:s} allowed. {better}",
    ),
    "ours-instead": QT_TRANSLATE_NOOP(
        "Sentences", "Simulate toolpaths shows the finished part at once, coarse at first."
    ),
    # What to do instead.
    "use-opengl": QT_TRANSLATE_NOOP("Sentences", "use the {simulator:simulator} for this operation"),
    "leave-out": QT_TRANSLATE_NOOP("Sentences", "leave this operation out of the simulation"),
    "fewer-operations": QT_TRANSLATE_NOOP("Sentences", "simulate fewer operations at a time"),
    "smaller-image": QT_TRANSLATE_NOOP("Sentences", "choose a smaller image in the preferences"),
    "coarser-accuracy": QT_TRANSLATE_NOOP("Sentences", "move its accuracy slider to the left"),
    # The z-buffer's memory.
    "zbuffer-memory": QT_TRANSLATE_NOOP(
        "Sentences",
        "The simulation takes about {memory:bytes} at its peak, for {dexels:n} dexels and {traces:n} elements of "
        "traces, more than the {allowed:bytes} allowed: {instead}.",
    ),
    "image-fits": QT_TRANSLATE_NOOP(
        "Sentences", "choose an image of {width:n} x {height:n} pixels of {pixel:mm2}, or simulate fewer operations"
    ),
    # The recommended image of the z-buffer.
    "image": QT_TRANSLATE_NOOP(
        "Sentences", "{width:n} x {height:n} pixels of {pixel:mm2}, limited by the {limit}{passes}"
    ),
    "limit-memory": QT_TRANSLATE_NOOP("Sentences", "memory"),
    "limit-time": QT_TRANSLATE_NOOP("Sentences", "time"),
    "passes-need": QT_TRANSLATE_NOOP("Sentences", "; passes {step:mm3} apart ask for {cell:mm2}"),
    "passes-seen": QT_TRANSLATE_NOOP("Sentences", "; {cell:mm2} would do for passes {step:mm3} apart"),
    "no-image": QT_TRANSLATE_NOOP("Sentences", "no resolution helps, not even a single pixel fits"),
    "no-image-in-time": QT_TRANSLATE_NOOP(
        "Sentences",
        "no resolution helps, the trajectories alone take {time:s}: simulate fewer operations{heaviest}",
    ),
    "heaviest": QT_TRANSLATE_NOOP("Sentences", "; the heaviest is {label} with {time:s}"),
}
