//! What an impact does, in words.

use littlewood::impact::{Impact, ImpactCase};
use littlewood::tables::Dimension;
use littlewood::{Hoop, Mode, Trajectory, Transition};

use super::to_the;
use crate::number::{brief, three};
use crate::scale::Scale;
use crate::{ShownImpact, kinetic_energy};

/// A transition with an impact.
pub(super) struct Struck<'a> {
    pub(super) hoop: &'a Hoop,
    /// Of the transition.
    pub(super) index: usize,
    pub(super) event: &'a Transition,
    pub(super) impact: &'a Impact,
    pub(super) scale: Scale<'a>,
}

impl Struck<'_> {
    /// A landing.
    pub(super) fn landing(&self) -> String {
        format!("Lands: {}{}.", self.course(), self.end())
    }

    /// An impact without a collision.
    pub(super) fn jam(&self) -> String {
        let why = match self.event.from {
            None => "no motion is consistent here",
            Some(_) => "the slide has reached P = 0",
        };
        let ends = match (self.event.before.slip == 0.0, self.stops_slipping()) {
            (true, _) => "stops the hoop",
            (false, true) => "ends the slip",
            (false, false) => "ends the rotation",
        };
        format!(
            "Jams: {why}, and the plane {ends} in an impact without a collision (Painlevé){}.",
            self.end()
        )
    }

    /// What is lost, and what follows.
    fn end(&self) -> String {
        let loss = self.loss().map(|loss| format!("; {loss}"));
        loss.unwrap_or_default() + &then(self.event, self.scale)
    }

    fn shown(&self) -> Option<ShownImpact> {
        ShownImpact::of(self.hoop, self.index, self.event)
    }

    /// What the contact point does.
    fn course(&self) -> &'static str {
        let slips = self.shown().is_some_and(|shown| shown.before.slip != 0.0);
        match self.impact.case {
            ImpactCase::None => "touches the plane without an impulse",
            ImpactCase::Slides => "slips throughout",
            ImpactCase::SticksInCompression if slips => {
                "slips, then sticks while it is pressed to the plane"
            }
            ImpactCase::SticksInRestitution if slips => "slips, then sticks while it springs back",
            ImpactCase::SticksInCompression | ImpactCase::SticksInRestitution => {
                "sticks throughout"
            }
            ImpactCase::ReversesInCompression if slips => {
                "slips, then slips the other way while it is pressed to the plane"
            }
            ImpactCase::ReversesInRestitution if slips => {
                "slips, then slips the other way while it springs back"
            }
            ImpactCase::ReversesInCompression | ImpactCase::ReversesInRestitution => {
                "begins to slip while it is pressed to the plane"
            }
            ImpactCase::Jams if slips && self.stops_slipping() => {
                "jams, and the plane presses on it until the slip has ended (Painlevé)"
            }
            ImpactCase::Jams => {
                "jams, and the plane presses on it until the rotation has ended (Painlevé)"
            }
        }
    }

    /// Whether the rim does not slip on in its direction.
    fn stops_slipping(&self) -> bool {
        self.impact.before.slip * self.impact.after.slip <= 0.0
    }

    /// The part of the kinetic energy that is lost, or gained.
    fn loss(&self) -> Option<String> {
        let kinetic = kinetic_energy(self.hoop, self.event.before.theta, &self.impact.before)
            .filter(|energy| *energy > 0.0)?;
        let share = self.shown()?.energy_lost / kinetic;
        Some(if share == 0.0 {
            "none of its kinetic energy is lost".to_owned()
        } else if share < 0.0 {
            format!(
                "its kinetic energy grows by {}, as Newton's law allows where friction changes on the way",
                percent(-share)
            )
        } else {
            format!(
                "{} of its kinetic energy before the impact is lost",
                percent(share)
            )
        })
    }
}

/// The end of bounces, which is transition `index`.
pub(super) fn settling(
    trajectory: &Trajectory,
    index: usize,
    event: &Transition,
    scale: Scale<'_>,
) -> String {
    let before = trajectory.transitions().get(..index).unwrap_or_default();
    let bounces = before.iter().rev().take_while(|it| it.is_bounce()).count();
    let after = match bounces {
        0 => "after infinitely many ever smaller bounces".to_owned(),
        1 => "after a bounce and infinitely many smaller ones".to_owned(),
        _ => format!("after {bounces} bounces and infinitely many smaller ones"),
    };
    format!(
        "Settles: {after}, the rim stays at the plane{}.",
        then(event, scale)
    )
}

/// A part of a whole: `42 %`, `3.1 %`, `99.6 %`.
fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    let digits = match percent {
        it if it < 0.01 => return "less than 0.01 %".to_owned(),
        it if it < 9.95 => format!("{percent:.1e}")
            .parse()
            .map_or_else(|_| brief(percent), brief),
        it if it < 99.0 => format!("{percent:.0}"),
        _ => format!("{percent:.1}"),
    };
    format!("{digits} %")
}

/// What follows.
fn then(event: &Transition, scale: Scale<'_>) -> String {
    match event.to {
        Some(Mode::Flight) => {
            let rate = event.impact.map_or(0.0, |impact| impact.after.gap_rate);
            let rate = scale.show_with_unit(Dimension::Velocity, three(rate));
            format!(", and the rim leaves the plane at {rate}")
        }
        Some(Mode::Rolling) => ", and it rolls".to_owned(),
        Some(Mode::Sliding) if event.after.slip == 0.0 => ", and it begins to slide".to_owned(),
        Some(Mode::Sliding) => format!(", and it slides {}", to_the(event.after.slip)),
        Some(Mode::Gliding) => ", and it glides".to_owned(),
        Some(Mode::Rest) => ", and it rests".to_owned(),
        Some(Mode::Skidding) => format!(", and it skids {}", to_the(event.after.slip)),
        None => String::new(),
    }
}
