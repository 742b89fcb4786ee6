//! The body: a hoop or disc with a particle fixed to it, in the dimensionless parameters of (2.9).

use crate::math::number::Number;
use crate::model::{
    Bound, MIN_INERTIA, MIN_MASSLESS_OFFSET, ParameterError, Quantity, Restitution, RestitutionLaw,
    getters, setters, within,
};

/// The unchecked parameters of a hoop. [`Hoop::new`] checks them.
///
/// ```
/// use littlewood::{Hoop, HoopParameters};
///
/// // A homogeneous disc with the mass of the particle, which is halfway to the rim: I_zz = ½ m1 R².
/// let disc = HoopParameters::thin(1.0).with_offset(0.5).with_inertia(0.5).with_friction(0.5, 0.4);
/// assert_eq!(Hoop::new(disc)?.offset(), 0.5);
/// # Ok::<(), littlewood::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct HoopParameters {
    /// Mass of the disc over that of the particle, m̂1 = m1/m2 ≥ 0.
    pub mass_ratio: f64,
    /// Distance of the particle from the centre over the radius, 0 ≤ ℓ̂ = ℓ/R ≤ 1.
    pub offset: f64,
    /// Moment of inertia of the disc about its centre, Î_zz = I_zz/(m2 R²) ≥ 0.
    pub inertia: f64,
    /// Coefficient of static friction, μs ≥ μk.
    pub mu_s: f64,
    /// Coefficient of kinetic friction, μk ≥ 0.
    pub mu_k: f64,
    /// Coefficient of rolling resistance over the radius, χ ≥ 0.
    #[cfg_attr(feature = "serde", serde(default))]
    pub rolling_resistance: f64,
    /// Angle α by which the plane rises to the right, |α| < π/2.
    #[cfg_attr(feature = "serde", serde(default))]
    pub slope: f64,
    /// Coefficient of restitution 0 ≤ e ≤ 1; without one a motion ends at a landing.
    pub restitution: Option<f64>,
    /// Law of restitution; `None` with a coefficient is the energetic law.
    pub restitution_law: Option<RestitutionLaw>,
}

impl HoopParameters {
    /// A thin hoop of this mass ratio m̂1 with the particle on its rim, without friction: ℓ = R,
    /// I_zz = m1 R². Other bodies have another offset and moment of inertia.
    #[must_use]
    pub const fn thin(mass_ratio: f64) -> Self {
        Self {
            mass_ratio,
            offset: 1.0,
            inertia: mass_ratio,
            mu_s: 0.0,
            mu_k: 0.0,
            rolling_resistance: 0.0,
            slope: 0.0,
            restitution: None,
            restitution_law: None,
        }
    }

    /// The same hoop with this coefficient and law of restitution: its motion continues after a
    /// landing.
    #[must_use]
    pub const fn with_restitution(self, coefficient: f64, law: RestitutionLaw) -> Self {
        Self {
            restitution: Some(coefficient),
            restitution_law: Some(law),
            ..self
        }
    }
}

setters! {
    HoopParameters:
    /// The same hoop with the particle at this distance ℓ̂ from the centre.
    with_offset(offset: f64);
    /// The same hoop with this moment of inertia Î_zz of the disc about its centre.
    with_inertia(inertia: f64);
    /// The same hoop with these coefficients of static and kinetic friction.
    with_friction(mu_s: f64, mu_k: f64);
    /// The same hoop with this coefficient χ of rolling resistance.
    with_rolling_resistance(rolling_resistance: f64);
    /// The same hoop on a plane that rises to the right by this angle α.
    with_slope(slope: f64);
}

/// A hoop with checked parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hoop {
    parameters: HoopParameters,
    body: Body,
    restitution: Option<Restitution>,
}

/// The two bodies of the paper, with different equations: with inertia (§2) and without (§3).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Body {
    /// Î > 0: rolls, slides and flies.
    Heavy(Heavy),
    /// Î = 0 and m̂1 = 0: rolls and glides.
    Massless(Massless),
}

/// A hoop with inertia; its mass ratio may be 0. Constructed by [`Hoop::new`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Heavy<T = f64> {
    /// Total mass m = 1 + m̂1.
    pub mass: T,
    /// Distance of the mass centre from the geometric centre, h = ℓ̂/m (2.4).
    pub h: T,
    /// Offset of the particle, ℓ̂ = m h.
    pub offset: T,
    /// Moment of inertia about the mass centre, Î = Î_zz + m̂1 ℓ̂²/(1 + m̂1) (2.1).
    pub inertia: T,
    /// Gravity along the plane over that normal to it, tan α; −0 on a level plane, so that every
    /// sum with it is unchanged.
    pub tilt: T,
}

/// The coefficients of static and kinetic friction and of rolling resistance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Friction<T = f64> {
    pub(crate) mu_s: T,
    pub(crate) mu_k: T,
    pub(crate) rolling_resistance: T,
}

/// What a body is made of: mass ratio m̂1, offset ℓ̂ and moment of inertia Î_zz.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Composition<T = f64> {
    pub(crate) mass_ratio: T,
    pub(crate) offset: T,
    pub(crate) inertia: T,
}

/// Littlewood's hoop: no mass, no inertia, a particle at 0 < ℓ̂ ≤ 1. Constructed by [`Hoop::new`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Massless {
    /// Offset of the particle, ℓ̂ = h. Littlewood has ℓ̂ = 1; footnote 7 of the paper relaxes it.
    pub offset: f64,
    /// Gravity along the plane over that normal to it, as in [`Heavy`].
    pub tilt: f64,
}

impl Restitution {
    /// A coefficient with a law.
    ///
    /// # Errors
    /// A coefficient outside [0, 1].
    pub fn new(coefficient: f64, law: RestitutionLaw) -> Result<Self, ParameterError> {
        Ok(Self {
            coefficient: Quantity::Restitution.check(coefficient)?,
            law,
        })
    }
}

getters! {
    Hoop, [self]:
    /// The parameters.
    pub parameters: HoopParameters = self.parameters;
    /// Mass ratio m̂1 = m1/m2.
    pub mass_ratio: f64 = self.parameters.mass_ratio;
    /// Offset ℓ̂ = ℓ/R.
    pub offset: f64 = self.parameters.offset;
    /// Moment of inertia Î_zz of the disc about its centre.
    pub inertia: f64 = self.parameters.inertia;
    /// Coefficient of static friction μs.
    pub mu_s: f64 = self.parameters.mu_s;
    /// Coefficient of kinetic friction μk.
    pub mu_k: f64 = self.parameters.mu_k;
    /// Coefficient χ of rolling resistance.
    pub rolling_resistance: f64 = self.parameters.rolling_resistance;
    /// Slope α of the plane.
    pub slope: f64 = self.parameters.slope;
    /// The restitution of an impact; `None` if a motion ends at a landing.
    pub restitution: Option<Restitution> = self.restitution;
    pub(crate) friction: Friction = Friction {
        mu_s: self.parameters.mu_s,
        mu_k: self.parameters.mu_k,
        rolling_resistance: self.parameters.rolling_resistance,
    };
    /// The body with or without inertia.
    pub body: Body = self.body;
    /// Total mass m = 1 + m̂1.
    pub mass: f64 = 1.0 + self.parameters.mass_ratio;
    /// Distance of the mass centre from the geometric centre, h = ℓ̂/m (2.4).
    pub h: f64 = self.parameters.offset / self.mass();
}

impl Hoop {
    /// Checks the parameters: finite, m̂1 ≥ 0, 0 ≤ ℓ̂ ≤ 1, Î_zz ≥ 0, 0 ≤ μk ≤ μs, χ ≥ 0, |α| < π/2,
    /// 0 ≤ e ≤ 1, and a body that can move.
    ///
    /// # Errors
    /// The first value that violates a bound; ℓ̂ = 0 with Î = 0 ([`ParameterError::NoMotion`]); 0 <
    /// Î < 1e-60; 0 < ℓ̂ < 1e-60 of a massless hoop; a law of restitution without a coefficient; a massless hoop with a coefficient of
    /// restitution.
    pub fn new(parameters: HoopParameters) -> Result<Self, ParameterError> {
        let composition = Composition {
            mass_ratio: Quantity::MassRatio.check(parameters.mass_ratio)?,
            offset: Quantity::Offset.check(parameters.offset)?,
            inertia: Quantity::Inertia.check(parameters.inertia)?,
        };
        let mu_s = Quantity::MuS.check(parameters.mu_s)?;
        let mu_k = Quantity::MuK.check(parameters.mu_k)?;
        Quantity::RollingResistance.check(parameters.rolling_resistance)?;
        let slope = Quantity::Slope.check(parameters.slope)?;
        within(Quantity::MuK, mu_k, Bound::AtMost(Quantity::MuS, mu_s))?;

        let heavy = Heavy::of(composition, slope);
        let Composition {
            mass_ratio, offset, ..
        } = composition;
        let body = if heavy.inertia > 0.0 {
            if heavy.inertia < MIN_INERTIA {
                return Err(ParameterError::NearlyMassless {
                    inertia: heavy.inertia,
                });
            }
            Body::Heavy(heavy)
        } else if offset > 0.0 && mass_ratio == 0.0 {
            if offset < MIN_MASSLESS_OFFSET {
                return Err(ParameterError::NearlyCentred { offset });
            }
            Body::Massless(Massless {
                offset,
                tilt: heavy.tilt,
            })
        } else {
            return Err(ParameterError::NoMotion { mass_ratio });
        };
        let (restitution, law) = (parameters.restitution, parameters.restitution_law);
        let restitution = match (body, restitution, law) {
            (_, None, Some(law)) => return Err(ParameterError::LawAlone { law }),
            (_, None, None) => None,
            (Body::Massless(_), Some(restitution), _) => {
                Quantity::Restitution.check(restitution)?;
                return Err(ParameterError::MasslessImpact { restitution });
            }
            (Body::Heavy(_), Some(coefficient), law) => {
                Some(Restitution::new(coefficient, law.unwrap_or_default())?)
            }
        };
        Ok(Self {
            parameters,
            body,
            restitution,
        })
    }

    /// Littlewood's own hoop (§3): massless, the particle on the rim.
    ///
    /// # Errors
    /// As [`Hoop::new`].
    pub fn littlewood(mu_s: f64, mu_k: f64) -> Result<Self, ParameterError> {
        Self::new(HoopParameters::thin(0.0).with_friction(mu_s, mu_k))
    }

    /// A thin hoop with a particle of equal mass on the rim: m1 = m2, ℓ = R, I_zz = m1 R² (Figures 2
    /// and 3).
    ///
    /// # Errors
    /// As [`Hoop::new`].
    pub fn equal_masses(mu_s: f64, mu_k: f64) -> Result<Self, ParameterError> {
        Self::new(HoopParameters::thin(1.0).with_friction(mu_s, mu_k))
    }

    /// The same hoop with a restitution.
    ///
    /// # Errors
    /// A massless hoop.
    pub fn with_restitution(&self, restitution: Restitution) -> Result<Self, ParameterError> {
        Self::new(
            self.parameters
                .with_restitution(restitution.coefficient(), restitution.law()),
        )
    }

    /// The parameters of the equations of rolling, which hold without inertia, too.
    pub(crate) const fn rigid_body(&self) -> Heavy {
        match self.body {
            Body::Heavy(heavy) => heavy,
            Body::Massless(Massless { offset, tilt }) => Heavy {
                mass: 1.0,
                h: offset,
                offset,
                inertia: 0.0,
                tilt,
            },
        }
    }

    /// √cos α: velocities over it are those in units in which gravity normal to the plane is 1. It
    /// is 1 on a level plane.
    pub(crate) fn pace(&self) -> f64 {
        libm::cos(self.parameters.slope).sqrt()
    }
}

impl<T: Number> Heavy<T> {
    /// The body on a slope; without inertia also that of a massless hoop.
    pub(crate) fn of(composition: Composition<T>, slope: T) -> Self {
        let (mass_ratio, offset) = (composition.mass_ratio, composition.offset);
        let (_, cos) = libm::sincos(slope.value());
        let tilt = if slope.value() == 0.0 {
            -0.0
        } else {
            libm::tan(slope.value())
        };
        let mass = mass_ratio + 1.0;
        Self {
            mass,
            h: offset / mass,
            offset,
            inertia: composition.inertia + mass_ratio * offset * offset / mass,
            tilt: slope.map(tilt, 1.0 / (cos * cos)),
        }
    }

    /// `tilt` as a term to subtract: +0 on a level plane.
    pub(crate) fn pull(&self) -> T {
        self.tilt + 0.0
    }
}

impl Heavy {
    /// The mirror image, on the mirrored slope.
    pub(crate) const fn mirrored(self) -> Self {
        Self {
            tilt: if self.tilt == 0.0 {
                self.tilt
            } else {
                -self.tilt
            },
            ..self
        }
    }
}

impl Massless {
    /// As [`Heavy::pull`].
    pub(crate) const fn pull(&self) -> f64 {
        self.tilt + 0.0
    }

    /// cos α, gravity normal to the plane.
    pub(crate) fn weight(&self) -> f64 {
        1.0 / (1.0 + self.tilt * self.tilt).sqrt()
    }
}

impl Body {
    /// Moment of inertia about the mass centre, Î of (2.9); zero for a massless hoop.
    pub const fn inertia_about_mass_centre(&self) -> f64 {
        match self {
            Self::Heavy(heavy) => heavy.inertia,
            Self::Massless(_) => 0.0,
        }
    }
}
