# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of all that is said: codes and their templates, one file for each subject.

A template is one text, or two, for one and for more, where the message counts something in its argument ``count``.
`PLAIN` has the words of a machinist for codes whose template in `TABLE` speaks in the paper's terms.
"""

from __future__ import annotations

from vkworkbench.language.table.commands import COMMANDS
from vkworkbench.language.table.operations import OPERATIONS
from vkworkbench.language.table.plain import PLAIN
from vkworkbench.language.table.programs import PROGRAMS
from vkworkbench.language.table.recognition import RECOGNITION
from vkworkbench.language.table.simulation import SIMULATION
from vkworkbench.language.table.simulators import SIMULATORS

__all__ = ["PLAIN", "TABLE"]

TABLE: dict[str, str | tuple[str, str]] = {
    **COMMANDS,
    **OPERATIONS,
    **PROGRAMS,
    **RECOGNITION,
    **SIMULATION,
    **SIMULATORS,
}
