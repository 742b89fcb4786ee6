//! The pictures that no paper has: the atlas, inertia switched off, the paper against exact.

use crate::support::{THIN, columns, figure, outlines, series};
use littlewood_figures::{Figure, FigureInput, find_figure};

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
