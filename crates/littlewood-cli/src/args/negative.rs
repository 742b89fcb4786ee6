//! Negative numbers after a flag.

use std::ffi::{OsStr, OsString};

/// Joins a flag and the negative number after it, `--slip -.5` to `--slip=-.5`.
///
/// The parser could be told to take whatever follows a flag, but then it takes the next flag too
/// when the number is missing; and what it holds to be a negative number does not include `-.5`.
pub(crate) fn join_negative_numbers(arguments: impl Iterator<Item = OsString>) -> Vec<OsString> {
    let mut joined: Vec<OsString> = Vec::new();
    for argument in arguments {
        let is_negative = argument
            .to_str()
            .is_some_and(|text| text.starts_with('-') && text.parse::<f64>().is_ok());
        match joined
            .last_mut()
            .filter(|last| is_negative && is_open_flag(last))
        {
            Some(flag) => {
                flag.push("=");
                flag.push(argument);
            }
            None => joined.push(argument),
        }
    }
    joined
}

/// Whether the argument is a flag without a value of its own.
fn is_open_flag(argument: &OsStr) -> bool {
    argument
        .to_str()
        .is_some_and(|text| text.len() > 2 && text.starts_with("--") && !text.contains('='))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_negative_numbers_are_joined_to_flags() {
        let joined = |text: &str| {
            join_negative_numbers(text.split(' ').map(OsString::from)).join(OsStr::new(" "))
        };
        assert_eq!(joined("--slip -.5 --x -1e-3"), "--slip=-.5 --x=-1e-3");
        assert_eq!(joined("--x -inf --theta -0"), "--x=-inf --theta=-0");
        assert_eq!(joined("--theta --slip 2"), "--theta --slip 2");
        assert_eq!(joined("--x=-1 -2 -- -3"), "--x=-1 -2 -- -3");
    }
}
