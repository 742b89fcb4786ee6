//! Classes of motions by the number of their landings.

/// The least number of landings of each class. The last has no end.
const LEAST: [u32; 9] = [0, 1, 2, 3, 4, 6, 11, 21, 51];

/// Number of classes.
pub const CLASSES: usize = LEAST.len();

/// Code of a start that has not been computed.
pub(crate) const NOT_COMPUTED: u8 = LEAST.len() as u8;

/// Code of the class of a motion with so many landings.
pub(crate) fn code(landings: u32) -> u8 {
    (LEAST.partition_point(|least| *least <= landings) - 1) as u8
}

/// What a class is called.
#[must_use]
pub fn labels() -> [String; CLASSES] {
    core::array::from_fn(|class| {
        let least = LEAST[class];
        match LEAST.get(class + 1) {
            None => format!("{least} or more"),
            Some(_) if least == 0 => "no landing".to_owned(),
            Some(_) if least == 1 => "1 landing".to_owned(),
            Some(next) if *next == least + 1 => least.to_string(),
            Some(next) => format!("{least}–{}", next - 1),
        }
    })
}

#[cfg(test)]
mod tests {
    use super::{CLASSES, code, labels};

    #[test]
    fn every_number_of_landings_has_the_class_that_its_label_names() {
        let labels = labels();
        let named = |landings: u32| labels[usize::from(code(landings))].as_str();
        for (landings, label) in [
            (0, "no landing"),
            (1, "1 landing"),
            (3, "3"),
            (4, "4–5"),
            (5, "4–5"),
            (20, "11–20"),
            (21, "21–50"),
            (50, "21–50"),
            (51, "51 or more"),
            (u32::MAX, "51 or more"),
        ] {
            assert_eq!(named(landings), label);
        }
        assert_eq!(usize::from(code(u32::MAX)), CLASSES - 1);
    }
}
