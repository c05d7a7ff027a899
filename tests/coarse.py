# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check simulated jobs coarsely where a test does not judge which faults are found."""

from contextlib import contextmanager

import pytest


@contextmanager
def coarse_check():
    """Check simulated jobs with wide pixels and with few rays along walls, to save nine tenths of the time.

    Other tests of the core and of the documents check which faults are found.
    """
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("vkworkbench.core.zbuffer.cost.axis_view._FINE_ENOUGH", 0.5)  # mm
        patch.setattr("vkworkbench.core.zbuffer.cost.axis_view._OF_TOOL", 1.0)
        patch.setattr("vkworkbench.core.zbuffer.findings.thin_gouges._AT_WALLS", 0.25)  # mm
        yield
