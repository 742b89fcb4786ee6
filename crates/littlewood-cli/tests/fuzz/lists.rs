//! Lists of starts: as they should be, and damaged.

use std::fs;
use std::path::Path;

use littlewood::tables::{Quantity, Setup};
use littlewood::{HoopParameters, Start};
use littlewood_sweep::StartList;

use crate::fuzz::damage::damage_text;
use crate::fuzz::program::{judge, run as run_program};
use crate::fuzz::{Case, Verdict};
use littlewood_random::Draw;

/// Where nothing else is said.
const BASE: Setup = Setup::new(
    HoopParameters::thin(1.0).with_friction(0.5, 0.4),
    Start::at(1.0, 1.0),
);

/// Which part of the lists goes through the program, which takes a thousand times as long.
const THROUGH_THE_PROGRAM: f64 = 0.1;

pub(crate) fn run(case: &mut Case) -> Verdict {
    let draw = &mut case.draw;
    let path = case.folder.join("starts.csv");
    let table = Table::random(draw);
    let mut text = table.csv(draw);
    while draw.comes(0.4) {
        text = damage_text(draw, &text);
    }
    fs::write(&path, text).expect("written");
    case.told.tell(format!(
        "littlewood sweep figure-3 --starts {} --out list.parquet",
        path.display()
    ));
    if draw.comes(THROUGH_THE_PROGRAM) {
        let words = [
            "sweep",
            "figure-3",
            "--until=9",
            "--starts",
            "starts.csv",
            "--out",
            "list.parquet",
        ];
        return judge(&run_program(&words.map(str::to_owned), &case.folder));
    }
    match read(&path) {
        Ok(rows) if rows == table.rows as u64 => Ok("read"),
        Ok(_) => Ok("read otherwise"),
        Err(message) if message.is_empty() => Err("a refusal that says nothing".to_owned()),
        Err(_) => Ok("refused"),
    }
}

/// Reads a list to its end: the number of rows, each of which can be followed.
fn read(path: &Path) -> Result<u64, String> {
    let list = StartList::open(path, BASE).map_err(|error| error.to_string())?;
    let mut rows = 0;
    for row in list.points().map_err(|error| error.to_string())? {
        row.map_err(|error| error.to_string())?;
        rows += 1;
    }
    if rows == list.rows() {
        Ok(rows)
    } else {
        Err(format!("{rows} rows of {}", list.rows()))
    }
}

/// A list before it is written.
struct Table {
    rows: usize,
    columns: Vec<(Quantity, Vec<f64>)>,
}

impl Table {
    fn random(draw: &mut Draw) -> Self {
        let rows = draw.one_of(&[0, 1, 2, 3, 30]);
        let quantities: Vec<Quantity> = Quantity::HOOP
            .into_iter()
            .chain(Quantity::START)
            .filter(|_| draw.comes(0.4))
            .collect();
        let mut columns = Vec::new();
        for quantity in quantities {
            let mut value = || {
                if draw.comes(0.02) {
                    draw.any(quantity)
                } else {
                    draw.between(quantity.row().usual)
                }
            };
            columns.push((quantity, (0..rows).map(|_| value()).collect()));
        }
        Self { rows, columns }
    }

    fn csv(&self, draw: &mut Draw) -> String {
        let end = draw.one_of(&["\n", "\r\n"]);
        let header: Vec<&str> = self
            .columns
            .iter()
            .map(|(quantity, _)| quantity.name())
            .collect();
        let mut text = header.join(",") + end;
        for row in 0..self.rows {
            let cells: Vec<String> = self
                .columns
                .iter()
                .map(|(_, values)| values[row].to_string())
                .collect();
            text += &cells.join(",");
            text += end;
        }
        text
    }
}
