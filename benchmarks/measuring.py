# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run FreeCAD's simulators and print their times, for benchmarks/simulators.py and its two windows."""

from __future__ import annotations

import math
import os
from pathlib import Path
from statistics import median

import FreeCAD
import numpy as np
import Part

RENDERER = "llvmpipe"  # under Xvfb
MOST_STOLEN = 0.03  # of a run's time
ROUNDS = {"fast-forward": 3, "play": 5, "OpenGL play": 3}  # how often each simulation is run in a window


def shape(tool):
    """The solid of a tool."""
    if tool.shape == "ballend":
        ball = Part.makeSphere(tool.radius, FreeCAD.Vector(0, 0, tool.radius))
        shank = Part.makeCylinder(tool.radius, 30, FreeCAD.Vector(0, 0, tool.radius))
        return ball.fuse(shank).removeSplitter()
    heights = tool.steepness * tool.radius
    if heights:
        cone = Part.makeCone(0, tool.radius, heights)
        return cone.fuse(Part.makeCylinder(tool.radius, 30, FreeCAD.Vector(0, 0, heights))).removeSplitter()
    return Part.makeCylinder(tool.radius, 30)


def in_rounds(runs):
    """Run each simulation, a kind and a function, a few times in turns: a slow minute spoils one time of each only.

    Return the seconds of each without the runs from which the host took time; None for one that did not end.
    """
    times = [[] for _ in runs]
    for turn in range(max(ROUNDS.values())):
        for (kind, run), seconds in zip(runs, times):
            if turn >= ROUNDS[kind] or None in seconds:
                continue
            before = stolen()
            taken = run()
            if taken is None or stolen() - before <= MOST_STOLEN * taken:
                seconds.append(taken)
    return [None if None in seconds else seconds for seconds in times]


def beside(predicted, seconds):
    """Return a prediction, the median time of the runs and all their times as text."""
    each = " ".join(f"{taken:.2f}" for taken in seconds)
    return f"{predicted:7.2f} s  {median(seconds or [math.nan]):7.2f} s  of {each}"


def left_out(durations):
    """How many simulations have no undisturbed run, in words."""
    return f"left out, the host took time from them: {durations.count([])} of {len(durations)}"


def summary(kind, ratios):
    """The ratios of a kind of simulation in words."""
    if not ratios:
        return f"{kind}, 0 runs"
    return f"{kind}, {len(ratios)} runs, ratio median / p90 / worst: {quantiles(ratios)}"


def quantiles(ratios):
    """Their median, 90th percentile and largest in words."""
    return " / ".join(f"{q:.2f}" for q in np.percentile(ratios, (50, 90, 100)))


def stolen() -> float:
    """Return the seconds that the host of a virtual machine gave to others so far; 0 where it does not say."""
    try:
        times = Path("/proc/stat").read_text().split("\n", 1)[0].split()
    except OSError:
        return 0.0
    return int(times[8]) / os.sysconf("SC_CLK_TCK")
