//! Figures 3(a) and 7(a): a motion in the space of states.

use core::f64::consts::TAU;

use littlewood::tables::Dimension;
use littlewood::{Cause, Mode, Sample, State, Transition};
use littlewood_draw::{
    Content, FAINT, FRICTION_FORCE, Figure, IMPULSE, Label, Layer, Mark, NORMAL_FORCE, PAPER,
    Panel, PanelFrame, REGION, SMALL, SOFT, START, Series, Sheet, Stroke, TRANSITION, View, short,
};
use littlewood_style::width::{BOLD, CURVE, FINE};
use littlewood_style::{Curve, Dash};

use crate::axes::littlewood_window;
use crate::columns::{SLIP, THETA, THETA_RATE, TIME};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{Modes, Shown, bounds};
use crate::plane::{Portrait, unloading_lines};
use crate::timeline::VERTICAL;
use crate::wording::Wording;

/// Arrows of time stand where the motion goes this part of the axes.
const LEAST_STEP: f64 = 0.006;
const COLUMNS: [&str; 4] = [TIME, THETA, THETA_RATE, SLIP];
/// The impacts of Figure 3(a).
const JUMP: Stroke = Stroke::solid(IMPULSE, CURVE).dashed(Dash::Short);

const fn of_state(state: State) -> [f64; 4] {
    [state.time, state.theta, state.theta_rate, state.slip]
}

const fn row(sample: &Sample) -> [f64; 4] {
    of_state(sample.state)
}

/// The ranges of the three axes.
struct Ranges {
    theta: [f64; 2],
    slip: [f64; 2],
    rate: [f64; 2],
}

impl Ranges {
    fn of(modes: &Modes) -> Self {
        let values = |k: usize| modes.rows().map(move |row| row[k]);
        Self {
            theta: bounds(values(1), 0.06),
            slip: bounds(values(3).chain([0.0]), 0.12),
            rate: bounds(values(2), 0.12),
        }
    }

    /// Whether a step is long enough to be seen.
    fn show(&self, [from, to]: &[[f64; 4]; 2]) -> bool {
        let steps = [self.theta, self.rate, self.slip]
            .into_iter()
            .zip(1..)
            .map(|(range, i)| (to[i] - from[i]) / (range[1] - range[0]));
        steps.map(|step: f64| step * step).sum::<f64>() > LEAST_STEP * LEAST_STEP
    }
}

/// The plane of rolling, with the shadow of the sliding parts on it.
fn floor(ranges: &Ranges, modes: &Modes) -> Vec<Layer> {
    let Ranges { theta, rate, .. } = ranges;
    let corner = |i: usize, j: usize| [theta[i], rate[j], 0.0];
    let floor = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
    let outline = floor.into_iter().chain([floor[0]]);
    let names = [THETA, THETA_RATE, SLIP];
    let mut layers = vec![
        Series::of_rows("plane of rolling", &names, floor)
            .drawn(Mark::Fill(REGION.over(PAPER, 0.6))),
        Series::of_rows("plane of rolling", &names, outline).drawn(Stroke::solid(FAINT, FINE)),
    ];
    for (_, series) in modes.0.iter().filter(|(mode, _)| *mode == Mode::Sliding) {
        let pieces = series.pieces.iter();
        let pieces = pieces.map(|piece| piece.iter().map(|row| [row[1], row[2], 0.0]));
        let stroke = Stroke::solid(FAINT, 1.0).dashed(Dash::Short);
        layers.push(Series::new("shadow", &names, pieces).drawn(stroke));
    }
    layers
}

/// Most phases of a mode of which each has a letter.
const LETTERS: usize = 2;

/// *s* and *r* at the phases; of many at the first, with how many there are.
fn letters(motion: &Shown) -> Vec<Label> {
    let mut labels: Vec<Label> = Vec::new();
    let shown = || {
        let phases = motion.phases().iter();
        phases.take_while(|phase| phase.start().time < motion.until)
    };
    let mut counted: Vec<Mode> = Vec::new();
    for phase in shown() {
        let (letter, share) = match phase.mode() {
            Mode::Sliding => ("*s*", 0.5),
            Mode::Rolling => ("*r*", 0.75),
            Mode::Gliding | Mode::Flight | Mode::Rest | Mode::Skidding => continue,
        };
        if counted.contains(&phase.mode()) {
            continue;
        }
        let count = shown().filter(|it| it.mode() == phase.mode()).count();
        let text = if count > LETTERS {
            counted.push(phase.mode());
            format!("{count} × {letter}")
        } else {
            letter.to_owned()
        };
        let duration = f64::min(phase.duration(), motion.until - phase.start().time);
        let middle = phase.sample(share * duration).state;
        let [right, down] = match middle.slip {
            slip if slip < 0.0 => [13.0, 12.0],
            0.0 => [4.0, 14.0],
            _ => [-14.0, -6.0],
        };
        let label = Label::new(text, &[middle.theta, middle.slip, middle.theta_rate]);
        labels.push(
            label
                .shifted(right, down)
                .coloured(Stroke::of_mode(phase.mode()).colour),
        );
    }
    labels
}

/// The transitions, impacts from before to after, and *L* where the hoop lifts off.
fn changes(motion: &Shown) -> (Vec<Layer>, Vec<Label>) {
    let (mut changes, mut jumps, mut labels) = (Vec::new(), Vec::new(), Vec::new());
    for transition in motion.passed() {
        let state = transition.before;
        if transition.cause == Cause::Landing && !motion.goes_on() {
            continue;
        }
        changes.push(of_state(state));
        if transition.impact.is_some() {
            changes.push(of_state(transition.after));
            jumps.push([of_state(state), of_state(transition.after)]);
        } else if transition.to.is_some_and(|mode| !mode.touches_plane()) {
            let at = [state.theta, state.slip, state.theta_rate];
            labels.push(Label::new("*L*", &at).shifted(13.0, -3.0));
        }
    }
    let mut layers = Vec::new();
    if !jumps.is_empty() {
        layers.push(Series::new("impact", &COLUMNS, jumps).drawn(JUMP));
    }
    layers.push(Series::of_rows("transition", &COLUMNS, changes).drawn(TRANSITION));
    layers.push(Series::of_rows("start", &COLUMNS, [of_state(motion.start())]).drawn(START));
    (layers, labels)
}

/// Figure 3(a).
pub(crate) fn space(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-3a";
    input.with_inertia(NAME)?;
    let motion = input.motion_in_contact(NAME)?;
    // Before the lift-off only, as in the paper, unless the motion goes on after the landing.
    let is_drawn = |mode: Mode| mode.touches_plane() || motion.goes_on();
    let mut on_ground = motion.by_mode("", &COLUMNS, row);
    on_ground.0.retain(|(mode, _)| is_drawn(*mode));
    let ranges = Ranges::of(&on_ground);
    let mut layers = floor(&ranges, &on_ground);
    layers.extend(on_ground.lines(BOLD));
    let is_seen = |mode: Mode, rows: &[[f64; 4]; 2]| is_drawn(mode) && ranges.show(rows);
    layers.extend(motion.arrows(0.62, &COLUMNS, row, is_seen));
    let (marks, of_marks) = changes(&motion);
    let has_jumps = marks.iter().any(|layer| layer.mark == JUMP.into());
    layers.extend(marks);
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
    let sheet = input.sheet(620.0)?;
    let height = sheet.height(480.0);
    let mut panel = in_space(ranges, input.wording(), layers);
    panel.frame = PanelFrame::from_corner(sheet.width, height);
    // After the name of the plane.
    panel
        .labels
        .splice(1..1, letters(&motion).into_iter().chain(of_marks));
    let title = "Figure 3(a): the motion in the space of states";
    let figure = sheet.figure(NAME, title, caption, height, vec![panel]);
    Ok(figure.noted(motion.remark()))
}

/// A panel of the space of states, without a frame: θ across, η′ upwards, θ′ to the back.
fn in_space(ranges: Ranges, say: Wording, layers: Vec<Layer>) -> Panel {
    let Ranges {
        theta: [left, right],
        slip: [low, high],
        rate: [front, back],
    } = ranges;
    let (x, y, z) = (
        say.angle(ranges.theta.into()),
        say.slip(ranges.slip.into()),
        say.rate(ranges.rate.into()),
    );
    let plane = Label::new("*η*′ = 0", &[right, 0.0, back]).shifted(-34.0, 14.0);
    let labels = vec![
        plane.coloured(SOFT),
        Label::new(&x.title, &[0.5 * (left + right), low, back]).shifted(-16.0, 38.0),
        Label::new(&z.title, &[right, low, 0.5 * (front + back)]).shifted(52.0, 26.0),
        Label::new(&y.title, &[left, high, front]).shifted(0.0, -18.0),
    ];
    let view = View::Space {
        x,
        y,
        z,
        yaw: 0.55,
        pitch: 0.32,
    };
    Panel {
        image: None,
        name: "space of states",
        frame: PanelFrame::from_corner(0.0, 0.0),
        view,
        layers,
        labels,
        keys: Vec::new(),
    }
}

/// Rows of the names of transitions.
const ROWS: u32 = 3;

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

/// The motion in the phase plane.
fn phase_plane(motion: &Shown) -> Content {
    let portrait = Portrait::new(motion.hoop(), littlewood_window(motion.start().theta_rate));
    // The hoop is where it is a turn earlier.
    let turns = TAU * libm::round(motion.start().theta / TAU);
    let of_state = |state: State| {
        let [time, theta, rate, slip] = of_state(state);
        [time, theta - turns, rate, slip]
    };
    let row = |sample: &Sample| of_state(sample.state);
    let theta_s = 2.0 * libm::atan(motion.hoop().mu_s());
    let mut modes = motion.by_mode("", &COLUMNS, row);
    modes.add_unbounded_end(motion, row);
    let mut layers = vec![portrait.rolling_region().drawn(Mark::Fill(REGION))];
    let bound = |curve| Stroke::of_curve(curve).wide(1.2);
    let unloading = if portrait.resists() {
        portrait.unloading_locus()
    } else {
        unloading_lines(theta_s)
    };
    layers.push(unloading.drawn(bound(Curve::NormalForceZero)));
    let mut labels = vec![
        Label::new("𝓡", &[-0.6 * theta_s, -0.6])
            .sized(20.0)
            .of_area(),
        Label::new("*n*", &[-0.4 * theta_s, 1.0])
            .shifted(0.0, -11.0)
            .coloured(NORMAL_FORCE),
    ];
    if let Some((_, limit)) = portrait.massless_limit() {
        // Beside the middle of the vertical on the left.
        let verticals = limit.pieces.iter().filter_map(|piece| {
            let [from, to] = [piece.first()?, piece.last()?];
            Some([from[0], 0.5 * (from[1] + to[1])])
        });
        let left = verticals.min_by(|a, b| a[0].total_cmp(&b[0]));
        let name = left.map(|at| Label::new("*f*", &at).shifted(-10.0, 0.0));
        labels.extend(name.map(|name| name.coloured(FRICTION_FORCE)));
        layers.push(limit.drawn(bound(Curve::SlipLimit)));
    }
    for (mode, series) in modes.0 {
        let first = series.pieces.first();
        if let Some(middle) = first.and_then(|piece| piece.get(piece.len() / 2)) {
            let label = Label::new(mode.name(), &middle[1..3]);
            let label = match mode {
                Mode::Rolling => label.shifted(-4.0, 14.0),
                Mode::Sliding | Mode::Gliding | Mode::Flight | Mode::Rest | Mode::Skidding => {
                    label.shifted(-10.0, -8.0).right()
                }
            };
            labels.push(label.coloured(Stroke::of_mode(mode).colour));
        }
        let stroke = Stroke::of_mode(mode).wide(BOLD);
        layers.push(series.drawn(stroke).marked_beyond());
    }
    let changes = motion.transitions().iter().map(|it| of_state(it.before));
    let changes = changes.filter(|row| row[2].is_finite());
    layers.extend(motion.arrows(0.5, &COLUMNS, row, |_, _| true));
    layers.push(Series::of_rows("transition", &COLUMNS, changes).drawn(TRANSITION));
    layers.push(Series::of_rows("start", &COLUMNS, [of_state(motion.start())]).drawn(START));
    portrait.content("phase plane", motion.say, layers, labels)
}

/// The slip velocity against time.
fn slip_velocity(motion: &Shown) -> Content {
    // η′ is finite where θ′ is not: at the end of a glide.
    let slips: Vec<(Mode, Vec<[f64; 2]>)> = motion
        .phases()
        .iter()
        .map(|phase| {
            let samples = motion.all_instants(phase).into_iter();
            let rows = samples.map(|Sample { state, .. }| [state.time, state.slip]);
            (phase.mode(), rows.collect())
        })
        .collect();
    let range = bounds(
        slips
            .iter()
            .flat_map(|(_, rows)| rows.iter().map(|row| row[1])),
        0.1,
    );
    let mut layers = vec![motion.level("zero", SLIP, 0.0, Stroke::solid(SOFT, FINE))];
    for (mode, rows) in slips {
        let stroke = Stroke::of_mode(mode).wide(BOLD);
        let series = Series::of_rows(mode.name(), &[TIME, SLIP], rows);
        layers.push(series.drawn(stroke).marked_beyond());
    }
    let mut labels = Vec::new();
    let [from, until] = motion.times();
    for (transition, row) in motion.transitions().iter().zip((0..ROWS).cycle()) {
        let time = transition.time();
        let vertical = range.map(|slip| [time, slip]);
        layers.push(Series::of_rows("time of transition", &[TIME, SLIP], vertical).drawn(VERTICAL));
        // Above the panel, where no curve is, in rows.
        let label = Label::new(instant(transition, motion.say), &[time, range[1]])
            .sized(SMALL)
            .fixed()
            .shifted(0.0, -10.0 - 16.0 * f64::from(row));
        labels.push(match (time - from) / (until - from) {
            part if part < 0.2 => label.left(),
            part if part > 0.8 => label.right(),
            _ => label,
        });
    }
    Content {
        name: "slip velocity",
        x: motion.say.clock([from, until].into()),
        y: motion.say.slip(range.into()),
        layers,
        labels,
    }
}

/// Figure 7(a).
pub(crate) fn gliding(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "figure-7a";
    input.littlewood(NAME)?;
    input.level(NAME)?;
    let motion = input.motion(NAME)?;
    let last = motion.transitions().last();
    let times = if last.is_some_and(|last| last.cause == Cause::ParticleAtPlane) {
        " As *τ* → *τ*_{g}, *θ* → ±π and *θ*′ → ±∞, but *η*′ remains finite."
    } else {
        ""
    };
    // Where the slip changes its direction gliding goes on.
    let phases = motion.phases().iter();
    let mut modes: Vec<&str> = phases.map(|phase| phase.mode().name()).collect();
    modes.dedup();
    let caption = format!(
        "A massless hoop: {}. First: in the phase plane, with 𝓡 shaded. Second: slip velocity *η*′, zero while \
         the hoop rolls; dashed verticals: transitions.{times} *μ*_{{s}} = {}; {}. Gliding follows (3.17) with \
         the corrected integral.",
        modes.join(", then "),
        short(input.hoop.mu_s()),
        motion.say.start(motion.hoop(), &input.start)
    );
    let sheet = input.sheet(860.0)?;
    let height = sheet.height(362.0);
    let rows = ROWS.min(motion.transitions().len() as u32);
    let frames = sheet.frames(12.0, 12.0 + 16.0 * f64::from(rows), height);
    let panels = frames
        .into_iter()
        .zip([phase_plane(&motion), slip_velocity(&motion)])
        .map(|(frame, content)| Sheet::panel(frame, content))
        .collect();
    let title = "Figure 7(a): rolling, then gliding";
    let bottom = frames[1].top + height + 6.0;
    Ok(sheet.figure(NAME, title, caption, bottom, panels))
}
