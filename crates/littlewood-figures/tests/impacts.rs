//! Figures of what comes after the landing, against the notes and the laws of impact written out
//! once more.

use crate::support;
use crate::support::{assert_near, columns, figure, outlines, series, winding};
use littlewood::cases::{CASES, find_case};
use littlewood::impact::Impact;
use littlewood::tables::Setup;
use littlewood::{Hoop, HoopParameters, Limits, RestitutionLaw, Start, Trajectory};
use littlewood_figures::{Figure, FigureError, FigureInput, Series, find_figure, plain};
use littlewood_random::jam_after_a_stick;

/// The landing of Figure 3, computed elsewhere: time, slip, rate of the gap, and A, B, C.
const LANDING: f64 = 3.847_395_556_686_894;
const SLIP: f64 = -0.785_244_687_128_996_2;
const GAP_RATE: f64 = -1.913_012_569_038_374_7;
const A: f64 = 0.704_169_493_845_475_1;
const B: f64 = -0.082_949_346_429_552_6;
const C: f64 = 0.533_700_402_266_253_8;
/// Where it settles with e = 0.5, and by which ratio.
const SETTLES: f64 = 6.924_682_083_018_514;
const RATIO: f64 = 0.492_024_505_882_643;

fn input(parameters: HoopParameters, start: Start) -> FigureInput {
    FigureInput::new(
        Hoop::new(parameters).expect("a hoop"),
        start,
        Limits::default(),
    )
}

fn make(name: &str, input: &FigureInput) -> Result<Figure, FigureError> {
    find_figure(name)
        .expect("a name of the catalogue")
        .figure(input)
}

fn figure_3_with(e: f64, law: RestitutionLaw) -> FigureInput {
    let setup = find_case("figure-3").expect("a case").setup;
    input(setup.hoop.with_restitution(e, law), setup.start)
}

fn motion(input: &FigureInput) -> Trajectory {
    input
        .hoop
        .simulate(input.start, input.limits)
        .expect("a motion")
}

fn impulses(series: &Series) -> Vec<[f64; 2]> {
    columns(series, ["friction_impulse", "normal_impulse"])
}

fn first_impact(motion: &Trajectory) -> Impact {
    motion
        .transitions()
        .iter()
        .find_map(|transition| transition.impact)
        .expect("an impact")
}

/// The corners of the course that are drawn, each once.
fn course(figure: &Figure) -> Vec<[f64; 2]> {
    let mut corners: Vec<[f64; 2]> = Vec::new();
    for part in series(figure, "course") {
        for corner in impulses(part) {
            if !corners.contains(&corner) {
                corners.push(corner);
            }
        }
    }
    corners
}

#[test]
fn the_course_of_the_impact_is_that_of_the_notes() {
    let figure = figure("impact");
    let corners = course(&figure);
    // It slips with σ = −1, J = μk P, to P1 = |u|/(μk A + B), and sticks then, dJ/dP = −B/A.
    let first = -SLIP / (0.4 * A + B);
    let k1 = C + 0.4 * B;
    let k2 = C - B * B / A;
    let between = GAP_RATE + k1 * first;
    // Stronge: w² = w1² + (k2/k1)(e² w0² − w1²).
    let opening =
        (between * between + k2 / k1 * (0.25 * GAP_RATE * GAP_RATE - between * between)).sqrt();
    let normal = first + (opening - between) / k2;
    let friction = 0.4 * first - B / A * (normal - first);
    for (found, wanted) in
        corners
            .iter()
            .zip([[0.0, 0.0], [0.4 * first, first], [friction, normal]])
    {
        assert_near(found[0], wanted[0], 1e-11, "J");
        assert_near(found[1], wanted[1], 1e-11, "P");
    }
    assert_eq!(corners.len(), 3);
    let impact = first_impact(&motion(
        &FigureInput::of_case("figure-3-bounces").expect("a case"),
    ));
    assert_eq!(
        corners[2],
        [impact.impulse.friction, impact.impulse.normal],
        "the end is the impulse"
    );
    let [[friction, normal]] = impulses(series(&figure, "compressed most")[0])[..] else {
        panic!("one")
    };
    assert_near(GAP_RATE + B * friction + C * normal, 0.0, 1e-12, "w = 0");
    assert_near(friction, 0.4 * normal, 1e-12, "while it slips");
    let caption = plain(&figure.caption);
    for words in [
        "A = 0.7042",
        "B = −0.0829",
        "C = 0.5337",
        "sticks in restitution",
        "e = 0.5",
        "energetic",
    ] {
        assert!(caption.contains(words), "{words}: {caption}");
    }
}

/// Both coordinates of the ends of a line that is drawn.
fn ends(figure: &Figure, name: &str) -> Vec<[f64; 2]> {
    impulses(series(figure, name)[0])
}

#[test]
fn the_lines_are_where_slip_and_gap_rate_vanish_and_where_the_law_ends_the_impact() {
    for law in RestitutionLaw::ALL {
        let input = figure_3_with(0.7, law);
        let figure = make("impact", &input).expect("the figure");
        for [friction, normal] in ends(&figure, "sticking") {
            assert_near(SLIP + A * friction + B * normal, 0.0, 1e-12, "u");
        }
        for [friction, normal] in ends(&figure, "greatest_compression") {
            assert_near(GAP_RATE + B * friction + C * normal, 0.0, 1e-12, "w");
        }
        let [_, compressed] = impulses(series(&figure, "compressed most")[0])[0];
        for [friction, normal] in ends(&figure, "termination") {
            match law {
                RestitutionLaw::Newton => {
                    assert_near(
                        GAP_RATE + B * friction + C * normal,
                        -0.7 * GAP_RATE,
                        1e-12,
                        "w after",
                    );
                }
                RestitutionLaw::Poisson => assert_near(normal, 1.7 * compressed, 1e-12, "P"),
                // Its slope is that of w; the course tells which of these lines it is.
                RestitutionLaw::Energetic => {}
            }
        }
        let line = ends(&figure, "termination");
        let last = *course(&figure).last().expect("an end");
        let across = (line[1][0] - line[0][0]) * (last[1] - line[0][1])
            - (line[1][1] - line[0][1]) * (last[0] - line[0][0]);
        assert_near(
            across,
            0.0,
            1e-10,
            "the course ends on the line of termination",
        );
        for [friction, normal] in ends(&figure, "static_cone") {
            assert_near(friction.abs(), 0.5 * normal, 1e-14, "cone");
        }
    }
}

/// An impact with rolling resistance: it slips and turns, turns back, sticks, and stops.
struct FourSegments {
    sigma: f64,
    /// The signs of θ′ in the first segments, and where each begins: J, P, η′ and the gap rate.
    turns: [f64; 4],
    starts: [[f64; 4]; 4],
    /// A, B, C, and what the couple of a unit of P adds to η′ and to the gap rate.
    response: [f64; 5],
    mass: f64,
}

impl FourSegments {
    /// By the table of segments in docs/theory/rolling-resistance.md.
    fn new(hoop: HoopParameters, theta: f64, before: [f64; 3]) -> Self {
        let chi = hoop.rolling_resistance;
        let mass = 1.0 + hoop.mass_ratio;
        let h = hoop.offset / mass;
        let own = hoop.inertia + hoop.mass_ratio * h * h + (hoop.offset - h) * (hoop.offset - h);
        let (sin, cos) = libm::sincos(theta);
        let (a, d) = (h * sin, 1.0 + h * cos);
        let [mut rate, mut slip, mut gap_rate] = before;
        let sigma = slip.signum();
        let turns = [1.0, -1.0, -1.0, 0.0];
        let mut starts = [[0.0; 4]; 4];
        let (mut friction, mut normal) = (0.0, 0.0);
        for (i, start) in starts.iter_mut().enumerate() {
            *start = [friction, normal, slip, gap_rate];
            let (j, twist) = (own + mass * d * d, a - turns[i] * chi);
            let rubs = if i < 2 {
                -sigma * hoop.mu_k
            } else {
                -mass * d * twist / j
            };
            let spin = (twist + d * rubs) / own;
            let slides = rubs / mass + d * spin;
            let length = [-rate / spin, -slip / slides, -rate / spin, 0.0][i];
            friction += rubs * length;
            normal += length;
            gap_rate += (1.0 / mass + a * spin) * length;
            rate = if i % 2 == 0 {
                0.0
            } else {
                rate + spin * length
            };
            slip = if i > 0 { 0.0 } else { slip + slides * length };
        }
        Self {
            sigma,
            turns,
            starts,
            response: [
                1.0 / mass + d * d / own,
                a * d / own,
                1.0 / mass + a * a / own,
                -chi * d / own,
                -chi * a / own,
            ],
            mass,
        }
    }

    /// η′ and the gap rate that the impulses J and P make, from the first segment in whose
    /// rotation P is.
    fn velocities(&self, [friction, normal]: [f64; 2], near: f64) -> [f64; 2] {
        let at = (0..4)
            .rev()
            .find(|&i| self.starts[i][1] <= near)
            .expect("a segment");
        // The second and the third turn alike.
        let at = if at == 2 { 1 } else { at };
        let [from, pressed, slip, gap_rate] = self.starts[at];
        let (along, across) = (friction - from, normal - pressed);
        if self.turns[at] == 0.0 {
            return [slip + along / self.mass, gap_rate + across / self.mass];
        }
        let [a, b, c, couple, lifts] = self.response;
        let turns = self.turns[at];
        [
            slip + a * along + (b + turns * couple) * across,
            gap_rate + b * along + (c + turns * lifts) * across,
        ]
    }
}

#[test]
fn with_rolling_resistance_the_lines_are_those_of_each_rotation() {
    let hoop = HoopParameters::thin(1.0)
        .with_offset(0.6)
        .with_inertia(0.5)
        .with_friction(0.4, 0.3)
        .with_rolling_resistance(0.32)
        .with_restitution(0.5, RestitutionLaw::Energetic);
    let start = Start::at(-2.8, 0.08).with_slip(0.24).with_gap_rate(0.5);
    let input = input(hoop, start);
    let motion = motion(&input);
    let landing = motion.transitions()[0];
    let impact = landing.impact.expect("an impact");
    let before = impact.before;
    let known = FourSegments::new(
        hoop,
        landing.before.theta,
        [before.theta_rate, before.slip, before.gap_rate],
    );
    let figure = make("impact", &input).expect("the figure");
    let corners = course(&figure);
    assert_eq!(corners.len(), 5);
    for (corner, start) in corners.iter().zip(&known.starts) {
        assert_near(corner[0], start[0], 1e-13, "J");
        assert_near(corner[1], start[1], 1e-13, "P");
    }
    // What ends where: a rotation, the slip, the rotation that has begun.
    for (name, count) in [("rotation ends", 2), ("slip ends", 1)] {
        assert_eq!(series(&figure, name).len(), count, "{name}");
    }
    assert!(known.sigma > 0.0);
    for (name, which) in [("sticking", 0), ("greatest_compression", 1)] {
        let lines = series(&figure, name);
        assert!(!lines.is_empty(), "{name}");
        for line in lines {
            let ends = impulses(line);
            let near = 0.5 * (ends[0][1] + ends[1][1]);
            for end in ends {
                assert_near(known.velocities(end, near)[which], 0.0, 1e-12, name);
            }
        }
    }
    let [end] = series(&figure, "termination")[..] else {
        panic!("one line")
    };
    for [_, normal] in impulses(end) {
        assert_near(
            normal,
            impact.impulse.normal,
            1e-13,
            "held, w depends on P alone",
        );
    }
}

#[test]
fn the_impact_is_chosen_by_its_number() {
    let first = FigureInput::of_case("figure-3-bounces").expect("a case");
    let motion = motion(&first);
    let landings: Vec<Impact> = motion
        .transitions()
        .iter()
        .filter(|transition| transition.cause == littlewood::Cause::Landing)
        .filter_map(|transition| transition.impact)
        .collect();
    for number in [1, 2, 3, landings.len()] {
        let figure = make(
            "impact",
            &FigureInput {
                impact: number,
                ..first
            },
        )
        .expect("the figure");
        let impulse = landings[number - 1].impulse;
        assert_eq!(
            course(&figure).last(),
            Some(&[impulse.friction, impulse.normal]),
            "{number}"
        );
    }
    for number in [0, landings.len() + 1, usize::MAX] {
        let error = make(
            "impact",
            &FigureInput {
                impact: number,
                ..first
            },
        )
        .expect_err("refused");
        assert!(
            matches!(error, FigureError::ImpactNumber { impacts, .. } if impacts == landings.len())
        );
        assert!(
            error
                .to_string()
                .contains(&format!("1 to {}", landings.len())),
            "{error}"
        );
    }
}

#[test]
fn a_jam_has_a_course_that_starts_on_the_line_of_greatest_compression() {
    let figure = make("impact", &FigureInput::of_case("jam").expect("a case")).expect("the figure");
    assert!(
        plain(&figure.caption).contains("jams"),
        "{}",
        figure.caption
    );
    let line = ends(&figure, "greatest_compression");
    assert!(
        line.iter()
            .any(|[friction, normal]| friction.abs() < 1e-15 && normal.abs() < 1e-15)
    );
    // With e = 0 it ends there again.
    let corners = course(&figure);
    assert_eq!(corners.len(), 3);
    let [[friction, normal]] = impulses(series(&figure, "compressed most")[0])[..] else {
        panic!("one")
    };
    assert_near(friction, corners[2][0], 1e-14, "J");
    assert_near(normal, corners[2][1], 1e-14, "P");
}

#[test]
fn bounces_shrink_by_the_effective_ratio_until_they_settle() {
    let figure = figure("bounces");
    let before = columns(
        series(&figure, "before the impact")[0],
        ["landing", "gap_rate", "log10_gap_rate"],
    );
    let after = columns(
        series(&figure, "after the impact")[0],
        ["landing", "gap_rate"],
    );
    assert_near(before[0][1], GAP_RATE, 1e-13, "the first landing");
    assert_near(
        after[0][1],
        0.978_517_419_970_790_8,
        1e-12,
        "the first rebound",
    );
    for (number, row) in before.iter().enumerate() {
        assert_eq!(row[0], (number + 1) as f64);
        assert_near(row[2], libm::log10(-row[1]), 1e-15, "logarithm");
    }
    let last = before.len() - 1;
    assert_near(
        before[last][1] / before[last - 1][1],
        RATIO,
        1e-6,
        "ratio in the end",
    );
    let slope = columns(series(&figure, "limit")[0], ["landing", "log10_gap_rate"]);
    let drawn = (slope[1][1] - slope[0][1]) / (slope[1][0] - slope[0][0]);
    // It is taken where the last bounces begin, less than 1e-7 before their end.
    assert_near(drawn, libm::log10(RATIO), 1e-7, "slope");
    assert_near(
        columns(series(&figure, "settles")[0], ["time"])[0][0],
        SETTLES,
        1e-12,
        "time",
    );
    let landings = columns(series(&figure, "landing")[0], ["time", "gap"]);
    assert_near(landings[0][0], LANDING, 1e-13, "landing");
    for [_, gap] in columns(series(&figure, "gap")[0], ["time", "gap"]) {
        assert!(gap > -1e-14, "{gap}");
    }
    assert!(plain(&figure.caption).contains(&format!("After {} landings", before.len())));
}

#[test]
fn energy_falls_in_steps_at_impacts() {
    let figure =
        make("energy", &figure_3_with(0.5, RestitutionLaw::Energetic)).expect("the figure");
    let total = series(&figure, "total energy")[0];
    let drops = series(&figure, "lost in an impact")[0];
    let [before, after] = &drops.pieces[0][..] else {
        panic!("two ends")
    };
    assert_near(before[0], LANDING, 1e-13, "time");
    assert_near(
        before[1] - after[1],
        3.362_443_419_227_28,
        1e-11,
        "energy lost",
    );
    // Both sides of the jump are ends of the total energy.
    let rows: Vec<[f64; 2]> = columns(total, ["time", "energy"]);
    for [time, energy] in drops.pieces.iter().flatten().map(|row| [row[0], row[1]]) {
        let is_end = |row: &[f64; 2]| row[0] == time && (row[1] - energy).abs() < 1e-11;
        assert!(rows.iter().any(is_end), "{time} {energy}");
    }
    assert!(plain(&figure.caption).contains("Sliding costs 0.1777 m₂gR, the impacts 3.7973 m₂gR"));
}

/// A stick leads to a jam, which ends no phase: what is lost is what the hoop no longer has.
#[test]
fn a_jam_to_which_a_stick_leads_is_lost_energy() {
    let Setup { hoop, start } = jam_after_a_stick();
    let input = FigureInput {
        limits: Limits::until(20.0),
        ..input(hoop, start)
    };
    let motion = motion(&input);
    let [first, .., last] = motion.phases() else {
        panic!("{:?}", motion.phases())
    };
    let energies = [first, last].map(|phase| phase.first().energy);
    let figure = make("energy", &input).expect("the figure");
    let drop = series(&figure, "lost in an impact")[0]
        .pieces
        .last()
        .expect("a drop");
    // Others begin with the same word.
    let all = series(&figure, "lost");
    let all = all.into_iter().find(|one| one.name == "lost");
    let lost = columns(all.expect("all that is lost"), ["energy_lost"]);
    let lost = lost.last().expect("rows")[0];
    assert_near(lost, energies[0] - energies[1], 1e-14, "lost in all");
    let impact = first_impact(&motion);
    assert_near(
        drop[0][1] - drop[1][1],
        impact.energy_lost(),
        1e-14,
        "lost in the jam",
    );
}

#[test]
fn impulses_stand_beside_the_forces_and_stay_in_the_cone() {
    let input = figure_3_with(0.5, RestitutionLaw::Energetic);
    let figure = make("forces", &input).expect("the figure");
    let impact = first_impact(&motion(&input));
    let first = |name: &str| columns(series(&figure, name)[0], ["time", "impulse"])[0];
    assert_eq!(
        first("normal impulse"),
        [impact_time(&input), impact.impulse.normal]
    );
    assert_eq!(
        first("friction impulse"),
        [impact_time(&input), impact.impulse.friction]
    );
    for [_, demand] in columns(
        series(&figure, "friction over normal impulse")[0],
        ["time", "demand"],
    ) {
        assert!(demand <= 0.5 * (1.0 + 1e-12), "{demand}");
    }
}

fn impact_time(input: &FigureInput) -> f64 {
    motion(input)
        .transitions()
        .iter()
        .find(|transition| transition.impact.is_some())
        .expect("one")
        .time()
}

#[test]
fn the_space_of_states_has_both_sides_of_each_jump() {
    let input = figure_3_with(0.5, RestitutionLaw::Energetic);
    let figure = make("figure-3a", &input).expect("the figure");
    let jumps = series(&figure, "impact")[0];
    let rows = columns(jumps, ["time", "theta_rate", "slip"]);
    assert_near(rows[0][2], SLIP, 1e-13, "slip before");
    assert_eq!(rows[1][2], 0.0, "it sticks");
    assert_near(rows[1][1], 1.803_947_379_026_181_2, 1e-12, "rate after");
    assert!(series(&figure, "flight")[0].pieces.len() > 20);
    // Without restitution it ends at the lift-off, as in the paper.
    let paper = support::figure("figure-3a");
    assert!(paper.series("impact").is_none() && paper.series("flight").is_none());
}

#[test]
fn a_motion_without_impacts_is_refused_with_a_reason() {
    let without = FigureInput::of_case("figure-3").expect("a case");
    let massless = FigureInput::of_case("figure-7").expect("a case");
    let setup = find_case("rolls-forever").expect("a case").setup;
    let rolls = input(
        setup.hoop.with_restitution(0.5, RestitutionLaw::Energetic),
        setup.start,
    );
    for name in ["impact", "bounces"] {
        let error = make(name, &without).expect_err("refused");
        assert!(
            matches!(error, FigureError::NeedsRestitution { .. }),
            "{error}"
        );
        assert!(error.to_string().contains("coefficient of restitution"));
        assert!(matches!(
            make(name, &massless),
            Err(FigureError::NeedsInertia { .. })
        ));
        let error = make(name, &rolls).expect_err("refused");
        assert!(matches!(error, FigureError::NoImpact { .. }), "{error}");
        assert!(error.to_string().contains("rolls for ever"), "{error}");
    }
}

/// Hoops that bounce in every way: figures can be made, or say why not, and have no holes.
#[test]
fn every_hoop_that_bounces_has_its_figures() {
    let e = |parameters: HoopParameters, e: f64| {
        parameters.with_restitution(e, RestitutionLaw::Energetic)
    };
    let thin = |m1: f64| HoopParameters::thin(m1).with_friction(0.5, 0.4);
    let balanced = HoopParameters::thin(1.0)
        .with_offset(0.0)
        .with_friction(0.5, 0.4);
    let rest = core::f64::consts::PI;
    let newton = HoopParameters::thin(0.5)
        .with_friction(1.5, 1.5)
        .with_restitution(0.9, RestitutionLaw::Newton);
    let mut inputs = vec![
        input(e(balanced, 0.6), Start::at(0.0, 1.0).with_gap_rate(1.0)),
        input(e(balanced, 1.0), Start::at(0.0, 0.0).with_gap_rate(1.0)),
        input(e(thin(1e-3), 0.5), Start::at(1.0, 2.0)),
        input(e(thin(1.0), 0.5), Start::at(rest, 0.0)),
        input(e(thin(1.0), 0.5), Start::at(rest, 0.0).with_gap_rate(1e-9)),
        input(e(thin(1.0), 0.99), Start::at(0.0, 4.0)),
        input(
            newton,
            Start::at(0.3, 1.0).with_slip(1.5).with_gap_rate(0.8),
        ),
        input(
            e(thin(1.0).with_friction(0.0, 0.0), 0.5),
            Start::at(1.0, 4.0),
        ),
        input(e(thin(1.0), 0.9), Start::at(2.0, 1e-3).with_gap_rate(1e-3)),
    ];
    inputs.extend(
        CASES
            .iter()
            .filter(|case| case.setup.hoop.restitution.is_some())
            .map(|case| input(case.setup.hoop, case.setup.start)),
    );
    let names = [
        "figure-3a",
        "figure-3b",
        "forces",
        "energy",
        "impact",
        "bounces",
    ];
    for (number, input) in inputs.iter().enumerate() {
        // What rolls or slides for ever without a limit is left to the other tests.
        let input = FigureInput {
            limits: Limits::default().with_until(Some(40.0)),
            ..*input
        };
        for name in names {
            match make(name, &input) {
                Ok(figure) => {
                    let drawing = figure.svg();
                    roxmltree::Document::parse(&drawing).expect("well-formed XML");
                    assert!(!figure.csv().contains("NaN"), "{number} {name}");
                    assert!(
                        drawing.len() < 4_000_000,
                        "{number} {name}: {}",
                        drawing.len()
                    );
                }
                Err(FigureError::NeedsOffset { .. } | FigureError::NoImpact { .. }) => {}
                Err(other) => panic!("{number} {name}: {other}"),
            }
        }
    }
}

#[test]
fn a_hoop_that_lands_and_goes_on_rolls_in_the_end_and_the_figure_says_so() {
    let series = |figure: &Figure, name: &str| {
        let layers = figure.panels.iter().flat_map(|panel| &panel.layers);
        layers
            .map(|layer| layer.series.clone())
            .find(|series| series.name == name)
    };
    let without = figure("outcomes");
    let with =
        make("outcomes", &figure_3_with(0.5, RestitutionLaw::Energetic)).expect("the figure");
    // Slides, jumps from (π/2, 2), bounces, settles and rolls for ever.
    let place = [core::f64::consts::FRAC_PI_2, 2.0];
    let covers = |figure: &Figure, name: &str| {
        series(figure, name)
            .is_some_and(|series| winding(&outlines(&series, ["theta", "theta_rate"]), place) == 1)
    };
    assert!(covers(&without, "lifts_off_later") && !covers(&without, "rolls_forever"));
    assert!(covers(&with, "rolls_forever") && covers(&with, "lifts_off"));
    assert!(
        series(&with, "lifts_off_later").is_none() && series(&with, "leaves_at_once").is_none()
    );
    let caption = plain(&with.caption);
    assert!(
        caption.contains("followed through all landings to its end; hatched"),
        "{caption}"
    );
}
