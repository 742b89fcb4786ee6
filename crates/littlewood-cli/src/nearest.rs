//! The names that look most like one that was typed.

/// Names less alike are not worth a suggestion.
const LEAST_LIKENESS: f64 = 0.75;

const SUGGESTIONS: usize = 3;

/// `did you mean 'figure-3'? ` if some of the known names look like the one that was typed, and
/// where all stand.
pub(crate) fn hint<'a>(name: &str, known: impl IntoIterator<Item = &'a str>, all: &str) -> String {
    let plain = |name: &str| name.to_lowercase().replace([' ', '_'], "-");
    let wanted = plain(name);
    let likeness = |known: &str| {
        let known = plain(known);
        // "3b" is figure-3b.
        let is_its_end = !wanted.is_empty() && known.ends_with(&wanted);
        if is_its_end {
            1.0
        } else {
            strsim::jaro_winkler(&wanted, &known)
        }
    };
    let mut ranked: Vec<(f64, &str)> = known
        .into_iter()
        .map(|known| (likeness(known), known))
        .filter(|(likeness, _)| *likeness > LEAST_LIKENESS)
        .collect();
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
    let names: Vec<String> = ranked
        .iter()
        .take(SUGGESTIONS)
        .map(|(_, name)| format!("'{name}'"))
        .collect();
    if names.is_empty() {
        all.to_owned()
    } else {
        format!("did you mean {}? {all}", names.join(" or "))
    }
}

#[cfg(test)]
mod tests {
    use super::hint;

    #[test]
    fn the_most_alike_come_first() {
        let known = ["mass_ratio", "offset", "inertia", "mu_s", "mu_k"];
        assert_eq!(
            hint("mass-ration", known, "all"),
            "did you mean 'mass_ratio'? all"
        );
        assert_eq!(hint("k", known, "all"), "did you mean 'mu_k'? all");
        assert_eq!(hint("zzz", known, "all"), "all");
        assert_eq!(hint("", known, "all"), "all");
    }
}
