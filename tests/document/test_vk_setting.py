# SPDX-License-Identifier: LGPL-2.1-or-later
"""Speeds of tool controllers, exact boxes of stocks, and the text of long paths."""

from math import inf, nan
from types import SimpleNamespace

import FreeCAD
import Part
import pytest

from vkworkbench.document.job.fingerprint import AT_ONCE, Settings, text_of
from vkworkbench.document.job.setting import exact_box, rapid_feeds, tool_remark, vertical_feed


def operation(**controller):
    """Return an operation; if properties of a tool controller are given, the operation has such a controller."""
    told = {"ToolController": SimpleNamespace(**{"Label": "TC", **controller})} if controller else {}
    return SimpleNamespace(Name="Operation", **told)


@pytest.mark.parametrize(
    "across, down, feeds",
    [
        (50.0, 20.0, (50, 20)), (0.5, 0.0, (0.5, 0)), (-1.0, 20.0, (0, 20)), (inf, nan, (0, 0)), (None, "fast", (0, 0)),
        (SimpleNamespace(Value=30.0), SimpleNamespace(Value=0), (30, 0)),
    ],
)  # fmt: skip
def test_rapid_speeds_are_positive_numbers_or_none(across, down, feeds):
    assert rapid_feeds(operation(HorizRapid=across, VertRapid=down)) == feeds
    assert rapid_feeds(operation()) == (0, 0)


@pytest.mark.parametrize("feed, told", [(5.0, 5), (0.5, 0.5), (SimpleNamespace(Value=3.0), 3), (None, 0), ("slow", 0)])
def test_vertical_feed_of_a_controller_is_read(feed, told):
    assert vertical_feed(operation(VertFeed=feed)) == told
    assert vertical_feed(operation()) == 0


@pytest.mark.parametrize(
    ("name", "instead"),
    [("endmill", None), ("tap", "as-drill"), ("probe", "as-end-mill"), ("my_ball_6", "as-end-mill")],
)
def test_unknown_tool_shape_is_simulated_as_end_mill(name, instead):
    bit = SimpleNamespace(ShapeName=name, ShapeType=name, Diameter=6.0)
    remark = tool_remark(operation(Label="Tool", Tool=bit))
    assert (remark and remark.arguments["instead"].code) == instead
    assert tool_remark(operation()) is None


def test_displayed_mesh_does_not_change_the_box_of_a_shape():
    """The triangles that FreeCAD displays for a ball lie inside the ball, so their box would be too small."""
    ball = Part.makeSphere(10, FreeCAD.Vector(1, 2, 3))
    ball.tessellate(5.0)
    lower, upper = exact_box(ball)
    assert lower == pytest.approx((-9, -8, -7), abs=1e-4) and upper == pytest.approx((11, 12, 13), abs=1e-4)


def test_given_commands_are_the_text_of_a_long_path():
    """FreeCAD copies the commands of a path slowly, so a caller can pass a list of commands that it already has."""
    commands = [SimpleNamespace(toGCode=lambda k=k: f"G1 X{k}") for k in range(AT_ONCE + 1)]
    path = SimpleNamespace(Size=len(commands))
    expected = "".join(f"G1 X{k}\n" for k in range(len(commands)))
    assert text_of(path, commands) == expected
    path.Commands = list(commands)  # a copy, as the attribute Commands of FreeCAD's Path returns
    assert text_of(path) == expected and path.Commands == []  # text_of frees the commands batch by batch
    short = SimpleNamespace(Size=AT_ONCE, toGCode=lambda: "at once")
    assert text_of(short) == text_of(short, []) == "at once"


def test_mark_without_stock_is_valid_only_after_opening(small, zigzag_commands):
    one = small.add("One", zigzag_commands)
    (whole,) = Settings().of(one)
    assert Settings(opened=True).of(one)[0] == whole and len(Settings(opened=True).of(one)) == 2
