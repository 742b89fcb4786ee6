//! A scenario file as it is written: TOML with a case, `[hoop]`, `[start]`, `[run]`, or `[si.hoop]` and `[si.start]`.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use littlewood::Quantity;
use miette::NamedSource;
use serde::Deserialize;
use toml::Spanned;

use crate::args::Format;
use crate::error::Error;
use crate::values::{Given, Origin};

/// A scenario file that has been read.
#[derive(Debug)]
pub(crate) struct Scenario {
    text: String,
    path: PathBuf,
    file: File,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    case: Option<Spanned<String>>,
    #[serde(default)]
    hoop: HoopTable,
    #[serde(default)]
    start: StartTable,
    #[serde(default)]
    run: RunTable,
    si: Option<SiTable>,
}

type Number = Option<Spanned<f64>>;

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct HoopTable {
    mass_ratio: Number,
    offset: Number,
    inertia: Number,
    mu_s: Number,
    mu_k: Number,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct StartTable {
    theta: Number,
    theta_rate: Number,
    slip: Number,
    x: Number,
    time: Number,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct RunTable {
    until: Number,
    until_s: Number,
    max_transitions: Option<Spanned<u64>>,
    samples: Option<Spanned<u64>>,
    format: Option<Format>,
    out: Option<PathBuf>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct SiTable {
    #[serde(default)]
    hoop: SiHoopTable,
    #[serde(default)]
    start: SiStartTable,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct SiHoopTable {
    disc_mass_kg: Number,
    particle_mass_kg: Number,
    radius_m: Number,
    offset_m: Number,
    inertia_kg_m2: Number,
    gravity_m_per_s2: Number,
    mu_s: Number,
    mu_k: Number,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct SiStartTable {
    theta_rad: Number,
    theta_rate_rad_per_s: Number,
    slip_m_per_s: Number,
    x_m: Number,
    time_s: Number,
}

impl Scenario {
    /// Reads a file.
    ///
    /// # Errors
    /// The file cannot be read, is not TOML, or has a key that means nothing.
    pub(crate) fn read(path: &Path) -> Result<Self, Error> {
        let text =
            fs::read_to_string(path).map_err(|source| Error::Unreadable { path: path.to_owned(), source })?;
        let file = toml::from_str(&text).map_err(|error| Error::Scenario {
            message: error.message().to_owned(),
            help: "the keys are `case`; [hoop] mass_ratio, offset, inertia, mu_s, mu_k; [start] theta, theta_rate, \
                   slip, x, time; [run] until, max_transitions, samples, format, out; and [si.hoop], [si.start] \
                   with units in the names"
                .to_owned(),
            source_code: named(path, &text),
            span: error.span().unwrap_or_default().into(),
        })?;
        let scenario = Self { text, path: path.to_owned(), file };
        scenario.check_run()?;
        Ok(scenario)
    }

    /// The counts have the bounds of the flags.
    fn check_run(&self) -> Result<(), Error> {
        let run = &self.file.run;
        for (name, count, least, most) in
            [("samples", &run.samples, 2, 10_000_000), ("max_transitions", &run.max_transitions, 1, u64::MAX)]
        {
            if let Some(count) = count.as_ref().filter(|count| !(least..=most).contains(count.get_ref())) {
                return Err(self.complain(
                    format!("{name} = {} is not between {least} and {most}", count.get_ref()),
                    format!("give another number for {name}, or leave it out"),
                    count.span(),
                ));
            }
        }
        Ok(())
    }

    /// The name of the case that the file starts from, and its place.
    pub(crate) fn case(&self) -> Option<(&str, Range<usize>)> {
        self.file.case.as_ref().map(|case| (case.get_ref().as_str(), case.span()))
    }

    /// The numbers in the file. θ, μs and μk of `[si]` stand last and thus count.
    pub(crate) fn given(&self) -> Vec<Given> {
        let File { hoop, start, run, si, .. } = &self.file;
        let mut pairs = vec![
            (Quantity::MassRatio, &hoop.mass_ratio),
            (Quantity::Offset, &hoop.offset),
            (Quantity::Inertia, &hoop.inertia),
            (Quantity::MuS, &hoop.mu_s),
            (Quantity::MuK, &hoop.mu_k),
            (Quantity::Theta, &start.theta),
            (Quantity::ThetaRate, &start.theta_rate),
            (Quantity::Slip, &start.slip),
            (Quantity::X, &start.x),
            (Quantity::Time, &start.time),
            (Quantity::Until, &run.until),
            (Quantity::UntilS, &run.until_s),
        ];
        if let Some(SiTable { hoop, start }) = si {
            pairs.extend([
                (Quantity::DiscMassKg, &hoop.disc_mass_kg),
                (Quantity::ParticleMassKg, &hoop.particle_mass_kg),
                (Quantity::RadiusM, &hoop.radius_m),
                (Quantity::OffsetM, &hoop.offset_m),
                (Quantity::InertiaKgM2, &hoop.inertia_kg_m2),
                (Quantity::GravityMPerS2, &hoop.gravity_m_per_s2),
                (Quantity::MuS, &hoop.mu_s),
                (Quantity::MuK, &hoop.mu_k),
                (Quantity::Theta, &start.theta_rad),
                (Quantity::ThetaRateRadPerS, &start.theta_rate_rad_per_s),
                (Quantity::SlipMPerS, &start.slip_m_per_s),
                (Quantity::XM, &start.x_m),
                (Quantity::TimeS, &start.time_s),
            ]);
        }
        pairs
            .into_iter()
            .filter_map(|(quantity, number)| {
                let number = number.as_ref()?;
                let origin = Origin::File(number.span());
                Some(Given { quantity, value: *number.get_ref(), origin })
            })
            .collect()
    }

    /// Whether the file has an `[si]` table.
    pub(crate) const fn is_si(&self) -> bool {
        self.file.si.is_some()
    }

    /// Largest number of transitions.
    pub(crate) fn max_transitions(&self) -> Option<u64> {
        self.file.run.max_transitions.as_ref().map(|count| *count.get_ref())
    }

    /// Number of samples.
    pub(crate) fn samples(&self) -> Option<u64> {
        self.file.run.samples.as_ref().map(|count| *count.get_ref())
    }

    /// Output format.
    pub(crate) const fn format(&self) -> Option<Format> {
        self.file.run.format
    }

    /// Output file; a relative path is meant from the folder of the scenario.
    pub(crate) fn out(&self) -> Option<PathBuf> {
        let out = self.file.run.out.as_ref()?;
        Some(self.path.parent().map_or_else(|| out.clone(), |folder| folder.join(out)))
    }

    /// The file with its name, for messages.
    pub(crate) fn source_code(&self) -> Arc<NamedSource<String>> {
        named(&self.path, &self.text)
    }

    /// An error at a place in the file.
    pub(crate) fn complain(&self, message: String, help: String, span: Range<usize>) -> Error {
        Error::Scenario { message, help, source_code: self.source_code(), span: span.into() }
    }
}

fn named(path: &Path, text: &str) -> Arc<NamedSource<String>> {
    Arc::new(NamedSource::new(path.display().to_string(), text.to_owned()))
}
