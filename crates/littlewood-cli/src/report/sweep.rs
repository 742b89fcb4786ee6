//! What has become of many motions: the summary of a sweep.

use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Duration;

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
        let rows = self
            .report
            .tally
            .iter()
            .map(|(class, count)| {
                let share = 100.0 * count as f64 / self.report.points as f64;
                vec![
                    class.label().to_owned(),
                    grouped(count),
                    format!("{share:.2} %"),
                ]
            })
            .collect();
        sheet.table(
            ["Class", "Starts", "Share"].map(str::to_owned).to_vec(),
            rows,
            &[1, 2],
        );
        sheet.gap();
        let mut starts = format!(
            "{} of {}",
            grouped(self.done()),
            grouped(self.report.points)
        );
        if self.report.reused > 0 {
            starts.push_str(&format!(
                ", {} of them from before",
                grouped(self.report.reused)
            ));
        }
        sheet.fact("Starts", vec![starts]);
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
        sheet.fact(
            "Written",
            self.kept
                .iter()
                .map(|path| path.display().to_string())
                .collect(),
        );
        sheet
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
            "out": self.kept.iter().map(|path| path.display().to_string()).collect::<Vec<_>>(),
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
