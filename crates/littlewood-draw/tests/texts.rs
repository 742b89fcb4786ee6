//! Texts with marks, and what is made of them.

use littlewood::tables::{Class, Dimension, Quantity, SampleColumn};
use littlewood::{Cause, Mode, OutcomeKind};
use littlewood_draw::{Run, Script, markdown, marked, missing, plain, runs, short, unicode, width};

#[test]
fn marks_are_taken_off() {
    assert_eq!(plain("|*F*| = *μ*_{s}*N*, *θ*′^{2}"), "|F| = μₛN, θ′²");
    assert_eq!(plain("10^{−7} *I*_{zz}, *W*^{s}"), "10⁻⁷ I_zz, W^s");
    assert_eq!(markdown("*μ*_{s} = ½"), "*μ*<sub>s</sub> = ½");
    assert_eq!(plain("{x}"), "{x}");
    assert_eq!(
        unicode("*h*, *μ*_{s}*N*, ϱ, *ϱ*, *I*_{z}"),
        "ℎ, 𝜇ₛ𝑁, ϱ, 𝜚, 𝐼\u{e07a}"
    );
    assert_eq!(
        (plain("`E`_{1}"), markdown("`E`_{1}")),
        ("E₁".to_owned(), "**E**<sub>1</sub>".to_owned())
    );
}

#[test]
fn a_run_knows_how_it_is_set() {
    let found = runs("*m*_{1}*R*");
    assert_eq!(
        found,
        [
            Run {
                text: "m",
                italic: true,
                bold: false,
                script: Script::Line
            },
            Run {
                text: "1",
                italic: false,
                bold: false,
                script: Script::Sub
            },
            Run {
                text: "R",
                italic: true,
                bold: false,
                script: Script::Line
            },
        ]
    );
}

#[test]
fn signs_are_marked() {
    assert_eq!(marked("Izz/(m₂R²)"), "*I*_{zz}/(*m*_{2}*R*^{2})");
    assert_eq!(marked("m₂√(gR)"), "*m*_{2}√(*gR*)");
    assert_eq!(marked("θ′"), "*θ*′");
    assert_eq!(marked("dθ/dt = h cos α"), "*dθ*/*dt* = *h* cos *α*");
    assert_eq!(marked("μₛ"), "*μ*_{s}");
}

#[test]
fn numbers_have_four_digits_and_four_decimals() {
    assert_eq!(short(2.0), "2");
    assert_eq!(short(-0.0), "0");
    assert_eq!(short(core::f64::consts::FRAC_PI_2), "1.5708");
    assert_eq!(short(0.000_123_456_7), "0.0001235");
    assert_eq!(short(-12.5), "−12.5");
    assert_eq!(short(53.130_102), "53.1301");
    assert_eq!(
        (short(9.80665), short(1000.0)),
        ("9.80665".to_owned(), "1000".to_owned())
    );
    assert_eq!(short(123_456.7), "123456.7");
    assert_eq!(short(1.5e-9), "1.5×10^{−9}");
    assert_eq!(short(-1e9), "−10^{9}");
}

#[test]
fn the_faces_have_the_letters_of_the_tables() {
    for sign in Quantity::ALL
        .iter()
        .map(|quantity| quantity.sign())
        .chain([SampleColumn::Normal.sign(), SampleColumn::Friction.sign()])
        .chain([
            Dimension::Force.scale_sign(),
            Dimension::Energy.scale_sign(),
        ])
        .chain(Quantity::ALL.iter().map(|quantity| quantity.unit_sign()))
    {
        assert_eq!(missing(&marked(sign)), "", "{sign}");
    }
    for label in Class::ALL
        .iter()
        .map(|class| class.label())
        .chain(Cause::ALL.iter().map(|cause| cause.label()))
        .chain(OutcomeKind::ALL.iter().map(|outcome| outcome.label()))
        .chain(Mode::NAMES)
    {
        assert_eq!(missing(label), "", "{label}");
    }
}

#[test]
fn the_faces_have_the_symbols() {
    assert_eq!(missing("*θηжτμπωℓ*′ 𝓡 𝓝 ± − × √ ° ≤ ½ *N*_{roll}"), "ж");
    assert!(width("mm", 10.0) > width("m", 10.0));
    assert!((width("*μ*_{s}", 20.0) / width("*μ*_{s}", 10.0) - 2.0).abs() < 1e-12);
}

#[test]
fn digits_are_of_one_width() {
    assert!(('1'..='9').all(|digit| width(&digit.to_string(), 1.0) == width("0", 1.0)));
}
