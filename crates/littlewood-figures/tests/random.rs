//! Random hoops: a figure that is made shows something, or it is refused with a reason.
//! `LITTLEWOOD_HOOPS=500` takes 500 of them, and `--nocapture` tells the slowest figures.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use littlewood::{Hoop, HoopParameters, Limits, RestitutionLaw, Start};
use littlewood_figures::{FIGURES, Figure, FigureInput, Layer, Mark, Panel, PlotAxis, Scale, View};

/// Numbers from 0 to 1, the same in each run (SplitMix64).
pub(crate) struct Draw(pub(crate) u64);

impl Draw {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn comes(&mut self, share: f64) -> bool {
        self.unit() < share
    }

    pub(crate) fn between(&mut self, from: f64, to: f64) -> f64 {
        from + (to - from) * self.unit()
    }

    /// Over six decades about one.
    fn size(&mut self) -> f64 {
        libm::pow(10.0, self.between(-3.0, 3.0))
    }

    pub(crate) fn input(&mut self) -> FigureInput {
        let is_massless = self.comes(0.2);
        let (mass_ratio, inertia) = if is_massless {
            (0.0, 0.0)
        } else {
            let mass_ratio = if self.comes(0.1) { 0.0 } else { self.size() };
            (
                mass_ratio,
                if mass_ratio > 0.0 && self.comes(0.5) {
                    mass_ratio
                } else {
                    self.size()
                },
            )
        };
        let offset = match self.unit() {
            share if share < 0.5 => 1.0,
            // Nothing determines the motion of a massless hoop that is not loaded.
            share if share < 0.55 && mass_ratio > 0.0 => 0.0,
            _ => self.between(0.01, 1.0),
        };
        let mu_s = if self.comes(0.1) {
            0.0
        } else {
            self.between(0.0, 1.5)
        };
        let mu_k = if self.comes(0.2) {
            mu_s
        } else {
            mu_s * self.unit()
        };
        let mut parameters = HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_s, mu_k);
        if !is_massless && self.comes(0.3) {
            let e = if self.comes(0.1) { 1.0 } else { self.unit() };
            parameters = parameters.with_restitution(e, RestitutionLaw::Energetic);
        }
        let rate = if self.comes(0.1) {
            0.0
        } else {
            self.between(-5.0, 5.0)
        };
        let mut start = Start::at(self.between(-3.1, 3.1), rate);
        if self.comes(0.3) {
            start.slip = self.between(-2.0, 2.0);
        }
        let limits = Limits::default().with_transitions(2000);
        FigureInput::new(Hoop::new(parameters).expect("within bounds"), start, limits)
    }
}

/// Series that are there whatever the hoop does.
pub(crate) const FRAME: [&str; 10] = [
    "ground",
    "zero",
    "weight",
    "transition",
    "time of transition",
    "plane of rolling",
    "singular",
    "mu_s",
    "mu_k",
    "inside of the cone",
];

/// Place of a value between the ends of an axis, 0 to 1.
fn share(axis: &PlotAxis, value: f64) -> f64 {
    (value - axis.range.from) / axis.range.length()
}

/// Two pixels of a panel: the contact before a long flight may be as short.
const SHORTEST: f64 = 0.004;

/// Whether something of a layer is seen: a mark in the window, or a line that is long enough.
fn is_seen(layer: &Layer, axes: &[&PlotAxis]) -> bool {
    let series = &layer.series;
    let Some(places) = axes
        .iter()
        .map(|axis| series.column(&axis.column))
        .collect::<Option<Vec<usize>>>()
    else {
        return false;
    };
    let inside: Vec<Vec<f64>> = series
        .rows()
        .map(|row| {
            axes.iter()
                .zip(&places)
                .map(|(axis, place)| share(axis, row[*place]))
                .collect::<Vec<f64>>()
        })
        .filter(|place| {
            place
                .iter()
                .all(|share| (-1e-9..=1.0 + 1e-9).contains(share))
        })
        .collect();
    match layer.mark {
        Mark::Line(_)
        | Mark::Arrow(_)
        | Mark::Fill(_)
        | Mark::Region(_)
        | Mark::Hatch(_)
        | Mark::HatchedRegion(_) => (0..axes.len()).any(|i| {
            let (low, high) = inside
                .iter()
                .map(|place| place[i])
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), at| {
                    (low.min(at), high.max(at))
                });
            high - low > SHORTEST
        }),
        Mark::Head(_)
        | Mark::Dot(..)
        | Mark::Ring(..)
        | Mark::Diamond(..)
        | Mark::Cross(..)
        | Mark::Hoop(_) => !inside.is_empty(),
        // It says that something is elsewhere.
        Mark::Beyond(_) => false,
    }
}

pub(crate) fn shows_something(panel: &Panel) -> bool {
    let axes = match &panel.view {
        View::Plane { x, y, .. } => vec![x, y],
        View::Space { x, y, z, .. } => vec![x, y, z],
    };
    assert!(axes.iter().all(|axis| axis.range.from < axis.range.to
        && axis.range.ends().iter().all(|end| end.is_finite())));
    panel
        .layers
        .iter()
        .filter(|layer| !FRAME.contains(&layer.series.name.as_str()))
        .any(|layer| is_seen(layer, &axes))
}

fn check(figure: &Figure, input: &FigureInput) {
    for panel in &figure.panels {
        let says_so = panel
            .labels
            .iter()
            .any(|label| label.text.starts_with("nothing to show"));
        assert!(
            says_so || shows_something(panel),
            "{}, {}: nothing is seen of {input:?}",
            figure.name,
            panel.name
        );
        for axes in [&panel.view] {
            if let View::Plane {
                x, y, axes: true, ..
            } = axes
            {
                let has_ticks =
                    |axis: &PlotAxis| axis.scale == Scale::Nothing || !axis.ticks.is_empty();
                assert!(
                    has_ticks(x) && has_ticks(y),
                    "{}: no ticks, {input:?}",
                    figure.name
                );
            }
        }
    }
}

#[test]
#[ignore = "thorough"]
fn no_figure_of_a_random_hoop_is_empty() {
    let hoops: u64 = std::env::var("LITTLEWOOD_HOOPS")
        .ok()
        .and_then(|text| text.parse().ok())
        .unwrap_or(40);
    let mut draw = Draw(14);
    let mut slowest: BTreeMap<&str, (Duration, String)> = BTreeMap::new();
    let mut made: BTreeMap<&str, u32> = BTreeMap::new();
    for hoop in 0..hoops {
        let input = draw.input();
        for entry in FIGURES {
            // The figure of thousands of motions of some hoops only, none of which slides for
            // thousands of turns.
            if entry.name == "outcomes" && (hoop % 20 != 1 || input.hoop.mu_k() < 0.05) {
                continue;
            }
            let clock = Instant::now();
            match entry.figure(&input) {
                Ok(figure) => {
                    check(&figure, &input);
                    let drawing = figure.svg();
                    assert!(
                        !drawing.contains("NaN") && !drawing.contains("inf\""),
                        "{}: {input:?}",
                        entry.name
                    );
                    *made.entry(entry.name).or_default() += 1;
                }
                Err(error) => assert!(!error.to_string().is_empty()),
            }
            let taken = clock.elapsed();
            let slow = slowest.entry(entry.name).or_default();
            if taken > slow.0 {
                *slow = (
                    taken,
                    format!("{:?}, {:?}", input.hoop.parameters(), input.start),
                );
            }
        }
    }
    for (name, (taken, of)) in slowest {
        println!(
            "{name}: {} made, slowest {taken:.3?} of {of}",
            made.get(name).copied().unwrap_or(0)
        );
    }
    // Few hoops may have no impact among them.
    for entry in FIGURES.iter().filter(|_| hoops >= 200) {
        assert!(
            made.contains_key(entry.name),
            "no random hoop has {}",
            entry.name
        );
    }
}
