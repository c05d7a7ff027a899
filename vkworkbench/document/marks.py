# SPDX-License-Identifier: LGPL-2.1-or-later
"""One mark: what an analysis found, written on an operation or on its job.

The text goes into Label2, the tree's Description column, as a segment in brackets beside the user's own words; the
data into read-only output properties. Neither touches an object: FreeCAD recomputes nothing (an ordinary property
would). A file so marked opens in a FreeCAD without this add-on.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Iterable

import FreeCAD

from vkworkbench import preferences
from vkworkbench.core import Strategy
from vkworkbench.core.simulators import SIMULATORS, ZBUFFER
from vkworkbench.document.fingerprint import path_fingerprint
from vkworkbench.document.operations import find
from vkworkbench.language import ENGLISH, Message, render
from vkworkbench.report import OperationReport

OPENING, CLOSING, SEPARATOR, OUTDATED = "⟦", "⟧", " · ", "outdated"
# Segments that begin with these words are this add-on's; other brackets may be the user's or another tool's.
_FIRST_WORDS = "|".join([*(strategy.value for strategy in Strategy), "[0-9]+ operations?"])
_SEGMENT = re.compile(f" ?{OPENING}(?:{_FIRST_WORDS})(?: [^{OPENING}{CLOSING}]*)?{CLOSING}")
_LONGEST_REMARK = 60  # characters of what is wrong; the whole is in the tooltip, the report and the properties

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

GROUP = "Toolpath analysis"
# Attributes: Output (8) keeps a change from touching the object, ReadOnly (1) keeps the user from it, Hidden is 4.
_SHOWN, _HIDDEN = 9, 13
_PROPERTIES = {
    "ToolpathStrategy": ("App::PropertyString", _SHOWN, QT_TRANSLATE_NOOP(
        "App::Property", "Machining strategy recognised from the toolpath")),
    "ToolpathConfidence": ("App::PropertyFloat", _SHOWN, QT_TRANSLATE_NOOP(
        "App::Property", "How sure the recognition is, 0 to 1")),
    "ToolpathReason": ("App::PropertyString", _SHOWN, QT_TRANSLATE_NOOP(
        "App::Property", "Why this strategy")),
    "ToolpathRemark": ("App::PropertyString", _SHOWN, QT_TRANSLATE_NOOP(
        "App::Property", "What is wrong with the operation or unknown about it")),
    "ToolpathMessages": ("App::PropertyString", _HIDDEN, QT_TRANSLATE_NOOP(
        "App::Property", "Reason and remark as codes with their arguments")),
    "ToolpathTrajectories": ("App::PropertyInteger", _SHOWN, QT_TRANSLATE_NOOP(
        "App::Property", "Number of straight moves, arcs chopped")),
    "ToolpathLength": ("App::PropertyFloat", _SHOWN, QT_TRANSLATE_NOOP(
        "App::Property", "Cutting length in mm")),
    "ToolpathSimulator": ("App::PropertyString", _SHOWN, QT_TRANSLATE_NOOP(
        "App::Property", "Simulator whose time and memory are given")),
    "ToolpathSeconds": ("App::PropertyFloat", _SHOWN, QT_TRANSLATE_NOOP(
        "App::Property", "Estimated time of simulating it, in seconds")),
    "ToolpathFactor": ("App::PropertyFloat", _SHOWN, QT_TRANSLATE_NOOP(
        "App::Property", "The true time is between the estimated one divided and multiplied by this")),
    "ToolpathMemory": ("App::PropertyFloat", _SHOWN, QT_TRANSLATE_NOOP(
        "App::Property", "Estimated memory of simulating it, in bytes")),
    "ToolpathFingerprint": ("App::PropertyString", _HIDDEN, QT_TRANSLATE_NOOP(
        "App::Property", "Of the path, tool and stock analysed")),
}  # fmt: skip


def is_marked(obj) -> bool:
    return any(hasattr(obj, name) for name in _PROPERTIES) or _SEGMENT.search(obj.Label2) is not None


def reason_of(obj) -> tuple[Message, ...]:
    """Return why an operation was marked with its strategy; empty on a job."""
    return _told(obj, "reason", getattr(obj, "ToolpathReason", ""))


def remarks_of(obj) -> tuple[Message, ...]:
    """Return what a mark says to be wrong or unknown."""
    return _told(obj, "remarks", getattr(obj, "ToolpathRemark", ""))


def _told(obj, name: str, english: str) -> tuple[Message, ...]:
    """Return the messages of a mark, or its English text where they render otherwise: another version wrote them."""
    try:
        messages = tuple(map(Message.from_data, json.loads(obj.ToolpathMessages)[name]))
        if "; ".join(map(render, messages)) == english:
            return messages
    except (AttributeError, LookupError, TypeError, ValueError, ArithmeticError, RecursionError):
        pass  # the mark has no messages, or none that this version can read
    return (Message("verbatim", text=english),) if english else ()


def _as_json(**messages: Iterable[Message]) -> str:
    return json.dumps({name: [message.as_data() for message in some] for name, some in messages.items()})


def is_outdated(obj) -> bool:
    """Whether the mark in the tree says that it no longer fits."""
    segment = segment_of(obj.Label2)
    return segment is not None and segment.endswith(SEPARATOR + OUTDATED)


def segment_of(label2: str) -> str | None:
    """Return the text between the brackets of a description, None where there is no mark."""
    match = _SEGMENT.search(label2)
    return match and match.group().strip(f" {OPENING}{CLOSING}")


def words_of(label2: str) -> str:
    """Return the user's own words in a description."""
    return _SEGMENT.sub("", label2)


def with_words(label2: str, words: str) -> str:
    """Return a description with other words of the user's before its mark."""
    match = _SEGMENT.search(label2)
    segment = match.group().strip() if match else ""
    return " ".join(filter(None, [words_of(words).strip(), segment]))


def refresh(obj, setting_of: Callable, *, path_changed: bool = True, setting_changed: bool = True) -> bool:
    """Add "outdated" to a mark that no longer fits its operation, and take it away where it fits again.

    Parameters
    ----------
    obj : DocumentObject
        An operation; one without a mark is passed over.
    setting_of : callable
        Returns the setting's fingerprint of an operation.
    path_changed, setting_changed : bool
        What may have changed since the mark was last compared; an outdated mark is compared as a whole.

    Returns
    -------
    bool
        Whether the mark changed.
    """
    if not hasattr(obj, "ToolpathFingerprint"):
        return False
    path, _, setting = obj.ToolpathFingerprint.partition(":")
    outdated = is_outdated(obj)
    fits = not (setting_changed or outdated) or setting_of(obj) == setting
    fits = fits and (not (path_changed or outdated) or path_fingerprint(obj) == path)
    if fits != outdated:
        return False
    _say_outdated(obj, not fits)
    return True


def refresh_total(job) -> None:
    """Say "outdated" in a job's mark while an operation's mark says it, or while the job has other operations."""
    if hasattr(job, "ToolpathFingerprint"):
        _refresh_total(job, [o.object for o in find(job) if o.counted])


def _refresh_total(job, operations: list) -> None:
    other = job.ToolpathFingerprint != _total_fingerprint(operations)
    _say_outdated(job, other or any(is_outdated(obj) for obj in operations))


def _total_fingerprint(operations: list) -> str:
    return " ".join(getattr(obj, "ToolpathFingerprint", "") for obj in operations)


def write(obj, report: OperationReport) -> None:
    """Write what was found on an operation."""
    simulator = preferences.read().mark_simulator
    cost = report.cost(simulator)
    seconds, memory = cost or (0.0, 0.0)
    _set(obj, {
        "ToolpathStrategy": report.strategy.value,
        "ToolpathConfidence": round(report.confidence, 4),
        "ToolpathReason": report.reason,
        "ToolpathRemark": report.error or "",
        "ToolpathMessages": _as_json(reason=(report.recognition.why,), remarks=report.remarks),
        "ToolpathTrajectories": report.trajectories,
        "ToolpathLength": report.length,
        "ToolpathSimulator": simulator,
        "ToolpathSeconds": seconds,
        "ToolpathFactor": report.factor(simulator),
        "ToolpathMemory": memory,
        "ToolpathFingerprint": report.fingerprint,
    })  # fmt: skip
    parts = [_verdict(report)]
    if cost:
        parts += _cost(simulator, seconds, memory, report.factor(simulator))
    if report.error:
        parts.append(_shortened(report.error))
    _describe(obj, SEPARATOR.join(parts))


def _cost(simulator: str, seconds: float, memory: float, factor: float, least: str = "") -> list[str]:
    """Return time and memory in words, with the name of the simulator unless it is the z-buffer."""
    whose = "" if simulator == ZBUFFER.name else f"{simulator} "
    time = ENGLISH.about(ENGLISH.time(seconds), factor)
    return [whose + least + time, least + ENGLISH.memory(memory)]


def _verdict(report: OperationReport) -> str:
    sure = f" {report.confidence:.0%}" if report.strategy.is_answer else ""
    return report.strategy.value + sure


def _shortened(text: str) -> str:
    text = text.replace(OPENING, "[").replace(CLOSING, "]")
    return text if len(text) <= _LONGEST_REMARK else text[: _LONGEST_REMARK - 1].rstrip() + "…"


def write_total(job) -> None:
    """Mark a job with the sum over its operations' marks.

    A job with an unmarked operation has no total, nor has one whose marks are of different simulators.
    """
    operations = [o.object for o in find(job) if o.counted]
    simulators = {getattr(obj, "ToolpathSimulator", None) for obj in operations}
    if len(simulators) != 1 or None in simulators:
        if is_marked(job):
            erase(job)
        return
    seconds = sum(obj.ToolpathSeconds for obj in operations)
    memory = sum(obj.ToolpathMemory for obj in operations)
    unknown = [obj for obj in operations if obj.ToolpathTrajectories and not obj.ToolpathMemory]
    remarks = (Message("cost-unknown", labels=[obj.Label for obj in unknown]),) if unknown else ()
    (simulator,) = simulators
    factor = max(obj.ToolpathFactor for obj in operations)
    _set(job, {
        "ToolpathSimulator": simulator,
        "ToolpathRemark": "; ".join(map(render, remarks)),
        "ToolpathMessages": _as_json(remarks=remarks),
        "ToolpathTrajectories": sum(obj.ToolpathTrajectories for obj in operations),
        "ToolpathLength": sum(obj.ToolpathLength for obj in operations),
        "ToolpathSeconds": seconds,
        "ToolpathFactor": factor,
        "ToolpathMemory": memory,
        "ToolpathFingerprint": _total_fingerprint(operations),
    })  # fmt: skip
    more = len(operations) > 1 and any(s.name == simulator and not s.adds_up for s in SIMULATORS)
    least = "≥ " if unknown or more else ""
    count = f"{len(operations)} operation" + ("s" if len(operations) > 1 else "")
    _describe(job, SEPARATOR.join([count, *_cost(simulator, seconds, memory, factor, least)]))
    _refresh_total(job, operations)


def _set(obj, values: dict) -> None:
    present = set(obj.PropertiesList)
    for name, value in values.items():
        if name not in present:
            type_id, attributes, tooltip = _PROPERTIES[name]
            obj.addProperty(type_id, name, GROUP, tooltip, attributes)
        if getattr(obj, name) != value:
            setattr(obj, name, value)


def _describe(obj, segment: str) -> None:
    """Put the segment in the place of the present one, or behind the user's own words."""
    text = f"{OPENING}{segment}{CLOSING}"
    match = _SEGMENT.search(obj.Label2)
    if match:
        space = " " if match.group().startswith(" ") else ""
        label2 = obj.Label2[: match.start()] + space + text + obj.Label2[match.end() :]
    else:
        label2 = f"{obj.Label2} {text}" if obj.Label2 else text
    if obj.Label2 != label2:
        obj.Label2 = label2


def _say_outdated(obj, outdated: bool) -> None:
    segment = segment_of(obj.Label2)
    if segment is not None:
        fresh = segment[: -len(SEPARATOR + OUTDATED)] if segment.endswith(SEPARATOR + OUTDATED) else segment
        _describe(obj, fresh + SEPARATOR + OUTDATED if outdated else fresh)


def erase(obj) -> None:
    """Remove the mark; the user's own words stay."""
    label2 = words_of(obj.Label2)
    if obj.Label2 != label2:
        obj.Label2 = label2
    for name in _PROPERTIES:
        if hasattr(obj, name):
            obj.removeProperty(name)
