//! Rolling along one orbit, to its slip, in the direction of motion (docs/engine.md): a zero of the
//! forms of [`crate::modes::rolling`] on the arcs ahead, isolated in Bernstein form.

use std::sync::OnceLock;

use crate::math::bracket::Bracket;
use crate::math::form::{Form, HalfAngle, on_arc};
use crate::math::trig::Angle;
use crate::model::{Hoop, SlipDirection};
use crate::modes::rolling::{HalfAngleOrbit, OrbitEnergy, OrbitPass, ReducedAngle, margin_forms};

use super::fallback::Fallback;

/// A direction of slip in a frame that is mirrored for −1.
pub(super) const fn mirrored_slip(slip: SlipDirection, mirror: f64) -> SlipDirection {
    if mirror < 0.0 { slip.reversed() } else { slip }
}

/// A margin within this part of its terms of zero is solved exactly.
pub(super) const MARGIN_TOLERANCE: f64 = 1e-12;

/// Slower slips are solved exactly: an angle reduced to a turn is known to 4e-16, and at this rate
/// the time to 1e-13.
pub(super) const MIN_RATE: f64 = 4e-3;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RollEnd {
    Slip(RollSlip),
    /// Never slips.
    Never,
    /// Neither for many turns.
    Open,
}

/// The end of rolling by a slip, in the direction of motion at its start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RollSlip {
    pub(super) elapsed: f64,
    pub(super) theta: f64,
    pub(super) theta_rate: f64,
    pub(super) slip: SlipDirection,
    pub(super) angle: Angle,
}

const OCTANTS: usize = 8;

/// Directions of the half angle at the ends of the octants.
const OCTANT_ENDS: [HalfAngle; OCTANTS + 1] = {
    const COS: f64 = 0.923_879_532_511_286_7;
    const SIN: f64 = 0.382_683_432_365_089_8;
    const BOTH: f64 = core::f64::consts::FRAC_1_SQRT_2;
    [
        [1.0, 0.0],
        [COS, SIN],
        [BOTH, BOTH],
        [SIN, COS],
        [0.0, 1.0],
        [-SIN, COS],
        [-BOTH, BOTH],
        [-COS, SIN],
        [-1.0, 0.0],
    ]
};

/// The margin of static friction of one body as a + L b, with the level L = K − D(π) of an orbit.
#[derive(Clone, Copy, Debug)]
pub(super) struct MarginForm {
    pub(super) a: Form<7>,
    pub(super) b: Form<7>,
}

impl MarginForm {
    fn on_orbit(&self, orbit_level: f64) -> Form<7> {
        Form(core::array::from_fn(|i| {
            self.a.0[i] + orbit_level * self.b.0[i]
        }))
    }

    fn at(&self, half: HalfAngle, orbit_level: f64) -> RoundedNumber {
        RoundedNumber {
            value: self.a.value(half) + orbit_level * self.b.value(half),
            scale: self.a.size(half) + orbit_level * self.b.size(half),
        }
    }
}

/// The margins of the two directions of slip in the frame of motion, by [`SlipDirection::index`].
pub(super) type Margins = [MarginForm; 2];

/// The margins of a hoop that moves in a direction; none of a massless one.
pub(super) fn margins_of(hoop: &Hoop, heading: f64) -> Option<Margins> {
    Some(margin_forms(hoop, heading)?.map(|[a, b]| MarginForm { a, b }))
}

/// The forms X^(6−k) Y^k in the barycentric coordinates of each octant, by the power of these, then
/// by k.
const POWERS: [[[f64; 7]; 7]; OCTANTS] = {
    let mut table = [[[0.0; 7]; 7]; OCTANTS];
    let mut octant = 0;
    while octant < OCTANTS {
        let mut k = 0;
        while k < 7 {
            let mut form = [0.0; 7];
            form[0] = 1.0;
            let mut factor = 0;
            while factor < 6 {
                let axis = if factor < k { 1 } else { 0 };
                let mut i = 6;
                while i > 0 {
                    form[i] = form[i] * OCTANT_ENDS[octant][axis]
                        + form[i - 1] * OCTANT_ENDS[octant + 1][axis];
                    i -= 1;
                }
                form[0] *= OCTANT_ENDS[octant][axis];
                factor += 1;
            }
            let mut i = 0;
            while i < 7 {
                table[octant][i][k] = form[i];
                i += 1;
            }
            k += 1;
        }
        octant += 1;
    }
    table
};

/// A number, and the sum of the sizes of its terms, which bounds its rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoundedNumber {
    pub(super) value: f64,
    pub(super) scale: f64,
}

impl RoundedNumber {
    #[inline(always)]
    pub(super) fn is_clearly_positive(&self) -> bool {
        self.value > MARGIN_TOLERANCE * self.scale
    }
}

/// A number a + L b of each orbit.
#[derive(Clone, Copy, Debug)]
pub(super) struct LinearNumber {
    pub(super) a: RoundedNumber,
    pub(super) b: RoundedNumber,
}

/// An open range of the constant of orbits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct OrbitRange {
    pub(super) min: f64,
    pub(super) max: f64,
}

impl OrbitRange {
    pub(super) const ALL: Self = Self {
        min: f64::NEG_INFINITY,
        max: f64::INFINITY,
    };

    /// The constants above `min` for which all numbers are positive, narrowed by their rounding.
    pub(super) fn of_positive(min: f64, numbers: impl IntoIterator<Item = LinearNumber>) -> Self {
        let mut range = Self {
            min,
            max: f64::INFINITY,
        };
        for LinearNumber { a, b } in numbers {
            let zero = -a.value / b.value;
            let rounding =
                4.0 * MARGIN_TOLERANCE * (a.scale + zero.abs() * b.scale) / b.value.abs();
            if b.value > 0.0 {
                range.min = f64::max(range.min, zero + rounding);
            } else if b.value < 0.0 {
                range.max = f64::min(range.max, zero - rounding);
            } else if a.value <= MARGIN_TOLERANCE * a.scale {
                range.max = f64::NEG_INFINITY;
            }
        }
        range
    }

    #[inline(always)]
    pub(super) fn contains(&self, constant: f64) -> bool {
        constant > self.min && constant < self.max
    }

    #[must_use]
    pub(super) const fn shifted(self, by: f64) -> Self {
        Self {
            min: self.min + by,
            max: self.max + by,
        }
    }

    /// Each end moved inwards by this part of the sum of its size and another.
    #[must_use]
    pub(super) fn narrowed(self, part: f64, size: f64) -> Self {
        // An infinite end would be narrowed by infinity, to NaN.
        let rounding = |end: f64| part * (end.abs().min(f64::MAX) + size);
        Self {
            min: self.min + rounding(self.min),
            max: self.max - rounding(self.max),
        }
    }

    #[must_use]
    pub(super) const fn intersection(self, other: Self) -> Self {
        Self {
            min: self.min.max(other.min),
            max: self.max.min(other.max),
        }
    }
}

/// The margins on one octant of the half angle.
#[derive(Clone, Debug)]
struct MarginTable {
    /// In its barycentric coordinates.
    margins: Margins,
    /// Orbits that certainly hold everywhere on it.
    holding: OrbitRange,
}

/// A margin on an orbit over an octant.
struct TabulatedMargin {
    form: Form<7>,
    signs: MarginSigns,
}

impl MarginTable {
    fn new(margins: &Margins, octant: usize) -> Self {
        let powers = &POWERS[octant];
        let transformed = |form: &Form<7>| {
            Form(powers.map(|powers| powers.iter().zip(form.0).map(|(power, c)| power * c).sum()))
        };
        let scales = |form: &Form<7>| {
            powers.map(|powers| {
                let terms = powers
                    .iter()
                    .zip(form.0)
                    .map(|(power, c)| (power * c).abs());
                terms.sum::<f64>()
            })
        };
        let numbers = margins.iter().flat_map(|margin| {
            let (a, b) = (transformed(&margin.a), transformed(&margin.b));
            let (a_scales, b_scales) = (scales(&margin.a), scales(&margin.b));
            (0..7).map(move |k| LinearNumber {
                a: RoundedNumber {
                    value: a.0[k],
                    scale: a_scales[k],
                },
                b: RoundedNumber {
                    value: b.0[k],
                    scale: b_scales[k],
                },
            })
        });
        Self {
            holding: OrbitRange::of_positive(0.0, numbers),
            margins: margins.each_ref().map(|margin| MarginForm {
                a: transformed(&margin.a),
                b: transformed(&margin.b),
            }),
        }
    }

    /// The margin of a direction of slip; `is_up` if the half angle grows.
    fn margin(&self, slip: SlipDirection, orbit_level: f64, is_up: bool) -> TabulatedMargin {
        let form = self.margins[slip.index()].on_orbit(orbit_level);
        let mut in_order = form.0;
        if !is_up {
            in_order.reverse();
        }
        TabulatedMargin {
            form,
            signs: MarginSigns::of(&in_order),
        }
    }
}

/// The tables of one hoop, made when an orbit first needs them, and the same whichever orbit that
/// is.
#[derive(Clone, Debug, Default)]
pub(super) struct MarginTables {
    octants: [OnceLock<Box<MarginTable>>; OCTANTS],
    /// Orbits that certainly hold everywhere.
    holding: OnceLock<OrbitRange>,
}

impl MarginTables {
    /// Whether the orbit with a level certainly holds everywhere.
    fn hold(&self, margins: &Margins, orbit_level: f64) -> bool {
        let holding = self.holding.get_or_init(|| {
            let ranges = (0..OCTANTS).map(|number| self.get(margins, number).holding);
            ranges.fold(OrbitRange::ALL, OrbitRange::intersection)
        });
        holding.contains(orbit_level)
    }

    fn get(&self, margins: &Margins, number: usize) -> &MarginTable {
        self.octants[number].get_or_init(|| Box::new(MarginTable::new(margins, number)))
    }
}

/// The signs of the Bernstein coefficients of a margin.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum MarginSigns {
    /// All positive: so is the margin.
    Holds,
    /// One change: the margin falls through zero once.
    Falls,
    Unclear,
}

impl MarginSigns {
    /// From the coefficients in order of passage.
    pub(super) fn of(coefficients: &[f64]) -> Self {
        let (above, rest) =
            coefficients.split_at(coefficients.iter().take_while(|c| **c > 0.0).count());
        match rest.last() {
            None => Self::Holds,
            Some(last) if !above.is_empty() && *last < 0.0 && rest.iter().all(|c| *c <= 0.0) => {
                Self::Falls
            }
            Some(_) => Self::Unclear,
        }
    }
}

/// Positive where the second direction lies ahead of the first.
fn cross(first: HalfAngle, second: HalfAngle) -> f64 {
    first[0] * second[1] - first[1] * second[0]
}

/// Part of an orbit between two directions of the half angle.
#[derive(Clone, Copy, Debug)]
struct OrbitArc {
    from: HalfAngle,
    to: HalfAngle,
    pass: OrbitPass,
}

/// The part of an arc on one octant.
#[derive(Clone, Copy, Debug)]
struct OctantArc {
    octant: usize,
    arc: OrbitArc,
}

impl OrbitArc {
    /// Whether the half angle grows.
    fn is_up(&self) -> bool {
        cross(self.from, self.to) > 0.0
    }

    fn parts(self) -> impl Iterator<Item = OctantArc> {
        let Self { from, to, pass } = self;
        let is_up = self.is_up();
        let is_behind = |edge: &HalfAngle| {
            let side = cross(*edge, from);
            side > 0.0 || (is_up && side == 0.0)
        };
        let mut octant = OCTANT_ENDS[1..OCTANTS].partition_point(is_behind);
        let mut next = Some(from);
        core::iter::from_fn(move || {
            let from = next?;
            let edge = OCTANT_ENDS[if is_up { octant + 1 } else { octant }];
            let ahead = cross(edge, to);
            let continues = if is_up {
                ahead > 0.0 && octant + 1 < OCTANTS
            } else {
                ahead < 0.0 && octant > 0
            };
            let part = OctantArc {
                octant,
                arc: Self {
                    from,
                    to: if continues { edge } else { to },
                    pass,
                },
            };
            next = continues.then_some(edge);
            if continues {
                octant = if is_up { octant + 1 } else { octant - 1 };
            }
            Some(part)
        })
    }
}

/// The first zero of a margin on an arc.
#[derive(Clone, Copy, Debug)]
struct MarginZero {
    /// The barycentric coordinate.
    at: f64,
    slip: SlipDirection,
}

/// One orbit.
struct RollProblem<'a> {
    orbit: &'a HalfAngleOrbit,
    orbit_level: f64,
    margins: &'a Margins,
    /// The direction of slip whose margin is zero at the start, where static friction holds behind.
    limit: Option<SlipDirection>,
}

/// Follows an orbit on which rolling holds where it is entered, perhaps just so (`on_limit`).
/// `tables` are used by long motions.
pub(super) fn solve_roll(
    orbit: &HalfAngleOrbit,
    margins: &Margins,
    on_limit: bool,
    tables: Option<&MarginTables>,
) -> Result<RollEnd, Fallback> {
    let orbit_level = orbit.orbit_level();
    if let (Some(tables), false) = (tables, on_limit)
        && tables.hold(margins, orbit_level)
    {
        return Ok(RollEnd::Never);
    }
    let half = [-orbit.start.z, orbit.start.y];
    let [negative, positive] = margins
        .each_ref()
        .map(|margin| margin.at(half, orbit_level));
    let limit = on_limit.then(|| {
        if positive.value.abs() < negative.value.abs() {
            SlipDirection::Positive
        } else {
            SlipDirection::Negative
        }
    });
    // So close to the limit, rounding would decide whether the hoop slips at once.
    let holds = match limit {
        None => negative.is_clearly_positive() && positive.is_clearly_positive(),
        Some(SlipDirection::Negative) => positive.is_clearly_positive(),
        Some(SlipDirection::Positive) => negative.is_clearly_positive(),
    };
    if !holds {
        return Err(Fallback::FrictionLimit);
    }
    let problem = RollProblem {
        orbit,
        orbit_level,
        margins,
        limit,
    };
    match tables {
        Some(tables) => problem.solve_by_tables(tables),
        None => problem.solve(),
    }
}

impl RollProblem<'_> {
    /// Isolates the zeros of both margins on each arc.
    fn solve(&self) -> Result<RollEnd, Fallback> {
        for (number, arc) in arcs(self.orbit).enumerate() {
            let limit = self.limit.filter(|_| number == 0);
            if let Some(zero) = self.first_zero(&arc, limit, |_| false) {
                return self.slip(&arc, zero);
            }
        }
        Ok(RollEnd::Never)
    }

    /// The same by octants: most orbits certainly hold on an octant, or have one margin there with
    /// one sign change, which needs no isolation.
    fn solve_by_tables(&self, tables: &MarginTables) -> Result<RollEnd, Fallback> {
        let mut limit_ahead = self.limit;
        for arc in arcs(self.orbit) {
            for part in arc.parts() {
                // A start on the edge of an octant leaves it at once: the half angle is rounded, and
                // the margin is zero in the next.
                let OrbitArc { from, to, .. } = part.arc;
                if limit_ahead.is_some() && cross(from, to).abs() <= 4.0 * f64::EPSILON {
                    continue;
                }
                let table = tables.get(self.margins, part.octant);
                let limit = limit_ahead.take();
                if !table.holding.contains(self.orbit_level)
                    && let Some(end) = self.end_on(table, &part, limit)
                {
                    return end;
                }
            }
        }
        Ok(RollEnd::Never)
    }

    /// The slip on the part of an arc in an octant, if there is one.
    fn end_on(
        &self,
        table: &MarginTable,
        OctantArc { octant, arc }: &OctantArc,
        limit: Option<SlipDirection>,
    ) -> Option<Result<RollEnd, Fallback>> {
        let is_up = arc.is_up();
        let known = SlipDirection::ALL.map(|slip| table.margin(slip, self.orbit_level, is_up));
        let falling = match &known {
            [falls, holds] if is_only_fall(falls, holds) => Some((SlipDirection::Negative, falls)),
            [holds, falls] if is_only_fall(falls, holds) => Some((SlipDirection::Positive, falls)),
            [_, _] => None,
        };
        let (begin, end) = (OCTANT_ENDS[*octant], OCTANT_ENDS[octant + 1]);
        let (first, last) = if is_up { (begin, end) } else { (end, begin) };
        // The margin is positive where the arc begins. If the arc leads to the end of the octant, the
        // fall lies ahead.
        if let Some((slip, falls)) = falling
            && limit.is_none()
            && arc.to == last
        {
            let whole = OrbitArc {
                from: first,
                to: last,
                ..*arc
            };
            let at = falls.zero(is_up);
            return Some(self.slip(&whole, MarginZero { at, slip }));
        }
        let holds = |slip: SlipDirection| known[slip.index()].signs == MarginSigns::Holds;
        let zero = self.first_zero(arc, limit, holds)?;
        Some(self.slip(arc, zero))
    }

    /// The first zero on an arc of the margins that may not hold; `limit` is the one that is zero
    /// at its start.
    fn first_zero(
        &self,
        arc: &OrbitArc,
        limit: Option<SlipDirection>,
        holds: impl Fn(SlipDirection) -> bool,
    ) -> Option<MarginZero> {
        let mut first: Option<MarginZero> = None;
        for slip in SlipDirection::ALL {
            if holds(slip) {
                continue;
            }
            let margin = self.margins[slip.index()]
                .on_orbit(self.orbit_level)
                .restricted(arc.from, arc.to);
            let at = if limit == Some(slip) {
                let margin = margin.bernstein().starting_at_zero();
                margin
                    .first_crossing()
                    .map(|bracket| bracket.refine(|t| margin.value_and_slope(t)))
            } else if margin.0.iter().all(|c| *c > 0.0) {
                // No zero without a change of sign.
                None
            } else {
                margin.bernstein().first_crossing().map(|bracket| {
                    let [first, last] =
                        [bracket.low, bracket.high].map(|t| margin.value([1.0 - t, t]));
                    bracket.refine_from_values(first, last, |t| newton_pair(&margin.0, t))
                })
            };
            first = match (first, at) {
                (Some(before), Some(at)) if at >= before.at => first,
                (_, Some(at)) => Some(MarginZero { at, slip }),
                (_, None) => first,
            };
        }
        first
    }

    fn slip(&self, arc: &OrbitArc, zero: MarginZero) -> Result<RollEnd, Fallback> {
        let orbit = self.orbit;
        let [x, y] = on_arc(arc.from, arc.to, zero.at);
        let z = -x;
        let four_l = orbit.four_l;
        let d = orbit.energy.bottom + four_l * z * z;
        // K − D changes by 4ℓ̂ (z0² − z²).
        let twice_kinetic = if orbit.rotates {
            orbit.energy.separatrix_gap + four_l * y * y
        } else {
            let start = orbit.start.z;
            (orbit.twice_kinetic + four_l * (start - z) * (start + z)).max(0.0)
        };
        let rate = (twice_kinetic / d).sqrt();
        if rate < MIN_RATE {
            return Err(Fallback::Standstill);
        }
        let start_turn = orbit.start.turn;
        let (turn, theta_rate) = match arc.pass {
            OrbitPass::First => (start_turn, rate),
            OrbitPass::NextTurn => (start_turn + 1.0, rate),
            OrbitPass::WayBack => (start_turn, -rate),
        };
        Ok(RollEnd::Slip(RollSlip {
            elapsed: orbit.time(orbit.phase(z, y, twice_kinetic), arc.pass),
            theta: ReducedAngle { turn, z, y }.angle(),
            theta_rate,
            slip: zero.slip,
            // Twice the half angle.
            angle: Angle {
                sin: -2.0 * y * z,
                cos: z * z - y * y,
            },
        }))
    }
}

fn is_only_fall(falls: &TabulatedMargin, holds: &TabulatedMargin) -> bool {
    falls.signs == MarginSigns::Falls && holds.signs == MarginSigns::Holds
}

impl TabulatedMargin {
    /// The barycentric coordinate of its one zero, from the end that is passed first.
    fn zero(&self, is_up: bool) -> f64 {
        let mut in_order = self.form.0;
        if !is_up {
            in_order.reverse();
        }
        // A form has its first and its last coefficient at the ends of its arc.
        let [first, .., last] = in_order;
        Bracket {
            low: 0.0,
            high: 1.0,
        }
        .refine_from_values(first, last, |t| newton_pair(&in_order, t))
    }
}

/// The form Σ c_k (1 − t)^(6−k) t^k over (1 − t)⁴, and its derivative by t over the same, for a step
/// of Newton's method: with s = t/(1 − t) they are (1 − t)² p(s) and p′(s) − 6 (1 − t) p(s), p the
/// polynomial with the coefficients of the form. In the second half of the arc from its other end.
fn newton_pair(form: &[f64; 7], t: f64) -> (f64, f64) {
    let (far, near) = (1.0 - t, t);
    let horner = |coefficients: [f64; 7], s: f64| {
        let (mut value, mut slope) = (coefficients[6], 0.0);
        for c in coefficients[..6].iter().rev() {
            (value, slope) = (value * s + c, slope * s + value);
        }
        (value, slope)
    };
    if near <= far {
        let (value, slope) = horner(*form, near / far);
        (far * far * value, slope - 6.0 * far * value)
    } else {
        let mut reversed = *form;
        reversed.reverse();
        let (value, slope) = horner(reversed, far / near);
        (near * near * value, 6.0 * near * value - slope)
    }
}

/// The arcs that lie ahead, until every point of the orbit has been passed.
fn arcs(orbit: &HalfAngleOrbit) -> impl Iterator<Item = OrbitArc> {
    (0..4)
        .filter_map(|number| arc(orbit, number))
        .filter(|arc| arc.from != arc.to)
}

/// One of up to four arcs, when it is asked for: most orbits end on the first.
fn arc(orbit: &HalfAngleOrbit, number: u8) -> Option<OrbitArc> {
    let (start, bottom) = ([-orbit.start.z, orbit.start.y], [0.0, 1.0]);
    let past_bottom = orbit.start.z >= 0.0;
    let turning = || {
        let OrbitEnergy {
            beta,
            separatrix_gap,
            ..
        } = orbit.energy;
        [
            -(beta / orbit.four_l).sqrt(),
            (separatrix_gap / orbit.four_l).sqrt(),
        ]
    };
    let (from, to, pass) = match (number, orbit.rotates, past_bottom) {
        (0, _, true) => return None,
        (0, _, false) => (start, bottom, OrbitPass::First),
        (1, rotates, _) => {
            let from = if past_bottom { start } else { bottom };
            let to = if rotates { [-1.0, 0.0] } else { turning() };
            (from, to, OrbitPass::First)
        }
        (2, true, _) => {
            let to = if past_bottom { bottom } else { start };
            ([1.0, 0.0], to, OrbitPass::NextTurn)
        }
        (2, false, _) => (turning(), bottom, OrbitPass::WayBack),
        (_, true, true) => (bottom, start, OrbitPass::NextTurn),
        (_, true, false) => return None,
        (_, false, _) => {
            let [x, y] = turning();
            (bottom, [-x, y], OrbitPass::WayBack)
        }
    };
    Some(OrbitArc { from, to, pass })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::chain::SlipCurves;
    use crate::mechanics::RollingLaw;
    use crate::model::{Hoop, HoopParameters, State};
    use crate::modes::Rolling;

    fn half_angle(theta: f64) -> HalfAngle {
        let (y, x) = libm::sincos(0.5 * theta);
        [x, y]
    }

    /// Where a margin vanishes and grows behind, on both sides of the body, forth and back: the
    /// exact solver's slip, by the orbit alone and by what is kept of it.
    #[test]
    fn an_orbit_on_the_limit_slips_where_it_does_for_the_exact_solver() {
        let mut slips = 0;
        for (mass_ratio, inertia, mu_s) in [(1.0, 1.0, 0.5), (2.0, 0.5, 0.2), (0.1, 0.07, 0.9)] {
            let hoop = HoopParameters::thin(mass_ratio)
                .with_offset(0.9)
                .with_inertia(inertia)
                .with_friction(mu_s, 0.0);
            let hoop = Hoop::new(hoop).unwrap();
            let (margins, law) = (margins_of(&hoop, 1.0).unwrap(), RollingLaw::of(&hoop));
            let curve = SlipCurves::new(margins, law);
            for (step, slip) in
                (0..300).flat_map(|step| SlipDirection::ALL.map(|slip| (step, slip)))
            {
                let theta = 0.021 * f64::from(step) - 3.1;
                let Some(u) = curve.slip_rate_squared(slip, theta).filter(|u| *u > 1e-2) else {
                    continue;
                };
                let rate = u.sqrt();
                let Some(orbit) = HalfAngleOrbit::enter(&law, theta, rate) else {
                    continue;
                };
                let ahead = margins[slip.index()]
                    .on_orbit(orbit.orbit_level())
                    .value(half_angle(theta + 1e-4));
                if ahead < 1e-9 {
                    continue;
                }
                let start = State {
                    time: 0.0,
                    theta,
                    theta_rate: rate,
                    slip: 0.0,
                    x: 0.0,
                };
                let expected = Rolling::new(&hoop, start).orbit().end_from_limit();
                let tables = MarginTables::default();
                for tables in [None, Some(&tables)] {
                    let found = solve_roll(&orbit, &margins, true, tables);
                    match (found, expected) {
                        (
                            Ok(RollEnd::Slip(RollSlip {
                                elapsed,
                                theta,
                                theta_rate,
                                ..
                            })),
                            Some(end),
                        ) => {
                            for (found, expected) in [
                                (elapsed, end.elapsed),
                                (theta, end.theta),
                                (theta_rate, end.theta_rate),
                            ] {
                                let allowed = 1e-12 * (1.0 + expected.abs());
                                assert!(
                                    (found - expected).abs() < allowed,
                                    "{orbit:?}: {found} {expected}"
                                );
                            }
                            slips += 1;
                        }
                        (Ok(RollEnd::Never), _) | (Ok(_), None) => {
                            panic!("{orbit:?} {found:?} {expected:?}")
                        }
                        (Ok(RollEnd::Open) | Err(_), _) => {}
                    }
                }
            }
        }
        assert!(slips > 500, "{slips}");
    }

    #[test]
    fn the_parts_of_an_arc_are_the_arc() {
        let at = |turns: f64| {
            let (y, x) = libm::sincos(core::f64::consts::PI * turns);
            [x, y]
        };
        // From octants 0.8 to 5.3, back, inside one, and from edge to edge.
        for (from, to, octants) in [
            (at(0.1), at(0.66), vec![0, 1, 2, 3, 4, 5]),
            (at(0.66), at(0.1), vec![5, 4, 3, 2, 1, 0]),
            (at(0.3), at(0.35), vec![2]),
            (at(0.35), at(0.3), vec![2]),
            (OCTANT_ENDS[0], OCTANT_ENDS[4], vec![0, 1, 2, 3]),
            (OCTANT_ENDS[4], OCTANT_ENDS[8], vec![4, 5, 6, 7]),
            (OCTANT_ENDS[4], OCTANT_ENDS[2], vec![3, 2]),
            ([-1.0, 0.0], OCTANT_ENDS[4], vec![7, 6, 5, 4]),
        ] {
            let parts: Vec<OctantArc> = OrbitArc {
                from,
                to,
                pass: OrbitPass::First,
            }
            .parts()
            .collect();
            assert_eq!(
                parts.iter().map(|part| part.octant).collect::<Vec<_>>(),
                octants
            );
            assert_eq!(
                (parts[0].arc.from, parts[parts.len() - 1].arc.to),
                (from, to)
            );
            assert!(
                parts
                    .windows(2)
                    .all(|pair| pair[0].arc.to == pair[1].arc.from)
            );
            for OctantArc {
                octant,
                arc: OrbitArc { from, to, .. },
            } in parts
            {
                let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
                assert!(
                    cross(OCTANT_ENDS[octant], middle) > 0.0
                        && cross(middle, OCTANT_ENDS[octant + 1]) > 0.0
                );
            }
        }
    }

    #[test]
    fn a_margin_next_to_zero_is_not_clearly_positive() {
        // 1 − L, with levels next to its zero.
        for (orbit_level, expected) in [
            (0.5, true),
            (1.0 - 1e-11, true),
            (1.0 - 1e-12, false),
            (1.0 + 1e-12, false),
            (2.0, false),
            (f64::NAN, false),
        ] {
            let margin = RoundedNumber {
                value: 1.0 - orbit_level,
                scale: 1.0 + orbit_level,
            };
            assert_eq!(margin.is_clearly_positive(), expected, "{orbit_level}");
        }
    }

    #[test]
    fn an_orbit_on_the_limit_is_not_said_to_hold() {
        let of = |margins: [[f64; 2]; 2]| {
            let exact = |value: f64| RoundedNumber {
                value,
                scale: value.abs(),
            };
            let numbers = margins.map(|[a, b]| LinearNumber {
                a: exact(a),
                b: exact(b),
            });
            OrbitRange::of_positive(0.0, numbers)
        };
        // Margins L − 2 and 6 − 2 L, both positive for 2 < L < 3.
        let OrbitRange { min, max } = of([[-2.0, 1.0], [6.0, -2.0]]);
        assert!(
            min > 2.0 * (1.0 + MARGIN_TOLERANCE) && min < 2.0 + 1e-10,
            "{min:e}"
        );
        assert!(
            max < 3.0 * (1.0 - MARGIN_TOLERANCE) && max > 3.0 - 1e-10,
            "{max:e}"
        );
        // A margin that no orbit changes.
        let all = OrbitRange {
            min: 0.0,
            max: f64::INFINITY,
        };
        assert_eq!(of([[1.0, 0.0], [1.0, 0.0]]), all);
        assert_eq!(of([[1.0, 0.0], [-1.0, 0.0]]).max, f64::NEG_INFINITY);
    }
}
