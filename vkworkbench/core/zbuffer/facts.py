# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the traces tell of each trajectory: what it removes, and where it should not have."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from vkworkbench.core.zbuffer.cuts import Source
from vkworkbench.core.zbuffer.moments import ZBuffer
from vkworkbench.core.zbuffer.records import GAP


def removed_volumes(zbuffer: ZBuffer) -> np.ndarray:
    """Volume that each trajectory removes, (n,) float64 mm^3.

    Parameters
    ----------
    zbuffer : ZBuffer
        Of any moment.
    """
    records, n = zbuffer.records, zbuffer.trajectories
    length = records.far.astype(float) - records.near()
    volumes = np.bincount(records.owner - GAP, length, n + 2)[1:-1]  # gaps come first, what stays last
    return volumes * zbuffer.frame.pixel**2


def removal_rates(zbuffer: ZBuffer) -> np.ndarray:
    """Volume that each trajectory removes in a minute, (n,) float64 mm^3/min; not a number for those without a feed.

    Parameters
    ----------
    zbuffer : ZBuffer
    """
    feed = zbuffer.cuts.feed
    seconds = np.where(feed > 0, zbuffer.cuts.lengths / np.where(feed > 0, feed, 1), np.nan)
    return 60 * removed_volumes(zbuffer) / seconds


def air_share(zbuffer: ZBuffer) -> float:
    """Share of the length of the cutting moves that removes nothing, 0 to 1; 0 where no move cuts.

    Parameters
    ----------
    zbuffer : ZBuffer
    """
    length = np.where(zbuffer.cuts.rapid, 0.0, zbuffer.cuts.lengths)
    total = float(length.sum())
    return float(length[removed_volumes(zbuffer) == 0].sum()) / total if total else 0.0


@dataclass(frozen=True)
class Crash:
    """A rapid that cuts.

    Attributes
    ----------
    trajectory : int
        Its number.
    source : Source
        Its cut and command.
    place : (3,) tuple of float
        Where the piece that it removes is longest, mm.
    depth : float
        How long that piece is along the view, mm.
    volume : float
        What it removes, mm^3.
    """

    trajectory: int
    source: Source
    place: tuple[float, float, float]
    depth: float
    volume: float


def crashes(zbuffer: ZBuffer) -> list[Crash]:
    """Rapids that remove material, in their order.

    Parameters
    ----------
    zbuffer : ZBuffer
    """
    records, frame = zbuffer.records, zbuffer.frame
    rapid = np.append(zbuffer.cuts.rapid, [False, False])  # what stays, and gaps
    pieces = np.flatnonzero(rapid[records.owner])
    if len(pieces) == 0:
        return []
    owner, near, far = records.owner[pieces], records.near()[pieces].astype(float), records.far[pieces].astype(float)
    pixel = np.searchsorted(records.index, pieces, side="right") - 1
    row, column = np.divmod(pixel, frame.width)
    middle = frame.origins(*frame.pixel_centres(column, row)) + ((near + far) / 2)[:, None] * frame.direction
    volumes = removed_volumes(zbuffer)
    # The longest piece of each rapid comes last of its own.
    order = np.lexsort((far - near, owner))
    last = order[np.append(owner[order][1:] != owner[order][:-1], True)]
    return [
        Crash(
            int(owner[i]),
            zbuffer.cuts.source(int(owner[i])),
            tuple(middle[i].tolist()),
            float(far[i] - near[i]),
            float(volumes[owner[i]]),
        )
        for i in last
    ]
