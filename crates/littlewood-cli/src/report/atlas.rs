//! The sequences of phases that occur.

use std::collections::BTreeSet;
use std::io::{self, Write};

use littlewood::{HoopParameters, PhaseSequence};
use littlewood_sweep::{Atlas, Coordinate, Entry, Stop};
use serde_json::{Map, Value, json};

use super::json;
use super::sheet::Sheet;
use super::sweep::grouped;
use littlewood_report::number::brief;

/// An atlas, and of what it is.
#[derive(Debug)]
pub(crate) struct Page {
    /// All hoops together.
    pub(crate) atlas: Atlas,
    /// Starts that were asked for.
    pub(crate) total: u64,
    /// What differs between starts, and is told of examples.
    pub(crate) shown: Vec<Coordinate>,
    /// Columns of the list of hoops.
    pub(crate) listed: Vec<Coordinate>,
    /// The hoops one by one, if there is a list.
    pub(crate) hoops: Vec<OfHoop>,
}

/// The atlas of one hoop of a list.
#[derive(Debug)]
pub(crate) struct OfHoop {
    /// Its line in the list.
    pub(crate) line: Option<u64>,
    /// The hoop; where there is an axis it has the first value of the axis.
    pub(crate) hoop: HoopParameters,
    /// Its sequences.
    pub(crate) atlas: Atlas,
}

impl Page {
    /// Number of hoops that have the sequence of an entry.
    fn hoops_with(&self, entry: &Entry) -> usize {
        let same = |other: &Entry| (other.sequence, other.stop) == (entry.sequence, entry.stop);
        self.hoops.iter().filter(|hoop| hoop.atlas.entries.iter().any(same)).count()
    }
}

/// Numbers of sequences, by what is told apart.
fn counts(atlas: &Atlas) -> [(&'static str, usize); 2] {
    let sequences: BTreeSet<PhaseSequence> = atlas.entries.iter().map(|entry| entry.sequence).collect();
    let without: BTreeSet<String> =
        sequences.iter().map(|sequence| sequence.to_string().replace(['+', '-'], "S")).collect();
    [("sequences", sequences.len()), ("without_directions", without.len())]
}

/// For a person.
pub(crate) fn table(writer: &mut dyn Write, page: &Page, colour: bool) -> io::Result<()> {
    let atlas = &page.atlas;
    let mut sheet = Sheet::new(writer, colour);
    let with_stop = atlas.entries.iter().any(|entry| entry.stop.is_some());
    let with_hoops = !page.hoops.is_empty();
    let mut heads = vec!["Sequence"];
    heads.extend(with_stop.then_some("Stop"));
    heads.extend(with_hoops.then_some("Hoops"));
    heads.extend(["Starts", "Example"]);
    let rows = atlas
        .entries
        .iter()
        .map(|entry| {
            let mut row = vec![entry.sequence.to_string()];
            if with_stop {
                row.push(entry.stop.map_or("", Stop::name).replace('_', " "));
            }
            if with_hoops {
                row.push(page.hoops_with(entry).to_string());
            }
            row.extend([grouped(entry.count), example(&page.shown, entry)]);
            row
        })
        .collect();
    let right: Vec<usize> = (heads.len() - 2 - usize::from(with_hoops)..heads.len() - 1).collect();
    sheet.table(&heads, rows, &right, None)?;
    sheet.gap()?;
    let [(_, sequences), (_, without)] = counts(atlas);
    let plural = if sequences == 1 { "sequence" } else { "sequences" };
    let mut total = format!("{sequences} {plural} on {} starts", grouped(atlas.points));
    if with_hoops {
        total.push_str(&format!(" of {} hoops", page.hoops.len()));
    }
    let mut lines = vec![total, format!("{without} if the direction of sliding does not count")];
    if with_stop {
        lines.push(format!("{} if the stop counts too", atlas.entries.len()));
    }
    sheet.fact("Total", &lines)?;
    if atlas.invalid > 0 {
        sheet.fact("Not", &[format!("{} starts are of no hoop", grouped(atlas.invalid))])?;
    }
    sheet.note("R rolling, + and - sliding, g, n and G gliding, F flight")
}

fn example(shown: &[Coordinate], entry: &Entry) -> String {
    let value = |coordinate: &Coordinate| {
        format!("{} = {}", coordinate.symbol(), brief(coordinate.of_point(&entry.example)))
    };
    shown.iter().map(value).collect::<Vec<_>>().join("  ")
}

/// For programs; an example has the whole point.
pub(crate) fn json(writer: &mut dyn Write, page: &Page) -> io::Result<()> {
    let Page { atlas, total, listed, hoops, .. } = page;
    let mut document = json!({
        "points": atlas.points,
        "total": total,
        "invalid": atlas.invalid,
        "kinds": counts(atlas).into_iter().collect::<std::collections::BTreeMap<_, _>>(),
        "sequences": atlas.entries.iter().map(entry).collect::<Vec<_>>(),
    });
    if !hoops.is_empty() {
        let of_hoop = |hoop: &OfHoop| {
            let point = littlewood_sweep::Point { hoop: hoop.hoop, start: littlewood::Start::at(0.0, 0.0) };
            json!({
                "line": hoop.line,
                "hoop": values(listed, &point),
                "points": hoop.atlas.points,
                "invalid": hoop.atlas.invalid,
                "sequences": hoop.atlas.entries.iter().map(entry).collect::<Vec<_>>(),
            })
        };
        document["hoops"] = hoops.iter().map(of_hoop).collect();
    }
    json::write(writer, &document)
}

fn entry(entry: &Entry) -> Value {
    json!({
        "sequence": entry.sequence.to_string(),
        "stop": entry.stop.map(Stop::name),
        "count": entry.count,
        "example": values(&Coordinate::ALL, &entry.example),
    })
}

fn values(coordinates: &[Coordinate], point: &littlewood_sweep::Point) -> Map<String, Value> {
    let value = |coordinate: &Coordinate| (coordinate.name().to_owned(), json!(coordinate.of_point(point)));
    coordinates.iter().map(value).collect()
}
