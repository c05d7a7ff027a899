# SPDX-License-Identifier: LGPL-2.1-or-later
"""Run FreeCAD's simulators and print their times, for simulators.py, simulators_window.py and simulators_opengl.py."""

from __future__ import annotations

import math
import os
from pathlib import Path
from statistics import median

import FreeCAD
import numpy as np
import Part

RENDERER = "llvmpipe"  # the OpenGL renderer under Xvfb, which uses the processor
MOST_STOLEN = 0.03  # runs from which the host takes a larger share of the time for other virtual machines are left out
ROUNDS = {"fast-forward": 3, "play": 5, "OpenGL play": 3}  # number of runs of each simulation in a window


def shape(tool):
    """Return the solid of a tool."""
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
    """Run each simulation a few times, in turns with the other simulations.

    `runs` has a kind and a function for each simulation. Because the simulations take turns, a slow minute of the
    computer affects only one run of each simulation. Return the times of each simulation, s, without the runs from
    which the host took time; None for a simulation that did not end.
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
    """Return as text a prediction, the median time of the runs, and all times of the runs."""
    each = " ".join(f"{taken:.2f}" for taken in seconds)
    return f"{predicted:7.2f} s  {median(seconds or [math.nan]):7.2f} s  of {each}"


def left_out(durations):
    """Return a text with the number of simulations in which the host took time from every run."""
    return f"left out, the host took time from them: {durations.count([])} of {len(durations)}"


def summary(kind, ratios):
    """Return a text that summarises the ratios of predicted to measured time for one kind of simulation."""
    if not ratios:
        return f"{kind}, 0 runs"
    return f"{kind}, {len(ratios)} runs, ratio median / p90 / worst: {quantiles(ratios)}"


def quantiles(ratios):
    """Return a text with the median, the 90th percentile and the largest value of `ratios`."""
    return " / ".join(f"{q:.2f}" for q in np.percentile(ratios, (50, 90, 100)))


def stolen() -> float:
    """Return the time that the host has given to other virtual machines so far, s; 0 if it is unknown."""
    try:
        times = Path("/proc/stat").read_text().split("\n", 1)[0].split()
    except OSError:
        return 0.0
    return int(times[8]) / os.sysconf("SC_CLK_TCK")
