//! Rolling with resistance, followed in the angle as slides are: u = θ′² obeys a linear equation, too
//! (docs/theory/rolling-resistance.md). It ends at θ′ = 0, or where static friction gives way.

use crate::engine::fallback::Fallback;
use crate::engine::roll::{MARGIN_TOLERANCE, MIN_RATE, OrbitRange, RoundedNumber};
use crate::math::series::product;
use crate::math::trig::{Angle, above_bottom};
use crate::mechanics::ResistedRollingLaw;
use crate::model::{Heavy, Hoop, SlipDirection};

use super::Stop;
use super::regular::{RegularSegment, Span};
use super::segment::{SlideSegment, TimedCoordinate, ValueAt, falling_zero};
use super::series::{
    Expansion, Family, InitialValue, LinearEquation, LinearForm, LinearTerms, Series, SignPattern,
    Signs, TruncatedPolynomial, bernstein, from_both_sides, min_value, scaled, sum_of_sizes,
};
use super::table::{
    AngleInterval, Edge, HALVINGS, LazyGrid, SolutionTable, coarsest, edge_angle_near,
};
use super::turning::{TurningPlace, turning_near};

/// Most segments of a phase: some 16 turns.
const MAX_SEGMENTS: usize = 512;

/// An orbit on which θ′² falls to less than this part of itself without a turning point passes next
/// to rest: it is left to the simulation.
const MIN_PART_OF_U: f64 = 1e-7;

/// The last step to a slip, as a part of a segment.
const MAX_LAST_STEP_TO_SLIP: f64 = 1e-12;

/// Rolling in one direction.
#[derive(Clone, Copy, Debug)]
struct RollFamily {
    body: Heavy,
    law: ResistedRollingLaw,
    mu_s: f64,
}

/// Signs of the margins of static friction, by [`SlipDirection::index`].
#[derive(Clone, Copy, Debug)]
struct MarginPatterns([SignPattern; 2]);

impl Signs for MarginPatterns {
    fn are_unknown(&self) -> bool {
        self.0.contains(&SignPattern::Unknown)
    }
}

impl MarginPatterns {
    /// On the way back, seen in the mirrored frame.
    const fn of_way_back(self) -> Self {
        let [negative, positive] = self.0;
        Self([positive.reversed(), negative.reversed()])
    }
}

/// The polynomials in z of rolling about an angle.
#[derive(Clone, Debug)]
struct RollPolynomials {
    /// n Dχ.
    denominator: [f64; 3],
    /// n³ Dχ (μs N + σ F)/m.
    margins: [LinearForm; 2],
    /// The size of their terms over 1 + u.
    scale: f64,
    equation: LinearEquation,
}

/// n = 1 + z².
const N: [f64; 3] = [1.0, 0.0, 1.0];

/// n cos ϑ, and the arms n a, n d and n (a − ςχ) of the forces of contact, in powers of z.
struct Arms {
    cos: [f64; 3],
    a: [f64; 3],
    d: [f64; 3],
    resisted: [f64; 3],
}

impl Arms {
    fn new(h: f64, resistance: f64, Angle { sin, cos }: Angle) -> Self {
        let a = [sin, 2.0 * cos, -sin].map(|s| h * s);
        let cos = [cos, -2.0 * sin, -cos];
        Self {
            a,
            d: core::array::from_fn(|k| N[k] + h * cos[k]),
            resisted: core::array::from_fn(|k| a[k] - resistance * N[k]),
            cos,
        }
    }
}

impl RollFamily {
    fn new(body: Heavy, mu_s: f64, resistance: f64) -> Self {
        Self {
            body,
            law: ResistedRollingLaw::of_body(&body, resistance),
            mu_s,
        }
    }

    /// About an angle: with n = 1 + z², sin ϑ = S/n and cos ϑ = C/n,
    ///
    /// ```text
    /// n (n Dχ) du/dz = 4 m [h S − ςχ n + (n + h C) tan α + h (S + ςχ C) u].
    /// ```
    fn polynomials(&self, angle: Angle) -> RollPolynomials {
        let Angle { sin, cos } = angle;
        let Heavy {
            mass,
            h,
            inertia,
            offset,
            ..
        } = self.body;
        let (chi, tilt) = (self.law.resistance, self.body.pull());
        let arms = Arms::new(h, chi, angle);
        let (n, s) = (N, [sin, 2.0 * cos, -sin]);
        // n (1 + cos ϑ).
        let above = [above_bottom(angle), -2.0 * sin, 1.0 - cos];
        let denominator: [f64; 3] = core::array::from_fn(|k| {
            self.law.rolling.bottom * n[k] + offset * (2.0 * above[k] - chi * s[k])
        });
        let driving: [f64; 3] = core::array::from_fn(|k| arms.resisted[k] + tilt * arms.d[k]);
        let growth: [f64; 3] = core::array::from_fn(|k| s[k] + chi * arms.cos[k]);
        let padded = |[c0, c1, c2]: [f64; 3]| [c0, c1, c2, 0.0, 0.0];
        let equation = LinearEquation::new(&LinearTerms {
            multiplier: product(&padded(denominator), &n),
            scale: 4.0 * mass,
            drive: padded(driving),
            factor: -h,
            damping: padded(growth),
        });
        let arm = 1.0 + h + chi.abs() + tilt.abs();
        RollPolynomials {
            denominator,
            margins: self.margin_forms(&arms),
            scale: (1.0 + self.mu_s) * (inertia + mass * arm * arm) * arm,
            equation,
        }
    }

    /// n³ Dχ (μs N + σ F)/m, with
    ///
    /// ```text
    /// N Dχ/m = J w − m a d (a u + tan α),
    /// F Dχ/m = (tan α + a u)(Î + m a (a − ςχ)) − m d (a − ςχ) w.
    /// ```
    fn margin_forms(&self, arms: &Arms) -> [LinearForm; 2] {
        let Heavy {
            mass, h, inertia, ..
        } = self.body;
        let tilt = self.body.pull();
        let Arms {
            cos: c,
            a,
            d,
            resisted,
        } = arms;
        let nn = [1.0, 0.0, 2.0, 0.0, 1.0];
        let dd: [f64; 5] = product(d, d);
        let ad: [f64; 5] = product(a, d);
        let a_resisted: [f64; 5] = product(a, resisted);
        let d_resisted: [f64; 5] = product(d, resisted);
        let j: [f64; 5] = core::array::from_fn(|k| inertia * nn[k] + mass * dd[k]);
        let driven: [f64; 5] = core::array::from_fn(|k| inertia * nn[k] + mass * a_resisted[k]);
        let normal_at_rest: [f64; 5] = core::array::from_fn(|k| j[k] - mass * tilt * ad[k]);
        let friction_at_rest: [f64; 5] =
            core::array::from_fn(|k| tilt * driven[k] - mass * d_resisted[k]);
        let (c_j, a_ad): ([f64; 7], [f64; 7]) = (product(c, &j), product(a, &ad));
        let (a_driven, c_d): ([f64; 7], [f64; 7]) = (product(a, &driven), product(c, &d_resisted));
        let normal = LinearForm {
            a: product(&normal_at_rest, &N),
            b: core::array::from_fn(|k| -h * c_j[k] - mass * a_ad[k]),
        };
        let friction = LinearForm {
            a: product(&friction_at_rest, &N),
            b: core::array::from_fn(|k| a_driven[k] + mass * h * c_d[k]),
        };
        SlipDirection::ALL.map(|slip| {
            let margin = |normal: [f64; 7], friction: [f64; 7]| -> [f64; 7] {
                core::array::from_fn(|k| self.mu_s * normal[k] + slip.sign() * friction[k])
            };
            LinearForm {
                a: margin(normal.a, friction.a),
                b: margin(normal.b, friction.b),
            }
        })
    }

    fn expansion(&self, angle: Angle, u: f64) -> Expansion<RollPolynomials> {
        let family = self.polynomials(angle);
        let [u] = family.equation.solutions([InitialValue { u, drive: 1.0 }]);
        Expansion { u, family }
    }

    /// The margins of static friction.
    fn margins(&self, angle: Angle, u: f64) -> [RoundedNumber; 2] {
        let forces = self.law.forces(angle, u);
        let arm = 1.0 + self.law.resistance.abs() + self.body.pull().abs();
        let scale = (1.0 + self.mu_s) * self.body.mass * (1.0 + u) * arm;
        SlipDirection::ALL.map(|slip| RoundedNumber {
            value: self.mu_s * forces.normal + slip.sign() * forces.friction,
            scale,
        })
    }

    fn holds(&self, angle: Angle, u: f64) -> bool {
        let margins = self.margins(angle, u);
        margins.iter().all(RoundedNumber::is_clearly_positive)
    }
}

impl Family for RollPolynomials {
    type Signs = MarginPatterns;

    fn signs(&self, u: &Series, width: f64, _: bool) -> Option<MarginPatterns> {
        if min_value(scaled(self.denominator, width)) <= 0.0 {
            return None;
        }
        let rounding = MARGIN_TOLERANCE * self.scale * (1.0 + sum_of_sizes(u, 1.0));
        let pattern = |form: &LinearForm| {
            let TruncatedPolynomial { low, remainder } = form.on(u, width, 1.0);
            let bernstein = TruncatedPolynomial {
                low: bernstein(low),
                remainder: remainder + rounding,
            };
            bernstein.pattern()
        };
        Some(MarginPatterns(self.margins.each_ref().map(pattern)))
    }
}

/// Rolling over an interval of the angle grid.
#[derive(Clone, Debug)]
struct RollTable {
    solutions: SolutionTable,
    margins: [[TruncatedPolynomial; 2]; 2],
    scale: f64,
    /// u_c of orbits that certainly hold everywhere on it.
    holding: OrbitRange,
}

impl RollTable {
    /// None where Dχ is not known to be positive, and where the series do not reach over the interval.
    fn new(family: &RollFamily, interval: AngleInterval) -> Option<Self> {
        let angle = interval.centre();
        let polynomials = family.polynomials(angle);
        let solutions = SolutionTable::new(&polynomials.equation, angle, interval)?;
        let denominator = scaled(polynomials.denominator, solutions.width);
        if min_value(from_both_sides(denominator)) <= 0.0 {
            return None;
        }
        let margins = polynomials
            .margins
            .each_ref()
            .map(|form| solutions.on_table(form));
        let scale = polynomials.scale;
        let holding = margins
            .iter()
            .map(|[a, b]| TruncatedPolynomial::positive(a, b, 1.0, scale))
            .fold(OrbitRange::ALL, OrbitRange::intersection);
        Some(Self {
            holding,
            solutions,
            margins,
            scale,
        })
    }

    fn signs(&self, u_centre: f64) -> MarginPatterns {
        if self.holding.contains(u_centre) {
            return MarginPatterns([SignPattern::Positive; 2]);
        }
        let rounding = MARGIN_TOLERANCE * self.scale * (1.0 + u_centre.abs());
        MarginPatterns(self.margins.each_ref().map(|[a, b]| {
            let sum = TruncatedPolynomial::of(a, b, u_centre);
            let known = TruncatedPolynomial {
                remainder: sum.remainder + rounding,
                ..sum
            };
            known.pattern()
        }))
    }
}

/// Rolling with resistance of one hoop.
#[derive(Clone, Debug)]
pub(in crate::engine) struct RollTables {
    /// With the frame of motion and against it; of each as it is, and mirrored.
    families: [[RollFamily; 2]; 2],
    /// Of the first two.
    grids: [LazyGrid<RollTable>; 2],
    is_level: bool,
}

/// Rolling that begins at an angle, in the frame of motion.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct RollStart {
    /// −1 where the frame is mirrored.
    pub(in crate::engine) mirror: f64,
    pub(in crate::engine) theta: f64,
    pub(in crate::engine) angle: Angle,
    pub(in crate::engine) u: f64,
    pub(in crate::engine) time_left: f64,
    pub(in crate::engine) uses_tables: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::engine) enum RollStop {
    /// θ′ = 0, with dθ′²/dθ there.
    Turn {
        u_slope: f64,
    },
    Slip(SlipDirection),
    /// By the time limit.
    Cut,
}

/// The end of rolling, in the frame of motion.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct ResistedRollEnd {
    pub(in crate::engine) stop: RollStop,
    pub(in crate::engine) elapsed: f64,
    pub(in crate::engine) theta: f64,
    pub(in crate::engine) theta_rate: f64,
    pub(in crate::engine) angle: Angle,
    /// The largest θ′² on the way, or nearly.
    pub(in crate::engine) max_u: f64,
}

impl RollTables {
    pub(in crate::engine) fn new(hoop: &Hoop, body: &Heavy) -> Self {
        let chi = hoop.rolling_resistance();
        let family = |body: Heavy, chi: f64| RollFamily::new(body, hoop.mu_s(), chi);
        Self {
            families: [chi, -chi].map(|chi| [family(*body, chi), family(body.mirrored(), chi)]),
            grids: Default::default(),
            is_level: body.tilt == 0.0,
        }
    }

    /// sin ϑ at the edges of the bands of rest on a level plane; none where the hoop rests anywhere.
    pub(in crate::engine) fn band_of_rest(&self) -> Option<f64> {
        let RollFamily { body, law, .. } = &self.families[0][0];
        let sin = law.resistance / body.h;
        (self.is_level && sin < 1.0).then_some(sin)
    }

    /// Whether static friction holds a hoop that begins to roll, at every angle.
    pub(in crate::engine) fn holds_at_rest(&self) -> bool {
        AngleInterval::all().all(|interval| {
            let polynomials = self.families[0][0].polynomials(interval.centre());
            let half = libm::tan(0.25 * interval.width());
            let rounding = MARGIN_TOLERANCE * polynomials.scale;
            polynomials
                .margins
                .iter()
                .all(|margin| min_value(from_both_sides(scaled(margin.a, half))) > rounding)
        })
    }

    /// 2 θ″ of rolling at θ′ = 0, and a bound of θ′² of the half swing that begins there.
    pub(in crate::engine) fn at_rest(&self, angle: Angle) -> [f64; 2] {
        let law = &self.families[0][0].law;
        let fallen = 2.0 * law.rolling.offset * above_bottom(angle);
        [
            2.0 * law.acceleration(angle, 0.0),
            fallen / law.rolling.bottom,
        ]
    }

    /// Follows rolling that holds where it begins.
    pub(in crate::engine) fn solve(&self, start: &RollStart) -> Result<ResistedRollEnd, Fallback> {
        let side = usize::from(start.mirror < 0.0);
        let mut roll = Roll {
            tables: self,
            side,
            start,
            theta: start.theta,
            point: RollPoint {
                angle: start.angle,
                u: start.u,
                elapsed: 0.0,
            },
            edge: None,
            is_behind_turn: false,
            max_u: start.u,
            segments: 0,
        };
        if !roll.family().holds(start.angle, start.u) {
            return Err(Fallback::FrictionLimit);
        }
        while roll.segments < MAX_SEGMENTS {
            roll.segments += 1;
            if let Err(stop) = roll.advance() {
                return stop.into_result();
            }
        }
        Err(Fallback::TooLong)
    }
}

#[derive(Clone, Copy, Debug)]
struct RollPoint {
    angle: Angle,
    u: f64,
    elapsed: f64,
}

struct Roll<'a> {
    tables: &'a RollTables,
    /// 1 where the frame of motion is mirrored.
    side: usize,
    start: &'a RollStart,
    theta: f64,
    point: RollPoint,
    /// The edge of the grid at which it is.
    edge: Option<usize>,
    is_behind_turn: bool,
    max_u: f64,
    segments: usize,
}

/// How far a segment was followed; without a stop to its end.
#[derive(Clone, Copy, Debug)]
struct Reached {
    z: f64,
    point: RollPoint,
    stop: Option<RollStop>,
}

/// A part of a segment.
#[derive(Clone, Copy, Debug)]
struct Way {
    span: Span,
    patterns: MarginPatterns,
    /// Whether the angles of the segment are those of the mirrored frame.
    is_mirrored: bool,
}

/// An orbit over an interval.
struct Crossing<'a> {
    interval: AngleInterval,
    table: &'a RollTable,
    u_centre: f64,
}

/// Whether it goes on.
type Advance = Result<(), Stop<ResistedRollEnd>>;

impl<'a> Roll<'a> {
    fn family(&self) -> &'a RollFamily {
        &self.tables.families[0][self.side]
    }

    fn table(&self, interval: AngleInterval) -> Option<&'a RollTable> {
        let grid = if self.tables.is_level { 0 } else { self.side };
        self.tables.grids[grid].get(interval, || RollTable::new(self.family(), interval))
    }

    fn advance(&mut self) -> Advance {
        if self.start.uses_tables {
            self.cross_intervals()?;
            if let Some(advance) = self.advance_in_table() {
                return advance;
            }
        }
        let RollPoint { angle, u, .. } = self.point;
        let expansion = self.family().expansion(angle, u);
        if u == 0.0 && expansion.u[1] <= 0.0 {
            return Err(Fallback::Standstill.into());
        }
        let is_done = self.is_behind_turn && expansion.u[1] > 0.0;
        let turning = if is_done {
            None
        } else {
            let families = &self.tables.families;
            turning_near(angle, &expansion, |is_ahead, angle| {
                if is_ahead {
                    families[1][1 - self.side].expansion(angle, 0.0)
                } else if u == 0.0 {
                    // It begins there.
                    expansion.clone()
                } else {
                    families[0][self.side].expansion(angle, 0.0)
                }
            })
        };
        if let Some(place) = turning {
            return self.follow_turning(&place);
        }
        if u < MIN_PART_OF_U * self.max_u {
            return Err(Fallback::Separatrix.into());
        }
        let segment = RegularSegment::new(&expansion, angle, false)?;
        self.follow_regular(&segment, 0.0, None)
    }

    /// The crossing of the coarsest interval from the edge at which it is.
    fn crossing(&self, edge: Edge) -> Option<Crossing<'a>> {
        edge.intervals().find_map(|interval| {
            let table = self.table(interval)?;
            let u_centre = table.solutions.u_centre_from_entry(self.point.u)?;
            Some(Crossing {
                interval,
                table,
                u_centre,
            })
        })
    }

    /// Crosses whole intervals on which it holds.
    fn cross_intervals(&mut self) -> Advance {
        let mut min_halvings = 0;
        while let Some(index) = self.edge
            && self.segments < MAX_SEGMENTS
            && let Some(crossing) = self.crossing(Edge {
                index,
                min_halvings,
            })
        {
            let Crossing {
                interval,
                table,
                u_centre,
            } = crossing;
            let (solutions, edge) = (&table.solutions, interval.exit());
            // Where an interval was too wide for this orbit the next one probably is, too.
            min_halvings = interval.halvings.saturating_sub(1);
            let time = solutions.time(u_centre);
            let elapsed = self.point.elapsed + time;
            if table.holding.contains(u_centre) && elapsed <= self.start.time_left {
                self.point = RollPoint {
                    angle: solutions.exit_angle,
                    u: solutions.exit(u_centre),
                    elapsed,
                };
                self.max_u = self.max_u.max(self.point.u);
                self.theta += interval.width();
                self.edge = Some(edge);
            } else {
                let patterns = table.signs(u_centre);
                if patterns.are_unknown() {
                    break;
                }
                let segment = solutions.whole(u_centre, time, patterns, None);
                self.follow_regular(&segment, -solutions.end, Some(edge))?;
            }
            self.segments += 1;
        }
        Ok(())
    }

    /// Follows a segment of a table. None where no table has one.
    fn advance_in_table(&mut self) -> Option<Advance> {
        let RollPoint { angle, u, .. } = self.point;
        let slope = 4.0 * self.family().law.acceleration(angle, u);
        let min_halvings = coarsest(slope, u)?;
        for halvings in min_halvings..=HALVINGS {
            for interval in AngleInterval::about(self.theta, halvings) {
                let Some(table) = self.table(interval) else {
                    continue;
                };
                let solutions = &table.solutions;
                let signs = |u_centre| table.signs(u_centre);
                if let Some(entrance) = solutions.enter(angle, u, signs) {
                    let edge = entrance.is_to_exit.then(|| interval.exit());
                    let from = entrance.z;
                    let segment = solutions.segment(entrance, None);
                    return Some(self.follow_regular(&segment, from, edge));
                }
            }
        }
        None
    }

    /// Follows a segment from a coordinate to its end, an edge of the grid or none.
    fn follow_regular(
        &mut self,
        segment: &RegularSegment<MarginPatterns>,
        from: f64,
        edge: Option<usize>,
    ) -> Advance {
        let way = Way {
            span: Span {
                start: from,
                end: segment.end,
            },
            patterns: segment.signs,
            is_mirrored: false,
        };
        let reached = self.reach(segment, way)?;
        let turned = segment.delta_theta(Span {
            start: from,
            end: reached.z,
        });
        self.theta = match (edge, reached.stop) {
            (Some(edge), None) => edge_angle_near(edge, self.theta),
            (None, None) | (_, Some(_)) => self.theta + turned,
        };
        self.arrive(reached, edge)
    }

    fn follow_turning(&mut self, place: &TurningPlace<MarginPatterns>) -> Advance {
        let TurningPlace {
            segment,
            y,
            distance,
            is_ahead,
        } = place;
        let past = 2.0 * libm::atan(*distance);
        if *is_ahead {
            let way = Way {
                span: Span {
                    start: *y,
                    end: 0.0,
                },
                patterns: segment.signs.of_way_back(),
                is_mirrored: false,
            };
            let mut reached = self.reach(segment, way)?;
            self.theta += past + segment.delta_theta(reached.z);
            if reached.stop.is_none() {
                let angle = reached.point.angle;
                if !self.family().holds(angle, 0.0) {
                    return Err(Fallback::FrictionLimit.into());
                }
                let law = &self.family().law;
                reached.stop = Some(RollStop::Turn {
                    u_slope: 2.0 * law.acceleration(angle, 0.0),
                });
            }
            return self.arrive(reached, None);
        }
        let way = Way {
            span: Span {
                start: *y,
                end: 1.0,
            },
            patterns: segment.signs,
            is_mirrored: true,
        };
        let reached = self.reach(segment, way)?;
        self.theta += -past - segment.delta_theta(reached.z);
        self.arrive(reached, None)?;
        self.is_behind_turn = true;
        Ok(())
    }

    /// How far a segment leads: to its end, to the first slip, or to the limit of time.
    fn reach<S: SlideSegment>(&self, segment: &S, way: Way) -> Result<Reached, Fallback> {
        let Span { start, end } = way.span;
        let angle = |z: f64| {
            let angle = segment.angle(z);
            if way.is_mirrored {
                angle.mirrored()
            } else {
                angle
            }
        };
        let margin = |slip: SlipDirection, z: f64| {
            self.family().margins(angle(z), segment.u(z))[slip.index()]
        };
        let (mut z, mut stop) = (end, None);
        for slip in SlipDirection::ALL {
            match way.patterns.0[slip.index()] {
                // It holds where the segment begins.
                SignPattern::Positive | SignPattern::Rising => {}
                SignPattern::Negative | SignPattern::Unknown => return Err(Fallback::SlipShape),
                SignPattern::Falling => {
                    let last = margin(slip, z);
                    if last.is_clearly_positive() {
                        continue;
                    }
                    let first = margin(slip, start).value;
                    if last.value > -MARGIN_TOLERANCE * last.scale || first <= 0.0 {
                        return Err(Fallback::FrictionLimit);
                    }
                    let [low, high] =
                        [(start, first), (z, last.value)].map(|(z, value)| ValueAt { z, value });
                    z = falling_zero(low, high, MAX_LAST_STEP_TO_SLIP, |z| margin(slip, z).value);
                    stop = Some(RollStop::Slip(slip));
                }
            }
        }
        let elapsed = self.point.elapsed + segment.time(start, z);
        let mut reached = TimedCoordinate { z, elapsed };
        if elapsed > self.start.time_left {
            let from = TimedCoordinate {
                z: start,
                elapsed: self.point.elapsed,
            };
            reached = segment.at_time(from, reached, self.start.time_left);
            stop = Some(RollStop::Cut);
        }
        let TimedCoordinate { z, elapsed } = reached;
        Ok(Reached {
            z,
            point: RollPoint {
                angle: angle(z),
                u: segment.u(z),
                elapsed,
            },
            stop,
        })
    }

    /// Moves to the end of a segment, at an edge of the grid or none.
    fn arrive(&mut self, reached: Reached, edge: Option<usize>) -> Advance {
        let point = reached.point;
        (self.point, self.edge, self.is_behind_turn) = (point, edge, false);
        self.max_u = self.max_u.max(point.u);
        let Some(stop) = reached.stop else {
            return Ok(());
        };
        let theta_rate = match stop {
            RollStop::Turn { .. } => 0.0,
            RollStop::Slip(_) | RollStop::Cut => point.u.max(0.0).sqrt(),
        };
        if matches!(stop, RollStop::Slip(_)) && theta_rate < MIN_RATE {
            return Err(Fallback::Standstill.into());
        }
        Err(Stop::End(ResistedRollEnd {
            stop,
            elapsed: point.elapsed,
            theta: self.theta,
            theta_rate,
            angle: point.angle,
            max_u: self.max_u,
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{HoopParameters, RotationDirection, State};
    use crate::modes::{ResistedBudget, ResistedEnd, ResistedRolling, RollingLimit};

    fn hoops() -> impl Iterator<Item = Hoop> {
        [
            (1.0, 1.0, 0.5, 0.05, 0.0),
            (0.2, 0.4, 0.3, 0.2, 0.0),
            (0.01, 0.01, 0.4, 0.01, 0.0),
            (1.0, 1.0, 0.5, 0.02, 0.1),
            (2.0, 0.5, 0.2, 0.3, -0.4),
        ]
        .into_iter()
        .map(|(mass_ratio, inertia, mu, chi, slope)| {
            let parameters = HoopParameters::thin(mass_ratio)
                .with_inertia(inertia)
                .with_friction(mu, mu)
                .with_rolling_resistance(chi)
                .with_slope(slope);
            Hoop::new(parameters).unwrap()
        })
    }

    /// The margins from the equations of motion, at angles all over a table, lie within the bound of
    /// what their sums leave out.
    #[test]
    fn margins_are_those_of_the_equations_however_fast_an_orbit_is() {
        let mut all = 0;
        for hoop in hoops() {
            let tables = RollTables::new(&hoop, &hoop.rigid_body());
            let family = &tables.families[0][0];
            for (interval, k) in AngleInterval::all().flat_map(|it| (0..5).map(move |k| (it, k))) {
                let Some(table) = RollTable::new(family, interval) else {
                    continue;
                };
                all += 1;
                let u_centre = libm::pow(10.0, f64::from(k) - 2.0);
                let forms = table.margins.each_ref();
                let forms = forms.map(|[a, b]| TruncatedPolynomial::of(a, b, u_centre));
                for k in 0..=20 {
                    let at = 0.05 * f64::from(k);
                    let z = table.solutions.width * (2.0 * at - 1.0);
                    let angle = table.solutions.angle.plus(Angle::of_half_tangent(z));
                    let u = table.solutions.u_at(u_centre, 2.0 * at - 1.0);
                    let factor = libm::pow(1.0 + z * z, 3.0) * family.law.denominator_of(angle);
                    let margins = family.margins(angle, u);
                    for (margin, TruncatedPolynomial { low, remainder }) in
                        margins.iter().zip(&forms)
                    {
                        let expected = factor * margin.value / family.body.mass;
                        // The value of a Bernstein form, by repeated means of its coefficients.
                        let mut means = *low;
                        for last in (1..means.len()).rev() {
                            for j in 0..last {
                                means[j] += at * (means[j + 1] - means[j]);
                            }
                        }
                        let rounding = MARGIN_TOLERANCE * table.scale * (1.0 + u.abs());
                        let error = (means[0] - expected).abs();
                        assert!(error <= remainder + rounding, "{interval:?} {u}: {error:e}");
                    }
                }
            }
        }
        assert!(all > 300, "{all}");
    }

    /// The end by Taylor series in time, and the direction of a slip.
    fn by_series(hoop: &Hoop, start: &RollStart) -> (State, Option<SlipDirection>) {
        let state = State {
            time: 0.0,
            theta: start.theta,
            theta_rate: start.u.sqrt(),
            slip: 0.0,
            x: 0.0,
        };
        let budget = ResistedBudget {
            time_left: Some(start.time_left),
            steps: 10_000,
        };
        let direction = RotationDirection::Positive;
        let (_, end) = ResistedRolling::run(hoop, &hoop.rigid_body(), state, direction, budget);
        match end {
            ResistedEnd::TurningPoint(state) | ResistedEnd::TimeLimit(state) => (state, None),
            ResistedEnd::Limit {
                state,
                limit: RollingLimit::Friction(slip),
            } => (state, Some(slip)),
            end => panic!("{end:?}"),
        }
    }

    /// The same end as by Taylor series in time, on slopes, too.
    #[test]
    fn rolling_ends_as_by_series_in_time() {
        let (mut turns, mut slips) = (0, 0);
        for hoop in hoops() {
            let tables = RollTables::new(&hoop, &hoop.rigid_body());
            for k in 0..400_u32 {
                let theta = 0.37 * f64::from(k % 17) - 3.0;
                let rate = 0.05 * f64::from(k % 43) + 0.02;
                let start = RollStart {
                    mirror: 1.0,
                    theta,
                    angle: Angle::of(theta),
                    u: rate * rate,
                    time_left: 30.0,
                    uses_tables: k % 2 == 0,
                };
                let Ok(found) = tables.solve(&start) else {
                    continue;
                };
                let (state, stop) = by_series(&hoop, &start);
                turns += u32::from(state.theta_rate == 0.0);
                slips += u32::from(stop.is_some());
                let slip = match found.stop {
                    RollStop::Slip(slip) => Some(slip),
                    RollStop::Turn { .. } | RollStop::Cut => None,
                };
                assert_eq!(slip, stop, "{theta} {rate}");
                for (found, expected) in [
                    (found.elapsed, state.time),
                    (found.theta, state.theta),
                    (found.theta_rate, state.theta_rate),
                ] {
                    let error = (found - expected).abs();
                    assert!(error < 1e-10, "{theta} {rate}: {found} {expected}");
                }
            }
        }
        assert!(turns > 300 && slips > 100, "{turns} {slips}");
    }
}
