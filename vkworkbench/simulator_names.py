# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names of the simulators whose costs are told: the paper's extended z-buffer, and FreeCAD's two."""

ZBUFFER, LEGACY, OPENGL = "z-buffer", "legacy", "OpenGL"
SIMULATORS = (ZBUFFER, LEGACY, OPENGL)
