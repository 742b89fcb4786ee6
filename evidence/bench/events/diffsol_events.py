"""diffsol, through the program `events` of ../diffsol, whose path is the argument."""

import re
import subprocess
import sys
from pathlib import Path

from problems import Stop, answer

LOCK = Path(__file__).resolve().parents[1] / "diffsol" / "Cargo.lock"


class Peer:
    tool = "diffsol " + re.search(
        'name = "diffsol"\nversion = "([^"]+)"', LOCK.read_text(encoding="utf-8")
    ).group(1)

    def __init__(self, setting, program):
        self.setting, self.program = setting, program

    def first(self, system, parameter, state, until):
        key = self.setting.replace(", ", "-")
        print(key, system.name, parameter, until, *state, file=self.program.stdin, flush=True)
        word, *rest = self.program.stdout.readline().split()
        if word == "none":
            return None
        if word == "error":
            raise RuntimeError(" ".join(rest))
        index, *end = rest
        return Stop(float(word), tuple(map(float, end)), (int(index),))


if __name__ == "__main__":
    pipe = subprocess.PIPE
    with subprocess.Popen(sys.argv[1:], stdin=pipe, stdout=pipe, text=True) as program:
        for setting in ("tsit45", "tsit45, 1e-12", "bdf"):
            answer(Peer(setting, program))
