//! Captions as files: Markdown, and a figure of LaTeX.

use crate::figure::Figure;
use crate::markup::{Script, markdown, plain, runs};

impl Figure {
    /// The caption without marks.
    pub fn caption_txt(&self) -> String {
        format!("{}\n\n{}\n", plain(&self.title), plain(&self.caption))
    }

    /// The figure in Markdown: the picture, its title and its caption.
    pub fn caption_md(&self) -> String {
        let Self {
            name,
            title,
            caption,
            ..
        } = self;
        format!(
            "![{}]({name}.svg)\n\n**{}.** {}\n",
            plain(title),
            markdown(title),
            markdown(caption)
        )
    }

    /// The figure in LaTeX, with the PDF as its graphics: a file to be read by `\input`.
    pub fn caption_tex(&self) -> String {
        let Self {
            name,
            title,
            caption,
            ..
        } = self;
        let width = self.print_mm.map_or_else(
            || "width=\\linewidth".to_owned(),
            |mm| format!("width={mm}mm"),
        );
        format!(
            "\\begin{{figure}}\n  \\centering\n  \\includegraphics[{width}]{{{name}.pdf}}\n  \
             \\caption{{\\textbf{{{}.}} {}}}\n  \\label{{fig:{name}}}\n\\end{{figure}}\n",
            latex(title),
            latex(caption)
        )
    }
}

/// As LaTeX: symbols, numbers between them, indices and exponents in formulas, the rest as text.
pub fn latex(text: &str) -> String {
    let mut writer = Writer::default();
    for run in runs(text) {
        let letters = letters_of(run.text, run.italic);
        match run.script {
            Script::Sub => writer.formula(&format!("_{{{letters}}}")),
            Script::Super => writer.formula(&format!("^{{{letters}}}")),
            Script::Line if run.bold => writer.formula(&format!("\\mathbf{{{}}}", run.text)),
            Script::Line if run.italic => writer.formula(&letters),
            Script::Line => {
                let mut rest = run.text.chars().peekable();
                while let Some(letter) = rest.next() {
                    let ahead = rest.clone().find(|letter| !letter.is_ascii_digit());
                    let goes_on = match letter {
                        '.' => rest.peek().is_some_and(char::is_ascii_digit),
                        // The argument of a function.
                        '(' => rest.peek().is_some_and(char::is_ascii_digit) && ahead == Some(')'),
                        ')' => writer.out.ends_with(|before: char| before.is_ascii_digit()),
                        _ => false,
                    };
                    writer.letter(letter, goes_on);
                }
            }
        }
    }
    writer.finish()
}

#[derive(Default)]
struct Writer {
    out: String,
    is_formula: bool,
    /// A space after a formula, in it or behind it.
    has_space: bool,
}

impl Writer {
    fn formula(&mut self, piece: &str) {
        if !self.is_formula {
            self.out.push('$');
            self.is_formula = true;
        } else if self.has_space {
            self.out.push(' ');
        }
        self.has_space = false;
        // A name of letters ends before another letter.
        let before = self
            .out
            .trim_end_matches(|letter: char| letter.is_ascii_alphabetic());
        if before.len() < self.out.len()
            && before.ends_with('\\')
            && piece.starts_with(|letter: char| letter.is_ascii_alphabetic())
        {
            self.out.push(' ');
        }
        self.out += piece;
    }

    fn text(&mut self, piece: &str) {
        if self.is_formula {
            self.out.push('$');
            self.is_formula = false;
        }
        if self.has_space {
            self.out.push(' ');
        }
        self.has_space = false;
        self.out += piece;
    }

    /// A letter that is upright; one of a formula goes on with it.
    fn letter(&mut self, letter: char, goes_on: bool) {
        match (letter, symbol(letter)) {
            (_, Some(symbol)) => self.formula(symbol),
            ('<' | '>' | '|' | '=' | '+', None) => self.formula(&letter.to_string()),
            ('/', None) if self.is_formula && !self.has_space => self.formula("/"),
            (' ', None) if self.is_formula && !self.has_space => self.has_space = true,
            (digit, None) if self.is_formula && (digit.is_ascii_digit() || goes_on) => {
                self.formula(&digit.to_string());
            }
            ('%' | '&' | '#' | '$' | '_' | '{' | '}', None) => self.text(&format!("\\{letter}")),
            ('\\', None) => self.text("\\textbackslash{}"),
            ('é', None) => self.text("\\'e"),
            ('§', None) => self.text("\\S{}"),
            ('~', None) => self.text("\\textasciitilde{}"),
            ('^', None) => self.text("\\textasciicircum{}"),
            (other, None) => self.text(&other.to_string()),
        }
    }

    fn finish(mut self) -> String {
        if self.is_formula {
            self.out.push('$');
        }
        self.out
    }
}

/// Letters of a formula, upright if they are words.
fn letters_of(text: &str, italic: bool) -> String {
    let mut out = String::new();
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        // An accent follows its letter.
        let accent = match letters.peek() {
            Some('\u{302}') => Some("hat"),
            Some('\u{304}') => Some("bar"),
            _ => None,
        };
        if let Some(accent) = accent {
            letters.next();
            out += &format!("\\{accent}{{{letter}}}");
        } else if let Some(symbol) = symbol(letter) {
            out += symbol;
            // A name of letters ends before another letter.
            if symbol.starts_with('\\') && letters.peek().is_some_and(char::is_ascii_alphabetic) {
                out.push(' ');
            }
        } else if letter.is_ascii_alphabetic() && !italic {
            let mut word = letter.to_string();
            while let Some(next) = letters.next_if(char::is_ascii_alphabetic) {
                word.push(next);
            }
            out += &format!("\\mathrm{{{word}}}");
        } else {
            out.push(letter);
        }
    }
    out
}

/// Symbols beyond ASCII.
const fn symbol(letter: char) -> Option<&'static str> {
    Some(match letter {
        'α' => "\\alpha",
        'θ' => "\\theta",
        'τ' => "\\tau",
        'γ' => "\\gamma",
        'η' => "\\eta",
        'μ' => "\\mu",
        'π' => "\\pi",
        'ω' => "\\omega",
        'ℓ' => "\\ell",
        '𝓡' => "\\mathcal{R}",
        '𝓝' => "\\mathcal{N}",
        '′' => "'",
        '−' => "-",
        '±' => "\\pm",
        '×' => "\\times",
        '·' => "\\cdot",
        '√' => "\\surd",
        '∞' => "\\infty",
        '≤' => "\\leq",
        '≥' => "\\geq",
        '≠' => "\\neq",
        '≈' => "\\approx",
        '°' => "^{\\circ}",
        '½' => "\\tfrac12",
        '¼' => "\\tfrac14",
        '→' => "\\to",
        '…' => "\\ldots",
        _ => return None,
    })
}
