//! Captions as files: Markdown, and a figure of LaTeX.

use crate::draw::{Script, markdown, plain, runs};
use crate::figure::Figure;

impl Figure {
    /// The caption without marks.
    #[must_use]
    pub fn caption_txt(&self) -> String {
        format!("{}\n\n{}\n", plain(&self.title), plain(&self.caption))
    }

    /// The figure in Markdown: the picture, its title and its caption.
    #[must_use]
    pub fn caption_md(&self) -> String {
        let Self { name, title, caption, .. } = self;
        format!("![{}]({name}.svg)\n\n**{}.** {}\n", plain(title), markdown(title), markdown(caption))
    }

    /// The figure in LaTeX, with the PDF as its graphics: a file to be read by `\input`.
    #[must_use]
    pub fn caption_tex(&self) -> String {
        let Self { name, title, caption, .. } = self;
        let width =
            self.print_mm.map_or_else(|| "width=\\linewidth".to_owned(), |mm| format!("width={mm}mm"));
        format!(
            "\\begin{{figure}}\n  \\centering\n  \\includegraphics[{width}]{{{name}.pdf}}\n  \
             \\caption{{\\textbf{{{}.}} {}}}\n  \\label{{fig:{name}}}\n\\end{{figure}}\n",
            latex(title),
            latex(caption)
        )
    }
}

/// As LaTeX: symbols, numbers between them, indices and exponents in formulas, the rest as text.
#[must_use]
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
                    let is_decimal = letter == '.' && rest.peek().is_some_and(char::is_ascii_digit);
                    writer.letter(letter, is_decimal);
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

    fn letter(&mut self, letter: char, is_decimal: bool) {
        match (letter, symbol(letter)) {
            (_, Some(symbol)) if symbol.starts_with('\\') => self.formula(&format!("{symbol}{{}}")),
            (_, Some(symbol)) => self.formula(symbol),
            ('<' | '>' | '|' | '=' | '+' | '/', None) => self.formula(&letter.to_string()),
            (' ', None) if self.is_formula && !self.has_space => self.has_space = true,
            (digit, None) if self.is_formula && (digit.is_ascii_digit() || is_decimal) => {
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
        // A line over the letter before.
        if letters.peek() == Some(&'\u{304}') {
            letters.next();
            out += &format!("\\bar{{{letter}}}");
        } else if let Some(symbol) = symbol(letter) {
            out += symbol;
            // A name of letters ends before another letter.
            if symbol.starts_with('\\') && letters.peek().is_some_and(char::is_ascii_alphabetic) {
                out.push(' ');
            }
        } else if letter.is_ascii_alphabetic() && !italic {
            out += &format!("\\mathrm{{{letter}}}");
        } else {
            out.push(letter);
        }
    }
    out
}

/// Symbols beyond ASCII.
const fn symbol(letter: char) -> Option<&'static str> {
    Some(match letter {
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

#[cfg(test)]
mod tests {
    use littlewood::si::SiParameters;

    use super::*;
    use crate::{FIGURES, FigureInput};

    #[test]
    fn symbols_are_formulas_and_words_are_text() {
        assert_eq!(latex("|*F*| = *μ*_{s}*N* at 5%"), "$|F| = \\mu_{\\mathrm{s}}N$ at 5\\%");
        assert_eq!(latex("*θ*′^{2} = 10^{−9}."), "$\\theta'^{2} = 10^{-9}$.");
        assert_eq!(latex("*μ*_{k} = 0.4. In 2019"), "$\\mu_{\\mathrm{k}} = 0.4$. In 2019");
        assert_eq!(latex("*X̄* moves by *ℓh*"), "$\\bar{X}$ moves by $\\ell h$");
    }

    /// What LaTeX would not take.
    fn faults(tex: &str) -> Vec<String> {
        let mut found = Vec::new();
        found
            .extend(tex.chars().filter(|letter| !letter.is_ascii()).map(|letter| format!("letter {letter}")));
        for (open, close) in [('{', '}'), ('[', ']')] {
            let count = |wanted: char| tex.chars().filter(|letter| *letter == wanted).count();
            if count(open) != count(close) {
                found.push(format!("{open} without {close}"));
            }
        }
        if tex.contains("$$") {
            found.push("an empty formula".to_owned());
        }
        let (mut is_formula, mut last) = (false, ' ');
        for letter in tex.chars() {
            match letter {
                '$' if last != '\\' => is_formula = !is_formula,
                '%' | '&' | '#' if last != '\\' => found.push(format!("{letter} alone")),
                '^' | '_' if !is_formula && last != '\\' => found.push(format!("{letter} in a text")),
                '~' => found.push("~".to_owned()),
                _ => {}
            }
            last = if last == '\\' && letter == '\\' { ' ' } else { letter };
        }
        if is_formula {
            found.push("a formula without end".to_owned());
        }
        found
    }

    #[test]
    fn captions_have_nothing_that_latex_does_not_take() {
        assert_eq!(faults("5% of $x$ é").len(), 2);
        let units = SiParameters {
            particle_mass_kg: 0.14,
            radius_m: 0.45,
            gravity_m_per_s2: 9.81,
            ..SiParameters::default()
        }
        .units()
        .expect("units");
        let mut count = 0;
        for case in littlewood::cases::CASES {
            let input = FigureInput::of_case(case.name).expect("a case");
            let limits = input.limits.with_until(Some(30.0));
            for units in [None, Some(units)] {
                let input = FigureInput { limits, units, ..input };
                // Whose captions are those of its own case, but for the numbers of the hoop.
                let slow = |name| ["outcomes", "bifurcation"].contains(&name);
                for entry in FIGURES.iter().filter(|entry| entry.case == case.name || !slow(entry.name)) {
                    if let Ok(figure) = entry.figure(&input) {
                        let tex = figure.caption_tex();
                        assert_eq!(faults(&tex), [""; 0], "{} of {}: {tex}", entry.name, case.name);
                        count += 1;
                    }
                }
            }
        }
        assert!(count > 200, "{count}");
    }
}
