//! The sequences of phases that occur.

use std::collections::BTreeSet;
use std::io::{self, Write};

use littlewood::Mode;
use littlewood::tables::{Class, PhaseCode, PhaseSequence, Quantity, Setup};
use littlewood_sweep::{Atlas, AtlasEntry, Stop};
use serde_json::{Map, Value, json};

use super::json;
use super::sweep::grouped;
use littlewood_report::number::brief;
use littlewood_report::sheet::Sheet;

/// An atlas, and of what it is.
#[derive(Debug)]
pub(crate) struct Page {
    /// All hoops together.
    pub(crate) atlas: Atlas,
    /// Starts that were asked for.
    pub(crate) total: u64,
    /// Quantities that differ between starts, shown for examples.
    pub(crate) shown: Vec<Quantity>,
    pub(crate) listed: Vec<Quantity>,
    /// The hoops one by one, if there is a list.
    pub(crate) hoops: Vec<OfHoop>,
}

#[derive(Debug)]
pub(crate) struct OfHoop {
    pub(crate) line: Option<u64>,
    /// The hoop, with a start; where there is an axis it has the first value of the axis.
    pub(crate) setup: Setup,
    pub(crate) atlas: Atlas,
}

impl Page {
    /// Number of hoops that have the sequence of an entry.
    fn hoops_with(&self, entry: &AtlasEntry) -> usize {
        let same =
            |other: &AtlasEntry| (other.sequence, other.stop) == (entry.sequence, entry.stop);
        self.hoops
            .iter()
            .filter(|hoop| hoop.atlas.entries.iter().any(same))
            .count()
    }
}

/// Numbers of sequences, with and without the direction of sliding.
fn counts(atlas: &Atlas) -> [(&'static str, usize); 2] {
    let sequences: BTreeSet<PhaseSequence> =
        atlas.entries.iter().map(|entry| entry.sequence).collect();
    // Directions of gliding are told apart all the same.
    let phase = |code: PhaseCode| match code.mode() {
        (Mode::Sliding, _) => (Mode::Sliding, None),
        (mode @ (Mode::Rolling | Mode::Gliding | Mode::Flight), direction) => (mode, direction),
    };
    let without: BTreeSet<Vec<_>> = sequences
        .iter()
        .map(|sequence| sequence.codes().map(|code| code.map(phase).ok()).collect())
        .collect();
    [
        ("sequences", sequences.len()),
        ("without_directions", without.len()),
    ]
}

pub(crate) fn table(page: &Page) -> Sheet {
    let atlas = &page.atlas;
    let mut sheet = Sheet::default();
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
    sheet.table(heads.into_iter().map(str::to_owned).collect(), rows, &right);
    sheet.gap();
    let [(_, sequences), (_, without)] = counts(atlas);
    let plural = if sequences == 1 {
        "sequence"
    } else {
        "sequences"
    };
    let mut total = format!("{sequences} {plural} on {} starts", grouped(atlas.points));
    if with_hoops {
        total.push_str(&format!(" of {} hoops", page.hoops.len()));
    }
    let mut lines = vec![
        total,
        format!("{without} if the direction of sliding does not count"),
    ];
    if with_stop {
        lines.push(format!("{} if the stop counts too", atlas.entries.len()));
    }
    sheet.fact("Total", lines);
    if atlas.invalid > 0 {
        let label = Class::Invalid.label();
        sheet.fact(
            "Invalid",
            vec![format!("{} starts with {label}", grouped(atlas.invalid))],
        );
    }
    sheet.note(&legend());
    sheet
}

/// The letters of sequences, by mode: `R rolling, - and + sliding`.
fn legend() -> String {
    let of_mode = |mode: Mode| {
        let mut letters: Vec<&str> = PhaseCode::ALL
            .into_iter()
            .filter(|code| code.mode().0 == mode)
            .map(PhaseCode::name)
            .collect();
        let last = letters.pop()?;
        let letters = if letters.is_empty() {
            last.to_owned()
        } else {
            format!("{} and {last}", letters.join(", "))
        };
        Some(format!("{letters} {mode}"))
    };
    Mode::ALL
        .into_iter()
        .filter_map(of_mode)
        .collect::<Vec<_>>()
        .join(", ")
}

fn example(shown: &[Quantity], entry: &AtlasEntry) -> String {
    let value = |quantity: &Quantity| {
        let value = entry.example.get(*quantity)?;
        Some(format!("{} = {}", quantity.sign(), brief(value)))
    };
    shown
        .iter()
        .filter_map(value)
        .collect::<Vec<_>>()
        .join("  ")
}

/// For programs; an example has the whole point.
pub(crate) fn json(writer: &mut dyn Write, page: &Page) -> io::Result<()> {
    let Page {
        atlas,
        total,
        listed,
        hoops,
        ..
    } = page;
    let mut document = json!({
        "points": atlas.points,
        "total": total,
        "invalid": atlas.invalid,
        "kinds": counts(atlas).into_iter().collect::<std::collections::BTreeMap<_, _>>(),
        "sequences": atlas.entries.iter().map(entry).collect::<Vec<_>>(),
    });
    if !hoops.is_empty() {
        let of_hoop = |hoop: &OfHoop| {
            json!({
                "line": hoop.line,
                "hoop": values(listed, &hoop.setup),
                "points": hoop.atlas.points,
                "invalid": hoop.atlas.invalid,
                "sequences": hoop.atlas.entries.iter().map(entry).collect::<Vec<_>>(),
            })
        };
        document["hoops"] = hoops.iter().map(of_hoop).collect();
    }
    json::write(writer, &document)
}

fn entry(entry: &AtlasEntry) -> Value {
    json!({
        "sequence": entry.sequence.to_string(),
        "stop": entry.stop.map(Stop::name),
        "count": entry.count,
        "example": values(&Quantity::AXES, &entry.example),
    })
}

fn values(quantities: &[Quantity], setup: &Setup) -> Map<String, Value> {
    let value =
        |quantity: &Quantity| Some((quantity.name().to_owned(), json!(setup.get(*quantity)?)));
    quantities.iter().filter_map(value).collect()
}
