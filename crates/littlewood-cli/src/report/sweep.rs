//! What has become of many motions: the summary of a sweep.

use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Duration;

use littlewood::tables::Class;
use littlewood_report::sheet::Sheet;
use littlewood_sweep::Report;
use serde_json::{Map, Value, json};

use super::json;
use crate::args::ShortFormat;
use crate::error::Error;
use crate::output::print;
use crate::store::interrupted;

#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) report: Report,
    /// What the starts took.
    pub(crate) time: Duration,
    pub(crate) threads: usize,
    /// What can be read now.
    pub(crate) kept: Vec<PathBuf>,
}

impl Run {
    const fn done(&self) -> u64 {
        self.report.computed + self.report.reused
    }

    /// Starts per second; none if none was computed.
    fn rate(&self) -> Option<f64> {
        let seconds = self.time.as_secs_f64();
        (self.report.computed > 0 && seconds > 0.0).then(|| self.report.computed as f64 / seconds)
    }

    fn table(&self) -> Sheet {
        let mut sheet = Sheet::default();
        self.show_classes(&mut sheet);
        sheet.gap();
        sheet.fact("Starts", vec![self.starts()]);
        if let Some(rate) = self.rate() {
            let threads = if self.threads == 1 {
                "thread"
            } else {
                "threads"
            };
            let rate = format!(
                "{} starts per second on {} {threads}",
                grouped(rate as u64),
                self.threads
            );
            sheet.fact("Rate", vec![rate]);
        }
        if self.report.damaged_chunks > 0 {
            let repaired = format!(
                "{} damaged or missing chunks computed again",
                self.report.damaged_chunks
            );
            sheet.fact("Repair", vec![repaired]);
        }
        sheet.fact("Written", self.paths());
        sheet
    }

    /// The number of starts of each class, and their share of all.
    fn show_classes(&self, sheet: &mut Sheet) {
        let Report { tally, points, .. } = &self.report;
        let row = |(class, count): (Class, u64)| {
            let share = 100.0 * count as f64 / *points as f64;
            vec![
                class.label().to_owned(),
                grouped(count),
                format!("{share:.2} %"),
            ]
        };
        let heads = ["Class", "Starts", "Share"].map(str::to_owned);
        sheet.table(heads.to_vec(), tally.iter().map(row).collect(), &[1, 2]);
    }

    /// How many starts are done.
    fn starts(&self) -> String {
        let Report { points, reused, .. } = self.report;
        let done = format!("{} of {}", grouped(self.done()), grouped(points));
        if reused > 0 {
            format!("{done}, {} of them from before", grouped(reused))
        } else {
            done
        }
    }

    fn paths(&self) -> Vec<String> {
        self.kept
            .iter()
            .map(|path| path.display().to_string())
            .collect()
    }

    fn json(&self, writer: &mut dyn Write) -> io::Result<()> {
        let counts: Map<String, Value> = self
            .report
            .tally
            .iter()
            .map(|(class, count)| (class.name().to_owned(), json!(count)))
            .collect();
        let document = json!({
            "points": self.report.points,
            "done": self.done(),
            "complete": self.report.complete,
            "computed": self.report.computed,
            "reused": self.report.reused,
            "damaged_chunks": self.report.damaged_chunks,
            "counts": counts,
            "seconds": self.time.as_secs_f64(),
            "starts_per_second": self.rate(),
            "threads": self.threads,
            "out": self.paths(),
        });
        json::write(writer, &document)
    }

    /// Prints the summary, and complains if not all was done.
    pub(crate) fn finish(self, format: ShortFormat) -> Result<(), Error> {
        print(format, None, || self.table(), |writer| self.json(writer))?;
        if self.report.complete {
            return Ok(());
        }
        Err(interrupted(self.done(), self.report.points, &self.kept))
    }
}

/// A whole number with its digits in groups of three.
pub(super) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}
