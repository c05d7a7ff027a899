# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tooltip of a mark in the tree: reason, strategy, time on the machine, time in each simulator, and warnings."""

from __future__ import annotations

from vkworkbench.document.marks.record import Record
from vkworkbench.gui.qt.plain_text import lines
from vkworkbench.gui.qt.sentences import plain_sentence, strategy_name, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.tree.layout import pill_text
from vkworkbench.gui.tree.notices import Level, Notice, notices_of
from vkworkbench.language import ROUGH
from vkworkbench.preferences import Preferences
from vkworkbench.report import is_switched_off


def explanation(record: Record, chosen: Preferences) -> str:
    """Return the explanation of a mark in the tree, as HTML without a paragraph."""
    reasons = () if is_switched_off(record) else record.reason
    first, *rest = [*(plain_sentence(reason) for reason in reasons), _title(record)]
    texts = [f"<b>{lines(first)}</b>", *map(lines, rest)]
    if record.trajectories:
        texts.append(lines(_machining(record)))
    names = sorted(record.costs, key=lambda name: name != chosen.simulator)
    texts += [lines(_simulation(record, name)) for name in names]
    texts += map(_notice, notices_of(record, chosen))
    if chosen.simulator not in record.costs and record.costs:
        text = translate("Pills", "The time in the {simulator} is not known. Analyze the operation again.")
        texts.append(f"<i>{lines(text.format(simulator=user().simulator(chosen.simulator)))}</i>")
    if record.outdated:
        text = translate(
            "Pills",
            "This result is outdated, because the toolpath, the tool or the stock has "
            "changed. Analyze the operation again.",
        )
        texts.append(f"<i>{lines(text)}</i>")
    return "<br>".join(texts)


def _notice(notice: Notice) -> str:
    text = lines(notice.text)
    return text if notice.level is Level.NOTE else f"<b>⚠ {text}</b>"


def _title(record: Record) -> str:
    if record.strategy is None or not record.strategy.is_answer:
        return pill_text(record)
    text = translate("Pills", "{strategy}, confidence {share}")
    return text.format(strategy=strategy_name(record.strategy), share=user().share(record.confidence))


def _machining(record: Record) -> str:
    length = user().length(record.length)
    if not record.machining_seconds:  # do not give an unknown machining time as "at least 0 s"
        return translate("Pills", "Cutting length: {length}.").format(length=length)
    time = user().clock(record.machining_seconds)
    if record.left_out:
        time = translate("Pills", "at least {time}").format(time=time)
    text = translate("Pills", "Machining time: {time}. Cutting length: {length}.")
    if not record.setup.planned:
        text = translate("Pills", "Machining time at constant feed: {time}. Cutting length: {length}.")
    elif record.strategy is None and record.setup.change:
        setup = translate("Pills", "Tool changes and starts of the spindle: {time}.")
        text += " " + setup.format(time=user().clock(record.setup.change))
    return text.format(time=time, length=length)


def _simulation(record: Record, name: str) -> str:
    """Return the text with the time and memory of one simulator. A rough estimate of the time has a range."""
    seconds, memory = record.cost(name)
    factor, reader = record.factor(name), user()
    time = reader.estimated_time(seconds, factor)
    if factor >= ROUGH:
        between = reader.between(reader.time(seconds / factor, factor), reader.time(seconds * factor, factor))
        time = f"{time} ({between})"
    text = translate("Pills", "Simulation time of this operation alone in the {simulator}: {time}. Memory: {memory}.")
    if record.strategy is None:
        text = translate("Pills", "Simulation time in the {simulator}: {time}. Memory: {memory}.")
    if record.incomplete:
        text = translate("Pills", "Simulation time in the {simulator}: at least {time}. Memory: {memory}.")
    return text.format(simulator=reader.simulator(name), time=time, memory=reader.memory(memory))
