# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sentences about faults that a simulation shows, and about the limit of its pictures."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

SIMULATION: dict[str, str | tuple[str, str]] = {
    "rapid-cuts": QT_TRANSLATE_NOOP("Sentences", "A rapid move removes {volume:mm³2}."),
    "cuts-model": QT_TRANSLATE_NOOP("Sentences", "The tool cuts {depth:mm2} into the model."),
    "stock-lacks": QT_TRANSLATE_NOOP(
        "Sentences",
        "The stock is {depth:mm2} too small for the model. Choose a larger stock, or move the model within it.",
    ),
    "plunges-fast": QT_TRANSLATE_NOOP(
        "Sentences", "The tool plunges into full material at {feed:mm/min3}. Its limit is {allowed:mm/min3}."
    ),
    "leaves-material": QT_TRANSLATE_NOOP("Sentences", "{depth:mm2} of stock is left on the model."),
    "picture-in-time": QT_TRANSLATE_NOOP(
        "Sentences", "A finer picture would take longer than the {allowed:s} limit in the preferences."
    ),
    # A fault of an operation, in the results.
    "simulated": (
        QT_TRANSLATE_NOOP("Sentences", "The simulation shows a fault at command {command:#}: {fault}"),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "The simulation shows faults at {count:n} commands, for example at command {command:#}: {fault}",
        ),
    ),
}
