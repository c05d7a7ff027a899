# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make jobs with one fault each, and sound jobs, and count the faults that a simulation finds.

    python3 benchmarks/zbuffer_faults.py [JOBS [KIND ...]]      # JOBS of each kind, by default 25
    freecadcmd "$PWD/benchmarks/zbuffer_faults.py"              # also prints the facts on the example job

The number of sound jobs is four times JOBS. Each job cuts a pocket at a random place in a block of 20 to 600 mm, at
several depths by rows and a contour, with a tool of 0.1 to 20 mm. Then some holes are drilled and some lines are
engraved around the pocket. Each fault has a random place and a random size. In the sound jobs, the shanks, holders,
clamps and travel are only just sufficient. The benchmark prints each job in which the fault was not found, or another
fault was reported. Then the script prints for each kind of fault the number of jobs, the number of jobs in which the
fault is found with the right operation and command, and the number of jobs in which another fault is found. The jobs of
each kind depend only on `SEED` and on the kind.
"""

from __future__ import annotations

import os
import sys
import tempfile
from dataclasses import dataclass, field, replace
from itertools import product
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "benchmarks"), str(ROOT / "examples")]

from vkworkbench.core import Cut, Stock, Tool, Toolpath
from vkworkbench.core.stocks import Mesh
from vkworkbench.core.zbuffer import (
    SeenModel,
    axis_view,
    check_crashes,
    facts,
    holder_collisions,
    simulate_job,
    thin_gouges,
)
from vkworkbench.report import OperationReport, extent_of, with_travel

JOBS, SEED = 25, 47
# Memory limit of a simulation, bytes. The default limit in the preferences is 25 times as large and gives finer images.
MEMORY = 40e6
FEED, PLUNGE = 10.0, 2.0  # mm/s
ABOVE = 5.0  # distance of rapids above the block, mm
# A copy of the standard output, because FreeCAD writes its progress to the original.
OUT = os.fdopen(os.dup(1), "w")


@dataclass
class Moves:
    """Moves with their feeds. Each move is one command."""

    points: list = field(default_factory=list)
    feeds: list = field(default_factory=list)

    def rapid(self, x, y, z) -> None:
        self._add((x, y, z), 0.0)

    def feed(self, x, y, z, feed=None) -> None:
        falls = bool(self.points) and z < self.points[-1][2]
        self._add((x, y, z), feed or (PLUNGE if falls else FEED))

    @property
    def commands(self) -> int:
        """Number of G-code commands so far. The first point of the toolpath is a position, not a command."""
        return max(0, len(self.points) - 1)

    def _add(self, point, feed) -> None:
        if not self.points or point != self.points[-1]:
            self.points.append(point)
            self.feeds.append(feed)

    def cut(self, tool, allowed_depth=0.0) -> Cut:
        path, feeds = Toolpath.through(np.array(self.points, float)), np.array(self.feeds[1:])
        return Cut(replace(path, rapid=feeds == 0, feed=feeds), tool, PLUNGE, allowed_depth)


class Job:
    """A block with a pocket, holes and engraved lines, and the moves that cut them."""

    def __init__(self, rng, fault) -> None:
        self.rng, self.fault = rng, fault
        self.made_by = None  # index of the cut and number of the command that make the fault
        self.size = np.exp(rng.uniform(np.log(20), np.log(600), 3))
        self.size[2] = min(self.size[2], 50)
        diameter = np.exp(rng.uniform(np.log(0.1), np.log(min(20, self.size[:2].min() / 5))))
        self.tool, self.radius = Tool("endmill", diameter), diameter / 2
        self.depth = min(rng.uniform(0.5, 3) * diameter, self.size[2] / 2)
        wide = np.minimum(rng.uniform(1.5, 20, 2) * diameter, self.size[:2] / 3)
        self.low = rng.uniform(0.3 * self.size[:2], 0.6 * self.size[:2] - wide / 2)
        self.high = self.low + np.maximum(wide, 1.2 * diameter)
        self.top = self.size[2]
        self.safe = self.top + ABOVE
        # Size of the error that the job's fault makes, mm.
        self.error = float(rng.uniform(0.2, 1.0))
        self.hole_places = self.places(4)
        if fault in BODIES:
            self.depth = max(self.depth, 1.0)
        self.cuts = [self.pocket().cut(self.tool), *self.holes(), self.lines()]
        self.travel = self.extent * rng.uniform(1.001, 2, 3)
        if fault == "travel":
            axis = int(rng.integers(3))
            self.travel[axis] = self.extent[axis] * rng.uniform(0.5, 0.999)
            self.made_by = "XYZ"[axis]
        beside = self.size[0] + 1 + (self.tool.holder_diameter or 0) / 2
        self.clamp = Stock((beside, 0, 0), (beside + 30, self.size[1], self.top + ABOVE / 2))
        if fault == "clamp":
            self.clamp = self.clamp_in_the_way()

    @property
    def extent(self) -> np.ndarray:
        """Return the range of the positions of all tools along X, Y and Z, (3,) mm."""
        return np.ptp(np.concatenate([cut.toolpath.points for cut in self.cuts]), axis=0)

    def clamp_in_the_way(self) -> Stock:
        """Return a clamp on the block, between two holes, away from the pocket."""
        while True:
            first, second = self.hole_places[1:3]
            middle, half = (first + second) / 2, self.rng.uniform(0.5, 5, 2)
            lower, upper = middle - half, middle + half
            top = self.safe + self.rng.uniform(0.5, 5)
            hits = [entered(self.cuts, lower - more, upper + more, top + more) for more in (-0.1, 0.0, 0.1)]
            if upper[1] < self.low[1] - 0.5 and hits[0] == hits[1] == hits[2] != []:
                self.made_by = hits[0]
                return Stock((*lower, self.top), (*upper, top))
            self.hole_places = self.places(4)
            self.cuts[1:2] = self.holes()

    def choose_bodies(self, layers) -> np.ndarray:
        """Choose the sizes of flutes, shank and holder of the pocket's tool, and return the heights of the cuts."""
        rng, fault, diameter = self.rng, self.fault, 2 * self.radius
        depth = self.top - layers[-1]
        thickest = diameter + max(2 * diameter, 0.5)
        thicker = np.exp(rng.uniform(np.log(diameter + 0.05), np.log(thickest)))
        sizes = {
            "cutting_edge_height": depth + rng.uniform(0.1, 2.0),
            "length": 60.0,
            "shank_diameter": thicker,
            "holder_diameter": 3 * thickest,
            "holder_length": 30.0,
        }
        # A height between two depths of cut. A shank or holder whose lower end is at this height collides at the lower
        # depth.
        deep = int(rng.integers(1, len(layers)))
        between = self.top - (layers[deep - 1] + layers[deep]) / 2
        if fault == "shank":
            sizes["cutting_edge_height"] = between
        elif fault == "flutes":
            layers = np.delete(layers, deep - 1)
            deep -= 1
            above = layers[deep - 1] if deep else self.top
            sizes.update(cutting_edge_height=0.75 * (above - layers[deep]), shank_diameter=diameter)
        elif fault in ("holder", "short"):
            sizes.update(length=between, cutting_edge_height=between, shank_diameter=diameter)
            if fault == "short":
                sizes.update(holder_diameter=None, holder_length=None)
        elif rng.random() < 0.5 and fault not in ("no retract", "wall", "clamp"):
            # Half of the jobs that get here have flutes that are only slightly longer than a depth step, with a shank
            # of the same diameter. In the other half of the jobs, the holder is just above the block. Jobs with the
            # faults in the condition are excluded: their moves beside the pocket are too deep for these flutes, or
            # their clamp collides with this holder.
            if rng.random() < 0.5:
                thickness = max(-np.diff(layers, prepend=self.top))
                sizes.update(cutting_edge_height=1.01 * thickness + 0.05, shank_diameter=diameter)
            else:
                sizes.update(length=depth + 0.1, cutting_edge_height=depth + 0.1)
        if fault == "clamp":
            # A wide shank would also hit the clamp, in small blocks at every place of the clamp.
            sizes["shank_diameter"] = diameter
        self.tool = replace(self.tool, **sizes)
        self.deep = deep
        return layers

    def pocket(self) -> Moves:
        moves, fault, rng = Moves(), self.fault, self.rng
        low, high = self.low + self.radius, self.high - self.radius
        layers = np.linspace(self.top, self.top - self.depth, rng.integers(3, 6))[1:]
        if fault == "deep layer":
            layers[-1] -= self.error
        layers = self.choose_bodies(layers)
        moves.rapid(*low, self.safe)
        for number, z in enumerate(layers):
            last = number == len(layers) - 1
            if fault == "rapid plunge" and last:
                # A place beside the pocket, where the higher cuts have not removed the material.
                x, y = low[0] - self.radius * rng.uniform(1, 2), low[1]
                self.made_by = 0, moves.commands + 1
                moves.rapid(x, y, self.safe)
                moves.rapid(x, y, z)
                moves.rapid(x, y, self.safe)
                moves.rapid(*low, self.safe)
            moves.rapid(*low, layers[number - 1] + 0.1 if number else self.top + 1)
            if fault == "fast plunge" and last:
                self.made_by = 0, moves.commands
            if fault == "deep layer" and last:
                self.made_by = 0, moves.commands
            if fault in BODIES and number == self.deep:
                # If the flutes are too short, the fault is not the plunge but the first move of the row after the
                # plunge.
                self.made_by = 0, moves.commands + (fault == "flutes")
            moves.feed(*low, z, FEED if fault == "fast plunge" and last else None)
            for k, y in enumerate(
                np.linspace(low[1], high[1], max(2, 1 + int((high[1] - low[1]) / (0.9 * self.radius))))
            ):
                ends = (low[0], high[0]) if k % 2 == 0 else (high[0], low[0])
                for x in ends:
                    moves.feed(x, y, z)
            wide = self.error if fault == "wall" and last else 0.0
            corners = [(low[0], high[1]), (high[0], high[1]), (high[0], low[1]), (low[0], low[1])]
            for corner in corners:
                moves.feed(*corner, z)
            if wide:
                self.made_by = 0, moves.commands
                moves.feed(low[0] - wide, low[1], z)
                moves.feed(low[0] - wide, high[1], z)
                moves.feed(low[0], high[1], z)
                moves.feed(*low, z)
            if fault == "no retract" and last:
                self.made_by = 0, moves.commands
                moves.rapid(
                    low[0] - self.radius - rng.uniform(2, 5) * self.radius, rng.uniform(*self.size[1:2] * (0.3, 0.6)), z
                )
            moves.rapid(*moves.points[-1][:2], self.safe)
            moves.rapid(*low, self.safe)
        return moves

    def holes(self) -> list[Cut]:
        """Return drilling moves that end just above the block, because the top of the block is part of the model.

        The fault "deep hole" is a move into the block.
        """
        moves = Moves()
        moves.rapid(0, 0, self.safe)
        for x, y in self.hole_places:
            moves.rapid(x, y, self.safe)
            moves.rapid(x, y, self.top + 0.5)
            moves.feed(x, y, self.top + 0.05)
            moves.rapid(x, y, self.safe)
        if self.fault == "deep hole":
            x, y = self.places(1)[0]
            moves.rapid(x, y, self.safe)
            self.made_by = 1, moves.commands
            moves.feed(x, y, self.top - self.error)
            moves.rapid(x, y, self.safe)
        return [moves.cut(Tool("endmill", 2 * self.radius))]

    def lines(self) -> Cut:
        """Return the cut of engraved lines, which are not in the model."""
        moves, depth = Moves(), 0.2
        moves.rapid(0, 0, self.safe)
        for number, (x, y) in enumerate(self.places(3)):
            deep = depth + (self.error + 0.1 if self.fault == "deep line" and number == 1 else 0.0)
            moves.rapid(x, y, self.safe)
            moves.rapid(x, y, self.top + 0.5)
            if deep > depth:
                self.made_by = 2, moves.commands
            moves.feed(x, y, self.top - deep)
            moves.feed(x, min(y + 5 * self.radius, 0.25 * self.size[1]), self.top - deep)
            moves.rapid(*moves.points[-1][:2], self.safe)
        return moves.cut(Tool("vbit", max(0.5, 2 * self.radius), tip_angle=np.pi / 2, tip_diameter=0.1), depth)

    def places(self, count):
        """Return points beside the pocket."""
        return self.rng.uniform((0.1, 0.1) * self.size[:2], (0.9, 0.2) * self.size[:2], (count, 2))

    @property
    def model(self) -> Mesh:
        """Return the model: the block with its pocket."""
        xs, ys = ([0.0, low, high, end] for low, high, end in zip(self.low, self.high, self.size))
        floor, top = self.top - self.depth, self.top
        triangles = []

        def face(a, b, c, d) -> None:
            triangles.extend([(a, b, c), (a, c, d)])

        for i, j in product(range(3), range(3)):
            (x0, x1), (y0, y1) = xs[i : i + 2], ys[j : j + 2]
            z = floor if i == j == 1 else top
            for height in (0.0, z):
                face((x0, y0, height), (x1, y0, height), (x1, y1, height), (x0, y1, height))
        for x, y0, y1, low in self._walls(xs, ys):
            face((x, y0, low), (x, y1, low), (x, y1, top), (x, y0, top))
        for y, x0, x1, low in self._walls(ys, xs):
            face((x0, y, low), (x1, y, low), (x1, y, top), (x0, y, top))
        return Mesh(np.array(triangles))

    def _walls(self, across, along):
        """Yield position, extent and lower end of each outer wall and of each wall of the pocket.

        Each outer wall is divided at the walls of the pocket, as the top of the block is.
        """
        for at in (across[0], across[3]):
            for k in range(3):
                yield at, along[k], along[k + 1], 0.0
        for at in across[1:3]:
            yield at, along[1], along[2], self.top - self.depth


# For each kind of fault, the name under which the facts of the simulation list it.
KINDS = {
    "no retract": "crashes", "rapid plunge": "crashes", "fast plunge": "fast_plunges", "deep layer": "gouges", "wall": "gouges",
    "deep hole": "gouges", "deep line": "gouges", "shank": "shank", "flutes": "flutes", "holder": "holder", "short": "length",
    "clamp": "tool", "travel": "travel",
}  # fmt: skip
# Kinds of faults that also cut into the model.
GOUGING = ("no retract", "rapid plunge")
# Kinds of faults in which the material touches a shank or holder, or flutes or tool are too short.
BODIES = ("shank", "flutes", "holder", "short")


def entered(cuts, lower, upper, top) -> list:
    """Return for each cut its number and the command of the first move that enters a box (x, y) below a height.

    The moves are tested in small steps.
    """
    found = []
    for number, cut in enumerate(cuts):
        points = cut.toolpath.points
        share = np.linspace(0, 1, 500)[:, None]
        for command, (start, end) in enumerate(zip(points, points[1:])):
            at = start + share * (end - start)
            away = np.hypot(*np.maximum(0, np.maximum(lower - at[:, :2], at[:, :2] - upper)).T)
            if ((at[:, 2] < top) & (cut.tool.height(away) < top - at[:, 2])).any():
                found.append((number, command))
                break
    return found


def found_in(job: Job):
    """Return the faults that a simulation of a job finds: the name, cut and command of each."""
    cuts, stock = job.cuts, Stock((0, 0, 0), job.size)
    view = axis_view(cuts, stock, memory_bytes=MEMORY, seconds=60)
    zbuffer = simulate_job(cuts, stock=stock, view=view)
    seen = SeenModel(job.model, zbuffer.frame)
    collisions = holder_collisions(zbuffer.cuts, stock, clamps={"clamp": job.clamp})
    thin = thin_gouges(cuts, stock, seen)
    found = facts(zbuffer, check_crashes(cuts, stock), thin=thin, model=seen, collisions=collisions).job
    faults = {
        (name, one.source and (one.source.cut, one.source.command))
        for name in ("crashes", "fast_plunges", "gouges")
        for one in getattr(found, name)
    }
    faults |= {(one.body, (one.source.cut, one.source.command)) for one in found.collisions}
    return faults | {("travel", axis) for axis in beyond_travel(job)}


def beyond_travel(job: Job) -> list:
    """Return the axes along which a report says that the job needs more travel than the machine has."""
    empty = OperationReport("", "", "", "", True, None, 0, None, {}, {}, (), (), "")
    rows = [replace(empty, name=str(k), extent=extent_of(cut.toolpath)) for k, cut in enumerate(job.cuts)]
    rows = with_travel(rows, rows, tuple(job.travel))
    return [remark.arguments["axis"] for row in rows for remark in row.remarks]


def main(jobs: int = JOBS, *kinds: str) -> None:
    print(f"{'':14}{'jobs':>6}{'found':>6}{'else':>6}   seed {SEED}", file=OUT)
    for number, fault in enumerate(("sound", *KINDS)):
        if kinds and fault not in kinds:
            continue
        rng, row = np.random.default_rng((SEED, number)), np.zeros(3, int)
        for _ in range(jobs if number else 4 * jobs):
            job = Job(rng, fault)
            made_by = job.made_by if fault == "clamp" else [job.made_by]
            right = {(KINDS[fault], one) for one in made_by} if number else set()
            also = {("gouges", job.made_by)} if fault in GOUGING else set()
            found = found_in(job)
            row += [1, right <= found, bool(found - right - also)]
            if not right <= found <= right | also:
                print(
                    f"{fault}, job {row[0]}: {sorted(right, key=str)}, found {sorted(found, key=str)}",
                    file=OUT,
                    flush=True,
                )
        print(f"{fault:14}" + "".join(f"{n:6}" for n in row), file=OUT, flush=True)


def example() -> None:
    from make_example import make_example

    import vkworkbench

    with tempfile.TemporaryDirectory() as folder:
        found = vkworkbench.simulate(make_example(Path(folder) / "example.FCStd")).facts()
    print(f"\nthe example job\n{found}", file=OUT, flush=True)
    print(f"left on {sum(one.area for one in found.job.left):.0f} mm2, in {len(found.job.left)} places", file=OUT)


if __name__ == "__main__" or "FreeCAD" in sys.modules:
    if "FreeCAD" not in sys.modules:
        main(*map(int, sys.argv[1:2]), *sys.argv[2:])
    else:
        main()
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        example()
        OUT.flush()
