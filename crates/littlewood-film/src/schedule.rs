//! Which instant each frame shows, and for how long.

use littlewood::modes::RecurrenceKind;
use littlewood::si::Units;
use littlewood::{OutcomeKind, Trajectory, Transition};

use crate::error::FilmError;
use crate::impacts::ShownImpact;

/// Most frames of a film: at 25 frames per second more than an hour.
const MOST_FRAMES: u64 = 100_000;

/// Greatest rate of frames.
pub(crate) const MOST_FPS: u32 = 240;

/// Longest time that the last picture stays, in seconds.
const LONGEST_HOLD: f64 = 60.0;

/// Transitions shown of a motion that bounces until it is stopped.
const BOUNCES: usize = 8;

/// Seconds for which an impulse stays in the picture.
const STAYS_S: f64 = 0.8;

/// Time shown of a motion that lasts for ever and has no period.
const HORIZON: f64 = 10.0;

/// Time after which the rest of a hoop is not waited for.
const LONG: f64 = 120.0;

/// Time after which a motion that lasts for ever is not waited for to come to its last phase, or to
/// the end of a period.
const PATIENCE: f64 = 30.0;

/// What a film shows of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// All of it.
    Whole,
    /// An oscillation, at whose end it is where it began.
    Period,
    /// Two periods of what lasts for ever.
    TwoPeriods,
    /// A while of what lasts for ever.
    While,
    /// Some bounces of a motion that bounces until it is stopped.
    Bounces,
    /// A while of what comes to rest much later.
    BeforeRest,
}

impl Part {
    /// In words; none for the whole.
    pub const fn label(self) -> Option<&'static str> {
        match self {
            Self::Whole => None,
            Self::Period => Some("one period of a motion without end"),
            Self::TwoPeriods => Some("two periods of a motion without end"),
            Self::While => Some("the beginning of a motion without end"),
            Self::Bounces => Some("the first bounces of many"),
            Self::BeforeRest => Some("the beginning of a motion that comes to rest"),
        }
    }
}

/// How a film runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// Frames per second.
    pub fps: u32,
    /// Seconds of film for a unit of time √(R/g); with `units`, for a second of the motion.
    pub slow: f64,
    /// Units, if the film shows seconds, metres and newtons.
    pub units: Option<Units>,
    /// Time for which the last picture stays, in seconds; the default is 1.5, and 0 for a film that
    /// closes.
    pub hold_s: Option<f64>,
}

impl Pace {
    /// Seconds of film for a unit of dimensionless time.
    fn seconds(&self) -> f64 {
        self.units
            .map_or(self.slow, |units| self.slow * units.time_s)
    }
}

/// The instants of the frames.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// First instant.
    pub start: f64,
    /// Last instant of the motion that is shown.
    pub end: f64,
    /// Where the line of time ends: beside a longer motion later than this one.
    pub line_end: f64,
    /// Dimensionless time from frame to frame.
    pub step: f64,
    /// Frames per second.
    pub fps: u32,
    /// Number of frames.
    pub frames: u64,
    /// What the film shows of the motion.
    pub part: Part,
    hold_ms: u32,
}

/// When a frame is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shown {
    /// Number of the frame, from 0.
    pub index: u64,
    /// Frames per second.
    pub fps: u32,
    /// Time for which the frame stays longer than others, in milliseconds.
    pub hold_ms: u32,
}

impl Schedule {
    /// Frames from the start of a motion to its end. A motion without an end is shown for a whole
    /// oscillation, so that the film closes, for two turns, or for ten units of time; one that comes
    /// to rest for a tenth longer than it moved.
    ///
    /// # Errors
    /// A rate, a slowness or a hold out of bounds, no motion, or too many frames.
    pub fn new(trajectory: &Trajectory, pace: &Pace) -> Result<Self, FilmError> {
        let Pace { fps, slow, .. } = *pace;
        if !(1..=MOST_FPS).contains(&fps) {
            return Err(FilmError::FrameRate {
                fps,
                most: MOST_FPS,
                format: "a film",
            });
        }
        if !(slow.is_finite() && slow > 0.0) {
            return Err(FilmError::Slow { slow });
        }
        if trajectory.phases().is_empty() {
            return Err(FilmError::NoMotion {
                outcome: trajectory.outcome().kind(),
            });
        }
        let start = trajectory.start().time;
        let (end, part) = shown_until(trajectory);
        let closes = part == Part::Period;
        let seconds = (end - start) * pace.seconds();
        let intervals = libm::ceil(seconds * f64::from(fps) - 1e-9).max(0.0);
        let frames = intervals + if closes { 0.0 } else { 1.0 };
        if frames > MOST_FRAMES as f64 {
            return Err(FilmError::TooLong {
                frames,
                most: MOST_FRAMES,
            });
        }
        let hold_s = pace.hold_s.unwrap_or(if closes { 0.0 } else { 1.5 });
        if !(0.0..=LONGEST_HOLD).contains(&hold_s) {
            return Err(FilmError::Hold {
                hold_s,
                most_s: LONGEST_HOLD,
            });
        }
        Ok(Self {
            start,
            end,
            line_end: end,
            step: 1.0 / (pace.seconds() * f64::from(fps)),
            fps,
            frames: frames.max(1.0) as u64,
            hold_ms: libm::round(1e3 * hold_s) as u32,
            part,
        })
    }

    /// The same in a film of so many frames, no fewer: a motion without an end goes on.
    pub(crate) fn go_on(&self, trajectory: &Trajectory, frames: u64) -> Self {
        let line_end = (self.start + frames.saturating_sub(1) as f64 * self.step).max(self.end);
        let is_endless = !trajectory.end_time().is_finite();
        Self {
            end: if is_endless { line_end } else { self.end },
            line_end,
            frames,
            part: match self.part {
                // Beside another motion no period is whole.
                Part::Period | Part::TwoPeriods => Part::While,
                part => part,
            },
            ..*self
        }
    }

    /// Whether the film goes on with its first frame after the last, because the motion comes back
    /// to its start.
    pub const fn closes(&self) -> bool {
        matches!(self.part, Part::Period)
    }

    /// The instant that a frame shows. The last is the end of the motion, to the last bit; it comes
    /// less than a frame late.
    pub fn time(&self, index: u64) -> f64 {
        if index + 1 >= self.frames && !self.closes() {
            return self.end;
        }
        (self.start + index as f64 * self.step).min(self.end)
    }

    /// Whether the impulse of an impact is still in the picture at a frame: for a short while.
    pub(crate) fn shows(&self, index: u64, impact: &ShownImpact) -> bool {
        let fps = f64::from(self.fps);
        let since = index as f64 / fps - (impact.time - self.start) / (self.step * fps);
        (0.0..=STAYS_S).contains(&since)
    }

    /// When a frame is shown.
    pub const fn shown(&self, index: u64) -> Shown {
        let is_last = index + 1 == self.frames;
        Shown {
            index,
            fps: self.fps,
            hold_ms: if is_last { self.hold_ms } else { 0 },
        }
    }
}

impl Shown {
    /// Duration in hundredths of a second, such that no error adds up over the frames.
    pub fn centiseconds(&self) -> u64 {
        let until = |frames: u64| rounded(100 * frames, u64::from(self.fps));
        until(self.index + 1) - until(self.index) + rounded(u64::from(self.hold_ms), 10)
    }

    /// How often a film without durations repeats the frame.
    pub fn copies(&self) -> u64 {
        1 + rounded(u64::from(self.hold_ms) * u64::from(self.fps), 1000)
    }
}

/// The whole number nearest to a fraction.
const fn rounded(numerator: u64, denominator: u64) -> u64 {
    (2 * numerator + denominator) / (2 * denominator)
}

/// Up to when a motion is shown, and what that is of it.
fn shown_until(trajectory: &Trajectory) -> (f64, Part) {
    let end = trajectory.end_time();
    let outcome = trajectory.outcome();
    if outcome.kind() == OutcomeKind::TransitionLimit && trajectory.hoop().restitution().is_some() {
        let stopped = trajectory.transitions().get(BOUNCES).map(Transition::time);
        return stopped.map_or((end, Part::Whole), |stopped| (stopped, Part::Bounces));
    }
    if end.is_finite() {
        return (end, Part::Whole);
    }
    let start = trajectory.start().time;
    let since = outcome.state().time;
    if let Some(until) = trajectory.rest_shown_until() {
        return if since - start > LONG {
            (start + PATIENCE, Part::BeforeRest)
        } else {
            (until, Part::Whole)
        };
    }
    let period = outcome.recurrence().and_then(|recurrence| {
        Some((
            recurrence.kind(),
            recurrence.period().filter(|period| period.is_finite())?,
        ))
    });
    let (until, part) = match period {
        None => (since + HORIZON, Part::While),
        // The hoop that rolls back and forth is back at its place; the one that slides has moved
        // on.
        Some((RecurrenceKind::Libration, period))
            if outcome.kind() == OutcomeKind::RollsForever && trajectory.phases().len() == 1 =>
        {
            (since + period, Part::Period)
        }
        Some((_, period)) => (since + 2.0 * period, Part::TwoPeriods),
    };
    if until - start > PATIENCE && part != Part::Period {
        return (start + PATIENCE, Part::While);
    }
    (until, part)
}
