//! The pictures that no paper has: the atlas, the wall, inertia switched off, the paper against
//! exact, all cases on one page.

use crate::support::{THIN, columns, figure, outlines, series};
use littlewood::cases::CASES;
use littlewood_figures::{Figure, FigureInput, Mark, find_figure};

fn of_case(name: &str, case: &str) -> Figure {
    let input = FigureInput::of_case(case).expect("a case");
    find_figure(name)
        .expect("a name of the catalogue")
        .figure(&input)
        .expect("it can be drawn")
}

#[test]
fn each_motion_of_the_atlas_has_its_own_fate_and_a_leader_that_crosses_no_other() {
    for (case, least) in [
        ("figure-3", 10),
        ("figure-7", 4),
        ("figure-3-bounces", 4),
        ("ramp-jump", 4),
    ] {
        let atlas = of_case("atlas", case);
        let pictures = atlas.panels.iter().filter(|panel| panel.name == "motion");
        let titles: Vec<&str> = pictures
            .map(|panel| panel.labels[0].text.as_str())
            .collect();
        assert!(titles.len() >= least, "{case}: {titles:?}");
        for (i, title) in titles.iter().enumerate() {
            // Mirrored motions and long ones may begin alike, but not all.
            assert!(title.contains(": "), "{title}");
            assert!(
                titles[..i].iter().filter(|other| *other == title).count() < 4,
                "{case}: {titles:?}"
            );
        }
        let leaders = outlines(series(&atlas, "leader")[0], ["right", "up"]);
        assert_eq!(leaders.len(), titles.len());
        let side = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
            ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
        };
        for (i, one) in leaders.iter().enumerate() {
            // Those of the other row leave the plane at the other side.
            let same = |other: &&Vec<[f64; 2]>| (other[1][1] - one[1][1]).abs() < 1.0;
            for other in leaders[..i].iter().filter(same) {
                let [a, b, c, d] = [one[0], one[1], other[0], other[1]];
                let crosses = side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b);
                assert!(!crosses, "{case}: {one:?} and {other:?}");
            }
        }
    }
}

#[test]
fn every_jump_meets_the_wall() {
    let wall = figure("wall");
    let jumps = columns(series(&wall, "lift-off")[0], ["theta", "theta_rate"]);
    assert!(jumps.len() >= 4);
    // h = 1/2.
    for [theta, rate] in jumps {
        assert!(
            (0.5 * libm::cos(theta) * rate * rate - 1.0).abs() < 1e-9,
            "{theta} {rate}"
        );
    }
    for [theta, rate] in columns(
        series(&wall, "foot of the wall")[0],
        ["theta", "theta_rate"],
    ) {
        assert!(
            (0.5 * libm::cos(theta) * rate * rate - 1.0).abs() < 1e-9,
            "{theta} {rate}"
        );
    }
}

#[test]
fn the_blow_at_the_bottom_grows_until_it_is_gone() {
    let figure = figure("inertia");
    let peaks: Vec<f64> = [1.0, 0.1, 0.01, 0.001]
        .map(|inertia| {
            let series = &figure.panels[1].layers;
            let own = series
                .iter()
                .find(|layer| layer.series.name == format!("inertia {inertia}"));
            columns(&own.expect("a line").series, ["normal"])
                .into_iter()
                .map(|[n]| n)
                .fold(0.0, f64::max)
        })
        .to_vec();
    assert!(
        peaks.windows(2).all(|pair| pair[1] > 3.0 * pair[0]),
        "{peaks:?}"
    );
    let massless = figure.panels[1]
        .layers
        .iter()
        .find(|layer| layer.series.name == "inertia 0")
        .expect("a line");
    for [time, normal] in columns(&massless.series, ["time", "normal"]) {
        // It slips at ln 5 and glides from then on, without a force.
        assert!(
            normal < 1.0 && (time < libm::log(5.0) + 1e-9 || normal == 0.0),
            "{time} {normal}"
        );
    }
}

#[test]
fn the_band_is_where_rolling_needs_a_pull_and_sliding_does_not() {
    let figure = figure("paper");
    let band = series(&figure, "band")[0];
    for piece in outlines(band, ["theta", "theta_rate"]) {
        let middle =
            [0, 1].map(|k| piece.iter().map(|place| place[k]).sum::<f64>() / piece.len() as f64);
        if crate::support::winding(std::slice::from_ref(&piece), middle) == 0 {
            continue;
        }
        let (normal, _) = THIN.rolling_forces(middle[0], middle[1]);
        assert!(
            normal < 0.0 && 0.5 * libm::cos(middle[0]) * middle[1] * middle[1] < 1.0,
            "{middle:?}"
        );
    }
    for piece in &series(&figure, "exact")[0].pieces {
        let w = |row: &Vec<f64>| {
            let falling = libm::sin(row[0]) * row[1];
            0.5 * falling * falling + libm::cos(row[0])
        };
        assert!(
            piece
                .iter()
                .all(|row| (w(row) - w(&piece[0])).abs() < 1e-9 * (1.0 + row[1] * row[1]))
        );
    }
    for piece in &series(&figure, "printed")[0].pieces {
        let w = |row: &Vec<f64>| 0.5 * libm::sin(row[0]) * row[1] * row[1] - row[0];
        assert!(piece.iter().all(|row| (w(row) - w(&piece[0])).abs() < 1e-9));
    }
}

#[test]
fn the_page_of_cases_has_each_by_name_on_one_scale() {
    let page = figure("cases");
    let texts: Vec<String> = page.texts().into_iter().map(|(text, _)| text).collect();
    for case in CASES {
        assert!(texts.iter().any(|text| text == case.name), "{}", case.name);
    }
    for name in ["friction", "energy"] {
        let mut ranges = page
            .panels
            .iter()
            .filter(|panel| panel.name == name)
            .map(|panel| {
                let axes = panel.axes();
                [axes[0].range, axes[1].range]
            });
        let first = ranges.next().expect("a panel");
        assert!(ranges.all(|range| range == first));
    }
    // One radius everywhere.
    let pixels = page
        .panels
        .iter()
        .filter(|panel| panel.name == "motion")
        .map(|panel| {
            assert!(
                panel
                    .layers
                    .iter()
                    .any(|layer| matches!(layer.mark, Mark::Hoop { .. }))
            );
            let [[left, _], [right, _]] = panel.axes_frame();
            let x = panel.axes()[0].range;
            (right - left) / (x[1] - x[0])
        });
    let pixels: Vec<f64> = pixels.collect();
    assert!(
        pixels.len() == CASES.len() - 1 && pixels.iter().all(|one| (one - pixels[0]).abs() < 1e-9)
    );
}
