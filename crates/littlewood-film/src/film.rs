//! A film: a motion, and how it is shown.

use littlewood::si::Units;
use littlewood::tables::Dimension;
use littlewood::{Mode, Phase, Trajectory};
use littlewood_draw::Image;

use crate::body::{draw_arrows, draw_body, draw_course, draw_impulse, draw_trail};
use crate::camera::{Camera, EXAMINED, Framing, Window};
use crate::canvas::Canvas;
use crate::colour::{self, PAPER};
use crate::encoder::Encoder;
use crate::error::FilmError;
use crate::ground::{draw_contact, draw_plane};
use crate::impacts::ShownImpact;
use crate::inset::{self, Inset};
use crate::pane::{PANE, Pane, With};
use crate::panel::{FOOT, HEAD, Name, Panel, short};
use crate::scene::{ArrowScale, DrawnImpulse, Scene};
use crate::schedule::{Pace, Schedule};
use crate::size::FrameSize;
use crate::trail::Trail;

/// A film of a motion, or of two in the same clock, one over the other.
///
/// Frames are drawn one after the other and handed to an [`Encoder`]; at most one is kept.
#[derive(Debug)]
pub struct Film<'a> {
    /// From the top.
    lanes: Vec<Lane<'a>>,
    size: FrameSize,
}

/// A motion in its part of the picture, from one side to the other.
#[derive(Debug)]
struct Lane<'a> {
    trajectory: &'a Trajectory,
    schedule: Schedule,
    scale: ArrowScale,
    size: FrameSize,
    framing: Framing,
    units: Option<Units>,
    note: String,
    impacts: Vec<ShownImpact>,
    with: Option<With>,
    name: Option<Name>,
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
        let lane = Lane {
            trajectory,
            schedule,
            scale,
            size,
            framing,
            units: pace.units,
            note: note(pace),
            impacts,
            with: None,
            name: None,
        };
        Ok(Self {
            lanes: vec![lane],
            size,
        })
    }

    /// The same film with a pane beside the hoop in which the motion runs along.
    #[must_use]
    pub fn with_pane(mut self, with: With) -> Self {
        for lane in &mut self.lanes {
            lane.with = Some(with);
        }
        self
    }

    /// This film over another of the same pace, in one clock, each with its name: the lanes have
    /// one scale of lengths and of arrows. A motion that ends before the other stays where it is,
    /// one without an end goes on as long as the other.
    ///
    /// ```
    /// use littlewood::cases::find_case;
    /// use littlewood_film::{Film, FrameSize, Framing, Pace};
    ///
    /// let size = FrameSize::new(640, 600)?;
    /// let pace = Pace { fps: 5, slow: 1.0, units: None, hold_s: None };
    /// let [a, b] = ["figure-3", "figure-7"].map(|name| find_case(name).expect("a named case").simulate());
    /// let (a, b) = (a?, b?);
    /// let film = |motion| Film::new(motion, &pace, size, Framing::Auto);
    /// let both = film(&a)?.over(film(&b)?, ["figure-3", "figure-7"])?;
    /// assert_eq!(both.still(0)?.len(), 4 * 640 * 600);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A picture that has no room for two, or only one film in SI units.
    // One name for each lane, from the top.
    pub fn over(mut self, other: Self, names: [&str; 2]) -> Result<Self, FilmError> {
        let size = FrameSize::new(self.size.width(), self.size.height() / 2)
            .map_err(|_| FilmError::NoRoomForTwo { size: self.size })?;
        self.lanes.extend(other.lanes);
        if self
            .lanes
            .iter()
            .any(|lane| lane.units.is_some() != self.lanes[0].units.is_some())
        {
            return Err(FilmError::TwoClocks);
        }
        let frames = self.lanes.iter().map(|lane| lane.schedule.frames);
        let frames = frames.max().unwrap_or_default();
        let of_all =
            |part: fn(&Lane<'_>) -> f64| self.lanes.iter().map(part).fold(f64::INFINITY, f64::min);
        let (force, velocity, impulse) = (
            of_all(|lane| lane.scale.force / lane.worth(Dimension::Force)),
            of_all(|lane| lane.scale.velocity / lane.worth(Dimension::Velocity)),
            of_all(|lane| lane.scale.impulse / lane.worth(Dimension::Impulse)),
        );
        for ((lane, words), colour) in self.lanes.iter_mut().zip(names).zip(colour::LANES) {
            lane.schedule = lane.schedule.go_on(lane.trajectory, frames);
            lane.scale.force = force * lane.worth(Dimension::Force);
            lane.scale.velocity = velocity * lane.worth(Dimension::Velocity);
            lane.scale.impulse = impulse * lane.worth(Dimension::Impulse);
            lane.impacts = ShownImpact::all(lane.trajectory, lane.schedule.end);
            lane.size = size;
            lane.name = Some(Name {
                words: words.to_owned(),
                colour,
            });
        }
        Ok(self)
    }

    /// Whether impulses or energies are drawn, which have inks of their own.
    pub(crate) fn has_energies(&self) -> bool {
        let has =
            |lane: &Lane<'_>| !lane.impacts.is_empty() || matches!(lane.with, Some(With::Energy));
        self.lanes.iter().any(has)
    }

    /// Whether there are two lanes, which have inks of their own.
    pub(crate) const fn has_lanes(&self) -> bool {
        self.lanes.len() > 1
    }

    /// The upper lane, or the only one.
    fn first(&self) -> &Lane<'a> {
        &self.lanes[0]
    }

    /// The instants of the frames, of two motions those of the upper one.
    pub fn schedule(&self) -> &Schedule {
        &self.first().schedule
    }

    /// Lengths of the arrows.
    pub fn scale(&self) -> ArrowScale {
        self.first().scale
    }

    /// Size of the frames.
    pub const fn size(&self) -> FrameSize {
        self.size
    }

    /// What a frame shows, of two motions the upper one.
    ///
    /// # Errors
    /// None of a film that could be made.
    pub fn scene(&self, index: u64) -> Result<Scene, FilmError> {
        self.first().scene(index)
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
        let mut frame = Frame::new(self)?;
        let schedule = self.schedule();
        let total = schedule.frames;
        for index in 0..total {
            if !watch(index) {
                return Err(FilmError::Stopped { done: index, total });
            }
            encoder.frame(frame.draw(index)?, schedule.shown(index))?;
        }
        watch(total);
        Ok(())
    }

    /// A single frame: red, green, blue and 255 for each pixel, row by row.
    ///
    /// # Errors
    /// None of a film that could be made.
    pub fn still(&self, index: u64) -> Result<Vec<u8>, FilmError> {
        Ok(Frame::new(self)?.draw(index)?.to_vec())
    }

    /// The frame that tells most of the motion, of two of the upper one: in the middle of its
    /// longest flight, or of its last phase that is shown.
    pub fn telling(&self) -> u64 {
        let Lane {
            trajectory,
            schedule,
            ..
        } = self.first();
        let shown = || {
            let phases = trajectory.phases().iter();
            phases.filter(|phase| phase.start().time < schedule.end)
        };
        let length = |phase: &Phase| phase.end_time().min(schedule.end) - phase.start().time;
        let flight = shown()
            .filter(|phase| phase.mode() == Mode::Flight)
            .max_by(|a, b| length(a).total_cmp(&length(b)));
        let middle = flight.or_else(|| shown().next_back()).map_or(0.0, |phase| {
            phase.start().time + 0.5 * length(phase) - schedule.start
        });
        (libm::round(middle / schedule.step) as u64).min(schedule.frames.saturating_sub(1))
    }

    /// A single frame as a PNG file.
    ///
    /// # Errors
    /// None of a film that could be made.
    pub fn png(&self, index: u64) -> Result<Vec<u8>, FilmError> {
        let pixels = self.still(index)?;
        let image = Image {
            size: [self.size.width(), self.size.height()].map(|side| side as usize),
            pixels: pixels
                .as_chunks::<4>()
                .0
                .iter()
                .flat_map(|&[red, green, blue, _]| [red, green, blue])
                .collect(),
        };
        Ok(image.png())
    }

    /// How each lane is looked at: with one scale.
    fn cameras(&self) -> Vec<Camera> {
        let seen = |framing: Framing| -> Vec<Camera> {
            self.lanes.iter().map(|lane| lane.camera(framing)).collect()
        };
        if !self.has_lanes() {
            return seen(self.first().framing);
        }
        let lengths: Vec<f64> = self
            .lanes
            .iter()
            .map(|lane| lane.worth(Dimension::Length))
            .collect();
        let mut cameras = seen(self.first().framing);
        let is_whole = cameras.iter().all(Camera::is_still) && Camera::join(&mut cameras, &lengths);
        if !is_whole {
            cameras = seen(Framing::Follow);
            Camera::join(&mut cameras, &lengths);
        }
        cameras
    }
}

impl<'a> Lane<'a> {
    /// What a unit of (2.9) is worth in the units of the film.
    fn worth(&self, dimension: Dimension) -> f64 {
        self.units.map_or(1.0, |units| units.unit(dimension))
    }

    fn camera(&self, framing: Framing) -> Camera {
        Camera::new(
            self.trajectory,
            &self.schedule,
            framing,
            self.window(),
            self.size.unit(),
            self.scale,
        )
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

    /// What a frame shows.
    fn scene(&self, index: u64) -> Result<Scene, FilmError> {
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
}

/// The frame that is being drawn: the lanes one over the other.
struct Frame<'a> {
    reels: Vec<Reel<'a>>,
    /// Of two lanes.
    pixels: Vec<u8>,
}

impl<'a> Frame<'a> {
    fn new(film: &'a Film<'a>) -> Result<Self, FilmError> {
        let cameras = film.cameras();
        let lanes = film.lanes.iter().zip(cameras);
        let reels = lanes.map(|(lane, camera)| Reel::new(lane, camera));
        let pixels = if film.has_lanes() {
            vec![u8::MAX; 4 * film.size.area()]
        } else {
            Vec::new()
        };
        Ok(Self {
            reels: reels.collect::<Result<_, _>>()?,
            pixels,
        })
    }

    fn draw(&mut self, index: u64) -> Result<&[u8], FilmError> {
        let Self { reels, pixels } = self;
        if pixels.is_empty() {
            return reels[0].draw(index);
        }
        let mut from = 0;
        for reel in reels {
            let drawn = reel.draw(index)?;
            pixels[from..from + drawn.len()].copy_from_slice(drawn);
            from += drawn.len();
        }
        Ok(pixels)
    }
}

/// The lane that is being drawn, and what it shares with the frames before it.
struct Reel<'a> {
    lane: &'a Lane<'a>,
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
    fn new(lane: &'a Lane<'a>, camera: Camera) -> Result<Self, FilmError> {
        let mut canvas = Canvas::new(lane.size)?;
        let panel = Panel::new(lane.size, lane.units);
        let (size, unit) = (lane.size, lane.size.unit());
        let (trajectory, schedule) = (lane.trajectory, &lane.schedule);
        if camera.is_still() {
            // So that the first frame, which players show before they play, tells the motion.
            let course = trajectory.sample_evenly(EXAMINED, schedule.end);
            draw_course(&mut canvas, &camera.view(&lane.scene(0)?), course, unit);
        }
        panel.draw_still(&mut canvas, trajectory, schedule, &lane.note);
        if let Some(name) = &lane.name {
            panel.draw_name(&mut canvas, name);
        }
        if camera.is_still() {
            let view = camera.view(&lane.scene(0)?);
            draw_plane(&mut canvas, &view, lane.window(), unit, lane.units.as_ref());
        }
        let pane = lane
            .with
            .map(|with| Pane::new(with, trajectory, schedule, pane_of(size), unit, lane.units));
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
            lane,
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
            lane,
            canvas,
            trail,
            ground,
            ..
        } = self;
        let lane = *lane;
        let scene = lane.scene(index)?;
        trail.extend(lane.trajectory, &lane.schedule, scene.time());
        canvas.copy(ground);
        self.draw_motion(&scene);
        self.restore_surroundings();
        if let Some(pane) = &self.pane {
            pane.draw_moving(&mut self.canvas, &scene.sample);
        }
        if let Some(inset) = &self.inset {
            inset.draw_moving(&mut self.canvas, &scene);
        }
        let is_over = scene.time() == lane.schedule.end && !lane.schedule.closes();
        let outcome = is_over.then(|| lane.trajectory.outcome());
        let (panel, canvas) = (&self.panel, &mut self.canvas);
        panel.draw_moving(canvas, &scene, &lane.schedule, outcome);
        Ok(canvas.data())
    }

    /// The plane if it moves, the hoop with its trail, and the arrows.
    fn draw_motion(&mut self, scene: &Scene) {
        let Self {
            lane,
            camera,
            panel,
            canvas,
            trail,
            ..
        } = self;
        let unit = lane.size.unit();
        let view = camera.view(scene);
        if !camera.is_still() {
            draw_plane(canvas, &view, lane.window(), unit, lane.units.as_ref());
        }
        draw_trail(canvas, &view, trail, scene, unit);
        // Pale, so that the marks on it are seen.
        let rim = lane.name.as_ref().map(|name| name.colour.over(PAPER, 0.5));
        draw_body(canvas, &view, scene, lane.trajectory.hoop(), rim, unit);
        draw_contact(canvas, &view, scene, &panel.gap(scene), unit);
        draw_arrows(canvas, &view, scene, unit);
        draw_impulse(canvas, &view, scene, &panel.impulse(scene), unit);
    }

    /// What stands around the window, over which a trail or an arrow may have run.
    fn restore_surroundings(&mut self) {
        let (lane, canvas, ground) = (self.lane, &mut self.canvas, &self.ground);
        let unit = lane.size.unit();
        let all = Window {
            left: 0.0,
            top: 0.0,
            width: f64::from(lane.size.width()),
            height: f64::from(lane.size.height()),
        };
        if lane.with.is_some() {
            let left = libm::round(lane.window().width);
            let top = HEAD * unit;
            canvas.restore(ground, Window { left, top, ..all });
        }
        if !self.camera.is_still() {
            canvas.restore(ground, inset_of(lane.size));
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
