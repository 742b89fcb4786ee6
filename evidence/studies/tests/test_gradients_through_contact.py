from dataclasses import replace

import littlewood as lw
import pytest

from evidence.studies.gradients_through_contact import (
    BOUNCES,
    CASE,
    DIFFERENCE,
    END,
    RATE,
    RISE,
    THETA,
    automatic,
    difference,
    exact,
    motion_of,
    with_impacts,
    with_spring,
    without_delay,
)

HOOPS = [
    BOUNCES,
    *(replace(BOUNCES, mass_ratio=m, inertia=i) for m, i in ((0.3, 0.2), (2.0, 1.5), (5.0, 3.0))),
]


@pytest.mark.parametrize("hoop", HOOPS)
def test_impacts_at_steps_lose_the_delay_of_the_event(hoop):
    assert [transition.cause for transition in motion_of(hoop).transitions] == ["landing"]
    wrong, true = without_delay(hoop), exact(hoop)
    assert abs(wrong - true) > 0.1 * abs(true)
    # The scheme is of first order.
    coarse, fine = (abs(automatic(with_impacts, hoop, step) - wrong) for step in (1e-2, 1e-4))
    assert fine < 2e-3 * max(1.0, abs(wrong))
    assert fine < coarse


@pytest.mark.parametrize("hoop", HOOPS)
def test_differences_of_the_scheme_and_of_the_library_agree_with_the_exact_derivative(hoop):
    def angle(rise: float) -> float:
        return float(
            hoop.simulate(theta=THETA, theta_rate=RATE, gap_rate=rise, until=END)(END).theta
        )

    chord = (angle(RISE + DIFFERENCE) - angle(RISE - DIFFERENCE)) / (2 * DIFFERENCE)
    # The landing of the scheme is late by a step at most, which changes θ by Δθ′ at most that long:
    # 1e-4 Δθ′ over 0.02.
    (landing,) = motion_of(hoop).transitions
    jump = abs(landing.after.theta_rate - landing.state.theta_rate)
    assert difference(with_impacts, hoop, 1e-4) == pytest.approx(
        chord, abs=1e-4 * (jump + 1) / DIFFERENCE
    )
    step = 1e-5
    assert (angle(RISE + step) - angle(RISE - step)) / (2 * step) == pytest.approx(
        exact(hoop), abs=1e-8
    )


def test_a_soft_spring_has_the_derivative_of_a_soft_plane():
    hoop = BOUNCES
    softer, stiffer = (
        automatic(lambda hoop, step, rise, t=t: with_spring(hoop, step, rise, t), hoop, 1e-5)
        for t in (0.2, 0.05)
    )
    assert abs(stiffer - exact(hoop)) < abs(softer - exact(hoop)) < 0.3 * abs(exact(hoop))


def test_reasons_of_the_page():
    rolls = lw.case("figure-2-libration").simulate().derivatives(["slip"])
    glides = lw.case("figure-7").simulate().derivatives(["theta"])
    smooth = (
        replace(CASE.hoop, mu_k=1e-6)
        .simulate(theta=0.3, theta_rate=0.3, slip=1e3)
        .derivatives(["theta"])
    )
    assert [str(found.end_reason.values[0]) for found in (rolls, glides, smooth)] == [
        "one_sided",
        "singular",
        "too_long",
    ]
