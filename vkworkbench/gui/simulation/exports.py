# SPDX-License-Identifier: LGPL-2.1-or-later
"""Save pictures, the shown part as a solid, or removal rates."""

from __future__ import annotations

import csv
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from errno import EIO
from itertools import chain, count
from os import strerror
from pathlib import Path

import FreeCAD
import numpy as np

from vkworkbench.document.simulation.simulate import Simulation
from vkworkbench.gui.qt import progress
from vkworkbench.gui.qt.names import QApplication, QEventLoop, QFileDialog, Qt, QWidget
from vkworkbench.gui.qt.plain_text import show_status, warn
from vkworkbench.gui.qt.saving import ask_path, folder_of
from vkworkbench.gui.qt.sentences import user
from vkworkbench.gui.qt.text import translate
from vkworkbench.report import SimulatedPart, as_cell

_FRAMES = 120  # number of pictures of the whole job
_COLUMNS = ("operation", "trajectory", "command", "begin_s", "end_s", "volume_mm3", "rate_mm3_per_min")


def save_picture(player) -> None:
    """Save the shown picture to a file that the user chooses."""
    title = translate("Vk_Simulate", "Save Picture")
    path = ask_path(player, title, _document(player), ".png")
    if path and not player.view.grab().save(path, "PNG"):
        _not_written(player, path)


def save_frames(player) -> None:
    """Save pictures of the whole job, at equal time intervals, in a new folder inside a folder that the user chooses.

    The function waits for the finest simulation before it saves pictures.
    """
    title = translate("Vk_Simulate", "Folder for the Pictures")
    chosen = QFileDialog.getExistingDirectory(player, title, str(folder_of(_document(player))))
    if not chosen:
        return
    text = translate("Vk_Simulate", "The pictures are saved when the finest picture is ready…")
    dialog = progress.dialog_of(translate("Vk_Simulate", "Simulate Toolpaths"), text, player, delay=0)
    dialog.setMaximum(_FRAMES)

    def going_on(done: int) -> bool:
        dialog.setValue(done)
        QApplication.processEvents()
        return not dialog.wasCanceled() and player.simulation is not None

    try:
        while player.refines and going_on(0):
            QApplication.processEvents(QEventLoop.WaitForMoreEvents)
        if going_on(0):
            folder = _new_folder(Path(chosen), _document(player).Name)
            done = write_frames(player, folder, _FRAMES, going_on)
            text = translate("Vk_Simulate", "{} of {} pictures are saved in {}.")
            text = text.format(user().count(done), user().count(_FRAMES), folder)
            show_status(text)
    except OSError as error:
        _not_written(player, error.filename)
    finally:
        dialog.close()
        dialog.deleteLater()


def _new_folder(parent: Path, document: str) -> Path:
    """Create a folder for the pictures of a document. If a folder of this name exists, append a number to the name."""
    name = translate("Vk_Simulate", "{} pictures").format(document)
    numbered = chain([name], (f"{name} {number}" for number in count(2)))
    folder = next(folder for folder in map(parent.joinpath, numbered) if not folder.exists())
    folder.mkdir()
    return folder


def write_frames(player, folder: Path, number: int, going_on: Callable[[int], bool]) -> int:
    """Write `number` pictures of the simulation, from the raw stock to the finished part; return how many were written.

    The pictures are numbered from 0000. `going_on` is called before each picture with the number of written pictures;
    the result False ends the writing. At the end the player shows the same moment as before. An OSError is raised if a
    picture cannot be written.
    """
    moment = player.moment
    before = moment.seconds, moment.noticed
    written = 0
    try:
        for seconds in np.linspace(0, player.clock.total, number).tolist():
            if not going_on(written):
                break
            moment.go_to(seconds)
            player.pictures.show_now()
            path = str(folder / f"{written:04d}.png")
            if not player.view.grab().save(path, "PNG"):
                raise OSError(EIO, strerror(EIO), path)
            written += 1
    finally:
        if player.simulation is not None:
            moment.go_to(*before)
            player.pictures.show_now()
    return written


def save_part(player) -> None:
    """Save the part at the shown moment as a closed solid, in an STL file that the user chooses."""
    title = translate("Vk_Simulate", "Save Part as STL")
    path = ask_path(player, title, _document(player), ".stl")
    if path:
        with _waiting():
            write_stl(_part(player), path, title, player)


def write_stl(part: SimulatedPart, path: str, title: str, parent: QWidget) -> None:
    """Write a part to an STL file, and show in the status bar that it is saved, or the reason why it is not."""
    try:
        part.save_stl(path)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        warn(title, translate("Vk_SaveStl", "{} cannot be written: {}").format(path, reason), parent)
    else:
        show_status(translate("Vk_SaveStl", "The part is saved in {}.").format(path))


def add_part(player) -> None:
    """Add the part at the shown moment to the document as a mesh."""
    with _waiting():
        added = _part(player).add_mesh()
    show_status(translate("Vk_AddMesh", "{} was added to the document.").format(added.Label))


def _part(player) -> Simulation:
    return player.simulation.at(player.moment.done)


@contextmanager
def _waiting() -> Iterator[None]:
    """Show that FreeCAD is busy."""
    QApplication.setOverrideCursor(Qt.WaitCursor)
    try:
        yield
    finally:
        QApplication.restoreOverrideCursor()


def save_rates(player) -> None:
    """Save the removed volume and the removal rate of each trajectory to a CSV file that the user chooses."""
    title = translate("Vk_Simulate", "Save Removal Rates")
    path = ask_path(player, title, _document(player), ".csv")
    if path:
        try:
            write_rates(player, Path(path))
        except OSError:
            _not_written(player, path)


def write_rates(player, path: Path) -> None:
    """Write one CSV line for each trajectory.

    The trajectories and commands of each operation are numbered from 1, as in the simulation tab.
    """
    ends, rates = player.clock.ends, player.clock.rates(player.volumes)
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(_COLUMNS)
        number = 0
        for operation, cut in zip(player.job.operations, player.job.cuts):
            for own, command in enumerate(cut.toolpath.command.tolist(), 1):
                numbers = (ends[number], ends[number + 1], player.volumes[number], rates[number])
                writer.writerow((as_cell(operation.label), own, command + 1, *(f"{value:.6g}" for value in numbers)))
                number += 1


def _document(player):
    return FreeCAD.getDocument(player.job.operations[0].document)


def _not_written(player, path: str) -> None:
    warn(
        translate("Vk_Simulate", "Simulate Toolpaths"),
        translate("Vk_Simulate", "{} cannot be written.").format(path),
        player,
    )
