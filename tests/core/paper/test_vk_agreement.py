# SPDX-License-Identifier: LGPL-2.1-or-later
"""Phi, level and reversals agree in the recognition, the Gauss map, the mark in the tree, the panel and the report."""

import csv
import gzip
import json
import re
from itertools import islice
from pathlib import Path

import numpy as np
import pytest

from vkworkbench.core import Strategy, linearize, machining, recognize, signature
from vkworkbench.core.paper.areas import monotonous_areas
from vkworkbench.core.paper.directions import farthest
from vkworkbench.core.paper.literal import paper_verdict
from vkworkbench.language import ENGLISH
from vkworkbench.report import OperationReport, Report

# Operations of FreeCAD that are not part of this repository. If the folder is missing, there are no such operations.
CORPUS = Path(__file__).resolve().parents[4] / "shared" / "corpus"
FILES = sorted(CORPUS.glob("freecad-*.jsonl.gz"))
NUMBER = re.compile(r"[+-]\d+\.\d\d|(?<![\d.])0(?![\d.%])")


def rows(count, *, step=2.0, length=40.0, sense=1):
    """Return the commands of a zigzag at one depth."""
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": -1.0, "F": 5.0})]
    for row in range(count):
        commands += [("G1", {"X": length if row % 2 == 0 else 0.0}), ("G1", {"Y": sense * step * (row + 1)})]
    return commands


def squares(count, *, sense=1, lifted=True, reverse=False):
    """Return nested square loops. With `reverse`, the tool moves back along a part of the first side of each loop."""
    commands = []
    for loop in range(count):
        a, b = 2.0 * loop, 60.0 - 2.0 * loop
        corners = [(a, a), (b, a), (b, b), (a, b), (a, a)][::sense]
        if lifted or not loop:
            commands += [("G0", {"Z": 5.0}), ("G0", {"X": a, "Y": a}), ("G1", {"Z": -1.0, "F": 5.0})]
        commands += [("G1", {"X": x, "Y": y}) for x, y in corners[0 if not lifted else 1 :]]
        if reverse:
            commands += [("G1", {"X": (a + b) / 2}), ("G1", {"X": a})]
    return commands


def bore(turns):
    commands = [("G0", {"X": 5.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": 0.0, "F": 5.0})]
    return commands + [("G2", {"X": 5.0, "Y": 0.0, "Z": -1.0 * k, "I": -5.0, "J": 0.0}) for k in range(1, turns + 1)]


def slot(passes):
    """Return passes back and forth on one line, each deeper than the pass before. Every turn is an exact reversal."""
    commands = [("G0", {"X": 0.0, "Y": 0.0, "Z": 5.0}), ("G1", {"Z": 0.0, "F": 5.0})]
    return commands + [("G1", {"X": 50.0 * (k % 2), "Z": -0.1 * k}) for k in range(1, passes + 1)]


OWN = {
    "zigzag": rows(12), "clockwise zigzag": rows(12, sense=-1), "nested loops": squares(8),
    "nested clockwise loops": squares(8, sense=-1), "linked loops": squares(8, lifted=False),
    "loops with reversals": squares(5, reverse=True), "bore": bore(7), "slot": slot(9), "one loop": squares(1),
    "one line": rows(1)[:3],
}  # fmt: skip


def of_corpus():
    """Yield the commands and the tool's diameter of every operation in the files."""
    for file in FILES:
        with gzip.open(file, "rt") as lines:
            for line in lines:
                record = json.loads(line)
                yield record["commands"], record["tool_diameter"]


def report(path, found):
    """Return a report with one operation, as an analysis returns it, but without simulation costs."""
    unknown = dict.fromkeys(OperationReport.__dataclass_fields__)
    known = {"document": "D", "name": "Operation", "label": "Operation", "counted": True, "recognition": found,
             "trajectories": len(path), "machining": machining(path)}  # fmt: skip
    for name, field in OperationReport.__dataclass_fields__.items():
        if field.type.startswith("tuple"):
            unknown[name] = ()
        elif field.type.startswith(("dict", "Mapping")):
            unknown[name] = {}
    return Report((OperationReport(**{**unknown, **known}),), {}, {})


def check(commands, diameter, file):
    path = linearize([(name, words) for name, words in commands])
    found, areas = recognize(path, tool_diameter=diameter), monotonous_areas(path)
    if found.strategy in (Strategy.EMPTY, Strategy.DRILLING):
        return False
    told = found.phi_range, found.level, found.reversals
    # The Gauss map shows the signature of the whole operation and of each area.
    assert (areas.phi_range, areas.top_level, len(areas.reversals)) == told
    each = [areas.signature(area) for area in range(len(areas.start))]
    low, high = min(s.phi_range[0] for s in each), max(s.phi_range[1] for s in each)
    assert ((low, high), sum(len(s.reversals) for s in each)) == (found.phi_range, found.reversals)
    assert found.level in {s.top_level for s in each}
    assert found.paper == paper_verdict(areas)
    # The mark in the tree, its tooltip and the panel show the reason.
    if found.reason.startswith("Phi "):
        shown = [ENGLISH.turns(phi) for phi in found.phi_range]
        numbers = NUMBER.findall(found.reason.partition(" turns")[0])
        assert numbers in (shown, [ENGLISH.turns(farthest(found.phi_range))], ["0"]), found.reason
        assert numbers != ["0"] or shown == ["0", "0"]
    report(path, found).to_csv(file)
    with open(file, newline="", encoding="utf-8") as lines:
        (row,) = csv.DictReader(lines)
    assert (float(row["phi_low"]), float(row["phi_high"])) == found.phi_range
    assert (int(row["level"]), int(row["reversals"])) == (found.level, found.reversals)
    assert np.hypot(float(row["v_x"]), float(row["v_y"])) == each[found.paper.area].length[-1]
    return True


@pytest.mark.parametrize("name", OWN)
def test_signature_of_a_path_agrees_wherever_it_is_shown(name, tmp_path):
    assert check(OWN[name], 6.0, tmp_path / "report.csv")


@pytest.mark.long
@pytest.mark.skipif(not FILES, reason="the corpus of FreeCAD's operations is not beside this repository")
def test_signature_of_freecad_operations_agrees_where_shown(tmp_path):
    assert sum(check(*one, tmp_path / "report.csv") for one in islice(of_corpus(), 0, None, 10)) >= 50


def test_signature_of_an_area_equals_the_one_of_its_points():
    for commands in OWN.values():
        areas = monotonous_areas(linearize(commands))
        for area in range(len(areas.start)):
            of_area = areas.signature(area)
            of_points = signature(of_area.vertices)
            assert of_area.phi == pytest.approx(of_points.phi, abs=1e-9)
            assert (of_area.level == of_points.level).all()
            assert of_area.reversals.tolist() == of_points.reversals.tolist()
            assert of_area.closed == of_points.closed
            if of_area.closed or commands is not OWN["linked loops"]:
                assert of_area.total_turning == pytest.approx(of_points.total_turning, abs=1e-9)


def test_phi_of_eight_linked_loops_reaches_eight_full_turns():
    areas = monotonous_areas(linearize(OWN["linked loops"]))
    assert len(areas.start) == 1 and not areas.closed[0]
    assert areas.phi_range == pytest.approx((0.0, 8 * 2 * np.pi)) and areas.top_level == 8


def test_signatures_of_areas_share_memory():
    areas = monotonous_areas(linearize(squares(4)))
    one = areas.signature(1)
    assert all(np.shares_memory(ours, whole) for ours, whole in ((one.alpha, areas.alpha), (one.phi, areas.phi)))


def test_strategy_and_numbers_by_the_papers_rule_are_as_expected():
    path = {name: linearize(commands) for name, commands in OWN.items()}
    verdicts = {name: recognize(p, tool_diameter=6.0).paper for name, p in path.items()}
    assert verdicts["zigzag"].strategy is Strategy.ZIGZAG and verdicts["zigzag"].sense is None
    assert verdicts["zigzag"].level == 0 and verdicts["zigzag"].v == pytest.approx((0.0, 24.0))
    assert verdicts["zigzag"].image == pytest.approx((0.0, 1.0))
    linked = verdicts["linked loops"]
    assert linked.strategy is Strategy.CONTOUR_PARALLEL and linked.level >= 7
    assert verdicts["bore"].strategy is Strategy.CONTOUR_PARALLEL and verdicts["bore"].level == -6
    # A single loop is unknown by the rule: its phi ends before 2 pi, because phi does not include the turn from the
    # last side to the first side.
    assert verdicts["one loop"].strategy is Strategy.UNKNOWN
    assert verdicts["one loop"].phi_range == pytest.approx((0.0, 1.5 * np.pi))
    # V_k is the vector from the first corner of the square to the corner k. The direction of V_k turns by a quarter
    # turn in total, in one sense.
    assert verdicts["one loop"].sense == "ccw"
    assert verdicts["one loop"].theta_range == pytest.approx((0.0, np.pi / 2))


@pytest.mark.sources
def test_directions_and_turns_are_computed_in_one_file():
    core = Path(__file__).resolve().parents[3] / "vkworkbench" / "core"
    sources = {path: path.read_text() for path in core.rglob("*.py")}
    # Other files use arctan2 only for angles around the centres of arcs and around the axis of a drawn tool.
    arcs = {"arcs.py", "legacy_cautions.py", "tool_picture.py"}
    assert {path.name for path, text in sources.items() if "arctan2" in text} <= {"directions.py", *arcs}
    wrapped = {path.name for path, text in sources.items() if re.search(r"rint\([^\n]*TURN|def wrap\b", text)}
    assert wrapped == {"directions.py"}
