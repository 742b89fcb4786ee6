//! Text with symbols: `*θ*` is italic, `` `E` `` bold, `_{s}` below the line, `^{2}` above it.

/// Where a run stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Script {
    /// On the line.
    Line,
    /// Below it.
    Sub,
    /// Above it.
    Super,
}

/// Letters of one kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Run<'a> {
    /// The letters.
    pub text: &'a str,
    /// Whether they are italic.
    pub italic: bool,
    /// Whether they are bold.
    pub bold: bool,
    /// Where they stand.
    pub script: Script,
}

/// The runs of a text.
pub fn runs(text: &str) -> Vec<Run<'_>> {
    let mut runs = Vec::new();
    let (mut italic, mut bold, mut script, mut begin, mut at) = (false, false, Script::Line, 0, 0);
    while at < text.len() {
        let rest = &text[at..];
        let (marks, next_script) = if rest.starts_with(['*', '`']) {
            (1, script)
        } else if rest.starts_with("_{") {
            (2, Script::Sub)
        } else if rest.starts_with("^{") {
            (2, Script::Super)
        } else if rest.starts_with('}') && script != Script::Line {
            (1, Script::Line)
        } else {
            at += rest.chars().next().map_or(1, char::len_utf8);
            continue;
        };
        if begin < at {
            runs.push(Run {
                text: &text[begin..at],
                italic,
                bold,
                script,
            });
        }
        italic ^= rest.starts_with('*');
        bold ^= rest.starts_with('`');
        script = next_script;
        at += marks;
        begin = at;
    }
    if begin < text.len() {
        runs.push(Run {
            text: &text[begin..],
            italic,
            bold,
            script,
        });
    }
    runs
}

/// Letters and digits that stand below or above the line by themselves, each as it is on the line,
/// and where it stands.
pub(crate) fn scripted() -> impl Iterator<Item = (char, char, Script)> {
    let all = [
        ("₁₂ₛₖ", "12sk", Script::Sub),
        ("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789−", Script::Super),
    ];
    all.into_iter().flat_map(|(own, plain, script)| {
        own.chars()
            .zip(plain.chars())
            .map(move |(own, plain)| (own, plain, script))
    })
}

/// Such a letter as it is on the line, and where it stands.
pub(crate) fn small(letter: char) -> Option<(char, Script)> {
    scripted()
        .find(|(own, ..)| *own == letter)
        .map(|(_, plain, script)| (plain, script))
}

/// The letter that stands there by itself.
fn raised(letter: char, place: Script) -> Option<char> {
    scripted()
        .find(|&(_, plain, script)| (plain, script) == (letter, place))
        .map(|(own, ..)| own)
}

/// The mathematical symbol of Unicode that is a letter in italics.
pub(crate) fn symbol(letter: char) -> char {
    let code = |first: u32, of: char| first + u32::from(letter) - u32::from(of);
    let code = match letter {
        'h' => 0x210e,
        'A'..='Z' => code(0x1d434, 'A'),
        'a'..='z' => code(0x1d44e, 'a'),
        'Α'..='Ω' => code(0x1d6e2, 'Α'),
        'α'..='ω' => code(0x1d6fc, 'α'),
        'ϱ' => 0x1d71a,
        other => other.into(),
    };
    char::from_u32(code).unwrap_or(letter)
}

/// The letters alone; what stands below or above the line keeps its place, or a sign before it
/// tells of it.
pub fn plain(text: &str) -> String {
    let mut out = String::new();
    for Run { text, script, .. } in runs(text) {
        let small: Option<String> = text.chars().map(|letter| raised(letter, script)).collect();
        match (script, small) {
            (Script::Line, _) => out += text,
            (_, Some(small)) => out += &small,
            (Script::Sub, None) => out.extend(["_", text]),
            (Script::Super, None) => out.extend(["^", text]),
        }
    }
    out
}

/// The signs that draw a text with [`font`](crate::font): italics are mathematical symbols, and
/// what stands below or above the line is a small sign, one for private use where Unicode has none.
pub fn unicode(text: &str) -> String {
    let mut out = String::new();
    for Run {
        text,
        italic,
        script,
        ..
    } in runs(text)
    {
        out.extend(text.chars().map(|letter| match script {
            Script::Line => {
                if italic {
                    symbol(letter)
                } else {
                    letter
                }
            }
            Script::Sub | Script::Super => {
                raised(letter, script).unwrap_or_else(|| private(letter, script))
            }
        }));
    }
    out
}

/// A sign for private use: a letter of ASCII below or above the line.
pub(crate) fn private(letter: char, script: Script) -> char {
    let first = if script == Script::Sub {
        0xe000
    } else {
        0xe100
    };
    let sign = letter
        .is_ascii()
        .then(|| char::from_u32(first + u32::from(letter)))
        .flatten();
    sign.unwrap_or(letter)
}

/// As Markdown.
pub fn markdown(text: &str) -> String {
    let mut out = String::new();
    for Run {
        text,
        italic,
        bold,
        script,
    } in runs(text)
    {
        let (open, close) = match script {
            Script::Line => ("", ""),
            Script::Sub => ("<sub>", "</sub>"),
            Script::Super => ("<sup>", "</sup>"),
        };
        let star = match (italic, bold) {
            (false, false) => "",
            (true, false) => "*",
            (false, true) => "**",
            (true, true) => "***",
        };
        out.extend([open, star, text, star, close]);
    }
    out
}
