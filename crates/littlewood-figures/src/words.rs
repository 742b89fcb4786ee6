//! Hoops and starts in captions.

use core::f64::consts::PI;

use littlewood::{Cause, Hoop, Start};

/// The parameters of a hoop, with marks.
pub(crate) fn hoop_in_words(hoop: &Hoop) -> String {
    format!(
        "*m*_{{1}}/*m*_{{2}} = {}, *ℓ*/*R* = {}, *I*_{{zz}}/(*m*_{{2}}*R*^{{2}}) = {}",
        short(hoop.mass_ratio()),
        short(hoop.offset()),
        short(hoop.inertia())
    )
}

/// A number for print, with a true minus.
pub(crate) fn short(value: f64) -> String {
    let text = format!("{value:.4}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    littlewood_style::ticks::minus(if text == "-0" { "0" } else { text })
}

/// A start, with marks.
pub(crate) fn start_in_words(start: &Start) -> String {
    let angle = fraction_of_pi(start.theta).unwrap_or_else(|| short(start.theta));
    format!("*θ*(0) = {angle}, *θ*′(0) = {}, *η*′(0) = {}", short(start.theta_rate), short(start.slip))
}

/// A multiple of π/12, if it is one.
fn fraction_of_pi(value: f64) -> Option<String> {
    let twelfths = libm::round(12.0 * value / PI);
    let is_one = twelfths != 0.0 && (value - twelfths * PI / 12.0).abs() < 1e-12 && twelfths.abs() < 100.0;
    is_one.then(|| littlewood_style::ticks::of_pi(twelfths as i64, 12))
}

/// An event.
pub(crate) const fn cause_in_words(cause: Cause) -> &'static str {
    match cause {
        Cause::LiftOff => "lift-off",
        Cause::NormalForceZero => "N = 0",
        Cause::ParticleAtPlane => "particle at plane",
        Cause::ParticleAtBottom => "particle at bottom",
        Cause::ParticleAtTop => "particle at top",
        other => other.name(),
    }
}
