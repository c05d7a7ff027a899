# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page beside the results: all that is known of one row, plain words first; the paper's terms behind "Why?"."""

from __future__ import annotations

import FreeCAD

from vkworkbench.core.simulators import SIMULATORS
from vkworkbench.gui.qt import colors
from vkworkbench.gui.qt.plain_text import lines
from vkworkbench.gui.qt.sentences import as_sentence, plain_sentence, sentence, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.results.columns import LENGTH, OPERATION, STATE, STRATEGY, WARNINGS
from vkworkbench.gui.results.rows import Row
from vkworkbench.gui.tree.notices import Level
from vkworkbench.report import OperationReport, is_switched_off

WHY, NUMBERS, GAUSS_MAP = "why", "numbers", "gauss-map"  # what the page's links open
_SIGNS = {
    Level.NOTE: ("i", colors.NOTE_SIGN), Level.WARNING: ("\u26a0", colors.WARNING_SIGN), Level.ERROR: ("\u2716", colors.ERROR_SIGN),
}  # fmt: skip
_APART = {OPERATION, STRATEGY, WARNINGS, STATE, LENGTH}  # columns that the page tells otherwise


def page(row: Row, first: list, others: list, opened: set[str]) -> str:
    """Return what is known of a row as HTML.

    Parameters
    ----------
    row : Row
    first, others : list of Column
        The columns that are seen at first and the others.
    opened : set of str
        Which of the page's links are open.
    """
    parts = [_title(row)]
    if row.strategy is not None and not is_switched_off(row.mark):
        parts.append(_strategy(row, WHY in opened))
    parts += [_notice(notice) for notice in row.notices]
    if row.outdated:
        text = translate("Vk_Results", "Outdated: toolpath, tool or stock have changed since. Analyze it again.")
        parts.append(f"<i>{lines(text)}</i>")
    html = "".join(f"<p>{part}</p>" for part in parts)
    html += _table(_cells(row, first) + _machining(row))
    if NUMBERS not in opened:
        return html + "<p>" + _link(NUMBERS, translate("Vk_Results", "All numbers")) + "</p>"
    html += _table(_cells(row, others) + _moves(row))
    html += "".join(f"<p>{lines(advice)}</p>" for advice in _advice(row))
    return html + "<p>" + _link(NUMBERS, translate("Vk_Results", "Fewer numbers")) + "</p>"


def _title(row: Row) -> str:
    return f"<b>{lines(row.label)}</b>: {lines(row.kind)}"


def _strategy(row: Row, why: bool) -> str:
    link = _link(WHY, translate("Vk_Results", "Why?"))
    seen = "; ".join(map(plain_sentence, row.mark.reason))
    text = f"{lines(as_sentence(seen))} {link}"
    if not why:
        return text
    more = [lines(sentence(reason)) for reason in row.mark.reason]
    if row.strategy.is_answer:
        sure = translate("Vk_Results", "Sure: {share}").format(share=user().share(row.found.confidence))
        more.append(lines(sure))
    more.append(_link(GAUSS_MAP, translate("Vk_Results", "Show it in the Gauss map")))
    return "<br>".join([text, *more])


def _notice(notice) -> str:
    sign, color = _SIGNS[notice.level]
    return f"<b style='color: {color}'>{sign}</b> {lines(notice.text)}"


def _cells(row: Row, columns: list) -> list[tuple[str, str, str]]:
    return [(column.name, column.text(row), column.range(row)) for column in columns if column.key not in _APART]


def _machining(row: Row) -> list[tuple[str, str, str]]:
    """Lengths, and what the machining time leaves out."""
    if not row.found.trajectories:
        return []
    length = user().length
    told = [(translate("Vk_Results", "Cutting"), length(row.found.length), "")]
    if row.is_total:
        return told
    if isinstance(row.found, OperationReport):  # a mark does not keep these
        machining = row.found.machining
        told.append((translate("Vk_Results", "Rapids"), length(machining.rapid_length), ""))
        if machining.depth is not None:
            told.append((translate("Vk_Results", "Depth"), length(machining.depth), ""))
    return told + [("", sentence(message), "") for message in row.found.left_out]


def _moves(row: Row) -> list[tuple[str, str, str]]:
    """How long the moves at feed are, by the program's lines: thousands of tiny ones tell why all takes long."""
    if row.is_total or not isinstance(row.found, OperationReport) or row.found.machining.median is None:
        return []
    machining, measure = row.found.machining, user().measure
    return [
        (translate("Vk_Results", "Shortest move at feed"), measure(machining.shortest, 3), ""),
        (translate("Vk_Results", "Median move at feed"), measure(machining.median, 3), ""),
    ]


def _advice(row: Row):
    for simulator in SIMULATORS:
        chosen = row.found.advice.get(simulator.name)
        if chosen is not None:
            text = FreeCAD.Qt.translate("Vk_Results", simulator.advice.sentence)
            yield text.format(sentence(chosen.why), simulator=user().simulator(simulator.name))


def _table(cells: list[tuple[str, str, str]]) -> str:
    rows = []
    for title, text, range_ in cells:
        if text:
            told = lines(text) + (f"<br><small>{lines(range_)}</small>" if range_ else "")
            name = lines(title)
            rows.append(f"<tr><td style='padding-right: 12px'>{name}</td><td>{told}</td></tr>" if name
                        else f"<tr><td colspan='2'><small>{told}</small></td></tr>")  # fmt: skip
    return f"<table cellspacing='1'>{''.join(rows)}</table>"


def _link(target: str, text: str) -> str:
    return f"<a href='{target}'>{lines(text)}</a>"
