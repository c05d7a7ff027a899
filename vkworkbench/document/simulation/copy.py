# SPDX-License-Identifier: LGPL-2.1-or-later
"""Copy the operations of a job from a document, and linearise the copies in any thread."""

from __future__ import annotations

from collections.abc import Callable, Container, Generator, Iterable, Iterator
from dataclasses import dataclass, replace
from queue import Empty, SimpleQueue

import FreeCAD

from vkworkbench import preferences
from vkworkbench.core import Cut, Stock, Tool, Toolpath, linearize
from vkworkbench.core.gcode import Words, in_seconds, used_up
from vkworkbench.core.recognition import is_turned
from vkworkbench.core.zbuffer import part_triangles
from vkworkbench.document.job.clamps import clamp_solids, clamps_of, readable_clamps, shapes_of
from vkworkbench.document.job.fingerprint import (
    finding_path_fingerprint,
    fingerprint_of,
    path_and_setting,
    path_fingerprint,
    read_setting_fingerprints,
    setting_fingerprint,
    surroundings_fingerprint,
    text_fingerprint,
    text_of,
)
from vkworkbench.document.job.listing import Listing
from vkworkbench.document.job.operations import (
    Operation,
    find,
    is_imported,
    is_object,
    jobs_of,
    or_active_document,
    posted,
)
from vkworkbench.document.job.previous import previous_job
from vkworkbench.document.job.recognition import rotary_cut
from vkworkbench.document.job.setting import placed, rapid_feeds, read_stock, read_tool, tool_remark, vertical_feed
from vkworkbench.document.job.solids import form_of_stock, have_equal_shapes, model_shapes, shapes_of_model, stock_solid
from vkworkbench.document.job.work_offsets import WorkOffsets
from vkworkbench.document.simulation.allowed_depth import allowed_depth, with_stroke_depth
from vkworkbench.document.simulation.along_axis import zbuffer_along_axis
from vkworkbench.document.simulation.job import SimulatedJob, SimulatedOperation
from vkworkbench.document.simulation.solid import stock_after
from vkworkbench.language import Message, Unusable
from vkworkbench.report import fingerprint_of_job

_WAIT = 0.05  # s between two calls of `going_on` while waiting for a copy


@dataclass(frozen=True)
class _Copied:
    """Copies of one operation's properties. The fingerprint of the copied path is not yet computed."""

    operation: SimulatedOperation
    path: object
    placement: object
    tool: Tool | None
    vertical_feed: float
    allowed_depth: float  # depth to which the operation may cut into the model, mm; see `Cut`
    simplified: Message | None  # the remark that a simpler shape is simulated instead of the tool
    no_tool: Message | None  # the reason why the tool is unknown


@dataclass(frozen=True, eq=False)
class ReadCut:
    """An operation that was copied and linearised."""

    operation: SimulatedOperation
    cut: Cut | None  # the toolpath and the tool; None if the operation cannot be simulated
    as_read: Toolpath | None = None
    listing: Listing | None = None  # see `SimulatedJob`
    remarks: tuple[Message, ...] = ()  # what the simulation simplifies in the operation
    unread: tuple[Message, ...] = ()  # parts of the operation that could not be read


class JobCopy:
    """Copies of a job's operations. The main thread makes the copies one by one, and another thread reads them."""

    def __init__(self, objects: list, job, asked: list, clamps: Iterable | None = None) -> None:
        previous = None if job is None else previous_job(job)
        self._previous = None if previous is None else _copy_previous(previous)
        self._previous_name = previous and previous.Name
        self._asked = tuple(obj.Name for obj in asked if is_object(obj))
        self.document = objects[0].Document.Name
        self.names = tuple(obj.Name for obj in objects)
        self.labels = tuple(obj.Label for obj in objects)
        self._objects = objects
        self._box = read_stock(job)
        self._form = form_of_stock(job, self._box)
        self._stock, remark = stock_solid(job, self._box)
        self._model_shapes = model_shapes(job)
        self._model = shapes_of_model(job)
        # Height of the surface into which an engraving is cut, mm.
        self._top = max((shape.BoundBox.ZMax for shape in self._model_shapes), default=float(self._box.upper[2]))
        self._settings: dict[str, str] = {}  # fingerprints of the settings, by the names of operations
        self._paths: dict[str, str] = {}
        self._given_clamps = None if clamps is None else tuple(clamps)
        self._clamp_shapes = shapes_of(self._clamps_of(job))
        self._unread = (remark,) if remark else ()
        if clamps is None:
            self._clamps, not_closed = readable_clamps(self._clamps_of(job))
            self._unread += not_closed
        else:
            self._clamps = clamp_solids(self._given_clamps)
        self._job_name = "" if job is None else job.Name
        posted_by_job = [o.object.Name for o in find(job) if o.counted] if job is not None else []
        is_whole = clamps is None and posted_by_job == list(self.names)
        self._surroundings = surroundings_fingerprint(job) if is_whole else ""
        self._offsets = WorkOffsets(job)
        chosen = preferences.read()
        self._tolerance, self._holder = chosen.tolerance, chosen.holder
        self._copied: SimpleQueue = SimpleQueue()

    def copying(self) -> Iterator[None]:
        """Copy one operation in each step. FreeCAD can handle events between two steps.

        A ReferenceError is raised if an operation was deleted between two steps.
        """
        if self._previous is not None:
            yield from self._previous.copying()
        for obj in self._objects:
            copied = _copied(obj, self._box, self._form, self._holder)
            self._settings[obj.Name] = copied.operation.fingerprint
            self._copied.put(copied)
            yield

    def read(self, going_on: Callable[[], None] = lambda: None) -> Iterator[ReadCut]:
        """Yield each operation, linearised, as soon as it is copied. An exception from `going_on` ends the work.

        If the job has a previous job, the previous job is simulated first, and its finished part becomes the stock.
        """
        if self._previous is not None:
            self._begin_with(self._previous.job(self._previous.read(going_on)), going_on)
        for name in self.names:
            read = _linearized(self._next(going_on), self._tolerance, self._offsets)
            path, setting = path_and_setting(read.operation.fingerprint)
            if setting:
                self._paths[name] = path
            yield read

    def _begin_with(self, previous: SimulatedJob, going_on: Callable[[], None]) -> None:
        """Simulate the previous job and use its finished part as the stock of this job."""
        budget = preferences.read().memory_budget_bytes
        zbuffer = zbuffer_along_axis(previous, budget, lambda _: going_on())
        self._stock, remark = stock_after(part_triangles(zbuffer), previous.model_shapes, self._model_shapes)
        self._unread += (*((remark,) if remark else ()), *previous.unread)

    def asked(self):
        """Return the objects that the user chose and that still exist; the whole document if no object exists."""
        document = FreeCAD.getDocument(self.document)
        return [obj for obj in map(document.getObject, self._asked) if obj is not None] or document

    def comparing(self, changed: Container[str]) -> Generator[None, None, bool]:
        """Compare the document with the copies, in steps of milliseconds; return whether both are equal.

        `changed` contains the names of the operations whose path has possibly changed.
        """
        try:
            objects, job = _posted(self.asked())
            previous = None if job is None else previous_job(job)
            if (previous and previous.Name) != self._previous_name:
                return False
            if self._previous is not None and not (yield from self._previous.comparing(changed)):
                return False
            same = have_equal_shapes(shapes_of_model(job), self._model) and have_equal_shapes(
                shapes_of(self._clamps_of(job)), self._clamp_shapes
            )
        except Unusable:  # the document was changed, for example so that the objects belong to several jobs
            return False
        if not same or tuple(obj.Name for obj in objects) != self.names:
            return False
        for obj in objects:
            if read_setting_fingerprints(obj, job)[0] != self._settings[obj.Name]:
                return False
            yield
            if obj.Name in changed and obj.Name in self._paths:
                yield from finding_path_fingerprint(obj)
                if path_fingerprint(obj) != self._paths[obj.Name]:
                    return False
        return True

    def job(self, read: Iterable[ReadCut]) -> SimulatedJob:
        """Return the job that consists of the operations `read`. Raise `Unusable` if no operation can be simulated."""
        read = tuple(read)
        cuts = [one for one in read if one.cut is not None]
        remarks = tuple(remark for one in read for remark in (*one.unread, *one.remarks))
        if not cuts:
            raise Unusable(remarks[0] if remarks else Message("nothing-to-simulate"))
        unread = tuple(remark for one in read for remark in one.unread)
        return SimulatedJob(
            tuple(one.operation for one in cuts),
            tuple(with_stroke_depth(one.operation, one.cut, self._top) for one in cuts),
            tuple(one.as_read for one in cuts),
            tuple(one.listing for one in cuts),
            self._stock,
            self._model_shapes,
            remarks + self._unread,
            self._clamps,
            unread + self._unread,
            tuple((one.operation.document, one.operation.name) for one in read if one.cut is None),
            self._job_name,
            fingerprint_of_job((one.operation.fingerprint for one in read), self._surroundings)
            if self._surroundings
            else "",
        )

    def _clamps_of(self, job) -> tuple:
        return clamps_of(job) if self._given_clamps is None else self._given_clamps

    def _next(self, going_on: Callable[[], None]) -> _Copied:
        while True:
            going_on()
            try:
                copied: _Copied = self._copied.get(timeout=_WAIT)
            except Empty:
                continue
            return copied


def read_job(what=None, clamps: Iterable | None = None) -> SimulatedJob:
    """Return the job to simulate; see :func:`vkworkbench.simulate`."""
    copy = copy_job(what, clamps)
    for _ in copy.copying():
        pass
    return copy.job(copy.read())


def copy_job(what=None, clamps: Iterable | None = None) -> JobCopy:
    """Return the job to simulate, before its operations are copied; see :func:`vkworkbench.simulate`."""
    what = or_active_document(what)
    asked = list(what) if isinstance(what, Iterable) else [what]
    objects, job = _posted(asked)
    if not objects:
        raise Unusable(Message("nothing-to-simulate"))
    return JobCopy(objects, job, asked, clamps)


def _copy_previous(job) -> JobCopy:
    try:
        return copy_job(job)
    except Unusable as error:
        raise Unusable(Message("of", label=job.Label, sentence=error.what)) from None


def _copied(obj, box: Stock, form: tuple, holder: dict[str, float]) -> _Copied:
    tool = simplified = no_tool = None
    try:
        tool, simplified = read_tool(obj), tool_remark(obj)
    except Unusable as error:
        no_tool = error.what
    rapids = rapid_feeds(obj)
    setting = setting_fingerprint(tool, box, form, rapids)
    if tool is not None and tool.holder_diameter is None:
        tool = replace(tool, **holder)
    operation = SimulatedOperation(obj.Document.Name, obj.Name, obj.Label, rapids, is_imported(obj), setting)
    allowed = allowed_depth(obj, tool, simplified)
    return _Copied(operation, obj.Path, obj.Placement, tool, vertical_feed(obj), allowed, simplified, no_tool)


def _linearized(copied: _Copied, tolerance: float, offsets: WorkOffsets) -> ReadCut:
    def of(*found: Message | None) -> tuple[Message, ...]:
        return tuple(Message("of", label=copied.operation.label, sentence=remark) for remark in found if remark)

    commands = copied.path.Commands
    text = text_of(copied.path, commands)
    listing, path = Listing(text, commands), text_fingerprint(text, copied.placement)
    operation = replace(copied.operation, fingerprint=fingerprint_of(path, copied.operation.fingerprint))
    try:
        words = Words(used_up(commands))
        toolpath = linearize(words, tolerance=tolerance)
        offset = offsets.remark(words, toolpath)
        toolpath = placed(toolpath, copied.placement)
    except Unusable as error:
        return ReadCut(operation, None, unread=of(error.what))
    unread = of(*(problem.remark for problem in toolpath.problems if not problem.of_time), offset)
    if not len(toolpath) or rotary_cut(toolpath):
        return ReadCut(operation, None, unread=unread)
    if copied.tool is None:
        return ReadCut(operation, None, unread=of(copied.no_tool))
    feeding, minutes = in_seconds(toolpath) if operation.imported else (toolpath, None)
    listing.in_minutes = minutes is not None
    cut = Cut(feeding, copied.tool, copied.vertical_feed, copied.allowed_depth)
    turned = Message("turned") if is_turned(toolpath) else None
    return ReadCut(operation, cut, toolpath, listing, of(copied.simplified, minutes), (*unread, *of(turned)))


def _posted(what) -> tuple[list, object]:
    """Return the objects to simulate, in the order of their job, and their job; None if they have no job."""
    operations = _chosen(find(what))
    return [operation.object for operation in operations], operations[0].job if operations else None


def _chosen(found: list[Operation]) -> list[Operation]:
    """Return the operations that are posted, in the order of their job.

    Raise `Unusable` if the operations have several jobs.
    """
    operations = posted(found)
    jobs = jobs_of(operations)
    if len(jobs) > 1:
        raise Unusable(Message("several-jobs", labels=[job.Label for job in jobs.values()]))
    order = [o.object for job in jobs.values() for o in find(job)]
    return sorted(operations, key=lambda o: order.index(o.object) if o.object in order else len(order))
