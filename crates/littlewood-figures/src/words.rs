//! Hoops and starts in captions.

use littlewood::Hoop;

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
    crate::ticks::minus(if text == "-0" { "0" } else { text })
}
