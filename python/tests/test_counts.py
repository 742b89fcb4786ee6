"""Counts without measure.

Refused with the bound, before anything is allocated. None ends the interpreter.
"""

import subprocess
import sys

import numpy as np
import pytest

import littlewood as lw

# As the command line has it: `littlewood simulate --samples`.
MOST_SAMPLES = 10_000_000


@pytest.fixture
def motion():
    return lw.case("figure-3").simulate()


@pytest.mark.parametrize("count", [MOST_SAMPLES + 1, 10**9, 10**12, 2**63, 2**64, 2**70])
def test_samples_are_bounded(count, motion):
    message = f"count = {count} must not exceed {MOST_SAMPLES}"
    for ask in (
        motion.sample,
        lambda count: motion.to_pandas(count=count),
        lambda count: motion.to_xarray(count=count),
    ):
        with pytest.raises(ValueError, match=message):
            ask(count)


def test_the_command_line_has_the_same_bound(command):
    assert command("simulate", "figure-3", f"--samples={MOST_SAMPLES + 1}").returncode == 2
    for count in (-1, 0, 1):
        with pytest.raises(ValueError, match=f"count = {count} must not be less than 2"):
            lw.case("figure-3").simulate().sample(count)


@pytest.mark.parametrize("count", [-1, 2**64, 2**70, 10**30])
@pytest.mark.parametrize("name", ["max_transitions", "max_slides"])
def test_limits_are_bounded(name, count, hoop):
    bound = "less than 0" if count < 0 else f"exceed {2**64 - 1}"
    message = f"{name} = {count} must not .*{bound}"
    with pytest.raises(ValueError, match=message):
        hoop.simulate(theta=0.0, theta_rate=1.0, **{name: count})
    with pytest.raises(ValueError, match=message):
        lw.simulate_many(hoop, theta=0.0, theta_rate=1.0, **{name: count})


def test_slides_are_limited_together(hoop):
    # The first slide of the motion of Figure 3 has the length 2.2, with its weight.
    start = dict(theta=1.5707963267948966, theta_rate=2.0)
    assert hoop.simulate(**start, max_slides=2, proof="none").outcome.kind == "step_limit"
    outcome = lw.simulate_many(hoop, **start, max_slides=2, proof="none").outcome
    assert lw.tables.OUTCOMES[int(outcome.values)] == "step_limit"
    assert hoop.simulate(**start).outcome.kind == "landing"


def test_no_transition_shows_what_is_there_at_once(hoop):
    # The motion of Figure 3 begins with a slide that sticks.
    start = dict(theta=1.5707963267948966, theta_rate=2.0)
    motion = hoop.simulate(**start, max_transitions=0)
    assert (motion.outcome.kind, [phase.mode for phase in motion.phases]) == (
        "transition_limit",
        ["sliding"],
    )
    assert hoop.simulate(**start, max_transitions=2**64 - 1).outcome.kind == "landing"


@pytest.mark.parametrize("frames", [-1, 1, 300_001, 10**12, 2**70])
def test_frames_are_bounded(frames, motion):
    with pytest.raises(
        ValueError, match=rf"frames = {frames} must not (be less than 2|exceed 300000)"
    ):
        motion.animate(frames=frames)


@pytest.mark.parametrize("count", [1.5, "7", None, np.float64(3.0)])
def test_a_count_is_a_whole_number(count, motion):
    with pytest.raises(TypeError):
        motion.sample(count)
    with pytest.raises(TypeError):
        motion.animate(frames=count)


def test_points_are_bounded(hoop):
    side = np.linspace(0.0, 1.0, 1_000_000)
    with pytest.raises(ValueError, match="1000000000000 points at once: there can be 100000000"):
        lw.outcome_map(hoop, theta=side, theta_rate=side)
    with pytest.raises(ValueError, match="1000000000000 points at once: there can be 100000000"):
        lw.simulate_many(hoop, theta=side[:, None], theta_rate=side[None, :])


# What is within the bounds may be more than a machine has.
LIMITED = """
import resource
import littlewood as lw
import numpy as np

motion = lw.case("figure-3").simulate()
hoop = motion.hoop
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + (400 << 20),) * 2)
for work in (
    lambda: motion.sample(10_000_000), lambda: motion(np.broadcast_to(1.0, 10_000_000)), lambda:
    lw.outcome_map(hoop, theta=np.linspace(0, 1, 10_000), theta_rate=np.linspace(0, 1, 10_000)),
):
    try:
        work()
    except MemoryError:
        print("refused")
"""


@pytest.mark.skipif(
    not sys.platform.startswith("linux"), reason="the limit of memory is that of Linux"
)
def test_too_little_memory_is_an_exception(tmp_path):
    done = subprocess.run(
        [sys.executable, "-c", LIMITED], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout.split()) == (0, ["refused"] * 3), done.stderr
