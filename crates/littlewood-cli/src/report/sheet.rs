//! A page of text: a title, facts with a label each, tables and notes.

use std::io::{self, Write};

use anstyle::Style;
use comfy_table::{CellAlignment, ContentArrangement, LineStyle, Table, TableStyle};

/// Width of the labels.
const LABEL: usize = 9;

/// A page for a person, with or without emphasis.
pub(super) struct Sheet<'a> {
    writer: &'a mut dyn Write,
    bold: Style,
    dim: Style,
}

impl<'a> Sheet<'a> {
    pub(super) fn new(writer: &'a mut dyn Write, colour: bool) -> Self {
        let (bold, dim) =
            if colour { (Style::new().bold(), Style::new().dimmed()) } else { (Style::new(), Style::new()) };
        Self { writer, bold, dim }
    }

    pub(super) fn title(&mut self, text: &str) -> io::Result<()> {
        let bold = self.bold;
        writeln!(self.writer, "{bold}{text}{bold:#}\n")
    }

    /// A fact; further lines stand under the first.
    pub(super) fn fact(&mut self, label: &str, lines: &[String]) -> io::Result<()> {
        let bold = self.bold;
        for (index, line) in lines.iter().enumerate() {
            let label = if index == 0 { label } else { "" };
            writeln!(self.writer, "{bold}{label:<LABEL$}{bold:#}{line}")?;
        }
        Ok(())
    }

    pub(super) fn gap(&mut self) -> io::Result<()> {
        writeln!(self.writer)
    }

    pub(super) fn note(&mut self, text: &str) -> io::Result<()> {
        let dim = self.dim;
        writeln!(self.writer, "{dim}{text}{dim:#}")
    }

    /// A table with a line under its header. The columns named in `numbers` are aligned to the right. `width` breaks
    /// long cells.
    pub(super) fn table(
        &mut self,
        header: &[impl AsRef<str>],
        rows: Vec<Vec<String>>,
        numbers: &[usize],
        width: Option<u16>,
    ) -> io::Result<()> {
        const STYLE: TableStyle =
            TableStyle::new().header_separator(LineStyle::none().fill('─').junction('─'));
        let mut table = Table::new();
        table.load_style(STYLE);
        table.set_header(header.iter().map(AsRef::as_ref));
        table.add_rows(rows);
        match width {
            Some(width) => {
                table.set_content_arrangement(ContentArrangement::Dynamic).set_width(width);
            }
            None => {
                table.set_content_arrangement(ContentArrangement::Disabled);
            }
        }
        for (index, column) in table.column_iter_mut().enumerate() {
            column.set_padding((0, 1));
            if numbers.contains(&index) {
                column.set_cell_alignment(CellAlignment::Right);
            }
        }
        // The padding of the last column is no part of the page.
        for line in table.lines() {
            writeln!(self.writer, "{}", line.trim_end())?;
        }
        Ok(())
    }
}
