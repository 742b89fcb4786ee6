//! What the figures of many motions show, read from their tables, against the simulation at random
//! places.

use std::collections::BTreeMap;

use crate::random::Draw;
use crate::support::winding;
use littlewood::cases::CASES;
use littlewood::tables::{Class, Quantity, Setup};
use littlewood::{Hoop, Limits, Mode, OutcomeKind, Phase, Start, Trajectory};
use littlewood_figures::{
    Axis, Figure, FigureError, FigureInput, Panel, PlotAxis, View, find_figure, plain,
};

/// The axes to the right and upwards.
fn axes(panel: &Panel) -> [&PlotAxis; 2] {
    match &panel.view {
        View::Plane { x, y, .. } | View::Space { x, y, .. } => [x, y],
    }
}

/// The pieces of each series of a panel, in a plane of two columns of the table.
fn table(figure: &Figure, panel: &str, columns: [&str; 2]) -> BTreeMap<String, Vec<Vec<[f64; 2]>>> {
    let csv = figure.csv();
    let mut lines = csv.lines();
    let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let place = |name: &str| {
        header
            .iter()
            .position(|column| *column == name)
            .expect("a column")
    };
    let [x, y] = columns.map(place);
    let mut series: BTreeMap<String, Vec<Vec<[f64; 2]>>> = BTreeMap::new();
    for cells in lines.map(|line| line.split(',').collect::<Vec<_>>()) {
        if cells[place("panel")] != panel {
            continue;
        }
        let (Ok(a), Ok(b)) = (cells[x].parse(), cells[y].parse()) else {
            continue;
        };
        let piece: usize = cells[place("piece")].parse().expect("a number");
        let pieces = series.entry(cells[place("series")].to_owned()).or_default();
        pieces.resize(pieces.len().max(piece + 1), Vec::new());
        pieces[piece].push([a, b]);
    }
    series
}

/// The class of a motion: of its end, where it goes on after a landing.
fn class(motion: &Trajectory) -> Class {
    let first = motion.phases().first().map(Phase::mode);
    let flies = motion
        .phases()
        .iter()
        .any(|phase| phase.mode() == Mode::Flight);
    match motion.outcome().kind() {
        _ if motion.hoop().restitution().is_none() && first == Some(Mode::Flight) => {
            Class::LeavesAtOnce
        }
        _ if motion.hoop().restitution().is_none() && flies => Class::LiftsOffLater,
        OutcomeKind::RollsForever => Class::RollsForever,
        OutcomeKind::SlipsForever => Class::SlipsForever,
        OutcomeKind::SlidesForever | OutcomeKind::RepeatsForever => Class::RepeatsForever,
        OutcomeKind::ParticleAtPlane => Class::ParticleAtPlane,
        OutcomeKind::ParticleAtTop => Class::ParticleAtTop,
        OutcomeKind::ParticleAtBottom => Class::ParticleAtBottom,
        OutcomeKind::Inconsistent | OutcomeKind::Ambiguous | OutcomeKind::Singular => {
            Class::Painleve
        }
        OutcomeKind::TransitionLimit
        | OutcomeKind::TimeLimit
        | OutcomeKind::StepLimit
        | OutcomeKind::StaysInContact => Class::InContact,
        OutcomeKind::Landing => Class::LiftsOffLater,
        OutcomeKind::Unresolved => Class::Unresolved,
        OutcomeKind::Invalid => Class::Invalid,
        OutcomeKind::NotComputed => Class::NotComputed,
    }
}

/// How far beside a place the motion must be alike for the place to be compared, in parts of the
/// line: lines between points of a curve are as flat as this.
const BESIDE: f64 = 2e-3;

/// The limits that a figure has followed motions to, as its caption says.
fn limits(figure: &Figure, own: Limits) -> Limits {
    let caption = plain(&figure.caption);
    let Some((before, _)) = caption.split_once(" transitions") else {
        return own;
    };
    let count = before.rsplit(' ').next().and_then(|word| word.parse().ok());
    count.map_or(own, |count| own.with_transitions(count))
}

/// What the figure of a line shows at a value: its class, and in which mode it is at times.
fn check_line(figure: &Figure, input: &FigureInput, axis: Axis, draw: &mut Draw) -> usize {
    // Where ends change more finely than is drawn the caption says so, and how often.
    let caption = plain(&figure.caption);
    let said: usize = caption
        .split_once(" other motions ")
        .and_then(|(_, after)| after.split(' ').next())
        .map_or(0, |count| count.parse().expect("a number"));
    let mut wrong = 0;
    let varies = axis.varies();
    let name = varies.name();
    let bands = table(figure, "bands", [name, "share"]);
    let times = table(figure, "times", [name, "time"]);
    let until = axes(&figure.panels[1])[1].range[1];
    let limits = limits(figure, input.limits);
    let simulated = |value: f64| -> Option<Trajectory> {
        let mut setup = Setup::new(input.hoop.parameters(), input.start);
        varies
            .quantities()
            .for_each(|quantity| setup.set(quantity, value));
        Hoop::new(setup.hoop)
            .ok()?
            .simulate(setup.start, limits)
            .ok()
    };
    let mut compared = 0;
    for _ in 0..60 {
        let value = draw.between(axis.from(), axis.to());
        let Some(motion) = simulated(value) else {
            continue;
        };
        let beside = BESIDE * (axis.to() - axis.from());
        let near: Vec<Trajectory> = [-beside, beside]
            .into_iter()
            .filter_map(|by| simulated(value + by))
            .collect();
        let codes = |motion: &Trajectory| -> Vec<_> {
            motion
                .phases()
                .iter()
                .take(8)
                .map(|phase| (phase.mode(), phase.direction()))
                .collect()
        };
        if near.len() < 2
            || near
                .iter()
                .any(|near| codes(near) != codes(&motion) || class(near) != class(&motion))
        {
            continue;
        }
        let what = || {
            format!(
                "{:?}, {:?}, {name} = {value}",
                input.hoop.parameters(),
                input.start
            )
        };
        let of_bands: Vec<&str> = bands
            .iter()
            .filter(|(band, pieces)| *band != "boundary" && winding(pieces, [value, 0.5]) != 0)
            .map(|(band, _)| band.as_str())
            .collect();
        if of_bands != [class(&motion).name()] {
            wrong += 1;
            assert!(
                wrong * 400 <= 4 * 60 * said,
                "{wrong} in 60, {said} in 400: {of_bands:?}, {}",
                what()
            );
            continue;
        }
        let from = motion.start().time;
        let mode_at = |motion: &Trajectory, time: f64| -> Option<&'static str> {
            let i = motion
                .phases()
                .iter()
                .position(|phase| phase.end_time() > time)?;
            let is_told = i < 8;
            Some(if is_told {
                motion.phases()[i].mode().name()
            } else {
                "further phases"
            })
        };
        for _ in 0..8 {
            let time = draw.between(0.0, until);
            let wanted = mode_at(&motion, from + time);
            let beside = BESIDE * until;
            let moves = near.iter().any(|near| mode_at(near, from + time) != wanted)
                || [-beside, beside]
                    .iter()
                    .any(|by| mode_at(&motion, from + time + by) != wanted);
            if moves {
                continue;
            }
            let found: Vec<&str> = times
                .iter()
                .filter(|(series, _)| !["boundary", "transition"].contains(&series.as_str()))
                .filter(|(_, pieces)| {
                    pieces
                        .iter()
                        .any(|piece| winding(std::slice::from_ref(piece), [value, time]) != 0)
                })
                .map(|(series, _)| series.as_str())
                .collect();
            // Motions that repeat for ever do so in the hatched part.
            let wanted = wanted.or_else(|| {
                let goes_on = matches!(
                    motion.outcome().kind(),
                    OutcomeKind::SlipsForever
                        | OutcomeKind::RepeatsForever
                        | OutcomeKind::TransitionLimit
                );
                goes_on.then_some("further phases")
            });
            let wanted = if motion.phases().is_empty() {
                Some("no phase")
            } else {
                wanted
            };
            if found == ["further phases"] && caption.contains("change faster than can be drawn") {
                continue;
            }
            assert_eq!(
                found,
                wanted.into_iter().collect::<Vec<_>>(),
                "at {time}: {}",
                what()
            );
            compared += 1;
        }
    }
    compared
}

#[test]
#[ignore = "thorough"]
fn bifurcations_of_all_cases_are_what_the_simulation_does() {
    let mut draw = Draw(32);
    let find = find_figure("bifurcation").expect("a figure");
    for case in CASES {
        let input = FigureInput::of_case(case.name).expect("a case");
        let restitution = input
            .hoop
            .restitution()
            .map(|_| (Quantity::Restitution, [0.0, 0.95]));
        let lines = [
            (Quantity::Theta, [-3.1, 3.1]),
            (Quantity::ThetaRate, [0.0, 2.4]),
            (Quantity::Slip, [-1.5, 1.5]),
            (Quantity::MuS, [input.hoop.mu_k(), input.hoop.mu_k() + 1.0]),
        ];
        let mut compared = 0;
        for (quantity, range) in lines.into_iter().chain(restitution) {
            let axis = Axis::new(quantity, range[0], range[1], 2).expect("an axis");
            match find.figure(&FigureInput {
                along: Some(axis),
                ..input
            }) {
                Ok(figure) => compared += check_line(&figure, &input, axis, &mut draw),
                Err(FigureError::NoTransition { .. } | FigureError::TooManyBands { .. }) => {}
                Err(other) => panic!("{}: {other}", case.name),
            }
        }
        println!("{}: {compared}", case.name);
        assert!(compared > 200, "{}: {compared}", case.name);
    }
}

#[test]
fn a_start_with_several_motions_says_so() {
    let input = FigureInput::of_case("jam").expect("a case");
    let axis = Axis::new(Quantity::ThetaRate, 0.0, 1.2, 2).expect("an axis");
    let figure = find_figure("bifurcation").expect("a figure");
    let figure = figure
        .figure(&FigureInput {
            along: Some(axis),
            ..input
        })
        .expect("it can be drawn");
    let caption = plain(&figure.caption);
    // 1 − h cos θ θ′² < 0 beyond, with h = 8/9 and θ = ½, so that flight is possible beside sliding
    // with P < 0.
    let bound = libm::sqrt(1.0 / (8.0 / 9.0 * libm::cos(0.5)));
    assert!(
        caption.contains("several motions are consistent (Painlevé paradox)"),
        "{caption}"
    );
    assert!(
        caption.contains(&format!("{bound:.8}")),
        "{bound}: {caption}"
    );
}

#[test]
#[ignore = "thorough"]
fn outcomes_of_all_cases_are_what_the_simulation_does() {
    let mut draw = Draw(33);
    let find = find_figure("outcomes").expect("a figure");
    let with = |name: &str, e: f64| {
        let input = FigureInput::of_case(name).expect("a case");
        let law = littlewood::RestitutionLaw::Energetic;
        let parameters = input.hoop.parameters().with_restitution(e, law);
        FigureInput {
            hoop: Hoop::new(parameters).expect("a hoop"),
            ..input
        }
    };
    let own = CASES
        .iter()
        .map(|case| FigureInput::of_case(case.name).expect("a case"));
    let hoops: Vec<FigureInput> = own
        .chain([0.0, 0.5, 0.9].map(|e| with("figure-3", e)))
        .collect();
    for (i, input) in hoops.iter().enumerate() {
        // Cases of one hoop have one figure.
        if hoops[..i].iter().any(|other| other.hoop == input.hoop) {
            continue;
        }
        let figure = find.figure(input).expect("it can be drawn");
        let regions = table(&figure, "plane", ["theta", "theta_rate"]);
        let axes = axes(&figure.panels[0]);
        let side = axes.map(|axis| axis.range[1] - axis.range[0]);
        let limits = limits(&figure, input.limits);
        let (mut compared, mut jumps, mut wrong) = (0, 0, 0);
        for _ in 0..300 {
            let place = axes.map(|axis| draw.between(axis.range[0], axis.range[1]));
            let seen = |[theta, rate]: [f64; 2]| {
                let motion = input
                    .hoop
                    .simulate(Start::at(theta, rate), limits)
                    .expect("a motion");
                let flies = motion
                    .phases()
                    .iter()
                    .any(|phase| phase.mode() == Mode::Flight);
                (class(&motion), flies)
            };
            let (class, flies) = seen(place);
            let beside = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
            let is_alike = |[a, b]: [f64; 2]| {
                seen([
                    place[0] + a * BESIDE * side[0],
                    place[1] + b * BESIDE * side[1],
                ]) == (class, flies)
            };
            if !beside.into_iter().all(is_alike) {
                continue;
            }
            let found: Vec<&str> = regions
                .iter()
                .filter(|(name, _)| Class::ALL.iter().any(|class| class.name() == *name))
                .filter(|(_, pieces)| winding(pieces, place) != 0)
                .map(|(name, _)| name.as_str())
                .collect();
            wrong += usize::from(found != [class.name()]);
            if input.hoop.restitution().is_some() {
                let is_hatched = regions
                    .get("lifts_off")
                    .is_some_and(|pieces| winding(pieces, place) != 0);
                assert_eq!(
                    is_hatched,
                    flies,
                    "{:?} at {place:?}",
                    input.hoop.parameters()
                );
                jumps += usize::from(flies);
            }
            compared += 1;
        }
        println!(
            "{:?}: {compared} with {jumps} jumps, {wrong} wrong",
            input.hoop.parameters()
        );
        assert!(compared > 100, "{compared}");
        // Where ends change more finely than is drawn the caption has to say so, and how often.
        let caption = plain(&figure.caption);
        let said: Option<usize> = caption
            .split_once(" of 500 other starts ")
            .and_then(|(_, after)| after.split(' ').next())
            .and_then(|count| count.parse().ok());
        assert!(
            wrong == 0 || said.is_some(),
            "{wrong} of {compared}: {caption}"
        );
        // Those next to a boundary, which are not compared here, are more often amiss.
        assert!(
            said.is_none_or(|said| said > 5 && wrong * 500 <= 2 * said * compared),
            "{wrong}: {caption}"
        );
    }
}
