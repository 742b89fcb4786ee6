//! Inertia switched off: lighter and lighter hoops from one start, and the massless one.

use littlewood::OutcomeKind;
use littlewood::tables::{Dimension, Quantity, SampleColumn};
use littlewood::{Hoop, HoopParameters};
use littlewood_draw::{
    Content, FAINT, Figure, INK, Label, Layer, Mark, NORMAL_FORCE, PlotAxis, Series, Stroke,
    marked, short,
};
use littlewood_style::Dash;
use littlewood_style::width::{BOLD, CURVE, FINE};

use crate::columns::{NORMAL, TIME, X, Y};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{Shown, bounds, finite_rows};

const NAME: &str = "inertia";
/// The moments of inertia, each with how it is drawn; the mass of the hoop is the same number, as
/// that of a thin one.
const HOOPS: [(f64, Dash); 5] = [
    (1.0, Dash::Dotted),
    (0.1, Dash::Short),
    (0.01, Dash::Dashed),
    (0.001, Dash::DashDot),
    (0.0, Dash::Solid),
];
/// Instants of a path.
const INSTANTS: usize = 600;

/// A hoop of the series, with the offset, friction and slope of the one that is asked for.
fn lightened(hoop: &Hoop, inertia: f64) -> Result<Hoop, FigureError> {
    let own = hoop.parameters();
    let thin = HoopParameters::thin(inertia)
        .with_offset(own.offset)
        .with_friction(own.mu_s, own.mu_k);
    Ok(Hoop::new(thin.with_slope(hoop.slope()))?)
}

/// A motion of the series.
struct Lightened {
    inertia: f64,
    stroke: Stroke,
    motion: Shown,
}

impl Lightened {
    fn new(input: &FigureInput, inertia: f64, dash: Dash) -> Result<Self, FigureError> {
        let motion = lightened(&input.hoop, inertia)?.simulate(input.start, input.limits)?;
        let stroke = if inertia > 0.0 {
            Stroke::solid(NORMAL_FORCE, CURVE)
        } else {
            Stroke::solid(INK, BOLD)
        };
        Ok(Self {
            inertia,
            stroke: stroke.dashed(dash),
            motion: Shown::new(motion, input.wording()),
        })
    }

    fn name(&self) -> String {
        format!("inertia {}", self.inertia)
    }

    /// The path of the particle.
    fn path(&self, until: f64) -> Layer {
        let samples = self
            .motion
            .sample_evenly(INSTANTS, until.min(self.motion.end_time()));
        let rows = samples.map(|it| [it.state.time, it.particle.x, it.particle.y]);
        Series::of_rows(self.name(), &[TIME, X, Y], finite_rows(rows)).drawn(self.stroke)
    }

    /// The normal force against time.
    fn force(&self, until: f64) -> Layer {
        let history = self
            .motion
            .history(&self.name(), NORMAL, |_, sample| Some(sample.normal));
        let mut force = history.drawn(self.stroke);
        for piece in &mut force.series.pieces {
            piece.retain(|row| row[0] <= until);
        }
        force
    }

    /// The largest force of a hoop that has inertia, and when it is so large.
    fn peak(&self, force: &Layer) -> Option<[f64; 2]> {
        let rows = force.series.rows();
        let highest = rows.max_by(|a, b| a[1].total_cmp(&b[1]))?;
        (self.inertia > 0.0 && highest[1] > 0.0).then_some([highest[0], highest[1]])
    }
}

/// Paths of the particle.
fn paths(motions: &[Lightened], until: f64) -> Content {
    let mut layers: Vec<Layer> = motions.iter().map(|it| it.path(until)).collect();
    let values = |layers: &[Layer], column: &str| -> Vec<f64> {
        let series = layers.iter().map(|layer| &layer.series);
        let of = |series: &Series| {
            let place = series.column(column);
            let rows = series.rows().filter_map(|row| row.get(place?).copied());
            rows.collect::<Vec<f64>>()
        };
        series.flat_map(of).collect()
    };
    let range = bounds(values(&layers, X), 0.06);
    let ground = Series::of_rows("plane", &[X, Y], range.map(|x| [x, 0.0]));
    layers.insert(0, ground.drawn(Stroke::solid(FAINT, FINE)));
    let heights = bounds(values(&layers, Y), 0.08);
    let say = motions[0].motion.say;
    Content {
        name: "paths",
        x: say.axis(X, "*x*", range),
        y: say.axis(Y, "*y*", heights),
        layers,
        labels: Vec::new(),
    }
}

/// Normal forces against time, with the largest of each; none of what is in the air all the time.
fn forces(motions: &[Lightened], times: [f64; 2]) -> Option<Content> {
    let say = motions[0].motion.say;
    let zero = Series::of_rows("zero", &[TIME, NORMAL], times.map(|time| [time, 0.0]));
    let mut layers = vec![zero.drawn(Stroke::solid(FAINT, FINE))];
    let (mut labels, mut most) = (Vec::new(), 0.0_f64);
    for motion in motions {
        let force = motion.force(times[1]);
        if let Some([time, highest]) = motion.peak(&force) {
            most = most.max(highest);
            // To a whole number or two digits.
            let unit = libm::exp10(libm::floor(libm::log10(highest)) - 1.0).min(1.0);
            let text = say.number(unit * libm::round(highest / unit), Dimension::Force);
            labels.push(Label::new(text, &[time, highest]).shifted(0.0, -9.0));
        }
        layers.push(force);
    }
    let normal = SampleColumn::Normal;
    let range = [-0.1, 3.0 * most.max(1.0)];
    (most > 0.0).then(|| Content {
        name: normal.long_name(),
        x: say.clock(times),
        y: PlotAxis {
            linear: 1.0,
            ..say.axis(NORMAL, &marked(normal.sign()), range)
        },
        layers,
        labels,
    })
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let gap_rate = input.start.gap_rate;
    if gap_rate != 0.0 {
        return Err(FigureError::NeedsStartOnPlane {
            figure: NAME,
            gap_rate,
        });
    }
    let motions = HOOPS.map(|(inertia, dash)| Lightened::new(input, inertia, dash));
    let motions: Vec<Lightened> = motions.into_iter().collect::<Result<_, _>>()?;
    let from = input.start.time;
    // The massless hoop ends where the particle reaches the plane; the others are shown for as long
    // again.
    let massless = motions.last().map(|massless| massless.motion.end_time());
    let until = match massless {
        Some(end) if end.is_finite() && end > from => from + 1.5 * (end - from),
        _ => from + 6.0,
    };
    let Some(forces) = forces(&motions, [from, until]) else {
        // What is in the air all the time feels no blow.
        return Err(FigureError::NoContact {
            figure: NAME,
            outcome: OutcomeKind::Landing,
        });
    };
    let seen = motions.iter().filter(|it| !it.motion.phases().is_empty());
    let sign = marked(Quantity::Inertia.sign());
    let keys = seen
        .map(|it| {
            (
                Mark::Line(it.stroke),
                format!("{sign} = {}", short(it.inertia)),
            )
        })
        .collect();
    let caption = format!(
        "Inertia switched off: thin hoops of mass and moment of inertia 1, 0.1, … from one start, and the massless hoop. First: paths of \
         the particle. Second: normal force against time, on an axis that is logarithmic beyond one. The lighter the hoop, the higher and \
         shorter the blow with which the particle turns at the bottom (numbers: the largest *N*, rounded). Without inertia there is none: the \
         hoop glides, *N* = 0, to the end of its motion, where the particle reaches the plane. {}; {}.",
        input.wording().shared(&input.hoop),
        input.wording().start(&input.hoop, &input.start)
    );
    let title = "Inertia switched off";
    let contents = [paths(&motions, until), forces];
    let sheet = input.sheet(860.0)?;
    Ok(sheet.pair(NAME, title, caption, 362.0, contents, keys))
}
