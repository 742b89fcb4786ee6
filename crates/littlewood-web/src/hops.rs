//! Motions by the number of their landings: counts as a map holds them, and the classes in which it
//! shows them.

#[cfg(feature = "first")]
use wasm_bindgen::prelude::wasm_bindgen;

/// Number of colours that a map has for numbers of landings.
#[cfg(feature = "first")]
pub const HOP_CLASSES: usize = 9;

/// Code of a start that has not been computed.
pub(crate) const NOT_COMPUTED: u8 = u8::MAX;

/// The count of landings as a map holds it; there are no more within the transitions that it
/// follows.
#[cfg(feature = "later")]
pub(crate) fn code(landings: u32) -> u8 {
    u8::try_from(landings)
        .unwrap_or(NOT_COMPUTED - 1)
        .min(NOT_COMPUTED - 1)
}

/// The classes of the numbers of landings of a map: the least and the largest number of each, in
/// turn.
#[cfg(feature = "first")]
#[wasm_bindgen(js_name = hopClasses)]
pub fn hop_classes(codes: &[u8]) -> Vec<u8> {
    let mut frequencies = [0; 256];
    for code in codes {
        frequencies[usize::from(*code)] += 1;
    }
    classes(&frequencies).concat()
}

/// The classes of some counts, by how often each occurs: the least and the largest count of each
/// class. Every count is a class as long as there are enough; else classes of about equal size
/// follow that of the motions that do not land.
#[cfg(feature = "first")]
fn classes(frequencies: &[usize; 256]) -> Vec<[u8; 2]> {
    let counts: Vec<(u8, usize)> = (0..NOT_COMPUTED)
        .zip(frequencies)
        .map(|(count, often)| (count, *often))
        .filter(|it| it.1 > 0)
        .collect();
    let single = |(count, _): &(u8, usize)| [*count, *count];
    if counts.len() <= HOP_CLASSES {
        return counts.iter().map(single).collect();
    }
    let landing = usize::from(counts[0].0 == 0);
    let mut classes: Vec<[u8; 2]> = counts[..landing].iter().map(single).collect();
    let mut rest: usize = counts[landing..].iter().map(|it| it.1).sum();
    let mut size = 0;
    for (place, (count, often)) in counts.iter().enumerate().skip(landing) {
        match classes.last_mut().filter(|_| size > 0) {
            Some(class) => class[1] = *count,
            None => classes.push([*count, *count]),
        }
        size += often;
        let left = HOP_CLASSES - classes.len();
        // A class is full with its share of what it and those after it have, or where each count
        // that is left can have one.
        if left > 0 && (size * (left + 1) >= rest || counts.len() - place - 1 <= left) {
            rest -= size;
            size = 0;
        }
    }
    classes
}
