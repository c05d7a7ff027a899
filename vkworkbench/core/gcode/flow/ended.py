# SPDX-License-Identifier: LGPL-2.1-or-later
"""The reasons why a program cannot be followed further."""

from __future__ import annotations

from vkworkbench.language import Message


class Ended(Exception):
    """The rest of the program cannot be followed.

    Parameters
    ----------
    why : Message
        The reason, a full sentence.
    """

    def __init__(self, why: Message) -> None:
        super().__init__(why)
        self.why = why


class Unknown(Ended):
    """A value comes from the machine. Only a line that needs the value ends the program."""


class Unreadable(Exception):
    """A line is not a macro statement, or contains an expression with an error."""
