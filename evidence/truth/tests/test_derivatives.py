"""The balls of derivatives: how many, how small, made again, and what the library computes."""

import json
import sys
from pathlib import Path

import pytest
from littlewood.scoring import CASES

FOLDER = Path(__file__).resolve().parents[1]


@pytest.fixture(scope="module")
def derivatives():
    sys.path.insert(0, str(FOLDER))
    import derivatives

    yield derivatives
    sys.path.remove(str(FOLDER))


@pytest.fixture(scope="module")
def motions():
    return json.loads((FOLDER / "derivatives.json").read_text(encoding="utf-8"))["motions"]


def balls(derivatives, motions):
    for motion in motions:
        for number, event in enumerate(motion["events"]):
            for name in derivatives.NUMBERS:
                yield motion["motion"], number, name, event[name]


def test_every_family_has_small_balls_through_all_events(derivatives, motions):
    assert len({one["motion"] for one in motions}) == len(motions)
    paths = (FOLDER / "certificates").glob("*.json")
    families = {
        path.stem: json.loads(path.read_text(encoding="utf-8"))["case"]["family"] for path in paths
    }
    # Jams end where they begin; massless hoops, those in SI units, rolling resistance and bounces
    # that settle on slopes are left out.
    assert {*families.values()} - {families[one["motion"]] for one in motions} == {
        "jam",
        "massless",
        "ramp-rests",
        "ramp-settles",
        "rests-elastic",
        "rests-landing",
        "rests-massless",
        "rests-rolling",
        "rests-si",
        "rests-sliding",
        "si",
    }
    causes = {event["cause"] for one in motions for event in one["events"]}
    assert causes >= {"stick", "slip", "lift_off", "landing"}
    quantities = {name for *_, found in balls(derivatives, motions) for name in found}
    assert quantities == {*derivatives.HOOP, *derivatives.START}
    for motion, number, name, found in balls(derivatives, motions):
        for quantity, (middle, radius) in found.items():
            assert float(radius) <= 1e-9 * max(1.0, abs(float(middle))), (
                motion,
                number,
                name,
                quantity,
            )


@pytest.mark.parametrize(
    "name", ["bounces", "law-energetic", "ramp-sliding-09", "near-tie-20", "jam-16"]
)
def test_committed_balls_are_made_again(derivatives, motions, name):
    certificate = json.loads((FOLDER / "certificates" / f"{name}.json").read_text(encoding="utf-8"))
    found = derivatives.differentiated(certificate)
    committed = next((one for one in motions if one["motion"] == name), None)
    assert found["events"] == (committed["events"] if committed else [])


def test_the_derivatives_of_the_library_are_in_the_balls_but_for_rounding(derivatives, motions):
    """Rounding changes the derivatives by the second ones, of the size of the cube of the largest
    derivative so far.

    Next to a tangency τ = √(p − p₀) has τ″ = −2 τ′³.
    """
    compared, refused = 0, []
    for motion in motions:
        names = list(motion["events"][0]["time"])
        exact = CASES[motion["motion"]].motion.derivatives(names)
        largest = 1.0
        for number, event in enumerate(motion["events"]):
            found = {name: event[name] for name in derivatives.NUMBERS}
            largest = max(
                largest,
                *(abs(float(middle)) for one in found.values() for middle, _ in one.values()),
            )
            # The bound is as large as the derivative itself: the library may say that the event is
            # touched.
            if ROUNDINGS * 2.0**-52 * largest**2 > 1.0 and set(exact.reason[number].values) == {
                "grazing"
            }:
                refused.append(motion["motion"])
                break
            for name, one in found.items():
                for quantity, (middle, radius) in one.items():
                    mine = float(exact[name].sel(quantity=quantity)[number])
                    bound = float(radius) + ROUNDINGS * 2.0**-52 * largest**3
                    assert abs(mine - float(middle)) <= bound, (
                        motion["motion"],
                        number,
                        name,
                        quantity,
                    )
                    compared += 1
    assert compared > 30000
    assert len(refused) < 5


ROUNDINGS = 16
"""In units in the last place: those of a dozen operations."""
