# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command ``python3 FOLDER/vkworkbench`` or ``python3 -m vkworkbench``, see `vkworkbench.program`."""

import os
import sys


def _is_current_folder(folder: str) -> bool:
    try:
        return os.path.samefile(folder or os.curdir, os.curdir)
    except OSError:  # a folder in sys.path may be missing
        return False


if __name__ == "__main__":
    # `python3 -m` and empty entries of PYTHONPATH let Python import from the current folder. This folder is removed
    # from sys.path, because it may contain files of other people.
    sys.path[:] = [folder for folder in sys.path if not _is_current_folder(folder)]
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

    from vkworkbench.program import main

    sys.exit(main())
