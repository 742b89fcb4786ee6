"""The command line: ``python -m littlewood``, and the program ``littlewood`` that comes with the package."""

import sys

from ._core import run_program


def main() -> int:
    """Run the command line with the arguments of the process.

    Returns
    -------
    int
        Its exit code.
    """
    return run_program(["littlewood", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
