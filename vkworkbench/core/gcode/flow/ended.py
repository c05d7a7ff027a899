# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the exceptions for NC programs that cannot be followed further, and for lines that cannot be read."""

from __future__ import annotations

from vkworkbench.language import Message


class Ended(Exception):
    """The rest of the NC program cannot be followed.

    Parameters
    ----------
    why : Message
        The reason, a full sentence.
    """

    def __init__(self, why: Message) -> None:
        super().__init__(why)
        self.why = why


class Unknown(Ended):
    """The value of a variable is unknown, because it comes from the machine.

    Reading goes on up to the first line that needs an unknown value.
    """


class Unreadable(Exception):
    """A program line is not a macro statement, or contains an expression with an error."""
