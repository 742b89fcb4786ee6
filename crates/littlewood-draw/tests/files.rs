use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// The files that each file uses; unit tests use any.
fn used() -> BTreeMap<String, BTreeSet<String>> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let entries = fs::read_dir(source).expect("the sources");
    let files = entries.map(|entry| {
        let path = entry.expect("an entry of a folder").path();
        let name = path.file_stem().expect("a name").to_string_lossy();
        let text = fs::read_to_string(&path).expect("a text in UTF-8");
        let code = text.split("#[cfg(test)]\nmod tests").next();
        let lines = code.unwrap_or_default().lines();
        let code = lines.filter(|line| !line.trim_start().starts_with("//"));
        let others = code.flat_map(|line| line.split("crate::").skip(1));
        let names = others.map(|rest| {
            let end = rest.find(|letter: char| !letter.is_alphanumeric());
            rest[..end.unwrap_or(rest.len())].to_owned()
        });
        (name.into_owned(), names.collect())
    });
    files.collect()
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let mut files = used();
    assert!(files.len() > 20 && files["svg"].contains("figure"));
    while !files.is_empty() {
        let names: BTreeSet<String> = files.keys().cloned().collect();
        // What uses nothing that is left stands lowest.
        files.retain(|_, others| !others.is_disjoint(&names));
        assert!(files.len() < names.len(), "a circle in {names:?}");
    }
}
