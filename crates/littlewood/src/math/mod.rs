//! Polynomials, roots and elliptic integrals, independent of the hoop.

pub(crate) mod bernstein;
pub(crate) mod bounded;
pub(crate) mod bracket;
pub(crate) mod carlson;
pub(crate) mod form;
pub(crate) mod number;
pub(crate) mod panel;
pub(crate) mod series;
pub(crate) mod trig;
