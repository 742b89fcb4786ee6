//! Motions by the number of their landings: counts as a map holds them, and the classes in which it shows them.

/// Number of colours that a map has for them.
pub const CLASSES: usize = 9;

/// Code of a start that has not been computed.
pub(crate) const NOT_COMPUTED: u8 = u8::MAX;

/// The count of landings as a map holds it; there are no more within the transitions that it follows.
pub(crate) fn code(landings: u32) -> u8 {
    u8::try_from(landings).unwrap_or(NOT_COMPUTED - 1).min(NOT_COMPUTED - 1)
}

/// The classes of some counts, by how often each occurs: the least and the largest count of each class. Every count is a class
/// as long as there are enough; else classes of about equal size follow that of the motions that do not land.
pub(crate) fn classes(frequencies: &[usize; 256]) -> Vec<[u8; 2]> {
    let counts: Vec<(u8, usize)> = (0..NOT_COMPUTED)
        .zip(frequencies)
        .map(|(count, often)| (count, *often))
        .filter(|it| it.1 > 0)
        .collect();
    let single = |(count, _): &(u8, usize)| [*count, *count];
    if counts.len() <= CLASSES {
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
        let left = CLASSES - classes.len();
        // A class is full with its share of what it and those after it have, or where each count that is left can have one.
        if left > 0 && (size * (left + 1) >= rest || counts.len() - place - 1 <= left) {
            rest -= size;
            size = 0;
        }
    }
    classes
}

#[cfg(test)]
mod tests {
    use super::{CLASSES, NOT_COMPUTED, classes, code};

    fn frequencies(of: impl IntoIterator<Item = (u8, usize)>) -> [usize; 256] {
        let mut frequencies = [0; 256];
        of.into_iter().for_each(|(count, often)| frequencies[usize::from(count)] = often);
        frequencies
    }

    #[test]
    fn a_count_is_kept_as_far_as_a_map_holds_it() {
        assert_eq!([0, 1, 200, 254, 255, u32::MAX].map(code), [0, 1, 200, 254, 254, 254]);
        assert!(code(u32::MAX) < NOT_COMPUTED);
    }

    #[test]
    fn few_counts_are_a_class_each() {
        let few = frequencies([(0, 900), (1, 5), (4, 1), (30, 7), (NOT_COMPUTED, 3)]);
        assert_eq!(classes(&few), [[0, 0], [1, 1], [4, 4], [30, 30]]);
        assert!(classes(&frequencies([])).is_empty());
    }

    #[test]
    fn many_counts_are_in_classes_of_about_equal_size() {
        let even = classes(&frequencies((0..=80).map(|count| (count, if count == 0 { 5000 } else { 10 }))));
        assert_eq!(even.len(), CLASSES);
        assert_eq!(even[0], [0, 0]);
        for (i, class) in even[1..].iter().enumerate() {
            let least = 1 + 10 * i as u8;
            assert_eq!(*class, [least, least + 9]);
        }
        // One count that nearly all have is a class of its own, and no count is in two.
        let uneven =
            classes(&frequencies((1..=40).map(|count| (count, if count == 26 { 90_000 } else { 11 }))));
        assert_eq!(uneven.len(), CLASSES);
        assert!(uneven.windows(2).all(|pair| pair[0][0] <= pair[0][1] && pair[0][1] + 1 == pair[1][0]));
        assert_eq!((uneven[0][0], uneven[CLASSES - 1][1]), (1, 40));
    }
}
