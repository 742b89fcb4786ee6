//! Quantities of a derivative, and standard errors of quantities.

use littlewood::tables::{Dimension, Quantity};

use crate::nearest;

/// A quantity of hoop or start, or all of them.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Names {
    All,
    One(Quantity),
}

/// The name of all quantities.
const ALL: &str = "all";

/// A name after `--derivatives`.
pub(super) fn parse_names(text: &str) -> Result<Names, String> {
    if text == ALL {
        Ok(Names::All)
    } else {
        parse_name(text, ALL).map(Names::One)
    }
}

/// A quantity with its standard error; that of an angle may be in degrees.
pub(super) fn parse_error(text: &str) -> Result<(Quantity, f64), String> {
    const FORM: &str = "hint: an error is NAME=ERROR, such as mu_k=0.02 or theta=0.5deg";
    let (name, error) = text.split_once('=').ok_or(FORM)?;
    let quantity = parse_name(name.trim(), "")?;
    let (number, unit) = match error.trim().strip_suffix("deg") {
        Some(number) if quantity.dimension() == Dimension::Angle => (number, 1_f64.to_radians()),
        Some(_) => {
            return Err(format!(
                "{quantity} is no angle, and has no error in degrees\n\n{FORM}"
            ));
        }
        None => (error.trim(), 1.0),
    };
    let error = number
        .trim()
        .parse::<f64>()
        .map_err(|_| format!("'{number}' is not a number\n\n{FORM}"))?
        * unit;
    if error.is_finite() && error >= 0.0 {
        Ok((quantity, error))
    } else {
        Err(format!(
            "the error of {quantity} = {error} must be a finite number and not negative\n\n{FORM}"
        ))
    }
}

pub(super) fn parse_name(name: &str, or: &'static str) -> Result<Quantity, String> {
    let known = || Quantity::HOOP.into_iter().chain(Quantity::START);
    let plain = name.replace('-', "_");
    known()
        .find(|quantity| quantity.name() == plain)
        .ok_or_else(|| {
            let names: Vec<&str> = known()
                .map(Quantity::name)
                .chain((!or.is_empty()).then_some(or))
                .collect();
            let all = format!("quantities are {}", names.join(", "));
            let hint = nearest::hint(name, names.iter().copied(), &all);
            format!("there is no quantity of a hoop or a start named '{name}'\n\nhint: {hint}")
        })
}
