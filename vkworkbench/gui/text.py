# SPDX-License-Identifier: LGPL-2.1-or-later
"""Translation of what the user reads, under the name that Qt's lupdate looks for."""

import FreeCAD

translate = FreeCAD.Qt.translate
QT_TRANSLATE_NOOP = FreeCAD.Qt.QT_TRANSLATE_NOOP  # for texts that FreeCAD translates itself
