//! A place in a file, shown with its line.

use std::ops::Range;
use std::path::Path;

use anstyle::{AnsiColor, Style};

#[derive(Debug)]
pub(crate) struct Excerpt {
    file: String,
    /// Line and column, from 1; a column is a letter.
    line: usize,
    column: usize,
    text: String,
    letters: usize,
}

impl Excerpt {
    /// The place of some bytes of a text. Where they are more than a line, the rest of their first
    /// line is meant.
    pub(crate) fn new(file: &Path, text: &str, bytes: &Range<usize>) -> Self {
        let start = text.floor_char_boundary(bytes.start.min(text.len()));
        let line_start = text[..start].rfind('\n').map_or(0, |end| end + 1);
        let line = text[line_start..].lines().next().unwrap_or_default();
        let line_end = line_start + line.len();
        let end = text.floor_char_boundary(bytes.end.clamp(start, line_end.max(start)));
        Self {
            file: file.display().to_string(),
            line: text[..line_start].matches('\n').count() + 1,
            column: text[line_start..start].chars().count() + 1,
            text: line.to_owned(),
            letters: text[start..end].chars().count().max(1),
        }
    }

    /// The name of the file, the line, and marks under what is meant.
    pub(super) fn render(&self) -> String {
        let Self {
            file,
            line,
            column,
            text,
            letters,
        } = self;
        let blue = Style::new().bold().fg_color(Some(AnsiColor::Cyan.into()));
        let red = Style::new().bold().fg_color(Some(AnsiColor::Red.into()));
        let number = line.to_string();
        let margin = " ".repeat(number.len());
        // A tab is as wide here as it is in the line above.
        let before: String = text
            .chars()
            .take(column - 1)
            .map(|letter| if letter == '\t' { '\t' } else { ' ' })
            .collect();
        let marks = "^".repeat(*letters);
        format!(
            "\n{margin} {blue}-->{blue:#} {file}:{line}:{column}\n{blue}{number} |{blue:#} {text}\n\
             {margin} {blue}|{blue:#} {before}{red}{marks}{red:#}\n"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::Excerpt;

    fn shown(text: &str, bytes: std::ops::Range<usize>) -> String {
        anstream::adapter::strip_str(&Excerpt::new("a.toml".as_ref(), text, &bytes).render())
            .to_string()
    }

    #[test]
    fn the_line_is_shown_with_marks_under_what_is_meant() {
        assert_eq!(
            shown("a = 1\nθ = two\n", 11..14),
            "\n  --> a.toml:2:5\n2 | θ = two\n  |     ^^^\n"
        );
    }

    #[test]
    fn any_place_is_shown() {
        // The end of the file, more than a line, the middle of a letter.
        assert!(shown("a", 1..9).contains("a.toml:1:2"));
        assert!(shown("a = [\n1]\n", 4..8).contains("    ^\n"));
        assert!(shown("θθ", 3..3).contains("a.toml:1:2"));
        assert!(shown("", 0..0).contains("a.toml:1:1"));
        assert!(shown("a\r\n", 2..3).contains("a.toml:1:"));
    }
}
