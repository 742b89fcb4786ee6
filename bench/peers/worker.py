"""A peer reads one benchmark a line (a name and a whole number) and answers with one line of JSON."""

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


def trajectory(name, call, each=1):
    """`call` returns the times of the three events of figure 3; it follows `each` motions at a time."""
    return {"name": name, "seconds": median_seconds(call) / each, "times": [float(t) for t in call()]}


def outcome_map(name, starts, outcome, pick=None):
    start = time.perf_counter()
    outcomes = [outcome(theta, rate) for theta, rate in starts]
    seconds = time.perf_counter() - start
    return {"name": name, "seconds": seconds, "pick": pick, "outcomes": "".join(map(str, outcomes))}
