# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random documents, changes, marks, settings and clicks inside FreeCAD. tests/fuzz.sh runs this file.

Each seed is one session: documents are made, changed, analysed, marked, damaged, copied, saved and closed. After each
action every mark in the tree that is not outdated is compared with its toolpath. A session has failed if such a mark
does not fit its toolpath, if the add-on raises an undocumented error, or if FreeCAD's log shows a traceback from the
add-on's code.

An environment variable selects the sessions: VKWORKBENCH_FUZZ="SEED MINUTES [SESSIONS]".
"""

from __future__ import annotations

import faulthandler
import json
import os
import random
import signal
import sys
import tempfile
import time
import traceback
from contextlib import suppress
from pathlib import Path

import FreeCAD
import Part
import Path as CAM

sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parents[1] / "examples"), str(Path(__file__).parents[1])]
import fuzz
import programs
from inside_freecad import run_and_leave
from make_example import cam

import vkworkbench
from vkworkbench import preferences
from vkworkbench.document import upkeep
from vkworkbench.document.job.fingerprint import Settings, path_fingerprint, text_fingerprint
from vkworkbench.document.job.operations import find
from vkworkbench.document.job.results import RESULTS
from vkworkbench.document.marks import marks
from vkworkbench.language import Unusable

ROOT = str(Path(__file__).parents[1])
# s; longest processor time and longest clock time of a session, after which the session counts as hanging
LONGEST, STILL = 120, 900
ACTIONS = 25  # number of actions per session
TEXTS = ["", "own words", "⟦zigzag 97%⟧", "⟦3 operations foo⟧", "a ⟦⟧ b", "⟦⟦x⟧", "⟧⟦", "zigzag 97% ⟦zigzag 97%⟧", "<b>&amp;", "🙂\n\x07",
         "<img src='file:///x'>", "x" * 3000, "⟦zigzag · ▶ 3 s · outdated⟧", "{0} %s"]  # fmt: skip
VALUES = {
    "App::PropertyString": "10 mm/s", "App::PropertyStringList": ["a", "b"], "App::PropertyBool": True,
    "App::PropertyInteger": -3, "App::PropertyFloat": float("nan"), "App::PropertyFloatList": [1.0, 2.0],
    "App::PropertyVector": FreeCAD.Vector(1, 2, 3), "App::PropertyLinkList": [], "App::PropertyLink": None,
    "App::PropertyMap": {"a": "b"}, "App::PropertyLength": 5, "App::PropertyPercent": 50,
}  # fmt: skip
ON_OPERATION = ["Active", "Base", "Copies", "Gcode", "Group", "Strategy", "Confidence", "Reason", "Remarks", "CuttingLength",
                "MachiningTime", "SimulationTime", "VkWorkbenchMark", "ToolpathMark", "ToolpathFingerprint", "ToolpathStrategy"]  # fmt: skip
# Sessions do not delete these objects: without them, the origin of a tool's body is an error, which FreeCAD 1.1 reports
# after it has deleted the body. See benchmarks/freecad_recompute.py.
OF_ORIGIN = {"App::Plane", "App::Line", "App::Point", "App::Origin"}
JSON = [None, -1, 0, 1e308, 10**400, "x", [], {}, [[[]]], True, float("nan"), {"a": {"b": []}}]


def command_of(name, words):
    words = {key: value for key, value in (words or {}).items() if isinstance(value, float)}
    if FreeCAD.GuiUp:
        words.pop("Q", None)  # FreeCAD would hang on tiny pecks, because it draws each (benchmarks/freecad_pecks.py)
    try:
        return CAM.Command(name, words)
    except (TypeError, ValueError, RuntimeError):
        return CAM.Command("G0")


def a_path(rng):
    """Return the path of a valid program or of a random program. Few paths are long."""
    if rng.random() < 0.5:
        commands = rng.choice(list(programs.SOUND.values()))()
    else:
        commands, *_ = fuzz.flat_program(rng.randrange(10**6))
    return CAM.Path([command_of(*one) for one in commands[: 30_000 if rng.random() < 0.05 else 400]])


class Session:
    """The random actions of one seed on open documents."""

    def __init__(self, seed):
        self.rng = random.Random(seed)
        self.actions = [
            getattr(self, name) for name in dir(type(self)) if name.startswith(("do_", "click_" if FreeCAD.GuiUp else "do_"))
        ]  # fmt: skip
        self.done, self.folder = [], tempfile.TemporaryDirectory()

    def run(self):
        RESULTS.clear()
        upkeep.watch()
        self.do_new_document()
        for _ in range(ACTIONS):
            if not FreeCAD.listDocuments():
                self.do_new_document()
            action = self.rng.choice(self.actions)
            self.done.append(action.__name__)
            print(f"\n{action.__name__}", flush=True)  # the log shows the action if FreeCAD crashes in it
            action()
            if self.rng.random() < 0.5:
                self.settle()
                self.marks_are_true()

    def end(self):
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)
        idle()
        self.folder.cleanup()
        FreeCAD.ParamGet(preferences.GROUP).Clear()
        calibration_file().unlink(missing_ok=True)

    # The following methods choose randomly among the open documents and their objects.

    @property
    def document(self):
        return FreeCAD.getDocument(self.rng.choice(sorted(FreeCAD.listDocuments())))

    def an_object(self, type_name=None):
        objects = [obj for obj in self.document.Objects if type_name is None or obj.isDerivedFrom(type_name)]
        return self.rng.choice(objects) if objects else None

    def an_operation(self):
        operations = [o.object for o in find(self.document)]
        return self.rng.choice(operations) if operations else None

    def something(self):
        return self.rng.choice([self.document, self.an_operation() or self.document, self.an_object() or self.document])

    # The following methods check the documents after each action.

    def settle(self):
        for document in FreeCAD.listDocuments().values():
            document.recompute()
        idle()

    def marks_are_true(self):
        for document in FreeCAD.listDocuments().values():
            settings = Settings()
            for obj in [o.object for o in find(document)]:
                known = marks.read(obj)
                path = text_fingerprint(obj.Path.toGCode(), obj.Placement)
                assert path_fingerprint(obj) == path, f"{obj.Name}: another path's fingerprint is known"
                if known is not None and not known.outdated:
                    at, _, setting = known.fingerprint.partition(":")
                    assert at in ("", path) and setting in settings.of(obj), f"{obj.Name}: fresh, and does not fit"

    def analyzed(self, what):
        before = {obj.Name: (obj.Label, obj.Label2, list(obj.State)) for obj in find_all(what)}
        report = vkworkbench.analyze(what)
        str(report)
        json.dumps([row.as_dict() for row in report.operations])
        for row in report.operations:
            assert "Please report" not in (row.error or ""), row.error
        assert before == {obj.Name: (obj.Label, obj.Label2, list(obj.State)) for obj in find_all(what)}
        return report

    # The following actions change documents, with and without a window.

    def do_new_document(self):
        if len(FreeCAD.listDocuments()) > 2:
            return
        document = FreeCAD.newDocument(self.rng.choice(["One", "Two"]))
        document.UndoMode = self.rng.choice([0, 1, 1, 1])
        block = document.addObject("Part::Box", "Block")
        block.Length, block.Width, block.Height = 60, 40, 20
        document.recompute()
        if self.rng.random() < 0.5:
            cam("Main.Job").Create("Job", [block])
            document.recompute()
            document.clearUndos()  # undoing a part of the job crashes FreeCAD, see benchmarks/freecad_undo.py
        for _ in range(self.rng.randrange(4)):
            self.add(document)

    def add(self, document):
        op = document.addObject(self.rng.choice(["Path::FeaturePython"] * 4 + ["Path::Feature"]), "Op")
        op.Path = a_path(self.rng)
        op.Label = self.rng.choice(["Op", "ZigZag", *TEXTS])
        jobs = [obj for obj in document.Objects if hasattr(obj, "Operations") and hasattr(obj, "Tools")]
        if jobs and self.rng.random() < 0.9:
            job = self.rng.choice(jobs)
            op.addProperty("App::PropertyLink", "ToolController", "Path")
            op.ToolController = self.rng.choice([*job.Tools.Group, None]) if hasattr(job.Tools, "Group") else None
            if hasattr(job.Operations, "Group"):
                job.Operations.Group += [op]

    def do_add_operation(self):
        self.add(self.document)

    def do_analyze_and_mark(self):
        vkworkbench.mark(self.analyzed(self.something_with_toolpaths()))

    do_analyze_again = do_mark_everything = do_analyze_and_mark

    def something_with_toolpaths(self):
        return self.rng.choice([self.document, self.document, self.an_operation() or self.document])

    def do_mark_later(self):
        report = self.analyzed(self.document)
        self.rng.choice([self.do_change_path, self.do_change_setting, self.do_close, self.do_delete, self.do_undo])()
        vkworkbench.mark(report)

    def do_change_during_an_analysis(self):
        change = self.rng.choice([self.do_change_path, self.do_change_setting, self.do_delete])
        report = vkworkbench.analyze(self.document, progress=lambda done, *_: done == 1 and change())
        vkworkbench.mark(report)

    def do_clear(self):
        what = self.something()
        try:
            vkworkbench.clear(what)
        except TypeError as error:
            assert "only a document, a job or operations" in str(error), error

    def do_change_path(self):
        op = self.an_operation()
        if op is not None:
            op.Path = self.rng.choice([a_path(self.rng), CAM.Path(op.Path.Commands[:-1]), CAM.Path()])

    def do_change_placement(self):
        op = self.an_operation()
        if op is not None:
            op.Placement.Base = FreeCAD.Vector(*(self.rng.uniform(-9, 9) for _ in range(3)))

    def do_change_setting(self):
        obj = self.an_object()
        for name in ("Diameter", "Height", "Stock", "ToolController", "ExtXpos", "Active"):
            if hasattr(obj, name) and self.rng.random() < 0.7:
                value = getattr(obj, name)
                number = self.rng.choice([1, 5, 7, 0, -1, 1e6, 1e-5])
                choices = [None, self.an_object()] if name in ("Stock", "ToolController") else [number]
                # FreeCAD itself refuses some values
                with suppress(TypeError, ValueError, ArithmeticError, RuntimeError):
                    setattr(obj, name, not value if isinstance(value, bool) else self.rng.choice(choices))

    def do_change_stock(self):
        job = next((obj for obj in self.document.Objects if hasattr(obj, "Stock")), None)
        if job is not None:
            solid = job.Document.addObject("Part::Feature", "Solid")
            solid.Shape = self.rng.choice([Part.makeBox(60, 60, 20), Part.makeCylinder(30, 20), Part.makeSphere(20), Part.Shape(),
                                           Part.makeTorus(20, 5), Part.makeBox(9, 9, 9).Shells[0], Part.makePlane(9, 9)])  # fmt: skip
            with suppress(TypeError):  # raised if the job's property Stock has been replaced by one of another type
                job.Stock = solid

    def do_odd_property(self):
        obj = self.an_operation() or self.an_object()
        if obj is None:
            return
        name, type_id = self.rng.choice(ON_OPERATION), self.rng.choice(list(VALUES))
        try:
            if hasattr(obj, name):
                obj.setPropertyStatus(name, "-LockDynamic")
                if not obj.removeProperty(name):
                    return
            if self.rng.random() < 0.6:
                obj.addProperty(type_id, name, self.rng.choice(["Odd", "Toolpath analysis"]))
                setattr(obj, name, VALUES[type_id])
        except (TypeError, ValueError, RuntimeError, AttributeError):
            pass  # FreeCAD itself refuses some properties

    def do_damage_mark(self):
        marked = [obj for obj in self.document.Objects if marks.is_marked(obj)]
        if not marked:
            return
        obj = self.rng.choice(marked)
        text = getattr(obj, "VkWorkbenchMark", "")
        if isinstance(text, str) and text:
            try:
                data = json.loads(text)
            except ValueError:
                data = {}
            if isinstance(data, dict) and data and self.rng.random() < 0.7:
                name = self.rng.choice([key for key in data if key not in ("fingerprint", "outdated")] or ["x"])
                data[name] = self.rng.choice(JSON)
                text = json.dumps(data)
            else:
                text = text[: self.rng.randrange(len(text))]
            obj.VkWorkbenchMark = text

    def do_description(self):
        obj = self.an_object()
        if obj is None:
            return
        try:
            how = self.rng.random()
            if how < 0.1:
                obj.setPropertyStatus("Label2", self.rng.choice(["Immutable", "-Immutable", "ReadOnly", "-ReadOnly"]))
            elif how < 0.2:
                obj.setExpression("Label2", self.rng.choice([None, "<<driven>>"]))
            else:
                obj.Label2 = self.rng.choice([*TEXTS, obj.Label2 + " more", obj.Label2[: len(obj.Label2) // 2]])
        except (TypeError, ValueError, RuntimeError, AttributeError):
            pass

    def do_undo(self):
        document = self.document
        for _ in range(self.rng.randrange(1, 4)):
            self.rng.choice([document.undo, document.undo, document.redo])()

    def do_transaction(self):
        document = self.document
        document.openTransaction("Random")
        self.rng.choice([self.do_change_path, self.do_change_setting, self.do_description, self.do_analyze_and_mark])()
        if document.Name in FreeCAD.listDocuments():
            self.rng.choice([document.commitTransaction, document.abortTransaction])()

    def do_copy(self):
        obj, there = self.an_operation(), self.document
        if obj is not None:
            with suppress(getattr(FreeCAD.Base, "XMLParseException", ())):  # FreeCAD 1.0 cannot copy control characters
                there.copyObject(obj, self.rng.random() < 0.3)

    def do_delete(self):
        obj = self.an_object()
        if obj is not None and obj.TypeId not in OF_ORIGIN:
            obj.Document.removeObject(obj.Name)

    def do_close(self):
        FreeCAD.closeDocument(self.document.Name)

    def do_save_and_open(self):
        document = self.document
        path = str(Path(self.folder.name) / f"{document.Name}.FCStd")
        document.saveAs(path)
        FreeCAD.closeDocument(document.Name)
        document = FreeCAD.openDocument(path)
        idle()
        if not FreeCAD.GuiUp:  # with a window, the add-on itself compares the marks of an opened document
            from vkworkbench.document.marks import watcher

            watcher.check(document)
        document.UndoMode = 1

    def do_preferences(self):
        group = FreeCAD.ParamGet(preferences.GROUP)
        names = [preferences.entry(name) for name in preferences.Preferences.__dataclass_fields__]
        for name in self.rng.sample(names, 3):
            how = self.rng.randrange(5)
            if how == 0:
                group.SetBool(name, self.rng.random() < 0.5)
            elif how == 1:
                group.SetInt(name, self.rng.choice([-1, 0, 1, 50, 2**31 - 1]))
            elif how == 2:
                # FreeCAD itself crashes at 1e300, because it has room for 255 digits only
                group.SetFloat(name, self.rng.choice([-1.0, 0.0, 0.5, 1e30, 1e-30]))
            elif how == 3:
                group.SetString(
                    name, self.rng.choice(["legacy", "OpenGL", "z-buffer", "own", "Front", "Isometric", *TEXTS])
                )
            else:
                group.Clear()
        group.SetInt("ImageWidth", 80)
        group.SetInt("ImageHeight", 60)

    def do_calibration(self):
        if self.rng.random() < 0.7:  # a damaged calibration is measured again, which takes a second
            return
        path = calibration_file()
        path.parent.mkdir(parents=True, exist_ok=True)
        try:
            data = json.loads(path.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            data = {"z-buffer": {}}
        at = data
        while isinstance(at, dict) and at:
            key = self.rng.choice(sorted(at))
            if not isinstance(at[key], dict) or not at[key] or self.rng.random() < 0.2:
                at[key] = self.rng.choice(JSON)
                break
            at = at[key]
        text = json.dumps(data)
        path.write_text(text if self.rng.random() < 0.8 else text[: len(text) // 2], encoding="utf-8")
        left = set(path.parent.iterdir())
        vkworkbench.analyze(self.document)
        assert set(path.parent.iterdir()) == left, "a temporary file was left"

    def do_simulate(self):
        view = vkworkbench.core.View((0, 0, -1), 40, 30)
        with suppress(Unusable):
            str(vkworkbench.simulate(self.something_with_toolpaths(), view=view).facts)

    # The following actions need the window.

    def click_analyze(self):
        self.click("Vk_Analyze")

    click_analyze_once_more = click_analyze

    def click_clear(self):
        self.click("Vk_Clear")

    def click_results(self):
        self.click("Vk_Results")

    def click_gauss_map(self):
        self.click("Vk_GaussMap")

    def click_strategies(self):
        self.click("Vk_Strategies", self.rng.randrange(2))

    def click_simulate(self):
        self.click("Vk_Simulate")
        idle(0.3)
        if self.rng.random() < 0.8:
            from vkworkbench.gui.qt import widgets
            from vkworkbench.gui.simulation.tab import SimulationTab

            for tab in widgets.find(SimulationTab):
                tab.window_of().close()

    def click_select(self):
        Gui.Selection.clearSelection()
        for _ in range(self.rng.randrange(3)):
            obj = self.an_object()
            if obj is not None:
                Gui.Selection.addSelection(obj)

    click_select_more = click_select

    def click_document(self):
        FreeCAD.setActiveDocument(self.document.Name)

    def click_visibility(self):
        obj = self.an_object()
        if obj is not None:
            obj.ViewObject.Visibility = not obj.ViewObject.Visibility

    def click(self, name, item=0):
        if FreeCAD.ActiveDocument is not None:
            Gui.runCommand(name, item)


def find_all(what):
    try:
        return [o.object for o in find(what)]
    except TypeError:
        return []


def calibration_file():
    return Path(FreeCAD.getUserAppDataDir()) / "ToolpathAnalysis" / "calibration.json"


def idle(seconds=0.05):
    """Let FreeCAD's window work until no work is pending."""
    if FreeCAD.GuiUp:
        end = time.monotonic() + seconds
        while time.monotonic() < end or waiting():
            events.happen()


def waiting():
    from vkworkbench.document.computer import idle as waits

    return bool(waits._works or waits._calls)


def answer():
    """Close an open dialog: a message box by its last button, another dialog by Esc."""
    box = QtGui.QApplication.activeModalWidget()
    if isinstance(box, QtGui.QMessageBox):
        box.buttons()[-1].click()
    elif isinstance(box, QtGui.QDialog) and not isinstance(box, QtGui.QProgressDialog):
        box.reject()
    if isinstance(box, QtGui.QProgressDialog) and random.random() < 0.3:
        box.cancel()


def tracebacks(log, start):
    """Return the tracebacks of this add-on after a position in the log, and the end of the log."""
    sys.stdout.flush()
    sys.stderr.flush()
    with open(log, encoding="utf-8", errors="replace") as file:
        file.seek(start)
        text = file.read()
        end = file.tell()
    found, block = [], None
    for line in text.splitlines():
        if "Traceback (most recent call last)" in line:
            block = [line]
            found.append(block)
        elif block is not None:
            block.append(line)
            if line and not line.startswith(" "):
                block = None
    return [
        text for text in map("\n".join, found) if f"{ROOT}/vkworkbench" in text or "/ToolpathAnalysis/" in text
    ], end


def main():
    seed, minutes, *most = map(float, os.environ["VKWORKBENCH_FUZZ"].split())
    seed, most = int(seed), most[0] if most else float("inf")
    log = os.environ["VKWORKBENCH_FUZZ_LOG"]
    until, done, failed, at = time.monotonic() + 60 * minutes, 0, 0, os.path.getsize(log)
    if FreeCAD.GuiUp:
        Gui.activateWorkbench("VkWorkbench")
        timer = QtCore.QTimer()
        timer.timeout.connect(answer)
        timer.start(50)
    faulthandler.register(signal.SIGPROF, chain=True)  # write the traceback, then let the signal end the process
    while time.monotonic() < until and done < most:
        faulthandler.dump_traceback_later(STILL, exit=True)
        signal.setitimer(signal.ITIMER_PROF, LONGEST)
        print(f"seed {seed}", flush=True)
        session, error = Session(seed), None
        try:
            session.run()
        except Exception:
            error = traceback.format_exc()
        try:
            session.end()
        except Exception:
            error = error or traceback.format_exc()
        seen, at = tracebacks(log, at)
        if error or seen:
            failed += 1
            print(f"\nFAILED: seed {seed} after {', '.join(session.done)}\n{error or ''}", *seen, sep="\n", flush=True)
            _, at = tracebacks(log, at)
        done, seed = done + 1, seed + 1
    where = "in the window" if FreeCAD.GuiUp else "without a window"
    print(f"{done} sessions {where}, the last of seed {seed - 1}: {failed} failed", flush=True)
    return 1 if failed or not done else 0


if "VKWORKBENCH_FUZZ" in os.environ:
    if FreeCAD.GuiUp:
        import events
        import FreeCADGui as Gui
        from PySide import QtCore, QtGui
    run_and_leave(main)
