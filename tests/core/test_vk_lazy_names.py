# SPDX-License-Identifier: LGPL-2.1-or-later
"""The names of vkworkbench.core are loaded at their first use."""

from __future__ import annotations

import pkgutil
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

from vkworkbench import core

ROOT = Path(__file__).resolve().parents[2]


def test_each_name_of_core_comes_from_its_module():
    assert sorted(core._HOMES) == sorted(core.__all__)
    for name, home in core._HOMES.items():
        assert getattr(core, name) is getattr(import_module(f"vkworkbench.core.{home}"), name)
    assert set(core.__all__) <= set(dir(core))
    with pytest.raises(AttributeError, match="no attribute 'Typo'"):
        _ = core.Typo


def test_modules_of_core_are_named_differently_than_public_names():
    assert not {module.name for module in pkgutil.iter_modules(core.__path__)} & set(core.__all__)


def test_import_of_core_loads_no_other_module():
    code = (
        "import sys, vkworkbench.core; print(*sorted(name for name in sys.modules if name.startswith('vkworkbench')))"
    )
    found = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=True)
    assert found.stdout.split() == ["vkworkbench", "vkworkbench.core"]
