# SPDX-License-Identifier: LGPL-2.1-or-later
"""Count how often toolpaths in mm are taken for inches (wrong), and toolpaths divided by 25.4 (right).

    python3 benchmarks/inches.py FILE...

FILE is an NC program, a folder of programs, or a ``.jsonl.gz`` file of operations with ``commands`` and
``tool_diameter`` in FreeCAD's units. For each kind of file, the script prints how often the guessed unit is inches, for
the toolpaths in mm and for the same toolpaths divided by 25.4, and how many toolpaths get the same strategy at both
sizes, with `recognize` and with `recognize_inches`.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parent.parent)]

from records import lines

from vkworkbench.core import Toolpath, linearize, recognize
from vkworkbench.core.gcode import INCH, looks_like_inches, read_program
from vkworkbench.core.recognition import recognize_inches
from vkworkbench.program.files import find_programs, read_bytes, text_of

LONGEST = 50_000  # maximum number of trajectories; recognising a longer toolpath several times takes too long


def operations(path: Path) -> Iterator[tuple[Toolpath, float | None]]:
    for record in lines(str(path)):
        yield linearize(record["commands"]), record["tool_diameter"]


def programs(path: Path) -> Iterator[tuple[Toolpath, float | None]]:
    for file in find_programs([path], []):
        try:
            program = read_program(text_of(read_bytes(file)))
        except ValueError:
            continue
        if not program.other and not program.rotary:
            yield program.toolpath(), None


def shrunk(toolpath: Toolpath, feeds: float) -> Toolpath:
    return replace(toolpath, points=toolpath.points / INCH, feed=toolpath.feed * feeds)


def main() -> None:
    print(f"{'':40s} {'number':>7s} {'said at 1':>10s} {'at 1/25.4':>10s} {'same':>7s} {'as inches':>10s}")
    for name in map(Path, sys.argv[1:]):
        imported = name.name.endswith(".jsonl.gz")  # FreeCAD's import reads feeds in mm/min or in/min as mm/s
        number = said = found = same = same_in_inches = judged = 0
        for toolpath, tool in (operations if imported else programs)(name):
            small = shrunk(toolpath, 60 / INCH if imported else 1 / INCH)
            number += 1
            said += looks_like_inches(toolpath, tool_diameter=tool)
            if not looks_like_inches(small, tool_diameter=tool, imported=imported):
                continue
            found += 1
            if len(toolpath) <= LONGEST:
                judged += 1
                true = recognize(toolpath, tool_diameter=tool).strategy
                same += recognize(small, tool_diameter=tool).strategy is true
                same_in_inches += recognize_inches(small, tool_diameter=tool).strategy is true
        print(
            f"{name.name:40s} {number:7d} {said / number:10.3f} {found / number:10.3f} "
            f"{same / max(judged, 1):7.3f} {same_in_inches / max(judged, 1):10.3f}"
        )


if __name__ == "__main__":
    main()
