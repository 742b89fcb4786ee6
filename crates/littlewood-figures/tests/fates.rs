//! What the figures of many motions show, read from their tables, against the simulation at random
//! places.

use std::collections::{BTreeMap, BTreeSet};

use crate::random::Draw;
use crate::support::winding;
use littlewood::cases::CASES;
use littlewood::tables::Class;
use littlewood::{Hoop, Limits, Mode, OutcomeKind, Phase, Start, Trajectory};
use littlewood_figures::{Figure, FigureInput, Panel, PlotAxis, View, find_figure, plain};
use littlewood_style::RestingPlace;

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
        OutcomeKind::Rests => Class::Rests,
        OutcomeKind::Unresolved => Class::Unresolved,
        OutcomeKind::Invalid => Class::Invalid,
        OutcomeKind::NotComputed => Class::NotComputed,
    }
}

/// The region of the outcomes to which a motion belongs: its class, or where it rests.
fn region(motion: &Trajectory) -> &'static str {
    match class(motion) {
        Class::Rests => RestingPlace::of(motion.outcome().state().theta).name(),
        other => other.name(),
    }
}

fn is_region(name: &str) -> bool {
    let classes = Class::ALL.iter().map(|class| class.name());
    let places = RestingPlace::ALL.iter().map(|place| place.name());
    classes.chain(places).any(|one| one == name)
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
        // Cases of one hoop have one figure; that of a disc, whose ends do not depend on θ, is refused.
        if input.hoop.h() == 0.0 || hoops[..i].iter().any(|other| other.hoop == input.hoop) {
            continue;
        }
        let figure = find.figure(input).expect("it can be drawn");
        let regions = table(&figure, "plane", ["theta", "theta_rate"]);
        let axes = axes(&figure.panels[0]);
        let side = axes.map(|axis| axis.range.length());
        let limits = limits(&figure, input.limits);
        let (mut compared, mut jumps, mut wrong) = (0, 0, 0);
        let mut mixed = BTreeSet::new();
        for _ in 0..300 {
            let place = axes.map(|axis| draw.between(axis.range.from, axis.range.to));
            let seen = |[theta, rate]: [f64; 2]| {
                let motion = input
                    .hoop
                    .simulate(Start::at(theta, rate), limits)
                    .expect("a motion");
                let flies = motion
                    .phases()
                    .iter()
                    .any(|phase| phase.mode() == Mode::Flight);
                (region(&motion), flies)
            };
            let (region, flies) = seen(place);
            let beside = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
            let is_alike = |[a, b]: [f64; 2]| {
                seen([
                    place[0] + a * BESIDE * side[0],
                    place[1] + b * BESIDE * side[1],
                ]) == (region, flies)
            };
            if !beside.into_iter().all(is_alike) {
                continue;
            }
            // Where outcomes change more finely than is drawn the figure tells none, which is not
            // amiss.
            let is_mixed = regions
                .get("mixed")
                .is_some_and(|pieces| winding(pieces, place) != 0);
            if is_mixed {
                mixed.insert((region, flies));
                compared += 1;
                continue;
            }
            let found: Vec<&str> = regions
                .iter()
                .filter(|(name, _)| is_region(name))
                .filter(|(_, pieces)| winding(pieces, place) != 0)
                .map(|(name, _)| name.as_str())
                .collect();
            wrong += usize::from(found != [region]);
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
        // What is mixed is not one.
        assert!(mixed.len() != 1, "{mixed:?}");
        // Where ends change more finely than is drawn the caption has to say so, and how often.
        let caption = plain(&figure.caption);
        let said: Option<usize> = caption
            .split_once(" of 500 other starts ")
            .and_then(|(_, after)| after.split(' ').next())
            .and_then(|count| count.parse().ok());
        // The caption reports an error rate above 1 %, measured on its own sample of 500 starts. In
        // this sample of 300 starts a rate of 1 % may appear as 2 %.
        assert!(
            wrong * 50 <= compared || said.is_some(),
            "{wrong} of {compared}: {caption}"
        );
        // Those next to a boundary, which are not compared here, are more often amiss.
        assert!(
            said.is_none_or(|said| said > 5 && wrong * 500 <= 2 * said * compared),
            "{wrong}: {caption}"
        );
    }
}
