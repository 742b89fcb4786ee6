//! Scenes against the geometry of the body and the forces of the motion.

use crate::filmed;
use littlewood::cases::find_case;
use littlewood::{Hoop, Limits, Mode, Start, Trajectory};
use littlewood_film::{DrawnArrow, Film, FrameSize, Framing, Pace, Part, Scene, With};
use littlewood_style::{Accent, Ink, Rgb, Theme};

const WITH: [With; 3] = [With::Plane, With::Friction, With::Energy];

fn motion(name: &str) -> Trajectory {
    find_case(name)
        .expect("a named case")
        .simulate()
        .expect("it can be simulated")
}

fn film(motion: &Trajectory) -> Film<'_> {
    let pace = Pace {
        fps: 20,
        slow: 3.0,
        units: None,
        hold_s: None,
    };
    Film::new(motion, &pace, FrameSize::default(), Framing::Auto).expect("it can be made")
}

fn scenes<'a>(film: &'a Film<'_>) -> impl Iterator<Item = Scene> + use<'a> {
    (0..film.schedule().frames).map(|index| film.scene(index).expect("it can be made"))
}

/// Horizontal and vertical extent of an arrow.
fn extent(arrow: Option<DrawnArrow>) -> (f64, f64) {
    arrow.map_or((0.0, 0.0), |arrow| {
        (arrow.head.x - arrow.tail.x, arrow.head.y - arrow.tail.y)
    })
}

#[test]
fn the_body_keeps_its_shape_in_all_modes() {
    for (case, motion) in filmed() {
        let hoop = motion.hoop();
        for scene in scenes(&film(&motion)) {
            let to = |point: littlewood::modes::Position| {
                (
                    point.x - scene.sample.centre.x,
                    point.y - scene.sample.centre.y,
                )
            };
            let (sin, cos) = libm::sincos(scene.sample.state.theta);
            for (point, distance) in [
                (scene.sample.particle, hoop.offset()),
                (scene.sample.mass_centre, hoop.h()),
            ] {
                // e2 of (2.2) is (−sin θ, cos θ).
                let (x, y) = to(point);
                let at = 1e-14 * scene.sample.centre.x.abs().max(1.0);
                assert!(
                    (x + distance * sin).abs() < at && (y - distance * cos).abs() < at,
                    "{case}"
                );
            }
            assert_eq!(scene.lowest.x, scene.sample.centre.x);
            assert!((to(scene.lowest).1 + 1.0).abs() < 1e-15);
            // The particle never goes through the plane.
            assert!(scene.sample.particle.y > -1e-14, "{case}");
        }
    }
}

#[test]
fn the_contact_point_is_on_the_plane_and_there_is_none_in_flight() {
    let mut modes = [0; Mode::ALL.len()];
    for (_, motion) in filmed() {
        for scene in scenes(&film(&motion)) {
            modes[scene.mode() as usize] += 1;
            if scene.mode() == Mode::Flight {
                // The gap of the landing itself is zero up to rounding.
                assert!(
                    scene.sample.gap > -1e-14 && scene.contact.is_none(),
                    "{}",
                    scene.sample.gap
                );
                assert!(scene.normal.is_none() && scene.friction.is_none() && scene.slip.is_none());
            } else {
                assert_eq!(scene.contact.unwrap().y, 0.0);
                assert_eq!(scene.sample.centre.y, 1.0);
            }
        }
    }
    assert!(modes.iter().all(|&count| count > 50), "{modes:?}");
}

#[test]
fn arrows_are_proportional_to_the_forces_of_the_motion() {
    for name in [
        "figure-3",
        "figure-7",
        "figure-2-libration",
        "stick-slip-no-jump",
    ] {
        let motion = motion(name);
        let film = film(&motion);
        let scale = film.scale();
        for (index, scene) in scenes(&film).enumerate() {
            let sample = motion.at(film.schedule().time(index as u64)).unwrap();
            let near = |found: f64, expected: f64| (found - expected).abs() < 1e-13;
            let (normal, friction, slip) = (
                extent(scene.normal),
                extent(scene.friction),
                extent(scene.slip),
            );
            assert!(
                normal.0 == 0.0 && near(normal.1, scale.force * sample.normal),
                "{name} {index}"
            );
            assert!(
                friction.1 == 0.0 && near(friction.0, scale.force * sample.friction),
                "{name} {index}"
            );
            if sample.mode != Mode::Flight {
                assert!(
                    slip.1 == 0.0 && near(slip.0, scale.velocity * sample.state.slip),
                    "{name} {index}"
                );
            }
            match sample.mode {
                // (2.15): kinetic friction is against the slip.
                Mode::Sliding if index > 0 => {
                    assert!(friction.0 * slip.0 <= 0.0);
                    assert!(near(friction.0.abs(), motion.hoop().mu_k() * normal.1));
                }
                // (2.13)
                Mode::Rolling => assert!(
                    slip.0.abs() < 1e-13
                        && friction.0.abs() <= motion.hoop().mu_s() * normal.1 + 1e-13
                ),
                // (3.16)
                Mode::Gliding => assert_eq!((normal, friction), ((0.0, 0.0), (0.0, 0.0))),
                _ => {}
            }
        }
    }
}

#[test]
fn a_particle_that_meets_the_plane_is_drawn_there() {
    let motion = motion("figure-7");
    let film = film(&motion);
    let last = film.scene(film.schedule().frames - 1).unwrap();
    assert!(last.sample.state.theta_rate.is_infinite());
    assert!(last.sample.particle.y.abs() < 1e-15);
    assert!((last.sample.particle.x - last.sample.centre.x).abs() < 1e-15);
    // τ_s = ln 5, τ_g − τ_s = (√89 − 3)/5.
    assert!((last.time() - libm::log(5.0) - (89.0_f64.sqrt() - 3.0) / 5.0).abs() < 1e-14);
}

#[test]
fn an_infinite_slip_is_cut() {
    // A particle inside the rim: η′ grows without bound towards θ = π.
    let case = find_case("figure-7").unwrap();
    let hoop = littlewood::Hoop::new(
        littlewood::HoopParameters::thin(0.0)
            .with_offset(0.8)
            .with_friction(0.5, 0.4),
    )
    .unwrap();
    let motion = hoop
        .simulate(case.setup.start, littlewood::Limits::default())
        .unwrap();
    let film = film(&motion);
    let last = film.scene(film.schedule().frames - 1).unwrap();
    let slip = last.slip.unwrap();
    assert!(slip.value.is_infinite() && slip.is_cut);
    assert!((slip.head.x - slip.tail.x).abs() < 2.0);
    assert!(!film.still(film.schedule().frames - 1).unwrap().is_empty());
}

#[test]
fn the_weight_hangs_from_the_mass_centre_on_the_scale_of_the_forces() {
    for name in ["figure-3", "figure-7"] {
        let motion = motion(name);
        let film = film(&motion);
        for scene in scenes(&film) {
            let weight = scene.weight.expect("it is never without weight");
            assert_eq!(weight.tail, scene.sample.mass_centre);
            let length = weight.tail.y - weight.head.y;
            assert!(
                (length - film.scale().force * motion.hoop().mass()).abs() < 1e-13,
                "{name}: {length}"
            );
        }
    }
}

#[test]
fn a_motion_without_end_is_shown_in_part_and_says_so() {
    let periods = |name: &str| {
        let motion = motion(name);
        let schedule = film(&motion).schedule().clone();
        let period = motion
            .outcome()
            .recurrence()
            .and_then(|recurrence| recurrence.period());
        let since = motion.outcome().state().time;
        (
            schedule.part,
            (schedule.end - since) / period.expect("a period"),
        )
    };
    let (part, number) = periods("figure-2-libration");
    assert!(
        part == Part::Period && (number - 1.0).abs() < 1e-12,
        "{part:?} {number}"
    );
    let (part, number) = periods("stick-slip-no-jump");
    assert!(
        part == Part::TwoPeriods && (number - 2.0).abs() < 1e-12,
        "{part:?} {number}"
    );
    assert_eq!(film(&motion("figure-3")).schedule().part, Part::Whole);
    for (case, motion) in filmed() {
        let schedule = film(&motion).schedule().clone();
        assert!(schedule.end - schedule.start < 60.0, "{case}");
    }
}

#[test]
fn a_pane_shows_the_motion_and_the_inset_the_path() {
    let motion = motion("figure-3");
    let plain = film(&motion);
    let last = plain.schedule().frames - 1;
    let mut pictures = vec![plain.still(last).unwrap()];
    for with in WITH {
        let shown = film(&motion).with_pane(with);
        let (first, end) = (shown.still(0).unwrap(), shown.still(last).unwrap());
        // The pane is the right part of the picture, under the inset: 640 − 236 pixels from the
        // left.
        let pane = |picture: &[u8]| -> Vec<u8> {
            picture
                .chunks_exact(4 * 640)
                .skip(96)
                .take(200)
                .flat_map(|row| row[4 * 404..].to_vec())
                .collect()
        };
        assert!(pane(&first) != pane(&end), "{with:?} does not run along");
        pictures.push(end);
    }
    for (i, picture) in pictures.iter().enumerate() {
        assert!(pictures[..i].iter().all(|other| other != picture));
    }
}

#[test]
#[ignore = "thorough"]
fn every_case_has_every_pane() {
    for (case, motion) in filmed() {
        for with in WITH {
            let film = film(&motion).with_pane(with);
            for index in [0, film.schedule().frames / 2, film.schedule().frames - 1] {
                assert!(!film.still(index).unwrap().is_empty(), "{case} {with:?}");
            }
        }
    }
}

#[test]
fn two_motions_run_in_one_clock() {
    let (first, second) = (motion("figure-3"), motion("figure-7"));
    let alone = [&first, &second].map(film);
    let size = FrameSize::new(320, 400).unwrap();
    let pace = Pace {
        fps: 20,
        slow: 3.0,
        units: None,
        hold_s: None,
    };
    let [upper, lower] =
        [&first, &second].map(|motion| Film::new(motion, &pace, size, Framing::Auto).unwrap());
    let both = upper.over(lower, ["a", "b"]).unwrap();
    let frames = both.schedule().frames;
    assert_eq!(frames, alone[0].schedule().frames);
    assert!(frames > alone[1].schedule().frames);
    // One scale of arrows, in which those of both have room.
    let scales = alone.each_ref().map(Film::scale);
    assert_eq!(
        both.scale().velocity,
        scales[0].velocity.min(scales[1].velocity)
    );
    let of = |pixels: &[u8], accent: Accent| {
        let Rgb([red, green, blue]) = accent.colour(Theme::Light);
        pixels.as_chunks::<4>().0.contains(&[red, green, blue, 255])
    };
    let halves = |index: u64| {
        let pixels = both.still(index).unwrap();
        let (upper, lower) = pixels.split_at(pixels.len() / 2);
        (upper.to_vec(), lower.to_vec())
    };
    let ended = alone[1].schedule().frames;
    let (before, last) = (halves(ended), halves(frames - 1));
    for (upper, lower) in [&before, &last] {
        assert!(of(upper, Accent::Violet) && !of(upper, Accent::Teal));
        assert!(of(lower, Accent::Teal) && !of(lower, Accent::Violet));
    }
    // What has ended stays, and the other goes on.
    assert!(before.1 == last.1 && before.0 != last.0);
    let low = FrameSize::new(640, 300).unwrap();
    let [upper, lower] =
        [&first, &second].map(|motion| Film::new(motion, &pace, low, Framing::Auto).unwrap());
    let refused = upper.over(lower, ["a", "b"]).unwrap_err().to_string();
    assert_eq!(
        refused,
        "size = 640x300 px: two hoops need a height of 320 to 4096 px"
    );
}

#[test]
fn the_frame_that_tells_most_is_in_the_middle_of_the_flight() {
    let motion = motion("figure-3");
    let film = film(&motion);
    let scene = film.scene(film.telling()).unwrap();
    assert_eq!(scene.mode(), Mode::Flight);
    let flight = motion.phases().last().unwrap();
    let middle = 0.5 * (flight.start().time + flight.end_time());
    assert!((scene.time() - middle).abs() <= 0.5 * film.schedule().step);
    let png = film.png(film.telling()).unwrap();
    assert!(png.starts_with(b"\x89PNG"));
}

#[test]
fn a_plane_with_a_slope_is_tilted_under_a_level_camera() {
    let ground = Ink::Ground.colour(Theme::Light).0;
    let ramp = find_case("ramp-jump").expect("a named case").setup;
    for (slope, theta, framing) in [
        (0.3, 0.5, Framing::Whole),
        (0.3, 0.5, Framing::Follow),
        (-0.7, -0.5, Framing::Follow),
        (1.4, 0.5, Framing::Follow),
        (-1.4, 0.5, Framing::Whole),
    ] {
        let hoop = Hoop::new(ramp.hoop.with_slope(slope)).expect("a hoop");
        let motion = hoop
            .simulate(Start::at(theta, 0.0), Limits::default())
            .expect("a motion");
        let pace = Pace {
            fps: 20,
            slow: 3.0,
            units: None,
            hold_s: None,
        };
        let film =
            Film::new(&motion, &pace, FrameSize::default(), framing).expect("it can be made");
        for index in [0, film.schedule().frames / 2] {
            let pixels = film.still(index).expect("it can be drawn");
            let width = FrameSize::default().width() as usize;
            let is_ground =
                |row: usize, column: usize| pixels[4 * (row * width + column)..][..3] == ground;
            // The side of the ground in each row, where it is not that of the picture; under the
            // inset nothing is seen.
            let side = |row: usize| {
                let mut columns = (0..width).filter(|column| is_ground(row, *column));
                let side = if slope > 0.0 {
                    columns.next()
                } else {
                    columns.next_back()
                };
                side.filter(|column| (1..width - 1).contains(column))
            };
            let sides: Vec<(usize, usize)> = (95..300)
                .filter_map(|row| side(row).map(|column| (row, column)))
                .collect();
            let [(top, first), .., (bottom, last)] = sides[..] else {
                panic!("the plane is not seen at {slope}")
            };
            // A pixel at either end, and the edge of the line beside a mark of the axis.
            let (down, left) = ((bottom - top) as f64, first as f64 - last as f64);
            let (sin, cos) = libm::sincos(slope);
            assert!(
                (down * cos - left * sin).abs() < 6.0,
                "{slope}, {framing:?}: {down} {left}"
            );
            assert!(down > 60.0, "{slope}, {framing:?}: {down}");
        }
    }
}
