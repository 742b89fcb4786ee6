//! A curve θ′(θ) that exists on some arcs only, as points close enough to draw.

/// Halvings of an interval that one end of an arc lies in: to a thousandth of a pixel. Nearer to the end of an arc of the
/// massless hoop, where N and its slope both vanish, rounding would be drawn.
const HALVINGS: usize = 12;

/// Rates beyond this one are off every plane that is drawn.
const FARTHEST: f64 = 1e4;

/// Points (θ, θ′) one after the other, each arc from end to end, with (NaN, NaN) between arcs.
pub(crate) fn trace(from: f64, to: f64, count: usize, rate: impl Fn(f64) -> Option<f64>) -> Vec<f64> {
    let intervals = count.max(2) - 1;
    let theta = |i: usize| from + (to - from) * (i as f64 / intervals as f64);
    let rate = |theta: f64| rate(theta).filter(|rate| *rate < FARTHEST);
    let mut points = Vec::with_capacity(2 * count);
    let mut before: Option<(f64, Option<f64>)> = None;
    for i in 0..=intervals {
        let here = (theta(i), rate(theta(i)));
        match (before, here.1) {
            (Some((there, Some(_))), None) => {
                let end = end_of_arc(there, here.0, &rate);
                points.extend(end);
                points.extend([f64::NAN, f64::NAN]);
            }
            (Some((there, None)), Some(_)) => points.extend(end_of_arc(here.0, there, &rate)),
            _ => {}
        }
        if let Some(rate) = here.1 {
            points.extend([here.0, rate]);
        }
        before = Some(here);
    }
    points
}

/// The last point of the curve between one where it exists and one where it does not.
fn end_of_arc(mut inside: f64, mut outside: f64, rate: &impl Fn(f64) -> Option<f64>) -> [f64; 2] {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (inside + outside);
        if rate(middle).is_some() {
            inside = middle;
        } else {
            outside = middle;
        }
    }
    [inside, rate(inside).unwrap_or(f64::NAN)]
}

#[cfg(test)]
mod tests {
    use super::trace;

    #[test]
    fn an_arc_reaches_its_ends() {
        // The upper half of the unit circle, which meets the axis at a right angle.
        let points = trace(-2.0, 2.0, 41, |x| (x * x <= 1.0).then(|| (1.0 - x * x).sqrt()));
        assert!((points[0] + 1.0).abs() < 3e-5 && points[1] < 8e-3);
        let end = points.len() - 4;
        assert!((points[end] - 1.0).abs() < 3e-5 && points[end + 1] < 8e-3);
        assert!(points[end + 2].is_nan());
    }
}
