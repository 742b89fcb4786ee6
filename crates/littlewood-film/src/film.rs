//! A film: a motion, and how it is shown.

use littlewood::{Trajectory, Units};

use crate::body::{draw_arrows, draw_body, draw_trail};
use crate::camera::{Camera, EXAMINED, Framing, Window};
use crate::canvas::Canvas;
use crate::encoder::Encoder;
use crate::error::FilmError;
use crate::ground::{draw_contact, draw_plane};
use crate::panel::{FOOT, HEAD, Panel, short};
use crate::scene::{ArrowScale, Scene};
use crate::schedule::{Pace, Schedule};
use crate::size::FrameSize;
use crate::trail::Trail;

/// A film of a motion.
///
/// Frames are drawn one after the other and handed to an [`Encoder`]; at most one is kept.
#[derive(Debug)]
pub struct Film<'a> {
    trajectory: &'a Trajectory,
    schedule: Schedule,
    camera: Camera,
    scale: ArrowScale,
    size: FrameSize,
    units: Option<Units>,
    note: String,
}

impl<'a> Film<'a> {
    /// A film of a motion from its start to its end, or as [`Schedule::new`] has it.
    ///
    /// # Errors
    /// As [`Schedule::new`].
    pub fn new(
        trajectory: &'a Trajectory,
        pace: &Pace,
        size: FrameSize,
        framing: Framing,
    ) -> Result<Self, FilmError> {
        let schedule = Schedule::new(trajectory, pace)?;
        let u = size.unit();
        let (width, height) = (f64::from(size.width()), f64::from(size.height()));
        let window = Window { left: 0.0, top: HEAD * u, width, height: height - (HEAD + FOOT) * u };
        let samples = trajectory.sample_evenly(EXAMINED, schedule.end());
        let scale = ArrowScale::fitting(trajectory.hoop(), samples);
        let camera = Camera::new(trajectory, &schedule, framing, window, u, scale);
        Ok(Self { trajectory, schedule, camera, scale, size, units: pace.units, note: note(pace) })
    }

    /// The instants of the frames.
    #[must_use]
    pub const fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    /// Lengths of the arrows.
    #[must_use]
    pub const fn scale(&self) -> ArrowScale {
        self.scale
    }

    /// Size of the frames.
    #[must_use]
    pub const fn size(&self) -> FrameSize {
        self.size
    }

    /// What a frame shows.
    ///
    /// # Errors
    /// None of a film that could be made.
    pub fn scene(&self, index: u64) -> Result<Scene, FilmError> {
        let sample = self.trajectory.at(self.schedule.time(index));
        let sample = sample.ok_or(FilmError::NoMotion { outcome: self.trajectory.outcome().kind() })?;
        Ok(Scene::of(sample, self.scale))
    }

    /// Draws all frames and hands them to an encoder. `watch` is called with the number of frames done; it returns whether to go on.
    ///
    /// # Errors
    /// The encoder's, or [`FilmError::Stopped`] if `watch` returns false.
    pub fn play(
        &self,
        encoder: &mut impl Encoder,
        mut watch: impl FnMut(u64) -> bool,
    ) -> Result<(), FilmError> {
        let mut reel = Reel::new(self)?;
        let total = self.schedule.frames();
        for index in 0..total {
            if !watch(index) {
                return Err(FilmError::Stopped { done: index, total });
            }
            let pixels = reel.draw(index)?;
            encoder.frame(pixels, self.schedule.shown(index))?;
        }
        watch(total);
        Ok(())
    }

    /// A single frame: red, green, blue and 255 for each pixel, row by row.
    ///
    /// # Errors
    /// None of a film that could be made.
    pub fn still(&self, index: u64) -> Result<Vec<u8>, FilmError> {
        Ok(Reel::new(self)?.draw(index)?.to_vec())
    }
}

/// The frame that is being drawn, and what it shares with those before it.
struct Reel<'a> {
    film: &'a Film<'a>,
    panel: Panel,
    canvas: Canvas,
    trail: Trail,
    /// What all frames have in common.
    ground: Vec<u8>,
}

impl<'a> Reel<'a> {
    fn new(film: &'a Film<'a>) -> Result<Self, FilmError> {
        let mut canvas = Canvas::new(film.size)?;
        let panel = Panel::new(film.size, film.units);
        panel.draw_still(&mut canvas, film.trajectory, &film.schedule, &film.note);
        if film.camera.is_still() {
            let view = film.camera.view(&film.scene(0)?);
            draw_plane(&mut canvas, &view, f64::from(film.size.width()), film.size.unit());
        }
        let ground = canvas.data().to_vec();
        Ok(Self { film, panel, canvas, trail: Trail::new(), ground })
    }

    fn draw(&mut self, index: u64) -> Result<&[u8], FilmError> {
        let Self { film, panel, canvas, trail, ground } = self;
        let (scene, unit) = (film.scene(index)?, film.size.unit());
        let view = film.camera.view(&scene);
        trail.extend(film.trajectory, &film.schedule, film.scale, scene.time());
        canvas.copy(ground);
        if !film.camera.is_still() {
            draw_plane(canvas, &view, f64::from(film.size.width()), unit);
        }
        draw_trail(canvas, &view, trail, &scene, unit);
        draw_body(canvas, &view, &scene, film.trajectory.hoop(), unit);
        draw_contact(canvas, &view, &scene, &panel.gap(&scene), unit);
        draw_arrows(canvas, &view, &scene, unit);
        let is_last = index + 1 == film.schedule.frames() && !film.schedule.closes();
        let outcome = is_last.then(|| film.trajectory.outcome());
        panel.draw_moving(canvas, &scene, &film.schedule, outcome);
        Ok(canvas.data())
    }
}

/// How much slower than the motion the film is.
fn note(pace: &Pace) -> String {
    match pace.units {
        None => format!("{} s of film for √(R/g)", short(pace.slow)),
        Some(_) if pace.slow == 1.0 => "real time".to_owned(),
        Some(_) if pace.slow > 1.0 => format!("{} × slower than real", short(pace.slow)),
        Some(_) => format!("{} × faster than real", short(1.0 / pace.slow)),
    }
}
