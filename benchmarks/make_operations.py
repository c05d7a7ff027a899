# SPDX-License-Identifier: LGPL-2.1-or-later
"""Make operations of every kind on the parts of shapes.py in this FreeCAD, as test data for recognition.py.

    VKWORKBENCH_OPERATIONS=OUT.jsonl.gz freecadcmd $PWD/benchmarks/make_operations.py

The script writes one JSON record per line, in the form of records.py. The labelled strategy is determined by the
operation's class and pattern, never by its path. Tools, steps, angles, sides and starts are random with a fixed seed.
Operations that fail in FreeCAD or remain empty are counted by name. 3D Surface and Waterline need OpenCAMLib.
"""

from __future__ import annotations

import collections
import gzip
import json
import os
import random
import signal
import sys
import time
from pathlib import Path

import FreeCAD

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "examples"), str(HERE.parent / "tests"), str(HERE.parent)]
from inside_freecad import run_and_leave
from make_example import cam, operation, tool_controller
from shapes import HEIGHT, SHAPES

from vkworkbench import freecad

VERSION = ".".join(map(str, freecad.version()))
PATTERN = freecad.POCKET_PATTERN.name
PATTERNS = ("ZigZag", "Offset", "ZigZagOffset", "Line", "Grid")
PATIENCE = 30  # time limit for an operation, s, because some operations never end
SCULPTURED = ("saddle", "ripple", "ball", "twisted")

# Strategies that count as right, the operation's own strategy first. FreeCAD's Line pattern cuts back and forth.
# ZigZagOffset is a zigzag followed by a contour along the walls. In narrow areas, Offset is a single loop. Outside the
# part, where the stock is thin, Adaptive is a contour.
TRUTH = {
    "ZigZag": "zigzag", "Line": "zigzag", "Offset": "contour-parallel profile", "ZigZagOffset": "zigzag",
    "Grid": "zigzag one-way mixed",
    "Profile": "profile", "Profile:Passes": "profile contour-parallel", "Adaptive:Inside": "adaptive",
    "Adaptive:Outside": "adaptive profile", "Helix": "helix", "ThreadMilling": "helix", "Drilling": "drilling",
    "Slot:Line": "profile one-way", "Slot:ZigZag": "profile zigzag", "Engrave": "profile engraving",
    "Deburr": "profile engraving", "Vcarve": "engraving",
    "Surface:Line": "one-way", "Surface:ZigZag": "zigzag", "Surface:Circular": "contour-parallel",
    "Surface:CircularZigZag": "zigzag", "Surface:Offset": "contour-parallel", "Surface:Spiral": "spiral",
    "Waterline": "waterline",
}  # fmt: skip


class Part:
    """A job on one part. The class creates one operation after another and keeps only their records."""

    def __init__(self, name, out, counts):
        self.name, self.out, self.counts = name, out, counts
        self.random = random.Random(name)
        self.document = FreeCAD.newDocument(name)
        self.model = self.document.addObject("Part::Feature", "Part")
        self.model.Shape = self.shape = SHAPES[name]()
        self.job = cam("Main.Job").Create("Job", [self.model])
        allowance = self.random.choice((0.5, 2, 4))
        for side in ("Xneg", "Xpos", "Yneg", "Ypos", "Zpos"):
            setattr(self.job.Stock, "Ext" + side, allowance)
        self.job.Stock.ExtZneg = 0
        self.document.recompute()
        self.controllers = {}

    def controller(self, shape, diameter):
        """Return the tool controller for a tool with the given shape and diameter."""
        if (shape, diameter) not in self.controllers:
            number = len(self.controllers) + 2
            self.controllers[shape, diameter] = tool_controller(self.document, number, "Tool", shape, diameter, 600)
        return self.controllers[shape, diameter]

    def names(self):
        """Return the names of all objects in the document."""
        return {obj.Name for obj in self.document.Objects}

    def make(self, kind, label, truth, base, diameter, tool="endmill.fcstd", **properties):
        """Make an operation of `kind`, write its record, and remove the operation from the document."""
        controller = self.controller(tool, diameter)
        self.job.Tools.Group = [controller]  # FreeCAD would ask the user to choose among several controllers
        before = self.names()
        signal.alarm(PATIENCE)
        try:
            op = operation(self.job, kind, "Op", controller, base, **properties)
            commands = [[command.Name, _rounded(command.Parameters)] for command in op.Path.Commands]
            failed = not any(name in _CUTTING for name, _ in commands) and "empty"
        except Exception as error:  # FreeCAD raises many kinds of errors, which are counted by name
            failed = f"{type(error).__name__}: {error}"
        signal.alarm(0)
        self.counts[label, failed or "made"] += 1
        if not failed:
            strategy, *others = TRUTH[truth].split()
            box = self.job.Stock.Shape.BoundBox
            record = {
                "id": f"{VERSION}:{self.name}:{label}:{sum(self.counts.values())}", "source": f"FreeCAD {VERSION}",
                "label": label, "strategy": strategy, "accept": [strategy, *others], "tool_diameter": diameter,
                "stock": [box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax], "params": properties,
                "commands": commands,
            }  # fmt: skip
            self.out.write(json.dumps(record) + "\n")
        self.job.Operations.Group = []
        for name in self.names() - before:
            if self.document.getObject(name):  # FreeCAD removes some objects together with other objects
                self.document.removeObject(name)

    def mill(self):
        """Make every operation of 2.5D milling that the part's faces allow."""
        names = dict(_named(self.shape.Faces, "Face"))
        flat = {
            name: face for name, face in names.items()
            if face.Surface.TypeId == "Part::GeomPlane" and face.normalAt(0, 0).z > 0.9
        }  # fmt: skip
        floors = [name for name, face in flat.items() if 0.1 < face.BoundBox.ZMin < HEIGHT - 0.1 and face.Area > 50]
        top = max(flat, key=lambda name: flat[name].BoundBox.ZMin)
        self.areas(floors, top)
        self.profiles(floors)
        if floors:
            self.adaptive(floors)
        self.holes([name for name, face in names.items()
                    if face.Surface.TypeId == "Part::GeomCylinder" and len(face.Wires[0].Edges) == 3])  # fmt: skip
        self.strokes(floors)

    def areas(self, floors, top):
        """Make pockets of all floors and of one floor, and mill the top face, in every pattern."""
        choice = self.random.choice

        def clearing(pattern):
            return {
                PATTERN: pattern, "StepOver": self.random.randint(15, 90), "StepDown": choice((2, 4, 50)),
                "CutMode": choice(("Climb", "Conventional")), "StartAt": choice(("Center", "Edge")),
                "ZigZagAngle": choice((0, 12, 30, 45, 77, 90, 135)), "KeepToolDown": choice((True, False)),
            }  # fmt: skip

        for pattern in PATTERNS:
            for base in (floors, [choice(floors)]) if floors else ():
                self.make(
                    "PocketShape", "Pocket:" + pattern, pattern, base, choice((3, 4, 5, 6, 8)), **clearing(pattern)
                )
            self.make(
                "MillFace",
                "MillFace:" + pattern,
                pattern,
                [top],
                choice((6, 8, 10, 12)),
                BoundaryShape=choice(("Stock", "Perimeter", "Boundbox")),
                **clearing(pattern),
            )
        if floors:
            pattern = choice(PATTERNS)
            self.make("Pocket", "Pocket3D:" + pattern, pattern, floors[:1], choice((4, 6)), **clearing(pattern))

    def profiles(self, floors):
        """Make profiles of one floor, inside and outside, and of the whole part."""
        choice = self.random.choice

        def profile(truth, base, diameter, **properties):
            self.make(
                "Profile",
                "Profile",
                truth,
                base,
                diameter,
                Direction=choice(("CW", "CCW")),
                OffsetExtra=choice((0, 0.4)),
                StepDown=choice((2, 5, 50)),
                UseComp=choice((True, True, False)),
                JoinType=choice(("Round", "Square", "Miter")),
                **properties,
            )

        for side in ("Inside", "Outside") if floors else ():
            profile("Profile", [choice(floors)], choice((3, 5, 8)), Side=side)
        profile("Profile", (), choice((3, 6, 10)))
        if VERSION >= "1.1":
            profile("Profile:Passes", (), 6, NumPasses=3, Stepover=2)

    def adaptive(self, floors):
        """Make adaptive clearing and adaptive profiling operations on both sides."""
        choice = self.random.choice
        for what in ("Clearing", "Profiling"):
            for side in ("Inside", "Outside"):
                self.make(
                    "Adaptive",
                    f"Adaptive:{what}:{side}",
                    "Adaptive:" + side,
                    [choice(floors)],
                    choice((5, 6, 8)),
                    OperationType=what,
                    Side=side,
                    StepOver=choice((20, 30, 40)),
                    StepDown=choice((8, 50)),
                    Tolerance=0.15,
                    FinishingProfile=choice((True, False)),
                )

    def holes(self, holes):
        """Make helix, drilling and thread milling operations in the round holes."""
        choice, radius = self.random.choice, {name: self.shape.getElement(name).Surface.Radius for name in holes}
        bores, drilled = [n for n in holes if radius[n] > 3], [n for n in holes if radius[n] < 8]
        for base in ([choice(bores)], bores) if bores else ():
            self.make("Helix", "Helix", "Helix", base, 3, StepDown=choice((1, 2.5)), StepOver=choice((30, 60)))
            diameter = 2 * radius[base[0]]
            self.make(
                "ThreadMilling",
                "ThreadMilling",
                "ThreadMilling",
                base[:1],
                3,
                "thread-mill.fcstd",
                ThreadType="CustomInternal",
                MajorDiameter=diameter + 0.8,
                MinorDiameter=diameter,
                Pitch=1.25,
                Passes=choice((1, 3)),
                LeadInOut=choice((True, False)),
            )
        for pecks in (False, True) if drilled else ():
            self.make("Drilling", "Drilling", "Drilling", drilled, 3, "drill.fcstd", PeckEnabled=pecks, PeckDepth=3)

    def strokes(self, floors):
        """Make slots, engraved edges, chamfered edges and a carved floor."""
        choice, edges = self.random.choice, dict(_named(self.shape.Edges, "Edge"))
        top = [name for name, edge in edges.items() if edge.BoundBox.ZMin > HEIGHT - 0.1]
        straight = [name for name in top if edges[name].Curve.TypeId == "Part::GeomLine" and edges[name].Length > 12]
        for pattern in ("Line", "ZigZag") if straight else ():
            self.make(
                "Slot",
                "Slot:" + pattern,
                "Slot:" + pattern,
                [choice(straight)],
                4,
                CutPattern=pattern,
                LayerMode=choice(("Single-pass", "Multi-pass")),
                StepDown=1.5,
                FinalDepth=14,
            )
        self.make(
            "Engrave", "Engrave", "Engrave", top, 3, StepDown=choice((0.5, 1)), StartDepth=HEIGHT, FinalDepth=HEIGHT - 1
        )
        self.make(
            "Deburr",
            "Deburr",
            "Deburr",
            top,
            6,
            "chamfer.fcstd",
            Width=0.5,
            ExtraDepth=0.3,
            Direction=choice(("CW", "CCW")),
        )
        if floors:
            self.make("Vcarve", "Vcarve", "Vcarve", [choice(floors)], 10, "v-bit.fcstd", StartDepth=HEIGHT)

    def sculpture(self):
        """Make rasters, rings, spirals and waterlines over the whole part."""
        choice = self.random.choice
        for pattern in ("Line", "ZigZag", "Circular", "CircularZigZag", "Offset", "Spiral"):
            for _ in range(2):
                self.make(
                    "Surface",
                    "Surface:" + pattern,
                    "Surface:" + pattern,
                    (),
                    choice((5, 6, 8)),
                    "ballend.fcstd",
                    CutPattern=pattern,
                    StepOver=self.random.randint(25, 80),
                    SampleInterval=2,
                    CutPatternAngle=choice((0, 30, 45, 90)),
                    CutMode=choice(("Climb", "Conventional")),
                    BoundBox=choice(("Stock", "BaseBoundBox")),
                    OptimizeLinearPaths=choice((True, False)),
                    CutPatternReversed=choice((True, False)),
                    LinearDeflection=0.05,
                    AngularDeflection=0.3,
                )
        for _ in range(2):
            self.make(
                "Waterline",
                "Waterline",
                "Waterline",
                (),
                choice((4, 6)),
                "ballend.fcstd",
                Algorithm="OCL Dropcutter",
                LayerMode="Multi-pass",
                StepDown=choice((1, 2)),
                SampleInterval=1,
                BoundBox="BaseBoundBox",
                LinearDeflection=0.05,
                AngularDeflection=0.3,
            )


_CUTTING = {"G1", "G2", "G3", "G01", "G02", "G03", "G73", "G81", "G82", "G83"}


def _rounded(words):
    """Return the words of a command rounded to six decimals, as they are stored in a file."""
    return {word: round(value, 6) for word, value in words.items()}


def _named(elements, kind):
    """Return pairs (name, element), in which FreeCAD's name is the kind and a number from 1, for example "Face1"."""
    return ((f"{kind}{number}", element) for number, element in enumerate(elements, 1))


def give_up(*_):
    raise TimeoutError(f"not done in {PATIENCE} s")


def has_opencamlib():
    """Return whether this FreeCAD has OpenCAMLib, which 3D Surface and Waterline need."""
    for name in ("ocl", "opencamlib"):
        try:
            __import__(name)
            return True
        except ImportError:
            pass
    return False


def main() -> int:
    signal.signal(signal.SIGALRM, give_up)
    began, counts, out = time.monotonic(), collections.Counter(), os.environ["VKWORKBENCH_OPERATIONS"]
    surfaces = has_opencamlib()
    if not surfaces:
        print("NO 3D SURFACE AND WATERLINE: OpenCAMLib is not installed")
    with gzip.open(out, "wt") as file:
        for name in SHAPES:
            if name in SCULPTURED and not surfaces:
                continue
            part = Part(name, file, counts)
            if name in SCULPTURED:
                part.sculpture()
            else:
                part.mill()
            FreeCAD.closeDocument(part.document.Name)
    for (label, result), count in sorted(counts.items()):
        if result != "made":
            print(f"{count:4d} {label}: {result}")
    made = sum(count for (_, result), count in counts.items() if result == "made")
    print(f"FreeCAD {VERSION}: {made} of {sum(counts.values())} operations in {time.monotonic() - began:.0f} s: {out}")
    return 0


run_and_leave(main)
