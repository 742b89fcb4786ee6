//! Links: what is written is read back to the last bit, and whatever else stands in one is refused
//! or means something.

use littlewood::cases::CASES;
use littlewood::si::SiSetup;
use littlewood::tables::{Quantity, Setup};
use littlewood::{Hoop, RestitutionLaw};
use littlewood_random::Draw;
use littlewood_report::link::{Link, Problem, VIEW};

fn bits(problem: &Problem) -> Vec<(Quantity, Option<u64>)> {
    problem
        .values
        .iter()
        .map(|(quantity, value)| (*quantity, value.map(f64::to_bits)))
        .collect()
}

fn link(draw: &mut Draw) -> Link {
    let mut problem = Problem::of_setup(&draw.setup(), None);
    problem.is_si = draw.comes(0.5);
    if problem.is_si {
        problem.values = Problem::quantities(true)
            .map(|quantity| (quantity, Some(draw.allowed(quantity))))
            .collect();
    }
    for (quantity, value) in &mut problem.values {
        if matches!(
            quantity,
            Quantity::Restitution | Quantity::Until | Quantity::UntilS
        ) {
            *value = draw.comes(0.5).then(|| draw.allowed(*quantity));
        }
    }
    problem.law = problem
        .get(Quantity::Restitution)
        .map(|_| draw.one_of(&RestitutionLaw::ALL));
    let at = draw.comes(0.5).then(|| draw.allowed(Quantity::Time));
    Link {
        problem,
        at,
        view: VIEW.map(|(_, choices, _)| draw.one_of(choices)),
    }
}

#[test]
fn what_is_written_is_read_to_the_last_bit() {
    for number in 0..4000 {
        let mut draw = Draw::of_case(2019, 34, number);
        let (link, shown) = (link(&mut draw), link(&mut draw));
        let text = link.to_string();
        let mut wanted = link.clone();
        if wanted.view[VIEW.len() - 1] == VIEW[VIEW.len() - 1].2 {
            // The theme is that of the reader, unless the link has another.
            wanted.view[VIEW.len() - 1] = shown.view[VIEW.len() - 1];
        }
        let read = Link::read(&format!("#{text}"), &shown.to_string());
        assert_eq!(read.refusals, [], "{text}");
        assert!(read.has_problem, "{text}");
        assert_eq!(bits(&read.link.problem), bits(&wanted.problem), "{text}");
        assert_eq!(
            read.link.at.map(f64::to_bits),
            wanted.at.map(f64::to_bits),
            "{text}"
        );
        assert_eq!(
            (read.link.problem.law, read.link.view),
            (wanted.problem.law, wanted.view),
            "{text}"
        );
    }
}

#[test]
fn a_case_is_written_by_its_name_and_read_with_what_differs() {
    for case in CASES {
        let problem = Problem::of_setup(&case.setup, None);
        assert_eq!(
            Link::of(problem.clone()).to_string(),
            format!("case={}", case.name)
        );
        let read = Link::read(&format!("case={}&mu_k=0.0625&x=3&until=30", case.name), "")
            .link
            .problem;
        let mut wanted = problem.clone();
        for (quantity, value) in &mut wanted.values {
            match quantity {
                Quantity::MuK => *value = Some(0.0625),
                Quantity::X => *value = Some(3.0),
                Quantity::Until => *value = Some(30.0),
                _ => {}
            }
        }
        assert_eq!(read, wanted);
    }
    assert_eq!(
        Link::read("case=libration", "").link.to_string(),
        "case=figure-2-libration"
    );
}

#[test]
fn no_link_is_too_strange() {
    const VALUES: [&str; 30] = [
        "0",
        "-0",
        "1",
        "0.4",
        "1e9",
        "5e-324",
        "1e400",
        "-1e400",
        "nan",
        "Infinity",
        "",
        " 2 ",
        "−1",
        "0x10",
        "1_0",
        "+.5",
        "1.",
        ".",
        "e5",
        "figure-3",
        "newton",
        "hops",
        "light",
        "%",
        "%zz",
        "%2D1",
        "%F0%9F",
        "1=2",
        "💥",
        "__proto__",
    ];
    let keys: Vec<&str> = Quantity::ALL
        .iter()
        .map(|quantity| quantity.name())
        .chain(VIEW.iter().map(|(key, ..)| *key))
        .chain(["case", "restitution_law", "at", ""])
        .collect();
    for number in 0..20_000 {
        let mut draw = Draw::of_case(2019, 35, number);
        let parts: Vec<String> = (0..draw.below(12))
            .map(|_| format!("{}={}", draw.one_of(&keys), draw.one_of(&VALUES)))
            .collect();
        let mut text: Vec<char> = parts
            .join(draw.one_of(&["&", "&", "&", "&&", ";"]))
            .chars()
            .collect();
        while draw.comes(0.3) {
            let at = draw.below(text.len() + 1);
            text.insert(
                at,
                char::from_u32(draw.below(0x11_0000) as u32).unwrap_or('%'),
            );
        }
        let text: String = text.into_iter().collect();
        let read = Link::read(&text, "");
        assert!(
            read.refusals
                .iter()
                .all(|refusal| !refusal.reason.is_empty()),
            "{text}"
        );
        for (quantity, value) in &read.link.problem.values {
            // What is missing is optional, or has been refused.
            let is_refused = read
                .refusals
                .iter()
                .any(|refusal| refusal.key == quantity.name());
            let is_optional = matches!(
                quantity,
                Quantity::Restitution | Quantity::Until | Quantity::UntilS
            );
            assert!(
                value.map_or(is_refused || is_optional, f64::is_finite),
                "{text}: {quantity}"
            );
        }
        // A law alone has no meaning, which only the hoop says.
        let has_sense = read.link.problem.law.is_none()
            || read.link.problem.get(Quantity::Restitution).is_some();
        if read.refusals.is_empty() && has_sense {
            let again = Link::read(&read.link.to_string(), "");
            assert_eq!(
                bits(&again.link.problem),
                bits(&read.link.problem),
                "{text}"
            );
            assert_eq!(again.link.to_string(), read.link.to_string(), "{text}");
        }
    }
}

#[test]
fn what_has_no_meaning_is_refused_with_its_key() {
    for (link, key, text, reason) in [
        (
            "case=no-such-case",
            "case",
            "no-such-case",
            "there is no case named 'no-such-case'",
        ),
        (
            "case=figure-3&colour=red",
            "colour",
            "red",
            "this key is not known",
        ),
        (
            "theta=nonsense",
            "theta",
            "nonsense",
            "'nonsense' is not a number",
        ),
        ("theta=1e400", "theta", "1e400", "'1e400' is not a number"),
        ("theta=１", "theta", "１", "'１' is not a number"),
        ("mu_s=%F0%9F", "mu_s", "%F0%9F", "'%F0%9F' is not a number"),
        ("at=soon", "at", "soon", "'soon' is not a number"),
        (
            "rate=5",
            "rate",
            "5",
            "one of 1, 1.5, 2, 3, 4, 6, 8, 12, 20",
        ),
        ("loop=yes", "loop", "yes", "one of 0, 1"),
        (
            "restitution_law=hooke&restitution=1",
            "restitution_law",
            "hooke",
            "one of energetic, poisson, newton",
        ),
        (
            "radius_m=0.3&case=figure-3",
            "disc_mass_kg",
            "",
            "the link does not give it",
        ),
    ] {
        let refusals = Link::read(link, "").refusals;
        let found = refusals
            .first()
            .map(|it| (it.key.as_str(), it.text.as_str(), it.reason.as_str()));
        assert_eq!(found, Some((key, text, reason)), "{link}");
    }
    let mixed = Link::read("radius_m=0.3&slip=1", "").refusals;
    assert!(
        mixed
            .iter()
            .any(|it| it.key == "slip" && it.reason.contains("not in SI units"))
    );
    // The motion that the page compares with is another link.
    let pinned = Link::read("pin=case%3Dfigure-7%26mu_s%3D2&case=two-hops", "");
    assert!(pinned.refusals.is_empty() && pinned.link.to_string() == "case=two-hops");
    // What a link does not say of the page is as it is at first; numbers may be written otherwise.
    assert_eq!(
        Link::read("rate=4.0&speed=.25&shows=hops", "")
            .link
            .to_string(),
        "case=figure-3&speed=0.25&shows=hops"
    );
}

#[test]
fn a_link_in_si_units_has_the_setup_of_its_values() {
    let text = "disc_mass_kg=0.4&particle_mass_kg=0.14&radius_m=0.45&offset_m=0.45&inertia_kg_m2=0.081&mu_s=0.5\
                &mu_k=0.4&theta=1.2&theta_rate_rad_per_s=11&until_s=2";
    let (setup, units, until) = Link::read(text, "").link.problem.to_setup().unwrap();
    let units = units.unwrap();
    let si = SiSetup::new(
        &Setup::new(Hoop::new(setup.hoop).unwrap().parameters(), setup.start),
        &units,
    );
    for (quantity, wanted) in [
        (Quantity::DiscMassKg, 0.4),
        (Quantity::OffsetM, 0.45),
        (Quantity::ThetaRateRadPerS, 11.0),
    ] {
        let found = si.get(quantity).unwrap();
        assert!(
            (found - wanted).abs() < 1e-15 * wanted,
            "{quantity} = {found}"
        );
    }
    assert!((until.unwrap() * units.time_s - 2.0).abs() < 1e-15);
}
