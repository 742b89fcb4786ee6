//! A faster implementation of the same simulation, for many starts.
//!
//! The walk along the automaton is that of [`crate::walk`], as for [`Hoop::simulate`]; the phases
//! are other solutions of the same equations ([`model`]): slides are followed in the angle
//! ([`slide`]), those out of rolling interpolated ([`slip_slides`]), rolling along its orbit
//! ([`roll`]), with rolling resistance in the angle, too ([`resisted`]), with half swings that are
//! interpolated ([`half_swings`]). What depends on the hoop alone is kept, and chains of slips are passed by whole links
//! ([`chain`]). A phase that these do not resolve to rounding is left to the solvers of the
//! simulation, for a reason that is counted ([`Fallback`]).

mod builder;
mod chain;
mod duration;
mod error_bound;
mod fallback;
mod half_swings;
mod interpolant;
mod jump;
mod model;
mod orbit;
mod quadrature;
mod resisted;
mod roll;
mod slide;
mod slip_slides;
mod slope;
mod solver;
mod state;
mod survey;

use std::sync::OnceLock;

use crate::ablation::{Part, is_on};
use crate::mechanics::ContactProof;
use crate::model::{Heavy, Hoop, Limits, ParameterError, Start};
use crate::motion::summary::{Summary, SummaryRecorder};
use crate::walk::{Exact, Origin, RelativeStart, SharedProofData, WalkSettings, walk};

pub use builder::{EngineBuilder, StartError};
use chain::SlipMaps;
pub use fallback::Fallback;
use model::HoopModel;
use solver::FastSolver;

/// Motions of lighter hoops, by Î/m, are simulated: each time the particle passes the bottom,
/// rounding is amplified by (Î/m)^(−1/2), and that of every step tells more than that of the start
/// of a phase.
const MIN_INERTIA: f64 = 1e-4;

/// So are those of hoops that are better balanced, by h: the forces of rolling change by h over a
/// turn, so that the angles at which it slips are known to ε/h.
const MIN_IMBALANCE: f64 = 1e-3;

/// So are those with less static friction, if there is any: where |F| = μs N they slip at angles
/// that are known to ε/μs.
const MIN_FRICTION: f64 = 1e-9;

/// So are those on steeper planes, by |tan α|: the pull along the plane is so much more than the
/// force normal to it, the unit here, that a rounded time tells in the slip.
const MAX_TILT: f64 = 100.0;

/// To motions of fewer transitions chains are not worth what is prepared for them.
const MIN_CHAIN_TRANSITIONS: usize = 256;

/// A hoop prepared for many motions.
///
/// The codes and counts of a summary are those of [`Hoop::simulate`]: outcome, sequence, number of
/// transitions and of landings, and whether a Painlevé paradox was met. Times, states and energies
/// may differ from it in their last digits, and so between an engine for many starts and one for
/// few. The repository's `docs/engine.md` has the bound of each column.
///
/// This rests on an assumption about rounding. Each decision is the sign of a computed number. Where
/// such a number is closer to zero than a bound on its rounding, the rules of the simulation decide
/// if the state is that of the simulation to the bit; otherwise the motion is simulated up to there.
/// These bounds are derived from the sizes of the terms, but for two: a slide that passes
/// within 10⁻⁹ of the end of contact or slip, relative to the terms, is solved by the simulation;
/// and after landings the numbers that decide an impact are taken to be larger than the accumulated
/// error of the state, which is at most 10⁻⁴. Ends of slides out of rolling are interpolated to
/// rounding; that no other event comes before is proved for each of them. The tests
/// (`tests/promise.rs`, `tests/engine.rs`) compare hundreds of thousands of motions with their
/// simulations; no proof excludes a motion that violates this.
/// [`EngineBuilder::interpolate_slips`] promises less.
///
/// ```
/// use littlewood::{Engine, Hoop, Limits, Start};
///
/// let hoop = Hoop::equal_masses(0.5, 0.4)?;
/// let engine = Engine::new(&hoop);
/// let summary = engine.summary(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
/// assert_eq!(summary.sequence.to_string(), "-R+F");
/// assert!((summary.lift_off_time - 1.518_670_213_819_437).abs() < 1e-13);
/// # Ok::<(), littlewood::ParameterError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Engine {
    hoop: Hoop,
    /// None where motions are simulated.
    model: Option<HoopModel>,
    /// For all directions of motion, or on a slope for each, made when a motion first needs them; none
    /// where slips are followed one by one.
    slip_maps: Option<OnceLock<Vec<SlipMaps>>>,
    /// Phases of a motion before slips are passed by these maps.
    phases_before_links: u32,
    /// Whether tables are used from the first phase of a motion on.
    is_prepared: bool,
    /// Whether slides out of rolling are interpolated.
    interpolates_slides: bool,
    contact: ContactProof,
}

/// A motion, perhaps up to a decision that is in doubt.
struct Attempt {
    summary: Summary,
    is_lost: bool,
}

impl Engine {
    /// An engine for many starts of a hoop.
    #[must_use]
    pub fn new(hoop: &Hoop) -> Self {
        let engine = Self::for_few_starts(hoop);
        Self {
            is_prepared: engine.model.is_some(),
            interpolates_slides: true,
            ..engine
        }
    }

    fn with_slip_maps(self, phases_before_links: u32) -> Self {
        // Without kinetic friction slides come back to the limit of static friction exactly, which
        // the walk decides by symmetry. With rolling resistance there are few slips.
        let is_chained = self.hoop.mu_k() > 0.0 && self.hoop.rolling_resistance() == 0.0;
        let model = self.model.as_ref().filter(|_| is_chained);
        Self {
            slip_maps: model.map(|_| OnceLock::new()),
            phases_before_links,
            ..self
        }
    }

    /// An engine for few starts. Nothing is prepared.
    fn for_few_starts(hoop: &Hoop) -> Self {
        let resolves_slips = hoop.mu_s() == 0.0 || hoop.mu_s() >= MIN_FRICTION;
        let is_computed = |Heavy {
                               mass,
                               h,
                               inertia,
                               tilt,
                               ..
                           }: Heavy| {
            resolves_slips
                && h >= MIN_IMBALANCE
                && inertia >= MIN_INERTIA * mass
                && tilt.abs() <= MAX_TILT
        };
        Self {
            hoop: *hoop,
            model: HoopModel::new(hoop).filter(|model| is_computed(model.body)),
            slip_maps: None,
            phases_before_links: 0,
            is_prepared: false,
            interpolates_slides: false,
            contact: ContactProof::default(),
        }
    }

    /// The hoop.
    pub const fn hoop(&self) -> &Hoop {
        &self.hoop
    }

    /// Whether it is prepared for many starts.
    pub const fn is_prepared(&self) -> bool {
        self.is_prepared
    }

    /// Whether chains of slips are interpolated ([`EngineBuilder::interpolate_slips`]).
    pub const fn interpolates_slips(&self) -> bool {
        self.slip_maps.is_some()
    }

    /// Whether motions are those of [`Hoop::simulate`] to the last bit.
    pub const fn is_exact(&self) -> bool {
        self.model.is_none()
    }

    /// How many phases were left to the solvers of the simulation so far, by the reason, and how
    /// often a motion was, from its start up to a doubt ([`Fallback::Drift`]).
    pub fn fallbacks(&self) -> impl Iterator<Item = (Fallback, u64)> {
        self.model.iter().flat_map(|model| model.fallbacks.counts())
    }

    /// The summary of one motion: that of [`Hoop::simulate`], to rounding.
    ///
    /// # Errors
    /// As [`Hoop::simulate`].
    pub fn summary(&self, start: Start, limits: Limits) -> Result<Summary, ParameterError> {
        self.hoop.check(start)?;
        limits.check(&start)?;
        let (origin, start, limits) = Origin::of(&self.hoop, &start, limits);
        Ok(match &self.model {
            Some(model) => self.fast_summary(model, &origin, start, &limits),
            None => self.exact_summary(&origin, start, &limits),
        })
    }

    fn exact_summary(&self, origin: &Origin, start: RelativeStart, limits: &Limits) -> Summary {
        let mut recorder = SummaryRecorder::new(&self.hoop, origin);
        let solver = Exact::new(&self.hoop, limits);
        let settings = WalkSettings {
            limits,
            shared: self.shared_proof_data(None),
        };
        let outcome = walk(&solver, start, settings, &mut recorder);
        recorder.finish(outcome.kind(), outcome.state())
    }

    /// The summary of a motion that is computed as far as all decisions are certain. Where one is
    /// in doubt it begins anew, simulated up to there, and computed behind that.
    fn fast_summary(
        &self,
        model: &HoopModel,
        origin: &Origin,
        start: RelativeStart,
        limits: &Limits,
    ) -> Summary {
        let mut simulated_phases = 0;
        loop {
            let Attempt { summary, is_lost } =
                self.attempt(model, origin, start, limits, simulated_phases);
            if !is_lost {
                return summary;
            }
            model.fallbacks.add(Fallback::Drift);
            // The phase behind the last transition is in doubt, too. At least twice as many each
            // time: where all is in doubt the whole motion is simulated after few attempts.
            simulated_phases = summary
                .transitions
                .saturating_add(1)
                .max(simulated_phases.saturating_mul(2));
        }
    }

    /// A motion whose first phases, so many, are those of the simulation.
    #[inline]
    fn attempt(
        &self,
        model: &HoopModel,
        origin: &Origin,
        start: RelativeStart,
        limits: &Limits,
        simulated_phases: u32,
    ) -> Attempt {
        let slip_maps = self.slip_maps.as_ref();
        let slip_maps = slip_maps
            .filter(|_| is_on(Part::Chains) && limits.transitions >= MIN_CHAIN_TRANSITIONS);
        let solver = FastSolver::new(&self.hoop, model, limits)
            .with_slip_maps(slip_maps, self.phases_before_links)
            .with_interpolated_slides(self.interpolates_slides)
            .behind_simulated(simulated_phases);
        let solver = if self.is_prepared {
            solver
        } else {
            solver.for_few_starts()
        };
        let mut recorder = SummaryRecorder::new(&self.hoop, origin);
        let settings = WalkSettings {
            limits,
            shared: self.shared_proof_data(slip_maps.map(|_| model)),
        };
        let end = walk(&solver, start, settings, &mut recorder);
        Attempt {
            summary: recorder.finish(end.kind, end.state),
            is_lost: solver.is_lost(),
        }
    }

    /// With the levels of the slip maps of a model, if slips are passed by these.
    fn shared_proof_data(&self, model: Option<&HoopModel>) -> SharedProofData<'_> {
        // Slips shrink towards a level with equal coefficients only.
        let model = model.filter(|_| self.hoop.mu_s() == self.hoop.mu_k());
        let maps = model.and_then(|model| {
            let maps = self.slip_maps.as_ref()?;
            maps.get_or_init(|| SlipMaps::new(&self.hoop, model))
                .first()
        });
        SharedProofData {
            levels: maps.and_then(SlipMaps::levels),
            contact: Some(&self.contact),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{HoopParameters, Restitution, RestitutionLaw};
    use crate::walk::solver::SkipBudget;
    use crate::walk::{Cause, Solver};

    impl Engine {
        fn simulated(&self, start: Start, limits: Limits) -> Summary {
            let (origin, start, limits) = Origin::of(&self.hoop, &start, limits);
            self.exact_summary(&origin, start, &limits)
        }

        fn attempted(&self, start: Start, limits: Limits, simulated_phases: u32) -> Attempt {
            let (origin, start, limits) = Origin::of(&self.hoop, &start, limits);
            let model = self.model.as_ref().unwrap();
            self.attempt(model, &origin, start, &limits, simulated_phases)
        }
    }

    /// How many transitions are passed at once from the last slip of the motion from a start that
    /// is simulated for so many.
    fn passed_from(hoop: &Hoop, start: Start, transitions: usize) -> usize {
        let engine = Engine::builder(hoop).interpolate_slips().build();
        let (model, maps) = engine
            .model
            .as_ref()
            .zip(engine.slip_maps.as_ref())
            .unwrap();
        let motion = hoop
            .simulate(start, Limits::default().with_transitions(transitions))
            .unwrap();
        let slip = motion
            .transitions()
            .iter()
            .rfind(|one| one.cause == Cause::Slip)
            .unwrap();
        let solver = FastSolver::new(hoop, model, &Limits::default()).with_slip_maps(Some(maps), 0);
        let budget = SkipBudget {
            transitions: 5_000,
            slide_cost: f64::INFINITY,
            record_phases: false,
            open: None,
        };
        let point = solver.point(slip.before);
        let linked = solver
            .skip_links(&point, slip.direction.unwrap(), &budget)
            .expect("links");
        linked.transitions as usize
    }

    /// Up to any place in its motion an attempt is the simulation, to the last bit, and behind that
    /// it leads to the same end.
    #[test]
    fn an_attempt_is_the_simulation_up_to_where_it_is_told() {
        let restitution = Restitution::new(0.5, RestitutionLaw::Energetic).unwrap();
        let hoop = Hoop::equal_masses(0.5, 0.4).unwrap();
        let hoop = hoop.with_restitution(restitution).unwrap();
        let (engine, mut computed) = (Engine::new(&hoop), 0);
        for k in 0..40_u16 {
            let start = Start::at(0.31 * f64::from(k), 4.0 - 0.2 * f64::from(k));
            let all = engine.simulated(start, Limits::default());
            for phases in (0..=all.transitions).step_by(3) {
                let limits = Limits::default().with_transitions(phases.max(1) as usize);
                let [simulated, ours] = [
                    engine.simulated(start, limits),
                    engine.attempted(start, limits, phases.max(1)).summary,
                ];
                assert_eq!(format!("{ours:?}"), format!("{simulated:?}"), "{start:?}");
                let whole = engine.attempted(start, Limits::default(), phases);
                computed += u32::from(format!("{:?}", whole.summary) != format!("{all:?}"));
                let same = |ours: &Summary| (ours.outcome, ours.sequence, ours.transitions);
                assert!(
                    whole.is_lost || same(&whole.summary) == same(&all),
                    "{start:?}"
                );
            }
        }
        assert!(computed > 100, "{computed}");
    }

    /// Up to a limit of time the phases of a few periods are solved, however many there are.
    #[test]
    fn periods_on_a_smooth_plane_are_skipped() {
        let hoop = Hoop::equal_masses(0.0, 0.0).unwrap();
        let engine = Engine::new(&hoop);
        let model = engine.model.as_ref().unwrap();
        let limits = Limits::until(2_000.0);
        let (origin, start, limits) = Origin::of(&hoop, &Start::at(-2.0, -0.5), limits);
        let solver = FastSolver::new(&hoop, model, &limits);
        let mut recorder = SummaryRecorder::new(&hoop, &origin);
        let settings = WalkSettings {
            limits: &limits,
            shared: engine.shared_proof_data(None),
        };
        walk(&solver, start, settings, &mut recorder);
        let summary = recorder.finish(crate::walk::OutcomeKind::TimeLimit, start.state);
        assert!(summary.transitions > 300, "{}", summary.transitions);
        assert!(solver.phases() < 60, "{}", solver.phases());
    }

    /// Maps are made for long motions alone where few starts would pay for them: an ordinary motion
    /// has the bits of one that is followed slip by slip, and a long one its end.
    #[test]
    fn short_motions_of_few_starts_are_followed_slip_by_slip() {
        let hoop = Hoop::equal_masses(0.5, 0.499).unwrap();
        let followed = Engine::builder(&hoop).expected_starts(256).build();
        let [few, many] = [256, 4_096].map(|starts| {
            let builder = Engine::builder(&hoop).expected_starts(starts);
            builder.interpolate_slips().build()
        });
        let (mut interpolated, mut long) = (0, 0);
        for k in 0..256_u16 {
            let start = Start::at(0.4 * f64::from(k % 16) - 3.0, 0.5 * f64::from(k / 16) - 3.9);
            let [one, other, mapped] = [&followed, &few, &many]
                .map(|engine| engine.summary(start, Limits::default()).unwrap());
            let ends = [one, other].map(|it| (it.outcome, it.sequence, it.transitions));
            assert_eq!(ends[0], ends[1], "{start:?}");
            let [one, other, mapped] = [one, other, mapped].map(|it| format!("{it:?}"));
            if ends[0].2 < 100 {
                assert_eq!(one, other, "{start:?}");
                interpolated += u32::from(one != mapped);
            } else {
                long += u32::from(one != other);
            }
        }
        assert!(interpolated > 0 && long > 0, "{interpolated} {long}");
    }

    /// The closer the coefficients, the closer to a grazing orbit a motion goes, and the less the
    /// level of its orbit tells where it slips.
    #[test]
    fn slips_towards_a_grazing_orbit_are_passed_by_the_thousand() {
        for mu_k in [0.498, 0.499, 0.4999] {
            let hoop = Hoop::equal_masses(0.5, mu_k).unwrap();
            let passed = passed_from(&hoop, Start::at(-3.0, -2.5), 4_000);
            assert!(passed > 1_000, "{mu_k}: {passed}");
        }
    }

    /// A hoop that goes over the top of a gentle slope slips in each turn, as in the turn before.
    #[test]
    fn slips_down_a_slope_are_passed_by_the_thousand() {
        let level = Hoop::equal_masses(0.5, 0.4).unwrap();
        for (slope, rate) in [(0.005, 2.0), (-0.005, -2.0), (0.01, 2.0)] {
            let hoop = Hoop::new(level.parameters().with_slope(slope)).unwrap();
            let passed = passed_from(&hoop, Start::at(3.0 * rate / 2.0, rate), 200);
            assert!(passed > 1_000, "{slope}: {passed}");
        }
    }

    /// With little friction grazing orbits slip where they turn, at an angle that hardly tells them
    /// apart.
    #[test]
    fn slips_next_to_turning_points_are_passed_by_the_hundred() {
        for (mass_ratio, offset, inertia, mu_s, mu_k, start) in [
            (2.0, 1.0, 0.5, 0.2, 0.1999, Start::at(2.336, 0.92)),
            (
                0.0985,
                0.779,
                0.0662,
                0.0915,
                0.091489,
                Start::at(2.336, 0.92),
            ),
            (
                0.551,
                0.993,
                0.124,
                0.0637,
                0.0636968,
                Start::at(2.336, 0.92),
            ),
            // There are no links at most rates, but at the lowest.
            (
                0.22784,
                0.33068,
                0.17859,
                0.078342,
                0.078332,
                Start::at(0.527, -0.295),
            ),
        ] {
            let parameters = HoopParameters::thin(mass_ratio)
                .with_offset(offset)
                .with_inertia(inertia)
                .with_friction(mu_s, mu_k);
            let hoop = Hoop::new(parameters).unwrap();
            let passed = passed_from(&hoop, start, 500);
            assert!(passed > 300, "{mu_s} {mu_k}: {passed}");
        }
    }
}
