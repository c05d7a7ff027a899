# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a simulation tells of each operation and of the whole job."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from vkworkbench.core.stocks import Solid
from vkworkbench.core.zbuffer.findings.deviations import TOLERANCE, Deviation, gouges, material_left
from vkworkbench.core.zbuffer.findings.facts import cuts_air, engagement, removed_volumes
from vkworkbench.core.zbuffer.findings.faults import Crash, Plunge, crashes, fast_plunges
from vkworkbench.core.zbuffer.findings.seen_model import deviations
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer
from vkworkbench.given import number

# Rates are means over so much machining time, s: shorter ones are those of single pixels.
_WINDOW = 1.0
_NUMBERS = (
    "removed_volume", "cutting_length", "cutting_seconds", "air_length", "air_seconds", "air_length_share",
    "air_time_share", "mean_rate", "peak_rate", "depth_of_cut", "width_of_cut", "tool_diameter",
)  # fmt: skip
_FAULTS = ("crashes", "first_crash_command", "fast_plunges", "deepest_gouge", "most_left")


@dataclass(frozen=True)
class CutFacts:
    """What is known of one operation, or of several together.

    Attributes
    ----------
    removed_volume : float
        mm^3.
    cutting_length, cutting_seconds : float
        Of the feed moves, mm and s; the time is that of moves with a feed rate.
    air_length, air_seconds : float
        The part of these that removes nothing.
    mean_rate, peak_rate : float
        Material removal rate, mm^3/min: over all of the cutting time, and in the busiest second.
    depth_of_cut, width_of_cut : float
        The greatest depth, and the mean width along the cutting length, mm; 0 where the view does not tell.
    tool_diameter : float
        The largest, mm.
    crashes : tuple of Crash
        Rapids that remove material.
    fast_plunges : tuple of Plunge
        Plunges into full material above the tool's vertical feed.
    gouges, left : tuple of Deviation
        What is cut below the model, and what is left above it; empty without a model.
    """

    removed_volume: float
    cutting_length: float
    cutting_seconds: float
    air_length: float
    air_seconds: float
    mean_rate: float
    peak_rate: float
    depth_of_cut: float
    width_of_cut: float
    tool_diameter: float
    crashes: tuple[Crash, ...]
    fast_plunges: tuple[Plunge, ...]
    gouges: tuple[Deviation, ...]
    left: tuple[Deviation, ...]

    @property
    def air_length_share(self) -> float:
        """Share of the cutting length that removes nothing, 0 to 1."""
        return self.air_length / self.cutting_length if self.cutting_length else 0.0

    @property
    def air_time_share(self) -> float:
        """Share of the cutting time that removes nothing, 0 to 1."""
        return self.air_seconds / self.cutting_seconds if self.cutting_seconds else 0.0

    def as_dict(self) -> dict[str, Any]:
        """Return it as numbers and lists, in mm, s, mm^3 and mm^3/min, with every place where something is wrong."""
        crashes = [
            {"command": c.source.command, "place": list(c.place), "depth": c.depth, "volume": c.volume}
            for c in self.crashes
        ]
        plunges = [
            {"command": p.source.command, "place": list(p.place), "feed": p.feed, "allowed": p.allowed}
            for p in self.fast_plunges
        ]
        gouges, left = (
            [
                {"command": d.source and d.source.command, "place": list(d.place), "depth": d.depth, "area": d.area}
                for d in found
            ]
            for found in (self.gouges, self.left)
        )
        return {**self._numbers(), "crashes": crashes, "fast_plunges": plunges, "gouges": gouges, "left": left}

    def cells(self) -> dict[str, float | int | None]:
        """Return it as the cells `FACT_COLUMNS` of one line of a table; of what is wrong the number of places and the worst."""
        faults = (
            len(self.crashes),
            self.crashes[0].source.command if self.crashes else None,
            len(self.fast_plunges),
            max((gouge.depth for gouge in self.gouges), default=0.0),
            max((left.depth for left in self.left), default=0.0),
        )
        return {**self._numbers(), **dict(zip(_FAULTS, faults))}

    def _numbers(self) -> dict[str, float]:
        return {name: getattr(self, name) for name in _NUMBERS}


# Names of the cells of `CutFacts.cells`.
FACT_COLUMNS = (*_NUMBERS, *_FAULTS)


@dataclass(frozen=True)
class JobFacts:
    """What a simulation tells.

    Attributes
    ----------
    cuts : tuple of CutFacts
        One for each operation.
    job : CutFacts
        All together; what is left where no operation cut, and what the stock lacks of the model, which stands among the
        gouges without a source, is told only here.
    """

    cuts: tuple[CutFacts, ...]
    job: CutFacts


def facts(zbuffer: ZBuffer, *, model: Solid | None = None, tolerance: float = TOLERANCE) -> JobFacts:
    """Tell what the traces, and the model, say of every operation.

    Parameters
    ----------
    zbuffer : ZBuffer
        At its last moment.
    model : Solid, optional
        What the part is to be.
    tolerance : float
        Deviations from the model up to this, mm, are none.

    Raises
    ------
    ValueError
        If the tolerance is no number of at least 0.
    TypeError
        If it is nothing like a number.
    """
    tolerance = number("tolerance", tolerance, "a length of at least 0 mm", lambda length: length >= 0)
    cuts = zbuffer.cuts
    volumes, air, (depth, width) = removed_volumes(zbuffer), cuts_air(zbuffer), engagement(zbuffer)
    crashed, plunged = crashes(zbuffer), fast_plunges(zbuffer)
    gouged, left = [], []
    if model is not None:
        found = deviations(zbuffer, model)
        gouged, left = gouges(zbuffer, found, tolerance), material_left(zbuffer, found, tolerance)

    def told(these: range, whole: bool = False) -> CutFacts:
        moves = slice(cuts.first[these.start], cuts.first[these.stop])
        feeding, seconds, removed = ~cuts.rapid[moves], cuts.seconds[moves], volumes[moves]
        length = np.where(feeding, cuts.lengths[moves], 0.0)
        engaged = np.where(width[moves] > 0, length, 0.0)
        in_time = np.where(seconds > 0, removed, 0.0)
        total = float(seconds.sum())

        def own(found: list[Any]) -> tuple[Any, ...]:
            return tuple(one for one in found if (whole if one.source is None else one.source.cut in these))

        return CutFacts(
            removed_volume=float(removed.sum()),
            cutting_length=float(length.sum()),
            cutting_seconds=total,
            air_length=float(length[air[moves]].sum()),
            air_seconds=float(seconds[air[moves]].sum()),
            mean_rate=60 * float(in_time.sum()) / total if total else 0.0,
            peak_rate=_peak_rate(seconds, in_time),
            depth_of_cut=float(depth[moves].max(initial=0.0)),
            width_of_cut=float((width[moves] * engaged).sum() / engaged.sum()) if engaged.any() else 0.0,
            tool_diameter=max((cuts.cuts[k].tool.diameter for k in these), default=0.0),
            crashes=own(crashed),
            fast_plunges=own(plunged),
            gouges=own(gouged),
            left=own(left),
        )

    return JobFacts(
        tuple(told(range(k, k + 1)) for k in range(len(cuts.cuts))), told(range(len(cuts.cuts)), whole=True)
    )


def _peak_rate(seconds: np.ndarray, volumes: np.ndarray) -> float:
    """Highest rate in any of the windows of time that follow one another.

    Between two ends of trajectories the rate stays: the windows in which one ends, and those behind these, tell all. So a
    machining time of years takes no more memory than its trajectories do.
    """
    ends, removed = np.append(0.0, np.cumsum(seconds)), np.append(0.0, np.cumsum(volumes))
    window = np.floor(ends / _WINDOW)
    begin = np.unique(np.append(window, window + 1)) * _WINDOW
    begin = begin[begin < max(ends[-1], _WINDOW)]
    rates = (np.interp(begin + _WINDOW, ends, removed) - np.interp(begin, ends, removed)) * 60 / _WINDOW
    return float(rates.max(initial=0.0))
