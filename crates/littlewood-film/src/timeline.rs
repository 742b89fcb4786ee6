//! Which time of the motion each second of a film shows: evenly, but slower about the impacts.

use crate::impacts::ShownImpact;

/// Time before and after an impact that is shown slowly, √(R/g).
const AROUND: f64 = 0.06;

/// Seconds of film for the impact itself, which takes no time.
const STILL_S: f64 = 1.2;

/// What a part of a film shows.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Even,
    Slow,
    /// The impact of this number.
    Impact(usize),
}

/// A part of a film: seconds of film, and the times that they show.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Part {
    seconds: [f64; 2],
    times: [f64; 2],
    kind: Kind,
}

/// What a second of the film shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Moment {
    pub(crate) time: f64,
    pub(crate) is_slow: bool,
    /// The impact that is being shown, and which share of it has passed.
    pub(crate) impact: Option<(usize, f64)>,
}

/// The parts of a film.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Timeline {
    parts: Vec<Part>,
}

impl Timeline {
    /// Times from `start` to `end` at so many seconds of film for a unit of time, and at `factor`
    /// times as many about the impacts that are noticeable.
    pub(crate) fn new(
        start: f64,
        end: f64,
        pace: f64,
        factor: f64,
        impacts: &[ShownImpact],
    ) -> Self {
        let shown: Vec<(usize, f64)> = impacts
            .iter()
            .enumerate()
            .filter(|(_, shown)| shown.is_noticeable)
            .map(|(number, shown)| (number, shown.time))
            .collect();
        let mut timeline = Self { parts: Vec::new() };
        let mut from = start;
        for (i, (number, at)) in shown.iter().enumerate() {
            let next = shown.get(i + 1).map_or(end, |(_, next)| 0.5 * (at + next));
            let (begin, stop) = ((at - AROUND).max(from), (at + AROUND).min(next).min(end));
            timeline.push(from, begin, pace, Kind::Even);
            timeline.push(begin, *at, factor * pace, Kind::Slow);
            let still = timeline.seconds();
            let (seconds, times) = ([still, still + STILL_S], [*at, *at]);
            timeline.parts.push(Part {
                seconds,
                times,
                kind: Kind::Impact(*number),
            });
            timeline.push(*at, stop, factor * pace, Kind::Slow);
            from = stop;
        }
        timeline.push(from, end, pace, Kind::Even);
        timeline
    }

    fn push(&mut self, from: f64, to: f64, pace: f64, kind: Kind) {
        if to > from {
            let second = self.seconds();
            self.parts.push(Part {
                seconds: [second, second + pace * (to - from)],
                times: [from, to],
                kind,
            });
        }
    }

    /// Seconds of film.
    pub(crate) fn seconds(&self) -> f64 {
        self.parts.last().map_or(0.0, |part| part.seconds[1])
    }

    /// What a second shows.
    pub(crate) fn moment(&self, second: f64) -> Option<Moment> {
        let after = self.parts.partition_point(|part| part.seconds[0] <= second);
        let part = self.parts.get(after.max(1) - 1)?;
        let share =
            ((second - part.seconds[0]) / (part.seconds[1] - part.seconds[0])).clamp(0.0, 1.0);
        let time = part.times[0] + share * (part.times[1] - part.times[0]);
        Some(match part.kind {
            Kind::Even => Moment {
                time,
                is_slow: false,
                impact: None,
            },
            Kind::Slow => Moment {
                time,
                is_slow: true,
                impact: None,
            },
            Kind::Impact(number) => Moment {
                time,
                is_slow: true,
                impact: Some((number, share)),
            },
        })
    }

    /// The second from which an impact is past, and until which it is shown slowly, if it is.
    pub(crate) fn after(&self, number: usize) -> Option<[f64; 2]> {
        let index = self
            .parts
            .iter()
            .position(|part| part.kind == Kind::Impact(number))?;
        let past = self.parts[index].seconds[1];
        let slow = self
            .parts
            .get(index + 1)
            .filter(|part| part.kind == Kind::Slow);
        Some([past, slow.map_or(past, |part| part.seconds[1])])
    }

    /// The second at which a time is reached.
    pub(crate) fn second(&self, time: f64) -> f64 {
        let part = self
            .parts
            .iter()
            .find(|part| time <= part.times[1])
            .or(self.parts.last());
        part.map_or(0.0, |part| {
            let span = part.times[1] - part.times[0];
            let share = if span > 0.0 {
                (time - part.times[0]) / span
            } else {
                0.0
            };
            part.seconds[0] + share * (part.seconds[1] - part.seconds[0])
        })
    }
}
