# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job whose finished part is the stock of another job, as for the second side of a part."""

from __future__ import annotations

from vkworkbench import freecad
from vkworkbench.document.job.operations import kind
from vkworkbench.document.job.solids import move_between, shapes_of_model
from vkworkbench.document.job.undo_step import transaction
from vkworkbench.language import Message, Unusable

# A hidden link does not make the job depend on the previous job, so FreeCAD recomputes no operation.
_TYPE = "App::PropertyLinkHidden"


def previous_job(job):
    """Return the job whose finished part is the stock of a job; None without such a job."""
    other = freecad.PREVIOUS_JOB.of(job)
    return other if other is not None and kind(other) == "job" else None


def possible_previous_jobs(job) -> list:
    """Return the other jobs of the document that machine the same model and do not start from the part of this job."""
    shapes = shapes_of_model(job)
    return [
        other
        for other in job.Document.Objects
        if kind(other) == "job"
        and job not in _chain(other)
        and move_between(shapes_of_model(other), shapes) is not None
    ]


def set_previous_job(job, previous=None) -> None:
    """Let the simulation of a job start with the finished part of another job. The choice is saved, in one undo step.

    Parameters
    ----------
    job : DocumentObject
    previous : DocumentObject, optional
        Another job of the document. None stands for the job's own stock.

    Raises
    ------
    Unusable
        If `previous` is this job, or starts, directly or through further jobs, with the finished part of this job.
    """
    if previous is not None and job in _chain(previous):
        raise Unusable(Message("previous-in-circle", label=previous.Label))
    with transaction(job.Document, "Set Previous Job"):
        if not freecad.PREVIOUS_JOB.is_in(job):
            text = "Job whose finished part is the stock of this job"
            job.addProperty(_TYPE, freecad.PREVIOUS_JOB.name, freecad.ADDED_GROUP, text, freecad.HIDDEN_AND_OUTPUT)
        setattr(job, freecad.PREVIOUS_JOB.name, previous)


def _chain(job) -> list:
    """Return a job, its previous job, the previous job of this job, and so on."""
    found: list = []
    while job is not None and job not in found:
        found.append(job)
        job = previous_job(job)
    return found
