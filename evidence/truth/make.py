"""Makes the certificates of the data set from the cases of littlewood.scoring.

    python3 make.py [FAMILY ...]

Each motion has a file in certificates/. The same bytes again, on any machine.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

from littlewood.certify import Case, certify, dump
from littlewood.scoring import CASES

HERE = Path(__file__).parent


def main() -> None:
    """Make all certificates, or those of some families."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("family", nargs="*", help="families to make; all without any")
    wanted = parser.parse_args().family
    cases = [one.given for one in CASES.values()]
    unknown = set(wanted) - {one["family"] for one in cases}
    if unknown:
        parser.error(f"there is no family {', '.join(sorted(unknown))}")
    folder = HERE / "certificates"
    folder.mkdir(exist_ok=True)
    for one in cases:
        if wanted and one["family"] not in wanted:
            continue
        began = time.perf_counter()
        certificate = certify(Case.read(one))
        (folder / f"{one['name']}.json").write_text(dump(certificate), encoding="utf-8")
        said = (
            certificate["end"]["kind"]
            if certificate["certified"]
            else f"not certified: {certificate['reason']}"
        )
        print(f"{one['name']:24} {time.perf_counter() - began:6.1f} s  {said}", flush=True)


if __name__ == "__main__":
    main()
