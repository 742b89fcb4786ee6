//! What has become of many motions: the summary of a sweep, and an atlas.

use std::io::{self, Write};
use std::path::PathBuf;
use std::time::Duration;

use littlewood_report::number::brief;
use littlewood_sweep::{Atlas, Class, Coordinate, Entry, Grid, Report, Stop};
use serde_json::{Map, Value, json};

use super::json;
use super::sheet::Sheet;
use crate::args::ShortFormat;
use crate::error::Error;
use crate::output::Output;
use crate::store::{Counts, interrupted};

/// How a sweep went.
#[derive(Debug)]
pub(crate) struct Summary {
    points: u64,
    out: Vec<PathBuf>,
    threads: usize,
    computed: u64,
    reused: u64,
    damaged_chunks: usize,
    seconds: f64,
    /// Starts that are done in the output that has the fewest.
    done: u64,
    /// Points of each class; empty where they were not counted.
    pub(crate) counts: Counts,
}

impl Summary {
    /// Nothing is done yet.
    pub(crate) fn new(points: u64, out: &[PathBuf], threads: usize) -> Self {
        Self {
            points,
            out: out.to_vec(),
            threads,
            computed: 0,
            reused: 0,
            damaged_chunks: 0,
            seconds: 0.0,
            done: points,
            counts: Counts::new(),
        }
    }

    /// An output has been written.
    pub(crate) fn add(&mut self, report: &Report, time: Duration) {
        self.computed += report.computed;
        self.reused += report.reused;
        self.damaged_chunks += report.damaged_chunks;
        self.done = self.done.min(report.computed + report.reused);
        self.seconds += time.as_secs_f64();
    }

    /// Points have been computed for something that is no store.
    pub(crate) fn add_points(&mut self, computed: u64, time: Duration) {
        self.computed += computed;
        self.done = self.done.min(computed);
        self.seconds += time.as_secs_f64();
    }

    /// Starts per second; none if none was computed.
    fn rate(&self) -> Option<f64> {
        (self.computed > 0 && self.seconds > 0.0).then(|| self.computed as f64 / self.seconds)
    }

    fn table(&self, writer: &mut dyn Write, colour: bool) -> io::Result<()> {
        let mut sheet = Sheet::new(writer, colour);
        if !self.counts.is_empty() {
            let rows = self
                .counts
                .iter()
                .map(|(class, count)| {
                    let share = 100.0 * *count as f64 / self.points as f64;
                    vec![class.label().to_owned(), grouped(*count), format!("{share:.2} %")]
                })
                .collect();
            sheet.table(&["Outcome", "Starts", "Share"], rows, &[1, 2], None)?;
            sheet.gap()?;
        }
        let mut starts = format!("{} of {}", grouped(self.done), grouped(self.points));
        if self.reused > 0 {
            starts.push_str(&format!(", {} of them from before", grouped(self.reused)));
        }
        sheet.fact("Starts", &[starts])?;
        if let Some(rate) = self.rate() {
            let threads = if self.threads == 1 { "thread" } else { "threads" };
            sheet.fact(
                "Rate",
                &[format!("{} starts per second on {} {threads}", grouped(rate as u64), self.threads)],
            )?;
        }
        if self.damaged_chunks > 0 {
            let repaired = format!("{} damaged or missing chunks computed again", self.damaged_chunks);
            sheet.fact("Repair", &[repaired])?;
        }
        let out: Vec<String> = self.out.iter().map(|path| path.display().to_string()).collect();
        sheet.fact("Written", &out)
    }

    fn json(&self, writer: &mut dyn Write) -> io::Result<()> {
        let counts: Map<String, Value> =
            self.counts.iter().map(|(class, count)| (key(*class), json!(count))).collect();
        let document = json!({
            "points": self.points,
            "done": self.done,
            "complete": self.done == self.points,
            "computed": self.computed,
            "reused": self.reused,
            "damaged_chunks": self.damaged_chunks,
            "counts": if counts.is_empty() { Value::Null } else { Value::Object(counts) },
            "seconds": self.seconds,
            "starts_per_second": self.rate(),
            "threads": self.threads,
            "out": self.out.iter().map(|path| path.display().to_string()).collect::<Vec<_>>(),
        });
        json::write(writer, &document)
    }
}

/// Prints the summary, and complains if not all was done.
///
/// # Errors
/// A failure to write, or Ctrl-C.
pub(crate) fn finish(summary: &Summary, format: ShortFormat) -> Result<(), Error> {
    let output = Output::open(None)?;
    let colour = output.has_colour();
    output.write(|writer| match format {
        ShortFormat::Table => summary.table(writer, colour),
        ShortFormat::Json => summary.json(writer),
    })?;
    if summary.done < summary.points {
        return Err(interrupted(summary.done, summary.points, &summary.out));
    }
    Ok(())
}

/// A class as a key: `leaves_at_once`.
fn key(class: Class) -> String {
    class.label().to_lowercase().replace('é', "e").replace(' ', "_")
}

/// An atlas for a person.
pub(crate) fn atlas_table(
    writer: &mut dyn Write,
    grid: &Grid,
    atlas: &Atlas,
    colour: bool,
) -> io::Result<()> {
    let mut sheet = Sheet::new(writer, colour);
    let with_stop = atlas.entries.iter().any(|entry| entry.stop.is_some());
    let rows = atlas
        .entries
        .iter()
        .map(|entry| {
            let mut row = vec![entry.sequence.to_string()];
            if with_stop {
                row.push(entry.stop.map_or("", Stop::name).replace('_', " "));
            }
            row.extend([grouped(entry.count), example(grid, entry)]);
            row
        })
        .collect();
    if with_stop {
        sheet.table(&["Sequence", "Stop", "Starts", "Example"], rows, &[2], None)?;
    } else {
        sheet.table(&["Sequence", "Starts", "Example"], rows, &[1], None)?;
    }
    sheet.gap()?;
    let sequences = format!("{} kinds on {} starts", atlas.entries.len(), grouped(atlas.points));
    sheet.fact("Total", &[sequences])?;
    if atlas.invalid > 0 {
        sheet.fact("Not", &[format!("{} starts are of no hoop", grouped(atlas.invalid))])?;
    }
    sheet.note("R rolling, + and - sliding, g, n and G gliding, F flight")
}

fn example(grid: &Grid, entry: &Entry) -> String {
    grid.axes()
        .iter()
        .map(|axis| {
            let coordinate = axis.coordinate();
            format!("{} = {}", coordinate.symbol(), brief(coordinate.of_point(&entry.example)))
        })
        .collect::<Vec<_>>()
        .join("  ")
}

/// An atlas for programs; an example has the whole point.
pub(crate) fn atlas_json(writer: &mut dyn Write, grid: &Grid, atlas: &Atlas) -> io::Result<()> {
    let sequences: Vec<Value> = atlas
        .entries
        .iter()
        .map(|entry| {
            let example: Map<String, Value> = Coordinate::ALL
                .into_iter()
                .map(|coordinate| (coordinate.name().to_owned(), json!(coordinate.of_point(&entry.example))))
                .collect();
            json!({
                "sequence": entry.sequence.to_string(),
                "stop": entry.stop.map(Stop::name),
                "count": entry.count,
                "example": example,
            })
        })
        .collect();
    let document = json!({
        "points": atlas.points,
        "total": grid.len(),
        "invalid": atlas.invalid,
        "sequences": sequences,
    });
    json::write(writer, &document)
}

/// A whole number with its digits in groups of three.
fn grouped(number: u64) -> String {
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
