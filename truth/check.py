"""Checks the certificates of the data set by the checker of the package, which needs no other package.

    python3 check.py [NAME ...]

Names are those of files in certificates/, or the beginnings of them.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path

from littlewood.certify import Refused, check

HERE = Path(__file__).parent


def main() -> int:
    """Check all certificates, or some."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("name", nargs="*", default=[""], help="names, or beginnings of names; all without any")
    wanted = tuple(parser.parse_args().name)
    right = refused = uncertified = 0
    for path in sorted((HERE / "certificates").glob("*.json")):
        if not path.stem.startswith(wanted):
            continue
        certificate = json.loads(path.read_text(encoding="utf-8"))
        if not certificate["certified"]:
            uncertified += 1
            continue
        began = time.perf_counter()
        try:
            said = f"{check(certificate)['numbers']} numbers are right"
            right += 1
        except Refused as error:
            said = f"REFUSED: {error}"
            refused += 1
        print(f"{path.stem:24} {time.perf_counter() - began:6.1f} s  {said}", flush=True)
    print(f"{right} right, {refused} refused, {uncertified} not certified")
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main())
