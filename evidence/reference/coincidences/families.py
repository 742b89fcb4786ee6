"""The families of starts, and how many each has."""

from . import massless_starts, starts
from .draws import heavy, inside, massless

# Of each family, unless QUICK has more of it.
STARTS = 50

FAMILIES = {
    "grazing_slip": (heavy, starts.grazing_slip),
    "turning_on_slip_curve": (heavy, starts.turning_on_slip_curve),
    "stick_at_lift_off": (heavy, starts.stick_at_lift_off),
    "reversal_or_stick": (heavy, starts.reversal_or_stick),
    "slip_that_touches_rest": (heavy, starts.slip_that_touches_rest),
    "normal_force_that_touches_zero": (heavy, starts.normal_force_that_touches_zero),
    "landing_that_grazes": (heavy, starts.landing_that_grazes),
    "start_beside_slip_curve": (heavy, starts.start_beside_slip_curve),
    "start_beside_lift_off_curve": (heavy, starts.start_beside_lift_off_curve),
    "start_beside_vanishing_normal_force": (heavy, starts.start_beside_vanishing_normal_force),
    "start_with_hardly_any_slip": (heavy, starts.start_with_hardly_any_slip),
    "massless_type_ii": (massless, massless_starts.type_ii),
    "massless_type_ii_on_the_rim": (lambda dice: (0.0, 1.0, 0.0), massless_starts.type_ii),
    "gliding_rest_on_slip_curve": (massless, massless_starts.gliding_rest_on_slip_curve),
    "gliding_slip_that_touches_rest": (massless, massless_starts.gliding_slip_that_touches_rest),
    "particle_that_just_reaches_the_top": (
        massless,
        massless_starts.particle_that_just_reaches_the_top,
    ),
    "gliding_rest_at_turning_point": (massless, massless_starts.gliding_rest_at_turning_point),
    "gliding_rest_at_the_bottom": (massless, massless_starts.gliding_rest_at_the_bottom),
    "massless_start_beside_a_curve": (massless, massless_starts.massless_start_beside_a_curve),
    "massless_grazing_slip": (inside, starts.grazing_slip),
    "massless_turning_on_slip_curve": (inside, starts.turning_on_slip_curve),
}

# Other numbers of starts: closed forms and short series need little time.
QUICK = {
    "massless_type_ii": 2000,
    "massless_type_ii_on_the_rim": 2000,
    "gliding_rest_on_slip_curve": 4300,
    "particle_that_just_reaches_the_top": 600,
    "gliding_rest_at_turning_point": 300,
    "gliding_slip_that_touches_rest": 100,
    "massless_start_beside_a_curve": 100,
    "gliding_rest_at_the_bottom": 100,
    # Few of the orbits that are drawn have such a point.
    "massless_grazing_slip": 10,
    "massless_turning_on_slip_curve": 10,
}
