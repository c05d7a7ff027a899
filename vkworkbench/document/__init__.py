# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD documents: the only place that reads or writes them."""
