# SPDX-License-Identifier: LGPL-2.1-or-later
"""The totals and the table of a report on several operations."""

from __future__ import annotations

import csv
import json
import re
from dataclasses import replace
from types import SimpleNamespace

import pytest

from vkworkbench.core import MACHINES, Machining, Span, Strategy
from vkworkbench.core.zbuffer import Verdict
from vkworkbench.language import Message
from vkworkbench.report import JobVerdict, Report, Setup, SimulationFacts, compare_with_sum, setup_of, without_results
from vkworkbench.report.table import table_of
from vkworkbench.report.text_table import printable

KNOWN = Machining(100.0, 20.0, -1.0, 1.0, 10.0, 2.0, ())
PARTLY = replace(KNOWN, rapid_seconds=None, left_out=(Message("rapids-not-told", length=20.0),))
JOB = "Doc", "Job"
FIRST, SECOND, JOINT = object(), object(), object()  # three placeholders for simulation results


def operation(label, machining=KNOWN, **other):
    """Return an operation with a machining time, without a strategy or a cost."""
    document, job = JOB
    row = without_results(
        Message("no-tool"), document=document, name=label, label=label, job=job, counted=True, fingerprint=""
    )
    return replace(row, trajectories=5, machining=machining, **other)


def report(*operations, **other):
    return Report(operations, {JOB: "Part"}, {"memory_bytes": 1e9, "seconds": 600.0}, **other)


def lines(shown):
    """Return the lines of a printed table without the lines of dashes: header, operations, totals."""
    return [line for line in str(shown).splitlines() if not line.startswith("---")]


def test_repr_of_a_report_is_one_line():
    told = report(operation("One"), operation("Two\n3"))
    assert repr(told) == "<Report of 2 operations>"
    assert repr(told.operations[1]) == str(told.operations[1]) == "<OperationReport of Two 3: unknown>"
    assert repr(told.totals[0]) == "<Total of Part: 2 operations>"


def test_report_iterates_over_its_operations():
    one, two = operation("One"), operation("Two", counted=False)
    told = report(one, two)
    assert list(told) == [one, two] and len(told) == 2 and one in told
    assert not report()


MILL = replace(MACHINES["small-mill"], tool_change=60.0, spindle_start=3.0, factor=2.0)


@pytest.mark.parametrize("tools, seconds", [
    (["T1"], 6), (["T1", "T1"], 6), (["T1", "T2"], 132), (["T1", "T2", "T1"], 258), (["T1", "", "T1"], 6), ([""], 0),
])  # fmt: skip
def test_tool_changes_are_in_the_total_time(tools, seconds):
    found = report(*(operation(str(n), setup=setup_of(tool, MILL)) for n, tool in enumerate(tools)), fixtures={JOB: 2})
    (total,) = found.totals
    assert total.setup == Setup("", True, 2 * seconds)
    assert (
        total.machining_seconds == 2 * (12 * len(tools) + seconds) and total.as_dict()["setup_seconds"] == 2 * seconds
    )


def test_tool_changes_take_no_time_without_a_machine():
    (total,) = report(*(operation(tool, setup=setup_of(tool, None)) for tool in ("T1", "T2"))).totals
    assert total.setup == Setup() and total.machining_seconds == 24


def test_total_is_the_sum_of_the_counted_operations():
    (total,) = report(operation("One"), operation("Two"), operation("Dressed", counted=False)).totals
    assert (total.operations, total.trajectories, total.length, total.machining_seconds) == (2, 10, 200.0, 24.0)


@pytest.mark.parametrize("second, complete", [(KNOWN, True), (PARTLY, False)])
def test_total_time_is_complete_if_all_times_are_complete(second, complete):
    told = report(operation("One"), operation("Two", second))
    (total,) = told.totals
    assert total.machining_complete is complete
    assert (" >= " in lines(told)[-1]) is not complete
    assert " >= " not in lines(told)[1]


def test_job_time_is_multiplied_by_its_fixtures():
    once, thrice = report(operation("One")), report(operation("One"), fixtures={JOB: 3})
    assert (once.totals[0].machining_seconds, thrice.totals[0].machining_seconds) == (12.0, 36.0)
    assert once.totals[0].length == thrice.totals[0].length


@pytest.mark.parametrize(
    "other, incomplete", [({}, True), ({"trajectories": 0}, False), ({"strategy": Strategy.EMPTY}, False)]
)
def test_total_is_incomplete_without_a_cutting_cost(other, incomplete):
    strategy = other.pop("strategy", Strategy.UNKNOWN)
    row = operation("One")
    row = replace(row, recognition=replace(row.recognition, strategy=strategy), **other)
    assert report(row).totals[0].incomplete is incomplete


def test_facts_of_a_job_need_all_its_cutting_operations():
    told = report(operation("One"), operation("Two"), replace(operation("Stop"), trajectories=0))
    both = SimulationFacts(
        (("One", FIRST), ("Two", SECOND)), JOINT, (("Doc", "One"), ("Doc", "Two")), ("", ""), trajectories={}
    )
    whole = told.with_facts(both)
    assert [row.simulated for row in whole.operations] == [FIRST, SECOND, None] and whole.totals[0].simulated is JOINT
    one = replace(both, operations=both.operations[:1], names=both.names[:1], fingerprints=both.fingerprints[:1])
    partly = told.with_facts(one)
    assert [row.simulated for row in partly.operations] == [FIRST, None, None] and partly.totals[0].simulated is None


def test_verdict_on_a_job_is_in_table_and_files(tmp_path):
    """An operation that was left out does not prevent the verdict on the job, which names the operation."""
    told = report(operation("One"), operation("Two"))
    one = SimulationFacts(
        (("One", None),), None, (("Doc", "One"),), ("",), {}, left_out=(("Doc", "Two"),), valid_for="x"
    )
    whole = told.with_facts(one)
    assert whole.verdicts == {JOB: JobVerdict(one.sentence, "x")}
    assert lines(whole)[-1] == "Part: Nothing is checked yet."
    whole.to_csv(tmp_path / "report.csv")
    whole.to_json(tmp_path / "report.json")
    with open(tmp_path / "report.csv", newline="", encoding="utf-8") as file:
        assert [row["verdict"] for row in csv.DictReader(file)] == ["Nothing is checked yet."] * 2
    data = json.loads((tmp_path / "report.json").read_text(encoding="utf-8"))
    assert data["totals"][0]["verdict"] == "Nothing is checked yet."
    assert told.with_facts(replace(one, left_out=())).verdicts == {}


def test_verdict_on_a_job_is_not_sound_if_outdated():
    sound = JobVerdict(Verdict(pixel=0.1).message(()), "x")
    assert sound.is_sound and not replace(sound, outdated=True).is_sound
    assert "outdated" in str(replace(sound, outdated=True)) and "No collision" in str(sound)
    unread = Verdict(pixel=0.1, unread=(Message("no-tool"),))
    assert not JobVerdict(unread.message(()), "x").is_sound


def test_table_row_of_a_job_names_its_fixtures():
    assert "1 operation x3 " in lines(report(operation("One"), fixtures={JOB: 3}))[-1]
    assert " x" not in lines(report(operation("One")))[-1]


def test_total_without_costs_shows_question_marks():
    told = report(operation("One"))
    (total,) = told.totals
    assert (total.seconds, total.memory_bytes, total.incomplete) == (0, 0, True)
    assert lines(told)[-1].split()[-2:] == ["?", "?"]


def test_table_row_ends_with_the_chosen_simulators_cost():
    cost = SimpleNamespace(seconds=7.0, memory_bytes=3e6, factor=1.0)
    row = operation("One", costs={"legacy": cost}, remarks=())
    assert table_of([row], [], "legacy").splitlines()[-1].split()[-4:] == ["7.0", "s", "3.0", "MB"]
    assert table_of([row], [], "z-buffer").splitlines()[-1].split()[-2:] == ["?", "?"]


@pytest.mark.parametrize("seconds, code", [
    (20.0, "more-than-sum"), (5.0, "less-than-sum"), (10.5, None), (9.5, None), (None, None),
])  # fmt: skip
def test_difference_between_total_cost_and_sum_has_a_reason(seconds, code):
    def costs(seconds):
        return {} if seconds is None else {"legacy": SimpleNamespace(seconds=seconds, memory_bytes=0.0, factor=1.0)}

    (total,) = report(operation("One")).totals
    parts = [operation("One", costs=costs(4.0)), operation("Two", costs=costs(6.0)), operation("Three")]
    found = compare_with_sum(replace(total, costs=costs(seconds)), parts, "legacy")
    assert (found and found.code) == code


def test_table_says_why_a_total_differs_from_the_sum():
    one, two, base = (operation(name, setup=setup_of(name, MILL)) for name in ("T1", "T2", "T3"))
    text = str(report(one, two, replace(base, counted=False)))
    assert "\nRows in brackets are not included in the totals" in text and "\n(T3) " in text
    assert text.endswith("\nPart: More than the sum: tool changes and starts of the spindle take 2:12.")
    assert "brackets" not in str(report(one)) and "sum" not in str(report(operation("One")))


def test_csv_file_of_one_operation_has_its_columns(tmp_path):
    file = tmp_path / "one.csv"
    report(operation("One")).to_csv(file)
    with open(file, newline="", encoding="utf-8") as opened:
        (row,) = csv.DictReader(opened)
    assert (row["document"], row["label"], row["trajectories"]) == ("Doc", "One", "5")


def test_table_of_one_document_does_not_name_the_document():
    assert lines(report(operation("One")))[0].split()[0] == "operation"
    told = report(operation("One"), operation("Two", document="Other"))
    assert [line.split()[0] for line in lines(told)] == ["document", "Doc", "Other", "Doc"]


def test_document_names_are_cut_to_two_hundred_letters():
    told = report(operation("One", document="a" * 300), operation("Two", document="b" * 200))
    assert [len(line.split()[0]) for line in lines(told)[1:3]] == [200, 200]


def test_job_length_is_unknown_if_an_operation_is():
    """The known cutting length of both operations is 0, but ignored commands may cut."""
    no_cut = replace(KNOWN, cutting_length=0.0, cutting_seconds=0.0)
    unknown = replace(PARTLY, cutting_length=0.0, cutting_seconds=None)
    for machining, shown in ((no_cut, "0"), (unknown, "?")):
        told = lines(report(operation("One", no_cut), operation("Two", replace(machining, left_out=PARTLY.left_out))))
        assert told[-1].split("10")[-1].split()[0] == shown


def test_table_lists_contradicting_name_before_other_remarks():
    rows = replace(operation("One").recognition, strategy=Strategy.ZIGZAG)
    _, one, two, _ = lines(report(operation("One", called="Offset", recognition=rows), operation("Two")))
    assert "  The operation is called Offset, but its toolpath is zigzag. The operation has no tool. Give" in one
    assert "called" not in two and "  The operation has no tool. Give" in two


def test_operation_without_moves_has_no_times():
    """The operation has no question mark for its cost, because a question mark would mean that a cost is missing."""
    stop = replace(operation("Stop"), trajectories=0)
    empty = replace(stop.recognition, strategy=Strategy.EMPTY)
    _, idle, other, *_ = lines(report(replace(stop, recognition=empty), stop))
    clock = re.compile(r"\d:\d\d")
    assert not {"?", "mm"} & set(idle.split()) and not clock.search(idle)
    assert {"?", "mm"} <= set(other.split()) and clock.search(other)


def test_operation_outside_the_totals_is_in_brackets():
    told = report(operation("One"), operation("Dressed", counted=False), operation("Imported", counted=False, job=None))
    assert [line.split()[0] for line in lines(told)[1:4]] == ["One", "(Dressed)", "Imported"]


def test_total_has_the_sums_of_its_operations():
    (total,) = report(operation("One"), operation("Two", PARTLY), fixtures={JOB: 2}).totals
    told = total.as_dict()
    assert {key: told[key] for key in ("document", "job", "label", "operations", "trajectories", "length", "fixtures")} == {
        "document": "Doc", "job": "Job", "label": "Part", "operations": 2, "trajectories": 10, "length": 200.0, "fixtures": 2,
    }  # fmt: skip
    assert (told["machining_seconds"], told["machining_complete"]) == (total.machining_seconds, False)
    assert (told["seconds"], told["memory_bytes"], told["incomplete"], told["simulated"]) == (0, 0, True, None)


def test_length_shares_of_strategies_have_four_decimals():
    row = operation("One")
    span = Span(0, 9, 0, 9, Strategy.ZIGZAG, 0.123456789)
    told = replace(row, recognition=replace(row.recognition, spans=(span,))).as_dict()["spans"]
    assert told == [{"strategy": "zigzag", "first_command": 0, "last_command": 9, "share": 0.1235}]


@pytest.mark.parametrize(("length", "shown"), [(60, 60 * "x"), (61, 59 * "x" + "…")])
def test_label_of_more_than_sixty_characters_is_cut(length, shown):
    assert lines(report(operation(length * "x")))[1].split()[0] == shown


def test_words_are_left_aligned_and_numbers_right_aligned():
    rows = (
        operation("One"),
        operation("Two", replace(KNOWN, cutting_length=123456.0), remarks=(Message("no-cutting-move"),)),
    )
    head, *shown = lines(report(*rows))[:3]
    assert {line.index("unknown") for line in shown} == {head.index("strategy")}
    assert {line.index(row.error) for line, row in zip(shown, rows)} == {len(head) + 2}
    for line, length in zip(shown, ("100 mm", "123 m")):
        assert line.index(length) + len(length) == head.index("cutting") + len("cutting")
        assert line[len(head) - 1] == "?"


def test_table_has_a_line_of_dashes_below_each_heading():
    head, rule, _ = table_of([operation("One")], [], "legacy").splitlines()
    assert len(rule.split()) == 8 and len(rule) == len(head.rstrip()) and set(rule) == {"-", " "}


def test_text_with_line_breaks_stays_on_one_line_of_the_table():
    assert printable("a\nb\r\x1b[31mc\u202e🙂") == "a b [31mc\u202e🙂"
    assert len(printable("x" * 5000)) == 60
