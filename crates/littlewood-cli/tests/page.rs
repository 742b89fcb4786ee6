//! The page that a person reads of a motion with impacts.

use crate::support::text;
use littlewood::cases::CASES;

/// The rows of the table of phases: between the line under its header and the next empty line.
fn rows(page: &str) -> Vec<&str> {
    page.lines()
        .skip_while(|line| !line.starts_with('─'))
        .skip(1)
        .take_while(|line| !line.is_empty())
        .collect()
}

fn words(row: &str) -> Vec<&str> {
    row.split_whitespace().collect()
}

#[test]
fn a_flight_has_a_row_and_its_impact_another() {
    let page = text(&["simulate", "lands-and-rolls"]);
    let rows = rows(&page);
    assert_eq!(rows.len(), 4, "{page}");
    assert_eq!(words(rows[1])[..2], ["2", "flight"]);
    assert!(rows[1].ends_with("landing"));
    assert_eq!(words(rows[2])[0], "impact");
    assert!(rows[2].ends_with("sticks in compression"), "{page}");
    assert_eq!(words(rows[3])[..2], ["3", "rolling"]);
    assert!(
        page.contains("\nLandings 1; the rim stays at the plane from τ = 2.81268 on\n"),
        "{page}"
    );
    assert!(
        page.contains(" lost in sliding, ") && page.contains(" lost in impacts\n"),
        "{page}"
    );
    assert!(page.contains("e = 0 (energetic)"), "{page}");
}

#[test]
fn many_bounces_share_a_row_unless_all_are_asked_for() {
    let page = text(&["simulate", "figure-3-bounces"]);
    let folded = rows(&page);
    let together: Vec<_> = folded
        .iter()
        .filter(|row| row.contains("bounces"))
        .collect();
    assert_eq!(together.len(), 1, "{page}");
    // Figure 3 has settled by then (the notes), and rolls from the next row on.
    assert!(together[0].ends_with("settles"), "{page}");
    let next = folded.last().expect("rolls");
    assert_eq!(words(next)[1..3], ["rolling", "6.92468"]);
    assert!(
        page.contains("the rim stays at the plane from τ = 6.92468 on"),
        "{page}"
    );

    let page = text(&["simulate", "figure-3-bounces", "--all-bounces"]);
    let all = rows(&page);
    let of = |name: &str| all.iter().filter(|row| words(row).contains(&name)).count();
    let landings = all.iter().filter(|row| row.ends_with("landing")).count();
    assert_eq!(of("impact"), landings, "{page}");
    assert_eq!(of("flight"), landings, "{page}");
    assert_eq!(of("bounces"), 1, "those without number");
    assert!(page.contains(&format!("\nLandings {landings}; ")), "{page}");
    // The row of many has the number of its first flight, the next that of the phase behind its
    // last.
    let first = words(together[0])[0]
        .strip_suffix('…')
        .expect("the first number")
        .parse::<usize>()
        .expect("a number");
    let count = words(next)[0].parse::<usize>().expect("a number") - first;
    assert_eq!(words(together[0])[1], count.to_string());
    assert_eq!(
        folded.len(),
        all.len() - (2 * (count - 1) + 1) + 1,
        "{page}"
    );
}

#[test]
fn a_long_motion_is_whole_if_all_is_asked_for() {
    let start = ["simulate", "bounces-forever", "--max-transitions", "500"];
    let page = text(&start);
    assert!(rows(&page).len() < 12, "{page}");
    assert!(
        page.contains("496 bounces") && page.contains("\nEnergy   none lost\n"),
        "{page}"
    );
    let page = text(&[&start[..], &["--all-bounces"]].concat());
    assert_eq!(rows(&page).len(), 1000);
    let slips =
        "simulate stick-slip-no-jump --mu-k 0.5 --max-transitions 100 --proof none --all-bounces";
    let page = text(&slips.split(' ').collect::<Vec<_>>());
    assert!(!page.contains('…'), "{page}");
    assert_eq!(rows(&page).len(), 100);
}

#[test]
fn a_jam_stands_before_the_phase_that_it_leads_to() {
    let page = text(&["simulate", "jam"]);
    let rows = rows(&page);
    assert_eq!(words(rows[0])[0], "jam");
    assert!(rows[0].ends_with("jams"), "{page}");
    assert_eq!(words(rows[1])[..3], ["1", "rolling", "0"]);
    // Every phase ends by its own event.
    let phases = rows
        .iter()
        .filter(|row| row.starts_with(|c: char| c.is_ascii_digit()));
    let ends: Vec<&str> = phases
        .filter_map(|row| words(row).last().copied())
        .collect();
    assert_eq!(
        ends,
        ["slip", "stick", "slip", "lift-off", "landing", "never"]
    );
}

/// A slide next to P = 0 that doubles do not resolve, without a word of the time limit, and the same
/// before that instant.
#[test]
fn a_phase_that_is_stopped_says_by_what() {
    let flags = "simulate --mass-ratio 0 --offset 0.7483 --inertia 0.001 --mu-s .9297 --mu-k .9297 --theta 2.48 \
                 --theta-rate 2.345 --slip 3.199 --until";
    for (until, end) in [("3", "unresolved"), ("0.09", "limit")] {
        let flags = flags.split_whitespace().chain([until]);
        let page = text(&flags.collect::<Vec<_>>());
        assert_eq!(words(rows(&page)[0]).last(), Some(&end), "{page}");
        let says_why = page.contains("it depends on") && page.contains("with rounding up to");
        assert_eq!(says_why, end == "unresolved", "{page}");
    }
}

#[test]
fn a_gain_by_newtons_law_is_told() {
    // Its friction changes in the impact, which closes and opens equally fast: J has the sign of
    // the slip that it ends.
    let flags = "simulate --mass-ratio 0.1 --offset 1 --inertia 0 --mu-s 1 --mu-k 0.5 --theta 3.5 --theta-rate 1 \
                 --slip 0.4 --gap-rate 1 --restitution 1 --restitution-law newton --until 1.5";
    let page = text(&flags.split_whitespace().collect::<Vec<_>>());
    assert!(
        page.contains("gained in impacts, as Newton's law allows"),
        "{page}"
    );
}

#[test]
fn pages_of_motions_with_impacts_fit_into_a_hundred_columns() {
    let names = CASES
        .iter()
        .filter(|case| case.setup.hoop.restitution.is_some())
        .map(|case| case.name);
    let mut pages: Vec<String> = names.map(|name| text(&["simulate", name])).collect();
    for restitution in ["0", "0.3", "0.9", "0.99"] {
        let flags = ["simulate", "figure-3", "--restitution", restitution];
        pages.push(text(&flags));
        pages.push(text(
            &[
                &flags[..],
                &["--radius-m", "0.45", "--particle-mass-kg", "0.14"],
            ]
            .concat(),
        ));
    }
    for page in pages {
        assert!(
            page.lines().all(|line| line.chars().count() <= 100),
            "{page}"
        );
    }
}

#[test]
fn titles_say_what_is_new() {
    let title = |flags: &[&str]| {
        let page = text(&[&["simulate"], flags].concat());
        page.lines().next().expect("a title").to_owned()
    };
    assert_eq!(
        title(&["figure-3", "--restitution", "0"]),
        "figure-3 with restitution"
    );
    assert_eq!(
        title(&[
            "figure-3",
            "--mu-k",
            "0.3",
            "--restitution",
            "0",
            "--restitution-law",
            "newton"
        ]),
        "figure-3 with another mu_k and with restitution, restitution_law"
    );
    assert_eq!(
        title(&["figure-3-bounces", "--restitution-law", "poisson"]),
        "figure-3-bounces with another restitution_law"
    );
}

#[test]
fn the_end_of_a_massless_hoop_says_why_there_is_no_impact() {
    let page = text(&["simulate", "figure-7"]);
    let words = page.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains("A rim without mass cannot be struck."),
        "{page}"
    );
}
