# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each language, switched on in FreeCAD's window: texts are translated, and none is cut off."""

import ast
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import FreeCAD
import FreeCADGui as Gui
import numpy as np
import pytest
from PySide import QtCore, QtGui

import vkworkbench
from toolpaths import synthetic
from vkworkbench.core import linearize, recognize
from vkworkbench.gui.sentences import fitting, in_user_language

ROOT = Path(vkworkbench.__file__).resolve().parents[1]
TRANSLATIONS = ROOT / "resources" / "translations"
LANGUAGES = {
    "de": ("Werkzeugwege analysieren", "Werkzeugweg-Analyse"),
    "fr": ("Analyser les parcours d'outil", "Analyse des parcours d'outil"),
    "es-ES": ("Analizar trayectorias", "Análisis de trayectorias"),
    "zh-CN": ("分析刀具路径", "刀具路径分析"),
}
DOCKS = ("VkResults", "VkGaussMap")


@pytest.fixture(params=LANGUAGES)
def language(request, opened, window):
    """FreeCAD in a language, with the add-on's docks made anew, as after a start."""

    def close_docks():
        for dock in window.main.findChildren(QtGui.QDockWidget):
            if dock.objectName() in DOCKS:
                Gui.Selection.removeObserver(dock)
                FreeCAD.removeDocumentObserver(dock)
                dock.close()
                dock.setObjectName("")
                dock.deleteLater()
        window.idle()

    close_docks()
    before = Gui.getLocale()
    Gui.setLocale(request.param)
    window.idle()
    yield request.param
    Gui.setLocale(before)
    close_docks()


def cut_off(root):
    """Texts of the visible widgets that are wider or higher than their widget."""
    for widget in root.findChildren(QtGui.QWidget):
        if not widget.isVisible():
            continue
        if isinstance(widget, QtGui.QLabel):
            high = widget.heightForWidth(widget.width()) if widget.wordWrap() else widget.sizeHint().height()
            wide = 0 if widget.wordWrap() else widget.sizeHint().width()
            if high > widget.height() or wide > widget.width():
                yield widget.text()
        elif isinstance(widget, (QtGui.QPushButton, QtGui.QCheckBox, QtGui.QComboBox)):
            if widget.minimumSizeHint().width() > widget.width():
                yield getattr(widget, "text", getattr(widget, "currentText", None))()
        elif isinstance(widget, QtGui.QGroupBox):
            if widget.fontMetrics().horizontalAdvance(widget.title()) > widget.width():
                yield widget.title()


def cut_off_headers(table):
    header = table.horizontalHeader()
    for section in range(header.count()):
        if header.sectionSizeHint(section) > header.sectionSize(section):
            yield table.model().headerData(section, QtCore.Qt.Horizontal)


def dock(window, name):
    return next(d for d in window.main.findChildren(QtGui.QDockWidget) if d.objectName() == name)


def test_the_window_in_each_language(language, opened, window):
    command, title = LANGUAGES[language]
    menus = {m.title().replace("&", "") for m in window.main.menuBar().findChildren(QtGui.QMenu)}
    assert title in menus
    window.click(command)
    window.wait(lambda: any(d.objectName() == "VkResults" and d.isVisible()
                            for d in window.main.findChildren(QtGui.QDockWidget)))  # fmt: skip
    window.dismiss()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(opened.getObjectsByLabel("Face")[0])
    window.idle(0.5)
    window.screenshot(f"results-{language}")
    results = dock(window, "VkResults")
    assert list(cut_off(results)) == []
    english = ("phi stays", "turns over", "limited by", "Recommended")
    assert not [words for words in english if words in results.details.text()]
    (table,) = results.findChildren(QtGui.QTableView)
    assert list(cut_off_headers(table)) == []
    results.close()

    window.click(FreeCAD.Qt.translate("Vk_GaussMap", "Gauss map"))
    gauss = dock(window, "VkGaussMap")
    window.wait(lambda: gauss.title.text().startswith("Face"))
    window.idle(0.5)
    window.screenshot(f"gauss-map-{language}")
    assert list(cut_off(gauss)) == []
    gauss.close()


def test_the_preferences_in_each_language(language, window):
    seen = {}

    def look():
        dialog = QtGui.QApplication.activeModalWidget()
        if dialog is None:
            QtCore.QTimer.singleShot(50, look)
            return
        try:
            form = parent = dialog.findChild(QtGui.QWidget, "VkPreferences")
            while parent is not dialog:
                child, parent = parent, parent.parentWidget()
                if isinstance(parent, QtGui.QStackedWidget):
                    parent.setCurrentWidget(child)
            window.idle(0.3)
            window.screenshot(f"preferences-{language}")
            seen["cut off"] = list(cut_off(form))
            seen["button"] = form.calibrate.text()
            seen["items"] = [form.view_direction.itemText(0), form.calibrated.text()]
        finally:
            dialog.reject()

    QtCore.QTimer.singleShot(50, look)
    Gui.runCommand("Std_DlgPreferences")
    assert seen["cut off"] == []
    assert seen["button"] != "Calibrate" and seen["items"][0] != "Top"
    assert "alibrated" not in seen["items"][1]


@pytest.mark.parametrize("name", LANGUAGES)
def test_what_is_compiled_is_what_is_translated(name):
    # Else run resources/update_translations.sh.
    translator = QtCore.QTranslator()
    assert translator.load(str(TRANSLATIONS / f"VkWorkbench_{name}.qm"))
    for context in ElementTree.parse(TRANSLATIONS / f"VkWorkbench_{name}.ts").getroot().iter("context"):
        for message in context.iter("message"):
            text = message.findtext("source")
            assert translator.translate(context.findtext("name"), text) == message.findtext("translation")


def said_by(*paths):
    """Every sentence that these files of the core can say, with a 1 where something is filled in.

    What is filled in right behind a word is an ending, or a piece that may be missing: it is missing.
    """
    for path in paths:
        for node in ast.walk(ast.parse((ROOT / "vkworkbench" / path).read_text())):
            texts = []
            if isinstance(node, ast.Call):
                name = getattr(node.func, "attr", getattr(node.func, "id", ""))
                if name in ("Verdict", "add", "append", "ValueError", "Recognition"):
                    texts = node.args
            elif isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") in ("seen", "message", "why"):
                texts = [node.value]
            elif isinstance(node, ast.Return) and isinstance(node.value, (ast.Constant, ast.JoinedStr)):
                texts = [node.value]
            for text in texts:
                if isinstance(text, ast.JoinedStr):
                    sentence = ""
                    for part in text.values:
                        filled = "" if re.search("[a-z]$", sentence) else "1"
                        sentence += part.value if isinstance(part, ast.Constant) else filled
                    yield sentence
                elif isinstance(text, ast.Constant) and isinstance(text.value, str) and " " in text.value:
                    yield text.value


def test_every_sentence_of_the_core_is_known():
    said = {*said_by("core/verdict.py", "core/evidence.py", "core/recognition.py", "core/linearize.py",
                     "core/preflight.py", "document/setting.py", "document/analysis.py")}  # fmt: skip
    # The sentence of a verdict has too many pieces: the next test makes real ones.
    not_shown = re.compile(
        "must be a positive number of mm, not|no document is open|analysis was cancelled|^phi |^1: 1$"
    )
    unknown = [s for s in said if fitting(s) is None and not not_shown.search(s) and len(s) > 3]
    assert unknown == [] and len(said) > 50


@pytest.mark.parametrize("kind, build", [(kind, build) for kind, _, build in synthetic.SAMPLES])
def test_every_reason_is_known(kind, build):
    for seed in range(3):
        reason = recognize(linearize(build(np.random.default_rng(seed))), tool_diameter=6.0).reason
        template, pieces = fitting(reason)
        assert "seen" not in pieces or fitting(pieces["seen"]) is not None, reason


def test_sentences_of_the_example_in_german(opened):
    Gui.setLocale("de")
    try:
        for o in vkworkbench.analyze(opened).operations:
            for sentence in (o.reason, *filter(None, [o.error]), *(c.message for c in o.cautions)):
                shown = in_user_language(sentence)
                assert shown != sentence and not re.search(r"\b(the|of|and|turns|is)\b", shown), shown
        assert in_user_language("what nobody knows: really") == "what nobody knows: really"
        two = (
            "no tool: give the operation a tool controller; "
            "words without a motion before them ignored (7 times, first at command 3)"
        )
        assert in_user_language(two) == (
            "kein Werkzeug: Der Operation einen Werkzeugcontroller geben; "
            "Wörter ohne Bewegung davor übergangen (7-mal, zuerst bei Befehl 3)"
        )
    finally:
        Gui.setLocale("English")


def test_pieces_of_a_reason():
    rows = [("G0", {"X": 0, "Y": 0, "Z": 0})]
    for i in range(12):
        rows += [("G1", {"X": 50 if i % 2 == 0 else 0}), ("G1", {"Y": 3.0 * (i + 1)})]
    template, pieces = fitting(recognize(linearize(rows), tool_diameter=5).reason)
    assert template.startswith("phi stays between") and pieces["strategy"] == "zigzag"
    assert pieces["more"].endswith("mm apart") and fitting(pieces["seen"]) is not None


def test_shortcuts_are_ours_alone(window):
    window.activate("VkWorkbench")
    ours = {"Vk_Analyze", "Vk_Clear", "Vk_GaussMap", "Vk_Results", "Vk_Strategies"}
    taken = {}
    for name in Gui.listCommands():
        command = Gui.Command.get(name)
        shortcut = command.getShortcut() if command else ""
        if shortcut:
            taken.setdefault(shortcut, []).append(name)
    for names in taken.values():
        assert len(names) == 1 or not ours & set(names), names


def test_every_command_explains_itself(window):
    window.activate("VkWorkbench")
    for name in ("Vk_Analyze", "Vk_Clear", "Vk_GaussMap", "Vk_Results", "Vk_Strategies"):
        info = Gui.Command.get(name).getInfo()
        assert info["menuText"] and len(info["toolTip"]) > 40 and info["whatsThis"] == info["toolTip"]
        (action,) = Gui.Command.get(name).getAction()[:1]
        assert action.statusTip() and not action.icon().isNull()
