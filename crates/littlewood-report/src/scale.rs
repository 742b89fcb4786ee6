//! The system of units that a person sees: none (2.9), or SI.

use littlewood::{State, Units};

use crate::number::brief;

/// A system of units.
#[derive(Clone, Copy, Debug)]
pub struct Scale<'a>(Option<&'a Units>);

impl<'a> Scale<'a> {
    /// That of these units; none for the dimensionless system.
    #[must_use]
    pub const fn new(units: Option<&'a Units>) -> Self {
        Self(units)
    }

    /// Symbols of τ, θ′ and η′, and of the height of the rim.
    #[must_use]
    pub const fn symbols(self) -> Symbols {
        match self.0 {
            None => Symbols { time: "τ", theta_rate: "θ′", slip: "η′" },
            Some(_) => Symbols { time: "t", theta_rate: "dθ/dt", slip: "dη/dt" },
        }
    }

    /// Labels of columns with their units.
    #[must_use]
    pub const fn columns(self) -> [&'static str; 6] {
        match self.0 {
            None => ["from τ", "duration", "θ", "θ′", "η′", "lost"],
            Some(_) => {
                ["from t\n[s]", "duration\n[s]", "θ\n[rad]", "dθ/dt\n[rad/s]", "dη/dt\n[m/s]", "lost\n[J]"]
            }
        }
    }

    /// A time in this system.
    #[must_use]
    pub fn time(self, value: f64) -> f64 {
        self.0.map_or(value, |units| value * units.time_s)
    }

    /// A rate of turning in this system.
    #[must_use]
    pub fn rate(self, value: f64) -> f64 {
        self.0.map_or(value, |units| value / units.time_s)
    }

    /// A velocity in this system.
    #[must_use]
    pub fn velocity(self, value: f64) -> f64 {
        self.0.map_or(value, |units| value * units.velocity_m_per_s())
    }

    /// An energy in this system.
    #[must_use]
    pub fn energy(self, value: f64) -> f64 {
        self.0.map_or(value, |units| value * units.energy_j())
    }

    /// A time with its unit.
    #[must_use]
    pub fn show_time(self, value: f64) -> String {
        self.show(self.time(value), "s")
    }

    /// A length of time in words: dimensionless times have the unit √(R/g).
    #[must_use]
    pub fn show_duration(self, value: f64) -> String {
        match self.0 {
            None => format!("{} √(R/g)", brief(value)),
            Some(units) => format!("{} s", brief(value * units.time_s)),
        }
    }

    /// A velocity in words: dimensionless velocities have the unit √(g R).
    #[must_use]
    pub fn show_speed(self, value: f64) -> String {
        match self.0 {
            None => format!("{} √(g R)", brief(value)),
            Some(_) => self.show_velocity(value),
        }
    }

    /// A length with its unit.
    #[must_use]
    pub fn show_length(self, value: f64) -> String {
        match self.0 {
            None if value == 0.0 => "0".to_owned(),
            None => format!("{} R", brief(value)),
            Some(units) => format!("{} m", brief(value * units.length_m)),
        }
    }

    /// A velocity with its unit.
    #[must_use]
    pub fn show_velocity(self, value: f64) -> String {
        self.show(self.velocity(value), "m/s")
    }

    /// A rate of turning with its unit.
    #[must_use]
    pub fn show_rate(self, value: f64) -> String {
        self.show(self.rate(value), "rad/s")
    }

    /// A force with its unit.
    #[must_use]
    pub fn show_force(self, value: f64) -> String {
        match self.0 {
            None => format!("{} m2 g", brief(value)),
            Some(units) => format!("{} N", brief(value * units.force_n())),
        }
    }

    /// An energy with its unit.
    #[must_use]
    pub fn show_energy(self, value: f64) -> String {
        match self.0 {
            None => format!("{} m2 g R", brief(value)),
            Some(units) => format!("{} J", brief(value * units.energy_j())),
        }
    }

    /// θ, θ′ and η′.
    #[must_use]
    pub fn show_motion(self, state: &State) -> String {
        let Symbols { theta_rate, slip, .. } = self.symbols();
        format!(
            "{}  {theta_rate} = {}  {slip} = {}",
            self.show_angle(state.theta),
            self.show_rate(state.theta_rate),
            self.show_velocity(state.slip),
        )
    }

    /// θ in radians and in degrees.
    #[must_use]
    pub fn show_angle(self, theta: f64) -> String {
        let degrees = brief((theta.to_degrees() * 10.0).round() / 10.0);
        format!("θ = {} ({degrees}°)", self.show(theta, "rad"))
    }

    fn show(self, value: f64, unit: &str) -> String {
        match self.0 {
            None => brief(value),
            Some(_) => format!("{} {unit}", brief(value)),
        }
    }
}

/// The symbols of the paper, or of their counterparts with dimensions.
#[derive(Clone, Copy, Debug)]
pub struct Symbols {
    /// τ.
    pub time: &'static str,
    /// θ′.
    pub theta_rate: &'static str,
    /// η′.
    pub slip: &'static str,
}
