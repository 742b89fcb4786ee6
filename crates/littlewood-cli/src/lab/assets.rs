//! The files of the page, in the program itself.

/// The page as `build.rs` has found it, name and content; nothing where it was not built before the program.
const FILES: &[(&str, &[u8])] = &include!(concat!(env!("OUT_DIR"), "/page.rs"));

/// Media types by the ending of a name, as IANA lists them. The page has no others, which a test shows.
const MEDIA_TYPES: [(&str, &str); 6] = [
    (".html", "text/html; charset=utf-8"),
    (".js", "text/javascript; charset=utf-8"),
    (".css", "text/css; charset=utf-8"),
    (".wasm", "application/wasm"),
    (".svg", "image/svg+xml"),
    (".webmanifest", "application/manifest+json"),
];

/// A file of the page.
#[derive(Clone, Debug)]
pub(super) struct Asset {
    pub(super) content: &'static [u8],
    /// Media type.
    pub(super) kind: &'static str,
}

/// The file of this name.
pub(super) fn find(name: &str) -> Option<Asset> {
    let (_, content) = FILES.iter().find(|(known, _)| *known == name)?;
    Some(Asset { content, kind: media_type(name) })
}

fn media_type(name: &str) -> &'static str {
    MEDIA_TYPES
        .iter()
        .find(|(ending, _)| name.ends_with(ending))
        .map_or("application/octet-stream", |(_, kind)| kind)
}

#[cfg(test)]
mod tests {
    use super::{FILES, MEDIA_TYPES};

    #[test]
    fn every_file_of_the_page_has_a_media_type() {
        for (name, _) in FILES {
            assert!(MEDIA_TYPES.iter().any(|(ending, _)| name.ends_with(ending)), "{name}");
        }
    }
}
