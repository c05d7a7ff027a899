# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the machining strategies that can be recognised."""

from __future__ import annotations

import enum

from vkworkbench.language import QT_TRANSLATE_NOOP


class Family(str, enum.Enum):
    """Way in which a strategy covers the part: by rows, by contours around an area, by holes or by strokes."""

    ROWS = "rows"
    AROUND = "around"
    HOLES = "holes"
    STROKES = "strokes"
    #: The operation has no strategy, or several strategies.
    NONE = "none"


class Strategy(str, enum.Enum):
    """The strategy of one operation, recognised from its toolpath alone.

    The attributes are everything that the window shows about a strategy. The value is also the anchor of the strategy's
    row in docs/recognition.md.

    Attributes
    ----------
    value : str
        Name of the strategy, which never changes, because documents store the name and macros read it.
    label : str
        English name for the user; the translations are in the context "Strategy".
    about : str
        Explanation in one sentence.
    family : Family
    color : str
        Colour, ``"#rrggbb"``. All colours have a relative luminance of 0.14 to 0.18 (WCAG 2.1): white text on them has a
        contrast above 4.5, and the colours are visible on light and dark windows. People with red-green colour
        blindness can also distinguish the colours. A strategy's colour is always shown with the strategy's name.
    """

    label: str
    about: str
    family: Family
    color: str

    def __new__(cls, value: str, label: str, family: Family, color: str, about: str) -> Strategy:  # noqa: PYI034 3.11
        """Make a member of this enum: a str with the attributes of a strategy."""
        entry = str.__new__(cls, value)
        entry._value_ = value
        entry.label, entry.family, entry.color, entry.about = label, family, color, about
        return entry

    ZIGZAG = (
        "zigzag", QT_TRANSLATE_NOOP("Strategy", "zigzag"), Family.ROWS, "#0072d8",
        "Long moves alternate between two opposite directions; short moves link them.",
    )  # fmt: skip
    ONE_WAY = (
        "one-way", QT_TRANSLATE_NOOP("Strategy", "one-way"), Family.ROWS, "#007890",
        "Parallel rows are all cut in the same direction, with rapid or lifted returns.",
    )  # fmt: skip
    CONTOUR_PARALLEL = (
        "contour-parallel", QT_TRANSLATE_NOOP("Strategy", "contour-parallel"), Family.AROUND, "#067e00",
        "Two or more nested loops, offset from each other, with one sense of rotation.",
    )  # fmt: skip
    PROFILE = (
        "profile", QT_TRANSLATE_NOOP("Strategy", "profile"), Family.AROUND, "#ba5a06",
        "One closed or open contour, which can be repeated at other depths.",
    )  # fmt: skip
    WATERLINE = (
        "waterline", QT_TRANSLATE_NOOP("Strategy", "waterline"), Family.AROUND, "#127854",
        "Contours at many depths whose shape changes with the depth.",
    )  # fmt: skip
    SPIRAL = (
        "spiral", QT_TRANSLATE_NOOP("Strategy", "spiral"), Family.AROUND, "#727248",
        "One continuous winding with a changing radius.",
    )  # fmt: skip
    HELIX = (
        "helix", QT_TRANSLATE_NOOP("Strategy", "helix"), Family.AROUND, "#4e7e30",
        "A winding that descends or climbs at a constant radius (bore, thread, ramp).",
    )  # fmt: skip
    ADAPTIVE = (
        "adaptive", QT_TRANSLATE_NOOP("Strategy", "adaptive"), Family.AROUND, "#e4243c",
        "Many small engagement loops (adaptive, trochoidal).",
    )  # fmt: skip
    DRILLING = (
        "drilling", QT_TRANSLATE_NOOP("Strategy", "drilling"), Family.HOLES, "#9c4ed2",
        "Vertical moves at points.",
    )  # fmt: skip
    ENGRAVING = (
        "engraving", QT_TRANSLATE_NOOP("Strategy", "engraving"), Family.STROKES, "#d22aa2",
        "Many short open or closed strokes that do not fill an area.",
    )  # fmt: skip
    MIXED = (
        "mixed", QT_TRANSLATE_NOOP("Strategy", "mixed"), Family.NONE, "#7e607e",
        "Several strategies, each in its own span of the toolpath.",
    )  # fmt: skip
    UNKNOWN = (
        "unknown", QT_TRANSLATE_NOOP("Strategy", "unknown"), Family.NONE, "#727272",
        "No strategy can be recognised reliably.",
    )  # fmt: skip
    EMPTY = (
        "empty", QT_TRANSLATE_NOOP("Strategy", "empty"), Family.NONE, "#727272",
        "There is no cutting move.",
    )  # fmt: skip

    def __str__(self) -> str:
        return str(self.value)

    @property
    def is_answer(self) -> bool:
        """Whether the toolpath has a recognised strategy, so that a confidence is meaningful."""
        return self not in (Strategy.UNKNOWN, Strategy.EMPTY)
