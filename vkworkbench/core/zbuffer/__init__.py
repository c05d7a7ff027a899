# SPDX-License-Identifier: LGPL-2.1-or-later
"""Simulate machining with the paper's extended z-buffer, find faults in the result, and estimate the simulation's cost.

The functions of this package receive one or several `Cut` objects (a toolpath with its tool), a stock and a view. The
main classes are:

* `ZBuffer`: the simulated part as an image, with the exact dexels (remaining material) and traces (removed material) on
  each pixel's ray after any number of trajectories.
* `JobFacts`: what the simulation shows about each operation, such as gouges, material left and removed volume.
* `Estimate`: the number of records (dexels, trace elements and gaps), the memory and the time of a simulation,
  estimated from sampled rays.
* `Resolution`: the smallest pixel with which a simulation stays within a budget of memory and time.
* `OverBudget`: the error raised if a simulation needs too much memory.
* `Speed`: the measured speed of this computer, from which simulation times are estimated.
"""

from vkworkbench.core.zbuffer.cost.axis_view import axis_view
from vkworkbench.core.zbuffer.cost.bound import cauchy_crofton, cuts_surely, may_cut, most_bytes
from vkworkbench.core.zbuffer.cost.effort import WORK_UNITS
from vkworkbench.core.zbuffer.cost.estimate import Estimate, estimate, estimate_job
from vkworkbench.core.zbuffer.cost.resolution import Resolution, best_resolution, heaviest
from vkworkbench.core.zbuffer.cost.speed import Speed, fit_speed, measure_speed
from vkworkbench.core.zbuffer.findings.collisions import Collision, Collisions, holder_collisions
from vkworkbench.core.zbuffer.findings.crash_check import CrashCheck, check_crashes
from vkworkbench.core.zbuffer.findings.deviations import TOLERANCE, Deviation, gouges, material_left, worst_places
from vkworkbench.core.zbuffer.findings.facts import (
    cuts_air,
    engagement,
    removal_rates,
    removed_volumes,
    trajectory_table,
)
from vkworkbench.core.zbuffer.findings.faults import Crash, Plunge, crashes, fast_plunges
from vkworkbench.core.zbuffer.findings.job_facts import FACT_COLUMNS, CutFacts, JobFacts, facts
from vkworkbench.core.zbuffer.findings.seen_model import Deviations, SeenModel, deviations
from vkworkbench.core.zbuffer.findings.thin_gouges import ThinGouges, thin_gouges
from vkworkbench.core.zbuffer.findings.verdict import PENDING, Verdict
from vkworkbench.core.zbuffer.findings.volumes import Volumes, measure_volumes
from vkworkbench.core.zbuffer.memory.memory import OverBudget, Peak, memory_needed
from vkworkbench.core.zbuffer.rays.records import DEXEL, RECORD_BYTES, TRACE
from vkworkbench.core.zbuffer.rays.surface import STOCK
from vkworkbench.core.zbuffer.simulator.moments import ZBuffer
from vkworkbench.core.zbuffer.simulator.sharing import shared_seconds
from vkworkbench.core.zbuffer.simulator.simulate import simulate, simulate_job
from vkworkbench.core.zbuffer.simulator.solid import part_triangles, write_stl
from vkworkbench.core.zbuffer.sweeps.cuts import Cut, Cuts, Source

__all__ = [
    "DEXEL", "FACT_COLUMNS", "PENDING", "RECORD_BYTES", "STOCK", "TOLERANCE", "TRACE", "WORK_UNITS", "Collision",
    "Collisions", "Crash", "CrashCheck", "Cut", "CutFacts", "Cuts", "Deviation", "Deviations", "Estimate", "JobFacts",
    "OverBudget", "Peak", "Plunge", "Resolution", "SeenModel", "Source", "Speed", "ThinGouges", "Verdict", "Volumes",
    "ZBuffer", "axis_view", "best_resolution", "cauchy_crofton", "check_crashes", "crashes", "cuts_air",
    "cuts_surely", "deviations", "engagement", "estimate", "estimate_job", "facts", "fast_plunges", "fit_speed",
    "gouges", "heaviest", "holder_collisions", "material_left", "may_cut", "measure_speed", "measure_volumes",
    "memory_needed", "most_bytes", "part_triangles", "removal_rates", "removed_volumes", "shared_seconds", "simulate",
    "simulate_job", "thin_gouges", "trajectory_table", "worst_places", "write_stl",
]  # fmt: skip
