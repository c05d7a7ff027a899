# SPDX-License-Identifier: LGPL-2.1-or-later
"""Compare the predicted cost of FreeCAD's simulators with their measured times and meshes.

    freecadcmd $PWD/benchmarks/simulators.py                 # the legacy simulator's meshes, without a window
    xvfb-run -a freecad $PWD/benchmarks/simulators.py        # fast-forward and play, in their own windows

The script simulates the operations of the example job, and up to 60 operations of each file in the environment variable
VKWORKBENCH_CORPUS. In the variable, the names of the files are separated by colons. The files have JSON lines (id,
label, tool_diameter, stock, commands) and may be gzipped. Errors are ratios of the larger to the smaller of prediction
and measurement. Times are valid only on an idle computer. Runs from which the host of a virtual machine took time are
left out. The time of a simulation is the time of its median run, because the shortest run would favour short
simulations, which fit into the fast moments of a shared processor.
"""

from __future__ import annotations

import math
import os
import sys
import tempfile
import time
from pathlib import Path
from unittest import mock

import FreeCAD
import numpy as np
import Part
from Path import Command
from PathSimulator import PathSim

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "examples"), str(ROOT / "tests")]

from inside_freecad import run_and_leave
from make_example import make_example
from measuring import quantiles, shape, stolen
from records import with_stock

from vkworkbench import freecad
from vkworkbench.core import Tool, linearize
from vkworkbench.core.simulators import DEFAULTS, OPENGL, Task, available, legacy, legacy_cost, legacy_mesh
from vkworkbench.document.computer.calibration import calibrate, constants
from vkworkbench.document.job.operations import find
from vkworkbench.document.job.setting import read_stock, read_tool

ACCURACIES = (0.1, 0.5, 1.0)
MOST = 60
OUT = sys.__stdout__
FEW = 1000  # minimum number of triangles; smaller meshes count as this number, because they take almost no time
LOOKS = 12  # number of moments of a play at which the triangles of the mesh are counted


def main() -> int:
    doc = make_example(str(Path(tempfile.mkdtemp()) / "example.FCStd"))
    samples = list(of_document(doc))
    for name in filter(None, os.environ.get("VKWORKBENCH_CORPUS", "").split(":")):
        samples += of_corpus(name)
    print(f"\nFreeCAD {'.'.join(map(str, freecad.version()))}, {len(samples)} operations", file=OUT)
    if FreeCAD.GuiUp:
        import simulators_window

        calibrate_undisturbed()
        if OPENGL in available(freecad.version()):
            import simulators_opengl

            simulators_opengl.run(samples, OUT)
        simulators_window.run(samples, OUT)
    else:
        headless(samples)
    return 0


def calibrate_undisturbed():
    """Repeat the calibration until the host takes no time from it."""
    for _ in range(20):
        before = stolen()
        calibrate()
        if stolen() == before:
            return


def of_document(doc):
    """Yield name, commands, tool and stock of every operation in a document's jobs."""
    for operation in find(doc):
        commands = [(c.Name, c.Parameters) for c in operation.object.Path.Commands]
        yield operation.object.Label, commands, read_tool(operation.object), read_stock(operation.job)


def of_corpus(name):
    """Yield name, commands, tool and stock of operations in a file of JSON lines. 3D surfaces get a ball end mill."""
    for record, stock in with_stock(name, MOST):
        ball = record["label"].startswith(("Surface", "Waterline"))
        tool = Tool("ballend" if ball else "endmill", record["tool_diameter"])
        yield record["id"], record["commands"], tool, stock


def headless(samples):
    """Simulate every sample at every accuracy (size of a cell), and print the errors of predicted meshes and times."""
    own = constants(calibrate().speed)
    errors = {accuracy: [] for accuracy in ACCURACIES}
    simpler = {}
    for _, commands, tool, stock in samples:
        task = Task(linearize(commands), tool, stock)
        for accuracy in ACCURACIES:
            predicted = legacy_cost(task, accuracy=accuracy, constants=own)
            mesh, looks, cells = really(commands, tool, stock, predicted.resolution, accuracy)
            facets = looks[-1]
            if accuracy == ACCURACIES[0]:
                for name, ratio in simpler_plays(task, predicted, looks):
                    simpler.setdefault(name, []).append(max(ratio, 1 / ratio))
            predicted_mesh, own_mesh = (own.cell * cells + own.facet * count for count in (predicted.facets, facets))
            pairs = (
                (max(predicted.facets, FEW), max(facets, FEW)),
                (own_mesh, mesh),
                (predicted_mesh, mesh),
            )
            errors[accuracy].append([*(max(a / b, b / a) for a, b in pairs), predicted_mesh / mesh])
    print("ratio, median / p90 / worst:", file=OUT)
    for accuracy, rows in errors.items():
        for name, values in zip(("triangles", "mesh from true triangles", "mesh"), np.array(rows).T):
            print(f"  accuracy {accuracy:.1f} %  {name:26}{quantiles(values)}", file=OUT)
        bias = np.median(np.array(rows)[:, 3])
        print(f"  accuracy {accuracy:.1f} %  {'mesh, predicted / true':26}{bias:.2f}", file=OUT)
    print("time of a play from the predicted meshes over that from the true ones, median / worst:", file=OUT)
    for name, ratios in simpler.items():
        print(f"  {name:40}{np.median(ratios):.2f} / {max(ratios):.2f}", file=OUT)


def simpler_plays(task, predicted, looks):
    """Yield the names of the mesh's model and of simpler models, and their ratios of predicted to actual play time."""
    every = [legacy.BOX, *looks]
    true = float(np.add(every[1:], every[:-1]).mean() / 2)
    tool, stock = task.cutting
    last, mean = legacy._triangles(task.toolpath, tool, stock, predicted.resolution)
    with mock.patch.object(legacy_mesh, "bottom_rectangles", return_value=1):
        _, without_floor = legacy._triangles(task.toolpath, tool, stock, predicted.resolution)
    for name, facets in (
        ("as it is", mean),
        ("without the rectangles of the lower face", without_floor),
        ("without looking while it is cut", 0.75 * last),
        ("without any map, 2000 triangles", 2000.0),
    ):
        guess, truth = (
            DEFAULTS.redraw + legacy._mesh_seconds(DEFAULTS, predicted.cells, count) for count in (facets, true)
        )
        yield name, guess / truth


def really(commands, tool, stock, resolution, accuracy):
    """Cut with FreeCAD's simulator as its panel does.

    Return the time of the last mesh, s, the numbers of triangles at some moments, and the number of cells.
    """
    size = stock.upper - stock.lower
    sim = PathSim()
    sim.BeginSimulation(Part.makeBox(*size, FreeCAD.Vector(*stock.lower)), resolution)
    sim.SetToolShape(shape(tool), 0.05 * accuracy)
    top = float(stock.upper[2])
    moves = straight(commands, resolution, top)
    position = FreeCAD.Placement(FreeCAD.Vector(0, 0, top), FreeCAD.Rotation())
    looks, looked_at = [], {len(moves) * look // LOOKS for look in range(1, LOOKS)}
    for done, move in enumerate(moves, 1):
        position = sim.ApplyCommand(position, move)
        if done in looked_at:
            looks.append(sum(mesh.CountFacets for mesh in sim.GetResultMesh()))
    times = []
    for _ in range(2):
        begin = time.perf_counter()
        outer, inner = sim.GetResultMesh()
        times.append(time.perf_counter() - begin)
    cells = (int(size[0] / resolution) + 1) * (int(size[1] / resolution) + 1)
    looks.append(outer.CountFacets + inner.CountFacets)
    return min(times), looks, cells


def straight(commands, resolution, top):
    """Return the straight moves that PerformCutVoxel makes of commands, without commands on which it would hang."""
    at = {"X": 0.0, "Y": 0.0, "Z": top}
    made = []
    first_hole = True

    def go(name, **words):
        made.append(Command(name, words))
        at.update(words)

    for name, words in commands:
        there = {axis: words[axis] for axis in "XYZ" if axis in words}
        if name in ("G2", "G3") and not words.get("K"):
            i, j = words.get("I", 0.0), words.get("J", 0.0)
            x, y, radius = at["X"] + i, at["Y"] + j, math.hypot(i, j)
            end = at | there
            angle = math.atan2(at["Y"] - y, at["X"] - x)
            sweep = (math.atan2(end["Y"] - y, end["X"] - x) - angle) % (2 * math.pi)
            sweep = sweep if name == "G3" or not sweep else sweep - 2 * math.pi
            count = math.ceil(math.sqrt(radius / resolution * sweep**2))
            rise, z = (end["Z"] - at["Z"]) / max(count, 1), at["Z"]
            for k in range(1, count + 1):
                turn = angle + sweep * k / count
                go("G1", X=x + radius * math.cos(turn), Y=y + radius * math.sin(turn), Z=z + rise * k)
        elif name in ("G0", "G1"):
            go(name, **there)
        elif name in ("G81", "G82", "G83"):
            if first_hole:
                go("G0", Z=words["R"])
            go("G0", **there | {"Z": words["R"]})
            go("G1", Z=words["Z"])
            go("G1", Z=words["R"])
        first_hole = name not in ("G81", "G82", "G83")
    return made


if __name__ in ("__main__", "simulators"):  # FreeCAD imports the script as a module named `simulators`
    run_and_leave(main)
