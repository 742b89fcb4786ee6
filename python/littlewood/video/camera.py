"""A pinhole camera."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

__all__ = ["Camera"]


@dataclass(frozen=True)
class Camera:
    """A pinhole camera that looks at the plane of the motion, z = 0. It does not distort.

    Parameters
    ----------
    position_m : tuple of float
        Its position: x to the right, y up, z toward the camera, m.
    target_m : tuple of float
        The point in the middle of its frame, m.
    focal_px : float
        Focal length, pixels: half of the width of the frame over the tangent of half of the angle
        of view.
    width, height : int, optional
        Size of the frame, pixels.
    roll_rad : float, optional
        Angle by which it is turned about its axis, clockwise as it looks, rad.

    Raises
    ------
    ValueError
        If it does not look at the plane from in front of it.
    """

    position_m: tuple[float, float, float]
    target_m: tuple[float, float, float]
    focal_px: float
    width: int = 1280
    height: int = 720
    roll_rad: float = 0.0

    def __post_init__(self) -> None:
        if not (self.focal_px > 0.0 and math.isfinite(self.focal_px)):
            raise ValueError(f"focal_px = {self.focal_px} must be positive, pixels")
        if self.width < 16 or self.height < 16:
            raise ValueError(
                f"a frame of {self.width} × {self.height} pixels is smaller than 16 × 16"
            )
        if not (self.position_m[2] > 0.0 and self.target_m[2] < self.position_m[2]):
            raise ValueError(
                f"position_m = {self.position_m} must be in front of the plane, z > 0, and of its "
                f"target"
            )

    @property
    def matrix(self) -> npt.NDArray[np.float64]:
        """The projection, 3 × 4: (u, v, 1) is proportional to its product with (x, y, z, 1)."""
        forward = np.subtract(self.target_m, self.position_m)
        forward = forward / np.linalg.norm(forward)
        right = np.cross(forward, (0.0, 1.0, 0.0))
        right = right / np.linalg.norm(right)
        down = np.cross(forward, right)
        cosine, sine = math.cos(self.roll_rad), math.sin(self.roll_rad)
        axes = np.array([cosine * right + sine * down, cosine * down - sine * right, forward])
        middle = ((self.width - 1) / 2.0, (self.height - 1) / 2.0)
        inner = np.array(
            [[self.focal_px, 0.0, middle[0]], [0.0, self.focal_px, middle[1]], [0.0, 0.0, 1.0]]
        )
        return np.asarray(inner @ np.column_stack([axes, -axes @ np.array(self.position_m)]))
