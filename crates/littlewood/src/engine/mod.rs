//! A table-driven implementation of the same simulation, for many starts of one hoop.
//!
//! What depends on the body and the coefficients of friction alone is computed once: where the orbits of rolling slip
//! ([`roll`]), and the slides ([`slide`]). The walk along the automaton is that of [`crate::walk`], as for
//! [`Hoop::simulate`]; a phase is looked up in the tables. A phase that the tables do not resolve, with a margin close to zero, a turning
//! point, a shape of η′ that might touch zero, a slow phase, is solved exactly.

mod interpolant;
mod jump;
mod quadrature;
mod roll;
mod slide;
mod slip;
mod tabulated;

use crate::equations::SlidingLaw;
use crate::error::ParameterError;
use crate::exact::Exact;
use crate::hoop::{Body, Heavy, Hoop};
use crate::mode::Direction;
use crate::simulate::Limits;
use crate::solvability::is_solvable;
use crate::state::Start;
use crate::summary::{Summary, SummaryRecorder};
use crate::walk::walk;

use roll::RollTable;
use slide::SlideTable;
use slip::SlipTable;
use tabulated::Tabulated;

/// Lighter hoops, by Î/m, have no tables: each time the particle passes the bottom, rounding is amplified by (Î/m)^(−1/2), and
/// tables and Taylor series, which round differently, would soon diverge.
const MIN_INERTIA: f64 = 1e-3;

/// Hoops that are better balanced, by h, have no tables: the forces of rolling change by h over a turn, so that the angles at
/// which it slips are known to ε/h.
const MIN_IMBALANCE: f64 = 1e-3;

/// A hoop prepared for many motions.
///
/// ```
/// use littlewood::{Engine, Hoop, Limits, Start};
///
/// let hoop = Hoop::figure_2(0.5, 0.4)?;
/// let engine = Engine::new(&hoop);
/// let summary = engine.summary(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
/// assert_eq!(summary.sequence.to_string(), "-R+F");
/// assert!((summary.lift_off_time - 1.518_670_213_819_437).abs() < 1e-13);
/// # Ok::<(), littlewood::ParameterError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Engine {
    hoop: Hoop,
    tables: Option<Tables>,
}

#[derive(Clone, Debug)]
struct Tables {
    body: Heavy,
    /// The laws of sliding for σ = −1 and σ = +1.
    sliding: [SlidingLaw; 2],
    roll: RollTable,
    slide: SlideTable,
    slip: SlipTable,
}

impl Tables {
    const fn law_of(&self, direction: Direction) -> &SlidingLaw {
        match direction {
            Direction::Negative => &self.sliding[0],
            Direction::Positive => &self.sliding[1],
        }
    }
}

impl Engine {
    /// Prepares a hoop. There are no tables for a massless hoop, without kinetic friction, where sliding is not well posed at
    /// every angle (P ≤ 0), and for very light and nearly balanced hoops, whose motions amplify rounding: these are
    /// simulated one by one.
    #[must_use]
    pub fn new(hoop: &Hoop) -> Self {
        let tables = match hoop.body() {
            Body::Heavy(body)
                if hoop.mu_k() > 0.0
                    && body.h >= MIN_IMBALANCE
                    && body.inertia >= MIN_INERTIA * body.mass =>
            {
                // P > 0 with μs, too: then never more than one motion is consistent.
                SlideTable::new(&body, hoop.mu_k())
                    .filter(|_| is_solvable(&body, hoop.mu_s()))
                    .zip(RollTable::new(hoop))
                    .map(|(slide, roll)| {
                        let sliding =
                            Direction::ALL.map(|direction| SlidingLaw::of_body(body, hoop.mu_k(), direction));
                        let slip = SlipTable::new(&body, (hoop.mu_s(), hoop.mu_k()), &roll, &slide);
                        Tables { body, sliding, roll, slide, slip }
                    })
            }
            Body::Heavy(_) | Body::Massless(_) => None,
        };
        Self { hoop: *hoop, tables }
    }

    /// Number of starts of one hoop from which on tables save more time than they cost.
    pub const MIN_STARTS_FOR_TABLES: usize = 96;

    /// A hoop without tables, whose motions are simulated one by one: for fewer starts than [`Engine::MIN_STARTS_FOR_TABLES`].
    #[must_use]
    pub const fn without_tables(hoop: &Hoop) -> Self {
        Self { hoop: *hoop, tables: None }
    }

    /// The hoop.
    #[must_use]
    pub const fn hoop(&self) -> &Hoop {
        &self.hoop
    }

    /// Whether motions are walks through tables; otherwise they are simulated one by one.
    #[must_use]
    pub const fn has_tables(&self) -> bool {
        self.tables.is_some()
    }

    /// Number of cells of the table of slides.
    #[must_use]
    pub fn cells(&self) -> usize {
        self.tables.as_ref().map_or(0, |tables| tables.slide.cells())
    }

    /// Number of pieces of the table of slides out of rolling.
    #[must_use]
    pub fn slip_pieces(&self) -> usize {
        self.tables.as_ref().map_or(0, |tables| tables.slip.pieces())
    }

    /// The summary of one motion: that of [`Hoop::simulate`], to rounding.
    ///
    /// # Errors
    /// As [`Hoop::simulate`].
    pub fn summary(&self, start: Start, limits: Limits) -> Result<Summary, ParameterError> {
        let state = (self.hoop.check(start)?, start.gap_rate);
        limits.check(&start)?;
        let mut recorder = SummaryRecorder::new(&self.hoop);
        Ok(match &self.tables {
            Some(tables) => {
                let solver = Tabulated::new(&self.hoop, tables, limits);
                let end = walk(&solver, state, &limits, &mut recorder);
                recorder.finish(end.kind, end.state)
            }
            None => {
                let solver = Exact::new(&self.hoop, &limits);
                let outcome = walk(&solver, state, &limits, &mut recorder);
                recorder.finish(outcome.kind(), outcome.state())
            }
        })
    }
}
