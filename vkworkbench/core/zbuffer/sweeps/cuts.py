# SPDX-License-Identifier: LGPL-2.1-or-later
"""Represent a job as a sequence of toolpaths, each with its tool.

Trajectories are numbered consecutively over the whole sequence.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from vkworkbench.core.tool import Tool, check_tool
from vkworkbench.core.toolpath import Toolpath, check_toolpath, exact_lengths
from vkworkbench.given import number, of_kind, whole


@dataclass(frozen=True, eq=False)
class Cut:
    """One operation: a toolpath and the tool that follows the toolpath.

    Attributes
    ----------
    toolpath : Toolpath
    tool : Tool
    vertical_feed : float
        Largest feed for plunging, mm/s; 0 if unknown.
    allowed_depth : float
        Depth to which the operation deliberately cuts into the model, mm, as in engraving, V-carving and deburring. The
        depth is infinite if the tool only approximates another shape, so that its gouges are meaningless.

    Raises
    ------
    TypeError
        If an argument has a wrong type, for example if it is FreeCAD's Path or tool bit instead.
    ValueError
        If the feed or the depth is not a number.
    """

    toolpath: Toolpath
    tool: Tool
    vertical_feed: float = 0.0
    allowed_depth: float = 0.0

    def __post_init__(self) -> None:
        check_toolpath(self.toolpath)
        check_tool(self.tool)
        feed = number("vertical_feed", self.vertical_feed, "a number of mm/s")
        object.__setattr__(self, "vertical_feed", feed)
        depth = number("allowed_depth", self.allowed_depth, "a depth of at least 0 mm", lambda depth: depth >= 0)
        object.__setattr__(self, "allowed_depth", depth)


@dataclass(frozen=True)
class Source:
    """The operation and the command from which a trajectory was made.

    Attributes
    ----------
    cut : int
        Number of the operation (cut) in the job.
    trajectory, command : int
        Number of the trajectory in the operation's toolpath, and index of the command from which it was made.
    """

    cut: int
    trajectory: int
    command: int


class Cuts:
    """The operations of a job in machining order, with consecutive numbers for all their trajectories.

    The moves between two operations (cuts) are unknown. The simulation assumes that these moves remove nothing.

    Parameters
    ----------
    cuts : iterable of Cut

    Attributes
    ----------
    cuts : tuple of Cut
    first : (c + 1,) int64
        Number of the first trajectory of each operation (cut). The last entry is the total number of trajectories.

    Raises
    ------
    TypeError
        If an item is not a Cut.
    """

    def __init__(self, cuts: Iterable[Cut]) -> None:
        of_kind("a job", cuts, Iterable, "several Cut(toolpath, tool)")
        self.cuts = tuple(cuts)
        for cut in self.cuts:
            of_kind("each of a job", cut, Cut, "a Cut(toolpath, tool)")
        self.first = np.append(0, np.cumsum([len(cut.toolpath) for cut in self.cuts])).astype(np.int64)

    def __len__(self) -> int:
        """Return the number of trajectories in all operations."""
        return int(self.first[-1])

    @property
    def ends(self) -> tuple[np.ndarray, np.ndarray]:
        """Start and end points of all trajectories, two arrays (n, 3), mm."""
        starts = [np.asarray(cut.toolpath.points, float)[:-1] for cut in self.cuts]
        ends = [np.asarray(cut.toolpath.points, float)[1:] for cut in self.cuts]
        nothing = np.empty((0, 3))
        return np.concatenate((nothing, *starts)), np.concatenate((nothing, *ends))

    def blocks(self, size: int) -> Iterator[tuple[np.ndarray, np.ndarray, np.ndarray]]:
        """Yield batches of `size` trajectories: numbers of operations, (k,) int64, start and end points, (k, 3) mm."""
        own = [np.asarray(cut.toolpath.points, float) for cut in self.cuts if len(cut.toolpath)]
        points = np.concatenate((np.empty((0, 3)), *own))
        ahead = np.cumsum(np.diff(self.first) > 0) - 1  # each toolpath has one more point than trajectories
        for begin in range(0, len(self), size):
            cut = self.cut[begin : begin + size]
            at = np.arange(begin, begin + len(cut)) + ahead[cut]
            yield cut, points[at], points[at + 1]

    @cached_property
    def rapid(self) -> np.ndarray:
        """Whether each trajectory is a rapid, (n,) bool."""
        return self._column("rapid", bool)

    @cached_property
    def feed(self) -> np.ndarray:
        """Feed rate of each trajectory, (n,) mm/s; 0 for rapids and unknown feeds."""
        return self._column("feed", float)

    @cached_property
    def command(self) -> np.ndarray:
        """Index, in the operation, of the command from which each trajectory was made, (n,) int64."""
        return self._column("command", np.int64)

    @cached_property
    def lengths(self) -> np.ndarray:
        """Length of each trajectory, (n,) mm; for a chord of an arc, the length of the arc between the chord's ends."""
        return np.concatenate((np.empty(0), *(exact_lengths(cut.toolpath) for cut in self.cuts)))

    @cached_property
    def seconds(self) -> np.ndarray:
        """Duration of each trajectory, (n,) s; 0 for rapids and unknown feeds."""
        return np.where(self.feed > 0, self.lengths / np.where(self.feed > 0, self.feed, 1), 0.0)

    @cached_property
    def cut(self) -> np.ndarray:
        """Number of the operation (cut) to which each trajectory belongs, (n,) int64."""
        return np.repeat(np.arange(len(self.cuts)), np.diff(self.first))

    def source(self, trajectory: int) -> Source:
        """Return the operation and the command from which a trajectory was made.

        Raises
        ------
        IndexError
            If the trajectory's number is negative or too large.
        TypeError
            If `trajectory` is not an integer.
        """
        trajectory = whole("trajectory", trajectory, "a whole number")
        if not 0 <= trajectory < len(self):
            raise IndexError(f"there are the trajectories 0 to {len(self) - 1}, not {trajectory}")
        cut = int(np.searchsorted(self.first, trajectory, side="right")) - 1
        own = int(trajectory - self.first[cut])
        return Source(cut, own, int(self.cuts[cut].toolpath.command[own]))

    def _column(self, name: str, kind: type) -> np.ndarray:
        return np.concatenate((np.empty(0, kind), *(getattr(cut.toolpath, name) for cut in self.cuts)))
