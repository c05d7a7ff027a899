# SPDX-License-Identifier: LGPL-2.1-or-later
from __future__ import annotations

import FreeCADGui


def test_window_is_there():
    assert FreeCADGui.getMainWindow().isVisible()
