//! The motion of Figure 3(b) as a picture: paths of the centre and of the mass centre, the hoop at each transition.
//!
//! `cargo run --example figure_3_svg > docs/figure-3.svg`

use std::fmt::Write as _;

use littlewood::{Mode, ParameterError, Point, Sample, Trajectory, find_case};

const SCALE: f64 = 78.0;
const MARGIN: f64 = 30.0;

/// Colours that also differ in grey, and dashes for those who see neither.
const fn stroke(mode: Mode) -> (&'static str, &'static str) {
    match mode {
        Mode::Sliding => ("#d55e00", "7 3"),
        Mode::Rolling => ("#0072b2", "none"),
        Mode::Gliding => ("#009e73", "2 3"),
        Mode::Flight => ("#222222", "1 3"),
    }
}

struct Frame {
    left: f64,
    top: f64,
}

impl Frame {
    fn map(&self, point: Point) -> (f64, f64) {
        (MARGIN + (point.x - self.left) * SCALE, MARGIN + (self.top - point.y) * SCALE)
    }

    fn path(
        &self,
        points: impl Iterator<Item = Point>,
        (colour, dashes): (&str, &str),
        width: f64,
    ) -> String {
        let mut data = String::new();
        for (i, point) in points.enumerate() {
            let (x, y) = self.map(point);
            let _ = write!(data, "{}{x:.2} {y:.2}", if i == 0 { "M" } else { "L" });
        }
        format!(
            "<path d='{data}' fill='none' stroke='{colour}' stroke-dasharray='{dashes}' stroke-width='{width}'/>\n"
        )
    }

    fn hoop(&self, motion: &Trajectory, sample: &Sample, label: &str) -> String {
        let (cx, cy) = self.map(sample.centre());
        let (px, py) = self.map(sample.particle(motion.hoop()));
        let (mx, my) = self.map(sample.mass_centre(motion.hoop()));
        let below = cy + SCALE + 17.0;
        format!(
            "<circle cx='{cx:.2}' cy='{cy:.2}' r='{SCALE}' fill='none' stroke='#888' stroke-width='1.2'/>\n\
             <line x1='{cx:.2}' y1='{cy:.2}' x2='{px:.2}' y2='{py:.2}' stroke='#888'/>\n\
             <circle cx='{px:.2}' cy='{py:.2}' r='6' fill='#222'/>\n\
             <circle cx='{mx:.2}' cy='{my:.2}' r='3' fill='white' stroke='#222'/>\n\
             <text x='{cx:.2}' y='{below:.2}' text-anchor='middle'>{label}</text>\n"
        )
    }
}

fn main() -> Result<(), ParameterError> {
    let Some(case) = find_case("figure-3") else { return Ok(()) };
    let motion = case.simulate()?;
    let samples: Vec<Sample> = motion.sample_evenly(600, f64::INFINITY).collect();
    let extent =
        |f: fn(f64, f64) -> f64, of: fn(&Sample) -> f64| samples.iter().map(of).reduce(f).unwrap_or(0.0);
    let frame = Frame {
        left: extent(f64::min, |s| s.centre().x) - 1.1,
        top: extent(f64::max, |s| s.centre().y) + 1.1,
    };
    let right = extent(f64::max, |s| s.centre().x) + 1.1;
    let (width, ground) = frame.map(Point { x: right, y: 0.0 });
    let height = ground + 64.0;

    let mut body = String::new();
    let _ = writeln!(
        body,
        "<line x1='0' y1='{ground:.2}' x2='{width:.2}' y2='{ground:.2}' stroke='#222' stroke-width='1.5'/>"
    );
    for transition in motion.transitions().iter().rev() {
        if let Some(sample) = motion.at(transition.state.time) {
            body += &frame.hoop(&motion, &sample, transition.cause.name().replace('_', "-").as_str());
        }
    }
    if let Some(first) = motion.phases().first() {
        body += &frame.hoop(&motion, &first.first(), "start");
    }
    for phase in motion.phases() {
        let of_phase = || (0..=200).map(|i| phase.sample(phase.duration() * f64::from(i) / 200.0));
        body += &frame.path(of_phase().map(|s| s.centre()), stroke(phase.mode()), 1.6);
        body += &frame.path(of_phase().map(|s| s.mass_centre(motion.hoop())), stroke(phase.mode()), 3.0);
    }
    let mut x = MARGIN;
    for mode in [Mode::Sliding, Mode::Rolling, Mode::Flight] {
        let (colour, dashes) = stroke(mode);
        let y = ground + 46.0;
        let _ = writeln!(
            body,
            "<line x1='{x}' y1='{y}' x2='{}' y2='{y}' stroke='{colour}' stroke-width='3' stroke-dasharray='{dashes}'/>\
             <text x='{}' y='{}'>{mode}</text>",
            x + 34.0,
            x + 40.0,
            y + 4.0
        );
        x += 120.0;
    }
    let _ = writeln!(
        body,
        "<text x='{x}' y='{}'>thick: mass centre, thin: geometric centre</text>",
        ground + 50.0
    );
    println!(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {width:.0} {height:.0}' font-family='sans-serif' \
         font-size='13' fill='#222'>\n<title>Figure 3: a hoop slides, rolls, slides and jumps</title>\n\
         <rect width='100%' height='100%' fill='white'/>\n{body}</svg>"
    );
    Ok(())
}
