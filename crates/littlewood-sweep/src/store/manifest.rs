//! Which chunks of a store are finished, the checksums of their files, and how many points of each
//! class they hold.

use core::fmt::Write as _;
use std::collections::BTreeMap;

use crate::description::STORE_FORMAT;
use crate::tally::Tally;

/// Length and checksum of the files of a chunk, taken together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Checksum {
    pub(crate) length: u64,
    pub(crate) crc: u32,
}

impl Checksum {
    pub(crate) fn of<'a>(files: impl IntoIterator<Item = &'a [u8]>) -> Self {
        let mut hasher = crc32fast::Hasher::new();
        let mut length = 0;
        for bytes in files {
            hasher.update(bytes);
            length += bytes.len() as u64;
        }
        Self {
            length,
            crc: hasher.finalize(),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ManifestChunk {
    pub(crate) checksum: Checksum,
    /// Its points, class by class: so that the counts of a store are known without reading it.
    pub(crate) tally: Tally,
}

/// The finished chunks of a run: a line of text each, added as the chunk is finished. A later line
/// of the same chunk replaces it. The first line has the version of the format.
///
/// ```text
/// littlewood-sweep 3 run 5f3759df
/// 0 24681 1b2c3d4e leaves_at_once=52,rolls_forever=25
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Manifest {
    /// CRC-32 of the description of the run.
    pub(crate) run: u32,
    pub(crate) chunks: BTreeMap<usize, ManifestChunk>,
}

impl Manifest {
    pub(crate) const fn new(run: u32) -> Self {
        Self {
            run,
            chunks: BTreeMap::new(),
        }
    }

    pub(crate) fn head(&self) -> String {
        format!("littlewood-sweep {STORE_FORMAT} run {:08x}\n", self.run)
    }

    pub(crate) fn line(number: usize, entry: &ManifestChunk) -> String {
        let ManifestChunk { checksum, tally } = entry;
        let counts: Vec<String> = tally
            .iter()
            .map(|(class, count)| format!("{class}={count}"))
            .collect();
        format!(
            "{number} {} {:08x} {}\n",
            checksum.length,
            checksum.crc,
            counts.join(",")
        )
    }

    pub(crate) fn text(&self) -> String {
        let mut text = self.head();
        for (&number, entry) in &self.chunks {
            let _ = write!(text, "{}", Self::line(number, entry));
        }
        text
    }

    /// Reads it again. A last line without its end was cut off by a kill, and its chunk does not
    /// count.
    ///
    /// # Errors
    /// The number of a line that cannot be understood, from 1.
    pub(crate) fn parse(text: &[u8], run: u32, count: usize) -> Result<Self, usize> {
        let mut manifest = Self::new(run);
        let mut lines = text.split_inclusive(|&byte| byte == b'\n');
        match lines.next() {
            None => return Ok(manifest),
            Some(head) if head == manifest.head().as_bytes() => {}
            Some(head)
                if !head.ends_with(b"\n") && manifest.head().as_bytes().starts_with(head) =>
            {
                return Ok(manifest);
            }
            Some(_) => return Err(1),
        }
        for (number, line) in (2_usize..).zip(lines) {
            let Some(line) = line.strip_suffix(b"\n") else {
                break;
            };
            let (chunk, entry) = entry(line)
                .filter(|(chunk, _)| *chunk < count)
                .ok_or(number)?;
            manifest.chunks.insert(chunk, entry);
        }
        Ok(manifest)
    }
}

fn entry(line: &[u8]) -> Option<(usize, ManifestChunk)> {
    let mut words = core::str::from_utf8(line).ok()?.split(' ');
    let chunk = words.next()?.parse().ok()?;
    let length = words.next()?.parse().ok()?;
    let crc = words.next().filter(|crc| crc.len() == 8)?;
    let crc = u32::from_str_radix(crc, 16).ok()?;
    let mut tally = Tally::default();
    for count in words.next()?.split(',') {
        let (class, count) = count.split_once('=')?;
        tally.add(class.parse().ok()?, count.parse().ok()?);
    }
    words.next().is_none().then_some((
        chunk,
        ManifestChunk {
            checksum: Checksum { length, crc },
            tally,
        },
    ))
}

#[cfg(test)]
mod tests {
    use littlewood::tables::Class;

    use super::*;

    fn example() -> Manifest {
        let mut manifest = Manifest::new(0x5f37_59df);
        let mut tally = Tally::default();
        tally.add(Class::LeavesAtOnce, 52);
        manifest.chunks.insert(
            0,
            ManifestChunk {
                checksum: Checksum {
                    length: 24_681,
                    crc: 0x1b2c,
                },
                tally,
            },
        );
        tally.add(Class::RollsForever, 25);
        manifest.chunks.insert(
            7,
            ManifestChunk {
                checksum: Checksum {
                    length: 9,
                    crc: 0xffff_ffff,
                },
                tally,
            },
        );
        manifest
    }

    #[test]
    fn reads_what_it_writes() {
        let manifest = example();
        assert_eq!(
            manifest.text(),
            format!(
                "littlewood-sweep {STORE_FORMAT} run 5f3759df\n0 24681 00001b2c leaves_at_once=52\n7 9 ffffffff \
                 leaves_at_once=52,rolls_forever=25\n"
            )
        );
        assert_eq!(
            Manifest::parse(manifest.text().as_bytes(), manifest.run, 8),
            Ok(manifest)
        );
    }

    #[test]
    fn a_cut_end_at_any_byte_loses_only_the_last_chunk() {
        let manifest = example();
        let text = manifest.text();
        for length in 0..text.len() {
            let parsed = Manifest::parse(&text.as_bytes()[..length], manifest.run, 8);
            let whole_lines = text[..length].matches('\n').count();
            assert_eq!(
                parsed.map(|parsed| parsed.chunks.len()),
                Ok(whole_lines.saturating_sub(1))
            );
        }
    }

    #[test]
    fn damage_is_found_and_its_line_named() {
        let parse = |text: &str| Manifest::parse(text.as_bytes(), 0x5f37_59df, 8).map(|_| ());
        let head = format!("littlewood-sweep {STORE_FORMAT} run 5f3759df\n");
        assert_eq!(parse(&head.replace("df\n", "de\n")), Err(1));
        assert_eq!(parse("something else\n"), Err(1));
        let good = "1 1 00000000 painleve=1";
        assert_eq!(parse(&format!("{head}{good}\n")), Ok(()));
        for bad in [
            "x 1 00000000 painleve=1",
            "8 1 00000000 painleve=1",
            "0 1 0 painleve=1",
            "0 1 00000000",
            "0 1 00000000 2",
            "0 1 00000000 happy=2",
            "0 1 00000000 painleve=1 2",
            "0 1",
            "",
            "0 -1 00000000 painleve=1",
        ] {
            assert_eq!(parse(&format!("{head}{good}\n{bad}\n")), Err(3), "{bad}");
        }
    }
}
