//! Links of the laboratory: a motion, an instant and how the page shows them, as the text after `#`
//! in an address.
//!
//! `case=figure-3&mu_k=0.3&at=1.2&map=0`: a case and what differs from it, or numbers without
//! dimension or in SI units; the instant; what of the page is not as it is at first. A link that is
//! written has every bit of what it says.

use core::fmt;

use littlewood::cases::{CASES, NamedCase, find_case};
use littlewood::si::{SiSetup, Units};
use littlewood::tables::{Presence, Quantity, Setup};
use littlewood::{HoopParameters, ParameterError, RestitutionLaw, Start};

use crate::record::RESTITUTION_LAW;

const CASE: &str = "case";
const AT: &str = "at";
const THEME: &str = "theme";
/// The link of a motion that the page compares this one with: it reads that by itself.
const PIN: &str = "pin";

const FLAG: &[&str] = &["0", "1"];

/// How the page shows a motion: the keys, what each may say, and what the page does at first.
pub const VIEW: [(&str, &[&str], &str); 11] = [
    (
        "rate",
        &["1", "1.5", "2", "3", "4", "6", "8", "12", "20"],
        "4",
    ),
    ("speed", &["0.1", "0.25", "0.5", "1", "2", "4"], "0.5"),
    ("slow", FLAG, "0"),
    ("loop", FLAG, "0"),
    ("map", FLAG, "1"),
    ("shows", &["outcome", "hops"], "outcome"),
    ("follow", FLAG, "1"),
    ("symbols", FLAG, "1"),
    ("level", &["auto", "simple", "full"], "auto"),
    ("embed", FLAG, "0"),
    (THEME, &["auto", "light", "dark"], "auto"),
];

/// A hoop, a start and a time limit, as they were given in one of the systems of units.
#[derive(Clone, Debug, PartialEq)]
pub struct Problem {
    /// Whether the values are in SI units.
    pub is_si: bool,
    /// The values of [`Problem::quantities`]. None for one that is left out or missing.
    pub values: Vec<(Quantity, Option<f64>)>,
    /// The law of restitution, if one is given.
    pub law: Option<RestitutionLaw>,
}

impl Problem {
    /// The quantities of a hoop, a start and a limit in a system of units.
    pub fn quantities(is_si: bool) -> impl Iterator<Item = Quantity> {
        let (hoop, start, limit): (&'static [_], &'static [_], _) = if is_si {
            (&Quantity::SI_HOOP, &Quantity::SI_START, Quantity::UntilS)
        } else {
            (&Quantity::HOOP, &Quantity::START, Quantity::Until)
        };
        hoop.iter().chain(start).copied().chain([limit])
    }

    /// A problem without dimension.
    #[must_use]
    pub fn of_setup(setup: &Setup, until: Option<f64>) -> Self {
        let value = |quantity| {
            if quantity == Quantity::Until {
                until
            } else {
                setup.get(quantity)
            }
        };
        let values = Self::quantities(false)
            .map(|quantity| (quantity, value(quantity)))
            .collect();
        Self {
            is_si: false,
            values,
            law: setup.hoop.restitution_law,
        }
    }

    /// The value of a quantity.
    pub fn get(&self, wanted: Quantity) -> Option<f64> {
        self.values
            .iter()
            .find(|(quantity, _)| *quantity == wanted)?
            .1
    }

    /// The law by which the hoop bounces, if it does.
    fn effective_law(&self) -> Option<RestitutionLaw> {
        self.get(Quantity::Restitution)
            .map(|_| self.law.unwrap_or_default())
    }

    /// The case that it is to the last bit, if it is one.
    pub fn case(&self) -> Option<&'static NamedCase> {
        let same = |other: &Self| {
            let bits = |problem: &Self| {
                problem
                    .values
                    .iter()
                    .map(|(_, value)| value.map(f64::to_bits))
                    .collect::<Vec<_>>()
            };
            bits(self) == bits(other) && self.effective_law() == other.effective_law()
        };
        CASES
            .iter()
            .filter(|_| !self.is_si)
            .find(|case| same(&Self::of_setup(&case.setup, None)))
    }

    /// The problem without dimension, its units if it is in SI units, and its limit.
    ///
    /// # Errors
    /// Values in SI units without physical meaning; those without dimension are checked where they
    /// are used.
    pub fn to_setup(&self) -> Result<(Setup, Option<Units>, Option<f64>), ParameterError> {
        if self.is_si {
            let (setup, units) =
                SiSetup::from_values(|quantity| self.get(quantity), self.law).to_setup()?;
            let until = self
                .get(Quantity::UntilS)
                .map(|until_s| units.until(until_s, &setup.start));
            return Ok((setup, Some(units), until.transpose()?));
        }
        let mut setup = Setup::new(HoopParameters::default(), Start::default());
        setup.hoop.restitution_law = self.law;
        for (quantity, value) in &self.values {
            let missing = if quantity.row().presence == Presence::Optional {
                None
            } else {
                Some(f64::NAN)
            };
            if let Some(value) = value.or(missing) {
                setup.set(*quantity, value);
            }
        }
        Ok((setup, None, self.get(Quantity::Until)))
    }
}

/// What a link says.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// The problem.
    pub problem: Problem,
    /// The instant that is shown, over √(R/g); none at the start.
    pub at: Option<f64>,
    /// What each key of [`VIEW`] says.
    pub view: [&'static str; VIEW.len()],
}

/// A part of a link that has no meaning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// The key.
    pub key: String,
    /// What the link says there.
    pub text: String,
    /// What is wrong with it.
    pub reason: String,
}

/// A link that has been read.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// What it says. What could not be read is as if it were not there.
    pub link: Link,
    /// Whether it says anything of a hoop, a start or a limit.
    pub has_problem: bool,
    /// What could not be read.
    pub refusals: Vec<Refusal>,
}

impl Link {
    /// A problem as the page shows it at first.
    #[must_use]
    pub fn of(problem: Problem) -> Self {
        Self {
            problem,
            at: None,
            view: VIEW.map(|(_, _, first)| first),
        }
    }

    /// Reads a link. Of the problem what it does not say is that of the case that it names; without
    /// one, that of the link `shown`, which may be empty.
    pub fn read(text: &str, shown: &str) -> Reading {
        let first = CASES
            .first()
            .map(|case| Self::of(Problem::of_setup(&case.setup, None)));
        let shown = if shown.is_empty() {
            first
        } else {
            Some(Self::read(shown, "").link)
        };
        let shown = shown.unwrap_or_else(|| {
            Self::of(Problem {
                is_si: false,
                values: vec![],
                law: None,
            })
        });
        let mut given = Given {
            pairs: pairs(text),
            refusals: Vec::new(),
        };
        let mut problem = given.problem(&shown.problem);
        let has_problem = problem.is_some();
        let at = given.number(AT);
        let view = VIEW.map(|(key, choices, first)| {
            let first = if key == THEME {
                shown.view.last().copied().unwrap_or(first)
            } else {
                first
            };
            given.choice(key, choices).unwrap_or(first)
        });
        let _ = given.take(PIN);
        for (key, text) in core::mem::take(&mut given.pairs) {
            let known = Quantity::ALL.iter().any(|quantity| quantity.name() == key);
            let reason = if known {
                "it is not in SI units, as the rest of the link is"
            } else {
                "this key is not known"
            };
            given.refuse(&key, &text, reason.to_owned());
        }
        let problem = problem.take().unwrap_or(shown.problem);
        Reading {
            link: Self { problem, at, view },
            has_problem,
            refusals: given.refusals,
        }
    }
}

impl fmt::Display for Link {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { problem, at, view } = self;
        let mut parts = Vec::new();
        if let Some(case) = problem.case() {
            parts.push(format!("{CASE}={}", case.name));
        } else {
            let said = |(quantity, value): &&(Quantity, Option<f64>)| {
                value.is_none_or(|value| !quantity.goes_without_saying(value))
            };
            for (quantity, value) in problem.values.iter().filter(said) {
                parts.extend(value.map(|value| format!("{}={}", quantity.name(), written(value))));
                let law = problem
                    .effective_law()
                    .filter(|_| *quantity == Quantity::Restitution);
                parts.extend(law.map(|law| format!("{RESTITUTION_LAW}={}", law.name())));
            }
        }
        parts.extend(at.map(|at| format!("{AT}={}", written(at))));
        let changed = VIEW
            .iter()
            .zip(view)
            .filter(|((_, _, first), says)| first != *says);
        parts.extend(changed.map(|((key, ..), says)| format!("{key}={says}")));
        f.write_str(&parts.join("&"))
    }
}

/// What is yet to be read of a link.
struct Given {
    pairs: Vec<(String, String)>,
    refusals: Vec<Refusal>,
}

impl Given {
    fn take(&mut self, key: &str) -> Option<String> {
        let index = self.pairs.iter().position(|(name, _)| name == key)?;
        Some(self.pairs.remove(index).1)
    }

    fn refuse(&mut self, key: &str, text: &str, reason: String) {
        self.refusals.push(Refusal {
            key: key.to_owned(),
            text: text.to_owned(),
            reason,
        });
    }

    fn number(&mut self, key: &str) -> Option<f64> {
        let text = self.take(key)?;
        let number = read_number(&text);
        if number.is_none() {
            self.refuse(key, &text, format!("'{text}' is not a number"));
        }
        number
    }

    fn choice(&mut self, key: &str, choices: &[&'static str]) -> Option<&'static str> {
        let text = self.take(key)?;
        let number = read_number(&text);
        let same =
            |choice: &&str| **choice == text || (number.is_some() && read_number(choice) == number);
        let found = choices.iter().copied().find(same);
        if found.is_none() {
            self.refuse(key, &text, format!("one of {}", choices.join(", ")));
        }
        found
    }

    /// The problem of a named case; none, and a complaint, if there is no such case.
    fn problem_of_case(&mut self, name: &str) -> Option<Problem> {
        let case = find_case(name);
        if case.is_none() {
            self.refuse(CASE, name, format!("there is no case named '{name}'"));
        }
        case.map(|case| Problem::of_setup(&case.setup, None))
    }

    /// A law of restitution; none, and a complaint, if there is no such law.
    fn law(&mut self, text: &str) -> Option<RestitutionLaw> {
        let law = text.parse().ok();
        if law.is_none() {
            let known = RestitutionLaw::NAMES.join(", ");
            self.refuse(RESTITUTION_LAW, text, format!("one of {known}"));
        }
        law
    }

    /// The problem; none if nothing is said of it.
    fn problem(&mut self, shown: &Problem) -> Option<Problem> {
        let case = self.take(CASE);
        let of_case = case.as_deref().and_then(|name| self.problem_of_case(name));
        let says = |quantity: &Quantity| self.pairs.iter().any(|(key, _)| key == quantity.name());
        let given: Vec<Quantity> = Quantity::ALL.into_iter().filter(says).collect();
        let law = self.take(RESTITUTION_LAW);
        if given.is_empty() && law.is_none() {
            return of_case.or_else(|| case.is_some().then(|| shown.clone()));
        }
        let base = of_case.as_ref().unwrap_or(shown);
        // What may be left out is left out, unless a case has it.
        let kept = |quantity| {
            if case.is_some() {
                base.get(quantity)
            } else {
                None
            }
        };
        let law_of_case = base.law.filter(|_| case.is_some());
        let is_si = given.iter().any(|quantity| quantity.is_si());
        let values = Problem::quantities(is_si).map(|quantity| {
            let is_missing = !given.contains(&quantity);
            let number = self.number(quantity.name());
            let otherwise = match quantity.row().presence {
                Presence::Optional => kept(quantity),
                Presence::Default(value) if quantity.goes_without_saying(value) => {
                    kept(quantity).or(Some(value))
                }
                Presence::Required | Presence::Default(_) if base.is_si == is_si => {
                    base.get(quantity)
                }
                Presence::Default(value) => Some(value),
                Presence::Required => {
                    if is_missing {
                        self.refuse(quantity.name(), "", "the link does not give it".to_owned());
                    }
                    None
                }
            };
            (quantity, number.or(otherwise))
        });
        let values = values.collect();
        let law = law.and_then(|text| self.law(&text));
        Some(Problem {
            is_si,
            values,
            law: law.or(law_of_case),
        })
    }
}

/// The keys of a link and what it says of each; of several the last.
fn pairs(text: &str) -> Vec<(String, String)> {
    let mut pairs: Vec<(String, String)> = Vec::new();
    for part in text
        .strip_prefix('#')
        .unwrap_or(text)
        .split('&')
        .filter(|part| !part.is_empty())
    {
        let (key, value) = part.split_once('=').unwrap_or((part, ""));
        let (key, value) = (decoded(key), decoded(value));
        pairs.retain(|(other, _)| *other != key);
        pairs.push((key, value));
    }
    pairs
}

/// Decodes the percent escapes of a part of a link; returns it unchanged if they are malformed.
fn decoded(text: &str) -> String {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        if byte != b'%' {
            bytes.push(byte);
            continue;
        }
        let mut digit = || rest.next().and_then(|byte| char::from(byte).to_digit(16));
        let (Some(high), Some(low)) = (digit(), digit()) else {
            return text.to_owned();
        };
        bytes.extend(u8::try_from(16 * high + low));
    }
    String::from_utf8(bytes).unwrap_or_else(|_| text.to_owned())
}

/// A finite number as people and programs write it; `None` for anything else.
pub fn read_number(text: &str) -> Option<f64> {
    let plain = text.trim().replacen('−', "-", 1);
    let is_plain = plain
        .bytes()
        .all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    plain
        .parse()
        .ok()
        .filter(|number: &f64| is_plain && number.is_finite())
}

/// A number in few letters, such that the same is read again.
fn written(number: f64) -> String {
    let plain = number.to_string();
    if plain.len() <= 24 {
        plain
    } else {
        format!("{number:e}")
    }
}
