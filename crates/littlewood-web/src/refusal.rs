//! A value that has no physical meaning.

use littlewood::ParameterError;
use littlewood::tables::{Quantity, UnknownName};
use wasm_bindgen::prelude::wasm_bindgen;

/// Why a hoop, a start or a limit was refused.
#[wasm_bindgen(getter_with_clone)]
#[derive(Clone, Debug)]
pub struct Refusal {
    /// Name of the quantity, as the command line has it.
    #[wasm_bindgen(readonly)]
    pub quantity: String,
    /// The quantity, its value, the bound and the unit.
    #[wasm_bindgen(readonly)]
    pub message: String,
    /// What to do.
    #[wasm_bindgen(readonly)]
    pub hint: String,
}

impl Refusal {
    fn new(quantity: Quantity, message: String, hint: &str) -> Self {
        Self {
            quantity: quantity.name().to_owned(),
            message,
            hint: hint.to_owned(),
        }
    }
}

impl From<ParameterError> for Refusal {
    fn from(error: ParameterError) -> Self {
        Self::new(error.quantity(), error.to_string(), error.hint())
    }
}

/// A law of restitution that there is not.
impl From<UnknownName> for Refusal {
    fn from(error: UnknownName) -> Self {
        Self::new(
            Quantity::Restitution,
            error.to_string(),
            "choose one of these",
        )
    }
}
