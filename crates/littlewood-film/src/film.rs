//! A film: a motion, and how it is shown.

use littlewood::Trajectory;
use littlewood::si::Units;

use crate::body::{draw_arrows, draw_body, draw_impulse, draw_trail};
use crate::camera::{Camera, EXAMINED, Framing, Window};
use crate::canvas::Canvas;
use crate::encoder::Encoder;
use crate::error::FilmError;
use crate::ground::{draw_contact, draw_plane};
use crate::impacts::ShownImpact;
use crate::inset::{self, Inset};
use crate::pane::{PANE, Pane, With};
use crate::panel::{FOOT, HEAD, Panel, short};
use crate::scene::{ArrowScale, DrawnImpulse, Scene};
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
    scale: ArrowScale,
    size: FrameSize,
    framing: Framing,
    units: Option<Units>,
    note: String,
    impacts: Vec<ShownImpact>,
    with: Option<With>,
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
        let impacts = ShownImpact::all(trajectory, schedule.end);
        let samples = trajectory.sample_evenly(EXAMINED, schedule.end);
        let scale = ArrowScale::fitting(trajectory.hoop(), samples, &impacts);
        Ok(Self {
            trajectory,
            schedule,
            scale,
            size,
            framing,
            units: pace.units,
            note: note(pace),
            impacts,
            with: None,
        })
    }

    /// The same film with a pane beside the hoop in which the motion runs along.
    #[must_use]
    pub fn with_pane(self, with: With) -> Self {
        Self {
            with: Some(with),
            ..self
        }
    }

    /// Whether impulses or energies are drawn, which have inks of their own.
    pub(crate) const fn has_energies(&self) -> bool {
        !self.impacts.is_empty() || matches!(self.with, Some(With::Energy))
    }

    /// The instants of the frames.
    pub const fn schedule(&self) -> &Schedule {
        &self.schedule
    }

    /// Where the motion is seen, beside the pane if there is one.
    fn window(&self) -> Window {
        let u = self.size.unit();
        let (width, height) = (f64::from(self.size.width()), f64::from(self.size.height()));
        let column = self.with.map_or(0.0, |_| PANE);
        Window {
            left: 0.0,
            top: HEAD * u,
            width: width - u * column,
            height: height - (HEAD + FOOT) * u,
        }
    }

    /// Lengths of the arrows.
    pub const fn scale(&self) -> ArrowScale {
        self.scale
    }

    /// Size of the frames.
    pub const fn size(&self) -> FrameSize {
        self.size
    }

    /// What a frame shows.
    ///
    /// # Errors
    /// None of a film that could be made.
    pub fn scene(&self, index: u64) -> Result<Scene, FilmError> {
        let sample = self.trajectory.at(self.schedule.time(index));
        let sample = sample.ok_or(FilmError::NoMotion {
            outcome: self.trajectory.outcome().kind(),
        })?;
        Ok(Scene {
            impulse: self.impulse(index),
            ..Scene::of(sample, self.scale)
        })
    }

    /// The largest of the impulses that are still to be seen at a frame.
    fn impulse(&self, index: u64) -> Option<DrawnImpulse> {
        self.impacts
            .iter()
            .filter(|impact| self.schedule.shows(index, impact))
            .max_by(|a, b| a.impact.impulse.normal.total_cmp(&b.impact.impulse.normal))
            .map(|shown| DrawnImpulse::new(shown, self.scale))
    }

    /// Draws all frames and hands them to an encoder. `watch` is called with the number of frames
    /// done; it returns whether to go on.
    ///
    /// # Errors
    /// The encoder's, or [`FilmError::Stopped`] if `watch` returns false.
    pub fn play(
        &self,
        encoder: &mut impl Encoder,
        mut watch: impl FnMut(u64) -> bool,
    ) -> Result<(), FilmError> {
        let mut reel = Reel::new(self)?;
        let total = self.schedule.frames;
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
    camera: Camera,
    panel: Panel,
    canvas: Canvas,
    trail: Trail,
    pane: Option<Pane>,
    inset: Option<Inset>,
    /// What all frames have in common.
    ground: Vec<u8>,
}

impl<'a> Reel<'a> {
    fn new(film: &'a Film<'a>) -> Result<Self, FilmError> {
        let mut canvas = Canvas::new(film.size)?;
        let panel = Panel::new(film.size, film.units);
        let (size, unit) = (film.size, film.size.unit());
        let (trajectory, schedule) = (film.trajectory, &film.schedule);
        let camera = Camera::new(
            trajectory,
            schedule,
            film.framing,
            film.window(),
            unit,
            film.scale,
        );
        panel.draw_still(&mut canvas, trajectory, schedule, &film.note);
        if camera.is_still() {
            let view = camera.view(&film.scene(0)?);
            draw_plane(&mut canvas, &view, film.window(), unit, film.units.as_ref());
        }
        let pane = film
            .with
            .map(|with| Pane::new(with, trajectory, schedule, pane_of(size), unit, film.units));
        let pane = pane.transpose()?;
        if let Some(pane) = &pane {
            pane.draw_still(&mut canvas);
        }
        let inset = (!camera.is_still()).then(|| {
            let inset = Inset::new(trajectory, schedule, inset_of(size), unit);
            inset.draw_still(&mut canvas);
            inset
        });
        let ground = canvas.data().to_vec();
        Ok(Self {
            film,
            camera,
            panel,
            canvas,
            trail: Trail::new(),
            pane,
            inset,
            ground,
        })
    }

    fn draw(&mut self, index: u64) -> Result<&[u8], FilmError> {
        let Self {
            film,
            canvas,
            trail,
            ground,
            ..
        } = self;
        let film = *film;
        let scene = film.scene(index)?;
        trail.extend(film.trajectory, &film.schedule, scene.time());
        canvas.copy(ground);
        self.draw_motion(&scene);
        self.restore_surroundings();
        if let Some(pane) = &self.pane {
            pane.draw_moving(&mut self.canvas, &scene.sample);
        }
        if let Some(inset) = &self.inset {
            inset.draw_moving(&mut self.canvas, &scene);
        }
        let is_last = index + 1 == film.schedule.frames && !film.schedule.closes();
        let outcome = is_last.then(|| film.trajectory.outcome());
        let (panel, canvas) = (&self.panel, &mut self.canvas);
        panel.draw_moving(canvas, &scene, &film.schedule, outcome);
        Ok(canvas.data())
    }

    /// The plane if it moves, the hoop with its trail, and the arrows.
    fn draw_motion(&mut self, scene: &Scene) {
        let Self {
            film,
            camera,
            panel,
            canvas,
            trail,
            ..
        } = self;
        let unit = film.size.unit();
        let view = camera.view(scene);
        if !camera.is_still() {
            draw_plane(canvas, &view, film.window(), unit, film.units.as_ref());
        }
        draw_trail(canvas, &view, trail, scene, unit);
        draw_body(canvas, &view, scene, film.trajectory.hoop(), unit);
        draw_contact(canvas, &view, scene, &panel.gap(scene), unit);
        draw_arrows(canvas, &view, scene, unit);
        draw_impulse(canvas, &view, scene, &panel.impulse(scene), unit);
    }

    /// What stands around the window, over which a trail or an arrow may have run.
    fn restore_surroundings(&mut self) {
        let (film, canvas, ground) = (self.film, &mut self.canvas, &self.ground);
        let unit = film.size.unit();
        let all = Window {
            left: 0.0,
            top: 0.0,
            width: f64::from(film.size.width()),
            height: f64::from(film.size.height()),
        };
        if film.with.is_some() {
            let left = libm::round(film.window().width);
            let top = HEAD * unit;
            canvas.restore(ground, Window { left, top, ..all });
        }
        if !self.camera.is_still() {
            canvas.restore(ground, inset_of(film.size));
        }
        let head = Window {
            height: HEAD * unit,
            ..all
        };
        let foot = Window {
            top: all.height - FOOT * unit,
            ..all
        };
        canvas.restore(ground, head);
        canvas.restore(ground, foot);
    }
}

/// The upper end of what stands under the inset.
fn beside_inset(size: FrameSize) -> f64 {
    (INSET_TOP + inset::HEIGHT + 6.0) * size.unit()
}

/// The place of the pane.
fn pane_of(size: FrameSize) -> Window {
    let u = size.unit();
    let (width, height) = (f64::from(size.width()), f64::from(size.height()));
    let top = beside_inset(size);
    Window {
        left: width - PANE * u,
        top,
        width: PANE * u,
        height: height - FOOT * u - top,
    }
}

/// The place of the whole path in small.
fn inset_of(size: FrameSize) -> Window {
    let u = size.unit();
    let width = inset::WIDTH * u;
    Window {
        left: f64::from(size.width()) - width - 12.0 * u,
        top: INSET_TOP * u,
        width,
        height: inset::HEIGHT * u,
    }
}

/// Upper end of the inset, under the clock.
const INSET_TOP: f64 = 35.0;

/// How much slower than the motion the film is.
fn note(pace: &Pace) -> String {
    match pace.units {
        None => format!("{} s of film for √(*R*/*g*)", short(pace.slow)),
        Some(_) if pace.slow == 1.0 => "real time".to_owned(),
        Some(_) if pace.slow > 1.0 => format!("{} × slower than real", short(pace.slow)),
        Some(_) => format!("{} × faster than real", short(1.0 / pace.slow)),
    }
}
