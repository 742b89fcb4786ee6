"""Compares the library with random motions at 60 digits: see the package."""

import argparse
import json
import os
import sys
import time

from .page import DATA, PAGE, content, filled

MOTIONS = 1000  # of the whole range, and as many of usual ones


def written(data):
    """The file: a line for each row."""

    def lines(name):
        return (
            f' "{name}": [\n' + ",\n".join("  " + json.dumps(item) for item in data[name]) + "\n ]"
        )

    def rows(name):
        return (
            f' "{name}": {{\n'
            + ",\n".join(f'  "{key}": {json.dumps(item)}' for key, item in data[name].items())
            + "\n }"
        )

    def bins(name):
        return (
            f' "{name}": {{\n'
            + ",\n".join(
                f'  "{key}": [\n' + ",\n".join("   " + json.dumps(item) for item in items) + "\n  ]"
                for key, items in data[name].items()
            )
            + "\n }"
        )

    head = [
        f' "{key}": {json.dumps(item)}'
        for key, item in data.items()
        if not isinstance(item, (list, dict))
    ]
    body = [
        rows("ended"),
        rows("parts"),
        rows("names"),
        bins("against"),
        lines("most_lost"),
        lines("others"),
        lines("kept"),
    ]
    return "{\n" + ",\n".join(head + body) + "\n}\n"


def main():
    options = argparse.ArgumentParser(prog="python3 -m accuracy")
    options.add_argument(
        "--motions",
        type=int,
        help=f"compare so many of either kind, write nothing (default: {MOTIONS}, and write)",
    )
    options.add_argument("--workers", type=int, default=os.cpu_count())
    options.add_argument(
        "--exact", metavar="FILE", help="keep the exact motions in a file, or take them from there"
    )
    options.add_argument("--page", action="store_true", help="picture and page from accuracy.json")
    options = options.parse_args()
    began = time.time()
    if not options.page:
        from follower.arithmetic import FINEST, Work

        from .exact import motions
        from .library import motions as drawn
        from .table import table

        both = [
            (f"{kind} {k}", *pair)
            for kind in ("any", "usual")
            for k, pair in enumerate(drawn(kind, options.motions or MOTIONS))
        ]
        results = motions([one[:2] for one in both], options.workers, options.exact)
        Work.use(FINEST)
        data = dict(made_by="accuracy", **table(results, [answer for _, _, answer in both]))
        for name, row in {**data["parts"], **data["names"]}.items():
            print(f"{name:12s}", row)
        for item in data["most_lost"] + data["others"]:
            print(item)
        print(
            {
                k: v
                for k, v in data.items()
                if not isinstance(v, list) and k not in ("parts", "names", "against")
            },
            f"{time.time() - began:.0f} s",
        )
        if options.motions:
            return 0
        DATA.write_text(written(data), encoding="utf-8")
    from .picture import save

    save(content())
    PAGE.write_text(filled(PAGE.read_text(encoding="utf-8"), content()), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
