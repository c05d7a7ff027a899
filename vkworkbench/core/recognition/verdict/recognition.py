# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a recognition tells: the strategy of an operation, why, and the numbers behind it."""

from __future__ import annotations

from dataclasses import dataclass

from vkworkbench.core.paper import PaperVerdict
from vkworkbench.core.strategy import Strategy
from vkworkbench.language import Message, render


@dataclass(frozen=True)
class Span:
    """A stretch of an operation that follows one strategy.

    Attributes
    ----------
    first, last : int
        First and last trajectory, inclusive.
    first_command, last_command : int
        Their source commands.
    strategy : Strategy
    share : float
        Share of the operation's cutting length, 0..1.
    """

    first: int
    last: int
    first_command: int
    last_command: int
    strategy: Strategy
    share: float


@dataclass(frozen=True)
class Recognition:
    """What an operation does, told from its toolpath alone.

    Attributes
    ----------
    strategy : Strategy
    confidence : float
        How often such verdicts are right, 0..1.
    why : Message
        In the paper's terms with the numbers.
    spans : tuple of Span
        In the order of cutting; more than one where the strategy is mixed, or a little of others lies beside it.
        Neighbours of one strategy are two operations of a program.
    level : int
        The level n of the paper reached, signed: whole turns of phi in one area, truncated toward zero.
    phi_range : tuple of float
        Lowest and highest phi reached in any area, rad, counted from the area's first trajectory, closing turns of loops
        included.
    reversals : int
        Exact reversals: turns of +-pi, which have no sign.
    sense : str or None
        Sense of rotation of the loops, "ccw" or "cw"; None where there is none or both.
    stepover : float or None
        Distance between neighbouring passes, mm.
    passes : int or None
        Number of rows or loops, all depths together.
    depths : int
        Number of depths at which whole moves are cut; 0 on sculptured surfaces, which have none.
    direction : float or None
        Direction of the rows, rad in [0, pi).
    closed_loops : int
        Number of loops that return to their first point.
    milling : str or None
        "climb" or "conventional" for nested loops cut by a spindle that turns clockwise (M3).
    entry : str or None
        How most of the depth is entered before the pattern: "plunge", "ramp", "zigzag ramp" or "helix"; None where the
        descent is the operation, and of mixed ones.
    finishing : bool
        Whether a contour around the rows finishes their walls.
    paper : PaperVerdict or None
        What the paper's rule says to the letter, with V_k and its Gauss image; None where no move has a direction.
    """

    strategy: Strategy
    confidence: float
    why: Message
    spans: tuple[Span, ...] = ()
    level: int = 0
    phi_range: tuple[float, float] = (0.0, 0.0)
    reversals: int = 0
    sense: str | None = None
    stepover: float | None = None
    passes: int | None = None
    depths: int = 0
    direction: float | None = None
    closed_loops: int = 0
    milling: str | None = None
    entry: str | None = None
    finishing: bool = False
    paper: PaperVerdict | None = None

    @property
    def reason(self) -> str:
        """Why in English, one sentence without a full stop."""
        return render(self.why)
