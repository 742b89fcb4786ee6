"""`python -m evidence.studies.film.videos FIRST LAST`: fits of synthetic films.

From the file of the film on.

Film number k is made with the seed k. The lines of docs/studies/real-film/videos.csv are those of 0
to 200.
"""

from __future__ import annotations

import sys
import tempfile
import warnings
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import littlewood as lw
import numpy as np
from littlewood import video

from .throws import FREE, SECONDS, Throw, throw

HEAD = [
    "film",
    "rate",
    "sequence_found",
    *(f"{name}_{what}" for name in FREE for what in ("true", "value", "error")),
]
EXPOSURE = [f"exposure_s_{what}" for what in ("true", "value", "error")]
NOISE = [f"{channel}_{part}" for part in ("white", "slow") for channel in ("theta", "x", "y")]
SIZE = (640, 360)
CLICK_PX = 0.3
"""Standard deviation of where somebody clicks, pixels."""


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

    @property
    def clicked(self) -> video.Plane:
        """The same as somebody has it who clicks on the corners of a small board.

        It has half the picture's width.
        """
        width, height = self.camera.width, self.camera.height
        left, top = self.plane.to_metres(0.25 * width, 0.3 * height)
        right, bottom = self.plane.to_metres(0.75 * width, 0.7 * height)
        corners = np.array([(left, bottom), (right, bottom), (right, top), (left, top)])
        pixels = np.column_stack(self.plane.to_pixels(*corners.T))
        random = np.random.default_rng([self.seed, 10])
        return video.Plane.from_points(pixels + random.normal(0.0, CLICK_PX, pixels.shape), corners)

    def write(self, path: Path) -> None:
        """Write the film."""
        video.synthetic_video(
            path,
            self.thrown.motion,
            self.camera,
            fps=self.rate,
            exposure_s=self.exposure_s,
            seconds=SECONDS,
            seed=self.seed,
        )

    def track(self, path: Path, plane: video.Plane) -> lw.Track:
        """Track the film by somebody who takes the plane to be there.

        The exposure is unknown to them.
        """
        return lw.track_video(path, self.thrown.hoop, plane=plane, fps=self.rate)

    def errors(self, track: lw.Track) -> dict[str, np.ndarray]:
        """Return what a track has too much.

        Against the mean of the exact motion over the exposures.
        """
        time_s = self.thrown.hoop.require_units().time_s
        instants = self.exposure_s / time_s * (np.arange(64) + 0.5) / 64
        exact = self.thrown.motion((track.time[:, None] + instants).ravel())
        means = {"theta": exact.theta, "x": exact.x, "y": exact.centre_y}
        found = {
            name: track.channels[name] - values.reshape(-1, 64).mean(axis=1)
            for name, values in means.items()
        }
        found["theta"] = np.mod(found["theta"] + np.pi, 2.0 * np.pi) - np.pi
        return found


def film_of(number: int, size: tuple[int, int] = SIZE, **other: Any) -> Film:
    """Draw a throw, a camera that stands to the side and above, and a shutter.

    The hoop may have something other than what is drawn.
    """
    random = np.random.default_rng([number, 9])
    thrown, rate = throw(random), (120.0, 240.0)[number % 2]
    if other:
        until, hoop = thrown.motion.end_time, replace(thrown.hoop, **other)
        start: dict[str, Any] = {**thrown.start}
        thrown = Throw(hoop.simulate(**start, until=until), thrown.slips)
    exposure_s = random.uniform(0.1, 1.0) / rate
    length = thrown.hoop.require_units().length_m
    path = thrown.motion(np.linspace(0.0, SECONDS, 200) / thrown.hoop.require_units().time_s)
    left, right = float(path.x.min() - 1.6) * length, float(path.x.max() + 1.6) * length
    top = float(path.centre_y.max() + 1.3) * length
    middle = 0.5 * (left + right)
    place = (middle + random.uniform(-0.4, 0.4), random.uniform(0.5, 1.2), random.uniform(3.5, 4.5))
    # So that all of the path is in the picture, from aside and above.
    across = max(right - left, (top + 0.5) * size[0] / size[1])
    focal = 0.88 * size[0] * place[2] / across
    camera = video.Camera(
        place, (middle, 0.5 * top - 0.1, 0.0), focal, *size, roll_rad=random.uniform(-0.02, 0.02)
    )
    return Film(thrown, camera, rate, exposure_s, number)


def track_of(film: Film) -> lw.Track:
    """Make and track one film."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "film.avi"
        film.write(path)
        return film.track(path, film.clicked)


def fitted(film: Film, track: lw.Track, **more: Any) -> lw.FitResult:
    """Fit the track of a film from the truth."""
    thrown = film.thrown
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.FitWarning)
        return lw.fit(
            track,
            thrown.hoop,
            free=FREE,
            slips_at_start=thrown.slips,
            start=thrown.start,
            search=False,
            **more,
        )


def line_of(number: int, track: lw.Track) -> list[str]:
    """Fit the track of one film."""
    film = film_of(number)
    result, thrown = fitted(film, track), film.thrown
    exposure, time_s = result.estimates["camera_exposure"], thrown.hoop.require_units().time_s
    return [
        *cells_of(number, film.rate, thrown, result),
        *(
            f"{value:.4g}"
            for value in (film.exposure_s, exposure.value * time_s, exposure.std_error * time_s)
        ),
        *(f"{noise.white:.4g}" for noise in result.noise.values()),
        *(f"{noise.slow:.4g}" for noise in result.noise.values()),
    ]


def cells_of(film: int, rate: float, thrown: Throw, result: lw.FitResult) -> list[str]:
    """Return the cells of a line: truth, estimate and standard error of every coefficient."""
    cells = [str(film), f"{rate:g}", str(int(result.motion.sequence == thrown.motion.sequence))]
    for name in FREE:
        estimate = result.estimates[name]
        cells += [
            f"{getattr(thrown.hoop, name):.7g}",
            f"{estimate.value:.7g}",
            f"{estimate.std_error:.4g}",
        ]
    return cells


def main() -> None:
    """Print the lines of the films that are asked for."""
    first, last = map(int, sys.argv[1:3])
    if first == 0:
        print(",".join([*HEAD, *EXPOSURE, *NOISE]), flush=True)
    for number in range(first, last):
        print(",".join(line_of(number, track_of(film_of(number)))), flush=True)


if __name__ == "__main__":
    main()
