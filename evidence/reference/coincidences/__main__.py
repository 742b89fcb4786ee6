"""Compares the library with motions that start beside a curve on which two events coincide.

python3 -m coincidences                      all starts: writes coincidences.json beside this
package python3 -m coincidences --starts 20 [NAME]   so many of each family, or of one: prints,
writes nothing
"""

import argparse
import gc
import multiprocessing
import os
import pickle
import time

from follower.arithmetic import FINE, Work

from .comparison import Compared
from .families import FAMILIES, QUICK, STARTS
from .library import library
from .report import report, write
from .sample import SUSPECT, closer, one


def remembered(path):
    """The motions of an earlier run."""
    if not path or not os.path.exists(path):
        return {}
    with open(path, "rb") as file:
        return pickle.load(file)


def main():
    options = argparse.ArgumentParser()
    options.add_argument("family", nargs="?", choices=FAMILIES)
    options.add_argument("--starts", type=int)
    options.add_argument("--workers", type=int, default=os.cpu_count())
    options.add_argument(
        "--motions", metavar="FILE", help="keep the motions in a file, or take them from there"
    )
    options = options.parse_args()
    names = [options.family] if options.family else list(FAMILIES)
    tasks = [
        (name, index)
        for name in names
        for index in range(options.starts or QUICK.get(name, STARTS))
    ]
    began = time.time()
    gc.disable()
    with multiprocessing.Pool(options.workers, maxtasksperchild=500) as pool:
        results = remembered(options.motions)
        for name in sorted(names, key=lambda name: QUICK.get(name, STARTS)):
            todo = [task for task in tasks if task[0] == name and task not in results]
            results.update(((r[0], r[1]), r) for r in pool.map(one, todo, chunksize=4))
            if options.motions and todo:
                with open(options.motions, "wb") as file:
                    pickle.dump(results, file)
        results = [results[task] for task in tasks]
        Work.use(FINE)
        answers = library([(r[2], r[3], r[4]) for r in results])
        compared = [Compared(*pair) for pair in zip(results, answers)]
        suspect = [k for k, c in enumerate(compared) if c.worst[0] > SUSPECT or not c.possible]
        for k, result in zip(suspect, pool.map(closer, [results[k] for k in suspect], chunksize=1)):
            compared[k] = Compared(result, answers[k])
    families, different, kept = report(compared)
    for name, row in families.items():
        print(f"{name:38s}", {k: v for k, v in row.items() if k != "largest_at"})
        print(" " * 38, row["largest_at"])
    for item in different:
        print(item)
    print(f"{len(results)} starts, {len(different)} disagreements, {time.time() - began:.0f} s")
    if not (options.family or options.starts):
        write(len(results), families, different, kept)


if __name__ == "__main__":
    main()
