//! Forces and energy of a motion against time, with its transitions.

use littlewood::energy::{EnergyLedger, EnergyParts};
use littlewood::tables::{Dimension, SampleColumn};
use littlewood::{Hoop, Phase, Sample, Transition};
use littlewood_draw::{
    Content, FRICTION_FORCE, Figure, IMPULSE, INK, Label, Layer, Mark, NORMAL_FORCE, Piece,
    PlotAxis, SMALL, SOFT, Series, Stroke, THEME, marked, short,
};
use littlewood_style::width::{BOLD, CURVE, FINE};
use littlewood_style::{Curve, Dash, EnergyPart};

use crate::columns::{
    COUPLE, DEMAND, ENERGY, ENERGY_CHANGE, FRICTION, LOST, MU_K, MU_S, NORMAL, TIME,
};
use crate::error::FigureError;
use crate::impacts;
use crate::input::FigureInput;
use crate::motion::{NOISE, Shown};
use crate::spikes::Spikes;
use crate::timeline::{Timeline, range_of, zero_of};

/// Energy that an impact takes.
const DROP: Stroke = Stroke::solid(IMPULSE, BOLD);

const WIDTH: f64 = 640.0;
/// The demand for friction is shown larger where it is less than this part of μk.
const SMALL_SHARE: f64 = 0.1;

/// The weight normal to the plane, m cos α.
pub(super) fn normal_weight(hoop: &Hoop) -> f64 {
    hoop.mass() * libm::cos(hoop.slope())
}

/// What its name takes of the axes, and the part of an axis from which on it stands below its
/// level.
const NAME_SHARES: [f64; 2] = [0.25, 0.2];
const HIGH: f64 = 0.8;

/// The level that the normal force has at rest, and its name as far to the right as there is no
/// curve of the normal force in its place.
pub(super) fn weight_level(
    motion: &Shown,
    normal: &[&Series],
    axis: &PlotAxis,
    width: f64,
) -> (Layer, Label) {
    let [low, high] = axis.range.ends();
    let weight = normal_weight(motion.hoop());
    let text = if motion.hoop().slope() == 0.0 {
        "weight"
    } else {
        "weight × cos α"
    };
    let [from, to] = motion.times();
    let span = to - from;
    let rows = || normal.iter().flat_map(|series| series.rows());
    let is_high = weight > low + HIGH * (high - low);
    let up = NAME_SHARES[1] * if is_high { low - high } else { high - low };
    let below = |end: &f64| {
        let near = rows().filter(|row| row[0] <= *end && row[0] >= end - NAME_SHARES[0] * span);
        near.filter(|row| (0.0..=1.0).contains(&((row[1] - weight) / up)))
            .count()
    };
    let ends = (4..=16).rev().map(|i| from + span * f64::from(i) / 16.0);
    let end = ends.min_by_key(below).unwrap_or(to);
    let label = Label::new(text, &[end, weight]).shifted(-6.0, if is_high { 9.0 } else { -9.0 });
    let stroke = Stroke::solid(SOFT, width).dashed(Dash::Dotted);
    (
        motion.level("weight", NORMAL, weight, stroke),
        label.right().sized(SMALL).coloured(SOFT),
    )
}

fn normal_panel(motion: &Shown) -> Content {
    let name = SampleColumn::Normal.long_name();
    let normal = motion.history(name, NORMAL, |_, sample| Some(sample.normal));
    let weight = normal_weight(motion.hoop());
    let sign = marked(SampleColumn::Normal.sign());
    let zero = zero_of(normal.rows().map(|row| row[1]).chain([weight]));
    let range = range_of([&normal], &[zero.unwrap_or(weight), weight]);
    let y = motion.say.axis(NORMAL, &sign, range);
    let (level, label) = weight_level(motion, &[&normal], &y, 1.0);
    let mut layers = vec![motion.verticals(&y, NORMAL)];
    layers.extend(zero.map(|_| motion.zero(NORMAL)));
    layers.extend([level, normal.drawn(Stroke::solid(NORMAL_FORCE, 2.0))]);
    motion.panel(name, y, layers, vec![label])
}

fn friction_panel(motion: &Shown) -> Content {
    let name = SampleColumn::Friction.long_name();
    let friction = motion.history(name, FRICTION, |_, sample| Some(sample.friction));
    let sign = marked(SampleColumn::Friction.sign());
    let y = motion
        .say
        .axis(FRICTION, &sign, range_of([&friction], &[0.0]));
    let mut layers = motion.ground(&y, FRICTION);
    layers.push(friction.drawn(Stroke::solid(FRICTION_FORCE, 2.0)));
    motion.panel(name, y, layers, Vec::new())
}

/// The couple of rolling resistance, and ±χN, which it does not exceed.
fn couple_panel(motion: &Shown) -> Content {
    let name = SampleColumn::Couple.long_name();
    let chi = motion.hoop().rolling_resistance();
    let couple = motion.history(name, COUPLE, |_, sample| Some(sample.couple));
    let sign = marked(SampleColumn::Couple.sign());
    let bound = |sign: f64| {
        let value = |_: &Phase, sample: &Sample| Some(sign * chi * sample.normal);
        motion.history("limit of the couple", COUPLE, value)
    };
    let bounds = [bound(1.0), bound(-1.0)];
    let [upper, lower] = &bounds;
    let y = motion
        .say
        .axis(COUPLE, &sign, range_of([&couple, upper, lower], &[0.0]));
    let mut layers = motion.ground(&y, COUPLE);
    let limit = Stroke::solid(SOFT, FINE).dashed(Dash::Dotted);
    layers.extend(bounds.map(|series| series.drawn(limit)));
    let colour = EnergyPart::RollingResistance.colour(THEME);
    layers.push(couple.drawn(Stroke::solid(colour, 2.0)));
    motion.panel(name, y, layers, Vec::new())
}

/// A contact that takes less than this part of the time is not seen.
const SEEN: f64 = 1.0 / 200.0;

/// |F|/N, and |J|/P of impacts; none where no contact is long enough to be seen.
fn demand_panel(motion: &Shown, spikes: &Spikes) -> Option<Content> {
    const NAME: &str = "friction over normal force";
    let demand = motion.history(NAME, DEMAND, |phase, sample| {
        let in_contact = phase.mode().has_normal_force();
        (in_contact && sample.normal > 1e-9).then(|| sample.friction.abs() / sample.normal)
    });
    let (mu_s, mu_k) = (motion.hoop().mu_s(), motion.hoop().mu_k());
    let demanded = demand.rows().map(|row| row[1]);
    let demanded = demanded.chain(spikes.shares()).fold(0.0, f64::max);
    // Of a heavy hoop nothing would be seen beside μs.
    let is_far = demanded > 0.0 && demanded < SMALL_SHARE * mu_k;
    let [from, to] = motion.times();
    let is_seen = |piece: &Piece| {
        let ends = [piece.first(), piece.last()].map(|row| row.map_or(0.0, |row| row[0]));
        ends[1] - ends[0] > SEEN * (to - from)
    };
    if spikes.impulses.is_empty() && !demand.pieces.iter().any(is_seen) {
        return None;
    }
    let highest = if is_far {
        demanded
    } else {
        f64::max(demanded, mu_s)
    };
    // Without friction the axis has a length all the same.
    let highest = if highest > 0.0 { highest } else { 0.1 };
    let y = motion
        .say
        .axis(DEMAND, "|*F*|/*N*", [0.0, 1.25 * highest].into());
    let mut layers = vec![motion.verticals(&y, DEMAND)];
    let mut labels = Vec::new();
    if is_far {
        let text = format!("*μ*_{{k}} = {} is above", short(mu_k));
        let label = Label::new(text, &[to, 1.25 * highest]).shifted(-8.0, 11.0);
        labels.push(label.right().sized(SMALL));
    } else {
        let limit = Stroke::of_curve(Curve::SlipLimit).wide(1.2);
        layers.push(motion.level(MU_S, DEMAND, mu_s, limit));
        layers.push(motion.level(MU_K, DEMAND, mu_k, limit.dashed(Dash::Dotted)));
        labels.push(Label::new("*μ*_{s}", &[to, mu_s]).shifted(-14.0, -11.0));
        if mu_k < mu_s {
            labels.push(Label::new("*μ*_{k}", &[to, mu_k]).shifted(-14.0, 11.0));
        }
    }
    layers.push(demand.drawn(Stroke::solid(INK, 2.0)));
    layers.extend(spikes.demands());
    Some(motion.panel(NAME, y, layers, labels))
}

/// Forces and the share of friction against time.
pub(crate) fn forces(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "forces";
    let motion = input.motion_in_contact(NAME)?;
    let spikes = Spikes::new(&motion);
    let sheet = input.sheet(WIDTH)?;
    let mut contents = vec![normal_panel(&motion), friction_panel(&motion)];
    let resists = motion.hoop().rolling_resistance() > 0.0;
    contents.extend(resists.then(|| couple_panel(&motion)));
    contents.extend(spikes.panel(&motion));
    let demand = demand_panel(&motion, &spikes);
    let is_short = demand
        .is_none()
        .then(|| "|*F*|/*N* has no panel: contacts are too short to be seen.".to_owned());
    contents.extend(demand);
    let caption = format!(
        "Normal force *N*, friction force *F* (positive along `E`_{{1}}) and |*F*|/*N* against time; dashed verticals: transitions. Rolling ends where |*F*|/*N* reaches *μ*_{{s}}, a slide has |*F*|/*N* = *μ*_{{k}}, and the forces \
         jump where a slide begins or ends.{}{} {}.",
        if resists {
            " *M*: couple of rolling resistance against the rotation, at most *χN* (dotted); it jumps where the hoop turns back."
        } else {
            ""
        },
        if spikes.impulses.is_empty() {
            ""
        } else {
            " Spikes: the impulses *P* and *J* of the impacts; dots: |*J*|/*P*."
        },
        input.in_words()
    );
    let timeline = Timeline {
        name: NAME,
        title: "Forces of a motion",
        caption,
        keys: Vec::new(),
        contents,
        height: &|_| sheet.height(190.0),
    };
    Ok(motion.figure(&sheet, timeline).noted(is_short))
}

/// What the impacts of some transitions take.
fn lost_in(transitions: &[Transition]) -> f64 {
    let impacts = transitions.iter().filter_map(|it| it.impact);
    impacts.fold(0.0, |lost, impact| lost + impact.energy_lost())
}

/// Where the energy falls in impacts: from before to after.
fn drops(motion: &Shown) -> Option<Layer> {
    let step = |time: f64, before: f64, lost: f64| [[time, before], [time, before - lost]];
    let mut pieces: Vec<[[f64; 2]; 2]> = Vec::new();
    for index in 0..=motion.phases().len() {
        let transitions = motion.leading_to(index);
        let ended = index.checked_sub(1).map(|before| &motion.phases()[before]);
        let Some(mut energy) = (match ended {
            Some(phase) => phase.last().map(|sample| sample.energy),
            None => {
                let first = motion.phases().first();
                first.map(|phase| phase.first().energy + lost_in(transitions))
            }
        }) else {
            continue;
        };
        for transition in transitions {
            let Some(impact) = transition
                .impact
                .filter(|_| transition.time() <= motion.until)
            else {
                continue;
            };
            let lost = impact.energy_lost();
            pieces.push(step(transition.time(), energy, lost));
            energy -= lost;
        }
    }
    (!pieces.is_empty())
        .then(|| Series::new("lost in an impact", &[TIME, ENERGY], pieces).drawn(DROP))
}

/// Energies that change by less than this part of the largest of them are shown from the start on.
const SMALL_CHANGE: f64 = 0.05;

/// The lowest and the highest value of the second column.
fn ends_of(series: &Series) -> [f64; 2] {
    let values = series.rows().map(|row| row[1]);
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    })
}

/// Some energies less what each was at the start, and these values, if they hardly change.
fn changes(energies: &mut [Series; 3]) -> Option<[f64; 3]> {
    let ends = energies.each_ref().map(ends_of);
    let size = ends
        .iter()
        .flatten()
        .fold(0.0, |size, end| end.abs().max(size));
    let change = ends
        .iter()
        .map(|[low, high]| high - low)
        .fold(0.0, f64::max);
    if !(NOISE * size..SMALL_CHANGE * size).contains(&change) {
        return None;
    }
    Some(energies.each_mut().map(|series| {
        let first = series.rows().next().map_or(0.0, |row| row[1]);
        from_value(series, first);
        // A rest of rounding is nothing.
        if first.abs() < NOISE * size {
            0.0
        } else {
            first
        }
    }))
}

/// A series of energies less a value.
fn from_value(series: &mut Series, value: f64) {
    series.columns[1] = ENERGY_CHANGE.into();
    for row in series.pieces.iter_mut().flatten() {
        row[1] -= value;
    }
}

/// What is noted of energies that are drawn from the start on.
fn said(motion: &Shown, starts: [f64; 3]) -> String {
    let [total, kinetic, potential] =
        starts.map(|value| motion.say.value(value, Dimension::Energy));
    format!(
        "Energies are drawn from the start on, where *E* = {total}, *T* = {kinetic}, *U* = {potential}."
    )
}

/// The energies, with what their lines mean, and what is noted of them.
fn energy_panel(motion: &Shown) -> (Content, Vec<(Mark, String)>, Option<String>) {
    let history = |name, value: &dyn Fn(&Sample) -> f64| {
        motion.history(name, ENERGY, |_, sample| Some(value(sample)))
    };
    let potential_of = |sample: &Sample| sample.potential_energy(motion.hoop());
    let mut energies = [
        history("total energy", &|sample| sample.energy),
        history("kinetic energy", &|it| it.energy - potential_of(it)),
        history("potential energy", &potential_of),
    ];
    let mut drops = drops(motion);
    let starts = changes(&mut energies);
    if let (Some([total, ..]), Some(drops)) = (starts, &mut drops) {
        from_value(&mut drops.series, total);
    }
    let [total, kinetic, potential] = energies;
    let lost_at_once = drops.iter().map(|layer| &layer.series);
    let range = range_of(
        [&total, &kinetic, &potential]
            .into_iter()
            .chain(lost_at_once),
        &[0.0],
    );
    let (column, title) = match starts {
        None => (ENERGY, "energy"),
        Some(_) => (ENERGY_CHANGE, "change of energy"),
    };
    let y = motion.say.axis(column, title, range);
    let part =
        |part: EnergyPart, dash| Mark::Line(Stroke::solid(part.colour(THEME), CURVE).dashed(dash));
    let lines = [
        (total, Mark::Line(Stroke::solid(INK, 2.2)), "total *E*"),
        (
            kinetic,
            part(EnergyPart::Kinetic, Dash::Dashed),
            "kinetic *T*",
        ),
        (
            potential,
            part(EnergyPart::Potential, Dash::DashDot),
            "potential *U*",
        ),
    ];
    let mut keys: Vec<(Mark, String)> = lines
        .iter()
        .map(|(_, mark, words)| (*mark, (*words).to_owned()))
        .collect();
    let mut layers = motion.ground(&y, column);
    // The total above its parts.
    let drawn = lines.into_iter().rev();
    layers.extend(drawn.map(|(series, mark, _)| series.drawn(mark)));
    if let Some(drops) = drops {
        keys.push((drops.mark, EnergyPart::Impacts.label().to_owned()));
        layers.push(drops);
    }
    let note = starts.map(|starts| said(motion, starts));
    (motion.panel("energy", y, layers, Vec::new()), keys, note)
}

/// Energies against time.
pub(crate) fn energy(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "energy";
    let motion = input.motion(NAME)?;
    let sheet = input.sheet(WIDTH)?;
    let (energies, mut keys, note) = energy_panel(&motion);
    let parts = lost_parts(&motion);
    let lost = lost_panel(&motion, &parts);
    for (_, mark, words) in &parts {
        // Drops of the energy have the key of what is lost in impacts.
        keys.retain(|(_, own)| own != words);
        keys.push((*mark, (*words).to_owned()));
    }
    let caption = format!(
        "Kinetic, potential (*U* = 0 with the particle at the height of *C*, in contact) and total energy (2.8) \
         against time{}; dashed verticals: transitions. {}. {}.",
        if lost.is_some() {
            ", and below what has been lost"
        } else {
            ""
        },
        losses(&motion),
        input.in_words()
    );
    let nothing = lost.is_none().then(|| "No energy is lost.".to_owned());
    let timeline = Timeline {
        name: NAME,
        title: "Energy of a motion",
        caption,
        keys,
        contents: [energies].into_iter().chain(lost).collect(),
        height: &|i| sheet.height([340.0, 178.0][i]),
    };
    Ok(motion.figure(&sheet, timeline).noted(note).noted(nothing))
}

/// Rounding of what a phase loses that is not seen, in parts of all.
const ROUNDED: f64 = 0.02;

/// What has been lost since the start in all, by the place of each instant.
fn lost_in_all(motion: &Shown) -> Vec<[f64; 2]> {
    let [from, until] = motion.times();
    let mut rows = vec![[from, 0.0]];
    let mut before = lost_in(motion.leading_to(0));
    for (index, phase) in motion.phases().iter().enumerate() {
        let begin = phase.first().energy;
        let mut samples = motion.instants(phase);
        // What a phase has taken lies between nothing and what it takes in all. What is beyond is
        // rounding: where this is not small, only the ends are known.
        let all = phase.energy_lost();
        let lost = |it: &Sample| begin - it.energy;
        let beyond = |it: &Sample| lost(it).max(all - lost(it)) - all;
        if samples.iter().any(|it| beyond(it) > ROUNDED * all) {
            let inner = 1..samples.len().saturating_sub(1).max(1);
            samples.drain(inner);
        }
        let row = |it: &Sample| [it.state.time, before + lost(it).max(0.0).min(all)];
        rows.extend(samples.iter().map(row));
        // Of a phase that is cut not all is lost yet.
        if phase.end_time() > until {
            break;
        }
        before += phase.energy_lost() + lost_in(motion.leading_to(index + 1));
        rows.push([phase.end_time(), before]);
    }
    rows.retain(|row| row[0] <= until && row[1].is_finite());
    rows
}

/// The parts of what has been lost, of a motion with rolling resistance, with what they mean: those
/// that there are.
fn lost_parts(motion: &Shown) -> Vec<(Series, Mark, &'static str)> {
    if motion.hoop().rolling_resistance() == 0.0 {
        return Vec::new();
    }
    let Some(ledger) = EnergyLedger::new(motion) else {
        return Vec::new();
    };
    let phases = motion.phases().iter();
    let samples: Vec<Sample> = phases.flat_map(|phase| motion.instants(phase)).collect();
    let parts: Vec<(f64, EnergyParts)> = samples
        .iter()
        .filter_map(|sample| Some((sample.state.time, ledger.parts(sample)?)))
        .collect();
    let lost = [
        (EnergyPart::RollingResistance, Dash::DashDotDot),
        (EnergyPart::Friction, Dash::Short),
        (EnergyPart::Impacts, Dash::Dotted),
    ];
    let series = lost.map(|(part, dash)| {
        let rows = parts.iter().map(|(time, parts)| [*time, part.of(parts)]);
        let stroke = Stroke::solid(part.colour(THEME), CURVE).dashed(dash);
        let series = Series::of_rows(part.name(), &[TIME, LOST], rows);
        (series, Mark::Line(stroke), part.label())
    });
    let is_there = |it: &(Series, Mark, &str)| it.0.rows().any(|row| row[1] != 0.0);
    series.into_iter().filter(is_there).collect()
}

/// The panel of the energy lost since the start, if any is.
fn lost_panel(motion: &Shown, parts: &[(Series, Mark, &'static str)]) -> Option<Content> {
    let rows = lost_in_all(motion);
    let most = rows.iter().map(|row| row[1]).fold(0.0, f64::max);
    let size = motion
        .phases()
        .first()
        .map_or(1.0, |phase| phase.first().energy.abs().max(1.0));
    if most <= NOISE * size {
        return None;
    }
    let top = 1.12 * most;
    let y = motion
        .say
        .axis(LOST, "*E*_{0} − *E*", [-0.08 * top, top].into());
    let mut layers = motion.ground(&y, LOST);
    layers.push(Series::of_rows("lost", &[TIME, LOST], rows).drawn(Stroke::solid(INK, CURVE)));
    let parts = parts.iter();
    layers.extend(parts.map(|(series, mark, _)| series.clone().drawn(*mark)));
    Some(motion.panel("energy lost", y, layers, Vec::new()))
}

/// What has cost energy.
fn losses(motion: &Shown) -> String {
    let energy = |value: f64| motion.say.quantity(value, Dimension::Energy);
    let resists = motion.hoop().rolling_resistance() > 0.0;
    if !motion.goes_on() {
        let resistance = motion.rolling_resistance_energy_lost();
        let sliding = energy(motion.energy_lost() - resistance);
        return if resists {
            format!(
                "Rolling resistance takes {}, sliding {sliding} in all",
                energy(resistance)
            )
        } else {
            format!("Only sliding dissipates energy, {sliding} in all")
        };
    }
    let in_impacts: f64 = impacts::all(motion)
        .filter(|(transition, _)| transition.time() <= motion.until)
        .map(|(_, impact)| impact.energy_lost())
        .sum();
    let phases = || {
        let phases = motion.phases().iter();
        phases.filter(|phase| phase.start().time < motion.until)
    };
    let resistance: f64 = phases().map(Phase::rolling_resistance_energy_lost).sum();
    let lost: f64 = phases().map(Phase::energy_lost).sum();
    let resisted = if resists {
        format!(", rolling resistance {}", energy(resistance))
    } else {
        String::new()
    };
    format!(
        "Sliding costs {}{resisted}, the impacts {}",
        energy(lost - resistance),
        energy(in_impacts)
    )
}
