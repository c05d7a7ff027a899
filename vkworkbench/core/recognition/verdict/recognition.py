# SPDX-License-Identifier: LGPL-2.1-or-later
"""The result of a recognition: strategy, reason and numbers."""

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
        Commands from which the first and the last trajectory come.
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
    """The strategy of an operation, recognised from its toolpath alone.

    Attributes
    ----------
    strategy : Strategy
    confidence : float
        Probability that the recognised strategy is right, 0..1.
    why : Message
        Reason for the strategy in the paper's terms (levels, phi, half turns), with numbers.
    spans : tuple of Span
        Stretches with one strategy each, in the order of cutting. There are several spans if the strategy is mixed, or
        if a few cuts follow another strategy than most of the operation. Neighbouring spans with the same strategy are
        two operations of an NC program.
    level : int
        Level n in the paper: number of full turns in one area (phi / 2 pi), with sign, truncated toward zero.
    phi_range : tuple of float
        Lowest and highest sum of the turns (phi) in any area, rad. phi is 0 at the first trajectory of each area, and
        includes the turn from the last to the first side of a closed loop.
    reversals : int
        Number of exact reversals: turns of +-pi, which have no sign.
    sense : str or None
        Sense of rotation of the loops, "ccw" or "cw"; None without loops, or with both senses.
    stepover : float or None
        Distance between neighbouring passes, mm.
    passes : int or None
        Number of rows or loops at all depths.
    depths : int
        Number of depths with horizontal cuts; 0 for sculptured surfaces.
    direction : float or None
        Direction of the rows, rad in [0, pi).
    closed_loops : int
        Number of loops that return to their first point.
    milling : str or None
        "climb" or "conventional" for nested loops cut by a spindle that turns clockwise (M3).
    entry : str or None
        Kind of the tool's entry into the material: "plunge", "ramp", "zigzag ramp" or "helix". The value is None if the
        descent is the operation itself, and for mixed operations.
    finishing : bool
        Whether a contour around the rows, or after adaptive clearing, finishes the walls.
    paper : PaperVerdict or None
        Strategy by the paper's literal rule, with V_k and its Gauss image; None if no move has a direction.
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
        """The reason in English, a sentence without a full stop."""
        return render(self.why)
