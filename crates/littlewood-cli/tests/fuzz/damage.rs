//! Damage to bytes and to folders of files.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use littlewood_random::Draw;

/// Files by their path within a folder.
pub(crate) type Tree = BTreeMap<PathBuf, Vec<u8>>;

/// Damages a few bytes, and says how.
pub(crate) fn damage(draw: &mut Draw, bytes: &mut Vec<u8>) -> String {
    let at = draw.below(bytes.len());
    match draw.below(8) {
        0 => {
            bytes.truncate(at);
            format!("cut at {at}")
        }
        1 => {
            bytes.clear();
            "emptied".to_owned()
        }
        2 => {
            let junk: Vec<u8> = (0..1 + draw.below(40)).map(|_| draw.bits() as u8).collect();
            bytes.splice(at..at, junk);
            format!("junk put in at {at}")
        }
        3 => {
            let end = (at + 1 + draw.below(40)).min(bytes.len());
            bytes.drain(at.min(end)..end);
            format!("{at} to {end} taken out")
        }
        4 => {
            let part = bytes[at..].to_vec();
            bytes.extend(part);
            format!("from {at} on twice")
        }
        5 if !bytes.is_empty() => {
            bytes[at] = draw.one_of(b"\0\n\"{}[],=-09.eN\xff");
            format!("another letter at {at}")
        }
        _ if !bytes.is_empty() => {
            bytes[at] ^= 1 << draw.below(8);
            format!("a bit at {at}")
        }
        _ => "nothing".to_owned(),
    }
}

/// Damages a text line by line or word by word, which keeps more of its grammar.
pub(crate) fn damage_text(draw: &mut Draw, text: &str) -> String {
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    let at = draw.below(lines.len());
    match draw.below(6) {
        0 if !lines.is_empty() => {
            lines.remove(at);
        }
        1 if !lines.is_empty() => lines.insert(at, lines[at].clone()),
        2 if !lines.is_empty() => {
            let other = draw.below(lines.len());
            lines.swap(at, other);
        }
        3 if !lines.is_empty() => {
            let words = [
                "nan", "-inf", "1e400", "", "\"", "true", "[]", "-0.0", "1e-320", "[hoop]", "é",
                ",",
            ];
            let pieces: Vec<&str> = lines[at].split_inclusive(['=', ',']).collect();
            let which = draw.below(pieces.len());
            let word = draw.one_of(&words);
            let changed = pieces.iter().enumerate();
            let line: String = changed
                .map(|(i, piece)| if i == which { word } else { piece })
                .collect();
            lines[at] = line;
        }
        _ => {
            let mut bytes = text.as_bytes().to_vec();
            damage(draw, &mut bytes);
            return String::from_utf8_lossy(&bytes).into_owned();
        }
    }
    lines.join("\n")
}

/// All files under a folder.
pub(crate) fn tree(root: &Path) -> Tree {
    let mut files = Tree::new();
    let mut open = vec![root.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                open.push(path);
            } else {
                let name = path.strip_prefix(root).expect("inside").to_owned();
                files.insert(name, fs::read(&path).expect("a file"));
            }
        }
    }
    files
}

/// Writes files into a folder.
pub(crate) fn plant(tree: &Tree, root: &Path) {
    fs::create_dir_all(root).expect("a folder");
    for (path, bytes) in tree {
        let path = root.join(path);
        fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        fs::write(path, bytes).expect("written");
    }
}
