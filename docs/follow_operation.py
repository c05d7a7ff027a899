# SPDX-License-Identifier: LGPL-2.1-or-later
"""Print what each step of an analysis computes for one small pocket.

    python3 docs/follow_operation.py STEP

STEP is one of: commands, toolpath, areas, pieces, rules, measures, votes, verdict, row.
docs/pipeline.md shows the output of every step.
"""

from __future__ import annotations

import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import vkworkbench
from vkworkbench.core import recognize
from vkworkbench.core.gcode import read_program
from vkworkbench.core.paper import monotonous_areas, paper_verdict
from vkworkbench.core.recognition.patterns.pieces import LOOP, STROKE, WINDING, ZIGZAG
from vkworkbench.core.recognition.patterns.section import Section
from vkworkbench.core.recognition.verdict.decide import STRATEGIES, features
from vkworkbench.core.recognition.verdict.measures import measure_section
from vkworkbench.core.recognition.verdict.model import shipped_model
from vkworkbench.core.recognition.verdict.rules import judge_section
from vkworkbench.language import render

KINDS = {LOOP: "loop", WINDING: "winding", ZIGZAG: "zigzag", STROKE: "stroke"}
TOOL_DIAMETER = 6.0  # mm
PROGRAM = """\
G21 G90
(T1 D=6 flat end mill)
T1 M6
G0 Z5
G0 X14 Y14
G1 Z-2 F120
G1 X26 F600
G1 Y20
G1 X14
G1 Y14
G1 X11 Y11
G1 X29
G1 Y23
G1 X11
G1 Y11
G1 X8 Y8
G1 X32
G1 Y26
G1 X8
G1 Y8
G0 Z5
M30
"""


def print_commands() -> None:
    """Print the NC program as commands of FreeCAD."""
    for name, parameters in read_program(PROGRAM).commands:
        print(f"{name:4}", " ".join(f"{letter}{value:g}" for letter, value in parameters.items()))


def print_toolpath() -> None:
    """Print the trajectories, one in each line."""
    toolpath = read_program(PROGRAM).toolpath()
    print("from (mm)             to (mm)               line  kind")
    for number in range(len(toolpath)):
        begin, end = toolpath.points[number], toolpath.points[number + 1]
        kind = "rapid" if toolpath.rapid[number] else f"cutting at {toolpath.feed[number]:g} mm/s"
        print(f"{_place(begin)}  {_place(end)}  {toolpath.command[number]:4}  {kind}")


def print_areas() -> None:
    """Print alpha, turning and phi of each move, and the strategy by the paper's rule."""
    areas = monotonous_areas(read_program(PROGRAM).toolpath())
    print(f"areas: {len(areas.start)}, moves: {len(areas)}")
    print("move  length/mm  alpha/deg  turning/deg  phi/deg")
    for number in range(len(areas)):
        alpha, turning, phi = np.degrees([areas.alpha[number], areas.turning[number], areas.phi[number]])
        print(f"{number:4}  {areas.length[number]:9.2f}  {alpha:9.0f}  {turning:11.0f}  {phi:7.0f}")
    paper = paper_verdict(areas)
    print(f"the paper's literal rule: {paper.strategy.value if paper.strategy else 'open'}")


def print_pieces() -> None:
    """Print the pieces of the areas, and the share of nested rings."""
    section = _section()
    pieces = section.pieces
    print("piece  kind     moves  length/mm")
    for number in range(len(pieces)):
        count = pieces.end[number] - pieces.start[number]
        print(f"{number:5}  {KINDS[pieces.kind[number]]:8} {count:5}  {pieces.length[number]:9.2f}")
    print(f"share of the length in nested rings: {section.share(section.rings.nested):.2f}")


def print_rules() -> None:
    """Print the strategy that the rules propose."""
    verdict = judge_section(_section())
    print(f"strategy: {verdict.strategy.value}\nreason: {render(verdict.seen)}")


def print_measures() -> None:
    """Print the first of the measures that describe the section."""
    measures = measure_section(_section())
    print(f"{len(measures)} measures, among them:")
    for name in list(measures)[:8]:
        print(f"{name:12} {measures[name]:6.3f}")


def print_votes() -> None:
    """Print the shares of the trees' votes, the largest first."""
    section = _section()
    paper = paper_verdict(section.moves)
    known = features(measure_section(section), judge_section(section).strategy, paper.strategy, tool=section.tool > 0)
    nonsense, votes = shipped_model().vote(known)
    for number in np.argsort(-votes, kind="stable")[:4]:
        print(f"{STRATEGIES[number].value:18} {votes[number]:.2f}")
    print(f"machines nothing   {nonsense:.2f}")


def print_verdict() -> None:
    """Print the recognised strategy."""
    recognition = recognize(read_program(PROGRAM).toolpath(), tool_diameter=TOOL_DIAMETER)
    print(f"strategy: {recognition.strategy.value}\nconfidence: {recognition.confidence:.2f}")
    print(f"reason: {recognition.reason}")
    print(f"stepover: {recognition.stepover:.2f} mm, depths: {recognition.depths}, level: {recognition.level}")


def print_row() -> None:
    """Print a part of the report's row, without the simulators' times, which depend on the computer."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "pocket.nc")
        file.write_text(PROGRAM, encoding="utf-8")
        operation = vkworkbench.analyze(str(file)).operations[0]
    print(f"trajectories: {operation.trajectories}\ncutting length: {operation.machining.cutting_length:.1f} mm")
    print(f"time of the cuts: {operation.machining.cutting_seconds:.1f} s")
    for remark in operation.remarks:
        print(f"remark: {render(remark)}")


def _section() -> Section:
    return Section(monotonous_areas(read_program(PROGRAM).toolpath()), TOOL_DIAMETER)


def _place(point: np.ndarray) -> str:
    return "(" + ", ".join(f"{value:5.1f}" for value in point) + ")"


STEPS = {
    "commands": print_commands,
    "toolpath": print_toolpath,
    "areas": print_areas,
    "pieces": print_pieces,
    "rules": print_rules,
    "measures": print_measures,
    "votes": print_votes,
    "verdict": print_verdict,
    "row": print_row,
}

if __name__ == "__main__":
    if sys.argv[1:] and sys.argv[1] in STEPS:
        STEPS[sys.argv[1]]()
    else:
        sys.exit(__doc__)
