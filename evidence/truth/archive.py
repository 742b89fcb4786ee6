"""Builds the archive of the data set.

Certificates, tables in CSV, README, a Frictionless data package.

    python3 archive.py [--out FOLDER] [--parquet]

The archive is a tar without compression, in order of names and without times or owners, so that it
has the same bytes wherever it is built. Parquet, whose bytes depend on the version of pyarrow, is
written beside it.
"""

from __future__ import annotations

import argparse
import csv
import hashlib
import io
import json
import tarfile
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
PACKAGE = HERE.parents[1] / "python" / "littlewood"
VERSION = "3"
NAME = f"littlewood-truth-{VERSION}"
HOME = "https://github.com/littlewood-hoop/littlewood"
TITLE = "Certified motions of Littlewood's hoop"
DESCRIPTION = (
    "Motions of a hoop with a particle on it, on a rough plane: "
    "it rolls, slides, lifts off, lands and bounces. "
    "Time and state of every event, "
    "each a midpoint and a radius that provably encloses the true number."
)
CONTRIBUTORS = [{"title": "The littlewood maintainers", "role": "author", "path": HOME}]

UNITS = {
    "time": ("√(R/g)", "s"),
    "theta": ("rad", "rad"),
    "theta_rate": ("√(g/R)", "rad/s"),
    "slip": ("√(gR)", "m/s"),
    "x": ("R", "m"),
    "gap": ("R", "m"),
    "gap_rate": ("√(gR)", "m/s"),
    "energy": ("m2 g R", "J"),
    "normal": ("m2 g", "N"),
    "friction": ("m2 g", "N"),
    "couple": ("m2 g R", "N m"),
    "normal_impulse": ("m2 √(gR)", "N s"),
    "friction_impulse": ("m2 √(gR)", "N s"),
    "energy_lost": ("m2 g R", "J"),
    "mass_ratio": ("1", "1"),
    "offset": ("R", "1"),
    "inertia": ("m2 R²", "1"),
    "mu_s": ("1", "1"),
    "mu_k": ("1", "1"),
    "rolling_resistance": ("1", "m"),
    "slope": ("rad", "rad"),
    "restitution": ("1", "1"),
    "until": ("√(R/g)", "s"),
}
"""Units of a number where the column `units` says dimensionless, and where it says si."""

MEANINGS = {
    "motion": "name of the motion",
    "family": "what the motion shows; families.md describes each",
    "units": "dimensionless (m2 = R = g = 1) or si: which of its units a number of the row has",
    "certified": "whether all of it is proved",
    "end": "how it ends",
    "events": "how many events it has",
    "reason": "why nothing is certified",
    "event": "number of the event in its motion, from 0",
    "half_swings": "of a motion that rests: how often it rolled from one θ′ = 0 to the next",
    "cause": "what happens",
    "to": "motion that follows; empty where it ends",
    "direction": "sign of the slip velocity where the contact slips, else 0",
    "rotation": "sign of θ′ while the hoop turns in contact, else 0; with rolling resistance only",
    "impact": "how friction acts in the impact; empty where there is none",
    "phase": "number of the phase in its motion, from 0",
    "mode": "motion in the phase",
    "time": "time",
    "theta": "angle of the particle from the normal of the plane, counterclockwise",
    "theta_rate": "its rate",
    "slip": "velocity of the point of contact along the plane",
    "x": "place of the centre along the plane",
    "gap": "height of the rim over the plane",
    "gap_rate": "its rate",
    "energy": "total energy",
    "normal": "force of the plane along its normal",
    "friction": "force of the plane along it",
    "couple": "couple of rolling resistance; empty without it",
    "normal_impulse": "impulse of the plane along its normal",
    "friction_impulse": "impulse of the plane along it",
    "energy_lost": "energy lost in the impact",
    "mass_ratio": "mass of the hoop over that of the particle",
    "offset": "distance of the particle from the centre over the radius",
    "inertia": "moment of inertia of the hoop about its centre over m2 R²",
    "mu_s": "coefficient of static friction",
    "mu_k": "coefficient of kinetic friction",
    "rolling_resistance": "coefficient of rolling resistance, a length",
    "slope": "angle of the plane, which rises to the right",
    "restitution": "coefficient of restitution; empty where a landing ends the motion",
    "restitution_law": "energetic, poisson or newton",
    "until": "where the motion is stopped; empty where it goes to its end",
}

SI_HOOP = (
    "disc_mass_kg",
    "particle_mass_kg",
    "radius_m",
    "offset_m",
    "inertia_kg_m2",
    "gravity_m_per_s2",
)
"""Numbers of the hoop in SI units; their columns are empty for the others, whose own numbers are
empty for these."""

KEYS = {
    "motions": ["motion"],
    "events": ["motion", "event"],
    "samples": ["motion", "phase", "time"],
}

STATE = ("time", "theta", "theta_rate", "slip", "x", "gap", "gap_rate", "energy")
START = ("theta", "theta_rate", "slip", "gap_rate")
IMPULSES = ("normal_impulse", "friction_impulse", "energy_lost")

Row = dict[str, Any]


def certificates() -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield all certificates by name."""
    for path in sorted((HERE / "certificates").glob("*.json")):
        yield path.stem, json.loads(path.read_text(encoding="utf-8"))


def motions() -> Iterator[Row]:
    """Yield a row for each motion."""
    for name, one in certificates():
        case = one["case"]
        hoop, start = case["hoop"], case["start"]
        yield {
            "motion": name,
            "family": case["family"],
            "units": case["units"],
            **{
                key: hoop.get(key, "")
                for key in ("mass_ratio", "offset", "inertia", *SI_HOOP, "mu_s", "mu_k")
            },
            "rolling_resistance": hoop.get(
                "rolling_resistance_m" if case["units"] == "si" else "rolling_resistance", 0.0
            ),
            "slope": hoop.get("slope", 0.0),
            "restitution": hoop.get("restitution", ""),
            "restitution_law": hoop.get("restitution_law", ""),
            **{f"start_{key}": start[key] for key in START},
            "until": "" if case["until"] is None else case["until"],
            "certified": one["certified"],
            "end": one["end"]["kind"] if one["certified"] else "",
            "half_swings": one.get("end", {}).get("half_swings", ""),
            "events": len(one.get("events", ())),
            "reason": one.get("reason", ""),
        }


def events() -> Iterator[Row]:
    """Yield a row for each event, with all digits and the radii."""
    for name, one in certificates():
        case = one["case"]
        for number, event in enumerate(one.get("events", ())):
            row: Row = {
                "motion": name,
                "family": case["family"],
                "units": case["units"],
                "event": number,
            }
            row |= {
                "cause": event["cause"],
                "to": event["to"] or "",
                "direction": event["direction"],
                "rotation": event.get("rotation", ""),
            }
            impact = event.get("impact", {})
            row["impact"] = impact.get("case", "")
            balls = {key: event["state"].get(key) for key in STATE}
            balls |= {
                f"{key}_before": impact.get("before", {}).get(key)
                for key in ("theta_rate", "slip", "gap_rate")
            }
            balls |= {key: impact.get(key) for key in IMPULSES}
            for key, ball in balls.items():
                row |= dict(zip((key, f"{key}_radius"), ball or ("", ""), strict=True))
            yield row


def samples() -> Iterator[Row]:
    """Yield a row for each sample, its numbers rounded to doubles."""
    for name, one in certificates():
        for number, phase in enumerate(one.get("phases", ())):
            for sample in phase["samples"]:
                row: Row = {"motion": name, "units": one["case"]["units"], "phase": number}
                row |= {"mode": phase["mode"], "direction": phase["direction"]}
                row["rotation"] = phase.get("rotation", "")
                yield row | {
                    key: float(Fraction(sample[key][0])) if key in sample else ""
                    for key in (*STATE, "normal", "friction", "couple")
                }


TABLES = {"motions": motions, "events": events, "samples": samples}


def table(rows: list[Row]) -> bytes:
    """Return the CSV of a table."""
    file = io.StringIO()
    writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return file.getvalue().encode()


def kind(values: list[Any]) -> str:
    """Return the type of a field of a data package.

    The digits of a ball are a text that no double has.
    """
    kinds: dict[type, str] = {bool: "boolean", int: "integer", float: "number"}
    found = {kinds.get(type(value), "string") for value in values if value != ""}
    return (
        found.pop() if len(found) == 1 else "number" if found == {"integer", "number"} else "string"
    )


def field(name: str, values: list[Any]) -> Row:
    """Return the description of a column."""
    base = name.removesuffix("_radius").removeprefix("start_").removesuffix("_before")
    described: Row = {"name": name, "type": kind(values)}
    meaning = MEANINGS.get(base, "of the hoop, its unit in its name")
    meaning += (
        " at the start"
        if name.startswith("start_")
        else ", before the impact"
        if "_before" in name
        else ""
    )
    if name.endswith("_radius"):
        meaning = f"radius of the ball of {name.removesuffix('_radius')}"
    described["description"] = meaning
    if base in UNITS:
        described["unit"], described["unit_si"] = UNITS[base]
    return described


def package(tables: dict[str, list[Row]], files: dict[str, bytes]) -> bytes:
    """Return the description of the data package."""
    resources = []
    for name, rows in tables.items():
        data = files[f"tables/{name}.csv"]
        schema: Row = {
            "fields": [field(key, [row[key] for row in rows]) for key in rows[0]],
            "primaryKey": KEYS[name],
        }
        if name != "motions":
            reference = {"resource": "motions", "fields": ["motion"]}
            schema["foreignKeys"] = [{"fields": ["motion"], "reference": reference}]
        resources.append(
            {
                "name": name,
                "path": f"tables/{name}.csv",
                "format": "csv",
                "mediatype": "text/csv",
                "encoding": "utf-8",
                "bytes": len(data),
                "hash": "sha256:" + hashlib.sha256(data).hexdigest(),
                "schema": schema,
            }
        )
    described = {
        "name": NAME,
        "title": TITLE,
        "description": DESCRIPTION,
        "version": VERSION,
        "homepage": HOME,
        "keywords": ["contact mechanics", "friction", "impact", "benchmark", "interval arithmetic"],
        "contributors": CONTRIBUTORS,
        "licenses": [
            {"name": "CC0-1.0", "path": "https://creativecommons.org/publicdomain/zero/1.0/"}
        ],
        "resources": resources,
    }
    return (json.dumps(described, indent=1, ensure_ascii=False) + "\n").encode()


def readme(tables: dict[str, list[Row]]) -> bytes:
    """Return what a person reads first."""
    counts = ", ".join(f"{len(rows)} {name}" for name, rows in tables.items())
    return f"""# {TITLE}

{DESCRIPTION} Version {VERSION}: {counts}.

| file | content |
|---|---|
| certificates/NAME.json | one motion with all its balls; \
certificate.schema.json is its JSON schema |
| tables/motions.csv | hoop, start, end of each motion; key: motion |
| tables/events.csv | time, state and impulses of each event, all digits and radii; \
key: motion, event |
| tables/samples.csv | states within the phases as doubles; key: motion, phase, time |
| datapackage.json | types, units and keys of all columns (Frictionless) |
| cases.json | the inputs, and those that the benchmark of contact solvers uses |
| derivatives.json | derivatives of the events of some motions, as balls |
| families.md | what each family shows |
| checker.py | `python3 checker.py certificates/*.json` confirms them; \
it needs Python 3.10 and nothing else |
| SHA256SUMS | `sha256sum --check SHA256SUMS`: \
all files, and so names and families, are those of this version |

A ball is a midpoint and a radius, as texts. Inputs are doubles, taken exactly. Where `units` is \
`dimensionless`,
the mass of the particle, the radius of the hoop and gravity are 1.

Licence: CC0 1.0 (LICENSE). Please cite it by CITATION.cff. Source: {HOME}
""".encode()


def contents() -> dict[str, bytes]:
    """Return the files of the archive."""
    tables = {name: list(rows()) for name, rows in TABLES.items()}
    files = {f"tables/{name}.csv": table(rows) for name, rows in tables.items()}
    for path in [*(HERE / "certificates").glob("*.json"), HERE / "certificate.schema.json"]:
        files[str(path.relative_to(HERE).as_posix())] = path.read_bytes()
    for path in (PACKAGE / "certify" / "checker.py", PACKAGE / "scoring" / "cases.json"):
        files[path.name] = path.read_bytes()
    files["derivatives.json"] = (HERE / "derivatives.json").read_bytes()
    files["README.md"] = readme(tables)
    for path in (HERE / "LICENSE", HERE / "families.md", HERE / "CITATION.cff"):
        files[path.name] = path.read_bytes()
    files["datapackage.json"] = package(tables, files)
    files["SHA256SUMS"] = "".join(
        f"{hashlib.sha256(data).hexdigest()}  {name}\n" for name, data in sorted(files.items())
    ).encode()
    return files


def archive(files: dict[str, bytes]) -> bytes:
    """Return the archive."""
    file = io.BytesIO()
    with tarfile.open(fileobj=file, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for name, data in sorted(files.items()):
            entry = tarfile.TarInfo(f"{NAME}/{name}")
            entry.size, entry.mode = len(data), 0o644
            tar.addfile(entry, io.BytesIO(data))
    return file.getvalue()


def main() -> None:
    """Write the archive."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=Path(), help="folder to write to")
    parser.add_argument(
        "--parquet",
        action="store_true",
        help="write the tables in Parquet, too; needs pandas and pyarrow",
    )
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    data = archive(contents())
    (given.out / f"{NAME}.tar").write_bytes(data)
    print(f"{NAME}.tar  {len(data)} bytes  sha256 {hashlib.sha256(data).hexdigest()}")
    if given.parquet:
        import pandas

        for name, rows in TABLES.items():
            pandas.DataFrame(rows()).to_parquet(given.out / f"{name}.parquet")


if __name__ == "__main__":
    main()
