# SPDX-License-Identifier: LGPL-2.1-or-later
"""Read, write and refresh the mark of one operation or job in the tree.

The description of an object (the property Label2, which the tree shows in its Description column) contains the text of
a mark in brackets, after the user's own words. A hidden property holds all data of the mark, including this text.
FreeCAD can open a marked file also without this add-on.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from typing import Any

from vkworkbench import preferences
from vkworkbench.core import Strategy
from vkworkbench.core.simulators import ZBUFFER
from vkworkbench.document.job import results
from vkworkbench.document.job.fingerprint import (
    path_and_setting,
    path_fingerprint,
    surroundings_fingerprint,
    text_fingerprint,
)
from vkworkbench.document.job.operations import find, fixtures_of, is_active
from vkworkbench.document.marks import properties as mark_properties
from vkworkbench.document.marks import record
from vkworkbench.document.marks.record import Record
from vkworkbench.document.marks.text import CLOSING, OPENING, SEPARATOR, SIMULATION, SWITCHED_OFF, text_of
from vkworkbench.preferences import Preferences
from vkworkbench.report import JobVerdict, OperationReport, fingerprint_of_job, total_of

_BRACKETS = re.compile(f" ?{OPENING}([^{OPENING}{CLOSING}]*){CLOSING}")
# The text of a mark, as any version of this add-on writes it: with a confidence, with a time, or with a strategy only.
_LIKE_A_MARK = re.compile(
    rf"\S.*?(?: \d{{1,3}} ?%|{SEPARATOR}(?:{SIMULATION}|▶) .+)(?:{SEPARATOR}.*|$)|"
    rf"(?:{'|'.join(strategy.value for strategy in Strategy)}|{SWITCHED_OFF}|\d+ operations?(?: x\d+)?)(?:{SEPARATOR}.*)?"
)


def read(obj) -> Record | None:
    """Return the mark of an object in the tree; None without a mark, or with a mark of an unknown format."""
    known = _kept(obj)
    return known and replace(known, label=obj.Label).shown


def _kept(obj) -> Record | None:
    """Return the stored mark of an object; for an inactive operation, its mark from before it was switched off."""
    return record.from_json(mark_properties.mark_data(obj))


def is_marked(obj) -> bool:
    """Return whether an object has a mark, or at least one property of a mark."""
    return bool(mark_properties.ours(obj))


def is_outdated(obj) -> bool:
    """Return whether the mark of an object is outdated."""
    known = read(obj)
    return known is not None and known.outdated


def is_shown(obj) -> bool:
    """Return whether the user has left the mark's text in the description, or the description is locked."""
    return any(_segments(obj)) or _is_locked(obj)


def words_of(obj) -> str:
    """Return the user's own words in an object's description."""
    label2 = obj.Label2
    for start, end in reversed(list(_segments(obj))):
        label2 = label2[:start] + label2[end:]
    return label2


def with_words(obj, words: str) -> str:
    """Return the description of an object with new words of the user, followed by the text of the mark."""
    segments = [obj.Label2[start:end].strip() for start, end in _segments(obj)]
    return " ".join(filter(None, [words.strip(), *segments[-1:]]))


def _segments(obj) -> Iterator[tuple[int, int]]:
    """Yield where texts of the mark begin and end in an object's description, without brackets that the user wrote."""
    if not (mark_properties.may_have_mark(obj) or is_marked(obj)):
        return
    written, own = mark_properties.text_written(obj), mark_properties.own_brackets(obj)
    for bracket in _BRACKETS.finditer(obj.Label2):
        text = bracket.group(1)
        if text == written or (_LIKE_A_MARK.fullmatch(text) and text not in own):
            yield bracket.span()


def write(obj, report: OperationReport, chosen: Preferences, *, outdated: bool) -> None:
    """Mark an operation with its report. The mark shows the time in the simulator of the preferences."""
    made = record.of_operation(report, chosen.simulator)
    _keep(obj, replace(made, outdated=outdated), chosen, new=True)


def write_total(job, chosen: Preferences, verdict: JobVerdict | None = None) -> None:
    """Mark a job with the total of its operations' marks. A job with an unmarked operation gets no mark.

    A new verdict replaces the verdict in the job's mark only if the new verdict is valid for the job as it is now.
    """
    parts = _parts(job)
    if not parts or None in parts.values():
        if is_marked(job):
            erase(job)
        return
    if verdict is not None and verdict.valid_for == _verdict_fingerprint(job, parts):
        _keep(job, replace(_total(job, parts), verdict=verdict), chosen, new=True)
    else:
        _keep(job, _total(job, parts), chosen, new=True)


def verdict_of(job, fingerprints: Iterable[str]) -> JobVerdict | None:
    """Return the safety verdict in a job's mark if it is valid for operations with these fingerprints, else None."""
    known = read(job)
    if known is None or known.verdict is None:
        return None
    valid = known.verdict.valid_for == fingerprint_of_job(fingerprints, surroundings_fingerprint(job))
    return replace(known.verdict, outdated=False) if valid else None


def _verdict_fingerprint(job, parts: dict[Any, Record | None]) -> str:
    return fingerprint_of_job(
        (part.fingerprint if part else "" for part in parts.values()), surroundings_fingerprint(job)
    )


def _verdict(job, parts: dict[Any, Record | None]) -> JobVerdict | None:
    """Return the simulation's verdict in a job's mark in the tree.

    The verdict is outdated if the job, or an operation's mark, has changed.
    """
    known = read(job)
    if known is None or known.verdict is None:
        return None
    outdated = _is_outdated(parts) or known.verdict.valid_for != _verdict_fingerprint(job, parts)
    return replace(known.verdict, outdated=outdated)


def _parts(job) -> dict[Any, Record | None]:
    """Return the marks of the operations that a job posts, by operation."""
    return {o.object: read(o.object) for o in find(job) if o.counted}


def _total(job, parts: dict[Any, Record | None]) -> Record:
    """Return the total of the marks of a job's operations; outdated if an operation's mark is outdated or missing."""
    marked = {obj: part for obj, part in parts.items() if part is not None}
    known = [_with_estimate(obj, part) for obj, part in marked.items()]
    total = total_of(job.Document.Name, job.Name, job.Label, known, None, fixtures_of(job))
    made = record.of_total(total, list(marked.values()), _total_fingerprint(job, parts))
    return replace(made, outdated=_is_outdated(parts), verdict=_verdict(job, parts))


def _is_outdated(parts: dict[Any, Record | None]) -> bool:
    return any(part is None or part.outdated for part in parts.values())


def _with_estimate(obj, part: Record) -> Record:
    """Return a mark for the total of a job, with the z-buffer's full estimate if this session has computed it."""
    row = results.latest_row(obj, part.fingerprint) if ZBUFFER.name in part.costs else None
    return replace(part, costs={**part.costs, ZBUFFER.name: row.estimate}) if row and row.estimate else part


def read_total(job) -> Record | None:
    """Return the mark of a job; None if its operations changed after the mark was written."""
    known = read(job)
    return known if known and known.fingerprint == _total_fingerprint(job, _parts(job)) else None


def _total_fingerprint(job, parts: dict[Any, Record | None]) -> str:
    fixtures = fixtures_of(job)
    often = [f"x{fixtures}"] if fixtures > 1 else []
    return " ".join([part.fingerprint if part else "" for part in parts.values()] + often)


def refresh(obj, settings_of: Callable, *, path_changed: bool, setting_changed: bool) -> bool:
    """Make a mark outdated if its operation has changed, or valid again if the change was undone.

    The mark of an operation without toolpath because it was switched off is not outdated, and shows "switched off". An
    operation without a mark is ignored. `settings_of` returns the valid fingerprints of an operation's setting (tool
    and stock). `path_changed` and `setting_changed` are True if the path or the setting has possibly changed since the
    last comparison. If the mark is outdated, or the operation was switched off, path and setting are compared in any
    case. The result is True if the mark changed.
    """
    known = _kept(obj)
    if known is None:
        return False
    path, setting = path_and_setting(known.fingerprint)
    whole = known.outdated or known.off
    has_path = not (path_changed or whole) or path_fingerprint(obj) == path
    off = not has_path and _is_switched_off(obj)
    fits = off or (has_path and (not (setting_changed or whole) or setting in settings_of(obj)))
    if (fits, off) == (not known.outdated, known.off):
        return False
    _keep(obj, replace(known, outdated=not fits, off=off), preferences.read())
    return True


def _is_switched_off(obj) -> bool:
    """Return whether an operation has no toolpath because it is switched off.

    FreeCAD removes the toolpath of an operation that is switched off only at the next recompute.
    """
    return not is_active(obj) and path_fingerprint(obj) == text_fingerprint("", obj.Placement)


def refresh_total(job) -> None:
    """Update the total in a job's mark. The mark is outdated while an operation's mark is outdated or missing."""
    known = read(job)
    if known is None:
        return
    parts = _parts(job)
    if known.fingerprint != _total_fingerprint(job, parts):
        _keep(job, _total(job, parts), preferences.read())
        return
    now = replace(known, outdated=_is_outdated(parts), verdict=_verdict(job, parts))
    if (now.outdated, now.verdict) != (known.outdated, known.verdict):
        _keep(job, now, preferences.read())


def follow(obj, chosen: Preferences) -> None:
    """Update the text of an object's mark, if it has one, after a change of the preferences."""
    known = _kept(obj)
    if known is not None and known.text and known.text != text_of(known.shown, chosen):
        _keep(obj, known, chosen)


def _keep(obj, known: Record, chosen: Preferences, *, new: bool = False) -> None:
    """Write the properties of a mark; write its text only if the mark is new or the description contains its text."""
    visible = known.shown
    known = replace(known, text=text_of(visible, chosen))
    spans = list(_segments(obj))
    values = {
        "Strategy": visible.strategy and visible.strategy.value,
        "Confidence": visible.strategy and round(100 * visible.confidence),
        "Reason": visible.english_reason or None,
        "Remarks": visible.english_remarks,
        "CuttingLength": visible.length,
        "MachiningTime": visible.machining_seconds,
        "SimulationTime": (visible.cost(chosen.simulator) or (None,))[0],
    }
    shown = mark_properties.may_show(obj, values)
    values = {name: value for name, value in values.items() if value is not None and name in shown}
    own = [bracket.group(1) for bracket in _BRACKETS.finditer(obj.Label2) if bracket.span() not in spans]
    mark_properties.set_values(obj, {mark_properties.MARK: record.as_json(known, values, own), **values})
    if spans or new:
        _describe(obj, spans, f"{OPENING}{known.text}{CLOSING}")


def _describe(obj, spans: list[tuple[int, int]], text: str) -> None:
    """Replace the first text of the mark in a description by a new text, and remove the mark's other texts.

    The parameter `spans` has the begin and end of each text. If `spans` is empty, the new text is appended.
    """
    label2 = obj.Label2
    for start, end in reversed(spans[1:]):
        label2 = label2[:start] + label2[end:]
    if spans:
        start, end = spans[0]
        label2 = label2[:start] + (" " if label2[start] == " " else "") + text + label2[end:]
    else:
        label2 = f"{label2} {text}" if label2 else text
    _set_description(obj, label2)


def _set_description(obj, label2: str) -> None:
    if obj.Label2 != label2 and not _is_locked(obj):
        obj.Label2 = label2


def _is_locked(obj) -> bool:
    """Return whether the description of an object is read-only, so that its mark has properties but no text."""
    driven = any(path.lstrip(".") == "Label2" for path, _ in obj.ExpressionEngine)
    return driven or "Immutable" in obj.getPropertyStatus("Label2")


def erase(obj) -> None:
    """Remove all properties and texts of a mark; keep the user's own words."""
    _set_description(obj, words_of(obj))
    for name in mark_properties.ours(obj):
        mark_properties.remove(obj, name)
