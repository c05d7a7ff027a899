# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulation leaves on the disk: a picture, pictures of the whole job, removal rates."""

from __future__ import annotations

import csv
from pathlib import Path

import FreeCAD
import numpy as np

from vkworkbench.gui.plain_text import warn
from vkworkbench.gui.qt import QApplication, QEventLoop, QFileDialog
from vkworkbench.gui.saving import proposed, with_suffix
from vkworkbench.gui.text import translate
from vkworkbench.spreadsheet import as_cell

_FRAMES = 120  # of the whole job
_COLUMNS = ("operation", "trajectory", "command", "begin_s", "end_s", "volume_mm3", "rate_mm3_per_min")


def save_picture(player) -> None:
    """Save what is seen to a file that the user chooses."""
    title = translate("Vk_Simulate", "Save Picture")
    path, _ = QFileDialog.getSaveFileName(player, title, _proposed(player, ".png"), "PNG (*.png)")
    path = with_suffix(path, ".png")
    if path and not player.view.grab().save(path, "PNG"):
        _not_written(player, path)


def save_frames(player) -> None:
    """Save pictures of the whole job, at equal distances in time, to a folder that the user chooses."""
    folder = QFileDialog.getExistingDirectory(player, translate("Vk_Simulate", "Folder of the Pictures"))
    if folder and player.simulation is not None:
        write_frames(player, Path(folder))


def write_frames(player, folder: Path, count: int = _FRAMES) -> None:
    """Write `count` pictures, numbered from 0000, from the stock to the part."""
    before = player.moment.seconds
    for number, seconds in enumerate(np.linspace(0, player.clock.total, count).tolist()):
        player.moment.go_to(seconds)
        player.pictures.show_now()
        path = folder / f"{number:04d}.png"
        if not player.view.grab().save(str(path), "PNG"):
            _not_written(player, str(path))
            break
        QApplication.processEvents(QEventLoop.ExcludeUserInputEvents)
    player.moment.go_to(before)


def save_rates(player) -> None:
    """Save what each trajectory removes, and how fast, to a CSV file that the user chooses."""
    title = translate("Vk_Simulate", "Save Removal Rates")
    path, _ = QFileDialog.getSaveFileName(player, title, _proposed(player, ".csv"), "CSV (*.csv)")
    path = with_suffix(path, ".csv")
    if path:
        try:
            write_rates(player, Path(path))
        except OSError:
            _not_written(player, path)


def write_rates(player, path: Path) -> None:
    """Write one line for each trajectory; operations' trajectories and commands are counted from 1, as in the window."""
    ends = player.clock.ends
    seconds = np.diff(ends)
    rates = 60 * player.volumes / np.where(seconds > 0, seconds, np.inf)
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(_COLUMNS)
        number = 0
        for operation, cut in zip(player.job.operations, player.job.cuts):
            for own, command in enumerate(cut.toolpath.command.tolist(), 1):
                numbers = (ends[number], ends[number + 1], player.volumes[number], rates[number])
                writer.writerow((as_cell(operation.label), own, command + 1, *(f"{value:.6g}" for value in numbers)))
                number += 1


def _proposed(player, suffix: str) -> str:
    document = FreeCAD.getDocument(player.job.operations[0].document)
    return proposed(document, document.Name + suffix)


def _not_written(player, path: str) -> None:
    warn(
        translate("Vk_Simulate", "Simulate toolpaths"),
        translate("Vk_Simulate", "{} cannot be written.").format(path),
        player,
    )
