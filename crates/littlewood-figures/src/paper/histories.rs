//! Forces and energy of a motion against time, with its transitions.

use littlewood::tables::{Dimension, SampleColumn};
use littlewood::{Hoop, Sample, Trajectory, Transition};
use littlewood_draw::{
    Content, Entries, FRICTION_FORCE, Figure, IMPULSE, INK, Label, Layer, Mark, NORMAL_FORCE,
    Panel, Piece, ROOM, SMALL, SOFT, Series, Sheet, Stroke, THEME, marked, short,
};

use crate::columns::{DEMAND, ENERGY, FRICTION, LOST, MU_K, MU_S, NORMAL, TIME};
use crate::error::FigureError;
use crate::impacts;
use crate::input::FigureInput;
use crate::motion::{NOISE, horizon, instants, remark};
use crate::spikes::Spikes;
use crate::timeline::{CLOSE, bare, history, level, names, range_of, transitions, zero};
use crate::wording::Wording;
use littlewood_style::width::{BOLD, CURVE};
use littlewood_style::{Curve, Dash, EnergyPart};

/// Energy that an impact takes.
const DROP: Stroke = Stroke::solid(IMPULSE, BOLD);

const WIDTH: f64 = 640.0;
/// The demand for friction is shown larger where it is less than this part of μk.
const SMALL_SHARE: f64 = 0.1;

/// Normal force, with the room that names take above, and which have none.
fn normal_panel(
    motion: &Trajectory,
    range: [f64; 2],
    normal: Series,
    (say, wide): (Wording, f64),
) -> (Content, f64, Option<String>) {
    let weight = normal_weight(motion.hoop());
    let axis = say.axis(
        NORMAL,
        &marked(SampleColumn::Normal.sign()),
        range_of(&[&normal], &[0.0, weight]),
    );
    let name_of_weight = weight_name(motion.hoop(), &[&normal], range, axis.range);
    let layers = vec![
        transitions(motion, &axis, NORMAL),
        zero(range, NORMAL),
        level(
            range,
            NORMAL_WEIGHT,
            NORMAL,
            weight,
            Stroke::solid(SOFT, 1.0).dashed(Dash::Dotted),
        ),
        normal.drawn(Stroke::solid(NORMAL_FORCE, 2.0)),
    ];
    let names = names(motion, axis.range[1], wide);
    let (height, unnamed) = (names.height, names.note());
    let mut labels = names.labels;
    labels.push(name_of_weight);
    let name = SampleColumn::Normal.long_name();
    (
        Content {
            name,
            x: bare(say, range),
            y: axis,
            layers,
            labels,
        },
        height,
        unnamed,
    )
}

/// Friction force.
fn friction_panel(motion: &Trajectory, range: [f64; 2], say: Wording) -> Content {
    let friction = history(
        motion,
        SampleColumn::Friction.long_name(),
        FRICTION,
        &|_, sample| Some(sample.friction),
    );
    let axis = say.axis(
        FRICTION,
        &marked(SampleColumn::Friction.sign()),
        range_of(&[&friction], &[0.0]),
    );
    let layers = vec![
        transitions(motion, &axis, FRICTION),
        zero(range, FRICTION),
        friction.drawn(Stroke::solid(FRICTION_FORCE, 2.0)),
    ];
    let name = SampleColumn::Friction.long_name();
    Content {
        name,
        x: bare(say, range),
        y: axis,
        layers,
        labels: Vec::new(),
    }
}

/// |F|/N, and |J|/P of impacts.
fn demand_panel(motion: &Trajectory, range: [f64; 2], spikes: &Spikes, say: Wording) -> Content {
    let hoop = motion.hoop();
    let demand = history(
        motion,
        "friction over normal force",
        DEMAND,
        &|phase, sample| {
            let in_contact = phase.mode().has_normal_force();
            (in_contact && sample.normal > 1e-9).then(|| sample.friction.abs() / sample.normal)
        },
    );
    let (mu_s, mu_k) = (hoop.mu_s(), hoop.mu_k());
    let demanded = demand
        .rows()
        .map(|row| row[1])
        .chain(spikes.shares())
        .fold(0.0, f64::max);
    // Of a heavy hoop nothing would be seen beside μs.
    let is_far = demanded > 0.0 && demanded < SMALL_SHARE * mu_k;
    let is_empty = demand.pieces.is_empty() && spikes.impulses.is_empty();
    let highest = if is_far {
        demanded
    } else {
        f64::max(demanded, mu_s)
    };
    // Without friction the axis has a length all the same.
    let highest = if highest > 0.0 { highest } else { 0.1 };
    let axis = say.axis(DEMAND, "|*F*|/*N*", [0.0, 1.25 * highest]);
    let mut layers = vec![
        transitions(motion, &axis, DEMAND),
        demand.drawn(Stroke::solid(INK, 2.0)),
    ];
    let limit = Stroke::of_curve(Curve::SlipLimit).wide(1.2);
    let mut labels = Vec::new();
    if is_empty {
        let middle = [0.5 * (range[0] + range[1]), 0.5 * mu_k];
        labels.push(
            Label::new("nothing to show: *N* = 0", &middle)
                .sized(SMALL)
                .coloured(SOFT),
        );
    }
    if is_far {
        let text = format!("*μ*_{{k}} = {} is above", short(mu_k));
        labels.push(
            Label::new(text, &[range[1], 1.25 * highest])
                .shifted(-8.0, 11.0)
                .right()
                .sized(SMALL),
        );
    } else {
        layers.insert(1, level(range, MU_S, DEMAND, mu_s, limit));
        layers.insert(
            2,
            level(range, MU_K, DEMAND, mu_k, limit.dashed(Dash::Dotted)),
        );
        labels.push(Label::new("*μ*_{s}", &[range[1], mu_s]).shifted(-14.0, -11.0));
    }
    layers.extend(spikes.demands());
    if mu_k < mu_s && !is_far {
        labels.push(Label::new("*μ*_{k}", &[range[1], mu_k]).shifted(-14.0, 11.0));
    }
    Content {
        name: "friction over normal force",
        x: say.clock(range),
        y: axis,
        layers,
        labels,
    }
}

/// Forces and the share of friction against time.
pub(crate) fn forces(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "forces";
    let motion = input.motion_in_contact(NAME)?;
    let range = [motion.start().time, horizon(&motion)];
    let normal = history(
        &motion,
        SampleColumn::Normal.long_name(),
        NORMAL,
        &|_, sample| Some(sample.normal),
    );
    let spikes = Spikes::new(&motion);
    let say = input.wording();
    let sheet = input.sheet(WIDTH)?;
    let [left, inner] = sheet.span();
    let (first, down, unnamed) = normal_panel(&motion, range, normal, (say, inner - ROOM[0]));
    let mut contents = vec![first, friction_panel(&motion, range, say)];
    contents.extend(spikes.panel(&motion, range, say));
    contents.push(demand_panel(&motion, range, &spikes, say));
    // Panels share one axis of times, so that they may be close.
    let height = sheet.height(190.0);
    let tops = |i: usize| 38.0 + down + (height - ROOM[1] + CLOSE) * i as f64;
    let frame = |i: usize| [left, tops(i), inner, height];
    let last = contents.len() - 1;
    let panels = contents
        .into_iter()
        .enumerate()
        .map(|(i, content)| Sheet::panel(frame(i), content))
        .collect();
    let figure = sheet.figure(
        NAME,
        "Forces of a motion",
        format!(
            "Normal force *N*, friction force *F* (positive along `E`_{{1}}) and |*F*|/*N* against time; dashed verticals: transitions. Rolling ends where |*F*|/*N* reaches *μ*_{{s}}, a slide has |*F*|/*N* = *μ*_{{k}}, and the forces \
             jump where a slide begins or ends.{} {}.",
            if spikes.impulses.is_empty() { "" } else { " Spikes: the impulses *P* and *J* of the impacts; dots: |*J*|/*P*." },
            input.in_words()
        ),
        tops(last) + height + 6.0,
        panels,
    );
    Ok(figure.noted(unnamed).noted(remark(&motion, say)))
}

/// Where the energy falls in impacts: from before to after.
fn drops(motion: &Trajectory) -> Option<Layer> {
    let until = horizon(motion);
    let step = |time: f64, before: f64, lost: f64| {
        [before, before - lost]
            .map(|energy| vec![time, energy])
            .to_vec()
    };
    let mut pieces: Vec<Piece> = Vec::new();
    // A jam at the start, which ends no phase.
    if let (Some(transition), Some(phase)) = (motion.transitions().first(), motion.phases().first())
        && let (None, Some(impact)) = (transition.from, transition.impact)
    {
        let lost = impact.energy_lost();
        pieces.push(step(transition.time(), phase.first().energy + lost, lost));
    }
    pieces.extend(motion.phases().iter().filter_map(|phase| {
        let transition = motion
            .end_of(phase)
            .filter(|transition| transition.time() <= until)?;
        Some(step(
            transition.time(),
            phase.last()?.energy,
            transition.impact?.energy_lost(),
        ))
    }));
    (!pieces.is_empty())
        .then(|| Series::new("lost in an impact", &[TIME, ENERGY], pieces).drawn(DROP))
}

/// Name of the level that the normal force has at rest.
pub(super) const NORMAL_WEIGHT: &str = "weight";

/// The weight normal to the plane, m cos α.
pub(super) fn normal_weight(hoop: &Hoop) -> f64 {
    hoop.mass() * libm::cos(hoop.slope())
}

/// What its name takes of the axes, and the part of an axis from which on it stands below its
/// level.
const NAME_SHARES: [f64; 2] = [0.25, 0.2];
const HIGH: f64 = 0.8;

/// Its name, as far to the right as there is no curve of the normal force in its place.
pub(super) fn weight_name(
    hoop: &Hoop,
    normal: &[&Series],
    times: [f64; 2],
    range: [f64; 2],
) -> Label {
    let weight = normal_weight(hoop);
    let text = if hoop.slope() == 0.0 {
        "weight"
    } else {
        "weight × cos α"
    };
    let span = times[1] - times[0];
    let rows = || normal.iter().flat_map(|series| series.rows());
    let is_high = weight > range[0] + HIGH * (range[1] - range[0]);
    let up = NAME_SHARES[1]
        * if is_high {
            range[0] - range[1]
        } else {
            range[1] - range[0]
        };
    let below = |end: &f64| {
        let near = rows().filter(|row| row[0] <= *end && row[0] >= end - NAME_SHARES[0] * span);
        near.filter(|row| (0.0..=1.0).contains(&((row[1] - weight) / up)))
            .count()
    };
    let ends = (4..=16)
        .rev()
        .map(|i| times[0] + span * f64::from(i) / 16.0);
    let end = ends.min_by_key(below).unwrap_or(times[1]);
    let label = Label::new(text, &[end, weight]).shifted(-6.0, if is_high { 9.0 } else { -9.0 });
    label.right().sized(SMALL).coloured(SOFT)
}

/// Energies against time.
pub(crate) fn energy(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "energy";
    let motion = input.motion(NAME)?;
    let hoop = motion.hoop();
    let range = [motion.start().time, horizon(&motion)];
    let potential_of = |sample: &Sample| sample.potential_energy(hoop);
    let total = history(&motion, "total energy", ENERGY, &|_, sample| {
        Some(sample.energy)
    });
    let kinetic = history(&motion, "kinetic energy", ENERGY, &|_, sample| {
        Some(sample.energy - potential_of(sample))
    });
    let potential = history(&motion, "potential energy", ENERGY, &|_, sample| {
        Some(potential_of(sample))
    });
    let say = input.wording();
    let axis = say.axis(
        ENERGY,
        "energy",
        range_of(&[&total, &kinetic, &potential], &[0.0]),
    );
    let drops = drops(&motion);
    let part =
        |part: EnergyPart, dash| Mark::Line(Stroke::solid(part.colour(THEME), CURVE).dashed(dash));
    let marks = [
        Mark::Line(Stroke::solid(INK, 2.2)),
        part(EnergyPart::Kinetic, Dash::Dashed),
        part(EnergyPart::Potential, Dash::DashDot),
    ];
    let words = ["total *E*", "kinetic *T*", "potential *U*"];
    let mut entries: Entries = words
        .into_iter()
        .zip(marks)
        .map(|(text, mark)| (mark, text.to_owned()))
        .collect();
    entries.extend(
        drops
            .as_ref()
            .map(|drops| (drops.mark, EnergyPart::Impacts.label().to_owned())),
    );
    let sheet = input.sheet(WIDTH)?;
    let [left, inner] = sheet.span();
    let names = names(&motion, axis.range[1], inner - ROOM[0]);
    let unnamed = names.note();
    let mut layers = vec![
        transitions(&motion, &axis, ENERGY),
        zero(range, ENERGY),
        potential.drawn(marks[2]),
        kinetic.drawn(marks[1]),
        total.drawn(marks[0]),
    ];
    layers.extend(drops);
    let (keys, room) = sheet.keys(entries, 6.0);
    let (top, height) = (room + 42.0 + names.height, sheet.height(340.0));
    let content = Content {
        name: "energy",
        x: bare(say, range),
        y: axis,
        layers,
        labels: names.labels,
    };
    let panel = Panel {
        keys,
        ..Sheet::panel([left, top, inner, height], content)
    };
    let (below, low) = (top + height - ROOM[1] + CLOSE, sheet.height(150.0));
    let lost = Sheet::panel([left, below, inner, low], lost_panel(&motion, range, say));
    let figure = sheet.figure(
        NAME,
        "Energy of a motion",
        format!(
            "Kinetic, potential (*U* = 0 with the particle at the height of *C*, in contact) and total energy (2.8) \
             against time, and below what has been lost; dashed verticals: transitions. {}. {}.",
            losses(&motion, say),
            input.in_words()
        ),
        below + low + 6.0,
        vec![panel, lost],
    );
    Ok(figure.noted(unnamed).noted(remark(&motion, say)))
}

/// What has been lost since the start, on an axis of its own.
fn lost_panel(motion: &Trajectory, range: [f64; 2], say: Wording) -> Content {
    let drop = |transition: Option<&Transition>| {
        transition
            .and_then(|it| it.impact)
            .map_or(0.0, |it| it.energy_lost())
    };
    let first = motion
        .transitions()
        .first()
        .filter(|transition| transition.from.is_none());
    let mut rows = vec![vec![range[0], 0.0]];
    let mut before = drop(first);
    for phase in motion.phases() {
        let begin = phase.first().energy;
        let own = instants(motion, phase, range[1])
            .iter()
            .map(|sample| vec![sample.state.time, before + begin - sample.energy])
            .collect::<Vec<_>>();
        rows.extend(own);
        before += phase.energy_lost() + drop(motion.end_of(phase));
        rows.push(vec![phase.end_time().min(range[1]), before]);
    }
    rows.retain(|row| row[0] <= range[1] && row[1].is_finite());
    let most = rows.iter().map(|row| row[1]).fold(0.0, f64::max);
    let size = motion
        .phases()
        .first()
        .map_or(1.0, |phase| phase.first().energy.abs().max(1.0));
    // A motion that loses nothing has a flat line.
    let most = if most > NOISE * size {
        1.12 * most
    } else {
        0.1 * size
    };
    let axis = say.axis(LOST, "*E*_{0} − *E*", [-0.08 * most, most]);
    let layers = vec![
        transitions(motion, &axis, LOST),
        zero(range, LOST),
        Series::of_rows("lost", &[TIME, LOST], rows).drawn(Stroke::solid(INK, CURVE)),
    ];
    Content {
        name: "energy lost",
        x: say.clock(range),
        y: axis,
        layers,
        labels: Vec::new(),
    }
}

/// What has cost energy.
fn losses(motion: &Trajectory, say: Wording) -> String {
    let all = motion.energy_lost();
    let energy = |value: f64| say.quantity(value, Dimension::Energy);
    if motion.hoop().restitution().is_none() {
        return format!("Only sliding dissipates energy, {} in all", energy(all));
    }
    let until = horizon(motion);
    let in_impacts: f64 = impacts::all(motion)
        .filter(|(transition, _)| transition.time() <= until)
        .map(|(_, impact)| impact.energy_lost())
        .sum();
    let sliding: f64 = motion
        .phases()
        .iter()
        .filter(|phase| phase.start().time < until)
        .map(littlewood::Phase::energy_lost)
        .sum();
    format!(
        "Sliding costs {}, the impacts {}",
        energy(sliding),
        energy(in_impacts)
    )
}
