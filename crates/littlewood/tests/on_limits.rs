//! Starts on a limit, where rounding tells the side: the change of its number decides on the mode, by
//! Newton's and Euler's equations.

use std::f64::consts::TAU;

use crate::common::dd::Dd;
use crate::common::newton::{agrees, balances, modes, said, solve};
use crate::common::{engines, none_differ};
use littlewood::modes::{Margin, Undecided};
use littlewood::theory::Body;
use littlewood::{
    Cause, Hoop, HoopParameters, Limits, Mode, Outcome, OutcomeKind, SlipDirection, Start, State,
};
use littlewood_random::Draw;

/// How a contact moves: it rolls, or slides with a coefficient of kinetic friction.
#[derive(Clone, Copy, Debug)]
enum Contact {
    Rolls,
    Slides(SlipDirection, f64),
}

impl Contact {
    /// θ″, η″ and |F| − μs N at a state.
    fn forced(self, hoop: &Hoop, [theta, rate, _]: [f64; 3]) -> [f64; 3] {
        let of = balances(hoop, &Start::at(theta, rate));
        let mu_s = hoop.mu_s();
        match self {
            Self::Rolls => {
                let [spin, normal, friction] = of.rolling();
                [spin, 0.0, friction.abs() - mu_s * normal]
            }
            Self::Slides(direction, mu_k) => {
                let f = Dd::from(-mu_k * direction.sign());
                let pressed = std::array::from_fn(|row| of.normal[row] + f * of.friction[row]);
                let [spin, slip, normal] = solve([of.spin, of.slip, pressed], of.right);
                [spin, slip, (mu_k - mu_s) * normal]
            }
        }
    }

    /// The state after a time, in steps of Runge and Kutta.
    fn after(self, hoop: &Hoop, start: &Start, (time, steps): (f64, u32)) -> [f64; 3] {
        let step = time / f64::from(steps);
        let change = |now: [f64; 3]| {
            let [spin, slip, _] = self.forced(hoop, now);
            [now[1], spin, slip]
        };
        let plus = |a: [f64; 3], b: [f64; 3], by: f64| std::array::from_fn(|i| a[i] + by * b[i]);
        let mut now = [start.theta, start.theta_rate, 0.0];
        for _ in 0..steps {
            let k1 = change(now);
            let k2 = change(plus(now, k1, 0.5 * step));
            let k3 = change(plus(now, k2, 0.5 * step));
            let k4 = change(plus(now, k3, step));
            for (k, weight) in [(k1, 1.0), (k2, 2.0), (k3, 2.0), (k4, 1.0)] {
                now = plus(now, k, weight * step / 6.0);
            }
        }
        now
    }
}

/// A start on the limit of static friction, with equal coefficients or a smaller one of slip.
fn start_on_limit(draw: &mut Draw) -> Option<(Hoop, Start)> {
    let (hoop, start) = draw.in_contact();
    let (is_equal, part) = (draw.comes(0.5), draw.share());
    let start = Start::at(start.theta, start.theta_rate);
    let Body::Heavy(body) = hoop.body() else {
        return None;
    };
    let [_, normal, friction] = balances(&hoop, &start).rolling();
    let mu_s = friction.abs() / normal;
    let presses = libm::cos(hoop.slope())
        - body.h * libm::cos(start.theta) * start.theta_rate * start.theta_rate;
    if !(normal > 0.01 && presses > 0.01 && mu_s > 1e-3 && mu_s < 2.0) {
        return None;
    }
    let mu_k = if is_equal { mu_s } else { part * mu_s };
    let parameters = hoop.parameters().with_friction(mu_s, mu_k);
    Some((Hoop::new(parameters).ok()?, start))
}

/// On |F| = μs N, where rounding tells on which side a start lies, the change of |F| − μs N in
/// rolling decides: the contact rolls or slides as Newton and Euler say, and does nothing else.
#[test]
fn a_start_on_the_limit_of_static_friction_goes_to_the_side_that_comes_next() {
    let (mut rolling, mut sliding, mut from_rest) = (0, 0, 0);
    let mut wrong = Vec::new();
    for case in 0..4_000 {
        let Some((hoop, start)) = start_on_limit(&mut Draw::of_case(45, 0, case)) else {
            continue;
        };
        let time = 2e-3 / (1.0 + start.theta_rate.abs());
        let margin = |time| {
            let state = Contact::Rolls.after(&hoop, &start, (time, 24));
            Contact::Rolls.forced(&hoop, state)[2]
        };
        let [early, late] = [0.5 * time, time].map(margin);
        // The first derivative has to decide on it so soon, or from rest the second.
        let order = if start.theta_rate == 0.0 { 4.0 } else { 2.0 };
        let is_early = late.abs() > if order == 4.0 { 1e-9 } else { 1e-6 };
        if !(is_early && (late / early - order).abs() < 0.1) {
            continue;
        }
        from_rest += u32::from(order == 4.0);
        let [_, _, friction] = balances(&hoop, &start).rolling();
        let against = SlipDirection::of_sign(-friction);
        let (expected, contact) = match against {
            Some(direction) if late > 0.0 => (
                (Mode::Sliding, against),
                Contact::Slides(direction, hoop.mu_k()),
            ),
            _ => ((Mode::Rolling, None), Contact::Rolls),
        };
        *if late > 0.0 {
            &mut sliding
        } else {
            &mut rolling
        } += 1;
        let limits = Limits::until(time);
        let motion = hoop.simulate(start, limits).expect("a start");
        let modes: Vec<_> = motion
            .phases()
            .iter()
            .map(|it| (it.mode(), it.direction()))
            .collect();
        let last = motion.phases().last().expect("a phase");
        let end = last.sample(time).state;
        let [coarse, expected_end] =
            [24, 96].map(|steps| contact.after(&hoop, &start, (time, steps)));
        let near = |end: State| {
            let numbers = [end.theta, end.theta_rate, end.slip];
            // Light hoops are stiff.
            let digit = 1e-11 * (1.0 + start.theta_rate.abs());
            numbers
                .into_iter()
                .zip(expected_end.into_iter().zip(coarse))
                .all(|(it, (fine, coarse))| (it - fine).abs() < digit + (fine - coarse).abs())
        };
        let is_same = modes == [expected]
            && near(end)
            && engines(&hoop).iter().all(|engine| {
                let found = engine.summary(start, limits).expect("a start");
                found.transitions == 0 && (found.end.time != time || near(found.end))
            });
        if !is_same {
            wrong.push(format!(
                "{case}: {modes:?}, not {expected:?}; {end:?}, not {expected_end:?}: {hoop:?} {start:?}"
            ));
        }
    }
    none_differ(
        &wrong,
        &format!("{rolling} roll, {sliding} slide, {from_rest} from rest"),
    );
    assert!(
        rolling > 200 && sliding > 200 && from_rest > 50,
        "{rolling} {sliding} {from_rest}"
    );
}

/// The number that is so many doubles away.
fn beside(value: f64, digits: i32) -> f64 {
    (0..digits.abs()).fold(value, |value, _| {
        if digits < 0 {
            value.next_down()
        } else {
            value.next_up()
        }
    })
}

/// The phases of a motion up to a time: modes, and directions of slip.
fn phases_until(hoop: &Hoop, start: Start, time: f64) -> Vec<(Mode, Option<SlipDirection>)> {
    let motion = hoop.simulate(start, Limits::until(time)).expect("a start");
    motion
        .phases()
        .iter()
        .map(|it| (it.mode(), it.direction()))
        .collect()
}

/// On w = 0, where rounding tells its sign, the change of w decides: the modes are those of a rate
/// that differs by 1e-6 to the side that comes next, and last.
#[test]
fn a_start_on_the_limit_of_contact_goes_to_the_side_that_comes_next() {
    let (mut contact, mut flying, mut wrong) = (0, 0, Vec::new());
    for case in 0..12_000 {
        let mut draw = Draw::of_case(46, 0, case);
        let (hoop, drawn) = draw.in_contact();
        let Body::Heavy(body) = hoop.body() else {
            continue;
        };
        let theta = if draw.comes(0.2) {
            0.0
        } else {
            draw.one_of(&[-1.0, 1.0]) * draw.between([0.05, 1.4])
        };
        let limit = (libm::cos(hoop.slope()) / (body.h * libm::cos(theta))).sqrt();
        if !(0.1..30.0).contains(&limit) {
            continue;
        }
        let side = draw.one_of(&[-1.0, 1.0]);
        // A slip that does not end soon.
        let slip = drawn.slip.signum() * if drawn.slip == 0.0 { 0.0 } else { 0.5 };
        let start = |rate: f64| Start::at(theta, side * rate).with_slip(slip);
        let next = if theta * side < 0.0 { 1e-6 } else { -1e-6 };
        // At the top w has its least value, on a level plane. Soon after it friction may hold again.
        let angle = if theta == 0.0 { 3e-7 } else { 1e-4 };
        let soon = Start::at(angle * side, side * limit).with_slip(slip);
        let expected = match theta == 0.0 {
            // With much friction P may vanish as soon.
            true if hoop.slope() != 0.0 || hoop.mu_s() > 10.0 => continue,
            true => modes(&hoop, &soon),
            false => modes(&hoop, &start(limit * (1.0 + next))),
        };
        // Another limit may lie in between.
        let nearer = modes(&hoop, &start(limit * (1.0 + 0.01 * next)));
        if !expected.are_certain() || theta != 0.0 && nearer.set() != expected.set() {
            continue;
        }
        for digits in [-1, 0, 1] {
            let start = start(beside(limit, digits));
            let found = said(&hoop.classify(start).expect("a start"));
            let until = angle / limit;
            let is_same = agrees(&expected, &found)
                && (found.len() != 1 || phases_until(&hoop, start, until) == found)
                && engines(&hoop).iter().all(|engine| {
                    let limits = Limits::until(until);
                    let motion = hoop.simulate(start, limits).expect("a start");
                    let summary = engine.summary(start, limits).expect("a start");
                    summary.outcome == motion.outcome().kind()
                });
            *if expected.flight == Some(true) {
                &mut flying
            } else {
                &mut contact
            } += 1;
            if !is_same {
                wrong.push(format!(
                    "{case} {digits}: {expected:?}, but {found:?}, {:?}: {hoop:?} {start:?}",
                    phases_until(&hoop, start, until)
                ));
            }
        }
    }
    none_differ(&wrong, &format!("{contact} in contact, {flying} fly"));
    assert!(contact > 500 && flying > 500, "{contact} {flying}");
}

/// On a slope N = F = 0 at once where the particle is vertically above the centre, at the rate of
/// lift-off: the first derivatives of w, N and F of Newton's and Euler's equations decide.
#[test]
fn a_start_in_free_fall_on_a_slope_goes_to_the_side_that_comes_next() {
    let (mut seen, mut wrong) = ([0; 4], Vec::new());
    for case in 0..3_000 {
        let mut draw = Draw::of_case(52, 0, case);
        let mu_s = draw.one_of(&[0.0, draw.clone().between([0.0, 2.0])]);
        let slope = draw.one_of(&[-1.0, 1.0]) * draw.between([0.02, 1.4]);
        let parameters = HoopParameters::thin(draw.between([0.0, 2.0]))
            .with_offset(draw.between([0.1, 1.0]))
            .with_inertia(draw.between([0.01, 1.0]))
            .with_slope(slope)
            .with_friction(mu_s, mu_s * draw.one_of(&[1.0, draw.clone().share()]));
        let hoop = Hoop::new(parameters).expect("a hoop");
        let limit = (1.0 / hoop.h()).sqrt();
        let side = draw.one_of(&[-1.0, 1.0]);
        let start = Start::at(-slope, side * limit);
        let time = 1e-4 / limit;
        let [early, late] = [0.5, 1.0].map(|part| {
            let state = Contact::Rolls.after(&hoop, &start, (part * time, 24));
            let of = balances(&hoop, &Start::at(state[0], state[1]));
            let [_, n, f] = of.rolling();
            let [_, opening, _] = of.flight();
            [opening, n, f, f.abs() - mu_s * n]
        });
        // The first derivatives have to decide so soon.
        if early
            .iter()
            .zip(late)
            .any(|(early, late)| (late / early - 2.0).abs() > 0.01)
        {
            continue;
        }
        let [opening, n, f, excess] = late;
        // The closed form of the page.
        let Body::Heavy(body) = hoop.body() else {
            panic!("heavy")
        };
        let (m, h, own) = (body.mass, body.h, body.inertia);
        let (sin, cos) = libm::sincos(slope);
        let demand =
            (m * h * sin * sin - own * cos).abs() / (sin.abs() * (own + m * (1.0 + h * cos)));
        assert!((f.abs() / n.abs() - demand).abs() < 0.02 * (1.0 + demand));
        let expected = if opening > 0.0 {
            // N and w fall together: no wedge.
            assert!(n < 0.0, "{hoop:?} {start:?}");
            (Mode::Flight, None)
        } else if n > 0.0 && excess <= 0.0 {
            (Mode::Rolling, None)
        } else {
            (Mode::Sliding, SlipDirection::of_sign(-f))
        };
        seen[match expected {
            (Mode::Flight, _) => 0,
            (Mode::Rolling, _) => 1,
            (_, Some(SlipDirection::Negative)) => 2,
            _ => 3,
        }] += 1;
        for digits in -2..=2 {
            let start = Start::at(-slope, side * beside(limit, digits));
            let found = phases_until(&hoop, start, time);
            let limits = Limits::until(time);
            let motion = hoop.simulate(start, limits).expect("a start").summary();
            let is_same = found == [expected]
                && said(&hoop.classify(start).expect("a start")) == [expected]
                && engines(&hoop).iter().all(|engine| {
                    let summary = engine.summary(start, limits).expect("a start");
                    (summary.outcome, summary.sequence) == (motion.outcome, motion.sequence)
                });
            if !is_same {
                wrong.push(format!(
                    "{case} {digits}: {found:?}, not {expected:?}: {hoop:?} {start:?}"
                ));
            }
        }
    }
    none_differ(&wrong, &format!("{seen:?} fly, roll, slide to either side"));
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
}

/// A swing without kinetic friction that comes back to its angle with the opposite rate, and the
/// tangent of the slope on which η′ vanishes there again: the pull over the time of the swing is
/// twice the momentum of the start. In units in which gravity normal to the plane is 1 the swing is
/// that of a level plane.
fn slip_that_comes_back(draw: &mut Draw) -> Option<(HoopParameters, [f64; 2], [f64; 2])> {
    let parameters = HoopParameters::thin(draw.between([0.0, 2.0]))
        .with_offset(draw.between([0.1, 1.0]))
        .with_inertia(draw.between([0.01, 1.0]));
    let level = Hoop::new(parameters).expect("a hoop");
    let (theta, rate) = (draw.between([-3.1, 3.1]), draw.between([-3.0, 3.0]));
    let (h, start) = (level.h(), Start::at(theta, rate));
    let smooth = Contact::Slides(SlipDirection::Positive, 0.0);
    let step = 0.02;
    let (mut now, mut time) = (start, 0.0);
    while time < 12.0 {
        let [angle, rate, _] = smooth.after(&level, &now, (step, 1));
        let next = Start::at(angle, rate);
        if h * libm::cos(angle) * rate * rate > 0.95 || (angle - theta).abs() > TAU {
            return None;
        }
        if rate * start.theta_rate < 0.0 && (angle - theta) * (now.theta - theta) <= 0.0 {
            // Newton's method for the time of the return, in small steps from the start.
            for _ in 0..3 {
                let [angle, rate, _] = smooth.after(&level, &start, (time, 2_000));
                time -= (angle - theta) / rate;
            }
            let tilt = -2.0 * start.theta_rate * (1.0 + h * libm::cos(theta)) / time;
            return (tilt.abs() < 5.0).then_some((
                parameters,
                [theta, start.theta_rate],
                [time, tilt],
            ));
        }
        now = next;
        time += step;
    }
    None
}

/// On a slope a slide without kinetic friction can come back to η′ = 0 at the angle and the squared
/// rate at which it began on |F| = μs N, if it has reversed before. On slopes that differ by a part
/// in 1e7 the side on which η′ vanishes decides.
#[test]
fn a_slip_that_comes_back_to_the_limit_on_a_slope_is_decided_by_its_side() {
    let (mut sides, mut exact, mut wrong) = ([0; 2], [0; 2], Vec::new());
    for case in 0..800 {
        let Some((parameters, [theta, rate], [time, tilt])) =
            slip_that_comes_back(&mut Draw::of_case(53, 0, case))
        else {
            continue;
        };
        for part in [-1e-7, 0.0, 1e-7] {
            let slope = libm::atan(tilt * (1.0 + part));
            let pace = libm::cos(slope).sqrt();
            let start = Start::at(theta, rate * pace);
            let parameters = parameters.with_slope(slope);
            let [_, n, f] = balances(&Hoop::new(parameters).expect("a hoop"), &start).rolling();
            let mu_s = f.abs() / n;
            if !(n > 0.01 && mu_s > 1e-3 && mu_s < 5.0) {
                continue;
            }
            let hoop = Hoop::new(parameters.with_friction(mu_s, 0.0)).expect("a hoop");
            let back = time / pace;
            let limits = Limits::until(1.01 * back);
            let motion = hoop.simulate(start, limits).expect("a start");
            let [first, second, ..] = motion.transitions() else {
                continue;
            };
            if first.cause != Cause::Reversal || (second.time() - back).abs() > 1e-4 {
                continue;
            }
            let smooth = Contact::Slides(SlipDirection::Positive, 0.0);
            let [_, _, slip] = smooth.after(&hoop, &start, (back, 2_000));
            let [_, slip_acceleration, _] = smooth.forced(&hoop, [theta, -start.theta_rate, slip]);
            let rest = back - slip / slip_acceleration;
            let at_rest = smooth.after(&hoop, &start, (rest, 2_000));
            let excess = Contact::Rolls.forced(&hoop, at_rest)[2];
            if part == 0.0 {
                exact[usize::from(second.cause == Cause::Stick)] += 1;
                continue;
            }
            sides[usize::from(excess < 0.0)] += 1;
            let expected = if excess < 0.0 {
                Cause::Stick
            } else {
                Cause::Reversal
            };
            let is_same = second.cause == expected
                && engines(&hoop).iter().all(|engine| {
                    let summary = engine.summary(start, limits).expect("a start");
                    summary.sequence == motion.summary().sequence
                });
            if !is_same {
                wrong.push(format!(
                    "{case} {part}: {:?}, not {expected:?} with {excess}: {hoop:?} {start:?}",
                    second.cause
                ));
            }
        }
    }
    none_differ(
        &wrong,
        &format!("{sides:?} slip on or stick, {exact:?} between"),
    );
    assert!(sides.iter().all(|count| *count > 4), "{sides:?}");
}

/// A massless hoop on a limit of rolling: the coefficient of friction that it needs, or a rate at
/// which N = 0.
fn massless_start_on_limit(draw: &mut Draw) -> Option<(Hoop, Start)> {
    let offset = draw.one_of(&[1.0, draw.clone().between([0.05, 1.0])]);
    let slope = draw.one_of(&[0.0, draw.clone().between([-1.2, 1.2])]);
    let theta = draw.between([-3.0, 3.0]);
    let (sin, cos) = libm::sincos(theta);
    let unloads = draw.comes(0.5);
    let rate = if unloads {
        let held = 1.0 + offset * cos - libm::tan(slope) * offset * sin;
        (libm::cos(slope) * held / (offset * (offset + cos))).sqrt()
    } else {
        draw.one_of(&[0.0, draw.clone().between([0.05, 2.0])])
    };
    let rate = draw.one_of(&[-1.0, 1.0]) * rate;
    let needed = offset * sin.abs() / (1.0 + offset * cos);
    let mu = if unloads { 2.0 * needed } else { needed };
    if !(rate.abs() < 5.0 && (1e-3..5.0).contains(&mu)) {
        return None;
    }
    let digits = draw.below(5) as i32 - 2;
    let parameters = HoopParameters::thin(0.0)
        .with_offset(offset)
        .with_slope(slope);
    let (mu, rate) = if unloads {
        (mu, beside(rate, digits))
    } else {
        (beside(mu, digits), rate)
    };
    let hoop = Hoop::new(parameters.with_friction(mu, mu)).ok()?;
    Some((hoop, Start::at(theta, rate)))
}

/// On N = 0 or |F| = μs N a massless hoop rolls if neither is exceeded just after, as Newton and
/// Euler say of its rolling, and glides otherwise.
#[test]
fn a_massless_start_on_a_limit_goes_to_the_side_that_comes_next() {
    let (mut rolling, mut gliding, mut wrong) = (0, 0, Vec::new());
    for case in 0..6_000 {
        let Some((hoop, start)) = massless_start_on_limit(&mut Draw::of_case(47, 0, case)) else {
            continue;
        };
        let time = 1e-3;
        // The least of N and of μs N − |F|.
        let margin = |time: f64| {
            let [theta, rate, _] = Contact::Rolls.after(&hoop, &start, (time, 24));
            let [_, n, f] = balances(&hoop, &Start::at(theta, rate)).rolling();
            n.min(hoop.mu_s() * n - f.abs())
        };
        let [early, late] = [0.5 * time, time].map(margin);
        let order = if start.theta_rate == 0.0 { 4.0 } else { 2.0 };
        if !(late.abs() > 1e-9 && (late / early - order).abs() < 0.1) {
            continue;
        }
        let expected = if late > 0.0 {
            rolling += 1;
            Mode::Rolling
        } else {
            gliding += 1;
            Mode::Gliding
        };
        let found: Vec<_> = phases_until(&hoop, start, time)
            .into_iter()
            .map(|it| it.0)
            .collect();
        if found != [expected] {
            wrong.push(format!(
                "{case}: {found:?}, not {expected:?}: {hoop:?} {start:?}"
            ));
        }
    }
    none_differ(&wrong, &format!("{rolling} roll, {gliding} glide"));
    assert!(rolling > 300 && gliding > 300, "{rolling} {gliding}");
}

/// At rest in an equilibrium of a slope |F| = μs N with μs = tan α, whatever comes: rolling and the
/// slide are both named. A part in 1e9 decides.
#[test]
fn a_hoop_balanced_on_a_slope_at_the_limit_of_static_friction_is_ambiguous() {
    for (inertia, slope) in [(0.0, 0.3), (1.0, 0.3), (0.4, -0.25), (0.0, -0.2)] {
        let needed = libm::tan(slope).abs();
        for (factor, expected) in [
            (1.0, None),
            (1.0 + 1e-9, Some(true)),
            (1.0 - 1e-9, Some(false)),
        ] {
            let parameters = HoopParameters::thin(0.0)
                .with_offset(0.8)
                .with_inertia(inertia)
                .with_slope(slope);
            let hoop = Hoop::new(parameters.with_friction(factor * needed, 0.5 * needed));
            let hoop = hoop.expect("a hoop");
            for equilibrium in littlewood::theory::PhasePlane::new(&hoop).equilibria() {
                let start = Start::at(equilibrium.theta, 0.0);
                let motion = hoop.simulate(start, Limits::until(1.0)).expect("a start");
                let found = hoop.classify(start).expect("a start");
                match expected {
                    Some(rolls) => {
                        let is_rolling = found.mode == Some(Mode::Rolling);
                        assert!(is_rolling == rolls && found.mode.is_some(), "{found:?}");
                    }
                    None => {
                        let Outcome::Ambiguous { candidates, .. } = motion.outcome() else {
                            panic!("{:?}: {hoop:?} {start:?}", motion.outcome())
                        };
                        assert!(candidates.rolling && candidates.count() == 2);
                        assert_eq!(found.candidates, Some(candidates));
                    }
                }
            }
        }
    }
    // The forces of a disc that rolls down are constant, with F/N = tan α Î/(Î + m).
    for (inertia, slope) in [(0.5, 0.4), (1.3, -0.7)] {
        let disc = |factor: f64| {
            let needed = factor * libm::tan(slope).abs() * inertia / (inertia + 2.0);
            let parameters = HoopParameters::thin(1.0)
                .with_offset(0.0)
                .with_inertia(inertia)
                .with_slope(slope);
            Hoop::new(parameters.with_friction(needed, 0.5 * needed)).expect("a disc")
        };
        let first = |factor: f64| {
            let found = disc(factor).classify(Start::at(0.3, 0.2)).expect("a start");
            found.mode
        };
        assert_eq!(first(1.0), None);
        assert_eq!(first(1.0 + 1e-9), Some(Mode::Rolling));
        assert_eq!(first(1.0 - 1e-9), Some(Mode::Sliding));
    }
}

/// At P = 0 a slide depends on the logarithm of P, which is rounding: unresolved where the plane
/// presses, and ambiguous where the hoop may fly. A part in 1e9 decides.
#[test]
fn a_slip_at_the_zero_of_p_is_unresolved() {
    let mut seen = [0; 2];
    for case in 0..4_000 {
        let mut draw = Draw::of_case(48, 0, case);
        let (mass_ratio, theta) = (draw.between([0.0, 0.5]), draw.between([0.2, 2.6]));
        let parameters = HoopParameters::thin(mass_ratio).with_inertia(draw.between([0.01, 0.3]));
        let side = draw.one_of(&[-1.0, 1.0]);
        let start = Start::at(side * theta, draw.between([-3.0, 3.0])).with_slip(side * 0.3);
        let of = |mu: f64| Hoop::new(parameters.with_friction(mu, mu)).expect("a hoop");
        let Body::Heavy(body) = of(0.0).body() else {
            panic!("heavy")
        };
        let (m, h, own) = (body.mass, body.h, body.inertia);
        let (sin, cos) = libm::sincos(theta);
        let zero = (own + m * (h * sin) * (h * sin)) / (m * h * sin * (1.0 + h * cos));
        let w = 1.0 - h * cos * start.theta_rate * start.theta_rate;
        if !(zero < 5.0 && w.abs() > 1e-3) {
            continue;
        }
        for digits in [-1, 0, 1] {
            let hoop = of(beside(zero, digits));
            let motion = hoop.simulate(start, Limits::until(1.0)).expect("a start");
            let outcome = motion.outcome();
            let kind = outcome.kind();
            if let Outcome::Unresolved { undecided, .. } = outcome {
                // P is Î and two terms that cancel it.
                let Undecided::Rounding {
                    margin: Margin::Painleve,
                    value,
                    bound,
                } = undecided
                else {
                    panic!("{undecided:?}")
                };
                let terms = own + m * h * sin * (h * sin + zero * (1.0 + h * cos));
                assert!(
                    value.abs() <= bound && bound < 1e-14 * terms,
                    "{undecided:?}"
                );
            }
            let expected = if w > 0.0 {
                OutcomeKind::Unresolved
            } else {
                OutcomeKind::Ambiguous
            };
            assert_eq!(kind, expected, "{hoop:?} {start:?}");
            for engine in engines(&hoop) {
                let summary = engine.summary(start, Limits::until(1.0)).expect("a start");
                assert_eq!(summary.outcome, kind, "{hoop:?} {start:?}");
            }
            seen[usize::from(w > 0.0)] += 1;
        }
        for factor in [1.0 - 1e-9, 1.0 + 1e-9] {
            let hoop = of(factor * zero);
            let found = said(&hoop.classify(start).expect("a start"));
            assert!(agrees(&modes(&hoop, &start), &found), "{hoop:?} {start:?}");
        }
    }
    assert!(seen.iter().all(|count| *count > 300), "{seen:?}");
}
