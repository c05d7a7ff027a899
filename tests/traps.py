# SPDX-License-Identifier: LGPL-2.1-or-later
"""A hostile folder with files that Python would run instead of its own modules, or at its start."""

from __future__ import annotations

import sys
from pathlib import Path

STARTED = {"sitecustomize", "usercustomize", "startup"}


def lay_traps(folder, names=()):
    """Fill a folder with modules that write their names into the file "ran".

    Parameters
    ----------
    folder : Path
    names : iterable of str
        Names of the modules; by default every module of Python, of this process, and of the add-on.

    Returns
    -------
    function
        Returns the names of the modules that were run.
    """
    folder.mkdir(parents=True)
    ran = folder / "ran"
    trap = f"with open({str(ran)!r}, 'a') as file: file.write(__name__ + ' ')\n"
    for name in names or _module_names():
        (folder / f"{name}.py").write_text(trap)
    package = folder / "vkworkbench"
    if not names:
        package.mkdir()
        for name in ("__init__", "__main__", "worker"):
            (package / f"{name}.py").write_text(trap)
    return lambda: ran.read_text().split() if ran.exists() else []


def environment_of_traps(folder):
    """Return environment variables by which Python would run the files of a folder with traps."""
    packages = Path(folder, "user", "lib", f"python{sys.version_info.major}.{sys.version_info.minor}", "site-packages")
    packages.mkdir(parents=True)
    trap = Path(folder, "pickle.py").read_text().replace("__name__", "'a .pth file'").replace("\n", "")
    (packages / "trap.pth").write_text(f"import sys; exec({trap!r})\n")
    (packages / "usercustomize.py").write_text(trap)
    return {
        "PYTHONPATH": str(folder),
        "PYTHONHOME": str(folder),
        "PYTHONSTARTUP": str(Path(folder, "startup.py")),
        "PYTHONUSERBASE": str(Path(folder, "user")),
        "HOME": str(Path(folder, "user")),
    }


def _module_names():
    known = {name.partition(".")[0] for name in sys.modules} | set(getattr(sys, "stdlib_module_names", ()))
    return {name for name in known if name.isidentifier() and name != "vkworkbench"} | {"distributed", *STARTED}
