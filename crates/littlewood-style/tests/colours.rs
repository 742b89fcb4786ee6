//! The colours are told apart: by hue, in grey, and on the paper they stand on.

use std::collections::BTreeSet;

use littlewood::Mode;
use littlewood::tables::Class;
use littlewood::theory::{BodyClass, EDGES};
use littlewood_style::{
    Accent, Arrow, Curve, EnergyPart, ImpulseLine, Ink, RANKS, Rgb, Swatch, Theme, dash_of,
    of_class, of_fraction, of_mode, of_rank, swatches,
};

/// Distance in the CIE L*a*b* space; about 2 can just be seen.
fn distance(a: Rgb, b: Rgb) -> f64 {
    let [a, b] = [a, b].map(lab);
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b) * (a - b))
        .sum::<f64>()
        .sqrt()
}

fn lab(colour: Rgb) -> [f64; 3] {
    let [r, g, b] = colour.0.map(|value| {
        let value = f64::from(value) / 255.0;
        if value <= 0.040_45 {
            value / 12.92
        } else {
            libm::pow((value + 0.055) / 1.055, 2.4)
        }
    });
    let bent = |t: f64| {
        if t > 0.008_856 {
            libm::cbrt(t)
        } else {
            7.787 * t + 16.0 / 116.0
        }
    };
    let x = bent((0.412_456_4 * r + 0.357_576_1 * g + 0.180_437_5 * b) / 0.950_47);
    let y = bent(0.212_672_9 * r + 0.715_152_2 * g + 0.072_175_0 * b);
    let z = bent((0.019_333_9 * r + 0.119_192 * g + 0.950_304_1 * b) / 1.088_83);
    [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
}

/// Whether two classes can be found in one map of a kind of hoop. One with rolling resistance rests
/// where one without it rolls, slips or repeats itself for ever. A hoop with inertia may leave the
/// plane and may be faster than the clock; with friction it may slip for ever or meet P ≤ 0, and
/// without it repeats itself. The particle of a massless one comes to the plane, or to the bottom
/// if it is inside the rim.
fn meet(a: Class, b: Class) -> bool {
    const HEAVY: [Class; 7] = [
        Class::LeavesAtOnce,
        Class::LiftsOffLater,
        Class::RollsForever,
        Class::SlipsForever,
        Class::InContact,
        Class::Painleve,
        Class::Unresolved,
    ];
    const WITHOUT_FRICTION: [Class; 6] = [
        Class::LeavesAtOnce,
        Class::LiftsOffLater,
        Class::RollsForever,
        Class::RepeatsForever,
        Class::InContact,
        Class::Unresolved,
    ];
    const MASSLESS: [Class; 7] = [
        Class::RollsForever,
        Class::RepeatsForever,
        Class::InContact,
        Class::ParticleAtPlane,
        Class::ParticleAtBottom,
        Class::ParticleAtTop,
        Class::Painleve,
    ];
    const RESISTED: [Class; 6] = [
        Class::LeavesAtOnce,
        Class::LiftsOffLater,
        Class::Rests,
        Class::InContact,
        Class::Painleve,
        Class::Unresolved,
    ];
    const MASSLESS_RESISTED: [Class; 6] = [
        Class::Rests,
        Class::InContact,
        Class::ParticleAtPlane,
        Class::ParticleAtBottom,
        Class::ParticleAtTop,
        Class::Painleve,
    ];
    [
        &HEAVY[..],
        &WITHOUT_FRICTION[..],
        &MASSLESS[..],
        &RESISTED[..],
        &MASSLESS_RESISTED[..],
    ]
    .into_iter()
    .any(|kind| kind.contains(&a) && kind.contains(&b))
}

#[test]
fn modes_that_meet_differ_in_grey() {
    for theme in Theme::ALL {
        let mut seen: BTreeSet<Mode> = BTreeSet::new();
        for body in BodyClass::ALL {
            let set: BTreeSet<Mode> = EDGES
                .iter()
                .filter(|edge| edge.body == body)
                .flat_map(|edge| [edge.from, edge.to])
                .flatten()
                .chain([Mode::Rest, Mode::Skidding])
                .collect();
            seen.extend(&set);
            for &a in &set {
                for &b in set.range(..a) {
                    let gap = (of_mode(a, theme).lightness() - of_mode(b, theme).lightness()).abs();
                    assert!(gap > 12.0, "{a} and {b}, {theme:?}: {gap}");
                }
            }
        }
        assert_eq!(seen.into_iter().collect::<Vec<_>>(), Mode::ALL);
    }
}

#[test]
fn classes_that_meet_in_one_map_differ_in_grey() {
    for theme in Theme::ALL {
        for (i, a) in Class::ALL.into_iter().enumerate() {
            let is_of_a_motion = !matches!(a, Class::Invalid | Class::NotComputed);
            assert_eq!(
                meet(a, a),
                is_of_a_motion,
                "{a} is in a map of some kind of hoop"
            );
            for b in Class::ALL.into_iter().take(i).filter(|b| meet(a, *b)) {
                let gap = (of_class(a, theme).lightness() - of_class(b, theme).lightness()).abs();
                assert!(gap > 12.0, "{a} and {b}, {theme:?}: {gap}");
            }
        }
    }
}

#[test]
fn what_is_mixed_differs_in_grey_from_every_outcome() {
    for theme in Theme::ALL {
        let mixed = Ink::Mixed.colour(theme).lightness();
        for class in Class::ALL.into_iter().filter(|class| meet(*class, *class)) {
            let gap = (mixed - of_class(class, theme).lightness()).abs();
            assert!(gap > 12.0, "{class}, {theme:?}: {gap}");
        }
    }
}

#[test]
fn points_without_a_motion_differ_in_grey_from_all_others() {
    for theme in Theme::ALL {
        for empty in [Class::Invalid, Class::NotComputed] {
            for class in Class::ALL.into_iter().filter(|class| *class != empty) {
                let gap =
                    (of_class(empty, theme).lightness() - of_class(class, theme).lightness()).abs();
                assert!(gap > 8.0, "{empty} and {class}, {theme:?}: {gap}");
            }
        }
    }
}

#[test]
fn a_colour_has_one_meaning() {
    for theme in Theme::ALL {
        let modes = Mode::ALL.map(|mode| (mode.name(), of_mode(mode, theme)));
        let classes = Class::ALL.map(|class| (class.name(), of_class(class, theme)));
        let arrows = Arrow::ALL.map(|arrow| (arrow.name(), arrow.colour(theme)));
        let accents = Accent::ALL.map(|accent| (accent.name(), accent.colour(theme)));
        let all: Vec<_> = modes
            .into_iter()
            .chain(classes)
            .chain(arrows)
            .chain(accents)
            .collect();
        for (i, (a, first)) in all.iter().enumerate() {
            for (b, second) in &all[..i] {
                let apart = distance(*first, *second);
                assert!(apart > 9.0, "{a} and {b}, {theme:?}: {apart}");
            }
        }
        // What is drawn over a map or beside a motion is told from it at a glance.
        for (a, first) in modes {
            for (b, second) in classes.into_iter().chain(arrows).chain(accents) {
                let apart = distance(first, second);
                assert!(apart > 20.0, "{a} and {b}, {theme:?}: {apart}");
            }
        }
    }
}

#[test]
fn lines_are_told_apart_without_colours() {
    for (i, a) in Mode::ALL.into_iter().enumerate() {
        for b in Mode::ALL.into_iter().take(i) {
            assert_ne!(dash_of(a), dash_of(b), "{a} and {b}");
        }
    }
    for theme in Theme::ALL {
        for (i, a) in Curve::ALL.into_iter().enumerate() {
            for b in Curve::ALL.into_iter().take(i) {
                let gap = (a.colour(theme).lightness() - b.colour(theme).lightness()).abs();
                // The band of rest is wider than any curve.
                let ratio = a.width().max(b.width()) / a.width().min(b.width());
                assert!(
                    a.dash() != b.dash() || gap > 12.0 || ratio >= 2.0,
                    "{a:?} and {b:?}, {theme:?}: {gap}"
                );
            }
        }
    }
}

#[test]
fn lines_of_impulses_and_parts_of_an_energy_are_told_apart() {
    for theme in Theme::ALL {
        for (i, a) in ImpulseLine::ALL.into_iter().enumerate() {
            for b in ImpulseLine::ALL.into_iter().take(i) {
                let apart = distance(a.colour(theme), b.colour(theme));
                assert!(
                    a.dash() != b.dash() || apart > 20.0,
                    "{a:?} and {b:?}, {theme:?}"
                );
            }
            assert!(
                a.colour(theme).contrast(Ink::Paper.colour(theme)) > 4.5,
                "{a:?}, {theme:?}"
            );
        }
        // Those that lie side by side in a bar.
        for pair in EnergyPart::ALL.windows(2) {
            let [a, b] = [pair[0].colour(theme), pair[1].colour(theme)];
            let in_grey = (a.lightness() - b.lightness()).abs();
            assert!(
                distance(a, b) > 20.0 && in_grey > 4.0,
                "{pair:?}, {theme:?}: {in_grey}"
            );
        }
    }
}

#[test]
fn lines_and_letters_stand_out_from_the_paper() {
    for theme in Theme::ALL {
        let [paper, ink] = [Ink::Paper, Ink::Ink].map(|ink| ink.colour(theme));
        for mode in Mode::ALL {
            // 3 is the bound of WCAG 2 for lines and bold letters.
            let colour = of_mode(mode, theme);
            assert!(colour.contrast(paper) > 3.0, "{mode}, {theme:?}");
            assert!(
                colour.contrast(colour.more_legible(ink, paper)) > 3.5,
                "{mode}, {theme:?}"
            );
        }
        for arrow in Arrow::ALL {
            assert!(
                arrow.colour(theme).contrast(paper) > 4.5,
                "{arrow:?}, {theme:?}"
            );
        }
        for accent in Accent::ALL {
            assert!(
                accent.colour(theme).contrast(paper) > 3.0,
                "{accent:?}, {theme:?}"
            );
        }
        for curve in [
            Curve::SlipLimit,
            Curve::NormalForceZero,
            Curve::Separatrix,
            Curve::LiftOff,
        ] {
            for ground in [Ink::Paper, Ink::Region].map(|ink| ink.colour(theme)) {
                assert!(
                    curve.colour(theme).contrast(ground) > 4.5,
                    "{curve:?}, {theme:?}"
                );
            }
        }
        let soft = Ink::Soft.colour(theme);
        assert!(
            ink.contrast(paper) > 7.0 && soft.contrast(paper) > 4.5,
            "{theme:?}"
        );
        assert!(soft.contrast(Ink::Ground.colour(theme)) > 4.0, "{theme:?}");
    }
}

#[test]
fn every_name_is_there_once() {
    for theme in Theme::ALL {
        let table = swatches(theme);
        for (i, swatch) in table.iter().enumerate() {
            let same = |other: &Swatch| other.group == swatch.group && other.name == swatch.name;
            assert!(!table[..i].iter().any(same), "{swatch:?}");
        }
        for (group, names) in [("mode", &Mode::NAMES[..]), ("class", &Class::NAMES)] {
            let found: Vec<&str> = table
                .iter()
                .filter(|swatch| swatch.group == group)
                .map(|swatch| swatch.name)
                .collect();
            assert_eq!(found, names);
        }
    }
}

#[test]
fn colours_are_written_as_style_sheets_have_them() {
    assert_eq!(of_mode(Mode::Rolling, Theme::Light).hex(), "#004b87");
    assert_eq!(
        Rgb([200, 100, 0]).over(Rgb([0, 100, 200]), 0.25),
        Rgb([50, 100, 150])
    );
    assert!((Rgb([255, 255, 255]).contrast(Rgb([0, 0, 0])) - 21.0).abs() < 1e-12);
}

#[test]
fn tints_of_a_hue_and_neighbours_differ_in_lightness() {
    for theme in Theme::ALL {
        let lightness = |rank, is_mirrored| of_rank(rank, is_mirrored, theme).lightness();
        for rank in 0..RANKS {
            let apart = |other: f64| (lightness(rank, false) - other).abs() > 12.0;
            assert!(apart(lightness(rank, true)), "{rank}, {theme:?}");
            assert!(
                rank == 0 || apart(lightness(rank - 1, false)),
                "{rank}, {theme:?}"
            );
        }
    }
}

#[test]
fn a_scale_grows_lighter() {
    let scale: Vec<f64> = (0..=200)
        .map(|i| of_fraction(f64::from(i) / 200.0).lightness())
        .collect();
    assert!(
        scale.windows(2).all(|pair| pair[1] >= pair[0]) && scale[200] - scale[0] > 70.0,
        "{scale:?}"
    );
}
