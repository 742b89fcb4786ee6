"""The command line.

``python -m littlewood``, and the program ``littlewood`` that comes with the package.
"""

import sys

from ._commands import fit, score
from ._core import run_program
from ._internal.terminal import forgive
from .certify import __main__ as certify

OF_THE_PACKAGE = {"certify": certify.main, "fit": fit.main, "score": score.main}
"""Commands that the package adds to those of the program."""


def main() -> int:
    """Run the command line with the arguments of the process, and return its exit code."""
    name, *rest = sys.argv[1:] or [""]
    if name in OF_THE_PACKAGE:
        forgive()
        return OF_THE_PACKAGE[name](rest)
    return run_program(["littlewood", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
