# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of the core share."""

from __future__ import annotations

from hypothesis import settings

# A busy machine is no failure. The same examples in every run: what it finds is the change's.
settings.register_profile("tests", deadline=None, derandomize=True)
settings.load_profile("tests")
