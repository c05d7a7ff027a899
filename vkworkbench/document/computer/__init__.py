# SPDX-License-Identifier: LGPL-2.1-or-later
"""The speed of this computer, and work that waits until FreeCAD is idle."""
