"""The command ``python -m littlewood.certify``."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any

from .._internal.terminal import forgive
from ..plot import canvas
from ..tables import QUANTITIES
from . import Case, CaseError, NoCertificate, Proof, Refused, checker, picture
from .case import HOOP, HOOP_SI, LAWS, ROLLING_RESISTANCE, START

EXAMPLE = (
    "python -m littlewood.certify --mass-ratio 1 --offset 1 --inertia 1 --mu-s 0.5 --mu-k 0.4"
    " --theta 1.5707963267948966 --theta-rate 2"
)


def parser() -> argparse.ArgumentParser:
    """Return the parser of the command line."""
    found = argparse.ArgumentParser(
        prog="python -m littlewood.certify",
        description="Certificate of a motion, as JSON: each event with 30 digits and a bound on "
        "their error.",
        epilog=f"example: {EXAMPLE}",
    )
    found.add_argument("--check", metavar="FILE", type=Path, help="check this certificate")
    found.add_argument(
        "--case",
        metavar="FILE",
        type=Path,
        help="a case in JSON, as a certificate has it, in place of numbers",
    )
    found.add_argument("--out", metavar="FILE", type=Path, help="write to this file")
    found.add_argument(
        "--picture",
        metavar="FILE",
        type=Path,
        help="check the certificate, and draw its proof: .svg, .pdf or .png",
    )
    found.add_argument(
        "--width-mm", metavar="MM", type=float, default=120.0, help="width of the picture"
    )
    found.add_argument(
        "--most-bits", metavar="BITS", type=int, default=1000, help="precision at which to give up"
    )
    found.add_argument("--until", metavar="TIME", type=float, help="stop at this time")
    for name in ROLLING_RESISTANCE.values():
        found.add_argument(
            "--" + name.replace("_", "-"),
            metavar="X",
            type=float,
            default=0.0,
            help=QUANTITIES[name].help,
        )
    found.add_argument(
        "--slope", metavar="RAD", type=float, default=0.0, help=QUANTITIES["slope"].help
    )
    found.add_argument(
        "--restitution", metavar="E", type=float, help=QUANTITIES["restitution"].help
    )
    found.add_argument(
        "--restitution-law", choices=LAWS, default=LAWS[0], help="law of restitution"
    )
    for name in dict.fromkeys(HOOP + HOOP_SI):
        found.add_argument(
            "--" + name.replace("_", "-"), metavar="X", type=float, help="of the hoop"
        )
    for name in START:
        found.add_argument(
            "--" + name.replace("_", "-"), metavar="X", type=float, default=0.0, help="of the start"
        )
    return found


def case_of(given: argparse.Namespace) -> Case:
    """Return the case of the command line."""
    if given.case is not None:
        found = checker.read_file(given.case)
        if not isinstance(found, dict):
            raise CaseError(f"{given.case} has no case")
        return Case.read(found.get("case", found))
    si = given.disc_mass_kg is not None
    units = "si" if si else "dimensionless"
    names = HOOP_SI if si else HOOP
    hoop: dict[str, Any] = {name: getattr(given, name) for name in names}
    missing = ["--" + name.replace("_", "-") for name, value in hoop.items() if value is None]
    if missing:
        raise CaseError(f"a hoop needs {', '.join(missing)}")
    for name in (ROLLING_RESISTANCE[units], "slope"):
        hoop[name] = getattr(given, name)
    if given.restitution is not None:
        hoop |= {"restitution": given.restitution, "restitution_law": given.restitution_law}
    start = {name: getattr(given, name) for name in START}
    return Case.read(
        {
            "units": units,
            "hoop": hoop,
            "start": start,
            "until": given.until,
        }
    )


def _made(given: argparse.Namespace) -> Any:
    """Make and write the certificate of the case of the command line."""
    from .certificate import certify, dump

    certificate = certify(case_of(given), given.most_bits)
    text = dump(certificate)
    if given.out is None:
        sys.stdout.write(text)
    else:
        given.out.write_text(text, encoding="utf-8")
    return certificate


def _draw(certificate: Any, given: argparse.Namespace) -> None:
    """Write the picture of the proof of a certificate."""
    found = Proof.of(certificate)
    canvas.save(
        found.plot(given.width_mm),
        given.picture,
        picture.title(found),
        picture.description(found),
    )
    print(f"{given.picture}: {picture.title(found)}", file=sys.stderr)


def main(arguments: list[str] | None = None) -> int:
    """Run the command: 0; 1 where something is not certified or refused.

    2 where the input is not right.
    """
    given = parser().parse_args(arguments)
    try:
        if given.picture is not None:
            canvas.format_of(given.picture)
        if given.check is not None and given.picture is None:
            return checker.main([str(given.check)])
        certificate = _made(given) if given.check is None else checker.read_file(given.check)
        if given.picture is not None and (given.check is not None or certificate["certified"]):
            _draw(certificate, given)
    except Refused as refused:
        print(f"{given.check or given.out}: refused: {refused}", file=sys.stderr)
        return 1
    except (CaseError, NoCertificate) as error:
        print(f"error: {error}\nhint: {EXAMPLE}", file=sys.stderr)
        return 2
    except (ImportError, OSError, canvas.PictureError, checker.Unreadable) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    if not certificate["certified"]:
        print(f"not certified: {certificate['reason']}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    forgive()
    sys.exit(main())
