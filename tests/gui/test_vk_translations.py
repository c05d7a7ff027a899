# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's window in each language: all texts are translated and fit their widgets."""

import re
from contextlib import contextmanager
from difflib import SequenceMatcher
from pathlib import Path
from xml.etree import ElementTree

import FreeCAD
import FreeCADGui as Gui
import pytest
from cases import first_everywhere
from preferences_dialog import in_preferences
from PySide import QtCore, QtGui

import vkworkbench
from vkworkbench import freecad, preferences
from vkworkbench.core import Strategy
from vkworkbench.core.simulators import cost_from_data
from vkworkbench.document.marks import marks
from vkworkbench.document.marks.record import Record
from vkworkbench.gui.qt import docks
from vkworkbench.gui.qt.language_change import LanguageChange
from vkworkbench.gui.qt.sentences import sentence, user
from vkworkbench.gui.tree.explanation import explanation
from vkworkbench.gui.tree.layout import layouts
from vkworkbench.language import Message, render
from vkworkbench.preferences import Preferences

ROOT = Path(vkworkbench.__file__).resolve().parents[1]
TRANSLATIONS = ROOT / "resources" / "translations"
LANGUAGES = {
    "de": ("Werkzeugwege analysieren", "Werkzeugweg-Analyse"),
    "fr": ("Analyser les parcours d'outil", "Analyse des parcours d'outil"),
    "es-ES": ("Analizar trayectorias", "Análisis de trayectorias"),
    "zh-CN": ("分析刀具路径", "刀具路径分析"),
}
DOCKS = ("VkResults", "VkGaussMap")
ACCELERATOR = re.compile(r"""["']Accel["']: *["']([^"']+)["']""")


def close_docks(window):
    """Delete the add-on's docks, so that the commands make new docks, as after a start of FreeCAD."""
    for dock in window.find(QtGui.QDockWidget):
        if dock.objectName() in DOCKS:
            Gui.Selection.removeObserver(dock)
            FreeCAD.removeDocumentObserver(dock)
            dock.close()
            dock.setObjectName("")
            dock.deleteLater()
    window.settle()


def texts_of(root):
    """Return the texts that a panel shows."""
    texts = [root.windowTitle()]
    for kind in (QtGui.QLabel, QtGui.QAbstractButton, QtGui.QLineEdit, QtGui.QComboBox):
        for one in root.findChildren(kind):
            texts += [getattr(one, name)() for name in ("text", "placeholderText", "currentText") if hasattr(one, name)]
    return texts


def test_change_of_language_translates_open_panels(marked, window):
    results = window.show_results()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(marked.getObjectsByLabel("Face")[0])
    window.click("Gauss Map")
    gauss = docks.find(docks.GAUSS_MAP)
    window.wait(lambda: gauss.title.text().startswith("Face"))
    english = set(texts_of(results) + texts_of(gauss))
    assert {"Toolpath Results", "Filter", "Gauss Map", "Save Picture…"} <= english
    try:
        Gui.setLocale("de")
        window.wait(lambda: results.windowTitle() != "Toolpath Results" and "Zickzack" in gauss.title.text())
        window.settle()
        shown = set(texts_of(results) + texts_of(gauss))
        assert not {text for text in shown & english if len(text) > 3}
        assert results.tree.model().rowCount()
        assert results.model.headerData(2, QtCore.Qt.Horizontal) != "Machining\nTime"
        assert "Warum?" in results.details.toPlainText()
        changes = []
        observer = LanguageChange(lambda: changes.append(Gui.getLocale()), results)
        Gui.updateLocale()  # as workbenches do to load their own translations
        window.settle()
        assert not changes
    finally:
        Gui.setLocale("en")
        window.wait(lambda: results.windowTitle() == "Toolpath Results")
        assert changes == ["English"]
        window.settle()
        observer.deleteLater()
        gauss.hide()


@contextmanager
def speaking(language, window):
    """Set FreeCAD's language, and delete the add-on's docks, which are then made in this language."""
    close_docks(window)
    Gui.setLocale(language)
    window.settle()
    yield
    Gui.setLocale("en")  # FreeCAD calls the former language "C" but does not accept this name
    close_docks(window)


@pytest.fixture(scope="module", params=first_everywhere(LANGUAGES))
def language(request, window):
    with speaking(request.param, window):
        yield request.param


@pytest.fixture
def german(language, window):
    """FreeCAD in German, with German numbers."""
    numbers = QtCore.QLocale()
    close_docks(window)
    QtCore.QLocale.setDefault(QtCore.QLocale("de"))
    yield
    QtCore.QLocale.setDefault(numbers)
    close_docks(window)


in_german = pytest.mark.parametrize("language", ["de"], indirect=True)


def cut_off(root):
    """Yield the texts that are wider or higher than their visible widget."""
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


def cut_off_headers(tree):
    header = tree.header()
    for section in range(header.count()):
        if not header.isSectionHidden(section) and header.sectionSizeHint(section) > header.sectionSize(section):
            yield tree.model().headerData(section, QtCore.Qt.Horizontal)


def dock(window, name):
    return next(d for d in window.find(QtGui.QDockWidget) if d.objectName() == name)


def test_shortcuts_are_not_used_twice(window):
    """Shortcuts are read from the loaded commands and from the Python sources of all workbenches."""
    cam_workbench = "PathWorkbench" if freecad.version() < (1, 0) else "CAMWorkbench"
    for workbench in ("SketcherWorkbench", "PartDesignWorkbench", "DraftWorkbench", cam_workbench, "VkWorkbench"):
        window.activate(workbench)
    ours, taken = {}, {}
    for name in Gui.listCommands():
        command = Gui.Command.get(name)
        shortcut = command.getShortcut() if command else ""
        if shortcut:
            (ours if name.startswith("Vk_") else taken).setdefault(shortcut.replace(" ", ""), []).append(name)
    for path in Path(FreeCAD.getHomePath(), "Mod").rglob("*.py"):
        for keys in ACCELERATOR.findall(path.read_text("utf-8", "replace")):
            taken.setdefault(keys.replace(" ", ""), []).append(path.name)
    assert len(ours) == sum(map(len, ours.values())) == 5 and len(taken) > 50
    assert {keys: taken[keys] for keys in ours if keys in taken} == {}


def test_every_command_has_help_texts(window):
    window.activate("VkWorkbench")
    for name in ("Vk_Analyze", "Vk_Clear", "Vk_GaussMap", "Vk_Results", "Vk_Strategies"):
        info = Gui.Command.get(name).getInfo()
        assert info["menuText"] and len(info["toolTip"]) > 40 and info["whatsThis"] == info["toolTip"]
        (action,) = Gui.Command.get(name).getAction()[:1]
        assert action.statusTip() and not action.icon().isNull()


def test_texts_of_the_window_are_translated_and_fit(language, opened, window):
    command, title = LANGUAGES[language]
    menus = {m.title().replace("&", "") for m in window.find(QtGui.QMenu)}
    assert title in menus
    window.click(command)
    window.wait(lambda: opened.Job.Label2)
    window.show_results()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(opened.getObjectsByLabel("Face")[0])
    window.settle()
    window.screenshot(f"results-{language}")
    results = dock(window, "VkResults")
    assert list(cut_off(results)) == []
    english = ("φ stays", "turns over", "limited by", "Recommended")
    assert not [words for words in english if words in results.details.toPlainText()]
    assert list(cut_off_headers(results.tree)) == []
    results.close()

    window.click(FreeCAD.Qt.translate("Vk_GaussMap", "Gauss Map"))
    gauss = dock(window, "VkGaussMap")
    window.wait(lambda: gauss.title.text().startswith("Face"))
    window.settle()
    window.screenshot(f"gauss-map-{language}")
    assert list(cut_off(gauss)) == []
    gauss.close()


def test_command_name_differs_from_freecad_simulators(language):
    ours = FreeCAD.Qt.translate("Vk_Simulate", "Simulate Toolpaths")
    for name in freecad.own_simulators():  # similar names would be confused, because menus show them side by side
        theirs = freecad.simulator_title(name)
        assert SequenceMatcher(None, ours, theirs).ratio() < 0.65, (ours, theirs)


def test_texts_of_the_preferences_are_translated_and_fit(language, window):
    seen = {}

    def look(dialog, form):
        window.settle()
        window.screenshot(f"preferences-{language}")
        seen["cut off"] = list(cut_off(form))
        seen["button"] = form.calibrate.text()
        seen["items"] = [form.view_direction.itemText(0), form.calibrated.text()]
        dialog.reject()

    in_preferences(window, look)
    assert seen["cut off"] == []
    assert seen["button"] != "Calibrate" and seen["items"][0] != "Top"
    assert "alibrated" not in seen["items"][1]


@pytest.mark.parametrize("name", LANGUAGES)
def test_compiled_translations_are_up_to_date(name):
    # If this test fails, run resources/update_translations.sh.
    translator = QtCore.QTranslator()
    assert translator.load(str(TRANSLATIONS / f"VkWorkbench_{name}.qm"))
    for context in ElementTree.parse(TRANSLATIONS / f"VkWorkbench_{name}.ts").getroot().iter("context"):
        for message in context.iter("message"):
            text = message.findtext("source")
            assert translator.translate(context.findtext("name"), text) == message.findtext("translation")


@pytest.mark.long
@in_german
def test_sentences_of_the_example_are_shown_in_german(opened, german):
    for o in vkworkbench.analyze(opened).operations:
        messages = *o.messages, o.resolution.why
        for message in messages:
            shown = sentence(message)
            assert shown != render(message) and not re.search(r"\b(the|of|and|turns|is)\b|[{}]", shown), shown
    two = (
        Message("no-tool"),
        Message("in-commands", sentence=Message("words-without-motion"), count=7, command=3),
    )
    assert list(map(sentence, two)) == [
        "Die Operation hat kein Werkzeug. Geben Sie ihr einen Werkzeugcontroller.",
        "Befehl 3 (der erste von 7): Wörter ohne eine Bewegung davor werden übergangen.",
    ]


@in_german
def test_numbers_have_the_format_of_the_users_locale(german):
    reader = user()
    assert (reader.count(5752), reader.time(1.42), reader.share(0.98)) == ("5.752", "1,4 s", "98 %")
    assert (reader.length(1601.38), reader.measure(2.5, 3), reader.turns(-9.0)) == ("1.601,38 mm", "2,5 mm", "-1,43")
    # FreeCAD's quantities have the same decimal separator, but no thousands separator.
    assert FreeCAD.Units.Quantity(1234.5, FreeCAD.Units.Length).UserString == reader.length(1234.5).replace(".", "")
    apart, rows = Message("passes-need", step=2.54, cell=0.635), Message("apart-at-depths", step=2.4, depths=3)
    try:
        FreeCAD.Units.setSchema(3)  # FreeCAD's unit schema with inches
        assert sentence(apart) == " Bahnen im Abstand von 0,1 in brauchen 0,025 in."
        # German: the unit "in" (inch), then the preposition "in" of "in 3 depths".
        assert sentence(rows) == " im Abstand von 0,0945 in in 3 Tiefen"
        assert reader.length(25.4) == "1,00 in"
        for schema in range(9):  # all unit schemas of FreeCAD
            FreeCAD.Units.setSchema(schema)
            assert not re.search("nan|inf|[{}]", sentence(apart))
            assert reader.measure(float("nan"), 6).startswith("nan") and reader.measure(0.0, 6).startswith("0 ")
    finally:
        FreeCAD.Units.setSchema(6)


@pytest.mark.long
@in_german
def test_mark_panel_and_gauss_map_are_shown_in_german(opened, german, window):
    """Mark, panel and Gauss map have German numbers and no English sentence."""
    (face,) = opened.getObjectsByLabel("Face")
    window.click("Werkzeugwege analysieren")
    window.wait(lambda: marks.is_marked(face))
    window.click(FreeCAD.Qt.translate("Vk_Results", "Toolpath Results"))
    window.wait(lambda: docks.find(docks.RESULTS) is not None)
    window.tree.expandAll()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(face)
    window.settle()
    text = explanation(marks.read(face), preferences.read())
    panel = docks.find(docks.RESULTS)
    shown = text + panel.details.toPlainText()
    assert (
        "Bearbeitungszeit bei konstantem Vorschub: " in text
        and "16 Zeilen im Abstand von" in text
        and "φ bleibt" not in shown
    )
    assert re.search(r"\d,\d+ mm", shown) and not re.search(r"\d\.\d\d?\b", shown), shown
    assert not re.search(r"\b(φ stays|turns|the|of|limited)\b", shown), shown
    assert re.search(r"\b\d+ %", text), text
    model = panel.tree.model()
    job = model.index(0, 0)
    cells = [model.index(row, column, job).data() for row in range(model.rowCount(job)) for column in range(1, 12)]
    assert not [cell for cell in cells if re.search(r"\d\.\d{1,2}\b", str(cell))], cells
    assert window.tooltip("Face")
    window.screenshot("german-tooltip-and-panel")
    QtGui.QToolTip.hideText()
    panel.close()
    window.click(FreeCAD.Qt.translate("Vk_GaussMap", "Gauss Map"))
    gauss = docks.find(docks.GAUSS_MAP)
    window.wait(lambda: gauss.title.text().startswith("Face"))
    window.settle()
    window.screenshot("german-gauss-map")
    shown = f"{gauss.title.text()} {gauss.values.text()} {gauss.chooser.currentText()}"
    assert re.search(r"[+-]\d,\d\d", gauss.title.text()) and re.search(r"\d,\d°", gauss.values.text())
    assert not re.search(r"\d\.\d{1,2}\b", shown), shown
    gauss.close()


@in_german
def test_times_in_pills_have_the_format_of_the_users_locale(german):
    cost = cost_from_data("z-buffer", {"seconds": 1.4, "memory_bytes": 2e6, "factor": 1.5, "stock_bytes": 0})
    record = Record(Strategy.ZIGZAG, confidence=0.7, costs={"z-buffer": cost}, remarks=(Message("no-tool"),))
    metrics = QtGui.QFontMetrics(QtGui.QFont())
    (full, *_) = layouts(record, "own words", Preferences(mark_simulator="z-buffer"), metrics, None)
    assert full.pieces[0].text == "Zickzack 70 %" and "Sim. 1,4 s" in full.text
    assert full.text.endswith("Die Operation hat kein Werkzeug. Geben Sie ihr einen Werkzeugcontroller.  own words")
