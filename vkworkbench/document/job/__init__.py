# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reading FreeCAD documents: operations, tools, stocks and models. Writes nothing."""
