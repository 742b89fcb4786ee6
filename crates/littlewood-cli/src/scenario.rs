//! A scenario file as it is written: TOML with a case, `[hoop]`, `[start]`, `[run]`, or `[si.hoop]`
//! and `[si.start]`.
//!
//! The keys of the tables are the quantities of the core; those of `[si]` have the unit in their
//! names.

use std::borrow::Cow;
use std::io::{self, ErrorKind};
use std::ops::{Range, RangeInclusive};
use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::ValueEnum;
use littlewood::tables::{Group, Quantity};
use littlewood::{Proof, RestitutionLaw};
use littlewood_report::RESTITUTION_LAW;
use littlewood_sweep::read_file;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use crate::args::{Format, MAX_SLIDES, MAX_TRANSITIONS, SAMPLES};
use crate::error::{Error, Excerpt};
use crate::nearest;
use crate::values::{Given, GivenLaw, Origin, si_name};

/// Most bytes of a scenario. One with every key has less than two thousand.
const MOST_BYTES: u64 = 1 << 20;

#[derive(Debug)]
pub(crate) struct Scenario {
    pub(crate) source: Source,
    /// The name of the case that the file starts from, and its place.
    pub(crate) case: Option<(String, Range<usize>)>,
    /// Of two numbers for the same quantity the later one counts.
    pub(crate) given: Vec<Given>,
    pub(crate) law: Option<GivenLaw>,
    /// Whether the file has an `[si]` table.
    pub(crate) is_si: bool,
    pub(crate) run: Run,
}

/// The numbers of a hoop and a start in one system of units, and the law of restitution.
#[derive(Default)]
struct GivenSetup {
    given: Vec<Given>,
    law: Option<GivenLaw>,
}

fn plain_name(quantity: Quantity) -> Cow<'static, str> {
    Cow::Borrowed(quantity.name())
}

/// What `[run]` says besides the time limit.
#[derive(Debug, Default)]
pub(crate) struct Run {
    pub(crate) max_transitions: Option<u64>,
    pub(crate) max_slides: Option<u64>,
    pub(crate) proof: Option<Proof>,
    pub(crate) samples: Option<u64>,
    pub(crate) format: Option<Format>,
    out: Option<PathBuf>,
}

impl Scenario {
    pub(crate) fn read(path: &Path) -> Result<Self, Error> {
        let source = Source::read(path)?;
        let document = DeTable::parse(&source.text).map_err(|error| {
            source.complain(
                error.message().to_owned(),
                overview(),
                error.span().unwrap_or_default(),
            )
        })?;
        let whole = Section {
            source: &source,
            name: "the file",
            table: document.get_ref(),
        };
        whole.refuse_other_keys(&["case", "hoop", "start", "run", "si"])?;

        let case = match whole.find("case") {
            Some((_, value)) => Some((whole.text("case", value)?.to_owned(), value.span())),
            None => None,
        };
        let GivenSetup { mut given, mut law } = whole.setup()?;
        let mut run = Run::default();
        if let Some(section) = whole.section("run", "[run]")? {
            let limits = Quantity::ALL
                .into_iter()
                .filter(|quantity| quantity.group() == Group::Run);
            given.extend(section.quantities(limits, plain_name, &Run::KEYS)?);
            run = Run::read(&section)?;
        }
        // θ, μs, μk and e with its law, which can stand in both, are taken from [si].
        let si = whole.section("si", "[si]")?;
        if let Some(si) = &si {
            let in_si = si.si_setup()?;
            given.extend(in_si.given);
            law = in_si.law.or(law);
        }
        let is_si = si.is_some();
        Ok(Self {
            source,
            case,
            given,
            law,
            is_si,
            run,
        })
    }

    /// Output file; a relative path is meant from the folder of the scenario.
    pub(crate) fn out(&self) -> Option<PathBuf> {
        let out = self.run.out.as_ref()?;
        Some(
            self.source
                .path
                .parent()
                .map_or_else(|| out.clone(), |folder| folder.join(out)),
        )
    }
}

impl Run {
    /// The keys of `[run]` that are no quantities.
    const KEYS: [&'static str; 6] = [
        "max_transitions",
        "max_slides",
        "proof",
        "samples",
        "format",
        "out",
    ];

    fn read(section: &Section<'_>) -> Result<Self, Error> {
        let [max_transitions, max_slides, proof, samples, format, out] = Self::KEYS;
        let text = |key| {
            section
                .find(key)
                .map(|(_, value)| section.text(key, value))
                .transpose()
        };
        let format = match (section.find(format), text(format)?) {
            (Some((_, value)), Some(name)) => Some(read_format(section, name, value.span())?),
            (_, _) => None,
        };
        Ok(Self {
            max_transitions: section.count(max_transitions, MAX_TRANSITIONS)?,
            max_slides: section.count(max_slides, MAX_SLIDES)?,
            proof: section
                .word(proof, "proof", &Proof::NAMES)?
                .map(|(proof, _)| proof),
            samples: section.count(samples, SAMPLES)?,
            format,
            out: text(out)?.map(PathBuf::from),
        })
    }
}

fn read_format(section: &Section<'_>, name: &str, span: Range<usize>) -> Result<Format, Error> {
    Format::from_str(name, false).map_err(|_| {
        let known: Vec<String> = Format::value_variants()
            .iter()
            .filter_map(|format| Some(format.to_possible_value()?.get_name().to_owned()))
            .collect();
        let message = format!("there is no format '{name}'");
        section.source.complain(
            message,
            format!("the formats are {}", known.join(", ")),
            span,
        )
    })
}

/// What a file can say, for one that is not TOML.
fn overview() -> String {
    let names = |quantities: &[Quantity]| {
        quantities
            .iter()
            .map(|quantity| quantity.name())
            .collect::<Vec<_>>()
            .join(", ")
    };
    format!(
        "the keys are `case`; [hoop] {}, {RESTITUTION_LAW}; [start] {}; [run] until, {}; and [si.hoop], [si.start] with \
         units in the names",
        names(&Quantity::HOOP),
        names(&Quantity::START),
        Run::KEYS.join(", "),
    )
}

#[derive(Debug)]
pub(crate) struct Source {
    path: PathBuf,
    text: String,
}

impl Source {
    fn read(path: &Path) -> Result<Self, Error> {
        let unreadable = |source| Error::Unreadable {
            path: path.to_owned(),
            source,
        };
        let bytes = read_file(path, MOST_BYTES).map_err(unreadable)?;
        let text = String::from_utf8(bytes).map_err(|error| {
            let at = error.utf8_error().valid_up_to();
            unreadable(io::Error::new(
                ErrorKind::InvalidData,
                format!("byte {at} is not UTF-8"),
            ))
        })?;
        Ok(Self {
            path: path.to_owned(),
            text,
        })
    }

    pub(crate) fn excerpt(&self, span: &Range<usize>) -> Excerpt {
        Excerpt::new(&self.path, &self.text, span)
    }

    pub(crate) fn complain(&self, message: String, help: String, span: Range<usize>) -> Error {
        Error::Scenario {
            message,
            help,
            excerpt: self.excerpt(&span),
        }
    }
}

/// A table of the file.
struct Section<'a> {
    source: &'a Source,
    /// As it is written: `[si.hoop]`.
    name: &'static str,
    table: &'a DeTable<'a>,
}

impl<'a> Section<'a> {
    fn find(&self, key: &str) -> Option<(Range<usize>, &'a Spanned<DeValue<'a>>)> {
        let (key, value) = self
            .table
            .iter()
            .find(|(known, _)| known.get_ref() == key)?;
        Some((key.span(), value))
    }

    /// `[hoop]` and `[start]` of the file.
    fn setup(&self) -> Result<GivenSetup, Error> {
        let mut setup = GivenSetup::default();
        if let Some(hoop) = self.section("hoop", "[hoop]")? {
            let keys = hoop.quantities(Quantity::HOOP, plain_name, &[RESTITUTION_LAW])?;
            setup.given.extend(keys);
            setup.law = hoop.law()?;
        }
        if let Some(start) = self.section("start", "[start]")? {
            let keys = start.quantities(Quantity::START, plain_name, &[])?;
            setup.given.extend(keys);
        }
        Ok(setup)
    }

    /// `[si.hoop]` and `[si.start]` of `[si]`.
    fn si_setup(&self) -> Result<GivenSetup, Error> {
        self.refuse_other_keys(&["hoop", "start"])?;
        let mut setup = GivenSetup::default();
        if let Some(hoop) = self.section("hoop", "[si.hoop]")? {
            let keys = hoop.quantities(Quantity::SI_HOOP, si_name, &[RESTITUTION_LAW])?;
            setup.given.extend(keys);
            setup.law = hoop.law()?;
        }
        if let Some(start) = self.section("start", "[si.start]")? {
            let keys = start.quantities(Quantity::SI_START, si_name, &[])?;
            setup.given.extend(keys);
        }
        Ok(setup)
    }

    /// A table in this one.
    fn section(&self, key: &str, name: &'static str) -> Result<Option<Self>, Error> {
        match self.find(key) {
            None => Ok(None),
            Some((_, value)) => match value.get_ref() {
                DeValue::Table(table) => Ok(Some(Self {
                    source: self.source,
                    name,
                    table,
                })),
                other => Err(self.of_other_type(key, "a table", other, value.span())),
            },
        }
    }

    /// The numbers of these quantities, in their order; the table may have other keys, too.
    fn quantities(
        &self,
        quantities: impl IntoIterator<Item = Quantity>,
        key: impl Fn(Quantity) -> Cow<'static, str>,
        others: &[&str],
    ) -> Result<Vec<Given>, Error> {
        let keys: Vec<_> = quantities
            .into_iter()
            .map(|quantity| (key(quantity), quantity))
            .collect();
        let known: Vec<&str> = keys
            .iter()
            .map(|(key, _)| key.as_ref())
            .chain(others.iter().copied())
            .collect();
        self.refuse_other_keys(&known)?;
        keys.iter()
            .filter_map(|(key, quantity)| self.find(key).map(|(_, value)| (key, *quantity, value)))
            .map(|(key, quantity, value)| {
                let origin = Origin::File(value.span());
                Ok(Given {
                    quantity,
                    value: self.number(key, value)?,
                    origin,
                })
            })
            .collect()
    }

    fn law(&self) -> Result<Option<GivenLaw>, Error> {
        let law = self.word(
            RESTITUTION_LAW,
            "law of restitution",
            &RestitutionLaw::NAMES,
        )?;
        Ok(law.map(|(law, span)| GivenLaw {
            law,
            origin: Origin::File(span),
        }))
    }

    /// A word of a table, with its place, if it is there.
    fn word<T: FromStr>(
        &self,
        key: &str,
        noun: &str,
        names: &[&'static str],
    ) -> Result<Option<(T, Range<usize>)>, Error> {
        let Some((_, value)) = self.find(key) else {
            return Ok(None);
        };
        let name = self.text(key, value)?;
        let span = value.span();
        let word = name.parse().map_err(|_| {
            let message = format!("there is no {noun} '{name}'");
            let all = format!("there are {}", names.join(", "));
            self.source.complain(
                message,
                nearest::hint(name, names.iter().copied(), &all),
                span.clone(),
            )
        })?;
        Ok(Some((word, span)))
    }

    fn number(&self, key: &str, value: &Spanned<DeValue<'_>>) -> Result<f64, Error> {
        let number = match value.get_ref() {
            DeValue::Float(float) => float.as_str().parse().ok(),
            integer @ DeValue::Integer(_) => whole(integer).map(|whole| whole as f64),
            DeValue::String(_)
            | DeValue::Boolean(_)
            | DeValue::Datetime(_)
            | DeValue::Array(_)
            | DeValue::Table(_) => None,
        };
        number.ok_or_else(|| self.of_other_type(key, "a number", value.get_ref(), value.span()))
    }

    fn text(&self, key: &str, value: &'a Spanned<DeValue<'a>>) -> Result<&'a str, Error> {
        let other = || self.of_other_type(key, "a string", value.get_ref(), value.span());
        value.get_ref().as_str().ok_or_else(other)
    }

    /// A count within bounds, which are those of the flag.
    fn count(&self, key: &str, bounds: RangeInclusive<u64>) -> Result<Option<u64>, Error> {
        let Some((_, value)) = self.find(key) else {
            return Ok(None);
        };
        let whole = whole(value.get_ref()).ok_or_else(|| {
            self.of_other_type(key, "a whole number", value.get_ref(), value.span())
        })?;
        match u64::try_from(whole) {
            Ok(count) if bounds.contains(&count) => Ok(Some(count)),
            Ok(_) | Err(_) => Err(self.source.complain(
                format!(
                    "{key} = {whole} is not between {} and {}",
                    bounds.start(),
                    bounds.end()
                ),
                format!("give another number for {key}, or leave it out"),
                value.span(),
            )),
        }
    }

    fn refuse_other_keys(&self, known: &[&str]) -> Result<(), Error> {
        match self
            .table
            .keys()
            .find(|key| !known.contains(&key.get_ref().as_ref()))
        {
            None => Ok(()),
            Some(key) => {
                let message = format!("there is no key '{}' in {}", key.get_ref(), self.name);
                let all = format!("the keys of {} are {}", self.name, known.join(", "));
                let help = nearest::hint(key.get_ref(), known.iter().copied(), &all);
                Err(self.source.complain(message, help, key.span()))
            }
        }
    }

    fn of_other_type(
        &self,
        key: &str,
        wanted: &str,
        found: &DeValue<'_>,
        span: Range<usize>,
    ) -> Error {
        let message = format!(
            "{key} is not {wanted}, but of the type {}",
            found.type_str()
        );
        self.source
            .complain(message, format!("{key} in {} is {wanted}", self.name), span)
    }
}

/// A whole number, in whichever base it is written.
fn whole(value: &DeValue<'_>) -> Option<i128> {
    let integer = value.as_integer()?;
    i128::from_str_radix(integer.as_str(), integer.radix()).ok()
}
