//! Numbers as a reader sees them.

/// Up to six significant digits, without trailing zeros.
pub fn brief(value: f64) -> String {
    if !value.is_finite() {
        return infinite(value);
    }
    let scientific = format!("{value:.5e}");
    let rounded: f64 = scientific.parse().unwrap_or(value);
    match rounded.abs() {
        0.0 => "0".to_owned(),
        size if (1e-4..1e7).contains(&size) => rounded.to_string(),
        _ => format!("{rounded:e}"),
    }
    .replace('-', "−")
}

/// Five decimals, so that the numbers of a column stand under each other; an exact zero is "0".
pub fn column(value: f64) -> String {
    if !value.is_finite() {
        return infinite(value);
    }
    match value.abs() {
        0.0 => "0".to_owned(),
        size if (1e-4..1e6).contains(&size) => format!("{value:.5}"),
        _ => format!("{value:.2e}"),
    }
    .replace('-', "−")
}

/// Three digits are enough for a sentence; all of them are in the tables.
pub fn three(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}

fn infinite(value: f64) -> String {
    if value.is_nan() {
        "undefined".to_owned()
    } else if value > 0.0 {
        "∞".to_owned()
    } else {
        "−∞".to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::{brief, column};

    #[test]
    fn numbers_are_short_and_keep_their_sign() {
        assert_eq!(brief(2.0), "2");
        assert_eq!(brief(core::f64::consts::FRAC_PI_2), "1.5708");
        assert_eq!(brief(0.1 + 0.2), "0.3");
        assert_eq!(brief(-1.5e-9), "−1.5e−9");
        assert_eq!(brief(-0.0), "0");
        assert_eq!(column(-1.0), "−1.00000");
        assert_eq!(column(3e-17), "3.00e−17");
        assert_eq!(column(f64::NEG_INFINITY), "−∞");
    }
}
