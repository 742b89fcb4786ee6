//! A wall chart: the paper on a page.

use littlewood_draw::Figure;

use crate::catalogue::{Watch, find_figure, finished};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::page::{Page, Paper, STORY, SUBTITLE, TITLE};
use crate::paper::stroboscope;

/// Sides of the wall chart in millimetres: A2.
pub const CHART_MM: [f64; 2] = [594.0, 420.0];

const PAPER: Paper = Paper {
    name: "chart",
    title: "Gliding motions of a rigid body",
    caption: "The figures of the paper and its main results on a page.",
    sides_mm: CHART_MM,
    columns: 6,
};

const SUBJECT: &str = "The curious dynamics of Littlewood's rolling hoop, a paper of A. Bronars and O. M. O'Reilly (Proc. R. Soc. A 475, 2019), on a page.";

/// One of the two parts of the paper.
struct Half {
    title: &'static str,
    results: &'static [&'static str],
    /// Its hoop and motion, shown in equal times.
    case: &'static str,
    figures: &'static [&'static str],
}

const HALVES: [Half; 2] = [
    Half {
        title: "§2: A hoop with inertia rolls, slides and jumps",
        results: &[
            "It rolls in 𝓡, where |*F*| ≤ *μ*_{s}*N* and *N* > 0, along a line of constant energy; where it leaves 𝓡 it slips.",
            "Sliding, it leaves the plane where *h* cos *θ* *θ*′^{2} = 1, whatever the friction; in flight its mass centre follows a parabola.",
            "With much friction a slide may have no solution, or two (not in the paper): the hoop jams, an impact without a collision.",
        ],
        case: "figure-3",
        figures: &[
            "figure-1",
            "figure-2a",
            "figure-2b",
            "figure-3a",
            "outcomes",
            "painleve",
        ],
    },
    Half {
        title: "§3: Littlewood's hoop, without mass, rolls, glides and never jumps",
        results: &[
            "Rolling has |*F*|/*N* = |tan *θ*/2| and *N* = cos^{2} *θ*/2 (1 − *θ*′^{2}): it ends on *n* (Type I), on *f* (Type III) or in a corner of 𝓡 (Type II).",
            "Where *N* vanishes the particle is on its way down (3.11), so that the hoop does not jump there.",
            "A hoop without mass that slips feels no force: it glides, *N* = *F* = 0, and the particle falls freely, on a parabola or a vertical line.",
        ],
        case: "figure-7",
        figures: &[
            "figure-4",
            "figure-5a",
            "figure-5b",
            "figure-6a",
            "figure-6b",
            "figure-7b",
        ],
    },
];

impl Half {
    /// The input of its motion, and its figures.
    fn drawn(&self, watch: &mut Watch<'_>) -> Result<(FigureInput, Vec<Figure>), FigureError> {
        let figure = |name: &&str| {
            let entry = find_figure(name)?;
            let input = FigureInput::of_case(entry.case);
            Some(input.and_then(|input| entry.figure_with(&Page::input_of_column(&input), watch)))
        };
        let figures = self
            .figures
            .iter()
            .filter_map(figure)
            .collect::<Result<_, _>>()?;
        Ok((FigureInput::of_case(self.case)?, figures))
    }
}

/// The figures of the paper and its main results on a page: on the left the hoop with inertia, on the
/// right Littlewood's hoop, each above all in equal times with its forces.
///
/// # Errors
/// None is known.
pub fn chart(watch: &mut Watch<'_>) -> Result<Figure, FigureError> {
    let mut drawn = Vec::new();
    for half in &HALVES {
        drawn.push((half, half.drawn(watch)?));
    }
    Ok(Page::written(PAPER, |page| {
        let all = page.all_columns(0.0);
        page.lines(PAPER.title, &all, 58.0, TITLE);
        let y = page.lines(SUBJECT, &all, 108.0, SUBTITLE);
        page.rule(&all, y);
        let of_half = PAPER.columns / HALVES.len();
        let mut end = y;
        for (i, (half, (input, figures))) in drawn.iter().enumerate() {
            let columns = |page: &Page, top| page.columns(i * of_half, of_half, top);
            let mut top = page.lines(half.title, &columns(page, y), y + 30.0, SUBTITLE);
            for result in half.results {
                top = page.lines(result, &columns(page, y), top, STORY);
            }
            let mut columns = columns(page, top);
            if let Ok(hero) = stroboscope::bolder(&columns.input_across(input)) {
                page.across(&finished(hero, input), &mut columns);
            }
            for figure in figures {
                page.stack(figure, &mut columns);
            }
            end = f64::max(end, page.laws(input, &columns));
        }
        page.colophon(&all, end)
    }))
}
