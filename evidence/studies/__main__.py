"""`python -m evidence.studies NAME…`: computes studies.

It writes their tables, pictures and lists.
"""

from __future__ import annotations

import argparse
import difflib
import sys
import time

from .page import put
from .pictures import write
from .study import NAMES, Study, load


def computed(study: Study) -> str:
    """Return the page with all its numbers computed again."""
    text = study.page.read_text(encoding="utf-8")
    for label, content in study.texts.items():
        text = put(text, label, content())
    return text


def draw(study: Study) -> None:
    """Write the pictures."""
    study.folder.mkdir(exist_ok=True)
    for name, picture in study.pictures.items():
        write(picture, study.folder / f"{name}.svg", study.page)


def main() -> int:
    """Compute what is asked for; 1 if a check finds another page."""
    parser = argparse.ArgumentParser(prog="python -m evidence.studies", description=__doc__)
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help=f"{', '.join(NAMES)}; all, if none is given"
    )
    parser.add_argument(
        "--pictures", action="store_true", help="draw only, and leave the numbers of the pages"
    )
    parser.add_argument(
        "--check", action="store_true", help="write nothing, and say where a page has other numbers"
    )
    arguments = parser.parse_args()
    for name in arguments.names:
        if name not in NAMES:
            parser.error(f"no study is called {name}; they are {', '.join(NAMES)}")
    differs = False
    for name in arguments.names or NAMES:
        begin = time.perf_counter()
        study = load(name)
        if arguments.pictures:
            draw(study)
            continue
        before, after = study.page.read_text(encoding="utf-8"), computed(study)
        if arguments.check:
            differs = differs or before != after
            sys.stdout.writelines(
                difflib.unified_diff(
                    before.splitlines(True), after.splitlines(True), "committed", "computed", n=0
                )
            )
        else:
            study.page.write_text(after, encoding="utf-8")
            draw(study)
            for file, content in study.files.items():
                (study.folder / file).write_text(content(), encoding="utf-8")
        print(f"{name}: {time.perf_counter() - begin:.0f} s")
    return 1 if differs else 0


if __name__ == "__main__":
    sys.exit(main())
