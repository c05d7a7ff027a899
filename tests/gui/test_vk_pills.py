# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pills in the tree: colours, texts and tooltips in light and dark windows, editing by F2, and the number of layouts."""

import re
import time
from dataclasses import replace
from types import SimpleNamespace

import FreeCAD
import FreeCADGui as Gui
import Part
import pytest
from pictures import contrast, counted, luminance, shows
from PySide import QtCore, QtGui

import vkworkbench
from vkworkbench import freecad, preferences
from vkworkbench.core import Strategy
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.record import Record, as_json
from vkworkbench.gui.qt import colors
from vkworkbench.gui.qt.sentences import plain_sentence, sentence, user
from vkworkbench.gui.results.columns import columns
from vkworkbench.gui.results.rows import Row
from vkworkbench.gui.tree import column as tree
from vkworkbench.gui.tree import pills
from vkworkbench.gui.tree.explanation import explanation
from vkworkbench.gui.tree.layout import PADDING, layouts
from vkworkbench.language import Message
from vkworkbench.preferences import Preferences


def labelled(document, label):
    (obj,) = document.getObjectsByLabel(label)
    return obj


def picture(window, label):
    """Return a screenshot of an operation's description in the tree."""
    view = window.tree
    view.scrollTo(window.cell(label))
    window.settle()
    area = view.visualRect(window.cell(label)) & view.viewport().rect()
    area.setWidth(min(area.width(), 240))  # px; the tests compare coloured shares of a picture with this width
    corner = view.viewport().mapToGlobal(area.topLeft())
    screen = QtGui.QApplication.primaryScreen()
    return screen.grabWindow(0, corner.x(), corner.y(), area.width(), area.height()).toImage()


def share(image, color):
    """Return the share of pixels with a colour."""
    return shows(image, color).mean()


def bright(image):
    """Return the share of nearly white pixels."""
    found = counted(image)
    return sum(count for color, count in found.items() if luminance(color) > 0.8) / sum(found.values())


def tooltip(window, label):
    return window.tooltip(label).replace("\u00a0", " ")


@pytest.mark.parametrize("one, other, expected", [
    ("white", "black", 21.0), ("#777777", "white", 4.478), ("#ff0000", "white", 3.998), ("#008000", "white", 5.137),
    ("#0000ff", "white", 8.592), ("#0a0a0a", "black", 1.0607),
])  # fmt: skip
def test_contrast_of_two_colours_follows_wcag(one, other, expected):
    for pair in ((one, other), (other, one)):
        assert colors.contrast(*map(QtGui.QColor, pair)) == pytest.approx(expected, rel=2e-4)


@pytest.mark.parametrize("ink, back, least, expected", [
    ("#2f7fd6", "white", 4.6, "#2a70bd"), ("#2f7fd6", "black", 4.6, "#2f7fd6"), ("#2f7fd6", "#1e1e1e", 4.6, "#478edb"),
    ("#8c8c8c", "#8c8c8c", 4.6, "#1b1b1b"), ("#8c8c8c", "#777777", 3.1, "#282828"), ("#ffff00", "white", 4.6, "#656500"),
    ("#000080", "black", 3.1, "#5959ac"), ("#000000", "white", 21.0, "#000000"), ("#777777", "white", 30.0, "#000000"),
])  # fmt: skip
def test_colour_is_changed_until_it_is_readable(ink, back, least, expected):
    """
    A readable colour is not changed.

    If no shade of the colour has enough contrast, the result is white or black.
    """
    found = QtGui.QColor(colors.readable(QtGui.QColor(ink), QtGui.QColor(back), least))
    assert found.getRgb()[:3] == pytest.approx(QtGui.QColor(expected).getRgb()[:3], abs=1)


def test_every_strategy_has_a_readable_colour():
    for color in [*(strategy.color for strategy in Strategy), colors.TOTAL]:
        assert contrast(color, colors.TEXT) >= 4.5
        assert contrast(color, "#ffffff") >= 3 and contrast(color, "#1e1f22") >= 3  # WCAG's minimum for graphics
    telling = [strategy.color for strategy in Strategy if strategy.is_answer]
    assert len(set(telling)) == len(telling)


def layout(record, words="", *, room=10_000, **chosen):
    """Return the layout of a mark in a cell that is `room` pixels wide."""
    found = layouts(record, words, Preferences(**chosen), QtGui.QFontMetrics(QtGui.QFont()), None)
    return next((one for one in found if one.needed <= room), found[-1])


def record_of(seconds, *, factor=1.3, strategy=Strategy.ADAPTIVE, **rest):
    costs = {"legacy": SimpleNamespace(seconds=seconds, play_seconds=seconds, memory_bytes=1e6, factor=factor)}
    return Record(strategy, confidence=0.9, costs=costs, **rest)


@pytest.mark.parametrize("seconds, color", [(299, None), (301, "NEAR"), (601, "OVER")])
def test_pill_of_a_time_near_or_over_the_budget_is_coloured(seconds, color):
    record = record_of(seconds)
    shown = layout(record, mark_simulator="legacy", time_budget=600.0)
    colored = [piece.color for piece in shown.pieces if piece.kind == "filled"]
    assert colored == [Strategy.ADAPTIVE.color, *([colors.BURDEN[color][0]] if color else [])]
    assert any(piece.kind == "warning" for piece in shown.pieces) == (color == "OVER")
    assert (user().time(seconds) in shown.text) == (color is None)
    assert layout(record, mark_simulator="legacy", time_budget=1e5).text.endswith(f"sim {user().time(seconds)}")


@pytest.mark.parametrize("points", [7, 9, 10, 11, 14, 24])
def test_pill_is_wider_than_its_text_in_every_font(points):
    metrics = QtGui.QFontMetrics(QtGui.QFont("Sans Serif", points))
    for strategy in (Strategy.CONTOUR_PARALLEL, Strategy.ADAPTIVE, None):
        record = record_of(6120, strategy=strategy)
        for shown in layouts(record, "", Preferences(mark_simulator="legacy"), metrics, None):
            for piece in shown.pieces:
                assert not piece.text or piece.width >= metrics.horizontalAdvance(piece.text) + 2 * PADDING


def test_narrow_pill_drops_machining_time_before_simulation():
    record = record_of(6120, factor=4.0, machining_seconds=78.0, remarks=(Message("no-job"),))
    texts = []
    for room in range(600, 10, -5):
        shown = layout(record, "own words", room=room, mark_simulator="legacy")
        text = " ".join([piece.text for piece in shown.pieces] + shown.text.split())
        if text not in texts:
            texts.append(text)
    about = user().estimated_time(6120, 4.0)
    plain = user().time(6120, 4.0)
    assert [[part in text for part in ("own words", "1:18", about, f"sim {plain}", plain)] for text in texts] == [
        [True, True, True, False, True],
        [False, True, False, True, True],
        [False, False, False, True, True],
        [False, False, False, False, False],
    ]


def test_narrow_pill_of_a_job_is_shortened_before_its_times():
    record = record_of(3000, strategy=None, operations=9, machining_seconds=999.0)
    texts = []
    for room in range(600, 10, -5):
        shown = layout(record, room=room, mark_simulator="legacy", time_budget=600.0)
        text = " ".join([piece.text for piece in shown.pieces] + shown.text.split())
        if text not in texts:
            texts.append(text)
    time = f"sim {user().time(3000, 1.3)}"
    assert [[part in text for part in ("9 operations", "9", "16:39", time)] for text in texts] == [
        [True, True, True, True],
        [False, True, True, True],
        [False, True, False, True],
        [False, True, False, False],
    ]


def test_warning_sign_is_shown_in_every_width():
    record = record_of(6120, machining_seconds=78.0)
    for room in range(600, 10, -5):
        shown = layout(record, "own words", room=room, mark_simulator="legacy", time_budget=600.0)
        assert "warning" in [piece.kind for piece in shown.pieces]


def test_error_has_a_sign_instead_of_a_pill():
    record = Record(Strategy.EMPTY, remarks=(Message("no-toolpath"),))
    (sign,) = layout(record).pieces
    assert sign.kind == "error" and sentence(record.remarks[0]) in layout(record).text


def test_minimum_time_of_0_is_not_shown():
    """The times of rapids without a speed are unknown, and "at least 0 s" would not help the user."""
    untimed = Message("rapids-untimed", length=100.0, name="HorizRapid")
    record = Record(Strategy.EMPTY, trajectories=1, machining_seconds=0.0, left_out=(untimed,),
                    remarks=(Message("no-cutting-move"),))  # fmt: skip
    text = explanation(record, preferences.read())
    assert not re.search(r"\b0 s", text) and "Cutting length: " in text
    (machining,) = [one for one in columns(freecad.version(), "legacy")[0] if one.key == "machining_time"]
    assert machining.text(Row(record, "Op", "Op", mark=record)) == ""


def test_error_sign_next_to_a_pill_is_shown_in_every_width():
    """A mark can have an error and a strategy: without a job the simulation is unknown, but the strategy is not."""
    record = Record(Strategy.ZIGZAG, confidence=0.95, remarks=(Message("no-tool"),))
    for room in (10_000, 120, 40):
        assert [piece.kind for piece in layout(record, room=room).pieces] == ["error", "filled"]
    assert sentence(record.remarks[0]) in layout(record).text


def test_pills_of_totals_and_outdated_marks_look_different():
    total = record_of(5, strategy=None, operations=8)
    assert layout(total).pieces[0].text == "8 operations" and layout(total).pieces[0].color == colors.TOTAL
    outdated = layout(record_of(5, outdated=True), "mine")
    assert outdated.pieces[0].kind == "outlined" and outdated.text.split()[-2:] == ["outdated", "mine"]


def test_description_without_a_mark_is_shown_unchanged(opened, window):
    tree.show_description()  # FreeCAD 1.x hides the Description column by default
    pills.show()
    for label2 in ("⟦⟧", "⟦3 operations foo⟧", "⟦sculpting 9%⟧", "zigzag 97% ⟦zigzag 97%⟧", "⟦zigzag · ▶ 3 s⟧"):
        labelled(opened, "Face").Label2 = label2
        window.settle()
        assert window.cell("Face").data() == label2 and share(picture(window, "Face"), Strategy.ZIGZAG.color) == 0
        assert edit(window, "Face", None) == label2


@pytest.mark.long
def test_text_beside_a_pill_is_readable(marked, window, theme):
    image = picture(window, "Face")
    metrics = QtGui.QFontMetrics(window.tree.font())
    beside = image.copy(
        metrics.horizontalAdvance("zigzag  ") + 20, 0, metrics.horizontalAdvance("sim about"), image.height()
    )
    shades = sorted(counted(beside), key=luminance)
    assert contrast(shades[0], shades[-1]) >= 4.5


@pytest.mark.long
def test_pills_can_be_switched_off(marked, window):
    preferences = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/VkWorkbench")
    color = marks.read(labelled(marked, "Face")).strategy.color
    preferences.SetBool("ShowPills", False)
    pills.show()
    assert share(picture(window, "Face"), color) == 0
    preferences.RemBool("ShowPills")
    pills.show()
    assert share(picture(window, "Face"), color) > 0.1


def test_tooltip_has_reason_and_times(marked, window):
    obj = labelled(marked, "Face")
    text = tooltip(window, "Face")
    # A no-break space keeps each number and its unit in one line.
    assert not re.search(r"\d (?:ms|s|min|h|mm|m|kB|MB)\b", QtGui.QToolTip.text())
    known = marks.read(obj)
    (reason,) = known.reason
    assert plain_sentence(reason).replace("<", "&lt;").replace(">", "&gt;") in text and "φ" not in text
    assert (
        f"Machining time at constant feed: {user().clock(known.machining_seconds)}. Cutting length: {user().length(known.length)}."
        in text
    )
    for name in freecad.own_simulators():
        assert f"Simulation time of this operation alone in the {freecad.simulator_title(name)}: " in text
    window.see_all()
    window.screenshot("pill-tooltip")
    obj.VkWorkbenchMark = as_json(replace(known, remarks=(Message("not-analysed", error="a <b>&c remark"),)))
    assert "a &lt;b&gt;&amp;c remark" in tooltip(window, "Face")


@pytest.mark.long
def test_user_words_equal_to_the_text_of_the_mark_can_be_edited(marked, window):
    face = labelled(marked, "Face")
    own = marks.read(face).text
    face.Label2 = f"{own} ⟦{own}⟧"
    assert marks.words_of(face) == own
    assert edit(window, "Face", "other words") == own
    assert face.Label2 == f"other words ⟦{own}⟧"


def test_pill_has_the_colour_of_its_strategy(marked, window, theme):
    labelled(marked, "Face").Label2 = "rough first " + labelled(marked, "Face").Label2
    drill = labelled(marked, "Drill holes")
    drill.VkWorkbenchMark = drill.VkWorkbenchMark.replace(marks.read(drill).fingerprint, "of:another")
    from vkworkbench.document.marks import watcher

    watcher.check(marked)
    Gui.Selection.addSelection(labelled(marked, "Bore"))
    window.settle()
    window.screenshot(f"pills-{theme}")
    for obj in filter(marks.is_marked, marked.Objects):
        mark = marks.read(obj)
        image = picture(window, obj.Label)
        color = mark.strategy.color if mark.strategy else colors.TOTAL
        # The colour of a valid mark covers more than 5 % of the cell in the tree.
        assert (share(image, color) > 0.05) != mark.outdated, obj.Label
        if not mark.outdated:
            assert bright(image) > 0.005, obj.Label  # the nearly white text of the pill covers a part of the cell
    assert marks.is_outdated(drill)


@pytest.mark.long
def test_warning_sign_is_in_sight_if_the_column_exceeds_the_tree(marked, window):
    view = window.tree
    preferences.write(time_budget=0.1)
    try:
        labelled(marked, "Face").Label2 = "rough " * 60 + labelled(marked, "Face").Label2
        window.settle()
        view.setColumnWidth(tree.DESCRIPTION, 2000)
        view.horizontalScrollBar().setValue(0)
        window.settle()
        cell = view.visualRect(window.cell("Job"))
        assert cell.right() > view.viewport().width()
        image = view.viewport().grab(cell & view.viewport().rect()).toImage()
        assert share(image, colors.WARNING[0]) > 0
    finally:
        preferences.write(time_budget=600.0)
        window.settle()


@pytest.mark.long
def test_text_of_a_pill_in_a_narrow_column_is_elided(marked, window):
    label, view = "Pocket around island", window.tree
    width = view.columnWidth(tree.DESCRIPTION)
    try:
        view.setColumnWidth(tree.DESCRIPTION, 70)
        window.settle()
        view.scrollTo(window.cell(label))
        image = picture(window, label)
    finally:
        view.setColumnWidth(tree.DESCRIPTION, width)
    back = QtGui.QColor(marks.read(labelled(marked, label)).strategy.color).getRgb()[:3]
    middle = image.height() // 2
    pill = [x for x in range(image.width()) if image.pixelColor(x, middle).getRgb()[:3] == back]
    assert len(pill) > 10
    ends = (pill[0] + 1, pill[0] + 2, pill[-1] - 2, pill[-1] - 1)
    assert {image.pixelColor(x, middle + y).getRgb()[:3] for x in ends for y in range(-3, 4)} == {back}
    assert bright(image) > 0.005


@pytest.mark.long
def test_tooltip_is_not_taken_from_another_document(marked, window):
    other = FreeCAD.newDocument("Other")
    other.Label = marked.Label
    twin = other.addObject("App::FeaturePython", "Face")
    twin.Label = "Face"
    twin.addProperty("App::PropertyString", "VkWorkbenchMark")
    twin.Label2 = labelled(marked, "Face").Label2
    FreeCAD.setActiveDocument(marked.Name)
    window.settle()
    index = next(i for i in all_rows(window.tree.model()) if i.data() == "Face")
    assert pills._object_of(index.sibling(index.row(), 1)) is None
    FreeCAD.closeDocument(other.Name)
    window.settle()
    (reason,) = marks.read(labelled(marked, "Face")).reason
    assert plain_sentence(reason)[1:20] in QtGui.QTextDocumentFragment.fromHtml(
        tooltip(window, "Face")).toPlainText()  # fmt: skip


@pytest.mark.long
def test_mark_without_a_stock_stays_outdated_after_a_copy(opened, window):
    job, face = opened.getObject("Job"), labelled(opened, "Face")
    job.Stock = opened.addObject("Part::FeaturePython", "NothingYet")
    opened.recompute()
    vkworkbench.mark(vkworkbench.analyze(face))
    assert not marks.is_outdated(face)
    job.Stock.Shape = Part.makeBox(60, 60, 20)
    opened.recompute()
    window.wait(lambda: marks.is_outdated(face))
    opened.copyObject(labelled(opened, "Bore"), False)  # after a copy, the watcher compares all marks
    opened.recompute()
    window.settle()
    assert marks.is_outdated(face)


def all_rows(model, parent=None):
    parent = parent or QtCore.QModelIndex()
    for row in range(model.rowCount(parent)):
        index = model.index(row, 0, parent)
        yield index
        yield from all_rows(model, index)


def edit(window, label, text, key=QtCore.Qt.Key_Return):
    """Edit a description as a user does; return the text that the editor offered."""
    index = window.cell(label)
    window.tree.scrollTo(index)
    window.tree.setCurrentIndex(index)
    window.tree.setFocus()
    window.tree.edit(index)
    window.wait(lambda: editors(window))
    (editor,) = editors(window)
    offered = editor.text()
    if text is not None:
        editor.selectAll()
        window.type(editor, text)
    window.press(editor, key)
    window.wait(lambda: not editors(window))
    return offered


def editors(window):
    return [e for e in window.tree.viewport().findChildren(QtGui.QLineEdit) if e.isVisible()]


def test_editing_changes_the_users_words_only(marked, window):
    obj = labelled(marked, "Face")
    segment, undo = obj.Label2, marked.UndoCount
    assert edit(window, "Face", "rough pass") == ""
    assert obj.Label2 == f"rough pass {segment}" and marked.UndoCount == undo + 1
    assert edit(window, "Face", None) == "rough pass"
    assert edit(window, "Face", "no", QtCore.Qt.Key_Escape) == "rough pass"
    assert obj.Label2 == f"rough pass {segment}" and marked.UndoCount == undo + 1
    assert edit(window, "Face", " ") == "rough pass"
    assert obj.Label2 == segment
    assert "Touched" not in obj.State
    Gui.runCommand("Std_Undo")
    assert obj.Label2 == f"rough pass {segment}"


def test_description_without_a_mark_is_edited_normally(opened, window):
    pills.show()
    assert edit(window, "Face", "mine") == ""
    assert labelled(opened, "Face").Label2 == "mine"


def test_marks_that_a_macro_writes_are_shown_as_pills(opened, window):
    vkworkbench.mark(vkworkbench.analyze(labelled(opened, "Face")))
    window.tree.expandAll()
    window.settle()
    assert share(picture(window, "Face"), Strategy.ZIGZAG.color) > 0.1


@pytest.mark.long
def test_layout_of_sixty_marks_is_computed_once(opened, window):
    """FreeCAD 1.x lays the tree out after each change of a text; 60 marks must cause no more layouts than one."""
    from vkworkbench.gui import commands

    job, bore = opened.getObject("Job"), labelled(opened, "Bore")
    copies = [opened.copyObject(bore, False) for _ in range(60 - len(job.Operations.Group))]
    job.Operations.Group += copies
    window.tree.expandAll()
    window.settle()
    one, all_of_them = vkworkbench.analyze(bore), vkworkbench.analyze(job)
    assert len(all_of_them.operations) >= 60
    resized = []
    window.tree.header().sectionResized.connect(lambda *what: resized.append(what))
    counts = []
    for report in (one, all_of_them):
        vkworkbench.clear(opened)
        window.settle()
        resized.clear()
        begin = time.thread_time()
        commands.mark(report)
        QtGui.QApplication.processEvents()
        print(f"{len(report.operations)} marks in {1e3 * (time.thread_time() - begin):.0f} ms")
        counts.append(len(resized))
    assert counts[1] <= counts[0] + 4
