//! The equations of the paper, written out once more, and access to the data of figures.

#![allow(dead_code, reason = "no test file needs all of it")]

use littlewood_figures::{Figure, Series, find_figure};

/// A figure as the paper has it.
pub(crate) fn figure(name: &str) -> Figure {
    find_figure(name)
        .expect("a name of the catalogue")
        .of_the_paper()
        .expect("the figure can be made")
}

/// All series of a figure whose names begin so.
pub(crate) fn series<'a>(figure: &'a Figure, prefix: &'a str) -> Vec<&'a Series> {
    let found: Vec<&Series> = figure
        .panels
        .iter()
        .flat_map(|panel| &panel.layers)
        .map(|layer| &layer.series)
        .filter(|series| series.name.starts_with(prefix))
        .collect();
    assert!(
        found.iter().any(|series| series.rows().next().is_some()),
        "{}: no {prefix}",
        figure.name
    );
    found
}

/// The rows of these columns.
pub(crate) fn columns<const N: usize>(series: &Series, names: [&str; N]) -> Vec<[f64; N]> {
    let places = names.map(|name| series.column(name).expect("a column of the series"));
    series
        .rows()
        .map(|row| places.map(|place| row[place]))
        .collect()
}

/// The outlines of an area in a plane of two columns.
pub(crate) fn outlines(series: &Series, names: [&str; 2]) -> Vec<Vec<[f64; 2]>> {
    let places = names.map(|name| series.column(name).expect("a column of the series"));
    let piece = |piece: &Vec<Vec<f64>>| {
        piece
            .iter()
            .map(|row| places.map(|place| row[place]))
            .collect()
    };
    series.pieces.iter().map(piece).collect()
}

/// How often closed lines wind about a place, counterclockwise.
pub(crate) fn winding(lines: &[Vec<[f64; 2]>], [x, y]: [f64; 2]) -> i32 {
    let edges = lines
        .iter()
        .flat_map(|line| line.iter().zip(line.iter().cycle().skip(1)));
    edges
        .map(|(a, b)| {
            let left = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
            match (a[1] <= y, b[1] <= y) {
                (true, false) if left > 0.0 => 1,
                (false, true) if left < 0.0 => -1,
                _ => 0,
            }
        })
        .sum()
}

/// A hoop with inertia: m1/m2, ℓ/R, I_zz/(m2 R²).
#[derive(Clone, Copy)]
pub(crate) struct Body {
    pub(crate) m1: f64,
    pub(crate) l: f64,
    pub(crate) izz: f64,
}

/// The hoop of Figures 2 and 3.
pub(crate) const THIN: Body = Body {
    m1: 1.0,
    l: 1.0,
    izz: 1.0,
};

impl Body {
    /// N and F of rolling by (2.11), (2.12), in the units of (2.9).
    pub(crate) fn rolling_forces(self, theta: f64, rate: f64) -> (f64, f64) {
        let m = self.m1 + 1.0;
        let h = self.l / m;
        let i = self.izz + self.m1 * self.l * self.l / m;
        let (sin, cos) = libm::sincos(theta);
        let square = rate * rate;
        let acceleration =
            (m * h * sin * square + self.l * sin) / (i + m * (1.0 + h * h + 2.0 * h * cos));
        let normal = m - self.l * (sin * acceleration + cos * square);
        let friction = -m * (1.0 + h * cos) * acceleration + self.l * sin * square;
        (normal, friction)
    }

    /// T + U of rolling by (2.8).
    pub(crate) fn energy(self, theta: f64, rate: f64) -> f64 {
        let m = self.m1 + 1.0;
        let h = self.l / m;
        let i = self.izz + self.m1 * self.l * self.l / m;
        let cos = libm::cos(theta);
        0.5 * (i + m * (1.0 + h * h + 2.0 * h * cos)) * rate * rate + self.l * cos
    }
}

/// Whether two numbers agree to a part of the larger of the first and one.
pub(crate) fn assert_near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!(
        (a - b).abs() <= tolerance * a.abs().max(1.0),
        "{what}: {a} and {b}"
    );
}
