//! The poster: nothing is left blank, whatever the hoop.

use littlewood::cases::find_case;
use littlewood::{Hoop, HoopParameters, Limits, Start};
use littlewood_figures::{Figure, FigureInput, POSTER_MM, poster};

fn made(parameters: HoopParameters, start: Start) -> Figure {
    let hoop = Hoop::new(parameters).expect("a hoop");
    let input = FigureInput::new(hoop, start, Limits::default());
    poster(&input, &mut |_, _| {}).expect("a poster")
}

/// The texts of the page itself.
fn texts(page: &Figure) -> Vec<&str> {
    let own = page
        .panels
        .iter()
        .find(|panel| panel.name == "page")
        .expect("the page");
    own.labels.iter().map(|label| &*label.text).collect()
}

#[test]
fn a_poster_has_the_proportions_of_a3_and_says_what_happens() {
    let case = find_case("figure-3").expect("a named case");
    let page = made(case.setup.hoop, case.setup.start);
    assert!((page.height / page.width - POSTER_MM[1] / POSTER_MM[0]).abs() < 1e-12);
    let texts = texts(&page);
    for said in [
        "*θ*(0) = π/2",
        "it slides, rolls and jumps by itself.",
        "sliding, rolling, sliding, flight",
        "Lift-off",
    ] {
        assert!(texts.iter().any(|text| text.contains(said)), "{said}");
    }
    let svg = page.svg();
    assert!(
        svg[..600].contains("width=\"420mm\" height=\"297mm\""),
        "{}",
        &svg[..600]
    );
    // 420 mm are 1190.55 points.
    let pdf = page.pdf();
    let text = String::from_utf8_lossy(&pdf);
    let (_, sides) = text.split_once("/MediaBox").expect("a page");
    let sides: String = sides.chars().take(40).collect();
    assert!(sides.contains("1190.") && sides.contains("841."), "{sides}");
}

#[test]
fn phases_of_a_mode_after_each_other_are_said_once() {
    let said = |case: &str| {
        let setup = find_case(case).expect("a named case").setup;
        let page = made(setup.hoop, setup.start);
        let story = texts(&page)
            .into_iter()
            .find(|text| text.contains("Then: "));
        story.expect("the story").to_owned()
    };
    let glides = said("figure-7");
    assert!(
        glides.contains("Then: rolling, gliding (2 times); in the end"),
        "{glides}"
    );
    let bounces = said("figure-3-bounces");
    assert!(!bounces.contains("flight, flight"), "{bounces}");
}

#[test]
fn what_does_not_apply_is_replaced() {
    let at = Start::at;
    for (name, parameters, start) in [
        (
            "Littlewood's hoop",
            HoopParameters::thin(0.0).with_friction(0.5, 0.4),
            at(0.0, 0.5),
        ),
        (
            "massless inside",
            HoopParameters::thin(0.0)
                .with_offset(0.6)
                .with_friction(0.5, 0.4),
            at(1.0, 0.5),
        ),
        (
            "not loaded",
            HoopParameters::thin(1.0)
                .with_offset(0.0)
                .with_friction(0.5, 0.4),
            at(1.0, 2.0),
        ),
        (
            "without friction",
            HoopParameters::thin(1.0).with_friction(0.0, 0.0),
            at(1.0, 1.0),
        ),
        (
            "leaves at once",
            HoopParameters::thin(1.0).with_friction(0.5, 0.4),
            at(0.0, 4.0),
        ),
        (
            "heavy",
            HoopParameters::thin(1000.0).with_friction(0.5, 0.4),
            at(1.0, 1.0),
        ),
    ] {
        let page = made(parameters, start);
        // Each of the six first places has a picture of its own, or a sentence.
        let pictures = page
            .panels
            .iter()
            .filter(|panel| panel.name != "page")
            .count();
        let reasons = texts(&page)
            .into_iter()
            .filter(|text| {
                text.starts_with("No figure of ") || text.starts_with("No other figure ")
            })
            .count();
        assert!(
            pictures + reasons >= 6,
            "{name}: {pictures} pictures, {reasons} reasons"
        );
        assert!(pictures >= 2, "{name}: {pictures}");
        // The largest of all is the hoop in equal times.
        let area = |panel: &littlewood_draw::Panel| panel.frame.width * panel.frame.height;
        let largest = page
            .panels
            .iter()
            .filter(|panel| panel.name != "page")
            .max_by(|a, b| area(a).total_cmp(&area(b)));
        let largest = largest.expect("a picture").name;
        assert_eq!(largest, "plane of motion", "{name}");
        for panel in &page.panels {
            let littlewood_draw::PanelFrame {
                left,
                top,
                width,
                height,
            } = panel.frame;
            assert!(
                left >= 0.0 && top >= 0.0,
                "{name}: {} {:?}",
                panel.name,
                panel.frame
            );
            assert!(
                left + width <= page.width + 1e-9 && top + height <= page.height + 1e-9,
                "{name}: {}",
                panel.name
            );
        }
        assert!(page.svg().len() > 20_000, "{name}");
    }
}
