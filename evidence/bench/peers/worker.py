"""A peer reads benchmarks, one a line, and answers each with one line of JSON.

A line is a name and a whole number.
"""

import json
import statistics
import sys
import time


def serve(**benchmarks):
    for line in sys.stdin:
        name, number = line.split()
        print(json.dumps(benchmarks[name](int(number))), flush=True)


def median_seconds(call, seconds=0.5):
    """Median time of a call, repeated for about so many seconds."""
    call()
    samples, end = [], time.perf_counter() + seconds
    while time.perf_counter() < end or len(samples) < 5:
        start = time.perf_counter()
        call()
        samples.append(time.perf_counter() - start)
    return statistics.median(samples)


def outcomes_in(name, starts, outcome, failed, most):
    """As many outcomes as can be had in some seconds of the processor, and the time of each.

    The time is the least, where there is time for more than one round. What cannot be integrated
    has failed.
    """
    outcomes, seconds = [], []
    end = time.process_time() + most
    while time.process_time() < end:
        for number, start in enumerate(starts):
            begun = time.process_time()
            if begun > end:
                break
            try:
                found = outcome(*start)
            except (ArithmeticError, RuntimeError, ValueError):
                found = failed
            took = time.process_time() - begun
            if number == len(outcomes):
                outcomes.append(found)
                seconds.append(took)
            seconds[number] = min(seconds[number], took)
    return {"name": name, "outcomes": outcomes, "seconds": seconds}


def trajectory(name, call, each=1):
    """`call` returns the times of the three events of figure 3.

    It follows `each` motions at a time.
    """
    return {
        "name": name,
        "seconds": median_seconds(call) / each,
        "times": [float(t) for t in call()],
    }


def outcome_map(name, starts, outcome, pick=None):
    start = time.process_time()
    outcomes = [outcome(theta, rate) for theta, rate in starts]
    seconds = time.process_time() - start
    return {"name": name, "seconds": seconds, "pick": pick, "outcomes": "".join(map(str, outcomes))}
