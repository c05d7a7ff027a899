# SPDX-License-Identifier: LGPL-2.1-or-later
"""The results of a simulation as a table and in files, for operations with and without faults."""

from __future__ import annotations

import csv
import json
from dataclasses import replace

import numpy as np

from vkworkbench.core.zbuffer import Crash, CutFacts, Deviation, Plunge, Source, Verdict
from vkworkbench.language import Message, render
from vkworkbench.report import SimulationFacts


def fault(kind, command=None, **numbers):
    """Return a fault of the second operation, caused by a command or by no command."""
    source = command and Source(1, command, command)
    return kind(trajectory=command, source=source, place=(1.0, 2.0, 3.0), **numbers)


CLEAN = CutFacts(
    removed_volume=12_340.0, removed_volume_error=10.0, pixel=0.1, cutting_length=400.0, cutting_seconds=40.0, air_length=100.0, air_seconds=10.0,
    mean_rate=18_510.0, peak_rate=30_000.0, depth_of_cut=2.0, width_of_cut=3.0, tool_diameter=6.0,
    crashes=(), fast_plunges=(), gouges=(), left=(),
)  # fmt: skip
FAULTY = replace(
    CLEAN,
    crashes=(fault(Crash, 3, depth=2.0, volume=50.0), fault(Crash, 6, depth=1.0, volume=9.0)),
    fast_plunges=(fault(Plunge, 4, feed=5.0, allowed=2.0),),
    gouges=(fault(Deviation, 5, depth=0.25, area=1.0), fault(Deviation, 7, depth=0.75, area=1.0)),
    left=(fault(Deviation, depth=1.5, area=1.0), fault(Deviation, depth=0.5, area=1.0)),
)
FOUND = SimulationFacts(
    (("Fräsen", CLEAN), ("=Pocket", FAULTY)),
    FAULTY,
    (("Doc", "Face"), ("Doc", "Pocket")),
    ("f", "g"),
    {
        "cut": np.array([0, 1, 1]),
        "command": np.array([2, 7, 8]),
        "removed_volume": np.array([1.5, 2.5, 0.0]),
        "rate": np.array([90.0, np.nan, 0.0]),
    },
)


def read(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def test_simulation_table_has_lines_for_operations_and_the_job():
    header, clean, faulty, job, *_, verdict = str(FOUND).splitlines()
    assert header.split()[0] == "operation"
    # The operation "Fräsen" has no faults.
    assert clean.split() == ["Fräsen", "12.34", "0.01", "18.51", "30.00", "25%"]
    assert faulty.split() == ["=Pocket", "12.34", "0.01", "18.51", "30.00", "25%", "2", "1", "0.8", "mm", "1.5", "mm"]
    assert job.split() == ["job", *faulty.split()[1:]] and verdict == "Nothing is checked yet."


def test_simulation_remarks_are_below_the_table(tmp_path):
    told = replace(FOUND, remarks=(Message("of", label="Top\nface", sentence=Message("no-stock", label="Job")),))
    *table, remark = str(told).splitlines()
    assert table == str(FOUND).splitlines() and remark.startswith("Top face: ")
    told.to_json(tmp_path / "facts.json")
    assert json.loads((tmp_path / "facts.json").read_text(encoding="utf-8"))["remarks"] == [render(told.remarks[0])]


def test_faults_are_below_the_table_with_operation_and_command():
    lacks = fault(Deviation, depth=4.0, area=1.0)
    found = replace(FOUND, job=replace(FAULTY, gouges=(*FAULTY.gouges, lacks)))
    assert str(found).splitlines()[4:-1] == [
        "=Pocket, command 4: A rapid move removes 50 mm³.",
        "=Pocket, command 7: A rapid move removes 9 mm³.",
        "=Pocket, command 6: The tool cuts 0.25 mm into the model.",
        "=Pocket, command 8: The tool cuts 0.75 mm into the model.",
        "Stock: The stock is 4 mm too small for the model. Choose a larger stock, or move the model within it.",
        "=Pocket, command 5: The tool plunges into full material at 300 mm/min. Its limit is 120 mm/min.",
    ]
    of_program = replace(found, verdict=Verdict(lines=True))
    assert str(of_program).splitlines()[4] == "=Pocket, line 3: A rapid move removes 50 mm³."


def test_long_list_of_faults_ends_with_their_number():
    many = replace(FOUND, job=replace(FAULTY, crashes=FAULTY.crashes[:1] * 30))
    *_, last, more, _ = str(many).splitlines()
    assert (last, more) == (str(FOUND).splitlines()[4], "13 more faults; to_json writes all faults.")


def test_long_verdict_is_printed_whole_and_its_reason_once():
    reason = Message("of", label="Top face", sentence=Message("no-stock", label="Job " * 200))
    found = replace(FOUND, remarks=(reason,), verdict=Verdict(pixel=0.1, unread=(reason,)))
    text = str(found)
    assert text.endswith("Shank, holder and clamps were not checked.") and text.count("Top face") == 1


def test_depth_of_missing_stock_has_its_own_column(tmp_path):
    found = replace(FOUND, job=replace(FAULTY, gouges=(*FAULTY.gouges, fault(Deviation, depth=4.0, area=1.0))))
    header, _, faulty, job, *_ = str(found).splitlines()
    assert header.endswith("gouged    left  stock lacks")
    assert job.split()[-6:] == ["0.8", "mm", "1.5", "mm", "4.0", "mm"]
    assert faulty.split()[-2:] == ["1.5", "mm"]
    found.to_csv(tmp_path / "facts.csv")
    row = read(tmp_path / "facts.csv")[-1]
    assert (row["deepest_gouge"], row["stock_lacks"]) == ("0.75", "4.0")


def test_verdict_on_the_job_is_below_table_and_in_file(tmp_path):
    unchecked = (Source(1, 4, 4), Source(1, 9, 9))
    found = replace(FOUND, verdict=Verdict(pixel=0.125, met=True, crashes=2, unchecked=unchecked))
    text = (
        "2 rapids cut into material. Checked to 0.12 mm. 2 moves were not checked for lack of time, the first is "
        "command 5 of =Pocket. Shank, holder and clamps were not checked."
    )
    assert str(found).splitlines()[-1] == text
    found.to_json(tmp_path / "facts.json")
    data = json.loads((tmp_path / "facts.json").read_text(encoding="utf-8"))
    assert (data["verdict"], data["pixel"]) == (text, 0.125)
    assert data["unchecked"] == [{"label": "=Pocket", "command": 4}, {"label": "=Pocket", "command": 9}]


def test_repr_of_simulation_facts_is_one_line():
    assert repr(FOUND) == f"<SimulationFacts of {len(FOUND.operations)} operations>"
    assert repr(replace(FOUND, operations=FOUND.operations[:1])) == "<SimulationFacts of 1 operation>"


def test_table_columns_fit_widest_cell():
    found = replace(FOUND, operations=(("A long label " * 3, CLEAN), ("x" * 70, CLEAN)))
    header, long, longest, job, *_ = str(found).splitlines()
    assert longest.startswith("x" * 59 + "…  ") and long.startswith("A long label")
    assert header.index("removed, cm3") == 60 + 2
    for line in (long, longest, job):  # Numbers are aligned with the right end of their heading.
        assert line[: header.index("cm3") + 3].endswith("12.34")


def test_labels_cannot_break_the_table_or_the_terminal():
    assert (
        str(replace(FOUND, operations=(("Top\n\x1b[2Jface", CLEAN),), job=CLEAN))
        .splitlines()[1]
        .startswith("Top [2Jface  ")
    )


def test_simulation_facts_are_written_as_csv_and_json(tmp_path):
    FOUND.to_csv(tmp_path / "facts.csv")
    FOUND.to_json(tmp_path / "facts.json")
    clean, faulty, job = read(tmp_path / "facts.csv")
    assert (job["label"], job["verdict"], clean["verdict"]) == ("job", "Nothing is checked yet.", "")
    assert (clean["label"], clean["crashes"], clean["first_crash_command"]) == ("Fräsen", "0", "")
    assert (faulty["label"], faulty["crashes"], faulty["first_crash_command"]) == ("'=Pocket", "2", "3")
    assert (faulty["deepest_gouge"], faulty["most_left"]) == ("0.75", "1.5")
    text = (tmp_path / "facts.json").read_text(encoding="utf-8")
    assert json.loads(text) == FOUND.as_dict() and "Fräsen" in text
    assert [one["label"] for one in FOUND.as_dict()["operations"]] == ["Fräsen", "=Pocket"]


def test_file_of_trajectories_names_their_operations(tmp_path):
    FOUND.trajectories_to_csv(tmp_path / "trajectories.csv")
    rows = read(tmp_path / "trajectories.csv")
    assert [row["label"] for row in rows] == ["Fräsen", "'=Pocket", "'=Pocket"]
    assert [row["command"] for row in rows] == ["2", "7", "8"] and "cut" not in rows[0]
    assert [float(row["removed_volume"]) for row in rows] == [1.5, 2.5, 0.0]
    # With the text "nan", spreadsheets would read the column as text.
    assert [row["rate"] for row in rows] == ["90.0", "", "0.0"]
