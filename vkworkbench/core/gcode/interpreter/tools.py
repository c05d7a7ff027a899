# SPDX-License-Identifier: LGPL-2.1-or-later
"""Process T words and tool changes."""

from __future__ import annotations

from vkworkbench.core.gcode.blocks import LARGEST_NUMBER, whole
from vkworkbench.core.gcode.interpreter.state.line import Line
from vkworkbench.core.gcode.interpreter.state.machine import Machine
from vkworkbench.core.gcode.moves.commands import Commands


def take(machine: Machine, line: Line, *, change: bool) -> None:
    """Process the T words of a line, and the tool change in the line if `change` is true.

    The tool change loads the tool of the first T word; a second T word preselects the next tool.
    """
    numbers = [value // 1 for letter, value in line.words if letter == "T"]  # T9.10 means tool 9 with offset 10
    tools = [whole(number, LARGEST_NUMBER) for number in numbers]
    for named in tools:
        machine.clues.tool(named, machine.number)
        machine.add(f"T{named}", {})  # In a program without M6, `with_changes` makes a T word a tool change.
    # On Fagor controls, the T word can be in a line after the M6. If a T word follows an M6 without a tool, the tool
    # change is moved from the M6 to the T word.
    if tools and not change and machine.unnamed is not None:
        machine.commands[machine.unnamed] = "G94", {}
        change = True
    if tools or change:
        machine.stop()
    if change:
        machine.changes = True
        tool = tools[0] if tools else machine.tool
        machine.add("M6", {} if tool is None else {"T": tool})
        machine.unnamed = len(machine.commands) - 1 if not tools and tool in (None, machine.spindle_tool) else None
        machine.spindle_tool = tool
    machine.tool = tools[-1] if tools else machine.tool


def with_changes(machine: Machine) -> Commands:
    """Return the commands; in a program without M6, each T word with a new number is a tool change."""
    if machine.changes:
        return machine.commands
    tool = None
    for at, name in enumerate(machine.commands.names):
        if name[:1] == "T":
            number = int(name[1:])
            machine.commands[at] = ("M6", {"T": number}) if number != tool else ("G94", {})
            tool = number
    return machine.commands
