# SPDX-License-Identifier: LGPL-2.1-or-later
"""Calibrate machining times by a measured time: store the factor by which the machine is slower than computed."""

from __future__ import annotations

from contextlib import suppress

from vkworkbench import preferences
from vkworkbench.document.marks import marking
from vkworkbench.gui.qt import progress
from vkworkbench.gui.qt.names import QInputDialog, QWidget
from vkworkbench.gui.qt.plain_text import warn
from vkworkbench.gui.qt.sentences import user
from vkworkbench.gui.qt.text import translate
from vkworkbench.gui.results.rows import Row
from vkworkbench.report import Cancelled


def learn(row: Row, parent: QWidget) -> bool:
    """Ask for the time that the machine took for an operation or job, and store the factor for the computed times.

    Return whether the factor was stored.
    """
    title = translate("Vk_Results", "Measured Time")
    label = translate("Vk_Results", "Time that {label} took on the machine, in minutes and seconds, such as 17:30:")
    planned = row.found.machining_seconds
    answer, accepted = QInputDialog.getText(parent, title, label.format(label=row.label), text=user().clock(planned))
    if not accepted:
        return False
    measured = user().seconds_of(answer)
    factor = preferences.read().time_factor * (measured or 0.0) / planned
    if not preferences.is_possible("time_factor", factor):
        warn(title, translate("Vk_Results", "This is not a possible time. Enter it like 17:30 or 1:02:30."), parent)
        return False
    preferences.write(time_factor=factor)
    return True


def analyze_again(document) -> None:
    """Analyse a document again and update all its marks in the tree, without an undo step."""
    with suppress(Cancelled):
        marking.mark(progress.analyze(document), undo_step=False)
