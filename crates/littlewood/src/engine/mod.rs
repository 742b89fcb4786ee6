//! A faster implementation of the same simulation, table-driven for many starts of one hoop.
//!
//! What depends on the body and the coefficients of friction alone is computed once: where the orbits of rolling slip
//! ([`roll`]), and the slides ([`slide`]). The walk along the automaton is that of [`crate::walk::follow`], as for
//! [`Hoop::simulate`]; a phase is looked up in the tables. A phase that the tables do not resolve, with a margin close to zero, a turning
//! point, a shape of η′ that might touch zero, a slow phase, is solved exactly.
//!
//! A hoop without tables has its phases from [`direct`], which computes what tables would hold where the motion goes.

mod chain;
mod direct;
mod doubt;
mod duration;
mod frictionless;
mod interpolant;
mod jump;
mod orbit;
mod piece;
mod polynomial;
mod quadrature;
mod roll;
mod slide;
mod slip;
mod solver;
mod tabulated;

use crate::ablation::{Part, is_on};
use crate::mechanics::lift_off::ContactProof;
use crate::mechanics::solvability::is_solvable;
use crate::model::error::ParameterError;
use crate::model::hoop::{Heavy, Hoop};
use crate::model::limits::Limits;
use crate::model::state::{Start, State};
use crate::motion::summary::{Summary, SummaryRecorder};
use crate::walk::exact::Exact;
use crate::walk::follow::walk;
use crate::walk::origin::Origin;
use crate::walk::proofs::Known;

use chain::Chains;
use direct::Direct;
use doubt::Doubt;
use roll::RollTable;
use slide::SlideTable;
use slip::SlipTable;
use solver::{FastSolver, Phases};

/// Lighter hoops, by Î/m, have no tables: each time the particle passes the bottom, rounding is amplified by (Î/m)^(−1/2), and
/// tables and Taylor series, which round differently, would soon diverge.
const MIN_INERTIA: f64 = 1e-3;

/// Motions of still lighter hoops are simulated: their rounding, at every step, tells more than that of the start of a phase.
const MIN_INERTIA_DIRECT: f64 = 1e-4;

/// Hoops that are better balanced, by h, have no tables: the forces of rolling change by h over a turn, so that the angles at
/// which it slips are known to ε/h.
const MIN_IMBALANCE: f64 = 1e-3;

/// Hoops with less static friction, if there is any, are simulated: where |F| = μs N they slip at angles that are known to ε/μs.
const MIN_FRICTION: f64 = 1e-9;

/// To motions of fewer transitions chains are not worth what is prepared for them.
const MIN_CHAIN_TRANSITIONS: usize = 256;

/// Whether phases of a body of at least so much inertia, as a part of its mass, are computed otherwise than in the simulation.
fn is_computed(hoop: &Hoop, body: &Heavy, least_inertia: f64) -> bool {
    let resolves_slips = hoop.mu_s() == 0.0 || hoop.mu_s() >= MIN_FRICTION;
    resolves_slips && body.h >= MIN_IMBALANCE && body.inertia >= least_inertia * body.mass
}

/// A hoop prepared for many motions.
///
/// The outcome, the sequence and the number of transitions of a motion are those of [`Hoop::simulate`], with tables or without. Times, states and energies may differ from it in their last
/// digits, and so between an engine with tables and one without.
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
    source: Source,
    /// What proofs have found of the hoop.
    contact: ContactProof,
}

/// Where phases come from.
#[derive(Clone, Debug)]
#[expect(
    clippy::large_enum_variant,
    reason = "where each start has a hoop of its own, an allocation for each would cost more"
)]
enum Source {
    /// Tables, prepared once.
    Tables(Box<Tables>),
    /// What tables would hold, computed where the motion goes.
    Direct(Direct),
    /// The same, but chains of slips are passed by whole links.
    Chained(Box<(Direct, Chains)>),
    /// The solutions of the simulation.
    Exact,
}

#[derive(Clone, Debug)]
struct Tables {
    /// What the tables do not resolve.
    direct: Direct,
    roll: RollTable,
    slide: SlideTable,
    slip: SlipTable,
    chains: Chains,
    /// P > 0 at every angle, with μs, too: then never more than one motion is consistent.
    is_solvable: bool,
}

impl Engine {
    /// Prepares a hoop. There are no tables for a massless hoop, and for very light and nearly
    /// balanced hoops, whose motions amplify rounding. Arcs on which sliding is not well posed (P ≤ 0) are left out of them.
    #[must_use]
    pub fn new(hoop: &Hoop) -> Self {
        let tables = Direct::new(hoop)
            .filter(|direct| is_computed(hoop, direct.body(), MIN_INERTIA))
            .and_then(|direct| {
                let body = *direct.body();
                let (slide, roll) = SlideTable::new(&body, hoop.mu_k()).zip(RollTable::new(hoop))?;
                let slip = SlipTable::new(&body, (hoop.mu_s(), hoop.mu_k()), &roll, &slide);
                let chains = Chains::new(hoop, &body, &roll);
                let is_solvable = [hoop.mu_s(), hoop.mu_k()].into_iter().all(|mu| is_solvable(&body, mu));
                Some(Tables { direct, roll, slide, slip, chains, is_solvable })
            });
        match tables {
            Some(tables) => Self::with(hoop, Source::Tables(Box::new(tables))),
            None => Self::without_tables(hoop).with_chains(),
        }
    }

    /// The same engine, which passes chains of slips by whole links.
    fn with_chains(self) -> Self {
        let Self { hoop, source, .. } = self;
        let source = match source {
            // Without kinetic friction chains are not passed.
            Source::Direct(direct) => match RollTable::new(&hoop).filter(|_| hoop.mu_k() > 0.0) {
                Some(roll) => {
                    let chains = Chains::new(&hoop, direct.body(), &roll);
                    Source::Chained(Box::new((direct, chains)))
                }
                None => Source::Direct(direct),
            },
            source @ (Source::Tables(_) | Source::Chained(_) | Source::Exact) => source,
        };
        Self::with(&hoop, source)
    }

    /// Number of starts of one hoop from which on tables save more time than they cost.
    pub const MIN_STARTS_FOR_TABLES: usize = 256;

    /// A hoop without tables: for fewer starts than [`Engine::MIN_STARTS_FOR_TABLES`]. Nothing is prepared.
    #[must_use]
    pub fn without_tables(hoop: &Hoop) -> Self {
        let direct = Direct::new(hoop).filter(|direct| is_computed(hoop, direct.body(), MIN_INERTIA_DIRECT));
        let source = direct.map_or(Source::Exact, Source::Direct);
        Self::with(hoop, source)
    }

    fn with(hoop: &Hoop, source: Source) -> Self {
        Self { hoop: *hoop, source, contact: ContactProof::default() }
    }

    /// The hoop.
    #[must_use]
    pub const fn hoop(&self) -> &Hoop {
        &self.hoop
    }

    /// Whether motions are walks through tables.
    #[must_use]
    pub const fn has_tables(&self) -> bool {
        matches!(self.source, Source::Tables(_))
    }

    /// Whether chains of slips out of rolling are passed at once, thousands of them in the time of some twenty phases.
    #[must_use]
    pub const fn passes_chains(&self) -> bool {
        // Without kinetic friction slides come back to the limit of static friction exactly, which the walk alone knows.
        self.hoop.mu_k() > 0.0 && matches!(self.source, Source::Tables(_) | Source::Chained(_))
    }

    /// Whether motions are those of [`Hoop::simulate`] to the last bit.
    #[must_use]
    pub const fn is_exact(&self) -> bool {
        matches!(self.source, Source::Exact)
    }

    /// Number of cells of the table of slides.
    #[must_use]
    pub fn cells(&self) -> usize {
        match &self.source {
            Source::Tables(tables) => tables.slide.cells(),
            Source::Direct(_) | Source::Chained(_) | Source::Exact => 0,
        }
    }

    /// Number of pieces of the table of slides out of rolling.
    #[must_use]
    pub fn slip_pieces(&self) -> usize {
        match &self.source {
            Source::Tables(tables) => tables.slip.pieces(),
            Source::Direct(_) | Source::Chained(_) | Source::Exact => 0,
        }
    }

    /// The summary of one motion: that of [`Hoop::simulate`], to rounding.
    ///
    /// # Errors
    /// As [`Hoop::simulate`].
    pub fn summary(&self, start: Start, limits: Limits) -> Result<Summary, ParameterError> {
        let state = self.hoop.check(start)?;
        limits.check(&start)?;
        let (origin, state, limits) = Origin::of(state, limits);
        let state = (state, start.gap_rate);
        let recorder = SummaryRecorder::new(&self.hoop, origin);
        Ok(match &self.source {
            Source::Tables(tables) => {
                self.fast_summary(tables.as_ref(), Some(&tables.chains), (state, limits), recorder)
            }
            Source::Chained(chained) => {
                self.fast_summary(&chained.0, Some(&chained.1), (state, limits), recorder)
            }
            Source::Direct(direct) => self.fast_summary(direct, None, (state, limits), recorder),
            Source::Exact => self.exact_summary((state, limits), recorder),
        })
    }

    fn exact_summary(
        &self,
        (state, limits): ((State, f64), Limits),
        mut recorder: SummaryRecorder<'_>,
    ) -> Summary {
        let solver = Exact::new(&self.hoop, &limits);
        let outcome = walk(&solver, state, (&limits, self.known(None)), &mut recorder);
        recorder.finish(outcome.kind(), outcome.state())
    }

    fn fast_summary<P: Phases>(
        &self,
        phases: &P,
        chains: Option<&Chains>,
        (state, limits): ((State, f64), Limits),
        empty: SummaryRecorder<'_>,
    ) -> Summary {
        let chains = chains.filter(|_| {
            is_on(Part::Chains) && limits.transitions >= MIN_CHAIN_TRANSITIONS && self.passes_chains()
        });
        let solver = FastSolver::new(&self.hoop, phases, chains, limits);
        let mut recorder = empty;
        let end = walk(&solver, state, (&limits, self.known(chains)), &mut recorder);
        if solver.is_in_doubt() {
            return self.exact_summary((state, limits), empty);
        }
        recorder.finish(end.kind, end.state)
    }

    fn known<'a>(&'a self, chains: Option<&'a Chains>) -> Known<'a> {
        Known { levels: chains.and_then(Chains::levels), contact: Some(&self.contact) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::hoop::HoopParameters;
    use crate::walk::automaton::Cause;
    use crate::walk::follow::Solver;
    use crate::walk::links::Room;

    /// How many of the decisions and phases of a plane are left to the exact solver.
    fn left_to_the_exact_solver<P: Phases>(hoop: &Hoop, phases: &P) -> (usize, [usize; 3]) {
        let solver = FastSolver::new(hoop, phases, None, Limits::default());
        let (mut all, mut left) = (0, [0; 3]);
        let steps = 60;
        for (i, j) in (0..steps).flat_map(|i| (0..steps).map(move |j| (f64::from(i), f64::from(j)))) {
            let part = |k: f64| (2.0 * k + 1.0) / f64::from(steps) - 1.0;
            for slip in [-0.5, 0.0, 0.5] {
                let start = Start::at(core::f64::consts::PI * part(i), 3.0 * part(j)).with_slip(slip);
                all += 1;
                for (left, count) in left.iter_mut().zip(solver.left_to_the_exact_solver(start)) {
                    *left += usize::from(count);
                }
            }
        }
        (all, left)
    }

    /// Whatever is left to the exact solver has the same answer, only later, which no test of answers would notice.
    #[test]
    fn little_is_left_to_the_exact_solver() {
        let figure_2 = Hoop::figure_2(0.5, 0.4).unwrap();
        let painleve = HoopParameters::new(0.2, 1.0, 0.1).with_friction(1.5, 1.4);
        let painleve = Hoop::new(painleve).unwrap();
        let tabulated = match &Engine::new(&figure_2).source {
            Source::Tables(tables) => left_to_the_exact_solver(&figure_2, tables.as_ref()),
            source => panic!("{source:?}"),
        };
        let [direct, direct_painleve] =
            [figure_2, painleve].map(|hoop| match &Engine::without_tables(&hoop).source {
                Source::Direct(direct) => left_to_the_exact_solver(&hoop, direct),
                source => panic!("{source:?}"),
            });
        let (all, left) = tabulated;
        assert!(left.iter().all(|count| 1000 * count < all), "{left:?} of {all}");
        let (all, left) = direct;
        assert!(left.iter().all(|count| 100 * count < all), "{left:?} of {all}");
        let tabulated_painleve = match &Engine::new(&painleve).source {
            Source::Tables(tables) => left_to_the_exact_solver(&painleve, tables.as_ref()),
            source => panic!("{source:?}"),
        };
        // Where P ≤ 0 for a direction the exact rules decide.
        for (all, [_, rolls, slides]) in [direct_painleve, tabulated_painleve] {
            assert!(100 * rolls < all && 100 * slides < all, "{rolls} {slides} of {all}");
        }
    }

    /// How many transitions are passed at once from the last slip of the motion from a start that is simulated for so many.
    fn passed_from(hoop: &Hoop, start: Start, transitions: usize) -> usize {
        let engine = Engine::new(hoop);
        let Source::Tables(tables) = &engine.source else { panic!("{:?}", engine.source) };
        let motion = hoop.simulate(start, Limits::default().with_transitions(transitions)).unwrap();
        let slip = motion.transitions().iter().rfind(|one| one.cause == Cause::Slip).unwrap();
        let solver = FastSolver::new(hoop, tables.as_ref(), Some(&tables.chains), Limits::default());
        let room = Room { transitions: 5_000, slides: f64::INFINITY, are_told: false, open: None };
        let place = solver.place(slip.before);
        let linked = solver.pass_links(&place, slip.direction.unwrap(), &room).expect("links");
        linked.transitions as usize
    }

    /// The closer the coefficients, the closer to a grazing orbit a motion goes, and the less the level of its orbit tells where it slips.
    #[test]
    fn slips_towards_a_grazing_orbit_are_passed_by_the_thousand() {
        for mu_k in [0.498, 0.499, 0.4999] {
            let hoop = Hoop::figure_2(0.5, mu_k).unwrap();
            let passed = passed_from(&hoop, Start::at(-3.0, -2.5), 4_000);
            assert!(passed > 1_000, "{mu_k}: {passed}");
        }
    }

    /// With little friction grazing orbits slip where they turn, at an angle that hardly tells them apart.
    #[test]
    fn slips_next_to_turning_points_are_passed_by_the_hundred() {
        for (mass_ratio, offset, inertia, mu_s, mu_k, start) in [
            (2.0, 1.0, 0.5, 0.2, 0.1999, Start::at(2.336, 0.92)),
            (0.0985, 0.779, 0.0662, 0.0915, 0.091489, Start::at(2.336, 0.92)),
            (0.551, 0.993, 0.124, 0.0637, 0.0636968, Start::at(2.336, 0.92)),
            // There are no links at most rates, but at the lowest.
            (0.22784, 0.33068, 0.17859, 0.078342, 0.078332, Start::at(0.527, -0.295)),
        ] {
            let parameters = HoopParameters::new(mass_ratio, offset, inertia).with_friction(mu_s, mu_k);
            let hoop = Hoop::new(parameters).unwrap();
            let passed = passed_from(&hoop, start, 500);
            assert!(passed > 300, "{mu_s} {mu_k}: {passed}");
        }
    }
}
