//! The data of a figure as a table: all rows that are drawn, and no others.

use std::fmt::Write as _;

use crate::figure::Figure;

impl Figure {
    /// The data: panel, series, piece, then a column for each quantity; a cell is empty where a
    /// series does not have it. Numbers have all digits.
    pub fn csv(&self) -> String {
        let mut columns: Vec<&str> = Vec::new();
        let layers = || {
            self.panels
                .iter()
                .flat_map(|panel| panel.layers.iter().map(move |layer| (panel, layer)))
        };
        for (_, layer) in layers() {
            for column in &layer.series.columns {
                if !columns.contains(&column.as_ref()) {
                    columns.push(column);
                }
            }
        }
        let mut out = format!("panel,series,piece,{}\n", columns.join(","));
        for (panel, layer) in layers() {
            let places: Vec<Option<usize>> = columns
                .iter()
                .map(|column| layer.series.column(column))
                .collect();
            for (number, piece) in layer.series.pieces.iter().enumerate() {
                for row in piece {
                    let _ = write!(out, "{},{},{number}", panel.name, layer.series.name);
                    for place in &places {
                        out.push(',');
                        if let Some(value) = place
                            .and_then(|place| row.get(place))
                            .filter(|v| v.is_finite())
                        {
                            let _ = write!(out, "{value}");
                        }
                    }
                    out.push('\n');
                }
            }
        }
        out
    }
}
