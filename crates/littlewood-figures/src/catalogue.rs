//! All figures by name.

use littlewood_draw::{Figure, markdown, plain};

use crate::error::FigureError;
use crate::input::FigureInput;
use crate::paper::{
    bounces, gliding, histories, impact, loci, outcomes, overview, painleve, paths, phase_path,
    portrait, schematic, state_space, stroboscope, types,
};
use crate::si::converted;

/// A figure that can be made.
#[derive(Clone, Copy, Debug)]
pub struct FigureEntry {
    /// Name, as the command line takes it.
    pub name: &'static str,
    /// What it shows.
    pub title: &'static str,
    /// The named case that it is made of unless another hoop or start is asked for.
    pub case: &'static str,
    make: Make,
}

/// Is told how many of how many starts have been followed for a figure.
pub type Watch<'a> = dyn FnMut(u64, u64) + 'a;

#[derive(Clone, Copy, Debug)]
enum Make {
    /// From one motion, or from none.
    Soon(fn(&FigureInput) -> Result<Figure, FigureError>),
    /// From many motions, which can take long.
    OfStarts {
        /// Refuses what can be refused before the first motion.
        check: fn(&FigureInput) -> Result<(), FigureError>,
        make: fn(&FigureInput, &mut Watch<'_>) -> Result<Figure, FigureError>,
    },
}

impl FigureEntry {
    /// The figure of a hoop and a start.
    ///
    /// # Errors
    /// A hoop that the figure cannot show, or a start that is out of bounds.
    pub fn figure(&self, input: &FigureInput) -> Result<Figure, FigureError> {
        self.figure_with(input, &mut |_, _| {})
    }

    /// As [`FigureEntry::figure`]; of a figure that takes many motions `watch` is told how far it
    /// is.
    ///
    /// # Errors
    /// As [`FigureEntry::figure`].
    pub fn figure_with(
        &self,
        input: &FigureInput,
        watch: &mut Watch<'_>,
    ) -> Result<Figure, FigureError> {
        let figure = match self.make {
            Make::Soon(make) => make(input),
            Make::OfStarts { check, make } => check(input).and_then(|()| make(input, watch)),
        }?;
        Ok(finished(figure, input))
    }

    /// The figure of one motion, or of none. Of a figure that takes many motions only what it is
    /// made of is checked, so that bad input is known before the long work of any figure.
    ///
    /// # Errors
    /// As [`FigureEntry::figure`].
    pub fn figure_if_quick(&self, input: &FigureInput) -> Result<Option<Figure>, FigureError> {
        match self.make {
            Make::Soon(make) => make(input).map(|figure| Some(finished(figure, input))),
            Make::OfStarts { check, .. } => check(input).map(|()| None),
        }
    }

    /// The figure as the paper has it.
    ///
    /// # Errors
    /// None is known.
    pub fn of_the_paper(&self) -> Result<Figure, FigureError> {
        self.figure(&FigureInput::of_case(self.case)?)
    }
}

/// A figure in the units of its input, complete.
pub(crate) fn finished(mut figure: Figure, input: &FigureInput) -> Figure {
    figure.caption += input.wording().note();
    if let Some(units) = &input.units {
        figure = converted(figure, units);
    }
    figure.fitted()
}

/// A table of figures: the name, the case, the function that makes it, for one of many motions that
/// which checks it before, and what it shows.
macro_rules! figures {
    ($(
        $name:literal of $case:literal by $file:ident::$make:ident
        $(after $same:ident::$check:ident)? : $title:literal;
    )*) => {
        &[$(FigureEntry {
            name: $name,
            title: $title,
            case: $case,
            make: figures!(@ $file::$make $(, $same::$check)?),
        }),*]
    };
    (@ $make:path) => { Make::Soon($make) };
    (@ $make:path, $check:path) => { Make::OfStarts { check: $check, make: $make } };
}

/// All figures, in the order of the paper, then those that it does not have.
pub const FIGURES: &[FigureEntry] = figures! {
    "figure-1" of "figure-3" by schematic::figure: "the body and its symbols";
    "figure-2a" of "figure-3" by loci::figure:
        "loci of slip in rolling, for four coefficients of friction";
    "figure-2b" of "figure-3" by portrait::with_inertia: "phase portrait of rolling";
    "figure-3a" of "figure-3" by state_space::space: "a motion in the space of states";
    "figure-3b" of "figure-3" by paths::centres: "paths of the centre and of the mass centre";
    "figure-4" of "figure-7" by portrait::massless: "phase portrait of the rolling massless hoop";
    "figure-5a" of "figure-7" by types::regions:
        "the region R of the massless hoop and its boundaries";
    "figure-5b" of "figure-7" by types::motions: "rolling motions of Types I, II and III";
    "figure-6a" of "figure-7" by gliding::alone: "phase portrait of gliding";
    "figure-6b" of "figure-7" by gliding::combined: "rolling and gliding in one portrait";
    "figure-7a" of "figure-7" by state_space::gliding:
        "rolling, then gliding, in the phase plane and in time";
    "figure-7b" of "figure-7" by paths::particle: "path of the particle, a cycloid and a parabola";
    "forces" of "figure-3" by histories::forces:
        "normal and friction force of a motion against time";
    "energy" of "figure-3" by histories::energy: "energies of a motion against time";
    "sheet" of "figure-3" by overview::figure: "all quantities of a motion against time";
    "stroboscope" of "figure-3" by stroboscope::figure:
        "the hoop at equal intervals of time, with its forces";
    "phase-path" of "figure-3" by phase_path::figure: "a motion in the phase portrait of rolling";
    "painleve" of "painleve" by painleve::figure: "where sliding has no solution or several";
    "impact" of "figure-3-bounces" by impact::figure: "an impact in the plane of impulses";
    "bounces" of "figure-3-bounces" by bounces::figure: "gap and rates of the bounces of a motion";
    "outcomes" of "figure-3" by outcomes::figure after outcomes::check:
        "outcomes of the starts in the phase plane";
};

/// Figures that were removed, each with what serves instead.
const REMOVED: [(&str, &str); 8] = [
    (
        "atlas",
        "`outcomes` has the outcome of each start, `stroboscope` the hoop along a motion",
    ),
    (
        "friction-demand",
        "`forces` has |F|/N of a motion beside mu_s and mu_k, `figure-2a` where rolling slips",
    ),
    (
        "hodograph",
        "`forces` has F, N and |F|/N of a motion beside mu_s and mu_k",
    ),
    (
        "inertia",
        "`forces` and `stroboscope` with --mass-ratio and --inertia show a light hoop, `figure-7a` \
         the massless one",
    ),
    (
        "paper",
        "docs/theory/errata.md lists what the paper prints otherwise, `figure-2b` and `figure-6a` \
         show it",
    ),
    (
        "wall",
        "`figure-3a` has the motion in the same space, `figure-2b` the lift-off curve",
    ),
    (
        "bifurcation",
        "`littlewood sweep` has the outcomes and sequences along a line: \
         --axis theta_rate=0:4:401 --out line.parquet",
    ),
    (
        "cases",
        "`littlewood cases` lists them, `littlewood figures sheet --case NAME` shows one",
    ),
];

/// What serves instead of a figure that was removed, if one of this name was.
pub fn instead_of(name: &str) -> Option<&'static str> {
    let found = REMOVED.iter().find(|(removed, _)| *removed == name);
    found.map(|(_, instead)| *instead)
}

/// Pixels of the pictures of the gallery to one of the drawing.
pub const GALLERY_SCALE: f64 = 1.5;

const PREFACE: &str = "\
# Gallery

Every figure of A. Bronars and O. M. O'Reilly, *Gliding motions of a rigid body: the curious dynamics of Littlewood's
rolling hoop* (Proc. R. Soc. A 475, 2019), and more, computed by the library:

```sh
littlewood figures --out figures
```

It writes each figure as SVG, PDF and PNG, with its data (CSV) and its caption. With other parameters (`--mass-ratio`, …) the
figures show another hoop, in SI units if the parameters are; `--width-mm 84` fits the column of a journal, with letters of 7
to 8 points. `littlewood figures --help` has examples. Lengths are in *R*,
masses in *m*<sub>2</sub>, times in √(*R*/*g*). `cargo run -p littlewood-figures --example gallery -- docs` writes this page
and its images; a test compares them.
";

/// The page of the gallery: every figure as the paper has it, with its caption.
///
/// # Errors
/// None is known.
pub fn gallery_page() -> Result<String, FigureError> {
    let mut page = PREFACE.to_owned();
    for entry in FIGURES {
        let figure = entry.of_the_paper()?;
        page += &format!(
            "\n## {}\n\n![{}](gallery/{}.svg)\n\n{} `littlewood figures {}`\n",
            markdown(&figure.title),
            plain(&figure.title),
            entry.name,
            markdown(&figure.caption),
            entry.name
        );
    }
    Ok(page)
}

/// The figure of this name.
pub fn find_figure(name: &str) -> Option<&'static FigureEntry> {
    FIGURES.iter().find(|entry| entry.name == name)
}
