"""`python -m evidence.studies.film.hard`: films as a school takes them.

And how far the track is then off.

It prints docs/studies/real-film/hard.csv. The films of H.264 need ffmpeg on the path.
"""

from __future__ import annotations

import math
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import littlewood as lw
import numpy as np
from littlewood import video
from littlewood.video import synthetic
from littlewood.video.files import FrameWriter

from .throws import FREE, SECONDS
from .videos import Film, film_of

FILMS = (0, 2, 3, 5)
"""Which of the films of videos.py are made harder."""

HEAD = [
    "condition",
    "film",
    "frames",
    "hoops",
    "markers",
    "centre_px",
    "marker_px",
    "by_hoop",
    "worst_pull",
    "doubts",
]
Frames = Iterator[np.ndarray]
GAMMA = 2.2


@dataclass(frozen=True)
class Hard:
    """What makes a film hard.

    Parameters
    ----------
    words : str
        What it is.
    look : Look or None
        The scene.
    part : float or None
        Exposure over the time of a frame; that of the film by default.
    change : callable, optional
        What becomes of the frames.
    codec : str
        Ending of the file; "h264" is written by ffmpeg.
    rate : float or None
        Frames a second; those of the film by default.
    other : dict, optional
        What the hoop has in place of what is drawn. Whoever fits is told of it, but for the slope.
    films : tuple of int, optional
        Which films are made so.
    """

    words: str
    look: video.Look | None = None
    part: float | None = None
    change: Callable[[Film, Frames], Frames] = lambda film, frames: frames
    codec: str = ".avi"
    rate: float | None = None
    other: dict[str, Any] = field(default_factory=dict)
    films: tuple[int, ...] = FILMS

    def film_of(self, number: int) -> Film:
        """Return a film with what makes it hard."""
        film = film_of(number, **self.other)
        if self.rate is not None:
            film = replace(film, rate=self.rate)
        return film if self.part is None else replace(film, exposure_s=self.part / film.rate)


def uneven(film: Film, frames: Frames) -> Frames:
    """A lamp on one side: on the other a quarter of the light is left."""
    light = np.linspace(1.0, 0.25, film.camera.width)[None, :, None] ** (1.0 / GAMMA)
    for frame in frames:
        yield np.clip(np.rint(frame * light), 0, 255).astype(np.uint8)


def flicker(film: Film, frames: Frames) -> Frames:
    """A lamp on mains of 50 Hz, whose light changes by a tenth a hundred times a second."""
    for number, frame in enumerate(frames):
        light = (1.0 + 0.1 * math.sin(math.tau * 100.0 * number / film.rate)) ** (1.0 / GAMMA)
        yield np.clip(np.rint(frame * light * 0.93), 0, 255).astype(np.uint8)


def cut(film: Film, frames: Frames) -> Frames:
    """The upper edge of the picture is at 1.6 radii.

    A fifth of the height of the hoop is out of it.
    """
    _, edge = film.plane.to_pixels(0.0, 1.6 * film.thrown.hoop.require_units().length_m)
    for frame in frames:
        yield np.ascontiguousarray(frame[round(float(edge)) :])


def shutter(film: Film, frames: Frames) -> Frames:
    """A shutter that reads the lines from the top in 12 ms, here in bands of a millisecond."""
    random, look = np.random.default_rng(film.seed), video.Look()
    scene = synthetic._Scene(film.camera, look, random)
    bands = np.array_split(np.arange(film.camera.height), _BANDS)
    for number in range(round((SECONDS - _READ_S) * film.rate)):
        found = np.empty((film.camera.height, film.camera.width, 3), dtype=np.uint8)
        for k, lines in enumerate(bands):
            begin = number / film.rate + k * _READ_S / _BANDS
            frame = synthetic._frame(
                scene, film.thrown.motion, look, begin, film.exposure_s, random
            )
            found[lines] = frame[lines]
        yield found


NOISE = 0.08 * 255.0
_READ_S, _BANDS = 0.012, 12
HARD = {
    "plain": Hard("as these are"),
    "uneven": Hard("a lamp at one side, four times as bright there", change=uneven),
    "flicker": Hard("a lamp that flickers by ±10 % at 100 Hz", change=flicker),
    "blur": Hard("exposed for the whole time between two frames", part=1.0),
    "cut": Hard("the top fifth of the hoop out of the picture", change=cut),
    "colour": Hard("a red marker before a reddish wall", look=video.Look(wall=(196, 120, 108))),
    "noise": Hard("noise of 8 % of full scale", look=video.Look(noise=NOISE)),
    "mpeg4": Hard("MPEG-4, as OpenCV writes it", codec=".mp4"),
    "h264": Hard("H.264, quality 28", codec="h264"),
    "inside": Hard(
        "a particle and its marker at 0.6 R, inside the rim", other={"offset": 0.6}, films=(0, 2)
    ),
    "tilted": Hard(
        "a floor that falls by 2°, of which nobody told",
        other={"slope": math.radians(-2.0)},
        films=(0, 2),
    ),
    "slow": Hard(
        "60 frames a second, exposed for the whole time between two",
        rate=60.0,
        part=1.0,
        films=(0, 2),
    ),
    "shutter": Hard(
        "60 frames a second, exposed for half of the time, lines read in 12 ms",
        rate=60.0,
        part=0.5,
        change=shutter,
        films=(0, 2),
    ),
}


def write(film: Film, hard: Hard, path: Path) -> None:
    """Write a film that is hard."""
    frames = hard.change(
        film,
        video.synthetic_frames(
            film.thrown.motion,
            film.camera,
            fps=film.rate,
            exposure_s=film.exposure_s,
            seconds=SECONDS,
            look=hard.look,
            seed=film.seed,
        ),
    )
    first = next(frames)
    size = (first.shape[1], first.shape[0])
    if hard.codec == "h264":
        size_text = f"{size[0]}x{size[1]}"
        flags = f"-y -loglevel error -f rawvideo -pix_fmt bgr24 -s {size_text} -r 30 -i -".split()
        encode = "-c:v libx264 -crf 28 -pix_fmt yuv420p".split()
        with subprocess.Popen(
            ["ffmpeg", *flags, *encode, str(path)], stdin=subprocess.PIPE
        ) as program:
            assert program.stdin is not None
            for frame in (first, *frames):
                program.stdin.write(frame.tobytes())
        return
    with FrameWriter(path, size) as writer:
        for frame in (first, *frames):
            writer.write(frame)


def shifted(film: Film, hard: Hard) -> video.Plane:
    """Return the true plane in the frames that are kept."""
    if hard.change is not cut:
        return film.plane
    _, edge = film.plane.to_pixels(0.0, 1.6 * film.thrown.hoop.require_units().length_m)
    up = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, -round(float(edge))], [0.0, 0.0, 1.0]])
    return video.Plane(up @ film.plane.matrix)


def line_of(name: str, number: int) -> list[str]:
    """Track and fit one hard film.

    The track is by the true plane, the fit by the plane that the hoop itself tells.
    """
    hard, film = HARD[name], HARD[name].film_of(number)
    told = replace(film.thrown.guess, slope=0.0)
    length = film.thrown.hoop.require_units().length_m
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"film{'.mp4' if hard.codec == 'h264' else hard.codec}"
        write(film, hard, path)
        plane = shifted(film, hard)
        cells = [name, str(number)]
        pixels = plane.pixels_per_metre(0.0, length) * length
        try:
            track = lw.track_video(path, told, plane=plane, fps=film.rate)
        except video.VideoError as error:
            return [*cells, *[""] * 5, type(error).__name__, "", ""]
        errors = film.errors(track)
        seen = {one: values[np.isfinite(values)] for one, values in errors.items()}
        centre = math.hypot(
            *(float(np.sqrt(np.mean(np.square(seen[one])))) for one in ("x", "y"))
        ) / math.sqrt(2.0)
        marker = film.thrown.hoop.offset * float(np.sqrt(np.mean(np.square(seen["theta"]))))
        cells += [str(track.time.size), str(seen["x"].size), str(seen["theta"].size)]
        cells += [f"{pixels * centre:.3g}", f"{pixels * marker:.3g}"]
        try:
            plane = video.find_plane(path, length)
            track = lw.track_video(path, told, plane=plane, fps=film.rate)
        except video.VideoError as error:
            return [*cells, type(error).__name__, "", ""]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.FitWarning)
        result = lw.fit(track, told, free=FREE, slips_at_start=True)
    found = [one for one in FREE if result.estimates[one].identifiable]
    true = film.thrown.hoop
    off = [
        abs(result.estimates[one].value - getattr(true, one)) / result.estimates[one].std_error
        for one in found
    ]
    return [
        *cells,
        "found",
        f"{max(off):.2f}",
        " ".join(dict.fromkeys(one.name for one in result.doubts)),
    ]


def main() -> None:
    """Print the lines of the conditions that are named, or of all."""
    print(",".join(HEAD), flush=True)
    for name in sys.argv[1:] or HARD:
        for number in HARD[name].films:
            print(",".join(line_of(name, number)), flush=True)


if __name__ == "__main__":
    main()
