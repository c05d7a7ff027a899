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
    "deeper-than-flutes": QT_TRANSLATE_NOOP(
        "Sentences", "The tool cuts {depth:mm2} deeper than its flutes, which are {length:mm3} long."
    ),
    "shank-collides": QT_TRANSLATE_NOOP("Sentences", "The shank collides with material {depth:mm2} high."),
    "holder-collides": QT_TRANSLATE_NOOP("Sentences", "The holder collides with material {depth:mm2} high."),
    "tool-too-short": QT_TRANSLATE_NOOP(
        "Sentences",
        "The tool is too short: it is {length:mm3} long, and the material beside it is {depth:mm2} higher than its upper end.",
    ),
    "hits-clamp": QT_TRANSLATE_NOOP("Sentences", "{part} collides with the clamp {clamp}."),
    "the-tool": QT_TRANSLATE_NOOP("Sentences", "The tool"),
    "the-shank": QT_TRANSLATE_NOOP("Sentences", "The shank"),
    "the-holder": QT_TRANSLATE_NOOP("Sentences", "The holder"),
    # Sentences that say whether shanks, holders and clamps were checked.
    "attachments": QT_TRANSLATE_NOOP("Sentences", "{sentences}"),
    "only-shanks-checked": QT_TRANSLATE_NOOP("Sentences", "Shank checked; no holder and no clamps given."),
    "shanks-checked": QT_TRANSLATE_NOOP("Sentences", "Shanks were checked."),
    "no-shanks": QT_TRANSLATE_NOOP(
        "Sentences", "Shanks were not checked, because no tool has a cutting edge height and a shank diameter."
    ),
    "shanks-unknown": QT_TRANSLATE_NOOP(
        "Sentences",
        "The shanks of {labels} were not checked, because the tools have no cutting edge height or no shank diameter.",
    ),
    "holders-checked": QT_TRANSLATE_NOOP("Sentences", "Holders were checked."),
    "no-holders": QT_TRANSLATE_NOOP("Sentences", "No holder is given."),
    "holders-unknown": QT_TRANSLATE_NOOP("Sentences", "No holder is given for {labels}."),
    "clamps-checked": (
        QT_TRANSLATE_NOOP("Sentences", "1 clamp was checked."),
        QT_TRANSLATE_NOOP("Sentences", "{count:n} clamps were checked."),
    ),
    "no-clamps": QT_TRANSLATE_NOOP("Sentences", "No clamps are given."),
    "clamp-left-out": QT_TRANSLATE_NOOP("Sentences", "A clamp was not checked. {sentence}"),
    "previous-in-circle": QT_TRANSLATE_NOOP(
        "Sentences", "{label} already begins with what this job leaves. Choose another job."
    ),
    "turned": QT_TRANSLATE_NOOP(
        "Sentences", "This is a toolpath for a lathe. It is simulated like a mill's, so that the part is wrong."
    ),
    "stock-not-moved": QT_TRANSLATE_NOOP(
        "Sentences", "The stock is where the other job leaves it, because the jobs have different models."
    ),
    "leaves-material": QT_TRANSLATE_NOOP("Sentences", "{depth:mm2} of stock is left on the model."),
    "picture-in-time": QT_TRANSLATE_NOOP(
        "Sentences", "A finer picture would take longer than the {allowed:s} limit in the preferences."
    ),
    # Sentences of a simulation's verdict on a job: which faults the job has, and what was not checked.
    "verdict": QT_TRANSLATE_NOOP("Sentences", "{sentences}"),
    "verdict-outdated": QT_TRANSLATE_NOOP(
        "Sentences", "The verdict of the simulation is outdated, because the job has changed. Simulate the job again."
    ),
    "verdict-pending": QT_TRANSLATE_NOOP("Sentences", "Nothing is checked yet."),
    "verdict-nothing": QT_TRANSLATE_NOOP(
        "Sentences", "Nothing was checked, because no tool meets the stock. Check the stock and its position."
    ),
    "verdict-sound": QT_TRANSLATE_NOOP("Sentences", "No {what}, checked to {pixel:mm2}."),
    "verdict-unsure": QT_TRANSLATE_NOOP("Sentences", "No {what} was found, checked to {pixel:mm2}."),
    "verdict-unread": (
        QT_TRANSLATE_NOOP("Sentences", "Not everything could be checked: {first}"),
        QT_TRANSLATE_NOOP(
            "Sentences", "Not everything could be checked, for {count:n} reasons. The first reason: {first}"
        ),
    ),
    "verdict-checked": QT_TRANSLATE_NOOP("Sentences", "Checked to {pixel:mm2}."),
    "verdict-kinds": QT_TRANSLATE_NOOP("Sentences", "collision, gouge or fast plunge"),
    "verdict-kinds-without-model": QT_TRANSLATE_NOOP("Sentences", "collision or fast plunge"),
    "verdict-crashes": (
        QT_TRANSLATE_NOOP("Sentences", "1 rapid cuts into material."),
        QT_TRANSLATE_NOOP("Sentences", "{count:n} rapids cut into material."),
    ),
    "verdict-gouges": (
        QT_TRANSLATE_NOOP("Sentences", "1 gouge is {depth:mm2} deep in the model."),
        QT_TRANSLATE_NOOP("Sentences", "{count:n} gouges are up to {depth:mm2} deep in the model."),
    ),
    "verdict-plunges": (
        QT_TRANSLATE_NOOP("Sentences", "1 plunge is too fast."),
        QT_TRANSLATE_NOOP("Sentences", "{count:n} plunges are too fast."),
    ),
    "verdict-walls": QT_TRANSLATE_NOOP(
        "Sentences", "The time did not suffice to check all walls for gouges narrower than {pixel:mm2}."
    ),
    "verdict-unchecked": (
        QT_TRANSLATE_NOOP("Sentences", "1 move was not checked for lack of time: command {command:#} of {label}."),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "{count:n} moves were not checked for lack of time, the first is command {command:#} of {label}.",
        ),
    ),
    "verdict-no-model": QT_TRANSLATE_NOOP(
        "Sentences", "Gouges were not checked, because the job has no model with a volume."
    ),
    "verdict-unjudged": QT_TRANSLATE_NOOP(
        "Sentences", "Gouges of {labels} were not checked, because the tool is simulated by a simpler shape."
    ),
    "attachments-unchecked": QT_TRANSLATE_NOOP("Sentences", "Shank, holder and clamps were not checked."),
    # Remarks of an operation with faults, in the results of an analysis.
    "simulated": (
        QT_TRANSLATE_NOOP("Sentences", "The simulation shows a fault at command {command:#}: {fault}"),
        QT_TRANSLATE_NOOP(
            "Sentences",
            "The simulation shows faults at {count:n} commands, for example at command {command:#}: {fault}",
        ),
    ),
}
