# SPDX-License-Identifier: LGPL-2.1-or-later
"""One mark: what an analysis found, written on an operation or on its job.

The text goes into Label2, the tree's Description column, in brackets beside the user's own words; a hidden property
holds the whole mark and says which of that text is ours. A file so marked opens in a FreeCAD without this add-on.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

from vkworkbench import preferences
from vkworkbench.core import Strategy
from vkworkbench.core.simulators import ZBUFFER
from vkworkbench.document.job import results
from vkworkbench.document.job.fingerprint import path_and_setting, path_fingerprint, text_fingerprint
from vkworkbench.document.job.operations import find, fixtures_of, is_active
from vkworkbench.document.marks import properties as mark_properties
from vkworkbench.document.marks import record
from vkworkbench.document.marks.record import Record
from vkworkbench.document.marks.text import CLOSING, OPENING, PLAY, SEPARATOR, SWITCHED_OFF, text_of
from vkworkbench.preferences import Preferences
from vkworkbench.report import OperationReport, total_of

_BRACKETS = re.compile(f" ?{OPENING}([^{OPENING}{CLOSING}]*){CLOSING}")
# What a mark of any version and language looks like: how sure it is, or a time; or one of our words and nothing else.
_LIKE_A_MARK = re.compile(
    rf"\S.*?(?: \d{{1,3}} ?%|{SEPARATOR}{PLAY} .+)(?:{SEPARATOR}.*|$)|"
    rf"(?:{'|'.join(strategy.value for strategy in Strategy)}|{SWITCHED_OFF}|\d+ operations?)(?:{SEPARATOR}.*)?"
)


def read(obj) -> Record | None:
    """Return what a mark says, None where an object has none that this version understands."""
    known = _kept(obj)
    return known and replace(known, label=obj.Label).shown


def _kept(obj) -> Record | None:
    """Return what a mark keeps: of an operation that was switched off, what it says when that is switched on again."""
    return record.from_json(mark_properties.kept(obj))


def is_marked(obj) -> bool:
    """Whether an object has a mark, or what is left of one."""
    return bool(mark_properties.ours(obj))


def is_outdated(obj) -> bool:
    """Whether a mark says that it no longer fits."""
    known = read(obj)
    return known is not None and known.outdated


def is_shown(obj) -> bool:
    """Whether the description has the mark's text, or is kept from us; else somebody has taken the text away."""
    return any(_segments(obj)) or _is_locked(obj)


def words_of(obj) -> str:
    """Return the user's own words in an object's description."""
    label2 = obj.Label2
    for start, end in reversed(list(_segments(obj))):
        label2 = label2[:start] + label2[end:]
    return label2


def with_words(obj, words: str) -> str:
    """Return an object's description with other words of the user's before its mark."""
    segments = [obj.Label2[start:end].strip() for start, end in _segments(obj)]
    return " ".join(filter(None, [words.strip(), *segments[-1:]]))


def _segments(obj) -> Iterator[tuple[int, int]]:
    """Where in an object's description its mark stands; the user's own brackets are no marks, whatever they say."""
    if not (mark_properties.may_have_mark(obj) or is_marked(obj)):
        return
    written, own = mark_properties.text_written(obj), mark_properties.own_brackets(obj)
    for bracket in _BRACKETS.finditer(obj.Label2):
        text = bracket.group(1)
        if text == written or (_LIKE_A_MARK.fullmatch(text) and text not in own):
            yield bracket.span()


def write(obj, report: OperationReport, chosen: Preferences, *, outdated: bool) -> None:
    """Write what was found on an operation, and say of it what the preferences ask for."""
    made = record.of_operation(report, chosen.simulator)
    _keep(obj, replace(made, outdated=outdated), chosen, anew=True)


def write_total(job, chosen: Preferences) -> None:
    """Mark a job with the total of its operations' marks; a job with an unmarked operation has none."""
    parts = _parts(job)
    if not parts or None in parts.values():
        if is_marked(job):
            erase(job)
        return
    _keep(job, _total(job, parts), chosen, anew=True)


def _parts(job) -> dict[Any, Record | None]:
    """What is marked on the operations that a job posts, by these."""
    return {o.object: read(o.object) for o in find(job) if o.counted}


def _total(job, parts: dict[Any, Record | None]) -> Record:
    """Return the total of what is marked; it is outdated where that is, or where a part has no mark."""
    marked = {obj: part for obj, part in parts.items() if part is not None}
    known = [_with_estimate(obj, part) for obj, part in marked.items()]
    total = total_of(job.Document.Name, job.Name, job.Label, known, None, fixtures_of(job))
    made = record.of_total(total, list(marked.values()), _total_fingerprint(job, parts))
    return replace(made, outdated=_is_outdated(parts))


def _is_outdated(parts: dict[Any, Record | None]) -> bool:
    return any(part is None or part.outdated for part in parts.values())


def _with_estimate(obj, part: Record) -> Record:
    """Return what a mark says, its z-buffer's cost with what a job's is estimated from, where this session has that."""
    row = results.latest_row(obj, part.fingerprint) if ZBUFFER.name in part.costs else None
    return replace(part, costs={**part.costs, ZBUFFER.name: row.estimate}) if row and row.estimate else part


def read_total(job) -> Record | None:
    """Return what a job's mark says of the operations that it has now; None where it speaks of others."""
    known = read(job)
    return known if known and known.fingerprint == _total_fingerprint(job, _parts(job)) else None


def _total_fingerprint(job, parts: dict[Any, Record | None]) -> str:
    fixtures = fixtures_of(job)
    often = [f"x{fixtures}"] if fixtures > 1 else []
    return " ".join([part.fingerprint if part else "" for part in parts.values()] + often)


def refresh(obj, settings_of: Callable, *, path_changed: bool, setting_changed: bool) -> bool:
    """Add "outdated" to a mark that no longer fits its operation, and take it away where it fits again.

    One whose operation lost its toolpath because it was switched off is not outdated: it says that.

    Parameters
    ----------
    obj : DocumentObject
        An operation; one without a mark is passed over.
    settings_of : callable
        Returns the fingerprints that fit an operation's setting.
    path_changed, setting_changed : bool
        What may have changed since the mark was last compared; one that is outdated or of an operation that was
        switched off is compared as a whole.

    Returns
    -------
    bool
        Whether the mark changed.
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
    """Whether an operation has no toolpath because it is switched off; until it is recomputed it has that of before."""
    return not is_active(obj) and path_fingerprint(obj) == text_fingerprint("", obj.Placement)


def refresh_total(job) -> None:
    """Let a job's mark be the total of what it has now, and say "outdated" while an operation's mark says it or is missing."""
    known = read(job)
    if known is None:
        return
    parts = _parts(job)
    if known.fingerprint != _total_fingerprint(job, parts):
        _keep(job, _total(job, parts), preferences.read())
    elif known.outdated != _is_outdated(parts):
        _keep(job, replace(known, outdated=not known.outdated), preferences.read())


def follow(obj, chosen: Preferences) -> None:
    """Let a mark say what the preferences ask for; an object without a mark is passed over."""
    known = _kept(obj)
    if known is not None and known.text and known.text != text_of(known.shown, chosen):
        _keep(obj, known, chosen)


def _keep(obj, known: Record, chosen: Preferences, *, anew: bool = False) -> None:
    """Write a mark: its properties, and its text where that stands already or the mark is made anew."""
    told = known.shown
    known = replace(known, text=text_of(told, chosen))
    spans = list(_segments(obj))
    values = {
        "Strategy": told.strategy and told.strategy.value,
        "Confidence": told.strategy and round(100 * told.confidence),
        "Reason": told.english_reason or None,
        "Remarks": told.english_remarks,
        "CuttingLength": told.length,
        "MachiningTime": told.machining_seconds,
        "SimulationTime": (told.cost(chosen.simulator) or (None,))[0],
    }
    shown = mark_properties.may_show(obj, values)
    values = {name: value for name, value in values.items() if value is not None and name in shown}
    own = [bracket.group(1) for bracket in _BRACKETS.finditer(obj.Label2) if bracket.span() not in spans]
    mark_properties.set_values(obj, {mark_properties.MARK: record.as_json(known, values, own), **values})
    if spans or anew:
        _describe(obj, spans, f"{OPENING}{known.text}{CLOSING}")


def _describe(obj, spans: list[tuple[int, int]], text: str) -> None:
    """Put a text in the place of the first span of a description, or behind the user's own words."""
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
    """Whether somebody keeps the description from us: a mark is then in its properties alone."""
    driven = any(path.lstrip(".") == "Label2" for path, _ in obj.ExpressionEngine)
    return driven or "Immutable" in obj.getPropertyStatus("Label2")


def erase(obj) -> None:
    """Remove the mark and what is left of others; the user's own words stay."""
    _set_description(obj, words_of(obj))
    for name in mark_properties.ours(obj):
        mark_properties.remove(obj, name)
