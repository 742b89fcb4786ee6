//! The value of a quantity at which the class of a motion changes, to the last digit.

use crate::model::{Hoop, Limits, ParameterError, Quantity, Setup};
use crate::motion::class::Class;

/// Steps in which a range is searched.
const STEPS: f64 = 200.0;

/// A value of the quantity, with the class of its motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClassAt {
    /// The value.
    pub value: f64,
    /// The class of the motion there; none of a value that is refused.
    pub class: Class,
}

/// Where a class ends: neighbouring numbers with motions of two classes. Where rounding decides
/// between them ([`Class::Unresolved`]) they are the last number of the one and the first of the
/// other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold {
    /// The last number below.
    pub below: ClassAt,
    /// The first number above.
    pub above: ClassAt,
    /// Whether the motions of numbers between them are unresolved.
    pub has_unresolved_between: bool,
}

/// The numbers between which a search has found no threshold, and its steps. What changes twice
/// within a step is not seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Searched {
    /// The least.
    pub from: f64,
    /// The largest.
    pub to: f64,
    /// The width of a step.
    pub step: f64,
}

/// A range of values, and the one from which it is searched to both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearchRange {
    /// Its least value.
    pub from: f64,
    /// Its largest value.
    pub to: f64,
    /// The value from which it is searched.
    pub near: f64,
}

/// The class of a motion, none of one that is refused. It is followed to its first landing, which
/// decides: behind a jam alone it goes on.
fn class_of(setup: &Setup, limits: Limits) -> Option<Class> {
    let class = |hoop: &Hoop| {
        let motion = hoop.simulate(setup.start, limits).ok()?;
        Some(Class::of(&motion.summary()))
    };
    let hoop = Hoop::new(setup.hoop).ok()?;
    let mut parameters = setup.hoop;
    (parameters.restitution, parameters.restitution_law) = (None, None);
    match class(&Hoop::new(parameters).ok()?)? {
        Class::Painleve if hoop.restitution().is_some() => class(&hoop),
        decided => Some(decided),
    }
}

impl Class {
    /// Whether two motions may be of one class: one that is in contact as far as it was followed
    /// may be any that stays in contact.
    #[must_use]
    pub fn may_be(self, other: Self) -> bool {
        let is_open = self == Self::InContact || other == Self::InContact;
        self == other || (is_open && self.stays_in_contact() && other.stays_in_contact())
    }
}

impl SearchRange {
    /// The usual values of a quantity, searched from the one that a motion has; from the least
    /// where it has none.
    #[must_use]
    pub fn usual(quantity: Quantity, value: Option<f64>) -> Self {
        let [from, to] = quantity.row().usual;
        let near = value.unwrap_or(from);
        Self {
            from: from.min(near),
            to: to.max(near),
            near,
        }
    }

    /// From the first value of a quantity on to the last.
    ///
    /// # Errors
    /// If one of them is none that the quantity can have.
    pub fn between(quantity: Quantity, first: f64, last: f64) -> Result<Self, ParameterError> {
        quantity.check(first)?;
        quantity.check(last)?;
        Ok(Self {
            from: first.min(last),
            to: first.max(last),
            near: first,
        })
    }

    /// The threshold of a quantity of a hoop or a start, as [`SearchRange::nearest`]; the value that
    /// the quantity has is replaced.
    ///
    /// ```
    /// use littlewood::tables::{Class, Quantity, Setup};
    /// use littlewood::thresholds::SearchRange;
    /// use littlewood::{HoopParameters, Limits, Start};
    ///
    /// // A disc at rest on a plane with χ = 0.1 begins to roll where tan α = χ.
    /// let disc = HoopParameters::thin(1.0).with_offset(0.0).with_friction(0.5, 0.4);
    /// let inertia = disc.with_inertia(0.5).with_rolling_resistance(0.1);
    /// let setup = Setup::new(inertia, Start::at(0.0, 0.0));
    /// let range = SearchRange { from: 0.0, to: 0.3, near: 0.0 };
    /// let threshold = range
    ///     .of_motion(&setup, Quantity::Slope, Limits::default())
    ///     .expect("it begins to roll");
    /// assert_eq!(threshold.below.class, Class::Rests);
    /// assert!((threshold.above.value.tan() - 0.1).abs() < 1e-15);
    /// ```
    ///
    /// # Errors
    /// As [`SearchRange::nearest`].
    pub fn of_motion(
        self,
        setup: &Setup,
        quantity: Quantity,
        limits: Limits,
    ) -> Result<Threshold, Searched> {
        let mut setup = *setup;
        self.nearest(|value| {
            setup.set(quantity, value);
            class_of(&setup, limits)
        })
    }

    /// The threshold nearest to where the search begins, from the classes of motions; of two that
    /// are as near, that above. A value without a motion, whose class is none, ends the search on
    /// its side.
    ///
    /// # Errors
    /// What was searched, where there is no threshold.
    pub fn nearest(
        self,
        mut class_at: impl FnMut(f64) -> Option<Class>,
    ) -> Result<Threshold, Searched> {
        let step = (self.to - self.from) / STEPS;
        let near = self.near;
        let none = |from, to| Searched { from, to, step };
        let Some(class) = class_at(near) else {
            return Err(none(near, near));
        };
        let here = ClassAt { value: near, class };
        let mut sides = [(near, self.to), (near, self.from)].map(|(inside, end)| Side {
            inside,
            end,
            outside: None,
        });
        // Step by step to both sides, so that the nearer threshold is found first.
        while sides.iter().any(Side::is_open) {
            for side in &mut sides {
                if side.is_open() {
                    side.advance(step, here.class, &mut class_at);
                }
            }
            let found = sides.iter().filter_map(|side| {
                Some(bisect(
                    side.inside,
                    side.outside?,
                    here.class,
                    step,
                    &mut class_at,
                ))
            });
            let distance = |it: &Threshold| (it.below.value - near).abs();
            let nearest = found.min_by(|a, b| distance(a).total_cmp(&distance(b)));
            if let Some(threshold) = nearest {
                return Ok(threshold);
            }
        }
        let [above, below] = sides;
        Err(none(below.inside, above.inside))
    }
}

/// The search on one side.
struct Side {
    /// The last value of the class.
    inside: f64,
    /// Where the search ends.
    end: f64,
    /// The first value of another class, a step away.
    outside: Option<ClassAt>,
}

impl Side {
    fn is_open(&self) -> bool {
        self.outside.is_none() && self.inside != self.end
    }

    fn advance(
        &mut self,
        step: f64,
        class: Class,
        class_at: &mut impl FnMut(f64) -> Option<Class>,
    ) {
        let value = if (self.end - self.inside).abs() <= step {
            self.end
        } else {
            self.inside + step.copysign(self.end - self.inside)
        };
        match class_at(value) {
            Some(there) if there.may_be(class) => self.inside = value,
            Some(there) => {
                self.outside = Some(ClassAt {
                    value,
                    class: there,
                });
            }
            None => self.end = self.inside,
        }
    }
}

/// The change of class between two values, down to neighbours, or to what a number next to zero
/// need not resolve.
fn bisect(
    inside: f64,
    outside: ClassAt,
    class: Class,
    step: f64,
    class_at: &mut impl FnMut(f64) -> Option<Class>,
) -> Threshold {
    let (mut near, mut far) = (inside, outside);
    narrow(&mut near, &mut far.value, step, |value| {
        class_at(value).is_some_and(|there| there.may_be(class))
    });
    far.class = class_at(far.value).unwrap_or(Class::Invalid);
    // What rounding decides is passed, up to the class behind it.
    let has_unresolved_between =
        far.class == Class::Unresolved && outside.class != Class::Unresolved;
    if has_unresolved_between {
        let mut unresolved = far.value;
        far = outside;
        narrow(&mut unresolved, &mut far.value, step, |value| {
            class_at(value) == Some(Class::Unresolved)
        });
        far.class = class_at(far.value).unwrap_or(Class::Invalid);
    }
    let near = ClassAt { value: near, class };
    let (below, above) = if near.value < far.value {
        (near, far)
    } else {
        (far, near)
    };
    Threshold {
        below,
        above,
        has_unresolved_between,
    }
}

/// Halves the interval between a value that is inside and one that is not.
fn narrow(near: &mut f64, far: &mut f64, step: f64, mut is_inside: impl FnMut(f64) -> bool) {
    loop {
        let middle = *near + 0.5 * (*far - *near);
        if middle == *near || middle == *far || (*far - *near).abs() < f64::EPSILON * step {
            return;
        }
        *(if is_inside(middle) {
            &mut *near
        } else {
            &mut *far
        }) = middle;
    }
}
