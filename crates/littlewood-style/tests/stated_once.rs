//! Names, labels and colours stand in their table and in no other source file.
//!
//! Rust has the items themselves: a name in quotes outside its table is a second statement. Python
//! and TypeScript look an item up by its name, and a wrong one is an error there (a `KeyError`, a
//! type that does not fit); in these a file states a table a second time if it has labels or
//! colours of it, or the greater part of its names.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use littlewood::modes::RecurrenceKind;
use littlewood::tables::{Class, PhaseCode, Quantity, SampleColumn, SummaryColumn};
use littlewood::theory::StartRegion;
use littlewood::{Cause, OutcomeKind};
use littlewood_style::{Curve, Theme, swatches};

/// Where sources are, with the endings that they have there.
const SOURCES: [(&str, &[&str]); 3] = [
    ("crates", &["rs"]),
    ("python/littlewood", &["py", "pyi", "css", "js"]),
    ("web/src", &["ts", "css", "js"]),
];

/// Folders and files of sources that are not written by hand.
const GENERATED: [&str; 3] = [
    "web/src/generated",
    "web/src/wasm",
    "python/littlewood/lab/laboratory.js",
];

const QUANTITIES: &str = "crates/littlewood/src/model/quantity.rs";
const CURVES: &str = "crates/littlewood-style/src/curve.rs";

/// Where texts of a table are allowed to stand a second time.
struct Exception {
    file: &'static str,
    texts: &'static [&'static str],
    reason: &'static str,
}

const EXCEPTIONS: &[Exception] = &[
    Exception {
        file: "crates/littlewood/src/walk/outcome.rs",
        texts: &["gap_rate", "half_swings", "transitions"],
        reason: "details of an outcome; the columns depend on outcomes, so that this file cannot ask them",
    },
    Exception {
        file: "crates/littlewood/src/model/mode.rs",
        texts: &["mode of motion"],
        reason: "the noun of a message about an unknown name",
    },
    Exception {
        file: "crates/littlewood/src/engine/fallback.rs",
        texts: &["turning_point"],
        reason: "a reason to leave a slide to the simulation, not an event of it",
    },
    Exception {
        file: "crates/littlewood-sweep/src/description.rs",
        texts: &["transitions"],
        reason: "the limit of a run, not the count of a summary",
    },
    Exception {
        file: "python/littlewood/fitting/track_columns.py",
        texts: &["angular acceleration"],
        reason: "a column of the programs that track films",
    },
];

/// Files in Python and TypeScript that name the greater part of a table, with the tables.
struct Listing {
    file: &'static str,
    table: &'static str,
    reason: &'static str,
}

const LISTINGS: &[Listing] = &[
    Listing {
        file: "python/littlewood/hoop.py",
        table: QUANTITIES,
        reason: "arguments of functions by name; python/tests/test_tables.py holds their signatures against the table",
    },
    Listing {
        file: "python/littlewood/certify/case.py",
        table: QUANTITIES,
        reason: "each number enters the exact fractions of the certifier by name",
    },
    Listing {
        file: "python/littlewood/certify/checker.py",
        table: QUANTITIES,
        reason: "the checker takes nothing over from the package whose certificates it checks",
    },
    Listing {
        file: "python/littlewood/certify/motion.py",
        table: "crates/littlewood/src/walk/automaton.rs",
        reason: "the certifier decides each event by itself",
    },
    Listing {
        file: "python/littlewood/certify/checker.py",
        table: "crates/littlewood/src/walk/automaton.rs",
        reason: "the checker takes nothing over from the package whose certificates it checks",
    },
    Listing {
        file: "python/littlewood/plot/plane.py",
        table: CURVES,
        reason: "each curve is computed by a function of its own",
    },
    Listing {
        file: "web/src/views/plane.ts",
        table: CURVES,
        reason: "the order in which curves lie over each other, and where their letters stand",
    },
];

/// A source file without comments and unit tests.
struct Source {
    file: String,
    text: String,
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn sources() -> Vec<Source> {
    let mut sources = Vec::new();
    for (folder, endings) in SOURCES {
        collect(&root(), Path::new(folder), endings, &mut sources);
    }
    sources
}

fn collect(root: &Path, folder: &Path, endings: &[&str], sources: &mut Vec<Source>) {
    for entry in fs::read_dir(root.join(folder)).expect("a folder of the repository") {
        let entry = entry.expect("an entry of a folder");
        let path = folder.join(entry.file_name());
        let file = path.to_str().expect("a name in UTF-8").replace('\\', "/");
        if entry.file_type().expect("a type").is_dir() {
            if !GENERATED.contains(&file.as_str()) {
                collect(root, &path, endings, sources);
            }
            continue;
        }
        let ending = path
            .extension()
            .and_then(|ending| ending.to_str())
            .unwrap_or_default();
        let is_source = !GENERATED.contains(&file.as_str())
            && (!file.starts_with("crates") || file.split('/').nth(2) == Some("src"));
        if is_source && endings.contains(&ending) {
            let text = fs::read_to_string(root.join(&path)).expect("a text in UTF-8");
            sources.push(Source {
                file,
                text: unwrapped(&without_comments(&text, ending)),
            });
        }
    }
}

/// Leaves out lines that are comments and, in Rust, the unit tests at the end.
fn without_comments(text: &str, ending: &str) -> String {
    let text = match (ending, text.find("#[cfg(test)]\nmod tests")) {
        ("rs", Some(end)) => &text[..end],
        _ => text,
    };
    let opens: &[&str] = if ending.starts_with("py") {
        &["#"]
    } else {
        &["//", "/*", "* "]
    };
    text.lines()
        .filter(|line| !opens.iter().any(|open| line.trim_start().starts_with(open)))
        .flat_map(|line| [line, "\n"])
        .collect()
}

/// Joins lines that end in a backslash inside of a literal.
fn unwrapped(text: &str) -> String {
    let mut parts = text.split("\\\n");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |joined, part| joined + part.trim_start())
}

/// A table of the core or the style.
struct Table {
    file: &'static str,
    names: Vec<&'static str>,
    labels: Vec<&'static str>,
}

fn tables() -> Vec<Table> {
    let table = |file, names: &[&'static str], labels: &[&'static str]| Table {
        file,
        names: names
            .iter()
            .copied()
            .filter(|name| is_unmistakable(name))
            .collect(),
        // One word of a label is plain English.
        labels: labels
            .iter()
            .copied()
            .filter(|label| label.contains(' '))
            .collect(),
    };
    vec![
        table(
            QUANTITIES,
            &Quantity::NAMES,
            &[
                Quantity::ALL.map(Quantity::long_name),
                Quantity::ALL.map(|quantity| quantity.row().help),
            ]
            .concat(),
        ),
        table(
            "crates/littlewood/src/walk/automaton.rs",
            &Cause::NAMES,
            &Cause::ALL.map(Cause::label),
        ),
        table(
            "crates/littlewood/src/walk/outcome.rs",
            &OutcomeKind::NAMES,
            &OutcomeKind::ALL.map(OutcomeKind::label),
        ),
        table(
            "crates/littlewood/src/motion/class.rs",
            &Class::NAMES,
            &Class::ALL.map(Class::label),
        ),
        table(
            "crates/littlewood/src/motion/columns.rs",
            &SampleColumn::NAMES,
            &SampleColumn::ALL.map(SampleColumn::long_name),
        ),
        table(
            "crates/littlewood/src/motion/columns.rs",
            &SummaryColumn::NAMES,
            &SummaryColumn::ALL.map(SummaryColumn::long_name),
        ),
        table(
            "crates/littlewood/src/walk/sequence.rs",
            &[],
            &PhaseCode::ALL.map(PhaseCode::meaning),
        ),
        table(
            "crates/littlewood/src/motion/classify.rs",
            &StartRegion::NAMES,
            &[],
        ),
        table(
            "crates/littlewood/src/modes/rolling/recurrence.rs",
            &RecurrenceKind::NAMES,
            &[],
        ),
        table(
            CURVES,
            &Curve::ALL.map(Curve::name),
            &[0.0, 1.0]
                .map(|slope| Curve::ALL.map(|curve| curve.label(slope)))
                .concat(),
        ),
    ]
}

/// Long enough not to be a word that stands in a source for something else.
fn is_unmistakable(name: &str) -> bool {
    name.contains('_') || name.len() >= 10
}

fn is_rust(source: &Source) -> bool {
    source.file.ends_with(".rs")
}

fn has_literal(source: &Source, text: &str) -> bool {
    let quotes: &[char] = if source.file.ends_with(".ts") {
        &['"', '\'', '`']
    } else {
        &['"', '\'']
    };
    quotes
        .iter()
        .any(|quote| source.text.contains(&format!("{quote}{text}{quote}")))
}

/// Whether an object of TypeScript has a key of this name.
fn has_key(source: &Source, name: &str) -> bool {
    source.file.ends_with(".ts")
        && [' ', '{']
            .iter()
            .any(|before| source.text.contains(&format!("{before}{name}:")))
}

/// What stands a second time is what is allowed to, no more and no less.
fn compare<'a>(
    found: BTreeSet<(&'a str, &'a str)>,
    allowed: impl Iterator<Item = (&'static str, &'static str)>,
) {
    let allowed: BTreeSet<(&str, &str)> = allowed.collect();
    let left: Vec<_> = found.difference(&allowed).collect();
    assert!(left.is_empty(), "stated a second time:\n{left:#?}");
    let unused: Vec<_> = allowed.difference(&found).collect();
    assert!(unused.is_empty(), "exceptions that are none:\n{unused:#?}");
}

#[test]
fn names_and_labels_stand_in_their_tables_alone() {
    let sources = sources();
    let rust = sources.iter().filter(|source| is_rust(source)).count();
    assert!(rust > 150 && sources.len() > rust + 50);
    let tables = tables();
    let mut found = BTreeSet::new();
    for Table {
        file,
        names,
        labels,
    } in &tables
    {
        let table = sources
            .iter()
            .find(|source| source.file == *file)
            .expect("the file of a table");
        for (text, is_label) in names
            .iter()
            .map(|name| (*name, false))
            .chain(labels.iter().map(|label| (*label, true)))
        {
            assert!(has_literal(table, text), "{text} is not in {file}");
            // Two tables may have the same name, of a cause and of the outcome that it leads to.
            let is_another = |other: &&Source| {
                !tables.iter().any(|table| {
                    table.file == other.file
                        && (table.names.contains(&text) || table.labels.contains(&text))
                })
            };
            for other in sources.iter().filter(is_another) {
                if has_literal(other, text) && (is_label || is_rust(other)) {
                    found.insert((other.file.as_str(), text));
                }
            }
        }
    }
    let allowed = EXCEPTIONS.iter().flat_map(|exception| {
        assert!(!exception.reason.is_empty());
        exception.texts.iter().map(|text| (exception.file, *text))
    });
    compare(found, allowed);
}

#[test]
fn no_file_in_another_language_lists_a_table() {
    let sources = sources();
    let tables = tables();
    let mut found = BTreeSet::new();
    for source in sources.iter().filter(|source| !is_rust(source)) {
        for Table { file, names, .. } in tables.iter().filter(|table| table.names.len() > 1) {
            let named = names
                .iter()
                .filter(|name| has_literal(source, name) || has_key(source, name))
                .count();
            if 2 * named > names.len() {
                found.insert((source.file.as_str(), *file));
            }
        }
    }
    compare(
        found,
        LISTINGS.iter().map(
            |Listing {
                 file,
                 table,
                 reason,
             }| {
                assert!(!reason.is_empty());
                (*file, *table)
            },
        ),
    );
}

#[test]
fn every_file_of_tests_is_a_module_of_their_program() {
    let crates = root().join("crates");
    let mut forgotten = Vec::new();
    for package in fs::read_dir(crates).unwrap() {
        let tests = package.unwrap().path().join("tests");
        let Ok(all) = fs::read_to_string(tests.join("all.rs")) else {
            continue;
        };
        for file in fs::read_dir(&tests).unwrap() {
            let file = file.unwrap().path();
            let name = file.file_stem().unwrap().to_string_lossy().into_owned();
            let has_tests = file.extension().is_some_and(|ending| ending == "rs")
                || file.join("mod.rs").exists();
            if has_tests && name != "all" && !all.contains(&format!("mod {name};")) {
                forgotten.push(file);
            }
        }
    }
    assert!(forgotten.is_empty(), "nobody runs {forgotten:#?}");
}

#[test]
fn colours_stand_in_the_style_alone() {
    let colours: BTreeSet<[u8; 3]> = Theme::ALL
        .into_iter()
        .flat_map(swatches)
        .map(|swatch| swatch.colour.0)
        .collect();
    assert!(colours.len() > 50);
    let mut second = Vec::new();
    for source in sources()
        .iter()
        .filter(|source| !source.file.starts_with("crates/littlewood-style/"))
    {
        let text = source.text.to_lowercase();
        for [red, green, blue] in &colours {
            for written in [
                format!("#{red:02x}{green:02x}{blue:02x}"),
                format!("0x{red:02x}{green:02x}{blue:02x}"),
                format!("0x{red:02x}, 0x{green:02x}, 0x{blue:02x}"),
                format!("rgb({red}, {green}, {blue})"),
                format!("rgb({red} {green} {blue})"),
            ] {
                if text.contains(&written) {
                    second.push((source.file.clone(), written));
                }
            }
        }
    }
    assert!(second.is_empty(), "stated a second time:\n{second:#?}");
}
