"""Exact motions, on all cores, kept in a file if wanted: they do not depend on the library."""

import multiprocessing
import os
import pickle

from follower.arithmetic import FINEST, Work

from .measure import one

TOGETHER = 100  # motions after which the file is written


def motions(tasks, workers, path=None):
    """The exact motions of named tasks, in their order."""
    # Numbers are read in this precision.
    Work.use(FINEST)
    kept = {}
    if path and os.path.exists(path):
        with open(path, "rb") as file:
            kept = pickle.load(file)
    todo = [(name, task) for name, task in tasks if name not in kept or kept[name][0] != task]
    with multiprocessing.Pool(workers, maxtasksperchild=500) as pool:
        for k in range(0, len(todo), TOGETHER):
            part = todo[k : k + TOGETHER]
            kept.update(
                (name, result) for (name, _), result in zip(part, pool.map(one, part, chunksize=4))
            )
            if path:
                with open(path + ".part", "wb") as file:
                    pickle.dump(kept, file)
                os.replace(path + ".part", path)
    return [kept[name] for name, _ in tasks]
