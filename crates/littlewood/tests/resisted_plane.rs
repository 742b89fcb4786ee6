//! The phase plane with rolling resistance, against forces, starts and motions.
#![allow(clippy::disallowed_methods)] // expected values may come from the platform's mathematics

use littlewood::theory::{PhasePlane, StartRegion, Window};
use littlewood::{Hoop, HoopParameters, Limits, Mode, OutcomeKind, Start};
use littlewood_random::Draw;
use std::f64::consts::{PI, TAU};

const WINDOW: Window = Window {
    x: [-PI / 2.0, 2.5 * PI],
    y: [-6.0, 6.0],
};

/// A hoop with rolling resistance, of any size but for the very light and the very heavy ones.
fn hoop(draw: &mut Draw, mu: f64) -> Hoop {
    let slope = if draw.comes(0.4) {
        draw.between([-0.3, 0.3])
    } else {
        0.0
    };
    let is_massless = draw.comes(0.25);
    let mass_ratio = if is_massless {
        0.0
    } else {
        draw.of_any_size([-1.0, 1.0])
    };
    let offset = if draw.comes(0.3) {
        1.0
    } else {
        draw.between([0.05, 1.0])
    };
    let chi = draw.of_any_size([-3.0, -0.2]);
    let parameters = HoopParameters::thin(mass_ratio)
        .with_offset(offset)
        .with_friction(mu, mu)
        .with_slope(slope)
        .with_rolling_resistance(chi);
    Hoop::new(parameters).expect("a valid hoop")
}

/// How often closed lines wind about a place.
fn winds(lines: &[Vec<[f64; 2]>], [x, y]: [f64; 2]) -> bool {
    let edges = lines
        .iter()
        .flat_map(|line| line.iter().zip(line.iter().cycle().skip(1)));
    let crossed = edges.filter(|(a, b)| {
        (a[1] <= y) != (b[1] <= y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    });
    crossed.count() % 2 == 1
}

/// Distance of a place from lines, in parts of the window.
fn distance(lines: &[Vec<[f64; 2]>], [x, y]: [f64; 2]) -> f64 {
    let scaled = |p: &[f64; 2]| {
        [
            (p[0] - x) / (WINDOW.x[1] - WINDOW.x[0]),
            (p[1] - y) / (WINDOW.y[1] - WINDOW.y[0]),
        ]
    };
    let chords = lines.iter().flat_map(|line| line.windows(2));
    chords
        .map(|chord| {
            let (a, b) = (scaled(&chord[0]), scaled(&chord[1]));
            let d = [b[0] - a[0], b[1] - a[1]];
            let square = d[0] * d[0] + d[1] * d[1];
            let along = if square == 0.0 {
                0.0
            } else {
                (-(a[0] * d[0] + a[1] * d[1]) / square).clamp(0.0, 1.0)
            };
            (a[0] + along * d[0]).hypot(a[1] + along * d[1])
        })
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn curves_of_resisted_rolling_have_their_forces_and_bound_the_region() {
    let mut draw = Draw::of_case(71, 0, 0);
    let (mut on_f, mut on_n, mut held, mut free) = (0, 0, 0, 0);
    for _ in 0..150 {
        let mu = draw.between([0.02, 1.2]);
        let hoop = hoop(&mut draw, mu);
        let plane = PhasePlane::new(&hoop);
        for [theta, rate] in plane.slip_curve(&WINDOW).concat() {
            let forces = plane.forces(theta, rate);
            let size = hoop.mass() * (1.0 + rate * rate);
            // Beside a pole of the forces a digit of the rate is worth many of the force.
            if rate != 0.0 && forces.normal.abs() < 1e3 * size {
                let margin = mu * forces.normal - forces.friction.abs();
                assert!(
                    margin.abs() < 1e-7 * size,
                    "{hoop:?} {theta} {rate}: {margin}"
                );
                on_f += 1;
            }
        }
        for [theta, rate] in plane.normal_force_curve(&WINDOW).concat() {
            let forces = plane.forces(theta, rate);
            let size = hoop.mass() * (1.0 + rate * rate);
            // At a pole Dχ = 0 both grow without bound.
            assert!(
                forces.friction.abs() > 1e3 * size
                    || forces.normal.abs() < 1e-6 * (size + forces.friction.abs()),
                "{hoop:?} {theta} {rate}: {forces:?}"
            );
            on_n += 1;
        }
        let region = plane.rolling_region(&WINDOW);
        for _ in 0..40 {
            let at = [draw.between(WINDOW.x), draw.between(WINDOW.y)];
            // The outline is flat to a part of the window.
            if distance(&region, at) < 1e-3 {
                continue;
            }
            let forces = plane.forces(at[0], at[1]);
            let chi = hoop.rolling_resistance().copysign(at[1]);
            // Dχ, by (eq-resisted-rolling).
            let (sin, cos) = at[0].sin_cos();
            let (a, d, m) = (hoop.h() * sin, 1.0 + hoop.h() * cos, hoop.mass());
            let inertia = hoop.inertia() + hoop.mass_ratio() * hoop.offset() * hoop.h();
            let denominator = inertia + m * d * d + m * a * (a - chi);
            let rolls = denominator > 0.0 && plane.in_rolling_region(at[0], at[1]);
            assert_eq!(winds(&region, at), rolls, "{hoop:?} {at:?} {forces:?}");
            held += usize::from(rolls);
            free += usize::from(!rolls);
        }
    }
    assert!(
        on_f > 5000 && on_n > 5000 && held > 500 && free > 500,
        "{on_f} {on_n} {held} {free}"
    );
}

#[test]
fn the_band_of_rest_is_where_a_hoop_at_rest_rests() {
    let mut draw = Draw::of_case(72, 0, 0);
    let (mut inside, mut outside) = (0, 0);
    for _ in 0..200 {
        let mu = draw.between([0.1, 1.2]);
        let hoop = hoop(&mut draw, mu);
        let band = PhasePlane::new(&hoop).band_of_rest(&WINDOW);
        for _ in 0..10 {
            let theta = draw.between(WINDOW.x);
            let rests = band.iter().any(|[from, to]| (from..=to).contains(&&theta));
            let found = hoop
                .classify(Start::at(theta, 0.0))
                .expect("a start")
                .region;
            let expected = found == StartRegion::BandOfRest;
            assert_eq!(rests, expected, "{hoop:?} {theta} {found:?} {band:?}");
            inside += usize::from(rests);
            outside += usize::from(!rests);
        }
    }
    assert!(inside > 200 && outside > 200, "{inside} {outside}");
    let level = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
    let band = |chi| {
        let hoop = Hoop::new(level.with_rolling_resistance(chi)).expect("a valid hoop");
        PhasePlane::new(&hoop).band_of_rest(&WINDOW)
    };
    assert!(band(0.0).is_empty());
    // h = ½: |sin θ| ≤ 0.2 about the top, the bottom and the top.
    let found = band(0.1);
    for ([from, to], middle) in found.iter().zip([0.0, PI, TAU]) {
        let half = 0.2_f64.asin();
        assert!(
            (from - middle + half).abs() < 1e-15 * 8.0 && (to - middle - half).abs() < 1e-15 * 8.0
        );
    }
    assert_eq!((found.len(), band(0.5)), (3, vec![WINDOW.x]));
}

#[test]
fn orbits_of_resisted_rolling_are_those_of_motions() {
    let mut draw = Draw::of_case(73, 0, 0);
    let (mut seen, mut turned) = (0, 0);
    for case in 0..120 {
        // Friction that holds any hoop, so that it rolls until it lifts off.
        let hoop = hoop(&mut draw, 50.0);
        let start = Start::at(draw.between([0.0, TAU]), draw.between([-1.5, 1.5]));
        let limits = Limits::default().with_until(Some(60.0));
        let motion = hoop.simulate(start, limits).expect("a motion");
        let orbit = PhasePlane::new(&hoop).orbit(start.theta, start.theta_rate, &WINDOW);
        for (swing, phase) in motion.phases().iter().enumerate().take(2) {
            if phase.mode() != Mode::Rolling {
                break;
            }
            turned += swing;
            for k in 0..=20 {
                let at = phase
                    .sample(phase.duration().min(60.0) * f64::from(k) / 20.0)
                    .state;
                let place = [at.theta, at.theta_rate];
                let is_in =
                    (WINDOW.x[0]..=WINDOW.x[1]).contains(&place[0]) && at.theta_rate.abs() < 6.0;
                // Beyond the window the orbit is not followed.
                if !is_in {
                    break;
                }
                let far = distance(&orbit, place);
                assert!(
                    far < 2e-4,
                    "case {case} {hoop:?} {start:?} {place:?}: {far}"
                );
                seen += 1;
            }
        }
    }
    assert!(seen > 1500 && turned > 40, "{seen} {turned}");
}

#[test]
fn separatrices_part_what_turns_back_from_what_passes_the_top() {
    let parameters = HoopParameters::thin(1.0)
        .with_friction(50.0, 50.0)
        .with_rolling_resistance(0.05);
    let hoop = Hoop::new(parameters).expect("a valid hoop");
    let plane = PhasePlane::new(&hoop);
    let pieces = plane.separatrix_curve(&WINDOW);
    // sin θ = χ/h beyond the top, either way, about both tops.
    let saddle = 0.1_f64.asin();
    for place in [saddle, TAU + saddle, -saddle, TAU - saddle] {
        assert!(distance(&pieces, [place, 0.0]) < 1e-9, "{place}");
    }
    // Towards the top at 2π from the bottom.
    let forward = pieces.iter().find(|piece| {
        let is_upper = piece.iter().all(|row| row[1] >= 0.0);
        is_upper && piece.iter().any(|row| (row[0] - TAU - saddle).abs() < 1e-3)
    });
    let forward = forward.expect("a separatrix");
    let pair = forward
        .windows(2)
        .find(|pair| (pair[0][0] - PI) * (pair[1][0] - PI) <= 0.0);
    let [from, to] = *pair.expect("it passes the bottom") else {
        unreachable!("pairs")
    };
    let rate = from[1] + (PI - from[0]) / (to[0] - from[0]) * (to[1] - from[1]);
    let limits = Limits::default();
    let ends = [-1.0, 1.0].map(|side| {
        let start = Start::at(PI, rate + 0.01 * side);
        let motion = hoop.simulate(start, limits).expect("a motion");
        assert_eq!(motion.outcome().kind(), OutcomeKind::Rests);
        motion.phases()[0].last().expect("it turns").state.theta
    });
    assert!(
        ends[0] < TAU + saddle && ends[1] > 2.0 * TAU - PI,
        "{ends:?}"
    );
}
