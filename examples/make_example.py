# SPDX-License-Identifier: LGPL-2.1-or-later
"""Build the example job, a plate with one operation of every common kind, and save it.

    freecadcmd "$PWD/examples/make_example.py"     # writes build/example.FCStd

The environment variable VKWORKBENCH_EXAMPLE names another file. The script runs in FreeCAD 0.20, 1.0 and 1.1, with or
without a window. Only with a window, the operations have the icons and editors of FreeCAD's own commands.
"""

from __future__ import annotations

import importlib
import math
import os
import sys
import tempfile

import FreeCAD
import Part
from FreeCAD import Vector

VERSION = tuple(map(int, FreeCAD.Version()[:2]))
LENGTH, WIDTH, HEIGHT = 160.0, 100.0, 20.0  # mm; the plate's lower corner is the origin
ALLOWANCE = Vector(2, 2, 0), Vector(2, 2, 1.5)  # mm of raw stock on the plate's lower and upper sides

# FreeCAD 1.x calls its CAM modules Path.X and Path.Gui.X. FreeCAD 0.20 calls the same modules PathX and PathXGui, with
# these exceptions.
OLD_NAMES = {
    "Op.Gui.Base": "PathOpGui",
    "Tool.Bit": "PathToolBit",
    "Tool.Controller": "PathToolController",
    "Dressup.Tags": "PathDressupHoldingTags",
    "Dressup.Gui.Tags": "PathDressupTagGui",
    "Post.scripts.gcode_pre": "post.gcode_pre",
}


def cam(name):
    """Return FreeCAD's CAM module whose name in 1.x is Path.`name`."""
    if VERSION >= (1, 0):
        return importlib.import_module("Path." + name)
    package, _, last = name.rpartition(".")
    old = OLD_NAMES.get(name) or "Path" + last + ("Gui" if package.endswith("Gui") else "")
    return importlib.import_module("PathScripts." + old)


def box(x, y, z, length, width, height):
    return Part.makeBox(length, width, height, Vector(x, y, z))


def cylinder(x, y, z, radius, height):
    return Part.makeCylinder(radius, height, Vector(x, y, z))


def plate():
    """Return the part to be milled, a solid in mm."""
    solid = box(0, 0, 0, LENGTH, WIDTH, HEIGHT)
    holes = [(8, 8), (152, 8), (8, 92), (152, 92)]  # holes in the four corners; the next two lines add a bolt circle
    angles = [math.radians(angle) for angle in range(0, 360, 60)]
    holes += [(134 + 13 * math.cos(angle), 70 + 13 * math.sin(angle)) for angle in angles]
    cuts = [
        box(18, 14, 12, 44, 34, 8),
        box(70, 14, 14, 42, 34, 6).cut(cylinder(91, 31, 14, 5, 6)),  # a pocket around a round island
        box(18, 56, 10, 46, 14, 10).fuse(box(18, 56, 10, 18, 32, 10)),  # an L-shaped pocket
        cylinder(134, 31, 0, 12, HEIGHT),
        Part.makeSphere(30, Vector(94, 72, HEIGHT + 24)),
    ]
    return solid.cut(cuts + [cylinder(x, y, 0, 2.5, HEIGHT) for x, y in holes]).removeSplitter()


def faces(shape, surface, lower, upper):
    """Return the names of the faces of the `surface` type inside the box from `lower` to `upper`, mm."""
    inside = FreeCAD.BoundBox(*lower, *upper)
    inside.enlarge(1e-3)
    return [
        f"Face{number}"
        for number, face in enumerate(shape.Faces, 1)
        if face.Surface.TypeId == "Part::Geom" + surface and inside.isInside(face.BoundBox)
    ]


def tool_controller(doc, number, label, shape, diameter, feed):
    """Make a tool of `diameter` mm; `shape` is the file with the tool's shape in FreeCAD's tool library."""
    try:
        from Path.Tool.toolbit import ToolBit  # 1.1

        tool = ToolBit.from_shape_id(shape).attach_to_doc(doc=doc)
    except ImportError:
        tool = cam("Tool.Bit").Factory.Create(label, shape)
        tool.Proxy.unloadBitBody(tool)
    tool.Label = label
    tool.Diameter = diameter
    if tool.ViewObject:
        tool.ViewObject.Visibility = False
    controller = cam("Tool.Controller").Create("TC: " + label, tool, number)
    controller.HorizFeed = controller.VertFeed = f"{feed} mm/min"
    controller.SpindleSpeed = 12000
    return controller


def operation(job, kind, label, controller, base=(), **properties):
    """Add an operation of `kind` on the faces `base` of the model to `job`."""
    op = cam("Op." + kind).Create(kind)
    op.ToolController = controller
    op.Label = label
    if base:
        op.Base = [(job.Model.Group[0], list(base))]
    for name, value in properties.items():
        if not hasattr(op, name):
            raise AttributeError(f"{label} has no {name}")
        # Remove FreeCAD's expression, which computes the depth or step from the tool and the job.
        op.setExpression(name, None)
        setattr(op, name, value)
    if op.ViewObject:
        resources = cam("Op.Gui." + kind).Command.res
        op.ViewObject.Proxy = cam("Op.Gui.Base").ViewProvider(op.ViewObject, resources)
    job.Document.recompute()
    return op


def holding_tags(job, profile):
    """Dress up `profile` with holding tags and put the result in its place."""
    dressup = cam("Dressup.Tags").Create(profile)
    dressup.Label = "Cut out with tags"
    dressup.Width, dressup.Height, dressup.Angle = 8, 3, 45
    if dressup.ViewObject:
        dressup.ViewObject.Proxy = cam("Dressup.Gui.Tags").PathDressupTagViewProvider(dressup.ViewObject)
    # Without a window, FreeCAD does not remove the dressed-up operation from the job's list.
    job.Operations.Group = [op for op in job.Operations.Group if op != profile]
    job.Document.recompute()
    return dressup


def make_example(path):
    """Build the example job in a new document and save it to `path`; the document stays open and is returned.

    If OpenCAMLib is not installed, the 3D surface is left out, and a line is printed.
    """
    doc = FreeCAD.newDocument("Example")
    model = doc.addObject("Part::Feature", "Plate")
    model.Shape = shape = plate()

    if FreeCAD.GuiUp:
        job = cam("Main.Gui.Job").Create([model], openTaskPanel=False)
    else:
        job = cam("Main.Job").Create("Job", [model])
    job.Stock.ExtXneg, job.Stock.ExtYneg, job.Stock.ExtZneg = ALLOWANCE[0]
    job.Stock.ExtXpos, job.Stock.ExtYpos, job.Stock.ExtZpos = ALLOWANCE[1]
    job.SetupSheet.HorizRapid = job.SetupSheet.VertRapid = "5000 mm/min"
    doc.recompute()

    (default,) = job.Tools.Group
    job.Tools.Group = []
    for obj in (default, default.Tool):
        doc.removeObject(obj.Name)
    cutter = tool_controller(doc, 1, "End mill 16 mm", "endmill.fcstd", 16, 1200)
    small = tool_controller(doc, 2, "End mill 6 mm", "endmill.fcstd", 6, 800)
    drill = tool_controller(doc, 3, "Drill 5 mm", "drill.fcstd", 5, 200)
    ball = tool_controller(doc, 4, "Ball end mill 6 mm", "ballend.fcstd", 6, 1000)
    # If the job has several tools, FreeCAD asks the user for the tool of the first operation, which fails without a
    # window. Therefore the job has only one tool at first.
    job.Proxy.addToolController(cutter)

    pattern = "ClearingPattern" if VERSION >= (1, 1) else "OffsetPattern"
    top = faces(shape, "Plane", (0, 0, HEIGHT), (LENGTH, WIDTH, HEIGHT))
    operation(
        job,
        "MillFace",
        "Face",
        cutter,
        top[:1],
        BoundaryShape="Stock",
        StepOver=60,
        StepDown=1.5,
        **{pattern: "ZigZag"},
    )
    floor = faces(shape, "Plane", (18, 14, 12), (62, 48, 12))
    operation(job, "PocketShape", "Pocket zigzag", small, floor, StepOver=50, StepDown=4, **{pattern: "ZigZag"})
    floor = faces(shape, "Plane", (70, 14, 14), (112, 48, 14))
    operation(job, "PocketShape", "Pocket around island", small, floor, StepOver=40, StepDown=3, **{pattern: "Offset"})
    floor = faces(shape, "Plane", (18, 56, 10), (64, 88, 10))
    operation(job, "Adaptive", "Adaptive pocket", small, floor, StepDown=5, StepOver=25)
    bore = faces(shape, "Cylinder", (122, 19, 0), (146, 43, HEIGHT))
    operation(job, "Helix", "Bore", small, bore, StepDown=2)
    holes = [
        name
        for name in faces(shape, "Cylinder", (0, 0, 0), (LENGTH, WIDTH, HEIGHT))
        if shape.getElement(name).Surface.Radius < 3
    ]
    operation(job, "Drilling", "Drill holes", drill, holes, PeckEnabled=True, PeckDepth=5)
    try:
        dish = faces(shape, "Sphere", (0, 0, 0), (LENGTH, WIDTH, HEIGHT))
        # With its default deflections, FreeCAD needs half a minute for the 3D surface.
        operation(
            job,
            "Surface",
            "Dish",
            ball,
            dish,
            CutPattern="ZigZag",
            StepOver=15,
            LinearDeflection=0.02,
            AngularDeflection=0.3,
        )
    except ImportError as error:
        print(f"The 3D surface is left out: {error}")
    profile = operation(job, "Profile", "Cut out", small, StepDown=5)
    holding_tags(job, profile)

    for controller in (small, drill, ball):
        job.Proxy.addToolController(controller)
    doc.recompute()
    doc.saveAs(str(path))
    return doc


def spiral_program():
    """Return the text of a program without comments that roughs the dish in two spirals."""
    lines = ["G21 G90", "M6 T2", "G0 Z26"]
    for depth, turns in ((18.5, 4), (17, 3)):
        lines += ["G0 X94 Y72", f"G1 Z{depth} F300"]
        for step in range(1, 36 * turns + 1):
            angle, radius = math.radians(10 * step), 2.5 * step / 36  # a stepover of 2.5 mm
            lines.append(f"G1 X{94 + radius * math.cos(angle):.3f} Y{72 + radius * math.sin(angle):.3f} F800")
        lines.append("G0 Z26")
    return "\n".join(lines)


def add_surprises(doc):
    """Add an imported program, and set a pattern without a recompute, so that a toolpath contradicts its pattern."""
    job = doc.getObject("Job")
    before = job.Operations.Group
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "O1234.nc")
        with open(path, "w") as file:
            file.write(spiral_program())
        cam("Post.scripts.gcode_pre").insert(path, doc.Name)
    (program,) = [op for op in job.Operations.Group if op not in before]
    program.Label = "O1234"
    # The operation that cuts out the plate stays the last one.
    job.Operations.Group = [*before[:-1], program, before[-1]]
    doc.recompute()
    pocket = next(op for op in job.Operations.Group if op.Label == "Pocket around island")
    setattr(pocket, "ClearingPattern" if VERSION >= (1, 1) else "OffsetPattern", "ZigZag")


# FreeCAD imports the script that it runs, so `__name__` is not always "__main__"; the command line names the script.
if __name__ == "__main__" or any(os.path.basename(word) == "make_example.py" for word in sys.argv):
    path = os.environ.get("VKWORKBENCH_EXAMPLE", "build/example.FCStd")
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    make_example(path)
    print("Saved", path)
