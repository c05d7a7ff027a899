# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read the properties of one operation that an analysis needs."""

from __future__ import annotations

import traceback
from collections.abc import Callable
from dataclasses import dataclass, fields, replace

import FreeCAD

from vkworkbench import freecad
from vkworkbench.core import Solid, Tool
from vkworkbench.document.job.fingerprint import setting_fingerprint
from vkworkbench.document.job.intent import name_of_intent
from vkworkbench.document.job.operations import Operation, is_imported, is_there, takes_tool
from vkworkbench.document.job.setting import controller_of, rapid_feeds, read_stock, read_tool, tool_remark
from vkworkbench.document.job.solids import form_of_stock, stock_is_model, stock_solid
from vkworkbench.language import Message, Unusable


@dataclass(frozen=True)
class Reading:
    """Copies of one operation's properties, which another thread may read."""

    document: str
    document_id: str
    name: str
    label: str
    job: str | None
    counted: bool
    active: bool
    intent: str | None = None
    imported: bool = False
    takes_tool: bool = True
    has_controller: bool = False
    tool_name: str = ""
    path: object = None
    placement: object = None
    tool: Tool | None = None
    stock: Solid | None = None
    stock_is_model: bool = False
    remarks: tuple[Message, ...] = ()
    rapid_feeds: tuple[float, float] = (0.0, 0.0)
    setting_fingerprint: str = ""
    error: Exception | None = None


# IDENTITY: the fields of a reading that identify the operation. SETTINGS: all other fields on which the results of the
# analysis depend, except path and placement.
IDENTITY = ("document", "document_id", "name", "label", "job", "counted")
SETTINGS = tuple(
    field.name for field in fields(Reading)
    if field.name not in (*IDENTITY, "path", "placement", "setting_fingerprint")
)  # fmt: skip


def read(operation: Operation) -> Reading:
    """Read an operation. An error is stored in the reading, so that all other operations are still analysed."""
    obj, job = operation.object, operation.job
    job = job if job is not None and is_there(job) else None  # a deleted job can leave its operations in the document
    reading = Reading(
        document=obj.Document.Name,
        document_id=obj.Document.Uid,
        name=obj.Name,
        label=obj.Label,
        job=job.Name if job is not None else None,
        counted=operation.counted,
        active=operation.active,
    )
    remarks: list[Message] = []
    try:
        tool, box = _or_remark(remarks, read_tool, obj), _or_remark(remarks, read_stock, job)
        stock, remark = stock_solid(job, box) if box else (None, None)
        remarks += [one for one in (remark, tool and tool_remark(obj)) if one]
        controller = controller_of(obj)
        form, rapids = form_of_stock(job, box) if box else (), rapid_feeds(obj)
        return replace(
            reading,
            intent=name_of_intent(obj),
            imported=is_imported(obj),
            takes_tool=takes_tool(obj),
            has_controller=controller is not None,
            tool_name="" if controller is None else f"T{freecad.TOOL_NUMBER.of(controller, 0)}",
            path=obj.Path,
            placement=obj.Placement,
            tool=tool,
            stock=stock,
            stock_is_model=bool(box) and stock_is_model(job),
            remarks=tuple(remarks),
            rapid_feeds=rapids,
            setting_fingerprint=setting_fingerprint(tool, box, form, rapids),
        )
    except ReferenceError:  # the object was deleted
        raise
    except Exception as error:
        FreeCAD.Console.PrintLog(traceback.format_exc())
        return replace(reading, error=error)


def _or_remark(remarks: list[Message], reader: Callable, source):
    """Return ``reader(source)``; if that fails, return None and add the reason to the remarks."""
    try:
        return reader(source)
    except Unusable as error:
        remarks.append(error.what)
        return None
