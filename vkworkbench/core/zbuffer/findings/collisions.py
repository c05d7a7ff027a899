# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find shanks and holders that hit material, tools that hit clamps, cuts deeper than the flutes, and too short tools.

The parts of a tool above its flutes are called bodies; a body does not cut. A body collides where it meets material
that the tool has not removed before. The collisions are found on vertical rays, in a simulation in which tools and
bodies move alternately and bodies remove material as if they were tools. Each segment of a ray that a body removes is a
collision. The rows of rays are rotated against the X and Y axes, because a row of rays parallel to a wall could miss a
thin layer of the wall on all its rays.

If the body moves before its tool, the simulation finds every collision, but also false collisions with material that
the tool removes in the same move before the body arrives. Therefore the moves with such collisions are simulated again,
divided into parts, and in each part the body moves after the tool. A segment of a ray that the body removes in the
second simulation, too, is a real collision.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf, pi, sqrt

import numpy as np

from vkworkbench.core.stocks import Solid
from vkworkbench.core.tool import Tool
from vkworkbench.core.toolpath import Toolpath
from vkworkbench.core.zbuffer.findings.fine_rays import FineRays
from vkworkbench.core.zbuffer.findings.removed_segments import RemovedSegments
from vkworkbench.core.zbuffer.rays.dexels import THINNEST
from vkworkbench.core.zbuffer.sweeps.bodies import Alternation, Body, alternate, slimmer
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts, Source
from vkworkbench.core.zbuffer.sweeps.trajectories import passes_over
from vkworkbench.language import Message

FLUTES, SHANK, HOLDER, LENGTH, TOOL = "flutes", "shank", "holder", "length", "tool"
# _TOUCHES: distance by which a body (a part of a tool above its flutes) is made smaller before the check, mm, because a
# body that only touches a wall does not collide. The chords that replace an arc leave material as thick as the largest
# distance between arc and chord (the arc's rise). Therefore bodies are made smaller by at least `_OF_RISE` times the
# rise.
_TOUCHES, _OF_RISE = 0.02, 2.0
# Assumed diameter of an unknown holder, as a multiple of the diameter of the tool or of its shank. The assumed diameter
# is the diameter of the narrowest holders.
_NARROWEST_HOLDER = 1.5
# Largest height, mm, by which the tool descends in one part of a sloped move. Sloped moves are divided into such parts
# to find cuts deeper than the flutes.
_FALL = 0.5
# The first simulation moves bodies (parts of tools above the flutes) before their tools, the second simulation after
# the tools. Moves in which only the first simulation finds a collision are divided into parts and simulated again.
# _SHARE: length of one part, as a share of the difference between the radii of body (shank or holder) and tool.
# _MOST_PARTS: largest number of parts of one move. _PARTS_TOGETHER: largest number of parts of all moves together.
_SHARE, _MOST_PARTS, _PARTS_TOGETHER = 0.5, 1000, 200_000
# Angle between the rows of rays and the X axis, rad; few walls have this direction.
_TURN = 0.3
# _RAYS: minimum number of rays in the rectangle that the shanks or holders pass over. _ACROSS: minimum number of rays
# along a radius of the shank or holder.
_RAYS, _ACROSS = 150_000, 4.0
# Minimum number of rays in the ring between the outlines of the tool and of its shank or holder, seen from above. With
# fewer rays, the check misses walls that the shank or holder only scrapes.
_IN_RING = 12.0
# Smallest distance between rays, mm.
_CLOSEST = 2.0**-7


@dataclass(frozen=True)
class Collision:
    """The collisions of one part of a tool in one operation.

    Attributes
    ----------
    body : {"flutes", "shank", "holder", "length", "tool"}
        Colliding part of the tool. "flutes" means that the cut is deeper than the flutes. "length" means that material
        reaches above the upper end of a tool whose holder is unknown. "tool" means that the cutting part of the tool
        cuts a clamp.
    trajectory : int
        Number of the first trajectory that collides.
    source, last : Source
        Operation and command of the first and of the last trajectory that collides.
    place : (3,) tuple of float
        Middle of the longest segment of a ray that the colliding part would remove in the first trajectory, mm.
    depth : float
        Largest height of material above the lower end of the colliding part, mm.
    clamp : str
        Name of the clamp. The name is empty for a collision with the workpiece.
    size : float
        Length of the flutes if `body` is "flutes", length of the tool if `body` is "length", mm; otherwise 0.
    """

    body: str
    trajectory: int
    source: Source
    last: Source
    place: tuple[float, float, float]
    depth: float
    clamp: str = ""
    size: float = 0.0

    @property
    def what(self) -> Message:
        """A message that describes the collision."""
        if self.clamp:
            parts = {TOOL: Message("the-tool"), SHANK: Message("the-shank"), HOLDER: Message("the-holder")}
            return Message("hits-clamp", part=parts[self.body], clamp=self.clamp)
        return {
            FLUTES: Message("deeper-than-flutes", depth=self.depth, length=self.size),
            SHANK: Message("shank-collides", depth=self.depth),
            HOLDER: Message("holder-collides", depth=self.depth),
            LENGTH: Message("tool-too-short", depth=self.depth, length=self.size),
        }[self.body]


@dataclass(frozen=True)
class Collisions:
    """The collisions in a job.

    Attributes
    ----------
    found : tuple of Collision
        All collisions, sorted by their first colliding trajectory.
    pixel : float
        Largest distance between neighbouring rays of the check, mm; 0 if no shank or holder is ever below the top of
        the material.
    shanks, holders : tuple of bool
        For each operation, whether the size of the tool's shank is known, and whether the size of its holder is known.
    clamps : int
        Number of clamps.
    """

    found: tuple[Collision, ...]
    pixel: float
    shanks: tuple[bool, ...]
    holders: tuple[bool, ...]
    clamps: int

    @property
    def worst(self) -> tuple[Collision, ...]:
        """For each part of the tools, its deepest collision with the workpiece and with each clamp."""
        deepest: dict[tuple[str, str], Collision] = {}
        for one in self.found:
            known = deepest.setdefault((one.body, one.clamp), one)
            if one.depth > known.depth:
                deepest[one.body, one.clamp] = one
        return tuple(deepest.values())

    def attachments(self, labels: Sequence[str]) -> Message:
        """Return a message on the operations whose shanks or holders were not checked, and on the number of clamps.

        Parameters
        ----------
        labels : sequence of str
            Labels of the operations.
        """
        shanks, holders = (
            tuple(label for label, one in zip(labels, known) if not one) for known in (self.shanks, self.holders)
        )
        if not shanks and not any(self.holders) and not self.clamps:
            return Message("only-shanks-checked")
        without_shanks = Message("shanks-unknown", labels=shanks) if any(self.shanks) else Message("no-shanks")
        without_holders = Message("holders-unknown", labels=holders) if any(self.holders) else Message("no-holders")
        sentences = (
            without_shanks if shanks else Message("shanks-checked"),
            without_holders if holders else Message("holders-checked"),
            Message("clamps-checked", count=self.clamps) if self.clamps else Message("no-clamps"),
        )
        return Message("attachments", sentences=sentences)


def holder_collisions(
    cuts: Cuts, stock: Solid, *, clamps: Mapping[str, Solid] | None = None, going_on: Callable[[], None] = lambda: None
) -> Collisions:
    """Find the collisions of the tools' non-cutting parts with the workpiece, and of all parts with clamps.

    Parameters
    ----------
    cuts : Cuts
        The operations. A part of a tool is not checked if its size is unknown.
    clamps : mapping of str to Solid, optional
        Solids that no part of a tool is allowed to touch, by name.
    going_on : callable, optional
        Called many times a second. An exception raised by `going_on` stops the check.
    """
    clamps = clamps or {}
    search = _Search(going_on)
    found = [one for body in (FLUTES, SHANK, HOLDER, LENGTH) for one in search.in_workpiece(cuts, stock, body)]
    slimmed = [replace(cut, tool=slimmer(cut.tool, _margin(cut.toolpath))) for cut in cuts.cuts]
    for name, clamp in clamps.items():
        # Each operation is checked against the whole clamp, because a collision of an earlier operation must not hide a
        # later collision.
        for number, first in enumerate(cuts.first[:-1].tolist()):
            alone, slim = Cuts([cuts.cuts[number]]), Cuts([slimmed[number]])
            of_bodies = (
                search.in_clamp(slim if body == TOOL else alone, clamp, name, body) for body in (TOOL, SHANK, HOLDER)
            )
            one = next((one for body in of_bodies for one in body), None)
            if one:
                source, last = replace(one.source, cut=number), replace(one.last, cut=number)
                found.append(replace(one, trajectory=one.trajectory + first, source=source, last=last))
    tools = [cut.tool for cut in cuts.cuts]
    return Collisions(
        tuple(sorted(found, key=lambda one: one.trajectory)),
        search.pixel,
        tuple(None not in (tool.cutting_edge_height, tool.shank_diameter) for tool in tools),
        tuple(None not in (tool.length, tool.holder_diameter) for tool in tools),
        len(clamps),
    )


def _margin(toolpath: Toolpath) -> float:
    rise = toolpath.lengths / 2 * np.tan(np.abs(toolpath.sweep) / 4)
    return max(_TOUCHES, _OF_RISE * float(rise.max(initial=0.0)))


def _body_of(cut: Cut, body: str) -> Body | None:
    """Return a part of an operation's tool, made smaller so that touching a wall is not a collision.

    The result is None if the size of this part is unknown, or if the part is not wider than the tool.
    """
    tool, margin = cut.tool, _margin(cut.toolpath)
    width, above = _width(tool, body), tool.cutting_edge_height if body in (FLUTES, SHANK) else tool.length
    if width is None or above is None:
        return None
    if body == FLUTES:
        width = slimmer(tool, margin).diameter
    else:
        width -= 2 * margin
        if width <= tool.diameter:
            return None
    return Body(width / 2, max(above, tool.rim) + margin)


def _width(tool: Tool, body: str) -> float | None:
    """Return the diameter of a part of a tool, mm; None if the diameter is unknown."""
    if body == LENGTH and tool.holder_diameter is None:
        return _NARROWEST_HOLDER * max(tool.diameter, tool.shank_diameter or 0.0)
    return {FLUTES: tool.diameter, SHANK: tool.shank_diameter, HOLDER: tool.holder_diameter}.get(body)


class _Search:
    def __init__(self, going_on: Callable[[], None]) -> None:
        self._going_on = going_on
        self.pixel = 0.0

    def in_workpiece(self, cuts: Cuts, stock: Solid, body: str) -> Iterator[Collision]:
        """Yield the collisions of one part of the tools with the workpiece."""
        bodies = [_body_of(cut, body) for cut in cuts.cuts]
        low = _low_moves(cuts, bodies, stock)
        if not low.any():
            return
        pixels = _pixels(cuts, bodies, low, stock)
        if body == FLUTES:
            removed = self._removed(_lifted(cuts, bodies, low), stock, pixels)
        else:
            removed = self._of_wider(cuts, bodies, low, stock, pixels)
        if body == HOLDER:
            removed = removed.within_holders(cuts, bodies)
        yield from removed.collisions(cuts, body)

    def _of_wider(
        self, cuts: Cuts, bodies: Sequence[Body | None], low: np.ndarray, stock: Solid, pixels: np.ndarray
    ) -> _Removed:
        """Return the segments of rays that meet a shank or holder, because the tool has not removed them before.

        The shanks and holders are wider than their tools.
        """
        removed = self._removed(alternate(cuts, bodies, low, body_first=True), stock, pixels)
        candidates = removed.is_by(len(cuts))
        if not candidates.any():
            return removed
        removed = self._removed(alternate(cuts, bodies, candidates, body_first=False), stock, pixels)
        undecided = candidates & ~removed.is_by(len(cuts))
        if not undecided.any():
            return removed
        start, end = cuts.ends
        run = np.where(undecided, np.hypot(*(end - start)[:, :2].T), 0)
        wider = np.array([own.radius - cut.tool.radius if own else 1.0 for own, cut in zip(bodies, cuts.cuts)])
        parts = _parts(run / (_SHARE * wider[cuts.cut]))
        return self._removed(alternate(cuts, bodies, candidates, body_first=False, parts=parts), stock, pixels)

    def in_clamp(self, cuts: Cuts, clamp: Solid, name: str, body: str) -> Iterator[Collision]:
        """Yield the collisions of one part of the tools with a clamp."""
        if body == TOOL:
            bodies: list[Body | None] = [Body(cut.tool.radius, 0.0) for cut in cuts.cuts]
        else:
            bodies = [_body_of(cut, body) for cut in cuts.cuts]
        low = _low_moves(cuts, bodies, clamp)
        if not low.any():
            return
        pixels = _pixels(cuts, bodies, low, clamp)
        carries = low & (body != TOOL)
        removed = self._removed(
            alternate(cuts, bodies, carries, body_first=True), clamp, pixels, of=low if body == TOOL else None
        )
        if body == HOLDER:
            removed = removed.within_holders(cuts, bodies)
        yield from removed.collisions(cuts, body, name)

    def _removed(
        self, alternation: Alternation, solid: Solid, pixels: np.ndarray, of: np.ndarray | None = None
    ) -> _Removed:
        """Return the segments that bodies, in moves that alternate with tools, remove from rays through the solid.

        With a mask `of` (n,) bool of the job's trajectories, return the segments that the tools remove in these
        trajectories instead.
        """
        chosen = np.flatnonzero(alternation.of_body if of is None else of[alternation.trajectory])
        moves = alternation.moves
        radius = np.array([cut.tool.radius for cut in moves.cuts])[moves.cut[chosen]]
        pixel = pixels[alternation.trajectory[chosen]]
        found = []
        for size in np.unique(pixel).tolist():
            own = pixel == size
            rays = FineRays(moves, solid, size, _TURN)
            removed = rays.removed_by(chosen[own], radius[own], self._going_on)
            found += [_Removed.by(segments, alternation.trajectory) for segments in removed]
            self.pixel = max(self.pixel, size)
        return _Removed.joined(found)


def _low_moves(cuts: Cuts, bodies: Sequence[Body | None], stock: Solid) -> np.ndarray:
    """Return whether each move can bring a body (shank or holder) as low as the top of the material, (n,) bool."""
    radius = np.array([body.radius if body else 0.0 for body in bodies])[cuts.cut]
    bottom = np.array([body.bottom if body else np.inf for body in bodies])[cuts.cut]
    start, end = cuts.ends
    low: np.ndarray = passes_over(start, end, radius, stock)
    low &= np.minimum(start[:, 2], end[:, 2]) + bottom < stock.upper[2]
    return low


def _pixels(cuts: Cuts, bodies: Sequence[Body | None], low: np.ndarray, solid: Solid) -> np.ndarray:
    """Return, for each trajectory, the distance between the rays on which the shank or holder is checked, (n,) mm.

    The distance is small if the shank or holder is narrow, or only slightly wider than its tool.
    """
    own = cuts.cut[low]
    radius = np.array([body.radius if body else 0.0 for body in bodies])[own][:, None]
    ends = [points[low, :2] for points in cuts.ends]
    lower = np.maximum((np.minimum(*ends) - radius).min(axis=0), solid.lower[:2])
    upper = np.minimum((np.maximum(*ends) + radius).max(axis=0), solid.upper[:2])
    pixel = np.full(len(bodies), sqrt(float((upper - lower).prod()) / _RAYS))
    for number, (cut, body) in enumerate(zip(cuts.cuts, bodies)):
        if body:
            ring = 2 * pi * body.radius * (body.radius - cut.tool.radius)
            pixel[number] = min(pixel[number], body.radius / _ACROSS, sqrt(ring / _IN_RING) if ring > 0 else inf)
    of_cut = 2.0 ** np.floor(np.log2(np.maximum(pixel, _CLOSEST)))
    return of_cut[cuts.cut]


def _lifted(cuts: Cuts, bodies: Sequence[Body | None], low: np.ndarray) -> Alternation:
    """Return the sequence of moves in which each body (shank or holder) moves before its tool.

    Sloped moves are divided into parts, because during each part the body is raised by the height that the tool
    descends in this part.
    """
    start, end = cuts.ends
    sloped = low & (start[:, :2] != end[:, :2]).any(axis=1)
    parts = _parts(np.where(sloped, np.maximum(start - end, 0)[:, 2], 0) / _FALL)
    return alternate(cuts, bodies, low, body_first=True, parts=parts, lifted=True)


def _parts(wanted: np.ndarray) -> np.ndarray:
    most = max(1, min(_MOST_PARTS, _PARTS_TOGETHER // max(1, int((wanted > 1).sum()))))
    return np.clip(np.ceil(wanted), 1, most).astype(np.int64)


@dataclass(frozen=True, eq=False)
class _Removed:
    """Segments of rays that bodies (shanks and holders) would remove if they could cut.

    Attributes
    ----------
    trajectory : (k,) int64
        Trajectory of the job in which each segment is removed.
    lower, upper : (k, 3) float64
        Lower and upper end of each segment, mm.
    height : (k,) float64
        Height of the colliding material above the lower end of each segment, mm.
    """

    trajectory: np.ndarray
    lower: np.ndarray
    upper: np.ndarray
    height: np.ndarray

    @classmethod
    def by(cls, segments: RemovedSegments, trajectory: np.ndarray) -> _Removed:
        """Convert segments removed by moves of a simulation to segments removed by trajectories of the job.

        `segments` are sorted by ray and depth. `trajectory` (n,) is the job's trajectory from which each move of the
        simulation was made.
        """
        every = np.arange(len(segments.owner))
        # A body can have removed several segments of a ray that lie directly below each other. The height of the
        # colliding material is measured from the top of the highest of these segments.
        begins = np.ones(len(every), bool)
        begins[1:] = (
            (np.diff(segments.x) != 0) | (np.diff(segments.y) != 0) | (segments.near[1:] > segments.far[:-1] + THINNEST)
        )
        top = segments.near[np.flatnonzero(begins)][np.cumsum(begins) - 1] if len(every) else segments.near
        lower, upper = (segments.points(every, depth) for depth in (segments.far, segments.near))
        return cls(trajectory[segments.owner], lower, upper, segments.far - top)

    @classmethod
    def joined(cls, parts: Sequence[_Removed]) -> _Removed:
        """Join several sets of removed segments of rays."""
        nothing = cls(np.empty(0, np.int64), np.empty((0, 3)), np.empty((0, 3)), np.empty(0))
        columns = zip(*((one.trajectory, one.lower, one.upper, one.height) for one in (nothing, *parts)))
        return cls(*map(np.concatenate, columns))

    def is_by(self, trajectories: int) -> np.ndarray:
        """Return whether each trajectory removes a segment of a ray, (trajectories,) bool."""
        found = np.zeros(trajectories, bool)
        found[self.trajectory] = True
        return found

    def within_holders(self, cuts: Cuts, bodies: Sequence[Body | None]) -> _Removed:
        """Return the segments of rays whose lower ends are below the upper ends of the holders."""
        ends = [cut.tool.holder_length or np.inf for cut in cuts.cuts]
        tops = np.array([body.bottom + end if body else np.inf for body, end in zip(bodies, ends)])
        tip = np.minimum(*(points[:, 2] for points in cuts.ends))
        kept = self.lower[:, 2] < (tip + tops[cuts.cut])[self.trajectory]
        return _Removed(self.trajectory[kept], self.lower[kept], self.upper[kept], self.height[kept])

    def collisions(self, cuts: Cuts, body: str, clamp: str = "") -> Iterator[Collision]:
        """Yield one collision for each operation in which bodies (shanks or holders) remove segments of rays."""
        cut = cuts.cut[self.trajectory]
        for number in np.unique(cut).tolist():
            own = np.flatnonzero(cut == number)
            first, last = int(self.trajectory[own].min()), int(self.trajectory[own].max())
            segments = own[self.trajectory[own] == first]
            longest = segments[np.argmax((self.upper - self.lower)[segments, 2])]
            x, y, z = ((self.lower[longest] + self.upper[longest]) / 2).tolist()
            tool = cuts.cuts[number].tool
            size = {FLUTES: tool.cutting_edge_height, LENGTH: tool.length}.get(body) or 0.0
            depth = float(self.height[own].max())
            yield Collision(body, first, cuts.source(first), cuts.source(last), (x, y, z), depth, clamp, size)
