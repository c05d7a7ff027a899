# SPDX-License-Identifier: LGPL-2.1-or-later
"""Commands for a job: set its clamps or its previous job, and save its simulated part as a mesh or an STL file."""

from __future__ import annotations

from collections.abc import Callable

import FreeCAD
import FreeCADGui as Gui

from vkworkbench.document.job.clamps import clamps_of, has_solid, set_clamps
from vkworkbench.document.job.operations import has_toolpath, job_of, kind
from vkworkbench.document.job.previous import possible_previous_jobs, previous_job, set_previous_job
from vkworkbench.document.simulation.simulate import Simulation, simulate_solid
from vkworkbench.gui.qt.document_command import DocumentCommand
from vkworkbench.gui.qt.plain_text import choose, inform, offer, show_status
from vkworkbench.gui.qt.progress import simulating
from vkworkbench.gui.qt.saving import ask_path
from vkworkbench.gui.qt.sentences import sentence
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, translate
from vkworkbench.gui.simulation.exports import write_stl
from vkworkbench.language import Unusable
from vkworkbench.report import Cancelled


class JobCommand(DocumentCommand):
    """A command for the selected job, for the job of a selected operation, or for the job of the active document.

    If there are several jobs, the command asks for one of them.
    """

    def Activated(self) -> None:
        if FreeCAD.ActiveDocument is None:
            return
        selected = Gui.Selection.getSelection()
        jobs = {obj.Name: obj for obj in map(_job_of, selected) if obj is not None}
        found = list(jobs.values()) or [obj for obj in FreeCAD.ActiveDocument.Objects if kind(obj) == "job"]
        if not found:
            self.tell(translate("Vk_Jobs", "The document has no job."))
        elif len(found) == 1:
            self._try(found[0], selected)
        else:
            text = translate("Vk_Jobs", "Choose the job:")
            _ask(self._title, text, found, [], lambda job: self._try(job, selected))

    def run(self, job, selected: list) -> None:
        """Run the command for a job, with the selected objects."""
        raise NotImplementedError

    @property
    def _title(self) -> str:
        return FreeCAD.Qt.translate(self.name, self.menu)

    def tell(self, text: str) -> None:
        """Show a message."""
        inform(self._title, text, Gui.getMainWindow())

    def _try(self, job, selected: list) -> None:
        try:
            self.run(job, selected)
        except Unusable as error:
            self.tell(sentence(error.what))


class ClampsCommand(JobCommand):
    """Make the selected solids the clamps of a job. If no solid is selected, offer to remove the present clamps."""

    name = "Vk_Clamps"
    menu = QT_TRANSLATE_NOOP("Vk_Clamps", "Set Clamps from Selection")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_Clamps",
        "Makes the selected solids, such as clamps and vices, the clamps of the job. "
        "The simulation warns if a tool, shank or holder collides with them. "
        "If no solid is selected, the command shows the present clamps and can remove them.",
    )

    def run(self, job, selected: list) -> None:
        of_job = {obj.Name for obj in job.OutListRecursive} - {obj.Name for obj in clamps_of(job)}
        solids = [obj for obj in selected if not has_toolpath(obj) and obj.Name not in of_job and has_solid(obj)]
        if solids:
            set_clamps(job, solids)
            show_status(_clamps_text(job))
            return
        advice = translate(
            "Vk_Clamps",
            "To set clamps, select their solids and start this command again. "
            "If the document has several jobs, select the job, too.",
        )
        if not clamps_of(job):
            none = translate("Vk_Clamps", "{} has no clamps.").format(job.Label)
            self.tell(f"{none} {advice}")
            return
        offer(
            self._title,
            f"{_clamps_text(job)} {advice}",
            translate("Vk_Clamps", "Remove Clamps"),
            lambda: _remove_clamps(job),
            Gui.getMainWindow(),
        )


def _remove_clamps(job) -> None:
    set_clamps(job, [])
    show_status(translate("Vk_Clamps", "{} has no clamps.").format(job.Label))


def _clamps_text(job) -> str:
    labels = ", ".join(obj.Label for obj in clamps_of(job))
    return translate("Vk_Clamps", "Clamps of {}: {}.").format(job.Label, labels)


class PreviousJobCommand(JobCommand):
    """Choose the previous job of a job: the job whose finished part is its stock.

    Both jobs machine the same model, for example from two sides.
    """

    name = "Vk_PreviousJob"
    menu = QT_TRANSLATE_NOOP("Vk_PreviousJob", "Begin with the Part of Another Job")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_PreviousJob",
        "Lets the simulation of the job begin with the part that another job leaves, as for the second side of a part. "
        "The part is moved and turned with the model.",
    )

    def run(self, job, selected: list) -> None:
        jobs = possible_previous_jobs(job)
        if not jobs:
            text = translate("Vk_PreviousJob", "No other job of this document machines the part of {}.")
            self.tell(text.format(job.Label))
            return
        text = translate("Vk_PreviousJob", "The simulation of {} begins with:").format(job.Label)
        own = translate("Vk_PreviousJob", "The stock of {}").format(job.Label)
        _ask(self._title, text, [None, *jobs], [own], lambda other: self._choose(job, other), previous_job(job))

    def _choose(self, job, other) -> None:
        set_previous_job(job, other)
        if other is None:
            show_status(translate("Vk_PreviousJob", "{} begins with its own stock.").format(job.Label))
        else:
            text = translate("Vk_PreviousJob", "{} begins with the part that {} leaves.")
            show_status(text.format(job.Label, other.Label))


class AddMeshCommand(JobCommand):
    """Simulate a job, and add the finished part to the document as a mesh."""

    name = "Vk_AddMesh"
    menu = QT_TRANSLATE_NOOP("Vk_AddMesh", "Add Simulated Part as Mesh")
    tooltip = QT_TRANSLATE_NOOP(
        "Vk_AddMesh", "Simulates the job, and adds the part that it leaves to the document as a mesh."
    )

    def run(self, job, selected: list) -> None:
        done = _simulated(job, self._title)
        if done is not None:
            added = done.add_mesh()
            show_status(translate("Vk_AddMesh", "{} was added to the document.").format(added.Label))


class SaveStlCommand(JobCommand):
    """Simulate a job, and save the finished part as an STL file."""

    name = "Vk_SaveStl"
    menu = QT_TRANSLATE_NOOP("Vk_SaveStl", "Save Simulated Part as STL")
    tooltip = QT_TRANSLATE_NOOP("Vk_SaveStl", "Simulates the job, and saves the part that it leaves as an STL file.")

    def run(self, job, selected: list) -> None:
        window = Gui.getMainWindow()
        path = ask_path(window, self._title, job.Document, ".stl")
        done = _simulated(job, self._title) if path else None
        if done is not None:
            write_stl(done, path, self._title, window)


def _simulated(job, title: str) -> Simulation | None:
    """Return the simulation of a job; None if the user cancelled it."""
    text = translate("Vk_Jobs", "Simulating {}…").format(job.Label)
    try:
        with simulating(title, text) as going_on:
            return simulate_solid(job, going_on)
    except Cancelled:
        show_status(translate("Vk_Jobs", "The simulation was cancelled. Nothing has changed."))
        return None


def _job_of(obj):
    return obj if kind(obj) == "job" else job_of(obj) if has_toolpath(obj) else None


def _ask(title: str, text: str, jobs: list, names: list[str], take: Callable, present=None) -> None:
    """Ask for one of several jobs, and call `take` with the chosen job.

    The list shows `names` for the first entries of `jobs`, and the labels for the others.
    """
    labels = names + [f"{number}. {job.Label}" for number, job in enumerate(jobs[len(names) :], 1)]
    shown = jobs.index(present) if present in jobs else 0
    choose(title, text, labels, lambda number: take(jobs[number]), Gui.getMainWindow(), shown)


for command in (ClampsCommand, PreviousJobCommand, AddMeshCommand, SaveStlCommand):
    command.add()
