# SPDX-License-Identifier: LGPL-2.1-or-later
"""An NC program is divided into operations by titles, tool changes, and descriptions of tools in comments."""

import math

import pytest

from vkworkbench.core.gcode.comments.sections import split_sections
from vkworkbench.core.gcode.comments.titles import title_of
from vkworkbench.core.gcode.comments.tool_table import number_named, tells_inches, tool_told
from vkworkbench.core.gcode.reader import read_program

CUT = "G0 X0 Y0 Z5\nG1 Z-1 F100\nX10\nG0 Z5\n"


def sections(text):
    return [(s.title, s.number, s.tool and s.tool.diameter) for s in split_sections(read_program(text))]


@pytest.mark.parametrize(
    ("comment", "number", "shape", "diameter"),
    [
        ("T1 D=6.35 CR=0. - ZMIN=-3. - flat end mill", 1, "endmill", 6.35),
        ("T12  D=8. CR=4. - ZMIN=-3. - ball end mill", 12, "ballend", 8),
        ("T3 D=10 CR=1.5 - ZMIN=0 - bullnose end mill", 3, "bullnose", 10),
        ("T4 D=12 CR=0 TAPER=45deg - ZMIN=-1 - chamfer mill", 4, "vbit", 12),
        ("T7 D=5 CR=0. TAPER=118deg - ZMIN=-13. - drill", 7, "drill", 5),
        ("T5 D=3.175 CR=0 - ZMIN=-4.3 - Schaftfräser", 5, "endmill", 3.175),
        ("T6 : 6.0", 6, "endmill", 6),
        ("TOOL/MILL,6.0,3.0,20.0,0", None, "ballend", 6),
        ("TOOL/MILL,6.0", None, "endmill", 6),
        ("TOOL/DRILL,4.0,118.0,20.0", None, "drill", 4),
        ("Tool: End Mill {0.25 inch}", None, "endmill", 6.35),
        ("Tool: End Mill (6 mm)", None, "endmill", 6),
        ('End mill 1/8"', None, "endmill", 3.175),
        ("1 1/4 FACE MILL", None, "endmill", 31.75),
        ("Fräser 3mm", None, "endmill", 3),
        ("tool_radius = 1.5", None, "endmill", 3),
        ("toolRadius = 1.5", None, "endmill", 3),
        ("toolDiam: 3.175", None, "endmill", 3.175),
        ("toolDiameter=3.175", None, "endmill", 3.175),
        ("6MM CRB 2FL 19 LOC", None, "endmill", 6),
        ("T4 | 3/8 FLAT ENDMILL | H4", 4, "endmill", 9.525),
        ("T1 3/8 HSC STUB DRILL", 1, "drill", 9.525),
        ("T2 - 1/4 3FL ACME 12345 EM", 2, "endmill", 6.35),
        ("T12 3/8 90 DEG 4FL CHAMFER MILL", 12, "vbit", 9.525),
        ("T5 1-1/2 TOP FACE MILL", 5, "endmill", 38.1),
        ("Change to 11mm / .433 Drill", None, "drill", 11),
        ("T3 6 mm/0.236 ENDMILL", 3, "endmill", 6),
        ("0mm / .433 Drill", None, "drill", 0.433),
        ("TWISTDRILL D16", None, "drill", 16),
        ("1.5 KEY CUTTER .0938", None, "endmill", 1.5),
        ("T3 3/4 WOODRUFF CUTTER .125", 3, "endmill", 19.05),
        ("FACINGTOOL D50", None, "endmill", 50),
        ("T1 2IN 7FL FLYCUTTER", 1, "endmill", 50.8),
        ("T9 1/4-20 TAP", 9, "endmill", 6.35),
        ("5MM DRILL FOR M6 TAP", None, "drill", 5),
        ('T01 = 1/2"  END MILL    03-0086', 1, "endmill", 12.7),
        ("TOOL - 239 DIA. OFF. - 239 LEN. - 239 DIA. - .5", 239, "endmill", 0.5),
        ("T1    CENTR3           DIA.- 3.", 1, "endmill", 3),
        ("Tool: D = 3.0 mm  type END flutes 2", None, "endmill", 3),
        ("TC: 5mm_Endmill001", None, "endmill", 5),
        ("Change tool: HSS 2-Flute Endmill, 2mm", None, "endmill", 2),
        ("T02 ID=002  DIA-0.5000    1/2 ENDMILL", 2, "endmill", 12.7),
        ('Tool: 2" Surfacing End Mill', None, "endmill", 50.8),
        ("TOOL:T24- 12 DIA 50.0 MCL END MILL", 24, "endmill", 12),
        (".375_3/8 X 90 DEG. SPOT DRILL", None, "vbit", 9.525),
        (".3281_21/64 PARABOLIC DRILL", None, "drill", pytest.approx(8.3337, abs=1e-3)),
        (".5_1/2 SPOT DRILL .06 TO.125 DIA.", None, "vbit", 12.7),
        ("Tool Diameter: 3,175", None, "endmill", 3.175),
        ("T2 = End Mill {0.5 inches}", 2, "endmill", 12.7),
        ('TOOL - 6 2"  FACE MILL    DIA. OFF. - 6  LEN. - 6  DIA. - 50.8', 6, "endmill", 50.8),
        ("T3|NO. 7 DRILL|H3|D3|TOOL DIA. - 5.1", 3, "drill", 5.1),
        ("TOOL 1 1/4 END MILL", 1, "endmill", 6.35),
        ("Tool: 1/4 in Carbide End Mill", None, "endmill", 6.35),
        ("T01 FRAISE 2T D10", 1, "endmill", 10),
        ('V-Bit {90 deg 0.5"}', None, "vbit", 12.7),
        ("Сверло 3мм", None, "drill", 3),
        ("T4 10 X 72 ENDMILL", 4, "endmill", 10),
        ("T4 10x72mm end mill", 4, "endmill", 10),
        ("6MM X 20MM LOC ENDMILL", None, "endmill", 6),
        ("6MM 25 LONG END MILL", None, "endmill", 6),
        ("T3 6MM 25 LONG END MILL", 3, "endmill", 6),
        ("T3 6 LONG END MILL 50MM", 3, "endmill", 6),
        ("2X 6MM ENDMILL", None, "endmill", 6),
        ("STOCK 100 X 50 X 20MM TOOL 10MM ENDMILL", None, "endmill", 10),
        ("USE 6 INCH VISE AND 1/2 END MILL", None, "endmill", 12.7),
        ("1/4 IN SHANK 1/8 FLAT END MILL", None, "endmill", 3.175),
        ("T2 NO. 7 DRILL 5.1MM", 2, "drill", 5.1),
        ("WERKZEUG 3 FRAESER 12MM", 3, "endmill", 12),
        ("WERKZEUG 3 FRAESER D12 R1", 3, "endmill", 12),
        ("Werkzeug: 12 mm Fräser", None, "endmill", 12),
        ("WKZ 3 FRAESER D12", 3, "endmill", 12),
        ("Wkz.-Nr. 3 Fräser 12 mm", 3, "endmill", 12),
        ("OUTIL 3 FRAISE D12", 3, "endmill", 12),
        ("HERRAMIENTA 3 FRESA D12", 3, "endmill", 12),
        ("UTENSILE 3 FRESA D12", 3, "endmill", 12),
        ("NARZĘDZIE 3 FREZ D12 END MILL", 3, "endmill", 12),
        ("OP 3 ENDMILL D12", None, "endmill", 12),
        ("STATION 3 ENDMILL 12MM", None, "endmill", 12),
        ("STATION 3 ENDMILL D12", None, "endmill", 12),
        ("12 ENDMILL 50MM LONG", None, "endmill", 12),
        ("0.5 ENDMILL 2IN LOC", None, "endmill", 0.5),
        ("T3 10 ENDMILL 25MM", 3, "endmill", 10),
        ("T3 D3 H3 FACE MILL D50", 3, "endmill", 50),
        ("T5 H25 D25 12MM ENDMILL", 5, "endmill", 12),
        ("T6 D=6 H6 - flat end mill", 6, "endmill", 6),
        ("T1 5/16-18 TAP", 1, "endmill", 7.9375),
        ("1/4-20 TAP", None, "endmill", 6.35),
        ("TOOL 2 1 1/4 - 7 UNC TAP", 2, "endmill", 31.75),
        ("1/2 TAP", None, "endmill", 12.7),
        ("TOOL 4 = M8 X 1.25 TAP", 4, "endmill", 8),
        ("M8-1.25 TAP", None, "endmill", 8),
        ("M8 TAP", None, "endmill", 8),
        ("T4 10MM TAP 1.5MM PITCH", 4, "endmill", 10),
        ("T01  1.118mm 0.0440in 0.0000in 0.0000in", 1, "endmill", 1.118),
        ("Tool Size: 0.1778", None, "endmill", 0.1778),
        ("T5 10 SPOT DRILL", 5, "vbit", 10),
        ("T2 6MM CENTRE DRILL", 2, "vbit", 6),
        ("T2 D=4 - center drill", 2, "vbit", 4),
        ("T3 12MM CENTER CUTTING ENDMILL", 3, "endmill", 12),
        ("1/2 90 SPOT DRILL", None, "vbit", 12.7),
    ],
)  # fmt: skip
def test_tool_comments_of_cam_systems_are_read(comment, number, shape, diameter):
    told = tool_told(comment, inches=False)
    assert (told.number, told.tool.shape) == (number, shape)
    assert told.tool.diameter == pytest.approx(diameter)


def test_corner_radius_and_tip_angle_of_a_tool_are_read():
    assert tool_told("T3 D=.5 CR=.06 - bullnose end mill", inches=True).tool.corner_radius == pytest.approx(1.524)
    mill = tool_told("TOOL/MILL,.5,.06,2.0,0", inches=True).tool
    assert (mill.shape, mill.diameter, mill.corner_radius) == ("bullnose", pytest.approx(12.7), pytest.approx(1.524))
    assert tool_told("T3 D=.5 - flat end mill", inches=True).tool.diameter == pytest.approx(12.7)
    assert tool_told("T3 D=12mm - flat end mill", inches=True).tool.diameter == 12
    assert tool_told("T4 D=12 TAPER=45deg - chamfer mill", inches=False).tool.tip_angle == pytest.approx(math.pi / 2)
    assert tool_told("T7 D=5 TAPER=118deg - drill", inches=False).tool.tip_angle == pytest.approx(math.radians(118))
    assert tool_told("V-Bit 60° 12mm", inches=False).tool.tip_angle == pytest.approx(math.pi / 3)
    assert tool_told("V-Bit 12mm", inches=False).tool.tip_angle is None
    assert tool_told("1/4 60 V-BIT", inches=False).tool.tip_angle == pytest.approx(math.pi / 3)
    assert tool_told("V-Bit 180.5 deg 12mm", inches=False).tool.tip_angle is None
    assert tool_told("T1 3/8 FLAT ENDMILL 2in LOC", inches=False).tool.diameter == pytest.approx(9.525)
    assert tool_told("TOOL 2mm END MILL of 3 mm drill", inches=False).tool.diameter == 2


def test_unit_of_a_tool_in_a_comment_is_read_with_its_size():
    for comment in (
        "6mm end mill",
        "6mm x 20mm end mill",
        "6x20mm end mill",
        "6 x 20 mm carbide",
        "stock 2 in, 6mm end mill",
    ):
        assert tool_told(comment, inches=True).tool.diameter == 6, comment
    assert tool_told("1in face mill", inches=False).tool.diameter == 25.4
    assert tool_told("M8 X 1.25 TAP", inches=True).tool.diameter == 8
    # FreeCAD converts the moves of its programs to inches, but not the tool's diameter in a comment.
    assert tool_told("Compensated Tool Path. Diameter: 4.7498", inches=True).tool.diameter == 4.7498
    assert tool_told("T1 5/16-18 TAP", inches=True).tool.diameter == pytest.approx(7.9375)


@pytest.mark.parametrize(
    ("fractions", "diameter"), [("", 6.35), ("1/3", 6.35), ("0/0", 6.35), ("6 35/100", 6.35), ("127/20", 161.29)]
)
def test_tool_size_repeated_as_fraction_is_in_inches(fractions, diameter):
    assert tool_told(f"T2 D=6.35 {fractions} - flat end mill", inches=False).tool.diameter == pytest.approx(diameter)


def test_too_large_size_or_too_long_comment_is_not_a_tool():
    assert tool_told("face mill 500 mm", inches=False).tool.diameter == 500
    assert tool_told("face mill 501 mm", inches=False) is None
    name = "end mill of the green box " + 29 * "x" + " 6 mm"
    assert (len(name), tool_told(name, inches=False).tool.diameter) == (60, 6)
    assert tool_told(name.replace("box", "case"), inches=False) is None


@pytest.mark.parametrize(
    "comment",
    ["2D Pocket3", "T1", "MANUAL TOOL CHANGE TO T5", "tool change at 0.0 0.0 17.0", "Drill 4 holes", "D=5", "",
     "Job mode = 2, DRILL", "Cutter comp LEFT (D1 = tool radius register)", "BACK 1400 END MILL 20 MINUTES", "1055_utab_265bit",
     "Engraving a 37 tick, 1.700 dia bezel", "Bit sizes: [0.8mm] [1mm]", "Face milling 3x3 inch block", 'Cutter does not descend more than 0.94" below top', "15mm square cut test for laser cutter",
     "Tool length 30 mm", "stock 20 mm x 30 mm", "T2 D=0 - flat end mill", "T2 D=9999 - end mill",
     "T2 - NO. 7 DRILL", "T2 #7 DRILL", "2 0.209 #4 tap drill", "Number 30 drill", "NR.7 BOHRER", "T3 LETTER F DRILL",
     "D DRILL", "T3 D3 H3 FACE MILL", "T11 H11 D11 ENDMILL", "H07 ENDMILL D7", "WERKZEUG 3 FRAESER", "OP 3 ENDMILL",
     "This file uses 4 drill bit sizes.", "T8 90 SPOT DRILL", "#10-24 TAP", "10-32 TAP", "T5 1/4-18 NPT TAP", "T5 10-32 TAP 50MM LONG", "TAP PULLEY 1/4-20",
     "DRILL FOR M8 TAP", "LETTER F DRILL FOR 5/16-18 TAP", "T3 1/2-13 THREADMILL", "JOB 2 DRILL PIN HOLES", "T1 #4 CARBIDE SPOT DRILL - 20MM L",
     "Feed 500 mm/min", "a story of more than sixty characters about an end mill and a 20 mm plate"],
)  # fmt: skip
def test_comments_without_a_tool_are_not_tools(comment):
    assert tool_told(comment, inches=False) is None


@pytest.mark.parametrize(
    ("comment", "title"),
    [
        ("2D Contour1", "2D Contour1"), ("Pocket: Layer 6", "Pocket: Layer 6"), ("begin operation: Face", "Face"),
        ("No. 3: Part 3", "Part 3"), ("Type:         Engrave", "Engrave"), ("*** SURFACE ***", "SURFACE"),
        ("Taschenfräsen außen", "Taschenfräsen außen"), ("Контур 2", "Контур 2"),
        ("finish operation: Face", ""), ("Plunge rate: 127", ""), ("Layer 3 of 12", ""), ("Path 7", ""),
        ("MOVEMENT_LEAD_IN", ""), ("retract", ""), ("Machine", ""), ("1001", ""), ("Z=-1.5", ""), ("", ""),
        ("Header End", ""), ("pen up", ""), ("Pen up to the wall", "Pen up to the wall"), ("origin: center", ""),
        ("Dia.: 24.15 Rad.: 3.00", ""), ("No.: pocket 3", "No.: pocket 3"),
        ("power(%): 65", ""), ("max_x(mm): 293.457", ""), ("is_rotate: false", ""),
        ("pcb2gcode 1.2.1", ""), ("High     Up        Down     Drill", ""), ("Preprocessor Geometry: default", ""),
        ("generator = PushCutter", ""), ("shape = CylindricalCutter", ""), ("X,Y End: None mm", ""), ("Z Start: None mm", ""),
        ("PYCAM-META-DATA: Version: 0.5.1", ""), ("It is made to work with MACH3 compatible motion controllers.", ""), ("select coordinate system 1", ""), ("Select pocket", "Select pocket"),
        ("Start cutting path id: path10", "path10"), ("End cutting path id: path10", ""), ("Generator cover", "Generator cover"),
        ("PYCAM_TOOLPATH_SETTINGS: END", ""), ("OP_10: POCKET", "OP_10: POCKET"), ("Front_face: Roughing", "Front_face: Roughing"),
        ("select the xy plane", ""), ("Plasma cutting", ""), ("THROUGH CUTTING", ""), ("RUN POINT-PIERCE COMMAND HERE", ""),
        ("Exported by FreeCAD", ""), ("Output Time:2020-01-01 12:30", ""), ("M6 T1", ""), ("-----", ""), ("$SetPartSize(4, 4, 1)", ""), ("Finished.", ""),
        ("Begin Drilling", ""), ("BEGIN CUTTING", ""), ("cutting starts", ""), ("End cut", ""), ("Finish cut", "Finish cut"), ("Drilling", "Drilling"),
        ("Optional stop, check center", ""), ("Block-name: holes", "holes"), ("Block-enable: 1", ""), ("Block-color: #00ff00", ""),
        ("Type: G-code from Geometry", ""), ("Name: board_drl", "board_drl"), ("Type: Groove", "Groove"),
        ("MATERIAL - ALUMINUM MM - 2024", ""), ("Werkstoff: EN AW-6061", ""), ("Material removal 2", "Material removal 2"),
        ("Material Size", ""), ("Post = Router", ""), ("turns laser ON", ""),
        ("Footer", ""), ("HEIGHT OFFSET ON", ""), ("compressor off", ""), ("CUT OFF", "CUT OFF"), ("color: #130df2", "color: #130df2"),
        ("#130df2", ""), ("Facade", "Facade"), ("Block-color: #000000", ""), ("Block-name: Keys", "Keys"),
        ("Block-name: Header", ""), ("R2.5400  P1.000000", ""), ("Optional stop, check the bore", ""), ("AXIS,stop", ""),
        ("fim do programa", ""), ("_gc_nextgen_svg_id:null", ""), ("Select work offset #1", ""), ("SECTION begin", ""),
        ("Start generation of : 1__FINISH SIDE", "1__FINISH SIDE"), ("Exact Path 0.001 tol.", ""), ("Default cutting", ""),
        ("XY plane", ""), ("Produced by drl2gcode.py", ""), ("feed per minute", ""), ("work coordinate system", ""),
        ("starting rough op", "rough"), ("ending rough op after 15 seconds", ""), ("PASS #1 AT -5 DEPTH", ""), ("MOVING TO FIRST POINT", ""),
        ("isPocket: False", ""), ("Generator: aCAM", ""), ("Pocket: outer", "Pocket: outer"), ("unconverted code: SP 1", ""),
        ("TOOLPATH : Rough the cavity", "Rough the cavity"), ("TOOLPATH WP : World", ""), ("STRATEGY USED : Face", ""),
        ("Toolpath", ""), ("Toolpath:- Groove 2", "Groove 2"), ("Operation: Inside Offset, slot, T2: Mill, 3 mm in diameter", "Inside Offset, slot"),
        ("Q0.01", ""), ("Q", ""), ("Linear", ""), ("Arc CCW", ""), ("Rapid traverse", ""), ("Arc mill end", ""), ("Linear slots", "Linear slots"),
        ("Cutter Comp Left", ""), ("Left", ""), ("Left side", "Left side"), ("Set up, no cutter comp,", ""), ("Move to start of contour", ""), ("Programmer: ada", ""),
        ("Laser on", ""), ("Ensure laser off", ""), ("Laser engraving", "Laser engraving"),
        ("Operation 9 of 13 : 2D Contour4", "2D Contour4"), ("(Pocket 1)", "Pocket 1"), ("(safe z)", ""), ("(A) and (B)", "(A) and (B)"),
    ],
)  # fmt: skip
def test_titles_in_comments_are_distinguished_from_remarks(comment, title):
    assert title_of(comment) == title


@pytest.mark.parametrize(
    "comment",
    ["Beginning of Single-pass layer.", "Begin step 0.", "End of step 12.", "part 1.", "PART 12.", "part 3", "Break", "--Break",
     "Layer 2 begins", "Layer transition", "End of layer 2", "Transition to base: Body.", "Start hold", "End hold",
     "End index angle 45.0", "Cut Area 12.5.", "Wire 0.", "Step over %: 15.0", "Sample interval: 1.0", "Tool type: ballend",
     "Compensated Tool Path. Diameter: 6.0", "Begin Thread Milling", "Begin Custom", "End Custom", "inactive operation",
     "operation initialise: Bore", "operation finalised: Bore", "PROBECLOSE", "helix cut operation", "Adaptive - depth: 3.000000"],
)  # fmt: skip
def test_freecad_remark_within_operation_is_not_a_title(comment):
    assert title_of(comment) == ""
    assert title_of("Part 3") == "Part 3"


@pytest.mark.parametrize(
    ("begin", "end"),
    [("begin operation", "finish operation"), ("BEGIN OPERATION", "FINISH OPERATION"), ("begin operation", "end operation"),
     ("operation start", "operation done")],
)  # fmt: skip
def test_comments_inside_freecad_operation_do_not_divide(begin, end):
    operation = f"({begin}: {{0}})\n({{0}})\n(half speed here)\n{CUT}(second half)\n{CUT}({end}: {{0}})\n"
    text = operation.format("Dish") + operation.format("Cut out: a") + f"(Chamfer)\n{CUT}"
    assert sections(text) == [("Dish", None, None), ("Cut out: a", None, None), ("Chamfer", None, None)]
    holes = "".join(
        f"({begin}: {name})\n(Begin Drilling)\n{CUT}({end}: {name})\n" for name in ("Drilling", "Drilling001")
    )
    assert [title for title, _, _ in sections(holes)] == ["Drilling", "Drilling001"]


def test_freecad_tool_controller_begins_untitled_operation():
    change = "(TC: End mill {0} mm)\nG77 ; Move to release position\nM01 Insert tool {0}\n"
    text = f"{change.format(6)}(Face)\n{CUT}{change.format(3)}{CUT}"
    assert sections(text) == [("Face", None, 6), ("TC: End mill 3 mm", None, 3)]


def test_operation_names_of_freecad_and_flatcam_are_titles():
    drilled = "(begin operation: Bolts)\n(Path: Bolts)\n(Bolts)\n(Begin Drilling)\nG81 X5 Y5 Z-3 R2 F9\nG80\n(finish operation: Bolts)\n"
    assert sections(f"{CUT}{drilled}") == [("", None, None), ("Bolts", None, None)]
    assert sections(f"(Name: board_cutout)\n(Type: G-code from Geometry)\n{CUT}") == [("board_cutout", None, None)]


def test_titles_and_tool_changes_divide_a_program():
    text = (
        "%\nO1000 (BRACKET)\n(T1 D=6 CR=0. - ZMIN=-3. - flat end mill)\n(T2 D=3 CR=0. - ZMIN=-3. - ball end mill)\nG21\n"
        f"(Face1)\nT1 M6\n{CUT}(Pocket2)\n{CUT}T2 M6\n{CUT}(Pocket3)\n{CUT}M30\n%"
    )
    program = read_program(text)
    found = split_sections(program)
    assert [(s.title, s.number, s.tool.diameter, s.tool.shape) for s in found] == [
        ("Face1", 1, 6, "endmill"), ("Pocket2", 1, 6, "endmill"), ("", 2, 3, "ballend"), ("Pocket3", 2, 3, "ballend"),
    ]  # fmt: skip
    assert [(s.first, s.last) for s in found] == [(2, 11), (12, 16), (17, 21), (22, 26)]


def test_title_before_and_after_tool_change_is_one_operation():
    assert sections(f"(Slot)\nT1 M6\n{CUT}T2 M6\n(Hole)\n{CUT}") == [("Slot", 1, None), ("Hole", 2, None)]


def test_tool_comments_without_a_number_are_read():
    assert sections(f"T1 M6 (End mill 6mm)\n{CUT}T1 M6 (End mill 3mm)\n{CUT}") == [
        ("End mill 6mm", 1, 6), ("End mill 3mm", 1, 3)
    ]  # fmt: skip
    assert sections(f"(Tool: D = 3.0 mm type END)\n{CUT}") == [("Tool: D = 3.0 mm type END", None, 3)]
    assert sections(f"(T6 D=4 - end mill)\n(Face)\n{CUT}") == [("Face", None, 4)]


def test_tool_comment_in_the_line_of_its_change_is_used():
    next_one = "T2 (NEXT TOOL: 5MM DRILL)\n"
    assert sections(f"T1 M6 (10MM ENDMILL)\n{next_one}{CUT}") == [("10MM ENDMILL", 1, 10)]
    assert sections(f"(20MM FACE MILL)\nT1 M6 (10MM ENDMILL)\n{next_one}{CUT}") == [("10MM ENDMILL", 1, 10)]
    # The last of several tool changes is used. The comment on the tool can be on the line after the tool change.
    assert sections(f"T1 M6 (10MM ENDMILL)\nT2 M6 (5MM DRILL)\n{CUT}") == [("5MM DRILL", 2, 5)]
    assert sections(f"T1 M6 (10MM ENDMILL)\nT2 M6\n(5MM DRILL)\n{CUT}") == [("5MM DRILL", 2, 5)]
    assert sections(f"(10MM ENDMILL)\nT1 M6\n(5MM DRILL)\n{CUT}") == [("5MM DRILL", 1, 5)]
    assert sections(f"(10MM ENDMILL)\n(5MM DRILL)\nT1 M6\n{CUT}") == [("10MM ENDMILL", 1, 10)]


def test_diameter_beside_a_tool_change_is_the_tools_diameter():
    assert sections(f"T1 M6 (D26)\n{CUT}") == [("D26", 1, 26)]
    assert sections(f"N1 T2 M6 (ID=002 - DIA 0.5)\n{CUT}") == [("ID=002 - DIA 0.5", 2, 0.5)]
    assert sections(f"T1 M6 (DRILL 8.5)\n{CUT}") == [("DRILL 8.5", 1, 8.5)]
    assert sections(f"T1 M6 (BALL ENDMILL 1/4)\n{CUT}")[0][2] == 6.35
    assert sections(f"T6 M6 (DIA 6)\n{CUT}") == [("DIA 6", 6, 6)]
    assert sections(f"M6 T24 (0.6 INCH)\n{CUT}")[0][2] == pytest.approx(15.24)
    others = "DRILL 8", "V-BIT 22.5", "TAP 1/4", "ENDMILL 8.5 LOC", "THREAD MILL 1.5", "BORE DIA 40", "4 HOLES DIA 8.5"
    for other in others:
        assert sections(f"T1 M6 ({other})\n{CUT}")[0][2] is None, other
    for offset in ("D1", "D01"):
        assert sections(f"T1 M6 ({offset})\n{CUT}") == [(offset, 1, None)]
    assert sections(f"T1 M6 (D26 X 50)\n{CUT}") == [("D26 X 50", 1, None)]
    assert sections(f"T1 M6\n(D26)\n{CUT}")[0][2] is None


def test_prepared_tool_is_not_the_current_tool():
    assert sections(f"T1 M6\n(10MM ENDMILL)\nT2 (5MM DRILL)\n{CUT}") == [("10MM ENDMILL", 1, 10)]
    assert sections(f"T1 M6\nT2 (5MM DRILL)\n{CUT}M6\n{CUT}") == [("", 1, None), ("", 2, 5)]
    assert sections(f"T1 M6\nT1 (10MM ENDMILL)\n{CUT}") == [("10MM ENDMILL", 1, 10)]
    assert sections(f"T1 M6 (10MM ENDMILL)\n{CUT}T2 (5MM DRILL)\nM6\n{CUT}") == [
        ("10MM ENDMILL", 1, 10), ("5MM DRILL", 2, 5)
    ]  # fmt: skip


def test_tool_comment_after_the_tool_change_is_read():
    two = f"M6\nT1.1 (10MM ENDMILL)\nM0\n{CUT}M6\nT9.9 (5MM DRILL)\n{CUT}"
    assert sections(two) == [("10MM ENDMILL", 1, 10), ("5MM DRILL", 9, 5)]
    assert sections(f"T1\nM6\n{CUT}M6\nT2 (5MM DRILL)\n{CUT}")[-1] == ("5MM DRILL", 2, 5)
    assert sections(f"T1\nM6\nT2 (5MM DRILL)\n{CUT}") == [("", 1, None)]  # T2 only prepares a tool.
    assert sections(f"M6\n{CUT}T2 (5MM DRILL)\n{CUT}")[-1][1] is None  # After a cut, T2 only prepares a tool.


def test_tools_and_remarks_in_chinese_are_read():
    changes = (
        f"(换1号刀: 中心钻φ3mm)\nT1 M6\n{CUT}T2 M6 (钻头φ8mm)\n(主轴正转，800转/分钟)\n{CUT}T3 M6 (6mm球刀)\n{CUT}"
    )
    assert sections(changes + "(程序结束)\nG0 Z50\n") == [
        ("换1号刀: 中心钻φ3mm", 1, 3), ("钻头φ8mm", 2, 8), ("6mm球刀", 3, 6),
    ]  # fmt: skip
    assert [s.tool.shape for s in split_sections(read_program(changes))] == ["vbit", "drill", "ballend"]


def test_cutviewer_tool_comment_applies_from_its_line_on():
    """MeshCAM writes another tool before the program's tool. In a list of tools, the first tool is used first."""
    assert sections(f"(TOOL/MILL,0.1,0.05,0,0)\n(TOOL/MILL,6,0,20,0)\nT1 M6\n{CUT}") == [("", 1, 6)]
    assert sections(f"(TOOL/MILL,0.1,0.05,0,0)\nT1 M6\n(TOOL/MILL,6,0,20,0)\n{CUT}(TOOL/MILL,3,0,9,0)\nT1 M6\n{CUT}") == [
        ("", 1, 6), ("", 1, 3)
    ]  # fmt: skip
    assert sections(f"(End mill 6mm)\n(End mill 3mm)\nT1 M6\n{CUT}") == [("End mill 6mm", 1, 6)]


def test_unnumbered_tool_list_describes_later_tools():
    """hyperMILL lists all tools at the beginning, and repeats the name of a tool at its tool change."""
    tools = ["KOMET-1.0", ".375 STUB END MILL", ".248 REAMER", ".5_1/2 X 90 DEG. SPOT DRILL .06 TO.125 DIA."]
    listed = "".join(f"({tool})\n" for tool in tools)
    changes = "".join(f"(OPERATION {k})\n({tool})\nT{k} M6\n{CUT}" for k, tool in enumerate(tools, 1))
    found = [diameter for _, _, diameter in sections(f"G20\n{listed}{changes}")]
    assert found == [None, pytest.approx(9.525), pytest.approx(6.2992), pytest.approx(12.7)]
    # A comment that is repeated for several tools does not start a tool list.
    same = "".join(f"(PART 7)\n(End mill 6mm)\nT{k} M6\n{CUT}" for k in range(1, 4))
    assert [diameter for _, _, diameter in sections(same)] == [6, 6, 6]


def test_tool_size_in_the_comment_after_its_heading_is_read():
    """pcb-gcode writes "Tool Size" before the number.

    The comment before the tool change describes the tool, and is not the title of an operation.
    """
    assert sections(f"(  Tool Size)\n(0.1778 )\n(spindle speed = 12000)\n{CUT}") == [("", None, 0.1778)]
    assert sections(f"(0.1778)\n{CUT}") == [("", None, None)]
    assert sections(f"(tool_radius = 1.5)\n{CUT}") == [("", None, 3)]


@pytest.mark.parametrize(
    ("name", "size", "shape"),
    [
        ("TOOL NAME: ENDMILL", "DIA=10.0", "endmill"),
        ("TOOL NAME : BALL_MILL", "TOOL DIAMETER : 10.0  LOWER RADIUS : 5.0", "ballend"),
        ("T1 : MILL_1", "DIAMETER : 10.000", "endmill"),
        ("Tool = EM_01", "D = 10.0 , R = 1.0", "endmill"),
    ],
)
def test_tool_name_and_diameter_in_two_comments_are_one_tool(name, size, shape):
    for text in (f"({name})\nN10 ({size})\nT1 M6\n{CUT}", f"T1 M6\n({name})\n({size})\n{CUT}"):
        (section,) = split_sections(read_program(text))
        assert (section.number, section.tool.shape, section.tool.diameter) == (1, shape, 10)
    for apart in (
        f"({name})\n{CUT}(D = 50.0)\n{CUT}",
        f"(TOOL PATH: POCKET)\n(D = 50.0)\n{CUT}",
        f"(BORE)\n(DIA: 50)\n{CUT}",
    ):
        assert all(diameter is None for _, _, diameter in sections("T1 M6\n" + apart))


def test_comments_inside_a_py2gcode_operation_are_no_titles():
    """py2gcode writes several comments inside each operation."""
    begun = "; Begin {0}\n; layers: ['b']\n; closed: True\n; toolDiam: 6.0\n; {0}: rapid move to start x,y\n"
    passes = "".join(f"; {{0}}: pass {k} lead-in\n{CUT}; {{0}}: pass {k} filled rectangle\n{CUT}" for k in (1, 2))
    operation = begun + passes + "; End {0}\n; -----\n"
    text = operation.format("RectPocketXY") + 2 * operation.format("CircBoundaryXY")
    assert sections(text) == [("RectPocketXY", None, 6), ("CircBoundaryXY", None, 6)]
    assert sections(f"(Begin Roughing)\n{CUT}(Pocket 1)\n{CUT}") == [
        ("Begin Roughing", None, None),
        ("Pocket 1", None, None),
    ]
    last = f"; Begin One\n; pass 1\n{CUT}; End One\n; Chamfer\n{CUT}"
    assert sections(last) == [("One", None, None), ("Chamfer", None, None)]


def test_operation_keeps_the_tool_described_before_its_title():
    assert sections(f"(END MILL 6MM)\n(POCKET)\n{CUT}") == [("POCKET", None, 6)]


def test_tool_without_description_after_a_change_has_no_size():
    assert sections(f"T1 M6 (End mill 6mm)\n{CUT}T2 M6\n{CUT}") == [("End mill 6mm", 1, 6), ("", 2, None)]


def test_title_between_plunge_and_cut_does_not_divide():
    """Hand-written programs have titles between plunge and cut.

    The plunge alone, without the cut after the title, would be recognised as drilling.
    """
    assert [title for title, _, _ in sections(f"(Sides)\nG0 X0 Y0\nG1 Z1 F9\nZ-2\n(Rough)\nX10\nY5\n(Wall)\n{CUT}")] == [
        "Rough", "Wall"
    ]  # fmt: skip
    # A hole counts as a cut, even if the next title comes before the retract from the hole.
    for hole in ("G1 Z-2 F9\n(Second)\nG0 Z5\n", "G1 Z-2 F9\n(Second)\nG1 Z5\n", "G1 Z-2 F9\nG0 Z5\n(Second)\n"):
        assert len(sections(f"(First)\nG0 X0 Y0\n{hole}X5\nG1 Z-2\n")) == 2


def test_numbered_passes_do_not_divide_a_program():
    passes = "".join(f"(Pass {k})\n{CUT}(level {k} of 60)\n{CUT}" for k in range(60))
    assert len(sections(f"(Pocket)\n{passes}")) == 1
    numbered = "".join(f"(Strich {k})\n{CUT}" for k in range(60))
    assert len(sections(numbered)) == 1


def test_repeated_title_with_a_number_is_another_operation():
    text = "".join(f";Operation: {k}\n;Type: Pocket\n{CUT}" for k in range(3))
    assert [title for title, _, _ in sections(text)] == ["Pocket"] * 3
    assert len(sections(f"(Pocket)\n{CUT}(Pocket)\n{CUT}")) == 1


def test_line_without_g_code_continues_the_feed_move():
    """Titles divide a program only after the first cut, so cuts must be found even if G1 is several lines above."""
    cut = "X10\nY5\nX0\n"
    assert [title for title, _, _ in sections(f"(One)\nG1 F100\n{cut}(Two)\n{cut}")] == ["One", "Two"]
    # Rapids, and feed words without a move, do not cut, so the title Two replaces the title One.
    assert [title for title, _, _ in sections(f"(One)\nG0 X5 Y5\nX6\nF100\n(Two)\nG1 {cut}")] == ["Two"]


@pytest.mark.parametrize(
    ("tool", "both"), [("T1 DIA-0.5000  1/2 ENDMILL", True), ("T1 DIA-0.5 - OP 3/4", False), ("T1 1/2 ENDMILL", False)]
)
def test_diameter_repeated_as_a_fraction_shows_inches(tool, both):
    assert tells_inches(tool) is both


def test_comment_beside_coolant_is_not_a_title():
    text = "(FACE TOP)\nM08 (Collant On)\nM07 (Mist)\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX50\nG0 Z5\nM9 (dry now)\n"
    assert [section.title for section in split_sections(read_program(text))] == ["FACE TOP"]
    told = split_sections(read_program("T2 M6 M8 (6 mm end mill)\n" + text))
    assert [section.tool.diameter for section in told] == [6]


def test_comment_beside_dwell_or_mode_is_not_a_title():
    assert sections(f"(FACE TOP)\nG91 (in steps)\nG90 G21 (no more)\n{CUT}") == [("FACE TOP", None, None)]
    assert sections(f"(FACE TOP)\nG90 G54 (left part)\n{CUT}") == [("left part", None, None)]
    assert sections(f"(FACE TOP)\nG4 P3 (pause in sec)\n{CUT}") == [("FACE TOP", None, None)]
    assert sections(f"G4 P1 (MSG, change to drill size 1.2 mm)\n{CUT}")[0][2] == 1.2


def test_comment_beside_speed_or_start_is_not_a_title():
    for code in ("S100", "F9", "M3 S100", "N5 M4", "M5"):
        assert [title for title, *_ in sections(f"{code} (beam)\n{CUT}")] == [""]
    assert [title for title, *_ in sections(f"N5 (Groove)\n{CUT}")] == ["Groove"]


def test_sheetcam_title_before_the_tool_change_is_read():
    text = "".join(
        f"(Part: lid)\n(Operation: {name}, T2: Mill, 3 mm in diameter)\nM6 T2 (Mill, 3 mm in diameter)\n{CUT}"
        for name in ("Drill, Holes", "Inside Offset, slot")
    )
    assert sections(text) == [("Drill, Holes", 2, 3), ("Inside Offset, slot", 2, 3)]


def test_comment_in_the_line_of_a_move_is_not_a_title():
    """A comment in the line of a move describes the move.

    From a comment in a move's line, only the description of a tool is used.
    """
    text = "(FACE TOP)\nT2 M6 (6 mm end mill)\nG0 X0 Y0 S1200 M3 (H1)\nG1 Z-1 F100\nX50\nG0 Z5 M5 (back off and stop)\nG1 X0\n"
    assert sections(text) == [("FACE TOP", 2, 6)]


def test_numbered_titles_at_tool_changes_are_operations():
    """Sixty numbered titles are passes of one operation, except if each title has a tool change."""
    changed = "".join(f"(Hole {k})\nT{k} M6\n{CUT}" for k in range(1, 61))
    assert [title for title, _, _ in sections(changed)] == [f"Hole {k}" for k in range(1, 61)]


def test_title_that_names_a_listed_tool_sets_this_tool():
    listed = "(T1 D=6 CR=0 - flat end mill)\n(T2 D=3 CR=0 - flat end mill)\n"
    assert sections(f"{listed}(T2 : rest)\n{CUT}")[0][2] == 3


def test_fusion_title_for_marlin_before_the_tool_is_read():
    """The table of ranges and the instructions to the operator are not titles of operations."""
    header = ";Ranges table:\n; X: Min=0 Max=5 Size=5\n;Tools table:\n"
    listed = "; T1 D=6 CR=0 - ZMIN=-3 - flat end mill\n; T3 D=3 CR=0 - ZMIN=-3 - flat end mill\n"
    second = "M6 ;wait for user interaction\n;2D Contour1 - Milling - Tool: 3 - flat end mill\n"
    first = ";Face1 - Milling - Tool: 1 -  flat end mill\n"
    assert sections(header + listed + first + CUT + second + CUT) == [("Face1", None, 6), ("2D Contour1", None, 3)]
    asked = "(ROUGH)\nT1 M6\nM0\n(MAKE SURE THE SPINDLE IS RUNNING)\n(THEN PRESS CYCLE START)\n"
    assert sections(asked + CUT)[0][0] == "ROUGH"


def test_comment_on_a_toolpath_is_not_a_tool():
    listed = "(T1 D=6 CR=0 - flat end mill)\n(T2 D=3 CR=0 - flat end mill)\nT1 M6\n"
    for title in ("Percurso da ferramenta 2", "Trayectoria de herramienta 2", "Trajectoire d'outil 2"):
        assert sections(f"{listed}({title})\n{CUT}") == [(title, 1, 6)]
        assert number_named(title) is None


def test_long_comments_are_read_quickly():
    for text in ("1" * 50_000, "T1 D=" + "1 " * 20_000, "a: " * 20_000, "-" * 50_000, "end mill " * 5000):
        assert len(sections(f"({text})\n{CUT}")) == 1


def test_operation_without_a_title_is_named_by_its_tool():
    (told,) = split_sections(read_program(f"T2 M6\n(T2 D=3 - ball end mill)\n(T3 D=8 - flat end mill)\n{CUT}"))
    assert (told.title, told.tool.diameter) == ("T2 D=3 - ball end mill", 3)
    assert sections(f"T2\n(MSG, Change to drill size 2 mm)\nM6\n{CUT}")[0][0] == "Change to drill size 2 mm"


def test_operation_begins_with_its_first_line():
    (whole,) = split_sections(read_program(CUT))
    assert (whole.first, whole.last) == (1, 4)


def test_program_without_comments_is_one_operation():
    assert sections(CUT) == [("", None, None)]


def test_only_tool_in_a_list_of_required_tools_is_used():
    program = "G90\n(Required tools:)\n({})\n\nG00 Z5\n(No. 1: Pocket: One)\nG00 X4 Y8\nG01 Z-1 F500\nG01 Y1\n"
    for entries, diameter in (("China 6mm", 6), ("China 6mm)\n(China 3mm", None), ("Whatever", None)):
        (section,) = split_sections(read_program(program.format(entries)))
        assert (section.tool and section.tool.diameter) == diameter


def test_list_of_drill_sizes_is_not_a_title():
    program = "( Bit sizes: [0.8mm] [1mm] )\nG21 G90\nT1\n(MSG, Change tool bit to drill size 0.8mm)\nM6\nG0 X0 Y0 Z5\nG1 Z-1 F60"
    (section,) = split_sections(read_program(program))
    assert section.title == "Change tool bit to drill size 0.8mm" and section.tool.diameter == 0.8


def test_tool_comment_after_a_title_is_not_a_title():
    listed = "(T1 D=1.5 CR=0. - ZMIN=-1. - flat end mill)\n"
    text = "G90 G21\n(Trace1)\nT1 M6\n(wood cutter, blue)\nS5000 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X9\n"
    assert [section.title for section in split_sections(read_program(listed + text))] == ["Trace1"]
    assert [section.title for section in split_sections(read_program(text))] == ["wood cutter, blue"]


@pytest.mark.parametrize(
    ("comment", "number", "shape", "diameter"),
    [
        ("6mm 엔드밀", None, "endmill", 6), ("볼엔드밀 D8", None, "ballend", 8), ("공구 3 직경 4mm", 3, "endmill", 4),
        ("T2 드릴 8.5mm", 2, "drill", 8.5), ("エンドミル φ10", None, "endmill", 10), ("ドリル 3mm", None, "drill", 3),
        ("Фреза Ф6", None, "endmill", 6), ("сверло ф8", None, "drill", 8), ("T1 6平刀", 1, "endmill", 6),
    ],
)  # fmt: skip
def test_tools_in_korean_japanese_and_russian_are_read(comment, number, shape, diameter):
    told = tool_told(comment, inches=False)
    assert (told.number, told.tool.shape, told.tool.diameter) == (number, shape, diameter)


@pytest.mark.parametrize("line", ["#<TOOL_DIAMETER> = 6", "#<_tool_dia>=6.0", "N5 #<tool_diameter> = 6 (mm)"])
def test_tool_diameter_is_read_from_a_named_variable(line):
    program = read_program(f"G21 G90\n{line}\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX40\nM30\n")
    (section,) = split_sections(program)
    assert section.tool.diameter == 6
