//! The core is a house: a room uses what stands on its own floor and on floors below.

use std::fs;
use std::path::Path;

const FLOORS: [&str; 7] = [
    "math",
    "model",
    "mechanics",
    "modes",
    "walk",
    "motion",
    "engine",
];

/// The rooms that the sources in a folder use, each with the file; unit tests use any.
fn used(folder: &Path, found: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).expect("a folder of the core") {
        let path = entry.expect("an entry of a folder").path();
        if path.is_dir() {
            used(&path, found);
            continue;
        }
        let text = fs::read_to_string(&path).expect("a text in UTF-8");
        let code = text
            .split("#[cfg(test)]\nmod tests")
            .next()
            .unwrap_or_default();
        for line in code
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"))
        {
            for (place, before) in line.match_indices("crate::") {
                let room = line[place + before.len()..]
                    .split(|letter: char| !letter.is_alphanumeric())
                    .next();
                found.push((
                    path.display().to_string(),
                    room.unwrap_or_default().to_owned(),
                ));
            }
        }
    }
}

#[test]
fn no_room_uses_a_higher_one() {
    let mut seen = 0;
    for (floor, room) in FLOORS.iter().enumerate() {
        let mut found = Vec::new();
        used(
            &Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(room),
            &mut found,
        );
        for (file, other) in found {
            let below = FLOORS.iter().position(|name| *name == other);
            assert!(
                below.is_none_or(|below| below <= floor),
                "{file} uses crate::{other}"
            );
            seen += usize::from(below.is_some());
        }
    }
    assert!(seen > 100, "{seen}");
}
