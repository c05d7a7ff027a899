# SPDX-License-Identifier: LGPL-2.1-or-later
# FreeCAD runs this file when its window starts, inside a function and without __file__. Therefore it only imports.
from vkworkbench.gui.workbench import install

install()
