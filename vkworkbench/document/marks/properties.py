# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties of a mark in the tree: hidden with all data, and visible. This module does not import numpy.

All properties are read-only outputs, because FreeCAD recomputes an object after a change of an ordinary property.
"""

from __future__ import annotations

import json
from collections.abc import Iterable

import FreeCAD

from vkworkbench import freecad
from vkworkbench.language import ENGLISH

QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP

# Name of the hidden property with all data of a mark, and its name in earlier versions. A property of the user can
# have the earlier name, too.
MARK, _EARLIER = "VkWorkbenchMark", "ToolpathMark"
# Attributes of visible and of hidden properties, as sums of FreeCAD's flags: ReadOnly (1): the user cannot change the
# property. Hidden (4). Output (8): a change of the property does not recompute the object.
_SHOWN, _HIDDEN = 9, 13
# "CuttingLength" and not "Length", because FreeCAD's lead-in dress-up has a property "Length".
_TYPES = {
    MARK: ("App::PropertyString", QT_TRANSLATE_NOOP("App::Property", "The text of the mark in the description.")),
    "Strategy": ("App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "The machining strategy recognized from the toolpath.")),
    "Confidence": ("App::PropertyPercent", QT_TRANSLATE_NOOP(
        "App::Property", "The confidence of the recognition, in percent.")),
    "Reason": ("App::PropertyString", QT_TRANSLATE_NOOP("App::Property", "The reason for this strategy.")),
    "Remarks": ("App::PropertyString", QT_TRANSLATE_NOOP(
        "App::Property", "Problems of the operation, and what to know before simulating it.")),
    "CuttingLength": ("App::PropertyLength", QT_TRANSLATE_NOOP("App::Property", "Length of the cutting moves.")),
    "MachiningTime": ("App::PropertyTime", QT_TRANSLATE_NOOP("App::Property", "Time on the machine.")),
    "SimulationTime": ("App::PropertyTime", QT_TRANSLATE_NOOP(
        "App::Property", "Estimated time of the simulation that the mark shows.")),
}  # fmt: skip


def may_have_mark(obj) -> bool:
    """Return whether an object itself has a mark's property. A link only shows the property of its linked object."""
    return (hasattr(obj, MARK) or _has_earlier_mark(obj)) and not obj.isDerivedFrom(freecad.LINK)


def is_mark(obj, name: str) -> bool:
    """Return whether a property holds the data of a mark."""
    return name == MARK or (name == _EARLIER and _has_earlier_mark(obj))


def _has_earlier_mark(obj) -> bool:
    """Return whether an object's property with the earlier name is a mark, by the property's group or data."""
    if not hasattr(obj, _EARLIER):
        return False
    if _group(obj, _EARLIER) == freecad.ADDED_GROUP:
        return True
    data = _parsed(getattr(obj, _EARLIER))
    return isinstance(data, dict) and {"format", "text"} <= set(data)


def mark_data(obj) -> str:
    """Return the data of a mark, as stored in its property; empty if there is no mark, or if it is not a text."""
    text = getattr(obj, _EARLIER if not hasattr(obj, MARK) and _has_earlier_mark(obj) else MARK, "")
    return text if isinstance(text, str) else ""


def ours(obj) -> list[str]:
    """Return the names of an object's properties that belong to its mark.

    A property belongs to the mark if the mark's data lists it, or by its name and group.
    """
    written = _written(obj)
    return [
        name
        for name in obj.PropertiesList
        if is_mark(obj, name) or name in written or (name in _TYPES and _group(obj, name) == freecad.ADDED_GROUP)
    ]


def text_written(obj) -> str | None:
    """Return the text of the mark in the tree, as last written into the description; None if it is unknown."""
    return _part(obj, "text")


def own_brackets(obj) -> list:
    """Return the user's own texts in brackets that the description had when the mark was written."""
    own = _part(obj, "own")
    return own if isinstance(own, list) else []


def _written(obj) -> set[str]:
    names = _part(obj, "shown")
    return {name for name in names if isinstance(name, str) and name in _TYPES} if isinstance(names, list) else set()


def _part(obj, name: str):
    data = _parsed(mark_data(obj))
    return data.get(name) if isinstance(data, dict) else None


def _parsed(text: object) -> object:
    """Return the data of a JSON text; None if the argument is not a JSON text."""
    try:
        return json.loads(text) if isinstance(text, str) else None
    except (ValueError, RecursionError):
        return None


def _group(obj, name: str) -> str:
    return obj.getGroupOfProperty(name)


def may_show(obj, names: Iterable[str]) -> set[str]:
    """Return the names of properties that a mark may write: without names that the object uses for other properties."""
    present = {name for name in names if hasattr(obj, name)}
    return set(names) - (present - set(ours(obj)) if present else set())


def set_values(obj, values: dict) -> None:
    """Set the properties of a mark to the given values, by name.

    The mark's properties without a value are removed; properties with another type or other attributes are replaced.
    """
    for name in ours(obj):
        if name not in values or not _is_as_written(obj, name):
            remove(obj, name)
    for name, value in values.items():
        if not hasattr(obj, name):
            obj.addProperty(
                _type(name), name, freecad.ADDED_GROUP, _TYPES[name][1], _HIDDEN if name == MARK else _SHOWN
            )
        if _type(name) == "App::PropertyString" and not isinstance(value, str):
            value = ENGLISH.time(value)  # FreeCAD 0.20 has no property for a time
        if getattr(getattr(obj, name), "Value", getattr(obj, name)) != value:
            setattr(obj, name, value)


def _is_as_written(obj, name: str) -> bool:
    attributes = {"ReadOnly", "Output"} | ({"Hidden"} if name == MARK else set())
    return (
        obj.getTypeIdOfProperty(name) == _type(name)
        and "Immutable" not in obj.getPropertyStatus(name)
        and attributes <= set(obj.getTypeOfProperty(name))
        and name not in {path.lstrip(".") for path, _ in obj.ExpressionEngine}
    )


def _type(name: str) -> str:
    """Return the type that a property of the mark has in this FreeCAD version."""
    type_id = _TYPES[name][0]
    has_times = freecad.version() >= freecad.TIME_PROPERTY_SINCE
    return "App::PropertyString" if type_id == "App::PropertyTime" and not has_times else type_id


def remove(obj, name: str) -> None:
    """Remove a property, even if it is locked."""
    if any(path.lstrip(".") == name for path, _ in obj.ExpressionEngine):
        obj.setExpression(name, None)
    if not obj.removeProperty(name):
        obj.setPropertyStatus(name, "-LockDynamic")
        obj.removeProperty(name)
