# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machining strategies that can be recognised."""

from __future__ import annotations

import enum


class Strategy(str, enum.Enum):
    """What one operation does, told from its toolpath alone.

    The values are stable: they are stored in documents and read by macros.
    """

    #: Long moves alternate between two opposite directions, short moves link them.
    ZIGZAG = "zigzag"
    #: The same rows all cut in one direction, with rapid or lifted returns.
    ONE_WAY = "one-way"
    #: Two or more nested offset loops, one sense of rotation.
    CONTOUR_PARALLEL = "contour-parallel"
    #: One closed or open contour per depth, repeated at other depths at most.
    PROFILE = "profile"
    #: Contours at many depths whose shape changes with the depth.
    WATERLINE = "waterline"
    #: One continuous winding with a changing radius.
    SPIRAL = "spiral"
    #: Winding that descends at a constant radius (bore, thread, ramp).
    HELIX = "helix"
    #: Many small engagement loops (adaptive, trochoidal).
    ADAPTIVE = "adaptive"
    #: Vertical moves at points.
    DRILLING = "drilling"
    #: Many short open or closed strokes, no filling pattern.
    ENGRAVING = "engraving"
    #: Several of these, each in its own span.
    MIXED = "mixed"
    #: None can be defended.
    UNKNOWN = "unknown"
    #: There is no cutting move.
    EMPTY = "empty"

    def __str__(self) -> str:
        return self.value
