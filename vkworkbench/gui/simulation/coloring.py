# SPDX-License-Identifier: LGPL-2.1-or-later
"""By what the surfaces are coloured, and what the colours mean."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Tuple, Union

import numpy as np

from vkworkbench.core import Strategy, ZBuffer
from vkworkbench.core.rendering import (
    CUT,
    DEEPEST,
    GOUGED,
    LEFT,
    MET,
    NO_MODEL,
    RAW,
    SCALE,
    difference_colors,
    distinct_colors,
    palette,
    scale_colors,
)  # fmt: skip
from vkworkbench.core.zbuffer import SeenModel
from vkworkbench.gui.qt.sentences import strategy_name, user
from vkworkbench.gui.qt.text import QT_TRANSLATE_NOOP, translate
from vkworkbench.gui.simulation.clock import Clock

# Of surfaces by who made them, (n + 1, 3) or (2, 3) uint8; or what returns those of the pixels at a moment.
Colors = Union[np.ndarray, Callable[[ZBuffer], np.ndarray]]
Entries = Tuple[Tuple[str, str], ...]


@dataclass(frozen=True, eq=False)
class Job:
    """What is known of the job that is coloured.

    Attributes
    ----------
    labels : tuple of str
        Of the operations.
    strategies : tuple of Strategy
    clock : Clock
    volumes : (n,) float64 or None
        What each trajectory removes, mm^3; None until it is known.
    seen : SeenModel or None
        What the part is to be, in the image that is coloured.
    awaited : bool
        Whether that is still to come.
    tolerance : float
        What is no difference to it yet, mm.
    """

    labels: tuple[str, ...]
    strategies: tuple[Strategy, ...]
    clock: Clock
    volumes: np.ndarray | None
    seen: SeenModel | None
    awaited: bool
    tolerance: float


@dataclass(frozen=True, eq=False)
class Coloring:
    """Colours of surfaces, which any thread may make, and their legend, whose words belong to the window.

    Attributes
    ----------
    colors : Colors
    legend : callable
        Returns a tuple of colour and what it stands for.
    """

    colors: Colors
    legend: Callable[[], Entries]


def by_material(zbuffer: ZBuffer, job: Job) -> Coloring:
    return Coloring(palette(CUT), lambda: (
        (_name(RAW), translate("Vk_Simulate", "raw")), (_name(CUT), translate("Vk_Simulate", "machined")),
    ))  # fmt: skip


def by_operation(zbuffer: ZBuffer, job: Job) -> Coloring:
    colors = distinct_colors(len(job.labels))
    return Coloring(palette(colors[zbuffer.cuts.cut]), lambda: tuple(zip(map(_name, colors), job.labels)))


def by_strategy(zbuffer: ZBuffer, job: Job) -> Coloring:
    # No QColor: Qt's events in the window do not wait for what a thread makes of Qt.
    colors = np.array([list(bytes.fromhex(strategy.color[1:])) for strategy in job.strategies], np.uint8)
    shown = dict.fromkeys(job.strategies)
    return Coloring(palette(colors[zbuffer.cuts.cut]), lambda: tuple((s.color, strategy_name(s)) for s in shown))


def by_time(zbuffer: ZBuffer, job: Job) -> Coloring:
    total = job.clock.total
    colors = scale_colors(job.clock.ends[1:] / total if total else job.clock.ends[1:])
    return Coloring(palette(colors), lambda: _ends(user().time(0), user().time(total)))


def by_removal_rate(zbuffer: ZBuffer, job: Job) -> Coloring:
    """From nothing to the rate that only a hundredth of the volume is removed faster than."""
    volumes = np.zeros(len(job.clock.cuts)) if job.volumes is None else job.volumes
    rates = job.clock.rates(volumes)
    order = np.argsort(rates)
    volume = np.cumsum(volumes[order])
    most = float(rates[order][np.searchsorted(volume, 0.99 * volume[-1])]) if len(volume) and volume[-1] > 0 else 1.0
    return Coloring(palette(scale_colors(rates / most)), lambda: _ends("0", f"{user().volume(most, 3)}/min"))


def by_difference(zbuffer: ZBuffer, job: Job) -> Coloring:
    """How far the surface is from the model's, along the view; walls that pass through a pixel are not judged."""
    seen, tolerance = job.seen, job.tolerance
    if seen is None:
        return Coloring(palette(CUT), lambda: ((_name(CUT), (
            translate("Vk_Simulate", "the model comes with the finest picture") if job.awaited
            else translate("Vk_Simulate", "there is no closed model")
        )),))  # fmt: skip

    def colors(at: ZBuffer) -> np.ndarray:
        found, size = seen.against(at), seen.near.shape
        return difference_colors(found.left.reshape(size), found.gouged.reshape(size), seen.seen, tolerance)

    def legend() -> Entries:
        least, most = user().measure(tolerance, 2), user().measure(DEEPEST * tolerance, 2)
        return (
            *_stations(GOUGED, translate("Vk_Simulate", "gouged by {} to {}").format(least, most)),
            (_name(MET), translate("Vk_Simulate", "as the model")),
            *_stations(LEFT, translate("Vk_Simulate", "left, {} to {}").format(least, most)),
            (_name(NO_MODEL), translate("Vk_Simulate", "no model")),
        )

    return Coloring(colors, legend)


COLORINGS: tuple[tuple[str, Callable[[ZBuffer, Job], Coloring]], ...] = (
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Material"), by_material),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Operation"), by_operation),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Strategy"), by_strategy),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Time"), by_time),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Removal rate"), by_removal_rate),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Difference to the model"), by_difference),
)


def _ends(least: str, most: str) -> Entries:
    """The legend of a scale: its stations, of which the first and the last are named."""
    names = [least, *[""] * (len(SCALE) - 2), most]
    return tuple(zip(map(_name, SCALE), names))


def _stations(colors: np.ndarray, name: str) -> Entries:
    """The stations of a scale, the last of them with its name."""
    return tuple(zip(map(_name, colors), [*[""] * (len(colors) - 1), name]))


def _name(color: np.ndarray) -> str:
    return "#{:02x}{:02x}{:02x}".format(*(int(part) for part in color))
