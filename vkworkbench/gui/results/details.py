# SPDX-License-Identifier: LGPL-2.1-or-later
"""The details of a row in the results panel, as HTML.

The details begin with a description in plain words; the link "Why?" shows the reasons in the paper's terms.
"""

from __future__ import annotations

from vkworkbench.gui.qt import colors
from vkworkbench.gui.qt.plain_text import lines
from vkworkbench.gui.qt.sentences import plain_sentence, sentence, user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.results.columns import LENGTH, NOTES, OPERATION, REASON, STATE, STRATEGY, WARNINGS
from vkworkbench.gui.results.rows import Row
from vkworkbench.gui.tree.notices import Level
from vkworkbench.report import OperationReport, is_switched_off

WHY, NUMBERS, GAUSS_MAP, MEASURED = "why", "numbers", "gauss-map", "measured"  # targets of links in the details
_SIGNS = {
    Level.NOTE: ("i", colors.NOTE_SIGN), Level.WARNING: ("\u26a0", colors.WARNING_SIGN), Level.ERROR: ("\u2716", colors.ERROR_SIGN),
}  # fmt: skip
# Columns whose values are not in the table of the details, because other parts of the details show them.
_APART = {OPERATION, STRATEGY, WARNINGS, NOTES, STATE, LENGTH, REASON}


def page(row: Row, first: list, others: list, opened: set[str]) -> str:
    """Return the details of a row as HTML, with the default columns (`first`) and the other columns.

    `opened` contains the targets of the links that the user has opened, such as "Why?".
    """
    parts = [_title(row)]
    if row.strategy is not None and not is_switched_off(row.mark):
        parts.append(_strategy(row, WHY in opened))
    parts += [_notice(notice) for notice in row.notices]
    if row.outdated:
        text = translate(
            "Vk_Results",
            "This result is outdated, because the toolpath, the tool or the stock has "
            "changed. Analyze the operation again.",
        )
        parts.append(f"<i>{lines(text)}</i>")
    html = "".join(f"<p>{part}</p>" for part in parts)
    html += _table(_cells(row, first) + _machining(row))
    if row.found.setup.planned and row.found.machining_seconds:
        html += "<p>" + _link(MEASURED, translate("Vk_Results", "Enter the Measured Time…")) + "</p>"
    if NUMBERS not in opened:
        return html + "<p>" + _link(NUMBERS, translate("Vk_Results", "All Numbers")) + "</p>"
    html += _table(_cells(row, others) + _moves(row))
    if row.found.resolution is not None:
        recommended = translate("Vk_Results", "Recommended image: {}").format(sentence(row.found.resolution.why))
        html += f"<p>{lines(recommended)}</p>"
    return html + "<p>" + _link(NUMBERS, translate("Vk_Results", "Fewer Numbers")) + "</p>"


def _title(row: Row) -> str:
    return f"<b>{lines(row.label)}</b>: {lines(row.kind)}"


def _strategy(row: Row, why: bool) -> str:
    link = _link(WHY, translate("Vk_Results", "Why?"))
    text = f"{lines(' '.join(map(plain_sentence, row.mark.reason)))} {link}"
    if not why:
        return text
    more = [lines(sentence(reason)) for reason in row.mark.reason]
    if row.strategy.is_answer:
        sure = translate("Vk_Results", "Confidence: {share}").format(share=user().share(row.found.confidence))
        more.append(lines(sure))
    more.append(_link(GAUSS_MAP, translate("Vk_Results", "Show in the Gauss Map")))
    return "<br>".join([text, *more])


def _notice(notice) -> str:
    sign, color = _SIGNS[notice.level]
    return f"<b style='color: {color}'>{sign}</b> {lines(notice.text)}"


def _cells(row: Row, columns: list) -> list[tuple[str, str, str]]:
    return [(column.name, column.text(row), column.remark(row)) for column in columns if column.key not in _APART]


def _machining(row: Row) -> list[tuple[str, str, str]]:
    """Return the lengths of a row's moves, and remarks on moves that the machining time does not include."""
    if not row.found.trajectories:
        return []
    length = user().length
    cells = [(translate("Vk_Results", "Cutting Length"), length(row.found.length), "")]
    if row.is_total:
        return cells
    if isinstance(row.found, OperationReport):  # marks in the tree have no rapid length and depth
        machining = row.found.machining
        cells.append((translate("Vk_Results", "Rapid Length"), length(machining.rapid_length), ""))
        if machining.depth is not None:
            cells.append((translate("Vk_Results", "Depth"), length(machining.depth), ""))
    return cells + [("", sentence(message), "") for message in row.found.left_out]


def _moves(row: Row) -> list[tuple[str, str, str]]:
    """Return the shortest and the median length of feed moves. Thousands of tiny moves explain a long simulation."""
    if row.is_total or not isinstance(row.found, OperationReport) or row.found.machining.median is None:
        return []
    machining, measure = row.found.machining, user().measure
    return [
        (translate("Vk_Results", "Shortest Move at Feed"), measure(machining.shortest, 3), ""),
        (translate("Vk_Results", "Median Move at Feed"), measure(machining.median, 3), ""),
    ]


def _table(cells: list[tuple[str, str, str]]) -> str:
    rows = []
    for title, text, remark in cells:
        if text:
            cell = lines(text) + (f"<br><small>{lines(remark)}</small>" if remark else "")
            name = lines(title)
            rows.append(f"<tr><td style='padding-right: 12px'>{name}</td><td>{cell}</td></tr>" if name
                        else f"<tr><td colspan='2'><small>{cell}</small></td></tr>")  # fmt: skip
    return f"<table cellspacing='1'>{''.join(rows)}</table>"


def _link(target: str, text: str) -> str:
    return f"<a href='{target}'>{lines(text)}</a>"
