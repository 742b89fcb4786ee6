"""NAME: how the hoop is set up in it, in one line.

engine: NAME as people know it
contact: rigid
settings: default careful
requires: numpy==2.4.6
docs: https://where.its.settings.are/documented

default: as the package comes.
careful: what its documentation recommends for accuracy, and the page that says so.
Cannot express: mu_s and mu_k (one coefficient); restitution.
"""

from adapter import main, stepped


def simulate(case, step, setting):
    """Yield rows: time, x and y of the geometric centre, theta, and the engine's own rates."""
    case.one_coefficient()  # refuses a case with two
    case.without_restitution()  # refuses a case that bounces
    # Copy to adapters/NAME_adapter.py, and replace these lines, in which a hoop falls through the
    # plane.
    x, y = case.mass_centre()
    vx, vy = case.mass_centre_rates()
    theta = case.theta

    def advance():
        nonlocal x, y, theta, vx, vy
        vx, vy = vx + step * case.gravity[0], vy + step * case.gravity[1]
        x, y, theta = x + step * vx, y + step * vy, theta + step * case.theta_rate

    def row(time):
        return case.row(time, x, y, theta, vx, vy, case.theta_rate)

    yield from stepped(case, step, advance, row)


if __name__ == "__main__":
    main(simulate)
