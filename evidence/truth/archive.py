"""Builds the archive of the data set: certificates, tables in CSV, descriptions, a Frictionless data package.

    python3 archive.py [--out FOLDER] [--parquet]

The archive is a tar without compression, in order of names and without times or owners, so that it has the same bytes
wherever it is built. Parquet, whose bytes depend on the version of pyarrow, is written beside it.
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
NAME = "littlewood-truth-2"
STATE = ("time", "theta", "theta_rate", "slip", "x", "gap", "gap_rate", "energy")
TITLE = "Certified motions of Littlewood's hoop"

Row = dict[str, Any]


def certificates() -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield all certificates by name."""
    for path in sorted((HERE / "certificates").glob("*.json")):
        yield path.stem, json.loads(path.read_text(encoding="utf-8"))


def motions() -> Iterator[Row]:
    """Yield a row for each motion."""
    for name, one in certificates():
        case = one["case"]
        yield {
            "motion": name,
            "family": case["family"],
            "units": case["units"],
            "certified": one["certified"],
            "end": one["end"]["kind"] if one["certified"] else "",
            "events": len(one.get("events", ())),
            "reason": one.get("reason", ""),
        }


def events() -> Iterator[Row]:
    """Yield a row for each event, with all digits and the radii."""
    for name, one in certificates():
        for number, event in enumerate(one.get("events", ())):
            row: Row = {"motion": name, "event": number, "cause": event["cause"], "to": event["to"] or ""}
            row["direction"] = event["direction"]
            for key in STATE:
                middle, radius = event["state"].get(key, ("", ""))
                row |= {key: middle, f"{key}_radius": radius}
            yield row


def samples() -> Iterator[Row]:
    """Yield a row for each sample, its numbers rounded to doubles."""
    for name, one in certificates():
        for number, phase in enumerate(one.get("phases", ())):
            for sample in phase["samples"]:
                row: Row = {"motion": name, "phase": number, "mode": phase["mode"], "direction": phase["direction"]}
                yield row | {key: float(Fraction(sample[key][0])) for key in (*STATE, "normal", "friction")}


TABLES = {"motions": motions, "events": events, "samples": samples}


def table(rows: list[Row]) -> bytes:
    """Return the CSV of a table."""
    file = io.StringIO()
    writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return file.getvalue().encode()


def kind(value: Any) -> str:
    """Return the type of a field of a data package."""
    kinds: dict[type, str] = {bool: "boolean", int: "integer", float: "number"}
    return kinds.get(type(value), "string")


def package(tables: dict[str, list[Row]], files: dict[str, bytes]) -> bytes:
    """Return the description of the data package."""
    resources = [
        {
            "name": name,
            "path": f"tables/{name}.csv",
            "format": "csv",
            "mediatype": "text/csv",
            "encoding": "utf-8",
            "bytes": len(files[f"tables/{name}.csv"]),
            "hash": "sha256:" + hashlib.sha256(files[f"tables/{name}.csv"]).hexdigest(),
            "schema": {"fields": [{"name": key, "type": kind(value)} for key, value in rows[0].items()]},
        }
        for name, rows in tables.items()
    ]
    described = {
        "name": NAME,
        "title": TITLE,
        "version": "2",
        "licenses": [{"name": "CC0-1.0", "path": "https://creativecommons.org/publicdomain/zero/1.0/"}],
        "resources": resources,
    }
    return (json.dumps(described, indent=1) + "\n").encode()


def contents() -> dict[str, bytes]:
    """Return the files of the archive."""
    tables = {name: list(rows()) for name, rows in TABLES.items()}
    files = {f"tables/{name}.csv": table(rows) for name, rows in tables.items()}
    for path in [*(HERE / "certificates").glob("*.json"), HERE / "cases.json", HERE / "certificate.schema.json"]:
        files[str(path.relative_to(HERE).as_posix())] = path.read_bytes()
    files["checker.py"] = (HERE.parents[1] / "python" / "littlewood" / "certify" / "checker.py").read_bytes()
    for path in (HERE / "LICENSE", HERE / "families.md", HERE / "CITATION.cff"):
        files[path.name] = path.read_bytes()
    files["datapackage.json"] = package(tables, files)
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
        "--parquet", action="store_true", help="write the tables in Parquet, too; needs pandas and pyarrow"
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
