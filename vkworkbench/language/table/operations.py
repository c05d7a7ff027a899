# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is wrong with an operation, its tool and its stock, and what its machining time leaves out."""

from __future__ import annotations

from vkworkbench.language.marking import QT_TRANSLATE_NOOP

OPERATIONS = {
    "tool-diameter": QT_TRANSLATE_NOOP(
        "Sentences", "the tool's diameter must be a positive number, not {diameter:mm}"
    ),
    "corner-radius": QT_TRANSLATE_NOOP(
        "Sentences", "the corner radius must lie between 0 and {radius:mm}, not be {corner:mm}"
    ),
    "tip-angle": QT_TRANSLATE_NOOP("Sentences", "the tip angle must lie between 0 and pi, not be {angle:g}"),
    "stock-not-finite": QT_TRANSLATE_NOOP("Sentences", "the stock's corners must be finite numbers"),
    "stock-without-volume": QT_TRANSLATE_NOOP(
        "Sentences", "the stock has no volume: its upper corner must exceed its lower corner in x, y and z"
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
}
