"""Compares starts that nobody has seen: `python3 -m unseen KIND [COUNT]`; 1 if any differs."""

import argparse
import sys
import time

from . import resisted, whole_range

SEED = 2026
COUNT = 2000
KINDS = {"resistance": resisted.attack, "range": whole_range.attack}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kind", choices=KINDS)
    parser.add_argument("count", nargs="?", type=int, default=COUNT)
    parser.add_argument("--seed", type=int, default=SEED)
    parser.add_argument("--first", type=int, default=0, help="number of the first start")
    given = parser.parse_args()
    began = time.perf_counter()
    numbers = range(given.first, given.first + given.count)
    counts, events, different = KINDS[given.kind](given.seed, numbers)
    for number, word, what in different:
        print(f"start {number}: {word}, {what}")
    print(f"{given.count} starts, {events} events, {len(different)} differ")
    print(f"{dict(counts.most_common())}, {time.perf_counter() - began:.0f} s")
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
