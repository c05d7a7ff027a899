# SPDX-License-Identifier: LGPL-2.1-or-later
"""Define the parallel view of a simulation: an image of rays, fitted to the stock."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial
from typing import Protocol

import numpy as np

from vkworkbench.given import number, numbers, whole

# Largest tilt of a view that counts as vertical, rad. A smaller tilt does not change the image visibly. If smaller
# tilts counted, rounding in the camera's direction would decide which side of the image is up, and whether a ray passes
# inside or outside a tool's vertical side.
VERTICAL = 1e-5
# Largest width and height of an image, pixels, and largest number of pixels in an image. The z-buffer stores indices of
# pixels in 32 bits.
LONGEST_SIDE, MOST_PIXELS = 1_000_000, 2**32
# Smallest and largest side of a pixel, mm. With the smallest pixel, the smallest stock fills the largest image. The
# largest pixel is much wider than the largest stock.
_SMALLEST_PIXEL, _LARGEST_PIXEL = 1e-12, 1e10


class Bounded(Protocol):
    """A solid with a bounding box, `lower` and `upper` (3,) mm."""

    lower: np.ndarray
    upper: np.ndarray


@dataclass(frozen=True)
class View:
    """A parallel projection on an image of rays.

    Parameters
    ----------
    direction : (3,) tuple of float
        Direction in which the eye looks; any length except zero is allowed. The default direction is straight down.
    width, height : int
        Size of the image, pixels: each at most a million, their product at most 2**32. The default is the paper's image
        (section 1).
    pixel : float, optional
        Side of a pixel, 1e-12 to 1e10 mm; by default the smallest pixel with which the image shows the whole stock.
    offset : (2,) tuple of float
        Position of the image's centre relative to the stock's centre, mm to the right and up, up to 1e10 each.

    Raises
    ------
    ValueError
        If the direction has zero length, a size is outside its limits, or a text is not a number.
    TypeError
        If `width` or `height` is not an integer (``160 / 0.5`` is a float), or another value is not a number.
    """

    direction: tuple[float, float, float] = (0.0, 0.0, -1.0)
    width: int = 800
    height: int = 600
    pixel: float | None = None
    offset: tuple[float, float] = (0.0, 0.0)

    def __post_init__(self) -> None:
        set_to = partial(object.__setattr__, self)
        direction = numbers("direction", self.direction, "three finite numbers that are not all zero", _is_direction)
        set_to("direction", tuple(direction.tolist()))
        for name in ("width", "height"):
            set_to(name, whole(name, getattr(self, name), "a whole number of pixels, at least 1", lambda n: n >= 1))
            whole(name, getattr(self, name), f"at most {LONGEST_SIDE:,} pixels", lambda n: n <= LONGEST_SIDE)
        whole("width * height", self.width * self.height, f"at most {MOST_PIXELS:,} pixels", lambda n: n <= MOST_PIXELS)
        if self.pixel is not None:
            takes = f"a positive number of mm, from {_SMALLEST_PIXEL:g} to {_LARGEST_PIXEL:g}"
            set_to("pixel", number("pixel", self.pixel, takes, lambda mm: _SMALLEST_PIXEL <= mm <= _LARGEST_PIXEL))
        offset = numbers(
            "offset", self.offset, f"two finite numbers of mm, at most {_LARGEST_PIXEL:g} each", _is_offset
        )
        set_to("offset", tuple(offset.tolist()))

    def of_size(self, width: int, height: int) -> View:
        """Return the view with an image of another size.

        If the pixel size is given and the image is smaller, the pixels are larger, so that the image shows the same
        area.
        """
        pixel = self.pixel and self.pixel * wider_pixel(self, width, height)
        return replace(self, width=width, height=height, pixel=pixel)

    def frame(self, stock: Bounded) -> Frame:
        """Return the view fitted to a stock: the image's axes, centre and pixel."""
        direction = np.array(self.direction)
        # Scale the direction's largest component to at most 1, so that the squares in `norm` do not overflow.
        direction = np.ldexp(direction, -np.frexp(np.abs(direction).max())[1])
        direction /= np.linalg.norm(direction)
        sine = np.hypot(direction[0], direction[1])
        if sine < VERTICAL:
            direction = np.array([0.0, 0.0, np.sign(direction[2])])
            right = np.array([1.0, 0.0, 0.0])
        else:
            right = np.array([direction[1], -direction[0], 0.0]) / sine
        (rx, ry, _), (dx, dy, dz) = right, direction
        up = np.array([ry * dz, -rx * dz, rx * dy - ry * dx])  # cross product of `right` and `direction`
        half = (stock.upper - stock.lower) / 2
        pixel = self.pixel
        if pixel is None:
            extent = 2 * np.array([np.abs(right) @ half, np.abs(up) @ half])
            pixel = float(max(extent[0] / self.width, extent[1] / self.height))
        centre = (stock.lower + stock.upper) / 2 + self.offset[0] * right + self.offset[1] * up
        return Frame(centre, right, up, direction, pixel, self.width, self.height)


def wider_pixel(image: View | Frame, width: int, height: int) -> float:
    """Return the factor by which a pixel grows so that an image of another size shows at least the same area."""
    return max(image.width / width, image.height / height)


def _are_finite(numbers: np.ndarray, size: int) -> bool:
    return numbers.shape == (size,) and bool(np.isfinite(numbers).all())


def _is_offset(numbers: np.ndarray) -> bool:
    return _are_finite(numbers, 2) and bool((np.abs(numbers) <= _LARGEST_PIXEL).all())


def _is_direction(numbers: np.ndarray) -> bool:
    return _are_finite(numbers, 3) and bool(numbers.any())


@dataclass(frozen=True, eq=False)
class Frame:
    """A view fitted to a stock: image coordinates x, y in mm about its centre, depth along the view.

    Attributes
    ----------
    centre, right, up, direction : (3,) ndarray
        Centre of the image, at the depth of the bounding box's centre, and the orthonormal axes of the image.
    pixel : float
        Side of a pixel, mm.
    width, height : int
        Size of the image, pixels.
    """

    centre: np.ndarray
    right: np.ndarray
    up: np.ndarray
    direction: np.ndarray
    pixel: float
    width: int
    height: int

    def origins(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        """Return the points (k, 3) of the image plane at image coordinates `x`, `y` (k,)."""
        # A loop over the coordinates is five times faster than numpy's outer products with three numbers.
        result = np.empty((len(x), 3))
        for axis in range(3):
            result[:, axis] = self.centre[axis] + x * self.right[axis] + y * self.up[axis]
        return result

    def pixel_centres(self, columns: np.ndarray, rows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the image coordinates of pixel centres; column 0 is left, row 0 is the bottom."""
        x = (np.asarray(columns) + 0.5 - self.width / 2) * self.pixel
        y = (np.asarray(rows) + 0.5 - self.height / 2) * self.pixel
        return x, y

    def points(self, columns: np.ndarray, rows: np.ndarray, depth: np.ndarray) -> np.ndarray:
        """Return the points (k, 3) at a depth (k,) along the ray of each pixel."""
        centres = self.origins(*self.pixel_centres(columns, rows))
        return centres + np.multiply.outer(depth, self.direction)
