//! A value that has no physical meaning.

use littlewood::ParameterError;
use littlewood::tables::{Quantity, UnknownName};
use wasm_bindgen::prelude::wasm_bindgen;

/// Why a hoop, a start or a limit was refused.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Refusal(Reason);

#[derive(Clone, Debug)]
enum Reason {
    Parameter(ParameterError),
    /// A law of restitution that there is not.
    Law(UnknownName),
}

#[wasm_bindgen]
impl Refusal {
    /// Name of the quantity, as the command line has it.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn quantity(&self) -> String {
        let quantity = match &self.0 {
            Reason::Parameter(error) => error.quantity(),
            Reason::Law(_) => Quantity::Restitution,
        };
        quantity.name().to_owned()
    }

    /// The quantity, its value, the bound and the unit.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn message(&self) -> String {
        match &self.0 {
            Reason::Parameter(error) => error.to_string(),
            Reason::Law(error) => error.to_string(),
        }
    }

    /// What to do.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn hint(&self) -> String {
        let hint = match &self.0 {
            Reason::Parameter(error) => error.hint(),
            Reason::Law(_) => "choose one of these",
        };
        hint.to_owned()
    }
}

impl From<ParameterError> for Refusal {
    fn from(error: ParameterError) -> Self {
        Self(Reason::Parameter(error))
    }
}

impl From<UnknownName> for Refusal {
    fn from(error: UnknownName) -> Self {
        Self(Reason::Law(error))
    }
}
