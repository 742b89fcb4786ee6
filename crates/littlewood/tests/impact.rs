//! The impact against stepping Newton's and Euler's equations in the impulse, without a table of
//! cases; its balances of momentum and energy; its mirror image; and numbers computed with 40
//! digits.
#![allow(clippy::panic)] // a failed expectation

use crate::common::heavy_hoop;
use littlewood::cases::find_case;
use littlewood::impact::{Impact, ImpactCase, ImpactError};
use littlewood::tables::Quantity;
use littlewood::theory::Body;
use littlewood::{
    Hoop, HoopParameters, Limits, Outcome, OutcomeKind, Restitution, RestitutionLaw, Start, State,
};
use littlewood_random::Draw;
use proptest::prelude::*;
use serde_json::Value;

const BOUNCES: &str = include_str!("../../../evidence/reference/bounces.json");
const RESISTANCE: &str = include_str!("../../../evidence/reference/resistance.json");

fn restitution(coefficient: f64, law: RestitutionLaw) -> Restitution {
    Restitution::new(coefficient, law).expect("a coefficient between 0 and 1")
}

fn landing() -> (Hoop, State, f64) {
    let motion = find_case("figure-3")
        .expect("a case")
        .simulate()
        .expect("a valid case");
    let Outcome::Landing { state, gap_rate } = motion.outcome() else {
        panic!("lands")
    };
    (*motion.hoop(), state, gap_rate)
}

/// Computed with 40 digits from the equations of the impact.
#[test]
fn the_landing_of_figure_3_has_the_impact_of_the_40_digit_computation() {
    let (hoop, state, gap_rate) = landing();
    assert!((gap_rate + 1.913_012_569_038_374_6).abs() < 1e-13);
    assert!((state.slip + 0.785_244_687_128_996_2).abs() < 1e-13);
    let plastic = hoop
        .impact(
            &state,
            gap_rate,
            restitution(0.0, RestitutionLaw::Energetic),
        )
        .expect("lands");
    assert_eq!(plastic.case, ImpactCase::Slides);
    assert!((plastic.after.theta_rate - 1.989_854_986_135_947_2).abs() < 1e-12);
    assert!((plastic.after.slip + 0.025_733_797_279_415_87).abs() < 1e-12);
    assert!(plastic.after.gap_rate.abs() < 1e-15);
    assert!((plastic.energy_lost() - 4.275_729_468_652_908).abs() < 1e-12);
    let half = hoop
        .impact(
            &state,
            gap_rate,
            restitution(0.5, RestitutionLaw::Energetic),
        )
        .expect("lands");
    assert_eq!(half.case, ImpactCase::SticksInRestitution);
    assert!((half.after.theta_rate - 1.803_947_379_026_181_2).abs() < 1e-12);
    assert_eq!(half.after.slip, 0.0);
    assert!((half.after.gap_rate - 0.978_517_419_970_790_8).abs() < 1e-12);
    assert!((half.energy_lost() - 3.362_443_419_227_28).abs() < 1e-12);
}

/// Impacts at velocities from the least number to the largest of a start, followed in the impulse
/// with 480 digits by `evidence/reference/bounces.py`.
#[test]
fn impacts_of_all_sizes_are_those_followed_with_480_digits() {
    let data: Value = serde_json::from_str(BOUNCES).expect("evidence/reference/bounces.json");
    let mut seen = 0;
    for record in data["impacts"].as_array().expect("a list") {
        let list = |key: &str| -> Vec<f64> {
            let items = record[key].as_array().expect("a list").iter();
            items
                .map(|it| {
                    it.as_f64().unwrap_or_else(|| {
                        it.as_str().expect("a number").parse().expect("a number")
                    })
                })
                .collect()
        };
        let (parameters, start, end) = (list("hoop"), list("start"), list("end"));
        let hoop = HoopParameters::thin(parameters[0])
            .with_offset(parameters[1])
            .with_inertia(parameters[2])
            .with_friction(parameters[3], parameters[4]);
        let hoop = Hoop::new(hoop).expect("a valid hoop");
        let law = record["law"]
            .as_str()
            .expect("a law")
            .parse()
            .expect("a law");
        let e = record["restitution"].as_f64().expect("a number");
        let state = State::from(Start::at(start[0], start[1]).with_slip(start[2]));
        let found = impact(&hoop, &state, start[3], e, law);
        // A dozen roundings of each term, and a digit of the least numbers.
        let (inertia, _) = heavy(&hoop);
        let answer = 4.0 * (1.0 + 1.0 / inertia);
        let push = (end[3] + end[4].abs()) * answer;
        let least = 4.0 * answer * f64::from_bits(1);
        let before = [start[1], start[2], start[3], 0.0, 0.0];
        for (at, ours) in numbers(&found).into_iter().enumerate() {
            // Quotients by slopes that are as small as 0.02.
            let digits = 50.0 * 16.0 * f64::EPSILON * (push + before[at].abs()) + least;
            assert!(
                (ours - end[at]).abs() <= digits,
                "{at}: {ours:e} {:e} {digits:e} {record}",
                end[at]
            );
        }
        assert_eq!(found.after.slip == 0.0, end[1] == 0.0, "{found:?} {record}");
        seen += 1;
    }
    assert_eq!(seen, 400);
}

/// Landings and jams with rolling resistance, followed with 34 digits from Newton's and Euler's
/// equations and the laws of the impulses by `evidence/reference/resistance`.
#[test]
fn impacts_with_rolling_resistance_are_those_of_34_digits() {
    let data: Value = serde_json::from_str(RESISTANCE).expect("evidence/reference/resistance.json");
    let number = |value: &Value| {
        value
            .as_f64()
            .unwrap_or_else(|| value.as_str().expect("a number").parse().expect("a number"))
    };
    let mut seen = [0; 4];
    for motion in data["motions"].as_array().expect("a list") {
        let Some(e) = motion["restitution"].as_f64() else {
            continue;
        };
        let of = |key: &str| number(&motion["hoop"][key]);
        let hoop = HoopParameters::thin(of("mass_ratio"))
            .with_offset(of("offset"))
            .with_inertia(of("inertia"))
            .with_friction(of("mu_s"), of("mu_k"))
            .with_rolling_resistance(of("rolling_resistance"));
        let hoop = Hoop::new(hoop).expect("a valid hoop");
        let law = motion["law"]
            .as_str()
            .expect("a law")
            .parse()
            .expect("a law");
        let mut lost_before = [0.0; 3];
        for event in motion["transitions"].as_array().expect("a list") {
            let lost =
                ["resistance", "sliding", "restitution"].map(|it| number(&event["lost"][it]));
            let before = core::mem::replace(&mut lost_before, lost);
            // Slow bounces are counted there, and not listed.
            let Some(after) = event.get("after").filter(|_| event["cause"] != "settle") else {
                continue;
            };
            let [theta, theta_rate, slip, gap_rate] =
                ["theta", "theta_rate", "slip", "gap_rate"].map(|it| number(&event[it]));
            let state = State::from(Start::at(theta, theta_rate).with_slip(slip));
            let found = if event["cause"] == "jam" {
                let hoop = hoop.with_restitution(restitution(e, law)).expect("heavy");
                hoop.jam(&state).expect("jams")
            } else {
                impact(&hoop, &state, gap_rate, e, law)
            };
            let size = 1.0 + theta_rate.abs() + found.impulse.normal;
            let digits = 2e-13 * size * size;
            for (name, ours) in [
                ("theta_rate", found.after.theta_rate),
                ("slip", found.after.slip),
                ("gap_rate", found.after.gap_rate),
            ] {
                let theirs = number(&after[name]);
                assert!(
                    (ours - theirs).abs() <= digits,
                    "{name}: {theirs}\n{found:?}\n{event}"
                );
                assert_eq!(
                    ours == 0.0,
                    theirs == 0.0,
                    "{name}: {theirs}\n{found:?}\n{event}"
                );
            }
            let losses = [
                -found.resistance_work,
                -found.friction_work,
                -found.normal_work,
            ];
            for (at, ours) in losses.into_iter().enumerate() {
                let theirs = lost[at] - before[at];
                assert!(
                    (ours - theirs).abs() <= digits,
                    "{at}: {theirs}\n{found:?}\n{event}"
                );
            }
            let segments = event["segments"].as_array().expect("a list").len();
            let bends = hoop.impact_course(theta, &found).len() - 1;
            assert_eq!(bends, segments, "{found:?}\n{event}");
            seen[segments - 1] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 1), "{seen:?}");
}

#[test]
fn a_jam_without_restitution_leaves_with_the_rate_of_the_reference() {
    // P = −0.1996 at the start: without a closing gap the slip is stopped all the same.
    let hoop =
        Hoop::new(HoopParameters::thin(0.125).with_friction(0.75, 0.75)).expect("a valid hoop");
    let state = State::from(Start::at(0.5, -0.5).with_slip(1.0));
    let jam = hoop
        .impact(&state, 0.0, restitution(0.0, RestitutionLaw::Energetic))
        .expect("heavy");
    assert_eq!(jam.case, ImpactCase::Jams);
    assert!((jam.after.theta_rate + 1.0).abs() < 1e-14, "{jam:?}");
    assert_eq!(jam.after.slip, 0.0);
    assert!(jam.after.gap_rate.abs() < 1e-15);
}

#[test]
fn what_is_no_impact_is_refused_or_said() {
    let (hoop, state, _) = landing();
    for value in [-0.1, 1.5, f64::NAN, f64::INFINITY] {
        let refused = Restitution::new(value, RestitutionLaw::Newton).expect_err("out of bounds");
        assert_eq!(refused.quantity(), Quantity::Restitution);
    }
    let e = restitution(0.5, RestitutionLaw::Poisson);
    assert_eq!(
        hoop.impact(&state, 0.25, e),
        Err(ImpactError::Opening { gap_rate: 0.25 })
    );
    let massless = Hoop::littlewood(0.5, 0.4).expect("a valid hoop");
    assert_eq!(massless.impact(&state, -1.0, e), Err(ImpactError::Massless));
    let still = hoop
        .impact(&State { slip: 0.0, ..state }, 0.0, e)
        .expect("heavy");
    assert_eq!((still.case, still.after), (ImpactCase::None, still.before));
}

/// Velocities of the body: those of the mass centre, and θ′.
#[derive(Clone, Copy, Debug)]
struct Velocities {
    x: f64,
    y: f64,
    spin: f64,
}

/// Newton's and Euler's equations in the impulse, in small steps. Friction opposes the slip and the
/// couple opposes the rotation. Where slip or rotation is zero, friction or couple takes the value
/// that keeps it zero, up to its limit.
struct Stepper {
    mass: f64,
    inertia: f64,
    arm: [f64; 2],
    mu: (f64, f64),
    chi: f64,
}

/// Friction and couple of a unit of the normal impulse.
#[derive(Clone, Copy, Debug)]
struct Answer {
    friction: f64,
    couple: f64,
    sticks: bool,
    holds: bool,
}

/// What an impact has done with the gap closing, and opening.
#[derive(Clone, Copy, Debug, Default)]
struct Given {
    impulse: f64,
    work: f64,
}

impl Stepper {
    fn new(hoop: &Hoop, theta: f64) -> Self {
        let (inertia, h) = heavy(hoop);
        let (sin, cos) = libm::sincos(theta);
        Self {
            mass: hoop.mass(),
            inertia,
            arm: [h * sin, -(1.0 + h * cos)],
            mu: (hoop.mu_s(), hoop.mu_k()),
            chi: hoop.rolling_resistance(),
        }
    }

    fn start(&self, rate: f64, slip: f64, closing: f64) -> Velocities {
        Velocities {
            x: slip + self.arm[1] * rate,
            y: -closing - self.arm[0] * rate,
            spin: rate,
        }
    }

    fn contact(&self, v: &Velocities) -> (f64, f64) {
        (v.x - v.spin * self.arm[1], v.y + v.spin * self.arm[0])
    }

    fn push(&self, v: &Velocities, answer: &Answer, normal: f64) -> Velocities {
        let (friction, couple) = (answer.friction * normal, answer.couple * normal);
        let moment = self.arm[0] * normal - self.arm[1] * friction + couple;
        Velocities {
            x: v.x + friction / self.mass,
            y: v.y + normal / self.mass,
            spin: v.spin + moment / self.inertia,
        }
    }

    /// Spin and slip of a unit of the normal impulse with this friction and couple.
    fn response(&self, friction: f64, couple: f64) -> (f64, f64) {
        let still = Velocities {
            x: 0.0,
            y: 0.0,
            spin: 0.0,
        };
        let answer = Answer {
            friction,
            couple,
            sticks: false,
            holds: false,
        };
        let pushed = self.push(&still, &answer, 1.0);
        (pushed.spin, self.contact(&pushed).0)
    }

    /// Without slip, with this couple.
    fn without_slip(&self, couple: f64) -> Answer {
        let (free, by_friction) = (
            self.response(0.0, couple).1,
            self.response(1.0, 0.0).1 - self.response(0.0, 0.0).1,
        );
        let needed = -free / by_friction;
        let sticks = needed.abs() <= self.mu.0;
        Answer {
            friction: if sticks {
                needed
            } else {
                -self.mu.1 * free.signum()
            },
            couple,
            sticks,
            holds: false,
        }
    }

    fn answer(&self, slip: f64, spin: f64) -> Answer {
        let sign = |value: f64| {
            if value == 0.0 { 0.0 } else { value.signum() }
        };
        let (friction, couple) = (-self.mu.1 * sign(slip), -self.chi * sign(spin));
        if spin == 0.0 {
            let free = self.response(friction, 0.0).0;
            let needed = -free * self.inertia;
            if needed.abs() <= self.chi {
                return Answer {
                    friction,
                    couple: needed,
                    sticks: slip == 0.0,
                    holds: true,
                };
            }
            let couple = -self.chi * free.signum();
            return if slip == 0.0 {
                self.without_slip(couple)
            } else {
                Answer {
                    friction,
                    couple,
                    sticks: false,
                    holds: false,
                }
            };
        }
        if slip == 0.0 {
            return self.without_slip(couple);
        }
        Answer {
            friction,
            couple,
            sticks: false,
            holds: false,
        }
    }

    /// To the end of the impact: velocities, impulses, and the works of the couple and of the
    /// normal impulse.
    fn run(&self, mut v: Velocities, e: f64, law: RestitutionLaw) -> (Velocities, [f64; 4]) {
        let (slip, gap) = self.contact(&v);
        let (closing, speed) = (-gap, slip.abs() + gap.abs() + v.spin.abs());
        let (mut friction, mut resisted) = (0.0, 0.0);
        let (mut taken, mut given, mut opens) = (Given::default(), Given::default(), false);
        let step = 2e-3 * speed.max(closing) * self.mass.min(self.inertia);
        for _ in 0..40_000_000 {
            let (slip, gap) = self.contact(&v);
            let answer = self.answer(slip, v.spin);
            let next = self.push(&v, &answer, step);
            let (slip_next, gap_next) = self.contact(&next);
            let until = |now: f64, next: f64| {
                if now * next < 0.0 {
                    now / (now - next)
                } else {
                    1.0
                }
            };
            let slips = if answer.sticks {
                1.0
            } else {
                until(slip, slip_next)
            };
            let turns = if answer.holds {
                1.0
            } else {
                until(v.spin, next.spin)
            };
            let slope = (gap_next - gap) / step;
            let closes = if opens == (slope < 0.0) && gap != 0.0 {
                until(gap, gap_next)
            } else {
                1.0
            };
            let mut part = slips.min(turns).min(closes);
            let mut last = false;
            if opens {
                let rest = match law {
                    RestitutionLaw::Poisson => e * taken.impulse - given.impulse,
                    RestitutionLaw::Newton => (e * closing - gap) / slope,
                    RestitutionLaw::Energetic => {
                        let left: f64 = e * e * -taken.work - given.work;
                        ((gap * gap + 2.0 * slope * left).sqrt() - gap) / slope
                    }
                };
                let newton_falls = law == RestitutionLaw::Newton && slope < 0.0;
                if !newton_falls && rest <= part * step {
                    (part, last) = ((rest / step).max(0.0), true);
                }
            }
            let p = part * step;
            let spin = v.spin;
            v = self.push(&v, &answer, p);
            friction += answer.friction * p;
            resisted += answer.couple * p * 0.5 * (spin + v.spin);
            let work = p * (gap + 0.5 * slope * p);
            let phase = if opens { &mut given } else { &mut taken };
            phase.impulse += p;
            phase.work += work;
            // What is zero here is so but for rounding.
            if turns < 1.0 && turns <= part && !last || answer.holds {
                let slip = self.contact(&v).0;
                v.y += v.spin * self.arm[0];
                v.spin = 0.0;
                v.x = slip;
            }
            if slips < 1.0 && slips <= part && !last || answer.sticks {
                v.x -= self.contact(&v).0;
            }
            if closes <= part && part < 1.0 && !last {
                v.y -= self.contact(&v).1;
                opens = !opens;
            }
            if !opens && slope > 0.0 {
                // Of a slow impact of a hoop that turns fast the sum for the gap rate may not come
                // any closer to zero.
                let rounding = 4.0 * f64::EPSILON * (v.y.abs() + v.spin.abs());
                opens = self.contact(&v).1 >= -rounding.max(1e-15 * closing);
            }
            if last || opens && e == 0.0 {
                let normal = taken.impulse + given.impulse;
                return (v, [normal, friction, resisted, taken.work + given.work]);
            }
        }
        panic!("the impact does not end");
    }
}

fn heavy(hoop: &Hoop) -> (f64, f64) {
    let Body::Heavy(body) = hoop.body() else {
        panic!("heavy")
    };
    (body.inertia, body.h)
}

fn laws() -> impl Strategy<Value = RestitutionLaw> {
    prop::sample::select(RestitutionLaw::ALL.to_vec())
}

fn chi() -> impl Strategy<Value = f64> {
    prop_oneof![1 => Just(0.0), 2 => 0.0..1.0_f64, 2 => 0.0..4.0_f64]
}

fn coefficients() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), Just(1.0), 0.0..1.0_f64]
}

/// (1/2) m v² + (1/2) Î θ′² from contact velocities.
fn kinetic(hoop: &Hoop, theta: f64, v: &littlewood::impact::ContactVelocities) -> f64 {
    let (inertia, h) = heavy(hoop);
    let (sin, cos) = libm::sincos(theta);
    let x = v.slip - (1.0 + h * cos) * v.theta_rate;
    let y = v.gap_rate - h * sin * v.theta_rate;
    0.5 * (hoop.mass() * (x * x + y * y) + inertia * v.theta_rate * v.theta_rate)
}

fn impact(hoop: &Hoop, state: &State, gap_rate: f64, e: f64, law: RestitutionLaw) -> Impact {
    hoop.impact(state, gap_rate, restitution(e, law))
        .expect("a heavy hoop that lands")
}

/// In units of a power of two, from next to the least number to next to the largest.
#[test]
fn an_impact_is_the_same_in_all_units_of_velocity() {
    for case in 0..20_000 {
        let mut draw = Draw::of_case(51, 2, case);
        let (hoop, start) = draw.heavy_motion();
        let hoop = if draw.comes(0.6) {
            draw.resisted(&hoop)
        } else {
            hoop
        };
        let mut velocity = |powers| {
            let size = draw.of_any_size(powers);
            if draw.comes(0.5) { -size } else { size }
        };
        let [rate, slip] = [[-3.0, 3.0]; 2].map(&mut velocity);
        let closing = if draw.comes(0.1) {
            0.0
        } else {
            draw.of_any_size([-3.0, 3.0])
        };
        let (e, law) = (draw.share(), draw.one_of(RestitutionLaw::ALL.as_slice()));
        let of_units = |unit: f64| {
            let start = Start::at(start.theta, rate * unit).with_slip(slip * unit);
            hoop.impact(&State::from(start), -closing * unit, restitution(e, law))
        };
        let Ok(of_1) = of_units(1.0) else {
            continue;
        };
        for exponent in [-980, -800, -600, -350, -301, 301, 500, 800] {
            let unit = libm::scalbn(1.0, exponent);
            let found = of_units(unit).expect("decided");
            assert_eq!(found.case, of_1.case);
            for (ours, theirs) in [
                (found.after.theta_rate, of_1.after.theta_rate),
                (found.after.slip, of_1.after.slip),
                (found.after.gap_rate, of_1.after.gap_rate),
                (found.impulse.normal, of_1.impulse.normal),
                (found.impulse.friction, of_1.impulse.friction),
            ] {
                let expected = theirs * unit;
                // Coefficients of friction as small as numbers are underflow at 1, too.
                let is_rounded = theirs.abs() < 1e-290 || !expected.is_normal();
                assert!(
                    is_rounded || ours == expected,
                    "{ours:e} {expected:e} {found:?}"
                );
            }
        }
    }
}

/// The velocities and impulses of an impact.
fn numbers(impact: &Impact) -> [f64; 5] {
    let after = impact.after;
    let impulse = impact.impulse;
    [
        after.theta_rate,
        after.slip,
        after.gap_rate,
        impulse.normal,
        impulse.friction,
    ]
}

/// A hoop on which rounding errors are small, and an angle.
fn moderate(draw: &mut Draw) -> (HoopParameters, f64) {
    let hoop = HoopParameters::thin(draw.between([0.2, 3.0]))
        .with_offset(draw.between([0.2, 1.0]))
        .with_inertia(draw.between([0.2, 3.0]));
    (hoop, draw.between([-3.0, 3.0]))
}

/// The same hoop with rolling resistance.
fn resisted(hoop: &Hoop, chi: f64) -> Hoop {
    Hoop::new(hoop.parameters().with_rolling_resistance(chi)).expect("a valid hoop")
}

fn rough(hoop: HoopParameters, mu_s: f64, mu_k: f64) -> Hoop {
    Hoop::new(hoop.with_friction(mu_s, mu_k)).expect("a valid hoop")
}

/// Asserts that an impact depends on a number continuously where a comparison changes its side.
#[track_caller]
fn is_continuous(at: f64, impact: impl Fn(f64) -> Impact) {
    let [below, exactly, above] = [at * (1.0 - 1e-11), at, at * (1.0 + 1e-11)].map(impact);
    for other in [&below, &above] {
        for (a, b) in numbers(&exactly).into_iter().zip(numbers(other)) {
            // Quotients by k1 and by the deceleration of the slip, which may be small, and their
            // squares.
            let size = 1.0
                + a.abs()
                + exactly.impulse.normal
                + exactly.impulse.normal * exactly.impulse.normal;
            assert!(
                (a - b).abs() < 1e-6 * size,
                "{a} {b}\n{exactly:?}\n{other:?}"
            );
        }
    }
    assert!(
        [below.case, above.case].contains(&exactly.case) && below.case != above.case,
        "{:?} {:?} {:?}",
        below.case,
        exactly.case,
        above.case
    );
}

/// Comparisons of an impact that need no tie: to both sides it is the same.
#[test]
fn an_impact_is_continuous_where_its_case_changes() {
    let mut seen = [0; 3];
    for number in 0..3_000 {
        let mut draw = Draw::of_case(51, 3, number);
        let (parameters, theta) = moderate(&mut draw);
        let (closing, rate) = (draw.between([0.1, 2.0]), draw.between([-2.0, 2.0]));
        let (e, law) = (
            draw.between([0.1, 0.95]),
            draw.one_of(RestitutionLaw::ALL.as_slice()),
        );
        let to = |hoop: &Hoop, slip: f64| {
            let state = State::from(Start::at(theta, rate).with_slip(slip));
            impact(hoop, &state, -closing, e, law)
        };
        let mu = draw.between([0.1, 1.5]);
        let hoop = rough(parameters, mu, mu);
        let compliance = hoop.compliance(theta).expect("heavy");
        let (a, b, c) = (compliance.a, compliance.b, compliance.c);
        for sign in [-1.0, 1.0] {
            let (k1, slowing) = (c - mu * sign * b, mu * a - sign * b);
            if k1 > 0.1 && slowing > 0.1 && (mu * a - b.abs()).abs() > 0.1 {
                // Slip ends with the greatest compression, and with the impact.
                let ends = sign * closing * slowing / k1;
                is_continuous(ends, |slip| to(&hoop, slip));
                is_continuous((1.0 + e) * ends, |slip| to(&hoop, slip));
                let at_end = to(&hoop, (1.0 + e) * ends);
                assert!(
                    at_end.case != ImpactCase::Slides || at_end.after.slip * sign >= 0.0,
                    "{at_end:?}"
                );
                seen[0] += 1;
            }
        }
        // P = 0 with a closing gap: μk |B| = C.
        let mu = c / b.abs();
        if mu < 50.0 && mu * a - b.abs() > 0.1 {
            let slip = draw.between([0.1, 2.0]) * b.signum();
            is_continuous(mu, |mu| to(&rough(parameters, mu, mu), slip));
            seen[1] += 1;
        }
        // No slip, where static friction holds with μk, too, or does not hold.
        if (mu * a - b.abs()).abs() > 0.1 {
            let [left, none, right] = [-1e-12, 0.0, 1e-12].map(|slip| numbers(&to(&hoop, slip)));
            for at in 0..5 {
                assert!((none[at] - left[at]).abs() < 1e-9 && (none[at] - right[at]).abs() < 1e-9);
            }
            seen[2] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 300), "{seen:?}");
}

/// Nor where the slip towards sign B does not slow down, μk A = |B|.
#[test]
fn an_impact_is_continuous_where_the_slip_does_not_slow_down() {
    let mut seen = 0;
    for number in 0..1_000 {
        let mut draw = Draw::of_case(51, 7, number);
        let (parameters, theta) = moderate(&mut draw);
        let (e, law) = (draw.share(), draw.one_of(RestitutionLaw::ALL.as_slice()));
        let compliance = rough(parameters, 0.0, 0.0)
            .compliance(theta)
            .expect("heavy");
        let (a, b, c) = (compliance.a, compliance.b, compliance.c);
        let mu = b.abs() / a;
        if mu < 0.05 || c - mu * b.abs() < 0.1 {
            continue;
        }
        for slip in [1e-9, 0.5] {
            let state = State::from(Start::at(theta, 1.0).with_slip(slip * b.signum()));
            let [less, more] = [1.0 - 1e-12, 1.0 + 1e-12].map(|part| {
                impact(
                    &rough(parameters, mu * part, mu * part),
                    &state,
                    -1.0,
                    e,
                    law,
                )
            });
            for (a, b) in numbers(&less).into_iter().zip(numbers(&more)) {
                assert!((a - b).abs() < 1e-8, "{less:?} {more:?}");
            }
        }
        seen += 1;
    }
    assert!(seen > 300, "{seen}");
}

/// |B| = μs A: with μk = μs stick and slip are the same impact. Otherwise they differ, and the tie
/// is said; no angle but 0 that is a double has exactly this friction.
#[test]
fn at_the_limit_of_static_friction_an_impact_is_continuous_or_undecided() {
    let (mut equal, mut weaker) = (0, 0);
    for number in 0..2_000 {
        let mut draw = Draw::of_case(51, 4, number);
        let (parameters, theta) = moderate(&mut draw);
        let compliance = rough(parameters, 0.0, 0.0)
            .compliance(theta)
            .expect("heavy");
        let mu = compliance.b.abs() / compliance.a;
        if mu < 0.02 {
            continue;
        }
        // Slip away from sign B ends in compression.
        let slip = -1e-3 * compliance.b.signum();
        let state = State::from(Start::at(theta, 0.5).with_slip(slip));
        let e = restitution(draw.share(), draw.one_of(RestitutionLaw::ALL.as_slice()));
        let with = |mu_s: f64, mu_k: f64| rough(parameters, mu_s, mu_k).impact(&state, -1.0, e);
        let parts = [1.0 - 1e-12, 1.0, 1.0 + 1e-12];
        let of_equal = parts.map(|part| with(mu * part, mu * part).expect("continuous"));
        for other in &of_equal {
            for (a, b) in numbers(other).into_iter().zip(numbers(&of_equal[1])) {
                assert!((a - b).abs() < 1e-10, "{of_equal:?}");
            }
        }
        assert_eq!(
            [of_equal[0].case, of_equal[2].case],
            [
                ImpactCase::ReversesInCompression,
                ImpactCase::SticksInCompression
            ]
        );
        equal += 1;
        let mu_k = 0.5 * mu;
        let [slips, tie, sticks] = parts.map(|part| with(mu * part, mu_k));
        assert_eq!(tie, Err(ImpactError::Undecided { theta }));
        let (slips, sticks) = (slips.expect("slips"), sticks.expect("sticks"));
        assert_eq!(
            [slips.case, sticks.case],
            [
                ImpactCase::ReversesInCompression,
                ImpactCase::SticksInCompression
            ]
        );
        assert!((slips.impulse.friction - sticks.impulse.friction).abs() > 1e-3 * mu);
        // A motion that lands there ends.
        let hoop = rough(parameters, mu, mu_k)
            .with_restitution(e)
            .expect("heavy");
        let start = Start::at(theta, 0.0).with_slip(slip).with_gap_rate(1.0);
        let motion = hoop
            .simulate(start, Limits::default())
            .expect("a valid start");
        assert_eq!(motion.outcome().kind(), OutcomeKind::Unresolved);
        assert_eq!(motion.outcome().state().theta, theta);
        weaker += 1;
    }
    assert!(equal > 1000 && weaker > 1000, "{equal} {weaker}");
}

/// P = 0: without a closing gap nothing happens where P > 0, and a jam where P < 0.
#[test]
fn at_p_0_without_a_closing_gap_an_impact_is_undecided() {
    let mut ties = 0;
    for number in 0..2_000 {
        let mut draw = Draw::of_case(51, 5, number);
        let (parameters, theta) = moderate(&mut draw);
        let compliance = rough(parameters, 0.0, 0.0)
            .compliance(theta)
            .expect("heavy");
        let mu = compliance.c / compliance.b.abs();
        if mu > 100.0 {
            continue;
        }
        let state = State::from(Start::at(theta, 0.5).with_slip(compliance.b.signum()));
        let e = restitution(draw.share(), draw.one_of(RestitutionLaw::ALL.as_slice()));
        let with = |mu: f64, closing: f64| rough(parameters, mu, mu).impact(&state, -closing, e);
        assert_eq!(with(mu, 0.0), Err(ImpactError::Undecided { theta }));
        assert_eq!(
            with(mu * (1.0 - 1e-12), 0.0).expect("none").case,
            ImpactCase::None
        );
        assert_eq!(
            with(mu * (1.0 + 1e-12), 0.0).expect("jams").case,
            ImpactCase::Jams
        );
        assert!(with(mu, 1e-9).is_ok());
        ties += 1;
    }
    assert!(ties > 200, "{ties}");
}

/// With a resistance that is nothing the impact is that without, which is computed in another way.
#[test]
fn a_vanishing_resistance_changes_nothing() {
    for number in 0..20_000 {
        let mut draw = Draw::of_case(51, 8, number);
        let (parameters, theta) = moderate(&mut draw);
        let mu_s = draw.between([0.0, 2.0]);
        let hoop = rough(parameters, mu_s, mu_s * draw.share());
        let (rate, slip) = (draw.between([-2.0, 2.0]), draw.between([-2.0, 2.0]));
        let state = State::from(Start::at(theta, rate).with_slip(slip));
        let (e, law) = (draw.share(), draw.one_of(RestitutionLaw::ALL.as_slice()));
        let [without, with] =
            [0.0, 1e-300].map(|chi| impact(&resisted(&hoop, chi), &state, -1.0, e, law));
        assert_eq!(without.case, with.case);
        let stops = |it: &Impact| hoop.impact_course(theta, it).len();
        assert_eq!(stops(&without), stops(&with));
        for (a, b) in numbers(&without).into_iter().zip(numbers(&with)) {
            let size = 1.0 + without.impulse.normal;
            assert!(
                (a - b).abs() < 1e-13 * size * size,
                "{a} {b}\n{without:?}\n{with:?}"
            );
        }
    }
}

/// Where both sides of a tie differ: without slip at the limit of static friction, at D_χ = 0 and P
/// = 0 without a closing gap, and where slip and rotation end together.
#[test]
fn ties_of_impacts_with_rolling_resistance_are_said() {
    let mut seen = [0; 4];
    for number in 0..20_000 {
        let mut draw = Draw::of_case(51, 9, number);
        let (parameters, theta) = moderate(&mut draw);
        let free = rough(parameters, 0.0, 0.0);
        let ((inertia, h), mass) = (heavy(&free), free.mass());
        let (sin, cos) = libm::sincos(theta);
        let (arm, lever) = (h * sin, 1.0 + h * cos);
        let about = inertia + mass * lever * lever;
        let e = restitution(draw.share(), draw.one_of(RestitutionLaw::ALL.as_slice()));
        let of = |mu: [f64; 2], chi: f64, [rate, slip, closing]: [f64; 3]| {
            let hoop = resisted(&rough(parameters, mu[0], mu[1]), chi);
            let state = State::from(Start::at(theta, rate).with_slip(slip));
            hoop.impact(&state, -closing, e)
        };
        let undecided = Err(ImpactError::Undecided { theta });
        let (chi, sign) = (draw.between([0.0, 0.3]), draw.one_of(&[-1.0, 1.0]));
        let needed = mass * lever * (arm - sign * chi) / about;
        let mu = needed.abs();
        if mu > 0.02 {
            let tie = |part: f64| of([mu * part, 0.5 * mu], chi, [sign, 0.0, 1.0]);
            assert_eq!(tie(1.0), undecided);
            let (slips, sticks) = (tie(1.0 - 1e-12).expect("slips"), tie(1.0 + 1e-12));
            assert!(slips.after.slip.abs() > 1e-6 && sticks.expect("sticks").after.slip == 0.0);
            seen[0] += 1;
        }
        let dead = arm.abs() + about / (mass * arm.abs());
        if dead < 100.0 {
            let tie = |part: f64| of([9e8; 2], dead * part, [arm.signum(), 0.0, 0.0]);
            assert_eq!(tie(1.0), undecided);
            assert_eq!(tie(1.0 - 1e-12).expect("none").case, ImpactCase::None);
            let stops = tie(1.0 + 1e-12).expect("jams");
            assert_eq!(
                (stops.case, stops.after.theta_rate),
                (ImpactCase::Jams, 0.0)
            );
            seen[1] += 1;
        }
        let mu = 0.1;
        let painleve = arm.abs() - mu * lever + inertia / (mass * arm.abs());
        if painleve > 0.0 && painleve < 100.0 {
            let turn = arm.signum();
            let tie = |part: f64| of([mu; 2], painleve * part, [turn, turn, 0.0]);
            assert_eq!(tie(1.0), undecided);
            assert_eq!(tie(1.0 - 1e-12).expect("none").case, ImpactCase::None);
            assert_eq!(tie(1.0 + 1e-12).expect("jams").case, ImpactCase::Jams);
            seen[2] += 1;
        }
        // At rest it would roll, by static friction, or slip, by the kinetic one.
        let chi = 0.3 * arm.abs();
        let mu = mass * lever * arm.abs() / about;
        let (spin, mu_k) = ((1.3 * arm.abs() + 0.2 * mu * lever) / inertia, 0.2 * mu);
        let slip = (mu_k / mass + lever * spin) / spin;
        if mu > 0.02 {
            let way = -arm.signum();
            let tie = |part: f64| of([mu, mu_k], chi, [way, way * slip * part, 100.0]);
            assert_eq!(tie(1.0), undecided);
            let (rolls, slips) = (tie(1.0 - 1e-9), tie(1.0 + 1e-9));
            let [rolls, slips] = [rolls, slips].map(|it| it.expect("decided").after.slip);
            assert!(
                (rolls - slips).abs() > 1e-6 && rolls * slips == 0.0,
                "{rolls} {slips}"
            );
            seen[3] += 1;
        }
    }
    assert!(seen.iter().all(|count| *count > 1000), "{seen:?}");
}

/// A light hoop that begins to stick while it springs back, where pressing closes the gap: with
/// little restitution the impact ends before, with more the hoop stops dead.
#[test]
fn an_impact_whose_gap_closes_again_is_that_of_small_steps() {
    let mut seen = [0; 3];
    for number in 0..120_000 {
        let mut draw = Draw::of_case(51, 10, number);
        let light = HoopParameters::thin(draw.between([0.02, 0.2]));
        let chi = draw.between([1.0, 5.0]);
        let hoop = resisted(&rough(light, 9.0, draw.between([0.3, 2.0])), chi);
        let theta = draw.between([2.0, 3.1]);
        let (rate, slip) = (draw.between([0.5, 2.0]), -draw.of_any_size([-2.0, 1.0]));
        let law = draw.one_of(RestitutionLaw::ALL.as_slice());
        let state = State::from(Start::at(theta, rate).with_slip(slip));
        let of = |e: f64| hoop.impact(&state, -1.0, restitution(e, law));
        let (Ok(low), Ok(high)) = (of(0.01), of(1.0)) else {
            continue;
        };
        let stops = |it: &Impact| it.after.theta_rate == 0.0;
        if stops(&low) || !stops(&high) {
            continue;
        }
        let stepper = Stepper::new(&hoop, theta);
        for e in [0.01, 1.0, draw.share()] {
            let ours = of(e).expect("decided");
            let (stepped, [normal, ..]) = stepper.run(stepper.start(rate, slip, 1.0), e, law);
            let size = 1.0 + slip.abs() + ours.impulse.normal / stepper.inertia;
            let (a, b) = (
                numbers(&ours),
                [stepped.spin, stepper.contact(&stepped).1, normal],
            );
            for (a, b) in [a[0], a[2], a[3]].into_iter().zip(b) {
                assert!(
                    (a - b).abs() < 1e-9 * size * size,
                    "{a} {b} {law} {e}\n{ours:?}"
                );
            }
        }
        // The coefficient between both: neighbours differ.
        let (mut low, mut high, mut is_said) = (0.01, 1.0, false);
        while !is_said && f64::next_up(low) < high {
            let middle = 0.5 * (low + high);
            match of(middle) {
                Ok(found) if stops(&found) => high = middle,
                Ok(_) => low = middle,
                Err(_) => is_said = true,
            }
        }
        if !is_said {
            // The rotation ends just with the impact.
            let [low, high] = [low, high].map(|e| of(e).expect("decided"));
            assert!(
                (low.impulse.normal - high.impulse.normal).abs() < 1e-12,
                "{low:?}\n{high:?}"
            );
            continue;
        }
        seen[usize::from(law.code())] += 1;
    }
    assert!(seen.iter().all(|count| *count > 3), "{seen:?}");
}

/// Asserts the laws of contact, of friction and of restitution of an impact.
fn check_laws(hoop: &Hoop, found: &Impact, e: f64, law: RestitutionLaw) {
    let (slip, closing) = (found.before.slip, -found.before.gap_rate);
    let what = format!("{hoop:?} {law:?} {e}\n{found:?}");
    let Impact {
        before,
        after,
        impulse,
        ..
    } = *found;
    assert!(
        numbers(found).iter().all(|number| number.is_finite()),
        "{what}"
    );
    assert!(impulse.normal >= 0.0 && after.gap_rate >= 0.0, "{what}");
    let least = f64::from_bits(1);
    let most = hoop.mu_s() * (impulse.normal * (1.0 + 8.0 * f64::EPSILON) + least) + least;
    assert!(impulse.friction.abs() <= most, "{what}");
    assert!(
        found.friction_work <= 0.0 && found.resistance_work <= 0.0,
        "{what}"
    );
    let turns = before.theta_rate * after.theta_rate > 0.0;
    let is_resisted = hoop.rolling_resistance() > 0.0 && !turns;
    match found.case {
        ImpactCase::None => {
            assert!(closing == 0.0 && before == after, "{what}");
        }
        ImpactCase::Slides => {
            assert!(after.slip * slip.signum() >= 0.0, "{what}");
            assert!(
                is_resisted || (after.gap_rate - e * closing).abs() <= least,
                "{what}"
            );
        }
        ImpactCase::SticksInCompression | ImpactCase::SticksInRestitution => {
            assert!(after.slip == 0.0, "{what}");
        }
        ImpactCase::Jams => {
            let resists = hoop.rolling_resistance() > 0.0;
            assert!(resists || after.slip == 0.0, "{what}");
        }
        ImpactCase::ReversesInCompression | ImpactCase::ReversesInRestitution => {
            assert!(after.slip * slip.signum() <= 0.0 || slip == 0.0, "{what}");
        }
    }
    if law == RestitutionLaw::Newton {
        assert!((after.gap_rate - e * closing).abs() <= least, "{what}");
    }
    // Without a kink all laws are the same.
    if law != RestitutionLaw::Newton || found.case == ImpactCase::Slides && !is_resisted {
        assert!(!found.gains_energy(), "{what}");
    }
}

/// Hoops of the whole range and velocities from the least number to the largest of a start.
#[test]
fn impacts_of_all_sizes_keep_their_laws() {
    let (mut cases, mut segments) = ([0_usize; ImpactCase::ALL.len()], [0_usize; 9]);
    for number in 0..200_000 {
        let mut draw = Draw::of_case(51, 6, number);
        let (hoop, start) = draw.heavy_motion();
        let hoop = if draw.comes(0.6) {
            draw.resisted(&hoop)
        } else {
            hoop
        };
        let mut velocity = || {
            let size = draw.of_any_size([-323.3, 6.0]).clamp(5e-324, 1e6);
            if draw.comes(0.5) { -size } else { size }
        };
        let [rate, mut slip, mut gap_rate] = [(); 3].map(|()| velocity());
        match draw.below(8) {
            0 => slip = 0.0,
            1 => gap_rate = 0.0,
            // As large as each other, but for the compliances.
            2..=5 => slip = gap_rate * draw.of_any_size([-3.0, 3.0]) * draw.one_of(&[-1.0, 1.0]),
            _ => {}
        }
        let closing = gap_rate.abs();
        let (e, law) = (draw.share(), draw.one_of(RestitutionLaw::ALL.as_slice()));
        let e = draw.one_of(&[0.0, 1.0, e, e]);
        let state = State::from(Start::at(start.theta, rate).with_slip(slip));
        let found = match hoop.impact(&state, -closing, restitution(e, law)) {
            Ok(found) => found,
            Err(error) => {
                assert!(matches!(error, ImpactError::Undecided { .. }), "{error}");
                continue;
            }
        };
        cases[usize::from(found.case.code())] += 1;
        check_laws(&hoop, &found, e, law);
        segments[hoop.impact_course(start.theta, &found).len() - 2] += 1;
    }
    assert!(cases.iter().all(|count| *count > 100), "{cases:?}");
    // An impact has at most four segments.
    assert!(
        segments[..4].iter().all(|count| *count > 10) && segments[4] == 0,
        "{segments:?}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    #[test]
    fn stepping_in_the_impulse_finds_the_same_impact(
        (m1, offset, inertia) in (0.1..4.0_f64, 0.05..1.0_f64, 0.05..3.0_f64),
        (mu_s, part) in (0.0..1.5_f64, 0.0..=1.0_f64),
        chi in chi(),
        theta in -3.2..3.2_f64, rate in prop_oneof![3 => -3.0..3.0_f64, 1 => Just(0.0)],
        slip in prop_oneof![3 => -2.0..2.0_f64, 1 => Just(0.0)],
        closing in 0.05..3.0_f64, e in coefficients(), law in laws(),
    ) {
        let hoop =
            Hoop::new(HoopParameters::thin(m1).with_offset(offset).with_inertia(inertia).with_friction(mu_s, part * mu_s).with_rolling_resistance(chi)).expect("heavy");
        let (about_centre, _) = heavy(&hoop);
        let stepper = Stepper::new(&hoop, theta);
        let start = stepper.start(rate, slip, closing);
        let state = State::from(Start::at(theta, rate).with_slip(slip));
        let ours = impact(&hoop, &state, -closing, e, law);
        let (stepped, [normal, friction, resisted, worked]) = stepper.run(start, e, law);
        let (slip_after, gap_after) = stepper.contact(&stepped);
        let size = 1.0 + rate.abs() + slip.abs() + closing + ours.impulse.normal * (1.0 + 1.0 / about_centre);
        for (name, a, b) in [
            ("θ′", ours.after.theta_rate, stepped.spin),
            ("slip", ours.after.slip, slip_after),
            ("gap rate", ours.after.gap_rate, gap_after),
            ("P", ours.impulse.normal, normal),
            ("J", ours.impulse.friction, friction),
            ("∫ θ′ dM", ours.resistance_work, resisted),
            ("∫ w dP", ours.normal_work, worked),
        ] {
            prop_assert!((a - b).abs() < 1e-9 * size * size, "{name}: {a} {b}\n{ours:?}");
        }
    }

    #[test]
    fn momentum_and_energy_are_balanced_and_friction_keeps_its_limits(
        hoop in heavy_hoop(), chi in chi(), theta in -7.0..7.0_f64,
        rate in prop_oneof![4 => -4.0..4.0_f64, 1 => Just(0.0)],
        slip in prop_oneof![3 => -2.0..2.0_f64, 1 => Just(0.0), 1 => -1e-9..1e-9_f64],
        closing in prop_oneof![4 => 0.0..3.0_f64, 1 => Just(0.0), 1 => 0.0..1e-9_f64],
        e in coefficients(), law in laws(),
    ) {
        let hoop = resisted(&hoop, chi);
        let state = State::from(Start::at(theta, rate).with_slip(slip));
        let found = impact(&hoop, &state, -closing, e, law);
        let before = kinetic(&hoop, theta, &found.before);
        let after = kinetic(&hoop, theta, &found.after);
        let (inertia, h) = heavy(&hoop);
        let scale = 1.0 + before + after + (h + 1.0) * found.impulse.normal * found.impulse.normal / inertia;
        prop_assert!((before - after - found.energy_lost()).abs() < 1e-12 * scale, "{found:?}");
        prop_assert!(found.friction_work <= 1e-15 * scale, "{found:?}");
        prop_assert!(found.resistance_work <= 0.0, "{found:?}");
        prop_assert!(found.impulse.normal >= 0.0 && found.after.gap_rate >= -1e-12 * scale, "{found:?}");
        prop_assert!(found.impulse.friction.abs() <= hoop.mu_s() * found.impulse.normal * (1.0 + 1e-14));
        if law != RestitutionLaw::Newton {
            prop_assert!(found.energy_lost() >= -1e-13 * scale, "gains energy: {found:?}");
        }
        if law == RestitutionLaw::Energetic && e == 1.0 {
            prop_assert!(found.normal_work.abs() < 1e-12 * scale, "gives back all: {found:?}");
        }
        if law == RestitutionLaw::Newton {
            prop_assert!((found.after.gap_rate - e * closing).abs() < 1e-12 * scale, "{found:?}");
        }
    }

    #[test]
    fn the_mirror_image_of_an_impact_is_that_of_the_mirror_image(
        hoop in heavy_hoop(), chi in chi(), theta in -7.0..7.0_f64, rate in -4.0..4.0_f64, slip in -2.0..2.0_f64,
        closing in 0.0..3.0_f64, e in coefficients(), law in laws(),
    ) {
        let hoop = resisted(&hoop, chi);
        let ours = impact(&hoop, &State::from(Start::at(theta, rate).with_slip(slip)), -closing, e, law);
        let theirs = impact(&hoop, &State::from(Start::at(-theta, -rate).with_slip(-slip)), -closing, e, law);
        prop_assert_eq!(ours.case, theirs.case);
        prop_assert_eq!(ours.impulse.normal.to_bits(), theirs.impulse.normal.to_bits());
        prop_assert_eq!(ours.after.gap_rate.to_bits(), theirs.after.gap_rate.to_bits());
        prop_assert_eq!(ours.after.theta_rate, -theirs.after.theta_rate);
        prop_assert_eq!(ours.after.slip, -theirs.after.slip);
        prop_assert_eq!(ours.impulse.friction, -theirs.impulse.friction);
    }
}
