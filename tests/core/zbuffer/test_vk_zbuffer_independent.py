# SPDX-License-Identifier: LGPL-2.1-or-later
"""The extended z-buffer is compared with a second implementation that shares only the tool's profile with it.

A point belongs to the first trajectory whose tool reaches the point. The second implementation tries single points with
every move: the height of the tool's surface above a point is a convex function of the tool's place on its move, so
halving
finds the lowest height. The points are probes on the rays. Probes beside both ends of every segment of a ray check the
depth at
which the segment ends, and probes between the ends check the trajectory that removed the segment.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from zbuffer_inputs import BOX, CHAMFERS, DIRECTIONS, PATHS, ROUND, TOOLS, close, free, surface, toolpath, zigzag

from vkworkbench.core import Tool, View
from vkworkbench.core.zbuffer.rays.chains import cut_rays
from vkworkbench.core.zbuffer.rays.dexels import THINNEST, first_cuts
from vkworkbench.core.zbuffer.rays.removal import Removal
from vkworkbench.core.zbuffer.simulator.simulate import simulate, simulate_job
from vkworkbench.core.zbuffer.sweeps.cuts import Cut

# Distance between the end of a segment of a ray and the probe beside this end, mm.
BESIDE = 5e-4
# The tool is grown or shrunk by this length before a probe is compared, mm, because depths are float32 and segments of
# rays up to THINNEST are joined to their neighbours.
CLEARANCE = 2e-4
# Positions of the probes between the two ends of a segment of a ray, as shares of the length of the segment.
BETWEEN = (0.1, 0.3, 0.5, 0.7, 0.9)
# Differences of depths up to this length are rounding errors, mm.
NOISE = 1e-7
# Number of halvings of a move in the search for the lowest height of the tool, down to a stretch of 1e-5 mm.
HALVINGS = 24


def reached(tool, start, move, at, grown):
    """Return which points a tool reaches on its move.

    Parameters
    ----------
    tool : Tool
    start, move, at : (3, k) ndarray
        Start of the tip, its displacement, and the point, mm.
    grown : float
        Distance by which the tool is enlarged on all sides, mm. With a negative distance, the tool is made smaller.

    Returns
    -------
    (k,) ndarray of bool
    """
    x, y, z = at - start
    run2 = move[0] ** 2 + move[1] ** 2
    vertical = run2 == 0
    safe_run2 = np.where(vertical, 1.0, run2)
    foot = np.where(vertical, 0.0, (x * move[0] + y * move[1]) / safe_run2)
    rest2 = (tool.radius + grown) ** 2 - (x - foot * move[0]) ** 2 - (y - foot * move[1]) ** 2
    half = np.where(vertical, 1.0, np.sqrt(np.maximum(rest2, 0) / safe_run2))
    # The point is within the tool's radius from the share `first` to the share `last` of the move.
    first, last = np.maximum(foot - half, 0), np.minimum(foot + half, 1)
    found = (rest2 >= 0) & (first <= last)
    (these,) = np.nonzero(found)
    x, y, z, first, last, move = x[these], y[these], z[these], first[these], last[these], move[:, these]

    def surface_above(t):
        """Return the height of the tool's surface above the point, if the tool is at the share `t` of its move."""
        r = np.hypot(x - t * move[0], y - t * move[1])
        return t * move[2] + tool.profile(np.maximum(r - grown, 0)) - grown - z

    step = 1e-7
    for _ in range(HALVINGS):
        middle = (first + last) / 2
        rises = surface_above(middle + step) > surface_above(middle - step)
        first, last = np.where(rises, first, middle), np.where(rises, middle, last)
    found[these] = surface_above((first + last) / 2) <= 0
    return found


def wrong_probes(cuts, at, owner, uncut):
    """Return which points (p, 3) the trajectory `owner` (p,) does not remove; the owner `uncut` means no removal."""
    starts, ends = cuts.ends
    wrong = np.zeros(len(at), bool)
    for number, cut in enumerate(cuts.cuts):
        tool, own = cut.tool, np.arange(cuts.first[number], cuts.first[number + 1])
        if len(own) == 0:
            continue
        lower = np.minimum(starts[own], ends[own]) - [tool.radius, tool.radius, 0]
        upper = np.maximum(starts[own], ends[own])[:, :2] + tool.radius
        for some in np.array_split(np.arange(len(at)), 1 + len(at) * len(own) // 4_000_000):
            point = at[some, None]
            near = (point >= lower).all(axis=2) & (point[..., :2] <= upper).all(axis=2)
            probe, item = np.nonzero(near & (own < owner[some, None]))
            probe, item = some[probe], own[item]
            # The swept volumes of trajectories before the owner (the trajectory that removed the segment) exclude the
            # probe.
            earlier = reached(tool, starts[item].T, (ends - starts)[item].T, at[probe].T, -CLEARANCE)
            wrong[probe[earlier]] = True
        # The swept volume of the owner (the removing trajectory) contains the probe.
        probe = np.flatnonzero(np.isin(owner, own) & (owner < uncut))
        item = owner[probe]
        wrong[probe] |= ~reached(tool, starts[item].T, (ends - starts)[item].T, at[probe].T, CLEARANCE)
    return wrong


def check(z, stock, pixels=None):
    """Check that the trajectory of each segment of a ray removes the points of the segment, for some pixels or all."""
    frame, dexels, cut = z.frame, z.dexel_records, z.trace_records["trajectory"] < z.step
    traces = z.trace_records[cut]
    trace_pixel = np.repeat(np.arange(frame.width * frame.height), np.diff(z.trace_index.astype(int)))[cut]
    pixel = np.concatenate((dexels["pixel"], trace_pixel)).astype(int)
    near, far = (np.concatenate((dexels[end], traces[end])).astype(float) for end in ("near", "far"))
    owner = np.concatenate((np.full(len(dexels), z.step), traces["trajectory"])).astype(int)
    order = np.lexsort((near, pixel))
    if pixels is not None:
        order = order[np.isin(pixel[order], pixels)]
    pixel, near, far, owner = pixel[order], near[order], far[order], owner[order]
    check_that_rays_are_filled(frame, stock, pixel, near, far, owner, pixels)
    shares = (far - near)[:, None] * BETWEEN
    beside = np.minimum(BESIDE, (far - near) / 3)
    depth = np.column_stack((near + beside, near[:, None] + shares, far - beside))
    row, column = np.divmod(np.repeat(pixel, depth.shape[1]), frame.width)
    owner = np.repeat(owner, depth.shape[1])
    wrong = wrong_probes(z.cuts, frame.points(column, row, depth.ravel()), owner, z.step)
    assert not wrong.any(), list(zip(column[wrong], row[wrong], depth.ravel()[wrong], owner[wrong]))[:5]


def check_that_rays_are_filled(frame, stock, pixel, near, far, owner, pixels):
    """Compare the segments of rays with the stock: no part of a ray may be missing or occur twice."""
    first = np.append(True, pixel[1:] != pixel[:-1]) if len(pixel) else np.zeros(0, bool)
    last = np.append(first[1:], True) if len(pixel) else first
    all_pixels = np.arange(frame.width * frame.height) if pixels is None else np.sort(pixels)
    row, column = np.divmod(all_pixels, frame.width)
    enter, leave = stock.chords(frame.origins(*frame.pixel_centres(column, row)), frame.direction)
    met = leave - enter > THINNEST
    assert np.array_equal(pixel[first], all_pixels[met])
    assert close(near[first], enter[met], NOISE, NOISE) and close(far[last], leave[met], NOISE, NOISE)
    assert np.array_equal(near[~first], far[~last])
    assert (far > near).all()
    assert (owner[~first] != owner[~last]).all()


def check_that_culling_drops_nothing(z, stock):
    """Compare a z-buffer with rays that are tested with all trajectories whose bounding boxes they pass."""
    frame, records = z.frame, z.records
    row, column = np.divmod(np.arange(frame.width * frame.height), frame.width)
    segments, _ = Removal(z.cuts, stock, frame).cut(*frame.pixel_centres(column, row))
    assert np.array_equal(records.pixel(), segments.ray)
    assert np.array_equal(records.owner, np.minimum(segments.owner, z.trajectories))
    assert close(records.near(), segments.near, NOISE, NOISE) and close(records.far, segments.far, NOISE, NOISE)


def some_pixels(rng, view, count):
    """Return random pixels of an image, at most `count`."""
    every = view.width * view.height
    return rng.choice(every, min(count, every), replace=False)


EVERY_TOOL = TOOLS + CHAMFERS


@pytest.mark.long
@pytest.mark.parametrize("path", PATHS, ids=lambda path: path.__name__)
@pytest.mark.parametrize("tool", EVERY_TOOL, ids=str)
def test_each_ray_segment_belongs_to_the_move_that_removes_it(tool, path):
    """The last moment of the simulation and a random earlier moment are compared."""
    which = PATHS.index(path), EVERY_TOOL.index(tool)
    rng = np.random.default_rng(which)
    # Every fourth direction is tested, so that each direction meets each path with a quarter of the tools.
    for direction in DIRECTIONS[sum(which) % 4 :: 4]:
        points = path(rng, int(rng.choice([4, 30, 60])))
        width, height = (int(v) for v in rng.integers(1, (60, 45)))
        # With pixels of 0.31 mm, no ray lies in a face of the stock, where rounding would decide whether it meets the
        # stock.
        view = View(direction, width, height, pixel=(None, 0.31)[rng.integers(2)])
        stock = (BOX, ROUND)[rng.integers(2)]
        z = simulate(toolpath(points), tool=tool, stock=stock, view=view)
        check_that_culling_drops_nothing(z, stock)
        check(z, stock, some_pixels(rng, view, 60))
        check(z.at(int(rng.integers(len(points)))), stock, some_pixels(rng, view, 20))


@pytest.mark.parametrize("direction", [(0, 0, -1), (1, 0.5, -0.3)])
def test_check_finds_shifted_and_wrong_segments_of_rays(direction):
    """Ends of segments are shifted by 0.001 mm, or a segment is assigned to the move before or after the right move."""
    points = free(np.random.default_rng(2), 8)
    z = simulate(toolpath(points), tool=TOOLS[0], stock=BOX, view=View(direction, 30, 20))
    check(z, BOX)
    records = z.records
    pixel, cut = records.pixel(), records.cut
    inner = np.append(pixel[1:] == pixel[:-1], False)  # Segments of rays that another segment follows.
    assert inner.sum() > 100
    for far, owner in (
        (records.far + np.float32(1e-3) * inner, records.owner),
        (records.far - np.float32(1e-3) * inner, records.owner),
        (records.far, np.where(cut, (records.owner + 1) % 8, records.owner)),
        (records.far, np.where(cut, (records.owner - 1) % 8, records.owner)),
    ):
        with pytest.raises(AssertionError):
            check(replace(z, records=replace(records, far=far, owner=owner.astype(np.int32))), BOX)


BALLS = [Tool("ballend", 6), Tool("ballend", 2.5)]


@pytest.mark.long
@pytest.mark.parametrize("tools", [EVERY_TOOL, BALLS, CHAMFERS], ids=["any", "balls", "chamfers"])
@pytest.mark.parametrize("direction", DIRECTIONS, ids=str)
def test_removed_points_belong_to_the_right_moves_and_tools(direction, tools):
    """The images are up to several tiles wide."""
    rng = np.random.default_rng([DIRECTIONS.index(direction), len(tools)])
    paths = [PATHS[rng.integers(len(PATHS))] for _ in range(rng.integers(2, 5))]
    cuts = [Cut(toolpath(path(rng, int(rng.choice([4, 30])))), tools[rng.integers(len(tools))]) for path in paths]
    view = View(direction, *(int(v) for v in rng.integers(1, rng.choice([60, 140]), 2)))
    stock = (BOX, ROUND)[rng.integers(2)]
    z = simulate_job(cuts, stock=stock, view=view)
    check_that_culling_drops_nothing(z, stock)
    check(z, stock, some_pixels(rng, view, 200))


@pytest.mark.long
def test_points_belong_to_the_right_pass_of_thousands():
    """Thousands of passes cross each tile, and culling must drop most passes."""
    rng = np.random.default_rng(0)
    for points, tool, direction in (
        (zigzag(rng, 3000), TOOLS[0], (0, 0, -1)),
        (zigzag(rng, 600), TOOLS[0], (1, 1, -1)),
        (surface(rng, 3000), TOOLS[2], (0, 0, -1)),
        (np.concatenate([zigzag(rng, 400)[:, [1, 0, 2]] for _ in range(4)]), TOOLS[3], (0, 0, -1)),
    ):
        view = View(direction, 100, 80)
        z = simulate(toolpath(points), tool=tool, stock=BOX, view=view)
        check_that_culling_drops_nothing(z, BOX)
        check(z, BOX, some_pixels(rng, view, 20))


def test_passes_that_cut_nothing_are_dropped_for_large_tiles():
    points = zigzag(np.random.default_rng(1), 200)
    once, often = (
        simulate(toolpath(np.tile(points, (k, 1))), tool=TOOLS[0], stock=BOX, view=View(width=200, height=150))
        for k in (1, 50)
    )
    assert once.traces == often.traces
    assert often.candidates < 12 * once.candidates


def test_fast_and_general_cuts_of_rays_with_one_gap_are_equal():
    rng = np.random.default_rng(5)
    rays, each = 300, 6
    near, far = np.full(rays, -3.0), rng.uniform(2, 9, rays)
    ray = np.repeat(np.arange(rays), each)
    middle = rng.choice([0.0, 1.0, 2.0], len(ray))
    length = rng.choice([1e-5, 5e-5, 0.7, 2.0, 4.0], len(ray))
    enter, leave = middle - length * rng.random(len(ray)), middle + length
    trajectory = np.tile(np.arange(each), rays)
    quick = cut_rays(near, far, ray, trajectory, enter, leave)
    general = first_cuts(near, far, ray, trajectory, enter, leave)
    for name in ("ray", "owner"):
        assert np.array_equal(getattr(quick, name), getattr(general, name)), name
    for name in ("near", "far"):
        assert getattr(quick, name) == pytest.approx(getattr(general, name), abs=NOISE)
