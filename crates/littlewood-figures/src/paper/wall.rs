//! Lift-off is a wall: motions in the space of states, and the surface where they leave the plane.

use core::f64::consts::TAU;

use littlewood::theory::{PhasePlane, Window};
use littlewood::{Cause, Mode, Trajectory, Transition};
use littlewood_draw::{
    Figure, Mark, NORMAL_FORCE, PAPER, Piece, REGION, SOFT, START, Series, Stroke, TRANSITION,
    lift_off_condition,
};
use littlewood_style::Curve;
use littlewood_style::width::{BOLD, CURVE, FINE};

use super::state_space::{COLUMNS, in_space, of_state, row};
use crate::columns::{SLIP, THETA, THETA_RATE};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::{bounds, by_mode, horizon};
use crate::plane::{Portrait, rows};

const NAME: &str = "wall";
/// The motions have the rate of the start times these.
const SHARES: [f64; 5] = [1.0, 0.85, 0.92, 1.15, 1.35];
/// Levels of the wall, and every so many of its points an upright.
const LEVELS: u32 = 4;
const UPRIGHTS: usize = 6;
/// What is shown of a wall beside its top.
const BESIDE: f64 = 0.8;
const PLANE_OF_STATES: [&str; 3] = [THETA, THETA_RATE, SLIP];

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.with_inertia(NAME)?;
    let hoop = &input.hoop;
    input.motion_in_contact(NAME)?;
    let motions: Vec<Trajectory> = SHARES
        .into_iter()
        .map(|share| {
            let mut start = input.start;
            start.theta_rate *= share;
            start
        })
        .map(|start| hoop.simulate(start, input.limits))
        .collect::<Result<_, _>>()?;
    // Each up to its first lift-off, or as far as it is shown.
    let until = |motion: &Trajectory| {
        let lift_off = motion
            .transitions()
            .iter()
            .find(|transition| transition.cause == Cause::LiftOff);
        lift_off.map_or_else(|| horizon(motion), Transition::time)
    };
    let modes = |motion: &Trajectory| -> Vec<(Mode, Series)> {
        let end = until(motion);
        let mut modes = by_mode(motion, "", &COLUMNS, &row);
        for (_, series) in &mut modes {
            for piece in &mut series.pieces {
                piece.retain(|row| row[0] <= end);
            }
            series.pieces.retain(|piece| piece.len() > 1);
        }
        modes.retain(|(mode, series)| mode.touches_plane() && !series.pieces.is_empty());
        modes
    };
    let all: Vec<Vec<(Mode, Series)>> = motions.iter().map(modes).collect();
    let values = |k: usize| {
        all.iter()
            .flatten()
            .flat_map(move |(_, series)| series.rows().map(move |row| row[k]))
    };
    let y = bounds(values(3).chain([0.0]), 0.15);
    let (mut x, mut z) = (bounds(values(1), 0.08), bounds(values(2), 0.12));
    let mut edge = rows(PhasePlane::new(hoop).lift_off_curve(&Window { x, y: z }));
    if edge.is_empty() {
        // The wall is far from these motions: its nearest top is shown with them.
        let top = TAU * libm::round(0.5 * (x[0] + x[1]) / TAU);
        let least = PhasePlane::new(hoop).lift_off_rate(0.0).unwrap_or(1.0);
        let sign = if input.start.theta_rate < 0.0 {
            -1.0
        } else {
            1.0
        };
        x = bounds(x.into_iter().chain([top - BESIDE, top + BESIDE]), 0.0);
        z = bounds(z.into_iter().chain([1.3 * sign * least]), 0.0);
        edge = rows(PhasePlane::new(hoop).lift_off_curve(&Window { x, y: z }));
    }
    let window = Window { x, y: z };
    let portrait = Portrait::new(hoop, window);
    let floor = [[x[0], z[0]], [x[1], z[0]], [x[1], z[1]], [x[0], z[1]]];
    let flat = |piece: Piece, slip: f64| -> Piece {
        piece
            .into_iter()
            .map(|row| vec![row[0], row[1], slip])
            .collect()
    };
    let mut outline: Piece = floor.map(Vec::from).to_vec();
    outline.push(floor[0].to_vec());
    let within = |row: Vec<f64>| vec![row[0].clamp(x[0], x[1]), row[1].clamp(z[0], z[1])];
    let tile = rows(portrait.plane.rolling_region(&window));
    let tile = tile
        .into_iter()
        .map(|piece| flat(piece.into_iter().map(within).collect(), 0.0))
        .collect();
    let mut layers = vec![
        Series::new("R", &PLANE_OF_STATES, tile).drawn(Mark::Fill(REGION)),
        Series::of_rows("plane of rolling", &PLANE_OF_STATES, flat(outline, 0.0))
            .drawn(Stroke::solid(SOFT, FINE)),
    ];
    let walls = edge.iter().map(|piece| {
        let back = flat(piece.clone(), y[1]).into_iter().rev();
        flat(piece.clone(), y[0]).into_iter().chain(back).collect()
    });
    layers.push(
        Series::new("wall", &PLANE_OF_STATES, walls.collect())
            .drawn(Mark::Fill(NORMAL_FORCE.over(PAPER, 0.12))),
    );
    let level = |i: u32| y[0] + (y[1] - y[0]) * f64::from(i) / f64::from(LEVELS);
    let lines = (0..=LEVELS).flat_map(|i| edge.iter().map(move |piece| (piece.clone(), i)));
    let mut lines: Vec<Piece> = lines.map(|(piece, i)| flat(piece, level(i))).collect();
    for piece in &edge {
        let step = (piece.len() / UPRIGHTS).max(1);
        let places = piece.iter().step_by(step).chain(piece.last());
        lines.extend(places.map(|at| y.map(|slip| vec![at[0], at[1], slip]).to_vec()));
    }
    let of_wall = Stroke::of_curve(Curve::LiftOff);
    layers.push(
        Series::new("lines of the wall", &PLANE_OF_STATES, lines)
            .drawn(Stroke::solid(NORMAL_FORCE.over(PAPER, 0.45), FINE)),
    );
    let foot = edge.iter().map(|piece| flat(piece.clone(), 0.0)).collect();
    layers.push(Series::new("foot of the wall", &PLANE_OF_STATES, foot).drawn(of_wall));
    for (i, modes) in all.into_iter().enumerate().rev() {
        for (mode, series) in modes {
            let width = if i == 0 { BOLD } else { CURVE };
            layers.push(series.drawn(Stroke::of_mode(mode).wide(width)));
        }
    }
    // A motion that begins in flight comes into the picture where it lands.
    let begins = |motion: &&Trajectory| {
        motion
            .phases()
            .first()
            .is_some_and(|it| it.mode().touches_plane())
    };
    let starts = motions
        .iter()
        .filter(begins)
        .map(|motion| of_state(motion.start()))
        .collect();
    let jumps: Piece = motions
        .iter()
        .filter_map(|motion| {
            motion
                .transitions()
                .iter()
                .find(|transition| transition.cause == Cause::LiftOff)
        })
        .map(|transition| of_state(transition.before))
        .collect();
    let count = jumps.len();
    layers.push(Series::of_rows("lift-off", &COLUMNS, jumps).drawn(TRANSITION));
    layers.push(Series::of_rows("start", &COLUMNS, starts).drawn(START));
    let caption = format!(
        "Lift-off is a wall: {}, a surface in the space of states upright to the plane of rolling, whatever the friction and the slip. \
         In the plane of rolling, *η*′ = 0, the region 𝓡 (shaded). {} motions with the rate of the start times {} (crosses): sliding is \
         dashed, rolling lies in the plane; {count} of them leave the plane, where they meet the wall (diamonds). {}.",
        lift_off_condition(hoop.slope()),
        motions.len(),
        SHARES.map(|share| share.to_string()).join(", "),
        input.in_words()
    );
    in_space(
        input,
        [x, y, z],
        (NAME, "Lift-off is a wall", caption),
        (layers, Vec::new()),
    )
}
