# SPDX-License-Identifier: LGPL-2.1-or-later
"""The simulation of a job in a tab of FreeCAD's window: the part, the time line, and what made each surface."""
