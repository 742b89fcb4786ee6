//! The motions of the paper, and some beyond it, by name.
//!
//! ```
//! use littlewood::cases::{CASES, find_case};
//!
//! let names: Vec<&str> = CASES.iter().map(|case| case.name).collect();
//! assert!(names.contains(&"figure-3"));
//! let motion = find_case("figure-3").expect("a named case").simulate()?;
//! assert_eq!(motion.phases().len(), 4);
//! # Ok::<(), littlewood::ParameterError>(())
//! ```

use core::f64::consts::{FRAC_PI_2, FRAC_PI_6};

use crate::model::{Hoop, HoopParameters, Limits, ParameterError, RestitutionLaw, Setup, Start};
use crate::motion::trajectory::Trajectory;

/// A named motion: a hoop and a start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NamedCase {
    /// Name on the command line.
    pub name: &'static str,
    /// Description of the motion.
    pub title: &'static str,
    /// Source in the paper.
    pub source: &'static str,
    /// Hoop and start.
    pub setup: Setup,
}

impl NamedCase {
    /// The motion to its final outcome.
    ///
    /// # Errors
    /// As [`Hoop::simulate`].
    pub fn simulate(&self) -> Result<Trajectory, ParameterError> {
        Hoop::new(self.setup.hoop)?.simulate(self.setup.start, Limits::default())
    }
}

/// Short and full name of a case, by the name of the third video of the paper.
const SHORT: (&str, &str) = ("libration", "figure-2-libration");

/// The case of this name; `libration` is short for `figure-2-libration`.
pub fn find_case(name: &str) -> Option<&'static NamedCase> {
    let long = if name == SHORT.0 { SHORT.1 } else { name };
    CASES.iter().find(|case| case.name == long)
}

const THIN_HOOP: HoopParameters = HoopParameters::thin(1.0).with_friction(0.5, 0.4);

const LITTLEWOOD_HOOP: HoopParameters = HoopParameters::thin(0.0).with_friction(0.5, 0.4);

const fn thin_hoop_with(restitution: f64) -> HoopParameters {
    THIN_HOOP.with_restitution(restitution, RestitutionLaw::Energetic)
}

/// Impact angle of a stable [`crate::impact::BouncingOrbit`].
const BOUNCING_ANGLE: f64 = 2.2;

/// θ′ and gap rate of that motion over the top.
const BOUNCING_RATE: f64 = 1.239_306_550_206_238_1;
const BOUNCING_GAP_RATE: f64 = 1.274_198_847_857_927_4;

/// √(3/5), since θ′² = cos θ_s = 3/5 for μs = ½: from the top, N vanishes as slip begins.
const TYPE_II_RATE: f64 = 0.774_596_669_241_483_4;

/// Cases: name, title and source, then hoop and start.
macro_rules! cases {
    ($( $name:literal, $title:literal, $source:literal => $hoop:expr, $start:expr; )+) => {
        &[$( NamedCase { name: $name, title: $title, source: $source, setup: Setup::new($hoop, $start) } ),+]
    };
}

/// All cases. Starts that the paper does not give were found by search; `tests/cases.rs` verifies
/// each title.
pub const CASES: &[NamedCase] = cases! {
    "figure-3", "slides, rolls, slides, then jumps", "Figure 3, section 2(f)" =>
        THIN_HOOP, Start::at(FRAC_PI_2, 2.0);
    "figure-2-libration", "rolls back and forth about the stable equilibrium for ever", "footnote 4, third video" =>
        THIN_HOOP, Start::at(2.5, 0.0);
    "footnote-3", "loses contact at once", "footnote 3" =>
        THIN_HOOP, Start::at(0.0, 4.0);
    "slip-then-jump", "rolls, slips once, then jumps", "section 2(f)" =>
        THIN_HOOP, Start::at(2.5, 3.0);
    "slide-then-jump", "slides once, then jumps", "section 2(f)" =>
        THIN_HOOP, Start::at(4.6, 2.4);
    "rolls-forever", "rolls over the top for ever", "section 2(f)" =>
        THIN_HOOP, Start::at(0.0, 0.5);
    "stick-slip-no-jump", "rolls and slides in turn, never jumps, and rolls for ever", "section 2(f)" =>
        THIN_HOOP, Start::at(-2.6, -2.15);
    "sliding-band", "slides at once where rolling would need N < 0", "section 2(a), corrected" =>
        THIN_HOOP, Start::at(-1.2, 2.0);
    "figure-7", "massless: rolls, then glides until the particle reaches the plane", "Figure 7" =>
        LITTLEWOOD_HOOP, Start::at(0.0, 0.5);
    "type-1", "massless, Type I: the normal force vanishes before friction gives way", "Figure 5(b)" =>
        LITTLEWOOD_HOOP, Start::at(0.0, 0.9);
    "type-2", "massless, Type II: the normal force vanishes just as friction gives way", "Figure 5(b)" =>
        LITTLEWOOD_HOOP, Start::at(0.0, TYPE_II_RATE);
    "type-3", "massless, Type III: friction gives way under a normal force", "Figure 5(b)" =>
        LITTLEWOOD_HOOP, Start::at(0.3, 0.2);
    "glide-to-roll", "massless: glides, sticks inside R, rolls, and glides again", "section 3(e)" =>
        LITTLEWOOD_HOOP, Start::at(1.0, -0.8).with_slip(-0.5);
    "painleve", "no motion is consistent: sliding is not solvable there", "beyond the paper" =>
        HoopParameters::thin(1.0 / 3.0).with_friction(1.0, 1.0), Start::at(0.7, 0.5).with_slip(1.0);
    "figure-3-bounces", "Figure 3 goes on: bounces, settles, and rolls for ever", "beyond the paper" =>
        thin_hoop_with(0.5), Start::at(FRAC_PI_2, 2.0);
    "lands-and-rolls", "slides, jumps, lands without a rebound, and rolls for ever", "beyond the paper" =>
        thin_hoop_with(0.0), Start::at(4.2, 2.5);
    "two-hops", "jumps, lands without a rebound, rolls, and jumps again", "beyond the paper" =>
        thin_hoop_with(0.0), Start::at(2.0, 3.4);
    "jam", "slides where P < 0: jams in an impact without a collision, and rolls", "beyond the paper" =>
        HoopParameters::thin(0.125).with_friction(0.75, 0.75).with_restitution(0.0, RestitutionLaw::Energetic),
        Start::at(0.5, -0.5).with_slip(1.0);
    "bounces-forever", "bounces twice a turn for ever, and never slips", "beyond the paper" =>
        thin_hoop_with(1.0), Start::at(-BOUNCING_ANGLE, BOUNCING_RATE).with_gap_rate(BOUNCING_GAP_RATE);
    "uphill-disc", "released from rest on a slope: climbs, and rolls back and forth for ever", "beyond the paper" =>
        HoopParameters::thin(1.0).with_offset(0.8).with_inertia(0.5).with_friction(0.8, 0.6).with_slope(0.15),
        Start::at(-1.0, 0.0);
    "ramp-jump", "released from rest on a ramp of 15 degrees: rolls, slips twice, and jumps", "Gomez et al., Eur. J. Phys. 33, 1359 (2012)" =>
        HoopParameters::thin(2.0).with_offset(0.8).with_inertia(1.0).with_friction(1.0, 1.0).with_slope(FRAC_PI_6 / 2.0),
        Start::at(FRAC_PI_6, 0.0);
    "ramp-libration", "rolls back and forth about the equilibrium of a slope for ever", "beyond the paper" =>
        THIN_HOOP.with_slope(0.2), Start::at(2.0, 0.0);
    "ramp-bounces", "jumps at once, bounces up the slope, settles, and rolls back and forth for ever", "beyond the paper" =>
        thin_hoop_with(0.5).with_slope(0.15), Start::at(0.5, -3.0);
    "libration-rests", "rolling resistance: rolls back and forth, and rests after three half swings", "beyond the paper" =>
        THIN_HOOP.with_rolling_resistance(0.05), Start::at(2.5, 0.0);
    "rests-on-far-side", "rolling resistance: rolls over the top, turns back, and rests beyond the bottom", "beyond the paper" =>
        HoopParameters::thin(1.0).with_offset(0.4).with_inertia(0.5).with_friction(0.5, 0.4).with_rolling_resistance(0.15),
        Start::at(-0.5, 0.9);
    "disc-rests-on-ramp", "rolling resistance: a disc rolls up a ramp, and rests where it stops", "beyond the paper" =>
        HoopParameters::thin(1.0).with_offset(0.0).with_inertia(0.5).with_friction(0.5, 0.4).with_rolling_resistance(0.1).with_slope(0.05),
        Start::at(0.0, -1.0);
    "skid", "rolling resistance: slides without turning, sticks, rolls over the bottom and back, and rests", "beyond the paper" =>
        HoopParameters::thin(1.0).with_offset(0.6).with_inertia(0.5).with_friction(0.4, 0.3).with_rolling_resistance(0.1),
        Start::at(1.21625, 0.0).with_slip(0.5);
    "painleve-resisted", "rolling resistance: no motion is consistent, although nothing slips", "beyond the paper" =>
        HoopParameters::thin(5.256_407_325e-4).with_friction(0.080_988_7, 0.035_455_5).with_rolling_resistance(0.419_847_7),
        Start::at(0.119_757, 0.704_997);
};
