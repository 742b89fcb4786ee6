//! Inertia switched off: lighter and lighter hoops from one start, and the massless one.

use littlewood::tables::{Dimension, Quantity, SampleColumn};
use littlewood::{Hoop, HoopParameters, OutcomeKind, Trajectory};
use littlewood_draw::{
    Content, FAINT, Figure, INK, Label, Mark, NORMAL_FORCE, Piece, PlotAxis, Series, Stroke,
    marked, short,
};
use littlewood_style::Dash;
use littlewood_style::width::{BOLD, CURVE, FINE};

use crate::columns::{NORMAL, TIME, X, Y};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::bounds;
use crate::timeline::{history, level};

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

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let gap_rate = input.start.gap_rate;
    if gap_rate != 0.0 {
        return Err(FigureError::NeedsStartOnPlane {
            figure: NAME,
            gap_rate,
        });
    }
    let motions: Vec<(Stroke, f64, Trajectory)> = HOOPS
        .into_iter()
        .map(|(inertia, dash)| {
            let motion = lightened(&input.hoop, inertia)?.simulate(input.start, input.limits)?;
            let stroke = if inertia > 0.0 {
                Stroke::solid(NORMAL_FORCE, CURVE)
            } else {
                Stroke::solid(INK, BOLD)
            };
            Ok((stroke.dashed(dash), inertia, motion))
        })
        .collect::<Result<_, FigureError>>()?;
    let from = input.start.time;
    // The massless hoop ends where the particle reaches the plane; the others are shown for as long
    // again.
    let end = motions
        .last()
        .map_or(f64::INFINITY, |(.., massless)| massless.end_time());
    let until = if end.is_finite() && end > from {
        from + 1.5 * (end - from)
    } else {
        from + 6.0
    };
    let say = input.wording();
    let times = [from, until];
    let (mut paths, mut forces, mut keys, mut most) = (Vec::new(), Vec::new(), Vec::new(), 0.0_f64);
    let mut peaks = Vec::new();
    for (stroke, inertia, motion) in &motions {
        let name = format!("inertia {inertia}");
        let rows = motion.sample_evenly(INSTANTS, until.min(motion.end_time()));
        let rows = rows.map(|sample| vec![sample.state.time, sample.particle.x, sample.particle.y]);
        let rows: Piece = rows
            .filter(|row| row.iter().all(|value| value.is_finite()))
            .collect();
        paths.push(Series::of_rows(name.clone(), &[TIME, X, Y], rows).drawn(*stroke));
        let mut normal = history(motion, "", NORMAL, &|_, sample| Some(sample.normal));
        for piece in &mut normal.pieces {
            piece.retain(|row| row[0] <= until);
        }
        normal.name = name;
        let highest = normal
            .rows()
            .max_by(|a, b| a[1].total_cmp(&b[1]))
            .map(<[f64]>::to_vec);
        if let Some(row) = highest.filter(|row| *inertia > 0.0 && row[1] > 0.0) {
            most = most.max(row[1]);
            // To a whole number or two digits.
            let unit = libm::exp10(libm::floor(libm::log10(row[1])) - 1.0).min(1.0);
            let text = say.number(unit * libm::round(row[1] / unit), Dimension::Force);
            peaks.push(Label::new(text, &row).shifted(0.0, -9.0));
        }
        forces.push(normal.drawn(*stroke));
        if !motion.phases().is_empty() {
            let text = format!("{} = {}", marked(Quantity::Inertia.sign()), short(*inertia));
            keys.push((Mark::Line(*stroke), text));
        }
    }
    if most == 0.0 {
        // What is in the air all the time feels no blow.
        return Err(FigureError::NoContact {
            figure: NAME,
            outcome: OutcomeKind::Landing,
        });
    }
    let range = bounds(
        paths
            .iter()
            .flat_map(|layer| layer.series.rows().map(|row| row[1])),
        0.06,
    );
    let ground = Series::of_rows("plane", &[X, Y], range.map(|x| vec![x, 0.0]).to_vec());
    paths.insert(0, ground.drawn(Stroke::solid(FAINT, FINE)));
    let normal = say.axis(
        NORMAL,
        &marked(SampleColumn::Normal.sign()),
        [-0.1, 3.0 * most.max(1.0)],
    );
    forces.insert(
        0,
        level(times, "zero", NORMAL, 0.0, Stroke::solid(FAINT, FINE)),
    );
    let heights = bounds(
        paths.iter().flat_map(|layer| {
            layer
                .series
                .rows()
                .map(|row| row[layer.series.columns.len() - 1])
        }),
        0.08,
    );
    let contents = [
        Content {
            name: "paths",
            x: say.axis(X, "*x*", range),
            y: say.axis(Y, "*y*", heights),
            layers: paths,
            labels: Vec::new(),
        },
        Content {
            name: SampleColumn::Normal.long_name(),
            x: say.clock(times),
            y: PlotAxis {
                linear: 1.0,
                ..normal
            },
            layers: forces,
            labels: peaks,
        },
    ];
    let caption = format!(
        "Inertia switched off: thin hoops of mass and moment of inertia 1, 0.1, … from one start, and the massless hoop. First: paths of \
         the particle. Second: normal force against time, on an axis that is logarithmic beyond one. The lighter the hoop, the higher and \
         shorter the blow with which the particle turns at the bottom (numbers: the largest *N*, rounded). Without inertia there is none: the \
         hoop glides, *N* = 0, to the end of its motion, where the particle reaches the plane. {}; {}.",
        say.shared(&input.hoop),
        say.start(&input.hoop, &input.start)
    );
    Ok(input
        .sheet(860.0)?
        .pair(NAME, "Inertia switched off", caption, 362.0, contents, keys))
}
