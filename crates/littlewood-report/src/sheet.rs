//! A page of text: a title, facts with a label each, tables and notes.

use std::io::{self, Write};

use littlewood::Mode;

/// Width of the labels.
const LABEL: usize = 9;

/// Room between two columns.
const GAP: usize = 2;

/// A row of a table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Row {
    /// The mode of motion whose colour the row may have.
    pub mode: Option<Mode>,
    /// Where the row begins in time, over √(R/g), if it is about a time.
    pub time: Option<f64>,
    /// Phases that it stands for together, if they are several.
    pub folds: Option<usize>,
    /// A text for each column; those at the end may be missing.
    pub cells: Vec<String>,
}

impl From<Vec<String>> for Row {
    fn from(cells: Vec<String>) -> Self {
        Self {
            cells,
            ..Self::default()
        }
    }
}

/// A table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Table {
    /// The headings; a second line, if any, is the unit.
    pub head: Vec<String>,
    /// The rows.
    pub rows: Vec<Row>,
    /// The columns of numbers, which are aligned to the right.
    pub numbers: Vec<usize>,
}

/// A part of a page.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// A title.
    Title(String),
    /// A label, and lines beside it.
    Fact(&'static str, Vec<String>),
    /// A table.
    Table(Table),
    /// A note in small print.
    Note(String),
    /// An empty line.
    Gap,
}

/// A page for a person.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    blocks: Vec<Block>,
}

impl Sheet {
    /// The parts, in order.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Adds a title.
    pub fn title(&mut self, text: String) {
        self.blocks.extend([Block::Title(text), Block::Gap]);
    }

    /// Adds a fact, unless it has no line.
    pub fn fact(&mut self, label: &'static str, lines: Vec<String>) {
        if !lines.is_empty() {
            self.blocks.push(Block::Fact(label, lines));
        }
    }

    /// Adds an empty line.
    pub fn gap(&mut self) {
        self.blocks.push(Block::Gap);
    }

    /// Adds a note.
    pub fn note(&mut self, text: &str) {
        self.blocks.push(Block::Note(text.to_owned()));
    }

    /// Adds a table that has been made.
    pub fn add(&mut self, table: Table) {
        self.blocks.push(Block::Table(table));
    }

    /// Adds a table.
    pub fn table(&mut self, head: Vec<String>, rows: Vec<impl Into<Row>>, numbers: &[usize]) {
        let rows = rows.into_iter().map(Into::into).collect();
        self.add(Table {
            head,
            rows,
            numbers: numbers.to_vec(),
        });
    }

    /// Writes the page, with the emphasis of a terminal if that is wanted. Tables break long cells
    /// to stay within `width`, if there is one.
    ///
    /// # Errors
    /// A failure to write.
    pub fn write(
        &self,
        writer: &mut dyn Write,
        emphasis: bool,
        width: Option<usize>,
    ) -> io::Result<()> {
        let [bold, dim, plain] = if emphasis {
            ["\x1b[1m", "\x1b[2m", "\x1b[0m"]
        } else {
            [""; 3]
        };
        for block in &self.blocks {
            match block {
                Block::Title(text) => writeln!(writer, "{bold}{text}{plain}")?,
                Block::Fact(label, lines) => {
                    for (index, line) in lines.iter().enumerate() {
                        let label = if index == 0 { label } else { "" };
                        writeln!(writer, "{bold}{label:<LABEL$}{plain}{line}")?;
                    }
                }
                Block::Table(table) => table.write(writer, width)?,
                Block::Note(text) => writeln!(writer, "{dim}{text}{plain}")?,
                Block::Gap => writeln!(writer)?,
            }
        }
        Ok(())
    }
}

impl Table {
    /// Writes the table with a line under its headings.
    fn write(&self, writer: &mut dyn Write, width: Option<usize>) -> io::Result<()> {
        let cells = || std::iter::once(&self.head).chain(self.rows.iter().map(|row| &row.cells));
        let mut widths = vec![0; self.head.len()];
        for (column, cell) in cells().flat_map(|row| row.iter().enumerate()) {
            let longest = cell.lines().map(length).max().unwrap_or(0);
            if let Some(width) = widths.get_mut(column) {
                *width = longest.max(*width);
            }
        }
        let total = |widths: &[usize]| widths.iter().sum::<usize>() + GAP * widths.len() - 1;
        // The widest columns are broken.
        while width.is_some_and(|width| total(&widths) > width)
            && let Some(widest) = widths.iter_mut().max()
            && *widest > 1
        {
            *widest -= 1;
        }
        for (index, row) in cells().enumerate() {
            self.write_row(writer, row, &widths)?;
            if index == 0 {
                writeln!(writer, "{}", "─".repeat(total(&widths)))?;
            }
        }
        Ok(())
    }

    fn write_row(
        &self,
        writer: &mut dyn Write,
        row: &[String],
        widths: &[usize],
    ) -> io::Result<()> {
        let columns = row.iter().zip(widths);
        let broken: Vec<Vec<String>> = columns.map(|(cell, &width)| broken(cell, width)).collect();
        let height = broken.iter().map(Vec::len).max().unwrap_or(0);
        for line in 0..height {
            let mut text = String::new();
            for (column, (cell, &width)) in broken.iter().zip(widths).enumerate() {
                let cell = cell.get(line).map_or("", String::as_str);
                let room = " ".repeat(width.saturating_sub(length(cell)));
                let (before, after) = if self.numbers.contains(&column) {
                    (room, String::new())
                } else {
                    (String::new(), room)
                };
                text.extend([&before, cell, &after, &" ".repeat(GAP)]);
            }
            writeln!(writer, "{}", text.trim_end())?;
        }
        Ok(())
    }
}

fn length(text: &str) -> usize {
    text.chars().count()
}

/// The lines of a cell, each within a width where words allow it.
fn broken(cell: &str, width: usize) -> Vec<String> {
    cell.lines()
        .flat_map(|line| filled(line.split(' ').map(str::to_owned), " ", width))
        .collect()
}

/// Items in lines, as many in each as there is room for.
pub(crate) fn filled(items: impl Iterator<Item = String>, gap: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for item in items {
        match lines.last_mut() {
            Some(line) if length(line) + length(gap) + length(&item) <= width => {
                line.push_str(gap);
                line.push_str(&item);
            }
            Some(_) | None => lines.push(item),
        }
    }
    lines
}
