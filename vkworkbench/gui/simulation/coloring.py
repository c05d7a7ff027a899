# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colour the surfaces of the simulated part by material, operation, strategy, time, removal rate or difference."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, Tuple, Union

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
from vkworkbench.gui.simulation.moment import Clock

# RGB colours of the surfaces that n trajectories made, (n + 1, 3) uint8; (2, 3) if all trajectories have one colour.
# For colours that differ within a surface: a function that returns the colour of each pixel.
Colors = Union[np.ndarray, Callable[[ZBuffer], np.ndarray]]
Entries = Tuple[Tuple[str, str], ...]


@dataclass(frozen=True, eq=False)
class Job:
    """The data of a job that a colouring uses."""

    labels: tuple[str, ...]  # labels of the operations
    strategies: tuple[Strategy, ...]
    clock: Clock
    volumes: np.ndarray  # (n,) float64: removed volume of each trajectory, mm^3
    seen: SeenModel | None  # the model, seen in the view of the coloured image
    awaited: bool  # whether the image of the model is still being computed
    tolerance: float  # allowed difference between the part and the model, mm


@dataclass(frozen=True, eq=False)
class Coloring:
    """Colours of surfaces, which any thread may compute, and a legend, which only Qt's main thread may make."""

    colors: Colors
    legend: Callable[[], Entries]  # returns the entries of the legend: pairs of a colour and its meaning


def by_material(zbuffer: ZBuffer, job: Job) -> Coloring:
    return Coloring(palette(CUT), lambda: (
        (_name(RAW), translate("Vk_Simulate", "Raw Stock")), (_name(CUT), translate("Vk_Simulate", "Machined")),
    ))  # fmt: skip


def by_operation(zbuffer: ZBuffer, job: Job) -> Coloring:
    colors = distinct_colors(len(job.labels))
    return Coloring(palette(colors[zbuffer.cuts.cut]), lambda: tuple(zip(map(_name, colors), job.labels)))


def by_strategy(zbuffer: ZBuffer, job: Job) -> Coloring:
    # Do not use QColor, because this function runs outside Qt's main thread.
    colors = np.array([list(bytes.fromhex(strategy.color[1:])) for strategy in job.strategies], np.uint8)
    shown = dict.fromkeys(job.strategies)
    return Coloring(palette(colors[zbuffer.cuts.cut]), lambda: tuple((s.color, strategy_name(s)) for s in shown))


def by_time(zbuffer: ZBuffer, job: Job) -> Coloring:
    total = job.clock.total
    colors = scale_colors(job.clock.ends[1:] / total if total else job.clock.ends[1:])
    return Coloring(palette(colors), lambda: _scale(SCALE, user().clock(total), user().clock(0)))


def by_removal_rate(zbuffer: ZBuffer, job: Job) -> Coloring:
    """Colour by removal rate, from 0 to the rate above which only 1 % of the volume is removed."""
    volumes = job.volumes
    rates = job.clock.rates(volumes)
    order = np.argsort(rates)
    volume = np.cumsum(volumes[order])
    most = float(rates[order][np.searchsorted(volume, 0.99 * volume[-1])]) if len(volume) and volume[-1] > 0 else 1.0
    return Coloring(palette(scale_colors(rates / most)), lambda: _scale(SCALE, f"{user().volume(most, 3)}/min", "0"))


def by_difference(zbuffer: ZBuffer, job: Job) -> Coloring:
    """Colour each pixel by the distance between part and model in the direction of the view.

    Pixels at a wall of the part are rarely coloured as different from the model.
    """
    seen, tolerance = job.seen, job.tolerance
    if seen is None:
        return Coloring(palette(CUT), lambda: ((_name(CUT), (
            translate("Vk_Simulate", "The model is shown with the finest picture.") if job.awaited
            else translate("Vk_Simulate", "There is no closed model.")
        )),))  # fmt: skip

    def colors(at: ZBuffer) -> np.ndarray:
        found, size = seen.against(at), seen.near.shape
        return difference_colors(found.left.reshape(size), found.gouged.reshape(size), seen.seen, tolerance)

    def legend() -> Entries:
        least, most = user().measure(tolerance, 2), user().measure(DEEPEST * tolerance, 2)
        return (
            *_scale(GOUGED, translate("Vk_Simulate", "Gouged, {} to {}").format(least, most)),
            (_name(MET), translate("Vk_Simulate", "As the Model")),
            *_scale(LEFT, translate("Vk_Simulate", "Stock Left, {} to {}").format(least, most)),
            (_name(NO_MODEL), translate("Vk_Simulate", "No Model")),
        )

    return Coloring(colors, legend)


COLORINGS: tuple[tuple[str, Callable[[ZBuffer, Job], Coloring]], ...] = (
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Material"), by_material),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Operation"), by_operation),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Strategy"), by_strategy),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Time"), by_time),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Removal Rate"), by_removal_rate),
    (QT_TRANSLATE_NOOP("Vk_Simulate", "Difference to the Model"), by_difference),
)


def _scale(colors: np.ndarray, last: str, first: str = "") -> Entries:
    """Return the legend of a colour scale; only its last colour, and often its first colour, have names."""
    return tuple(zip(map(_name, colors), [first, *[""] * (len(colors) - 2), last]))


def _name(color: np.ndarray) -> str:
    return "#{:02x}{:02x}{:02x}".format(*(int(part) for part in color))
