# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulation shows to be wrong, and why its picture is not finer."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

SIMULATION: dict[str, str | tuple[str, str]] = {
    "rapid-cuts": QT_TRANSLATE_NOOP("Sentences", "a rapid move removes {volume:mm³2}"),
    "cuts-model": QT_TRANSLATE_NOOP("Sentences", "cuts {depth:mm2} into the model"),
    "stock-lacks": QT_TRANSLATE_NOOP(
        "Sentences", "lacks {depth:mm2} of the model: choose a larger stock, or move the model within it"
    ),
    "plunges-fast": QT_TRANSLATE_NOOP(
        "Sentences", "plunges into full material at {feed:mm/min3}, where its tool may plunge at {allowed:mm/min3}"
    ),
    "leaves-material": QT_TRANSLATE_NOOP("Sentences", "{depth:mm2} are left on the model"),
    "picture-in-time": QT_TRANSLATE_NOOP(
        "Sentences", "a finer picture would take longer than the {allowed:s} that the preferences allow"
    ),
    # Of an operation, in the results.
    "simulated": (
        QT_TRANSLATE_NOOP("Sentences", "as simulated, command {command:#} is wrong: {fault}"),
        QT_TRANSLATE_NOOP("Sentences", "as simulated, {count:n} commands are wrong, among them {command:#}: {fault}"),
    ),
}
