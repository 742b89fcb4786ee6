"""The command ``littlewood fit``.

Friction, inertia and restitution from a film, or from the table of a tracker.
"""

from __future__ import annotations

import argparse
import math
import shlex
import sys
import warnings
import webbrowser
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .._internal.extras import require
from ..fitting.fall import Fall, fall_of
from ..fitting.given import checked_errors, usual_in_words
from ..fitting.least_squares import fit
from ..fitting.problem import OF_HOOP
from ..fitting.result import FitResult, FitWarning
from ..fitting.table_options import LENGTH_UNITS, TIME_UNITS, TableOptions, Words
from ..fitting.track import Track, track_of_table
from ..fitting.usual_errors import USUAL_ERRORS
from ..hoop import Hoop
from ..tables import QUANTITIES, SI_HOOP
from ..video.plane import Plane

__all__ = ["MissingAnswerError", "WrongClockError", "main"]

_REFUSED = 2
"""Exit code of what is refused."""
_INTERRUPTED = 130
_FILMS = (".mp4", ".mov", ".m4v", ".avi", ".mkv", ".webm", ".3gp", ".gif")
# What is weighed and measured. Slope and rate are asked for as well.
_ASKED = ("disc_mass_kg", "particle_mass_kg", "radius_m", "offset_m")
_GUESSED = ("inertia_kg_m2", "mu_s", "mu_k", "restitution", "rolling_resistance_m")
# A dry floor, and a rim of which all mass is at the radius.
_MU_S, _MU_K = 0.5, 0.3
_FREE = tuple(name for name in OF_HOOP if name != "slope")
_TRIES = 3
_QUALITY = 88
_FLAGS = Words(
    {
        "centre": "--centre {}",
        "marker": "--marker {}",
        "run": "--run {}",
        "fps": "--rate {}",
        "plane": "--point U V X Y, four times or more",
        "length_unit": "--length-unit {}",
        "time_unit": "--time-unit {}",
        "dimensionless": "--dimensionless",
        "ignore": "--ignore {}",
    },
    shlex.quote,
)
"""Options of a table as flags of this command."""


class MissingAnswerError(ValueError):
    """What nobody has said, where nobody can be asked.

    Attributes
    ----------
    flag : str
        The flag that says it.
    """

    def __init__(self, flag: str, meaning: str) -> None:
        super().__init__(f"{flag} is missing: {meaning}")
        self.flag = flag


class WrongClockError(ValueError):
    """A track in which the hoop falls too slowly or too fast for a body in flight.

    Attributes
    ----------
    fall : littlewood.fitting.fall.Fall
        How it falls.
    """

    def __init__(self, fall: Fall, rate: float | None) -> None:
        factor = 1.0 + fall.clock
        remedy = (
            f"were all times {factor:.3g} times as long"
            if rate is None
            else f"was the film taken at about {rate / factor:.3g} frames a second (--rate)"
        )
        super().__init__(
            f"in flight the mass centre falls with {fall.gravity:.3g} ± {fall.std_error:.1g} g, so "
            f"the clock is {100.0 * abs(fall.clock):.2g} ± {100.0 * fall.clock_error:.1g} % off: "
            f"{remedy}, or are all lengths {fall.gravity:.3g} times too large (--radius-m)? "
            "--any-clock fits it as it is"
        )
        self.fall = fall


def _check_clock(track: Track, hoop: Hoop, rate: float | None, is_any: bool) -> None:
    """Refuse a track whose flights are not those of a body that falls, or only say so."""
    fall = fall_of(track, hoop)
    if fall is None or not fall.is_wrong:
        return
    error = WrongClockError(fall, rate)
    if not is_any:
        raise error
    print(f"note: {error}", file=sys.stderr)


def _flag(name: str) -> str:
    return "--" + name.replace("_", "-")


def _positive(text: str) -> float:
    value = float(text)
    if not (value > 0.0 and math.isfinite(value)):
        raise argparse.ArgumentTypeError(f"{text} must be positive")
    return value


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="littlewood fit",
        description="Measure friction, inertia and restitution of a hoop from a film, or from the "
        "table of a tracker. "
        "What is not given and cannot be known is asked for.",
        epilog="example: littlewood fit film.mp4 --rate 240 --radius-m 0.3 --offset-m 0.27 "
        "--disc-mass-kg 0.25 "
        "--particle-mass-kg 0.25 --slope 0",
    )
    parser.add_argument(
        "file",
        metavar="FILE",
        type=Path,
        help="the film, or a table with time_s, theta_deg, x_m, y_m",
    )
    parser.add_argument(
        "--out",
        metavar="PAGE",
        type=Path,
        help="the report (default: FILE-report.html beside FILE)",
    )
    parser.add_argument("--show", action="store_true", help="open the report in the browser")
    hoop = parser.add_argument_group("the hoop")
    for name in SI_HOOP:
        if name in _ASKED:
            hoop.add_argument(_flag(name), metavar="X", type=float, help=QUANTITIES[name].help)
        elif name in _GUESSED:
            words = (
                "all mass at the rim"
                if name == "inertia_kg_m2"
                else {"mu_s": _MU_S, "mu_k": _MU_K, "rolling_resistance_m": 0}.get(name, "none")
            )
            hoop.add_argument(
                _flag(name),
                metavar="X",
                type=float,
                help=f"{QUANTITIES[name].help}: a first guess (default: {words})",
            )
    slope = hoop.add_mutually_exclusive_group()
    slope.add_argument(
        "--slope",
        metavar="RAD",
        type=float,
        help="angle by which the plane rises to the right, radians",
    )
    slope.add_argument("--slope-deg", metavar="DEGREES", type=float, help="the same in degrees")
    parser.add_argument(
        "--free",
        metavar="NAME",
        nargs="+",
        choices=OF_HOOP,
        default=list(_FREE),
        help=f"what is estimated, of {', '.join(OF_HOOP)} (default: all but slope); the rest is "
        f"held",
    )
    parser.add_argument(
        "--error",
        metavar=("NAME", "SIZE"),
        nargs=2,
        action="append",
        default=[],
        help="how well something is known, so that the intervals include it; several times: "
        "mass_ratio, offset, inertia, clock and camera_scale as parts of 1, slope in radians",
    )
    parser.add_argument(
        "--usual-errors",
        action="store_true",
        help="the intervals include usual errors of what was weighed and measured: "
        f"{usual_in_words()}".replace("%", "%%"),
    )
    parser.add_argument(
        "--any-clock",
        action="store_true",
        help="fit also where flights contradict the times",
    )
    film = parser.add_argument_group("a film")
    film.add_argument(
        "--rate", metavar="HZ", type=_positive, help="frames a second at which it was taken"
    )
    film.add_argument(
        "--exposure-s",
        metavar="S",
        type=_positive,
        help="how long a frame was exposed (default: estimated)",
    )
    film.add_argument(
        "--marker",
        metavar="COLOUR",
        help="colour of the marker (default: red); of a table, its point",
    )
    film.add_argument(
        "--first", metavar="N", type=int, default=0, help="first frame that is used, from 0"
    )
    film.add_argument("--last", metavar="N", type=int, help="the frame after the last that is used")
    film.add_argument(
        "--point",
        metavar=("U", "V", "X", "Y"),
        nargs=4,
        type=float,
        action="append",
        help="a measured point of the plane of the motion: pixels to the right and down, m to the "
        "right and up from "
        "the floor; four or more (default: the hoop itself is the ruler)",
    )
    table = parser.add_argument_group("a table")
    table.add_argument(
        "--centre", metavar="NAME", help="the point that is the centre, in exports that name points"
    )
    table.add_argument(
        "--run", metavar="N", help="number or name of the run or data set, in exports with several"
    )
    table.add_argument(
        "--length-unit",
        metavar="UNIT",
        choices=LENGTH_UNITS,
        help=f"{', '.join(LENGTH_UNITS)}, in tables that do not say it",
    )
    table.add_argument(
        "--time-unit",
        metavar="UNIT",
        choices=TIME_UNITS,
        help=f"{', '.join(TIME_UNITS)}, in tables that do not say it",
    )
    table.add_argument(
        "--dimensionless",
        action="store_true",
        help="names without units are dimensionless: in radii R, and times in √(R/g)",
    )
    table.add_argument(
        "--ignore",
        metavar="NAME",
        action="append",
        default=[],
        help="a column that is passed over; may be given several times",
    )
    table.add_argument(
        "--level", action="store_true", help="on a slope: x and y are those of a level camera"
    )
    return parser


def _ask(question: str, flag: str, default: float | None = None) -> float:
    """Ask at the terminal; without one a missing answer is an error."""
    if not sys.stdin.isatty():
        raise MissingAnswerError(flag, question)
    usual = "" if default is None else f" [{default:g}]"
    for _ in range(_TRIES):
        try:
            text = input(f"{question}{usual}: ").strip().replace(",", ".")
        except EOFError:
            break
        if not text and default is not None:
            return default
        try:
            value = float(text)
        except ValueError:
            value = math.nan
        if math.isfinite(value):
            return value
        print(f"{text!r} is not a number", file=sys.stderr)
    raise MissingAnswerError(flag, question)


def _hoop_of(options: argparse.Namespace) -> Hoop:
    """Return the hoop as its owner knows it."""
    given: dict[str, Any] = {}
    for name in _ASKED:
        value = getattr(options, name)
        given[name] = _ask(QUANTITIES[name].help, _flag(name)) if value is None else value
    slope = options.slope if options.slope_deg is None else math.radians(options.slope_deg)
    if slope is None:
        slope = math.radians(
            _ask("Angle by which the plane rises to the right, degrees", "--slope-deg", 0.0)
        )
    mu_k = _MU_K if options.mu_k is None else options.mu_k
    mu_s = max(_MU_S, mu_k) if options.mu_s is None else options.mu_s
    if options.mu_k is None:
        mu_k = min(mu_k, mu_s)
    inertia = options.inertia_kg_m2
    if inertia is None:
        inertia = given["disc_mass_kg"] * given["radius_m"] ** 2
    return Hoop.from_si(
        **given,
        inertia_kg_m2=inertia,
        mu_s=mu_s,
        mu_k=mu_k,
        slope=slope,
        restitution=options.restitution,
        rolling_resistance_m=options.rolling_resistance_m or 0.0,
    )


def _errors(options: argparse.Namespace) -> dict[str, float]:
    """Return how well is known what was weighed and measured."""
    try:
        told = checked_errors({name: float(size) for name, size in options.error})
    except ValueError as error:
        raise ValueError(f"--error: {error}") from None
    return {**USUAL_ERRORS, **told} if options.usual_errors else told


def _plane(options: argparse.Namespace) -> Plane | None:
    """Return the plane of the measured points, if there are any."""
    if options.point is None:
        return None
    return Plane.from_points([one[:2] for one in options.point], [one[2:] for one in options.point])


def _is_film(path: Path) -> bool:
    if path.suffix.lower() in _FILMS:
        return True
    if not path.is_file():
        # Who reads it says what it is.
        return False
    with path.open("rb") as file:
        begin = file.read(4096)
    return b"\0" in begin and not begin.startswith((b"\xff\xfe", b"\xfe\xff", b"PK", b"\xd0\xcf"))


def _has_bar() -> bool:
    if not sys.stderr.isatty():
        return False
    try:
        require("tqdm")
    except ImportError:
        return False
    return True


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; exit code 0, or 2 where something was refused."""
    options = _parser().parse_args(arguments)
    try:
        _run(options)
    except (ValueError, OSError, ImportError) as error:
        print(f"error: {error}", file=sys.stderr)
        return _REFUSED
    except KeyboardInterrupt:
        return _INTERRUPTED
    return 0


def _run(options: argparse.Namespace) -> None:
    path: Path = options.file
    out = path.with_name(f"{path.stem}-report.html") if options.out is None else options.out
    if not out.parent.is_dir():
        raise ValueError(f"{out}: there is no such folder")
    for module in ("scipy.optimize", "matplotlib", "xarray"):
        require(module)
    if _is_film(path):
        result, picture = _from_film(options, path)
        photo = out.with_suffix(".jpg")
        photo.write_bytes(picture)
        print(f"{photo}: the film and the fitted motion", file=sys.stderr)
    else:
        result, picture = _from_table(options, path), None
    from ..fitting.report import report_html

    print(result)
    out.write_text(
        report_html(result, title=f"A hoop, measured from {path.name}", photo=picture),
        encoding="utf-8",
    )
    print(f"{out}: the report", file=sys.stderr)
    if options.show:
        webbrowser.open(out.resolve().as_uri())


def _from_film(options: argparse.Namespace, path: Path) -> tuple[FitResult, bytes]:
    from .. import video

    marker = options.marker or "red"
    video.tracking.colour_of(marker)
    clock = video.clock_of(path)
    rate = options.rate
    if rate is None and clock.taken is None:
        played = float(f"{clock.rate:.6g}")
        question = (
            "Frames a second at which the film was taken "
            f"(it is played at {played:g}; slow motion is taken faster)"
        )
        rate = _ask(question, "--rate", played)
    options.rate = clock.require_rate(rate)
    for note in (*clock.facts(rate), *clock.doubts(rate)):
        print(f"note: {note}", file=sys.stderr)
    # What makes no sense is refused before the long work.
    _errors(options)
    hoop = _hoop_of(options)
    radius_m = hoop.require_units().length_m
    plane = _plane(options) or video.find_plane(
        path, radius_m, first=options.first, last=options.last
    )
    bar = _has_bar()
    with warnings.catch_warnings():
        # The notes have them.
        warnings.simplefilter("ignore", video.VideoWarning)
        track = video.track_video(
            path,
            hoop,
            plane=plane,
            fps=rate,
            marker=marker,
            first=options.first,
            last=options.last,
            exposure_s=options.exposure_s,
            progress=bar,
        )
    result = _fit(options, track, hoop, bar)
    picture = video.overlay_picture(path, result, plane=plane, fps=rate, track=track)
    cv2 = require("cv2")
    _, encoded = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, _QUALITY])
    return result, encoded.tobytes()


def _from_table(options: argparse.Namespace, path: Path) -> FitResult:
    hoop = _hoop_of(options)
    said = TableOptions(
        level=options.level,
        centre=options.centre,
        marker=options.marker,
        run=options.run,
        fps=options.rate,
        plane=_plane(options),
        length_unit=options.length_unit,
        time_unit=options.time_unit,
        dimensionless=options.dimensionless,
        ignore=tuple(options.ignore),
        words=_FLAGS,
    )
    track = track_of_table(path, hoop.units, said)
    for note in track.notes:
        print(f"note: {note}", file=sys.stderr)
    return _fit(options, track, hoop, _has_bar())


def _fit(options: argparse.Namespace, track: Track, hoop: Hoop, bar: bool) -> FitResult:
    _check_clock(track, hoop, options.rate, options.any_clock)
    with warnings.catch_warnings():
        # The table has them.
        warnings.simplefilter("ignore", FitWarning)
        return fit(
            track,
            hoop,
            free=options.free,
            slips_at_start=True,
            errors=_errors(options),
            progress=bar,
        )
