# SPDX-License-Identifier: LGPL-2.1-or-later
"""``python3 -m vkworkbench``: NC programs on the command line; see `vkworkbench.program`."""

import sys

from vkworkbench.program import main

if __name__ == "__main__":
    sys.exit(main())
