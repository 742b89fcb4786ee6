//! Figures 3(a) and 7(a): a motion in the space of states.

use core::f64::consts::PI;

use littlewood::tables::Dimension;
use littlewood::{Cause, Mode, Sample, State, Transition};
use littlewood_draw::{
    Content, FAINT, FRICTION_FORCE, Figure, IMPULSE, Label, Layer, Mark, NORMAL_FORCE, PAPER,
    Panel, Piece, REGION, SMALL, SOFT, START, Series, Sheet, Stroke, TRANSITION, View, short,
};

use crate::columns::{SLIP, THETA, THETA_RATE, TIME};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{
    add_unbounded_end, all_instants, arrows, bounds, by_mode, horizon, lines, remark,
};
use crate::plane::{Portrait, unloading_lines};
use crate::timeline::VERTICAL;
use crate::wording::Wording;
use littlewood::theory::Window;
use littlewood_style::width::{BOLD, CURVE, FINE};
use littlewood_style::{Curve, Dash};

/// Arrows of time stand where the motion goes this part of the axes.
const LEAST_STEP: f64 = 0.006;
pub(super) const COLUMNS: [&str; 4] = [TIME, THETA, THETA_RATE, SLIP];

pub(super) fn of_state(state: State) -> Vec<f64> {
    vec![state.time, state.theta, state.theta_rate, state.slip]
}

pub(super) fn row(sample: &Sample) -> Vec<f64> {
    of_state(sample.state)
}

/// Figure 3(a).
pub(crate) fn space(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-3a";
    input.with_inertia(NAME)?;
    let motion = input.motion_in_contact(NAME)?;
    let until = horizon(&motion);
    // Before the lift-off only, as in the paper, unless the motion goes on after the landing.
    let goes_on = motion.hoop().restitution().is_some();
    let on_ground: Vec<(Mode, Series)> = by_mode(&motion, "", &COLUMNS, &row)
        .into_iter()
        .filter(|(mode, _)| mode.touches_plane() || goes_on)
        .collect();
    let all = || on_ground.iter().flat_map(|(_, series)| series.rows());
    let x = bounds(all().map(|row| row[1]), 0.06);
    let z = bounds(all().map(|row| row[2]), 0.12);
    let y = bounds(all().map(|row| row[3]).chain([0.0]), 0.12);

    let floor = [[x[0], z[0]], [x[1], z[0]], [x[1], z[1]], [x[0], z[1]]];
    let floor = floor.map(|[theta, rate]| vec![theta, rate, 0.0]).to_vec();
    let mut outline = floor.clone();
    outline.push(floor[0].clone());
    let names = [THETA, THETA_RATE, SLIP];
    let mut layers = vec![
        Series::of_rows("plane of rolling", &names, floor)
            .drawn(Mark::Fill(REGION.over(PAPER, 0.6))),
        Series::of_rows("plane of rolling", &names, outline).drawn(Stroke::solid(FAINT, FINE)),
    ];
    // The shadow of the motion on the plane of rolling.
    for (mode, series) in &on_ground {
        if *mode == Mode::Sliding {
            let pieces = series
                .pieces
                .iter()
                .map(|piece| piece.iter().map(|row| vec![row[1], row[2], 0.0]).collect());
            let stroke = Stroke::solid(FAINT, 1.0).dashed(Dash::Short);
            layers.push(Series::new("shadow", &names, pieces.collect()).drawn(stroke));
        }
    }
    let mut labels = Vec::new();
    layers.extend(lines(on_ground, BOLD));
    for phase in motion.phases() {
        let (letter, share) = match phase.mode() {
            Mode::Sliding => ("*s*", 0.5),
            Mode::Rolling => ("*r*", 0.75),
            Mode::Gliding | Mode::Flight => continue,
        };
        let middle = phase
            .sample(share * f64::min(phase.duration(), until - phase.start().time))
            .state;
        let shift = match middle.slip {
            slip if slip < 0.0 => [13.0, 12.0],
            0.0 => [4.0, 14.0],
            _ => [-14.0, -6.0],
        };
        let label = Label::new(letter, &[middle.theta, middle.slip, middle.theta_rate]);
        labels.push(Label { shift, ..label }.coloured(Stroke::of_mode(phase.mode()).colour));
    }
    // Arrows of time where the motion is seen to move.
    let far = |rows: &[Vec<f64>]| {
        let steps = [x, z, y]
            .into_iter()
            .zip(1..)
            .map(|(range, i)| (rows[1][i] - rows[0][i]) / (range[1] - range[0]));
        steps.map(|step: f64| step * step).sum::<f64>() > LEAST_STEP * LEAST_STEP
    };
    let is_seen = |mode: Mode, rows: &[Vec<f64>]| (mode.touches_plane() || goes_on) && far(rows);
    layers.extend(arrows(&motion, 0.62, &COLUMNS, &row, is_seen));
    let (mut changes, mut jumps) = (Vec::new(), Vec::new());
    for transition in motion.transitions() {
        let state = transition.before;
        if (transition.cause == Cause::Landing && !goes_on) || state.time > until {
            continue;
        }
        changes.push(of_state(state));
        if transition.impact.is_some() {
            changes.push(of_state(transition.after));
            jumps.push(vec![of_state(state), of_state(transition.after)]);
        } else if transition.to.is_some_and(|mode| !mode.touches_plane()) {
            labels.push(
                Label::new("*L*", &[state.theta, state.slip, state.theta_rate]).shifted(13.0, -3.0),
            );
        }
    }
    let jump = Stroke::solid(IMPULSE, CURVE).dashed(Dash::Short);
    let has_jumps = !jumps.is_empty();
    if has_jumps {
        layers.push(Series::new("impact", &COLUMNS, jumps).drawn(jump));
    }
    layers.push(Series::of_rows("transition", &COLUMNS, changes).drawn(TRANSITION));
    layers.push(Series::of_rows("start", &COLUMNS, vec![of_state(motion.start())]).drawn(START));
    let say = input.wording();
    let caption = format!(
        "The motion in the space of *θ*, *θ*′ and the slip velocity *η*′: sliding (*s*), rolling (*r*) in the plane \
         *η*′ = 0, lift-off (*L*).{} Arrows: time; cross: start; diamonds: transitions; grey: shadow of the sliding parts on the plane of \
         rolling. {}. The zeros of *η*′ are located, not found by a threshold of \
         10^{{−9}} as in §2(c) of the paper.",
        if has_jumps {
            " Light: flight, in which *η*′ is the velocity of the lowest point of the rim; red: impacts, in which *θ*′ and \
             *η*′ jump."
        } else {
            ""
        },
        input.in_words()
    );
    let title = "Figure 3(a): the motion in the space of states";
    let figure = in_space(input, [x, y, z], (NAME, title, caption), (layers, labels))?;
    Ok(figure.noted(remark(&motion, say)))
}

/// A figure of the space of states: θ across, η′ upwards, θ′ to the back.
pub(super) fn in_space(
    input: &FigureInput,
    [x, y, z]: [[f64; 2]; 3],
    (name, title, caption): (&'static str, &'static str, String),
    (layers, mut labels): (Vec<Layer>, Vec<Label>),
) -> Result<Figure, FigureError> {
    let say = input.wording();
    let axes = [say.angle(x), say.slip(y), say.rate(z)];
    let [across, upwards, back] = &axes;
    labels.insert(
        0,
        Label::new("*η*′ = 0", &[x[1], 0.0, z[1]])
            .shifted(-34.0, 14.0)
            .coloured(SOFT),
    );
    labels.push(Label::new(&across.title, &[0.5 * (x[0] + x[1]), y[0], z[1]]).shifted(-16.0, 38.0));
    labels.push(Label::new(&back.title, &[x[1], y[0], 0.5 * (z[0] + z[1])]).shifted(52.0, 26.0));
    labels.push(Label::new(&upwards.title, &[x[0], y[1], z[0]]).shifted(0.0, -18.0));
    let sheet = input.sheet(620.0)?;
    let height = sheet.height(480.0);
    let [x, y, z] = axes;
    let panel = Panel {
        image: None,
        name: "space of states",
        frame: [0.0, 0.0, sheet.width, height],
        view: View::Space {
            x,
            y,
            z,
            yaw: 0.55,
            pitch: 0.32,
        },
        layers,
        labels,
        keys: Vec::new(),
    };
    Ok(sheet.figure(name, title, caption, height, vec![panel]))
}

/// Rows of the names of transitions.
const ROWS: u32 = 3;
/// Least width of panels that stand beside each other.
const NARROWEST: f64 = 300.0;

/// A transition and its time, with the symbols of §3: τ_s where static friction gives way, τ_g
/// where the particle reaches the plane.
fn instant(transition: &Transition, say: Wording) -> String {
    let time = say.value(transition.time(), Dimension::Time);
    let clock = say.time();
    match transition.cause {
        Cause::Slip => format!("{clock}_{{s}} = {time}"),
        Cause::ParticleAtPlane => format!("{clock}_{{g}} = {time}"),
        other => format!("{} at {clock} = {time}", other.label()),
    }
}

/// Figure 7(a).
pub(crate) fn gliding(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-7a";
    input.littlewood(NAME)?;
    input.level(NAME)?;
    let motion = input.motion(NAME)?;
    let window = Window {
        x: [-PI, PI],
        y: [-2.5, 2.5],
    };
    let portrait = Portrait::new(&input.hoop, window);
    let theta_s = 2.0 * libm::atan(input.hoop.mu_s());
    let mut modes = by_mode(&motion, "", &COLUMNS, &row);
    add_unbounded_end(&motion, &mut modes, &row);
    let mut plane = vec![portrait.rolling_region().drawn(Mark::Fill(REGION))];
    plane.push(unloading_lines(theta_s).drawn(Stroke::of_curve(Curve::NormalForceZero).wide(1.2)));
    if let Some((_, limit)) = portrait.massless_limit() {
        plane.push(limit.drawn(Stroke::of_curve(Curve::SlipLimit).wide(1.2)));
    }
    let mut trace = vec![
        Series::of_rows(
            "zero",
            &[TIME, SLIP],
            vec![vec![motion.start().time, 0.0], vec![horizon(&motion), 0.0]],
        )
        .drawn(Stroke::solid(SOFT, FINE)),
    ];
    let mut labels = vec![
        Label::new("𝓡", &[-0.6 * theta_s, -0.6]).sized(20.0),
        Label::new("*n*", &[-0.4 * theta_s, 1.0])
            .shifted(0.0, -11.0)
            .coloured(NORMAL_FORCE),
    ];
    if portrait.massless_limit().is_some() {
        labels.push(
            Label::new("*f*", &[-theta_s, 0.0])
                .shifted(-10.0, 0.0)
                .coloured(FRICTION_FORCE),
        );
    }
    for (mode, series) in &modes {
        let mark = Mark::Line(Stroke::of_mode(*mode).wide(BOLD));
        plane.push(series.clone().drawn(mark).marked_beyond());
        if let Some(middle) = series
            .pieces
            .first()
            .and_then(|piece| piece.get(piece.len() / 2))
        {
            let label = Label::new(mode.name(), &[middle[1], middle[2]])
                .coloured(Stroke::of_mode(*mode).colour);
            labels.push(match mode {
                Mode::Rolling => label.shifted(-4.0, 14.0),
                Mode::Sliding | Mode::Gliding | Mode::Flight => label.shifted(-10.0, -8.0).right(),
            });
        }
    }
    let until = horizon(&motion);
    // η′ is finite where θ′ is not: at the end of a glide.
    let slips: Vec<(Mode, Piece)> = motion
        .phases()
        .iter()
        .map(|phase| {
            let rows = all_instants(&motion, phase, until)
                .into_iter()
                .map(|sample| sample.state);
            (
                phase.mode(),
                rows.map(|state| vec![state.time, state.slip]).collect(),
            )
        })
        .collect();
    let range = bounds(
        slips
            .iter()
            .flat_map(|(_, rows)| rows.iter().map(|row| row[1])),
        0.1,
    );
    for (mode, rows) in slips {
        let stroke = Stroke::of_mode(mode).wide(BOLD);
        trace.push(Series::of_rows(mode.name(), &[TIME, SLIP], rows).drawn(stroke));
    }
    let say = input.wording();
    let mut trace_labels = Vec::new();
    for (transition, row) in motion.transitions().iter().zip((0..ROWS).cycle()) {
        let time = transition.time();
        let vertical = range.map(|slip| vec![time, slip]).to_vec();
        trace.push(Series::of_rows("time of transition", &[TIME, SLIP], vertical).drawn(VERTICAL));
        // Above the panel, where no curve is, in rows.
        let label = Label::new(instant(transition, say), &[time, range[1]])
            .sized(SMALL)
            .fixed();
        let label = label.shifted(0.0, -10.0 - 16.0 * f64::from(row));
        let part = (time - motion.start().time) / (until - motion.start().time);
        trace_labels.push(match part {
            part if part < 0.2 => label.left(),
            part if part > 0.8 => label.right(),
            _ => label,
        });
    }
    let changes: Piece = motion
        .transitions()
        .iter()
        .map(|transition| of_state(transition.before))
        .filter(|row| row[2].is_finite())
        .collect();
    plane.extend(arrows(&motion, 0.5, &COLUMNS, &row, |_, _| true));
    plane.push(Series::of_rows("transition", &COLUMNS, changes.clone()).drawn(TRANSITION));
    plane.push(Series::of_rows("start", &COLUMNS, vec![of_state(motion.start())]).drawn(START));
    let ends = motion
        .transitions()
        .last()
        .is_some_and(|last| last.cause == Cause::ParticleAtPlane);
    let times = if ends {
        " As *τ* → *τ*_{g}, *θ* → ±π and *θ*′ → ±∞, but *η*′ remains finite."
    } else {
        ""
    };
    // Where the slip changes its direction gliding goes on.
    let mut modes: Vec<&str> = motion
        .phases()
        .iter()
        .map(|phase| phase.mode().name())
        .collect();
    modes.dedup();
    let caption = format!(
        "A massless hoop: {}. First: in the phase plane, with 𝓡 shaded. Second: slip velocity *η*′, zero while \
         the hoop rolls; dashed verticals: transitions.{times} *μ*_{{s}} = {}; {}. Gliding follows (3.17) with \
         the corrected integral.",
        modes.join(", then "),
        short(input.hoop.mu_s()),
        say.start(motion.hoop(), &input.start)
    );
    let from = motion.start().time;
    let above = 12.0 + 16.0 * f64::from(ROWS.min(motion.transitions().len() as u32));
    let contents = [
        Content {
            name: "phase plane",
            x: say.angle(window.x),
            y: say.rate(window.y),
            layers: plane,
            labels,
        },
        Content {
            name: "slip velocity",
            x: say.clock([from, horizon(&motion)]),
            y: say.slip(range),
            layers: trace,
            labels: trace_labels,
        },
    ];
    let sheet = input.sheet(860.0)?;
    let [left, inner] = sheet.span();
    let height = sheet.height(362.0);
    let frames = match sheet.columns::<2>(NARROWEST) {
        Some((lefts, each)) => lefts.map(|left| [left, above, each, height]),
        None => [12.0, 12.0 + height + above].map(|top| [left, top, inner, height]),
    };
    let bottom = frames[1][1] + height + 6.0;
    let panels = frames
        .into_iter()
        .zip(contents)
        .map(|(frame, content)| Sheet::panel(frame, content))
        .collect();
    Ok(sheet.figure(
        NAME,
        "Figure 7(a): rolling, then gliding",
        caption,
        bottom,
        panels,
    ))
}
