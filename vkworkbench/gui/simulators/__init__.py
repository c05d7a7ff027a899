# SPDX-License-Identifier: LGPL-2.1-or-later
"""Notice that the user starts one of FreeCAD's simulators, and warn if it would hang or take too long."""
