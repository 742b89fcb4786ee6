//! The modes that are consistent at a state by Newton's and Euler's equations of the hoop and the
//! particle, solved for each mode in twice the digits, and bounds on the rounding of the library.

use super::dd::Dd;
use littlewood::theory::{Body, Classification};
use littlewood::{Hoop, HoopParameters, Mode, SlipDirection, Start, State};

/// Roundings on the longest way from the parameters to a number by which the library decides: the
/// body and the half angle, four forms of degree six in it, and their conversion to an arc. Each
/// is at most ε of the largest term.
const ROUNDINGS: f64 = 64.0;

/// Whether a mode is consistent; `None` where rounding may decide.
pub(crate) type Consistent = Option<bool>;

fn both(a: Consistent, b: Consistent) -> Consistent {
    match (a, b) {
        (Some(false), _) | (_, Some(false)) => Some(false),
        (Some(true), Some(true)) => Some(true),
        _ => None,
    }
}

/// A number, and a bound on the rounding of the library in it, besides that of the smallest numbers.
#[derive(Clone, Copy, Debug)]
struct Rounded {
    value: f64,
    rounding: f64,
}

impl Rounded {
    fn is_positive(self) -> Consistent {
        // Next to θ = 0 sines may be smaller than the least normal number, and have no digits.
        (self.value.abs() > self.rounding + f64::MIN_POSITIVE).then_some(self.value > 0.0)
    }
}

/// The determinant of three columns.
fn determinant([a, b, c]: [[Dd; 3]; 3]) -> Dd {
    a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1])
        + c[0] * (a[1] * b[2] - a[2] * b[1])
}

/// The three unknowns of three equations by Cramer's rule, from the columns of coefficients and the
/// right-hand sides.
pub(crate) fn solve(columns: [[Dd; 3]; 3], right: [Dd; 3]) -> [f64; 3] {
    let whole = determinant(columns).high;
    std::array::from_fn(|unknown| {
        let mut replaced = columns;
        replaced[unknown] = right;
        determinant(replaced).high / whole
    })
}

/// The coefficients of θ″, η″, gap″, N and F in the balances of moment about the centre, of
/// momentum normal to the plane and of momentum along it, and the right-hand sides.
pub(crate) struct Balances {
    pub(crate) spin: [Dd; 3],
    pub(crate) slip: [Dd; 3],
    pub(crate) gap: [Dd; 3],
    pub(crate) normal: [Dd; 3],
    pub(crate) friction: [Dd; 3],
    pub(crate) right: [Dd; 3],
}

impl Balances {
    /// θ″, N and F of rolling.
    pub(crate) fn rolling(&self) -> [f64; 3] {
        solve([self.spin, self.normal, self.friction], self.right)
    }

    /// θ″, gap″ and η″ of flight.
    pub(crate) fn flight(&self) -> [f64; 3] {
        solve([self.spin, self.gap, self.slip], self.right)
    }
}

/// A hoop of mass m1 and inertia Izz, the rim at the plane, and a particle of mass 1 at ℓ (−sin θ,
/// cos θ) from its centre, which has the acceleration (η″ − θ″, gap″).
pub(crate) fn balances(hoop: &Hoop, start: &Start) -> Balances {
    let HoopParameters {
        mass_ratio,
        offset,
        inertia,
        slope,
        ..
    } = hoop.parameters();
    let number = Dd::from;
    let (zero, one) = (number(0.0), number(1.0));
    let (sin, cos) = number(start.theta).sincos();
    let (along, down) = number(slope).sincos();
    let (mass, l) = (one + number(mass_ratio), number(offset));
    let rate = number(start.theta_rate);
    let (l_sin, l_cos, u) = (l * sin, l * cos, rate * rate);
    Balances {
        spin: [number(inertia) + l * l + l_cos, -l_sin, -(mass + l_cos)],
        slip: [-l_cos, zero, mass],
        gap: [-l_sin, mass, zero],
        normal: [zero, -one, zero],
        friction: [-one, zero, -one],
        right: [
            l_sin * down + l_cos * along,
            l_cos * u - mass * down,
            -(l_sin * u) - mass * along,
        ],
    }
}

/// The modes that are consistent at a state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Modes {
    pub(crate) rolling: Consistent,
    /// To either side.
    pub(crate) sliding: [Consistent; 2],
    pub(crate) gliding: Consistent,
    pub(crate) flight: Consistent,
}

impl Modes {
    fn named(&self) -> [(&'static str, Consistent); 5] {
        let [negative, positive] = self.sliding;
        [
            ("rolling", self.rolling),
            ("sliding", negative),
            ("sliding", positive),
            ("gliding", self.gliding),
            ("flight", self.flight),
        ]
    }

    pub(crate) fn are_certain(&self) -> bool {
        self.named().iter().all(|(_, mode)| mode.is_some())
    }

    /// Their names, in order.
    pub(crate) fn set(&self) -> String {
        let names: Vec<_> = self
            .named()
            .into_iter()
            .filter(|(_, mode)| *mode == Some(true))
            .map(|(name, _)| name)
            .collect();
        if names.is_empty() {
            "none".to_owned()
        } else {
            names.join(", ")
        }
    }
}

/// The modes from the balances alone: each is solved, and its forces and accelerations have to obey
/// Signorini's and Coulomb's laws. Where static friction holds no slide begins.
pub(crate) fn modes(hoop: &Hoop, start: &Start) -> Modes {
    let balances = balances(hoop, start);
    let Balances {
        spin,
        slip,
        normal,
        friction,
        right,
        ..
    } = balances;
    let scaled = |column: [Dd; 3], by: f64| column.map(|entry| entry * Dd::from(by));
    let added = |a: [Dd; 3], b: [Dd; 3]| [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
    let sizes = Sizes::of(hoop, start);
    let is_massless = matches!(hoop.body(), Body::Massless(_));
    let (mu_s, mu_k) = (hoop.mu_s(), hoop.mu_k());

    let [_, n, f] = balances.rolling();
    let forces = [(n, sizes.normal), (f, sizes.friction)]
        .map(|(value, rounding)| Rounded { value, rounding });
    let margin = Rounded {
        value: mu_s * n - f.abs(),
        rounding: sizes.friction_excess(),
    };
    let is_at_rest = start.slip == 0.0;
    let rolling = both(
        Some(is_at_rest),
        both(forces[0].is_positive(), margin.is_positive()),
    );
    // Where static friction holds no slide begins, and no glide.
    let may_slip = rolling.map(|rolls| !rolls);
    if is_massless {
        // N = F = 0, and the particle falls freely: sin θ ≠ 0.
        let turns = Rounded {
            value: libm::sin(start.theta).abs(),
            rounding: 0.0,
        };
        return Modes {
            rolling,
            sliding: [Some(false); 2],
            gliding: both(may_slip, turns.is_positive()),
            flight: Some(false),
        };
    }

    let [_, opening, _] = balances.flight();
    let opening = Rounded {
        value: opening,
        rounding: sizes.contact,
    };
    let sliding = SlipDirection::ALL.map(|direction| {
        let sigma = direction.sign();
        let bound = added(normal, scaled(friction, -mu_k * sigma));
        let [_, n, acceleration] = solve([spin, bound, slip], right);
        // N has the sign of w/P, and both may be rounding.
        let (p, p_rounding) = sizes.painleve(direction);
        let is_pressed = if opening.is_positive().is_none() || p.abs() <= p_rounding {
            None
        } else {
            Some(n > 0.0)
        };
        if !is_at_rest {
            let goes_on = SlipDirection::of_sign(start.slip) == Some(direction);
            return both(Some(goes_on), is_pressed);
        }
        // The library has it as −D (F + μk σ N)/(m P) from the forces of rolling.
        let force = sizes.friction + mu_k * sizes.normal;
        let begins = Rounded {
            value: sigma * acceleration,
            rounding: sizes.effective_inertia * force / (sizes.mass * p.abs())
                + acceleration.abs() * p_rounding / p.abs(),
        };
        both(may_slip, both(is_pressed, begins.is_positive()))
    });
    Modes {
        rolling,
        sliding,
        gliding: Some(false),
        flight: opening.is_positive(),
    }
}

/// Bounds on the rounding of the numbers by which the library decides, from the sizes of the terms
/// of its formulas.
pub(crate) struct Sizes {
    mass: f64,
    h: f64,
    inertia: f64,
    mu_s: f64,
    mu_k: f64,
    sin: f64,
    cos: f64,
    pub(crate) effective_inertia: f64,
    pub(crate) contact: f64,
    pub(crate) normal: f64,
    pub(crate) friction: f64,
}

impl Sizes {
    /// At a start, whose angle is known to its last digit.
    pub(crate) fn of(hoop: &Hoop, start: &Start) -> Self {
        Self::with_angle(hoop, start, f64::EPSILON * start.theta.abs())
    }

    /// Of a motion, whose angle is computed within a turn from that of the event before, which is
    /// rounded as well: a slide may return to exactly the limit of friction at which it began.
    pub(crate) fn of_motion(hoop: &Hoop, state: State) -> Self {
        let angles = std::f64::consts::PI + 2.0 * state.theta.abs();
        // A clock that reads τ resolves θ to θ′ ulp(τ).
        let ticks = (state.theta_rate * state.time).abs();
        Self::with_angle(hoop, &Start::from(state), f64::EPSILON * (angles + ticks))
    }

    /// With the rounding of the angle.
    fn with_angle(hoop: &Hoop, start: &Start, angle: f64) -> Self {
        let (mass, h, l) = (hoop.mass(), hoop.h(), hoop.offset());
        let inertia = hoop.body().inertia_about_mass_centre();
        let (sin, cos) = libm::sincos(start.theta);
        let (along, down) = libm::sincos(hoop.slope());
        let (sin, along, u) = (sin.abs(), along.abs(), start.theta_rate * start.theta_rate);
        let bottom = inertia + mass * (1.0 - h) * (1.0 - h);
        let half = libm::cos(0.5 * start.theta);
        let free = bottom + 4.0 * l * half * half;
        // Rolling resistance presses the hoop to the plane, or off it.
        let chi = hoop.rolling_resistance();
        let turns = if start.theta_rate == 0.0 {
            sin
        } else {
            libm::sin(start.theta) * start.theta_rate.signum()
        };
        let d = (free - chi * l * turns).abs();
        let unit = ROUNDINGS * f64::EPSILON;
        // h is rounded before 1 − h is squared.
        let relative = unit * (free + chi * l * sin + 2.0 * mass * (1.0 - h)) / d;
        let press = mass * down + l * u;
        let driven = l * sin * (down + u) + (mass + l) * along + chi * press;
        let normal = press + l * sin * driven / d;
        let level = l * sin * (u * (inertia + l * (1.0 + h)) + (mass + l) * down);
        let resisted = (mass + l) * press + l * sin * (l * sin * u + mass * along);
        let friction = (level + (mass * inertia + l * l * sin * sin) * along + chi * resisted) / d;
        // The forces change with the angle by these rates at most.
        let spin = (l * (down + u) + (mass + l) * along + chi * press) / d;
        let turning = 2.0 * (1.0 + l * (1.0 + chi) / d);
        let normal_by_angle = l * (u + spin * turning);
        let friction_by_angle =
            l * (u * (inertia + l * (1.0 + h)) + (mass + l) * (down + chi * (down + u))) / d
                + friction * turning;
        Self {
            mass,
            h,
            inertia,
            mu_s: hoop.mu_s(),
            mu_k: hoop.mu_k(),
            sin: libm::sin(start.theta),
            cos,
            effective_inertia: d,
            contact: unit * (down + h * cos.abs() * u),
            normal: relative * normal + angle * normal_by_angle,
            friction: relative * friction + angle * friction_by_angle,
        }
    }

    /// Of |F| − μs N.
    pub(crate) fn friction_excess(&self) -> f64 {
        self.mu_s * self.normal + self.friction
    }

    /// P, and the bound on its rounding.
    fn painleve(&self, direction: SlipDirection) -> (f64, f64) {
        let (arm, lever) = (self.h * self.sin, 1.0 + self.h * self.cos);
        let f = self.mu_k * direction.sign();
        let p = self.inertia + self.mass * arm * (arm - f * lever);
        let size = self.inertia + self.mass * arm.abs() * (arm.abs() + f.abs() * (1.0 + self.h));
        (p, ROUNDINGS * f64::EPSILON * size)
    }
}

/// The modes that the library finds.
pub(crate) fn said(found: &Classification) -> Vec<(Mode, Option<SlipDirection>)> {
    found.mode.map_or_else(
        || {
            let candidates = found.candidates.expect("a mode, or candidates");
            candidates.consistent().collect()
        },
        |mode| vec![(mode, found.direction)],
    )
}

/// Whether the library says the same of a state.
pub(crate) fn agrees(modes: &Modes, said: &[(Mode, Option<SlipDirection>)]) -> bool {
    let slides = |direction| said.contains(&(Mode::Sliding, Some(direction)));
    let has = |mode| said.iter().any(|(its, _)| *its == mode);
    let [negative, positive] = modes.sliding;
    [
        (modes.rolling, has(Mode::Rolling)),
        (negative, slides(SlipDirection::Negative)),
        (positive, slides(SlipDirection::Positive)),
        (modes.gliding, has(Mode::Gliding)),
        (modes.flight, has(Mode::Flight)),
    ]
    .into_iter()
    .all(|(ours, theirs)| ours.is_none_or(|ours| ours == theirs))
}
