# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command ``python3 -m vkworkbench``, see `vkworkbench.program`."""

import sys

from vkworkbench.program import main

if __name__ == "__main__":
    sys.exit(main())
