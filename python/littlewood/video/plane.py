"""The vertical plane of the motion, and its projection in a frame."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals

if TYPE_CHECKING:
    from .camera import Camera

__all__ = ["Plane"]


def _points(name: str, points: npt.ArrayLike, least: int) -> Reals:
    found = np.array(points, dtype=np.float64)
    if (
        found.ndim != 2
        or found.shape[1] != 2
        or found.shape[0] < least
        or not np.all(np.isfinite(found))
    ):
        raise ValueError(
            f"{name} must be at least {least} pairs of finite numbers, not an array of shape "
            f"{found.shape}"
        )
    return found


def _centred(points: Reals) -> tuple[Reals, Reals]:
    """Return points about their mean at a mean distance of √2, and a matrix.

    The matrix makes them so.
    """
    mean = points.mean(axis=0)
    scale = math.sqrt(2.0) / float(np.mean(np.hypot(*(points - mean).T)))
    matrix = np.array(
        [[scale, 0.0, -scale * mean[0]], [0.0, scale, -scale * mean[1]], [0.0, 0.0, 1.0]]
    )
    return (points - mean) * scale, matrix


def _mapped(matrix: Reals, a: npt.ArrayLike, b: npt.ArrayLike) -> tuple[Reals, Reals]:
    a, b = np.asarray(a, dtype=np.float64), np.asarray(b, dtype=np.float64)
    (p, q, w) = (row[0] * a + row[1] * b + row[2] for row in matrix)
    return p / w, q / w


@dataclass(frozen=True, eq=False)
class Plane:
    """The plane of the motion in a frame: metres to pixels, with the perspective.

    x is to the right and y the height over the floor, m; u is to the right and v downward, pixels
    from the centre of the first pixel, as OpenCV has them. One of :meth:`from_points`,
    :meth:`from_ground_line` and :meth:`from_camera` makes it.

    Parameters
    ----------
    matrix : array_like
        The homography, 3 × 3: (u, v, 1) is proportional to its product with (x, y, 1).

    Raises
    ------
    ValueError
        If the matrix is not one of a plane that is seen from the side.
    """

    matrix: Reals

    def __post_init__(self) -> None:
        matrix = np.array(self.matrix, dtype=np.float64)
        if (
            matrix.shape != (3, 3)
            or not np.all(np.isfinite(matrix))
            or np.linalg.matrix_rank(matrix) < 3
        ):
            raise ValueError("the matrix of a plane must have 3 × 3 finite numbers and an inverse")
        object.__setattr__(self, "matrix", matrix / np.linalg.norm(matrix))

    @classmethod
    def from_points(cls, pixels: npt.ArrayLike, metres: npt.ArrayLike) -> Plane:
        """Make the plane from measured points in the frame, such as four corners of a board.

        Parameters
        ----------
        pixels : array_like
            Where the frame shows them, of shape (n, 2) with n ≥ 4.
        metres : array_like
            Where they are, x and y, of the same shape; no three on a line. More than four are taken
            by least squares.

        Returns
        -------
        Plane

        Examples
        --------
        >>> import littlewood as lw
        >>> pixels = [(100, 400), (900, 420), (880, 30), (110, 10)]
        >>> plane = lw.video.Plane.from_points(pixels, [(0, 0), (2, 0), (2, 1), (0, 1)])
        >>> [round(float(value), 6) for value in plane.to_metres(900, 420)]
        [2.0, 0.0]
        """
        seen, true = _points("pixels", pixels, 4), _points("metres", metres, 4)
        if seen.shape != true.shape:
            raise ValueError(f"there are {len(seen)} points in pixels and {len(true)} in metres")
        (seen, of_seen), (true, of_true) = _centred(seen), _centred(true)
        rows = []
        for (u, v), (x, y) in zip(seen, true, strict=True):
            rows.append([x, y, 1.0, 0.0, 0.0, 0.0, -u * x, -u * y, -u])
            rows.append([0.0, 0.0, 0.0, x, y, 1.0, -v * x, -v * y, -v])
        _, singular, right = np.linalg.svd(np.array(rows))
        if singular[7] < 1e-9 * singular[0]:
            raise ValueError(
                "three of the points are on a line: they do not determine the perspective"
            )
        return cls(np.linalg.inv(of_seen) @ right[8].reshape(3, 3) @ of_true)

    @classmethod
    def from_ground_line(
        cls, left: tuple[float, float], right: tuple[float, float], length_m: float
    ) -> Plane:
        """Take the plane from a line on the floor, for a camera that looks at it squarely.

        Parameters
        ----------
        left, right : tuple of float
            Two points of the floor in the plane of the motion, in pixels; the left one is x = 0.
            The camera may be tilted about its axis, not turned: with perspective take
            :meth:`from_points`.
        length_m : float
            Distance of the points, m.

        Returns
        -------
        Plane
        """
        (u0, v0), (u1, v1) = left, right
        if not (length_m > 0.0 and math.isfinite(length_m) and u1 > u0):
            raise ValueError(
                f"a line of {length_m} m from {left} to {right} must have a length and go to the "
                f"right"
            )
        a, b = (u1 - u0) / length_m, (v1 - v0) / length_m
        return cls(np.array([[a, b, u0], [b, -a, v0], [0.0, 0.0, 1.0]]))

    @classmethod
    def from_camera(cls, camera: Camera) -> Plane:
        """Make the plane from a camera with a known position.

        Parameters
        ----------
        camera : Camera
            The camera.

        Returns
        -------
        Plane
        """
        return cls(camera.matrix[:, [0, 1, 3]])

    def to_pixels(self, x: npt.ArrayLike, y: npt.ArrayLike) -> tuple[Reals, Reals]:
        """Return points of the plane in the frame, u and v in pixels.

        Parameters
        ----------
        x, y : array_like
            Points, m.
        """
        return _mapped(self.matrix, x, y)

    def to_metres(self, u: npt.ArrayLike, v: npt.ArrayLike) -> tuple[Reals, Reals]:
        """Return the points of the plane that pixels show, x and y in m.

        Parameters
        ----------
        u, v : array_like
            Pixels.
        """
        return _mapped(np.asarray(np.linalg.inv(self.matrix), dtype=np.float64), u, v)

    def pixels_per_metre(self, x: float, y: float) -> float:
        """Return the scale of the frame about a point of the plane: the root of the ratio of areas.

        Parameters
        ----------
        x, y : float
            The point, m.
        """
        step = 1e-4
        (u, v) = self.to_pixels([x, x + step, x], [y, y, y + step])
        return math.sqrt(abs((u[1] - u[0]) * (v[2] - v[0]) - (u[2] - u[0]) * (v[1] - v[0]))) / step
