# SPDX-License-Identifier: LGPL-2.1-or-later
"""The error of what cannot be used."""

from __future__ import annotations

from vkworkbench.language.message import Message
from vkworkbench.language.sentences import render


class Unusable(ValueError):
    """Something given cannot be used; its message tells the user what is wrong with it.

    Attributes
    ----------
    what : Message
    """

    def __init__(self, what: Message) -> None:
        super().__init__(what)
        self.what = what

    def __str__(self) -> str:
        return render(self.what)
