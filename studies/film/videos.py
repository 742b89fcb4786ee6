"""`python -m studies.film.videos FIRST LAST`: fits of synthetic films, from the file of the film on.

Film number k is made with the seed k. The lines of docs/studies/real-film/videos.csv are those of 0 to 20.
"""

from __future__ import annotations

import sys
import tempfile
import warnings
from dataclasses import dataclass
from pathlib import Path

import littlewood as lw
import numpy as np
from littlewood import video

from .coverage import HEAD, cells_of
from .throws import FREE, SECONDS, Throw, throw

SIZE = (640, 360)


@dataclass(frozen=True)
class Film:
    """A film of a throw.

    Parameters
    ----------
    thrown : Throw
        What is filmed.
    camera : Camera
        What films it.
    rate, exposure_s : float
        Pictures per second, and how long each is exposed, s.
    seed : int
        Seed of its noise.
    """

    thrown: Throw
    camera: video.Camera
    rate: float
    exposure_s: float
    seed: int

    @property
    def plane(self) -> video.Plane:
        """Where the picture shows the plane of the motion."""
        return video.Plane.from_camera(self.camera)

    def write(self, path: Path) -> None:
        """Write the film."""
        video.synthetic_film(
            path,
            self.thrown.motion,
            self.camera,
            pictures_per_second=self.rate,
            exposure_s=self.exposure_s,
            seconds=SECONDS,
            seed=self.seed,
        )

    def track(self, path: Path) -> lw.Track:
        """Track the film."""
        return lw.track_video(path, self.thrown.hoop, plane=self.plane, pictures_per_second=self.rate)

    def errors(self, track: lw.Track) -> dict[str, np.ndarray]:
        """Return what a track has too much, against the exact motion in the middle of the exposures."""
        time_s = self.thrown.hoop.require_units().time_s
        exact = self.thrown.motion.at(track.time + 0.5 * self.exposure_s / time_s)
        theta, x, y = track.theta, track.x, track.y
        assert theta is not None and x is not None and y is not None
        return {
            "theta": np.mod(theta - exact.theta + np.pi, 2.0 * np.pi) - np.pi,
            "x": x - exact.x,
            "y": y - exact.centre_y,
        }


def film_of(number: int, size: tuple[int, int] = SIZE) -> Film:
    """Draw a throw, a camera that stands to the side and above, and a shutter."""
    random = np.random.default_rng([number, 9])
    thrown, rate = throw(random), (120.0, 240.0)[number % 2]
    exposure_s = random.uniform(0.1, 1.0) / rate
    length = thrown.hoop.require_units().length_m
    path = thrown.motion.at(np.linspace(0.0, SECONDS, 200) / thrown.hoop.require_units().time_s)
    left, right = float(path.x.min() - 1.6) * length, float(path.x.max() + 1.6) * length
    top = float(path.centre_y.max() + 1.3) * length
    middle = 0.5 * (left + right)
    place = (middle + random.uniform(-0.4, 0.4), random.uniform(0.5, 1.2), random.uniform(3.5, 4.5))
    # So that all of the path is in the picture, from aside and above.
    across = max(right - left, (top + 0.5) * size[0] / size[1])
    focal = 0.88 * size[0] * place[2] / across
    camera = video.Camera(place, (middle, 0.5 * top - 0.1, 0.0), focal, *size, roll_rad=random.uniform(-0.02, 0.02))
    return Film(thrown, camera, rate, exposure_s, number)


def line_of(number: int) -> list[str]:
    """Make, track and fit one film."""
    film = film_of(number)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "film.avi"
        film.write(path)
        track = film.track(path)
    hoop, thrown = film.thrown.hoop, film.thrown
    first = thrown.motion.at(0.5 * film.exposure_s / hoop.require_units().time_s)
    start = {"theta": float(first.theta), "theta_rate": float(first.theta_rate), "x": float(first.x)}
    start["slip"] = float(first.slip)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.IdentifiabilityWarning)
        result = lw.fit(track, hoop, free=FREE, slips_at_start=thrown.slips, start=start, search=False)
    return [
        *cells_of(number, film.rate, thrown, result),
        *(f"{result.sigma[name]:.4g}" for name in ("theta", "x", "y")),
    ]


def main() -> None:
    """Print the lines of the films that are asked for."""
    first, last = map(int, sys.argv[1:3])
    if first == 0:
        print(",".join([*HEAD, "theta_sigma", "x_sigma", "y_sigma"]), flush=True)
    for number in range(first, last):
        print(",".join(line_of(number)), flush=True)


if __name__ == "__main__":
    main()
