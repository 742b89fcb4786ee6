//! Files: what decoders find in them, the committed films, and ffmpeg.

use std::fs::{self, File};
use std::io::{self, BufReader, Write};
use std::path::Path;

use littlewood::cases::find_case;
use littlewood::tables::Setup;
use littlewood::{Hoop, Limits, Trajectory};
use littlewood_film::{
    Encoder, FfmpegFilm, Film, FilmError, FrameSize, Framing, GifFilm, Pace, SizeError, Video,
};

fn motion(name: &str) -> Trajectory {
    find_case(name)
        .expect("a named case")
        .simulate()
        .expect("it can be simulated")
}

fn film(motion: &Trajectory, fps: u32, size: (u32, u32)) -> Film<'_> {
    let pace = Pace {
        fps,
        slow: 1.0,
        units: None,
        hold_s: None,
    };
    Film::new(
        motion,
        &pace,
        FrameSize::new(size.0, size.1).expect("it can be made"),
        Framing::Auto,
    )
    .expect("it can be made")
}

fn gif(film: &Film<'_>) -> Vec<u8> {
    let mut encoder = GifFilm::new(Vec::new(), film).expect("it can be made");
    film.play(&mut encoder, |_| true).expect("it can be made");
    encoder.finish().expect("it can be made")
}

#[test]
fn a_gif_has_all_frames_their_durations_and_their_pixels() {
    let motion = motion("figure-3");
    let film = film(&motion, 15, (320, 180));
    let bytes = gif(&film);
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(&bytes[..]).unwrap();
    assert_eq!((decoder.width(), decoder.height()), (320, 180));
    let mut screen = vec![0; 320 * 180 * 4];
    let (mut count, mut duration) = (0, 0);
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        duration += u64::from(frame.delay);
        let width = usize::from(frame.width);
        for (i, pixel) in frame
            .buffer
            .chunks_exact(4)
            .enumerate()
            .filter(|(_, pixel)| pixel[3] == 255)
        {
            let (x, y) = (
                usize::from(frame.left) + i % width,
                usize::from(frame.top) + i / width,
            );
            screen[4 * (320 * y + x)..][..4].copy_from_slice(pixel);
        }
        if count % 10 == 0 {
            // The colours of a GIF are few, but nowhere far from what was drawn.
            let drawn = film.still(count).unwrap();
            let worst = screen
                .iter()
                .zip(&drawn)
                .map(|(a, b)| a.abs_diff(*b))
                .max()
                .unwrap();
            assert!(worst <= 60, "{worst} in frame {count}");
        }
        count += 1;
    }
    assert_eq!(count, film.schedule().frames);
    // 15 frames a second, and the last stays 1.5 s longer.
    let exact = 100.0 * count as f64 / 15.0 + 150.0;
    assert!((duration as f64 - exact).abs() <= 1.0, "{duration} {exact}");
}

#[test]
#[ignore = "thorough"]
fn the_committed_films_are_what_is_drawn() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/films");
    for (file, case, slow, until) in [
        ("figure-3", "figure-3", 3.0, None),
        ("figure-7", "figure-7", 4.0, None),
        ("libration", "figure-2-libration", 1.25, None),
        ("bounces", "figure-3-bounces", 1.5, Some(8.0)),
        ("ramp-jump", "ramp-jump", 0.8, None),
    ] {
        let Setup { hoop, start, .. } = find_case(case).unwrap().setup;
        let limits = Limits::default().with_until(until);
        let motion = Hoop::new(hoop).unwrap().simulate(start, limits).unwrap();
        let pace = Pace {
            fps: 20,
            slow,
            units: None,
            hold_s: None,
        };
        let film = Film::new(&motion, &pace, FrameSize::default(), Framing::Auto).unwrap();
        let committed = fs::read(folder.join(file).with_extension("gif")).unwrap();
        assert!(committed.len() < 2_000_000);
        assert!(
            gif(&film) == committed,
            "{file}: cargo run --release -p littlewood-film --example films docs/films"
        );
    }
}

#[test]
fn a_film_that_is_stopped_says_where() {
    let motion = motion("figure-3");
    let film = film(&motion, 10, (160, 160));
    let mut encoder = GifFilm::new(Vec::new(), &film).unwrap();
    let error = film.play(&mut encoder, |done| done < 7).unwrap_err();
    assert!(
        matches!(error, FilmError::Stopped { done: 7, total: 40 }),
        "{error}"
    );
}

/// Takes a number of bytes, then the disk is full.
struct FullDisk(usize);

impl Write for FullDisk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.0 == 0 {
            return Err(io::ErrorKind::StorageFull.into());
        }
        let taken = bytes.len().min(self.0);
        self.0 -= taken;
        Ok(taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_full_disk_is_an_error_of_its_own() {
    let motion = motion("figure-3");
    let film = film(&motion, 10, (160, 160));
    let is_full = |error: FilmError| match error {
        FilmError::Write(error) => error.kind() == io::ErrorKind::StorageFull,
        _ => false,
    };
    // In the header, in a frame.
    assert!(is_full(GifFilm::new(FullDisk(10), &film).unwrap_err()));
    let mut encoder = GifFilm::new(FullDisk(4000), &film).unwrap();
    assert!(is_full(film.play(&mut encoder, |_| true).unwrap_err()));
}

#[test]
fn a_gif_has_at_most_50_frames_a_second() {
    let motion = motion("figure-3");
    assert!(GifFilm::new(Vec::new(), &film(&motion, 50, (160, 160))).is_ok());
    let film = film(&motion, 51, (160, 160));
    let error = GifFilm::new(Vec::new(), &film).unwrap_err();
    assert!(matches!(
        error,
        FilmError::FrameRate {
            fps: 51,
            most: 50,
            format: "GIF"
        }
    ));
}

#[test]
fn sizes_have_bounds() {
    for (width, height) in [
        (0, 360),
        (640, 0),
        (159, 360),
        (640, 4097),
        (u32::MAX, u32::MAX),
    ] {
        assert!(matches!(
            FrameSize::new(width, height),
            Err(SizeError { .. })
        ));
    }
    // Small, tall, and wide.
    for size in [(160, 160), (160, 900), (1600, 160)] {
        let motion = motion("figure-3");
        assert_eq!(
            film(&motion, 2, size).still(3).unwrap().len(),
            4 * (size.0 * size.1) as usize
        );
    }
}

#[test]
fn an_mp4_needs_even_sides_and_ffmpeg() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.mp4");
    let motion = motion("figure-3");
    let odd = film(&motion, 10, (161, 160));
    assert!(matches!(
        FfmpegFilm::start("ffmpeg".as_ref(), &path, &odd, Video::Mp4),
        Err(FilmError::OddSize { .. })
    ));
    let even = film(&motion, 10, (160, 160));
    let error = FfmpegFilm::start(
        "ffmpeg-that-is-not-there".as_ref(),
        &path,
        &even,
        Video::Mp4,
    )
    .unwrap_err();
    assert!(
        matches!(&error, FilmError::NoFfmpeg { .. }) && error.hint().contains("install ffmpeg"),
        "{error}"
    );
}

/// A program that stands in for ffmpeg.
#[cfg(unix)]
fn stand_in(folder: &Path, script: &str) -> std::path::PathBuf {
    use std::os::unix::fs::PermissionsExt as _;
    let path = folder.join("ffmpeg");
    fs::write(&path, format!("#!/bin/sh\n{script}\n")).expect("it can be made");
    fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("it can be made");
    path
}

#[cfg(unix)]
#[test]
fn ffmpeg_receives_every_frame_and_repeats_of_the_last() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.mp4");
    // The last argument is the file.
    let program = stand_in(folder.path(), "for last; do :; done; cat > \"$last\"");
    let motion = motion("figure-3");
    let film = film(&motion, 10, (160, 170));
    let mut encoder = FfmpegFilm::start(program.as_ref(), &path, &film, Video::Mp4).unwrap();
    film.play(&mut encoder, |_| true).unwrap();
    encoder.finish().unwrap();
    let mut received = BufReader::new(File::open(&path).unwrap());
    // The last picture is there for 0.1 s + 1.5 s.
    for index in 0..film.schedule().frames + 15 {
        let mut frame = vec![0; 160 * 170 * 4];
        io::Read::read_exact(&mut received, &mut frame).unwrap();
        let drawn = film.still(index.min(film.schedule().frames - 1)).unwrap();
        assert!(frame == drawn, "frame {index}");
    }
    assert_eq!(io::Read::read(&mut received, &mut [0]).unwrap(), 0);
}

#[cfg(unix)]
#[test]
fn what_ffmpeg_says_is_passed_on() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("film.mp4");
    let motion = motion("figure-3");
    let film = film(&motion, 10, (160, 160));
    for script in [
        "echo 'Unknown encoder libx264' >&2; exit 3",
        "cat > /dev/null; echo 'Unknown encoder libx264' >&2; exit 3",
    ] {
        let program = stand_in(folder.path(), script);
        let mut encoder = FfmpegFilm::start(program.as_ref(), &path, &film, Video::Mp4).unwrap();
        let played = film.play(&mut encoder, |_| true);
        let error = played.and_then(|()| encoder.finish()).unwrap_err();
        assert!(
            error.to_string().contains("Unknown encoder libx264"),
            "{error}"
        );
    }
}

#[test]
fn a_frame_that_does_not_change_is_a_frame() {
    let motion = motion("figure-3");
    let film = film(&motion, 10, (160, 160));
    let mut encoder = GifFilm::new(Vec::new(), &film).unwrap();
    for index in 0..3 {
        encoder
            .frame(&[255; 160 * 160 * 4], film.schedule().shown(index))
            .unwrap();
    }
    let bytes = encoder.finish().unwrap();
    let mut decoder = gif::Decoder::new(&bytes[..]).unwrap();
    let mut count = 0;
    while decoder.read_next_frame().unwrap().is_some() {
        count += 1;
    }
    assert_eq!(count, 3);
}
