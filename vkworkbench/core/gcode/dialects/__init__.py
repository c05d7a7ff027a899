# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recognize the dialect of an NC program, and texts that are not G-code for a mill.

`Dialect` contains the properties in which dialects differ. A new dialect is an entry in `dialect.py`. `dialect_of`
finds the dialect of a text. `spelled` replaces Siemens' words by common words, and `drilling` reads Siemens' drilling cycles. `refuse` rejects programs in the languages of other controls, and `check` rejects texts
that are not NC programs. `Clues` collects the signs that a program is for another machine than a mill.
"""

from vkworkbench.core.gcode.dialects.clues import Clues
from vkworkbench.core.gcode.dialects.dialect import HEIDENHAIN, RAW_PATH, RS274, SIEMENS, Dialect
from vkworkbench.core.gcode.dialects.siemens import Drilling, drilling, spelled
from vkworkbench.core.gcode.dialects.texts import at_line, check, dialect_of, refuse

__all__ = [
    "HEIDENHAIN", "RAW_PATH", "RS274", "SIEMENS", "Clues", "Dialect", "Drilling", "at_line", "check", "dialect_of", "drilling",
    "refuse", "spelled",
]  # fmt: skip
