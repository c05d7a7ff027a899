# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of all sentences: the template of each code, one file for each subject.

A template is one text, or two texts (singular and plural) if the message has an argument ``count``.
`PLAIN` has templates in a machinist's words for codes whose template in `TABLE` uses the paper's terms.
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
