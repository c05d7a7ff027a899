# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compute facts, such as removed volume and gouges, on each operation and on the whole job from a simulation."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy as np

from vkworkbench.core.stocks import Solid
from vkworkbench.core.zbuffer.findings.collisions import Collision, Collisions
from vkworkbench.core.zbuffer.findings.crash_check import CrashCheck
from vkworkbench.core.zbuffer.findings.deviations import TOLERANCE, Deviation, gouges, material_left
from vkworkbench.core.zbuffer.findings.facts import cuts_air, engagement, removed_volumes
from vkworkbench.core.zbuffer.findings.faults import Crash, Plunge, crashes, fast_plunges
from vkworkbench.core.zbuffer.findings.seen_model import SeenModel
from vkworkbench.core.zbuffer.findings.thin_gouges import ThinGouges
from vkworkbench.core.zbuffer.findings.verdict import Verdict
from vkworkbench.core.zbuffer.findings.volumes import Volumes
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer
from vkworkbench.core.zbuffer.sweeps.cuts import Source
from vkworkbench.given import number
from vkworkbench.language import Message, render

# Length of the time windows for the peak removal rate, s. With shorter windows, the rate would depend on single pixels.
# Longer windows average out short peaks.
_WINDOW = 1.0
_NUMBERS = (
    "removed_volume", "removed_volume_error", "cutting_length", "cutting_seconds", "air_length", "air_seconds", "air_length_share",
    "air_time_share", "mean_rate", "peak_rate", "depth_of_cut", "width_of_cut", "tool_diameter", "pixel",
)  # fmt: skip
_Fault = TypeVar("_Fault", Crash, Plunge)
_FAULTS = ("crashes", "first_crash_command", "fast_plunges", "deepest_gouge", "stock_lacks", "most_left", "collisions")


@dataclass(frozen=True)
class CutFacts:
    """Facts of the simulation on one operation, or on several operations together.

    Attributes
    ----------
    removed_volume : float
        Removed volume, mm^3.
    removed_volume_error : float or None
        Upper bound, with 95 % confidence, of the error of `removed_volume`, mm^3. The error is None if the volume is
        computed from one image.
    cutting_length, cutting_seconds : float
        Length, mm, and time, s, of the feed moves. The time does not include moves whose feed rate is unknown.
    air_length, air_seconds : float
        Length, mm, and time, s, of the feed moves that remove nothing.
    mean_rate, peak_rate : float
        Mean material removal rate over the whole cutting time, and largest removal rate in one second, mm^3/min. If the
        volumes are measured, moves are divided into parts about as long as the tool's diameter, so that a short peak in
        a long move is not averaged out.
    depth_of_cut, width_of_cut : float
        Largest depth of cut, and mean width of cut over the length of the moves that cut, mm. Without measured volumes,
        depth and width are 0 in a view from the side.
    tool_diameter : float
        Largest diameter of the tools, mm.
    pixel : float
        Side of the pixels of the simulation, mm.
    crashes : tuple of Crash
        Rapids that remove material.
    fast_plunges : tuple of Plunge
        Plunges into full material above the tool's vertical feed.
    gouges, left : tuple of Deviation
        Places that are cut deeper than the model's surface, and places with leftover material above the model's
        surface. Both tuples are empty without a model.
    collisions : tuple of Collision
        Collisions of shanks and holders, cuts deeper than the flutes, tools that are too short, and collisions with
        clamps.
    """

    removed_volume: float
    removed_volume_error: float | None
    cutting_length: float
    cutting_seconds: float
    air_length: float
    air_seconds: float
    mean_rate: float
    peak_rate: float
    depth_of_cut: float
    width_of_cut: float
    tool_diameter: float
    pixel: float
    crashes: tuple[Crash, ...]
    fast_plunges: tuple[Plunge, ...]
    gouges: tuple[Deviation, ...]
    left: tuple[Deviation, ...]
    collisions: tuple[Collision, ...] = ()

    @property
    def air_length_share(self) -> float:
        """Share of the feed moves' length on which nothing is removed, 0 to 1."""
        return self.air_length / self.cutting_length if self.cutting_length else 0.0

    @property
    def air_time_share(self) -> float:
        """Share of the feed moves' time during which nothing is removed, 0 to 1."""
        return self.air_seconds / self.cutting_seconds if self.cutting_seconds else 0.0

    @property
    def faults(self) -> tuple[tuple[Source | None, Message], ...]:
        """Source and message of each fault: collisions, crashes, gouges and places without stock, fast plunges."""
        return (
            *((one.source, one.what) for one in self.collisions),
            *((one.source, one.what) for one in self.crashes),
            *((one.source, one.gouge_message) for one in self.gouges),
            *((one.source, one.what) for one in self.fast_plunges),
        )

    def as_dict(self) -> dict[str, Any]:
        """Return the facts of the simulation as a dictionary of numbers, and of lists of faults with their places.

        Lengths are in mm, times in s, volumes in mm^3, removal rates in mm^3/min and feeds in mm/s.
        """
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
                {
                    "command": d.source and d.source.command,
                    "last_command": d.last and d.last.command,
                    "place": list(d.place),
                    "depth": d.depth,
                    "area": d.area,
                }
                for d in found
            ]
            for found in (self.gouges, self.left)
        )
        collisions = [
            {
                "command": c.source.command,
                "last_command": c.last.command,
                "place": list(c.place),
                "depth": c.depth,
                "body": c.body,
                "clamp": c.clamp or None,
                "message": render(c.what),
            }
            for c in self.collisions
        ]
        return {
            **self._numbers(),
            "crashes": crashes,
            "fast_plunges": plunges,
            "gouges": gouges,
            "left": left,
            "collisions": collisions,
        }

    def cells(self) -> dict[str, float | int | None]:
        """Return the facts of the simulation as one table row with the columns `FACT_COLUMNS`.

        Faults of each kind are summarised by their number, or by their largest depth, mm.
        """
        faults = (
            len(self.crashes),
            self.crashes[0].source.command if self.crashes else None,
            len(self.fast_plunges),
            max((gouge.depth for gouge in self.gouges if gouge.source is not None), default=0.0),
            max((lacking.depth for lacking in self.gouges if lacking.source is None), default=0.0),
            max((left.depth for left in self.left), default=0.0),
            len(self.collisions),
        )
        return {**self._numbers(), **dict(zip(_FAULTS, faults))}

    def _numbers(self) -> dict[str, float | None]:
        return {name: getattr(self, name) for name in _NUMBERS}


# Names of the table columns for which `CutFacts.cells` returns values.
FACT_COLUMNS = (*_NUMBERS, *_FAULTS)


@dataclass(frozen=True)
class JobFacts:
    """Facts of the simulation on a job.

    Attributes
    ----------
    cuts : tuple of CutFacts
        Facts of the simulation on each operation separately.
    job : CutFacts
        Facts of the simulation on all operations together. Only `job` includes deviations without a source: leftover
        material where no operation cut (in `left`), and places where the stock is too small for the model (in
        `gouges`).
    verdict : Verdict
    """

    cuts: tuple[CutFacts, ...]
    job: CutFacts
    verdict: Verdict


def facts(
    zbuffer: ZBuffer,
    checked: CrashCheck,
    measured: Volumes | None = None,
    thin: ThinGouges | None = None,
    *,
    model: Solid | SeenModel | None = None,
    tolerance: float = TOLERANCE,
    collisions: Collisions | None = None,
) -> JobFacts:
    """Compute the facts of the simulation on every operation and on the job.

    Parameters
    ----------
    zbuffer : ZBuffer
        The finished simulation in a view along the tool axis.
    checked : CrashCheck
        Result of the check of the rapids and plunges of the same job.
    measured : Volumes, optional
        Measured volumes of the same job. Without `measured`, the volumes are computed from the image.
    thin : ThinGouges, optional
        The gouges that are too thin to be visible in the image, found with the same tolerance.
    model : Solid or SeenModel, optional
        The model of the finished part, or this model already prepared for the image. Without a model, no gouges and no
        leftover material are returned.
    tolerance : float
        Tolerance, mm. Deviations from the model up to the tolerance are ignored.
    collisions : Collisions, optional
        Result of the check of shanks, holders and clamps of the same job.

    Raises
    ------
    ValueError
        If the tolerance is negative or NaN.
    TypeError
        If the tolerance is not a number.
    """
    tolerance = number("tolerance", tolerance, "a length of at least 0 mm", lambda length: length >= 0)
    cuts = zbuffer.cuts
    volumes = removed_volumes(zbuffer) if measured is None else measured.each
    air, (depth, width) = cuts_air(zbuffer, measured), engagement(zbuffer, measured)
    crashed, plunged = (
        with_known(checked.crashes, crashes(zbuffer)),
        with_known(checked.fast_plunges, fast_plunges(zbuffer)),
    )
    gouged, left = [], []
    if model is not None:
        seen = model if isinstance(model, SeenModel) else SeenModel(model, zbuffer.frame)
        found = seen.against(zbuffer)
        gouged, left = gouges(zbuffer, found, tolerance), material_left(zbuffer, found, tolerance)
    if thin is not None:
        checked = replace(checked, unchecked=(*checked.unchecked, *thin.unchecked))
        gouged = with_thin(gouged, thin)

    def divided(moves: slice) -> tuple[np.ndarray, np.ndarray]:
        """Return time and removed volume of each trajectory, or of each trajectory's parts if volumes were measured."""
        seconds, removed = cuts.seconds[moves], volumes[moves]
        if measured is not None:
            first = measured.parts[moves.start : moves.stop + 1]
            count = np.diff(first)
            seconds, removed = np.repeat(seconds / count, count), measured.of_parts[first[0] : first[-1]]
        return seconds, np.where(seconds > 0, removed, 0.0)

    def facts_of(numbers: range, whole: bool = False) -> CutFacts:
        moves = slice(cuts.first[numbers.start], cuts.first[numbers.stop])
        feeding, seconds, removed = ~cuts.rapid[moves], cuts.seconds[moves], volumes[moves]
        length = np.where(feeding, cuts.lengths[moves], 0.0)
        engaged = np.where(width[moves] > 0, length, 0.0)
        in_time = np.where(seconds > 0, removed, 0.0)
        total = float(seconds.sum())

        def own(found: list[Any]) -> tuple[Any, ...]:
            return tuple(fault for fault in found if (whole if fault.source is None else fault.source.cut in numbers))

        return CutFacts(
            removed_volume=float(removed.sum()),
            removed_volume_error=None if measured is None else measured.error(numbers),
            cutting_length=float(length.sum()),
            cutting_seconds=total,
            air_length=float(length[air[moves]].sum()),
            air_seconds=float(seconds[air[moves]].sum()),
            mean_rate=60 * float(in_time.sum()) / total if total else 0.0,
            peak_rate=_peak_rate(*divided(moves)),
            depth_of_cut=float(depth[moves].max(initial=0.0)),
            width_of_cut=float((width[moves] * engaged).sum() / engaged.sum()) if engaged.any() else 0.0,
            tool_diameter=max((cuts.cuts[cut].tool.diameter for cut in numbers), default=0.0),
            pixel=zbuffer.frame.pixel,
            crashes=own(crashed),
            fast_plunges=own(plunged),
            gouges=own(gouged),
            left=own(left),
            collisions=own(list(collisions.found) if collisions else []),
        )

    job = facts_of(range(len(cuts.cuts)), whole=True)
    verdict = verdict_on(zbuffer, job, checked, compared=model is not None, collisions=collisions)
    verdict = replace(verdict, walls_checked=thin is None or thin.walls_checked)
    return JobFacts(tuple(facts_of(range(cut, cut + 1)) for cut in range(len(cuts.cuts))), job, verdict)


def with_thin(gouged: Sequence[Deviation], thin: ThinGouges) -> list[Deviation]:
    """Return the gouges found in the image together with the thin gouges, the deepest gouge first.

    In operations with thin tools, the thin gouges replace the gouges found in the image, unless some moves of thin
    tools are unchecked. A thin gouge in a wall is united with the gouges found in the image that the same operation
    made with an overlapping range of trajectories.
    """
    found = [one for one in gouged if one.source is None or one.source.cut not in thin.cuts or thin.unchecked]
    found += thin.found
    for new in thin.in_walls:
        same = [one for one in found if _overlap(one, new)]
        found = [one for one in found if one not in same] + [_united([new, *same])]
    return sorted(found, key=lambda gouge: -gouge.depth)


def _overlap(one: Deviation, other: Deviation) -> bool:
    """Return whether two gouges are made by the same operation and their ranges of trajectories overlap."""
    if one.source is None or other.source is None or one.last is None or other.last is None:
        return False
    first, last = max(one.source.trajectory, other.source.trajectory), min(one.last.trajectory, other.last.trajectory)
    return one.source.cut == other.source.cut and first <= last


def _united(gouged: Sequence[Deviation]) -> Deviation:
    """Unite several gouges into one gouge.

    The united gouge has the first and last command of all gouges, the largest area, and the depth and place of the
    deepest gouge.
    """
    first, last = min(gouged, key=lambda one: one.trajectory or 0), max(gouged, key=_last_trajectory)
    deepest = max(gouged, key=lambda one: one.depth)
    area = max(one.area for one in gouged)
    return replace(deepest, trajectory=first.trajectory, source=first.source, last=last.last, area=area)


def _last_trajectory(gouge: Deviation) -> int:
    return gouge.last.trajectory if gouge.last else -1


def with_known(known: Sequence[_Fault], found: Sequence[_Fault]) -> list[_Fault]:
    """Return the known and the newly found faults together, sorted by trajectory.

    If a trajectory has a known fault and a newly found fault, only the known fault is returned.
    """
    faults: dict[int, _Fault] = {}
    for some in (found, known):
        for fault in some:
            faults[fault.trajectory] = fault
    return [faults[trajectory] for trajectory in sorted(faults)]


def verdict_on(
    zbuffer: ZBuffer, job: CutFacts, checked: CrashCheck, *, compared: bool, collisions: Collisions | None = None
) -> Verdict:
    """Return the verdict on a job's safety.

    Parameters
    ----------
    job : CutFacts
        Facts on all operations together.
    compared : bool
        Whether the part was compared with a model.
    collisions : Collisions, optional
        Result of the check of shanks, holders and clamps.
    """
    crashed = {crash.source for crash in job.crashes}
    gouged = [one.depth for one in job.gouges if one.source is not None]
    of_tools = tuple(number for number, cut in enumerate(zbuffer.cuts.cuts) if cut.allowed_depth == np.inf)
    return Verdict(
        pixel=max(zbuffer.frame.pixel, collisions.pixel if collisions else 0.0),
        met=checked.met,
        compared=compared,
        crashes=len(job.crashes),
        gouges=len(gouged),
        fast_plunges=len(job.fast_plunges),
        deepest_gouge=max(gouged, default=0.0),
        lacking=max((one.depth for one in job.gouges if one.source is None), default=0.0),
        unchecked=tuple(one for one in checked.unchecked if one not in crashed),
        unjudged=of_tools if compared else (),
        collisions=collisions,
    )


def _peak_rate(seconds: np.ndarray, volumes: np.ndarray) -> float:
    """Return the largest removal rate in consecutive time windows, mm^3/min.

    During each trajectory the removal rate is constant. Therefore the rate is computed only for windows in which a
    trajectory ends, and for the window after each of these windows. The needed memory depends on the number of
    trajectories and not on the machining time.
    """
    ends, removed = np.append(0.0, np.cumsum(seconds)), np.append(0.0, np.cumsum(volumes))
    window = np.floor(ends / _WINDOW)
    begin = np.unique(np.append(window, window + 1)) * _WINDOW
    begin = begin[begin < max(ends[-1], _WINDOW)]
    rates = (np.interp(begin + _WINDOW, ends, removed) - np.interp(begin, ends, removed)) * 60 / _WINDOW
    return float(rates.max(initial=0.0))
