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
    # With `python3 -m` or an empty entry in PYTHONPATH, Python imports from the current folder. The current folder is
    # removed from sys.path, because it could contain other people's files.
    sys.path[:] = [folder for folder in sys.path if not _is_current_folder(folder)]
    sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

    from vkworkbench.program import main

    sys.exit(main())
