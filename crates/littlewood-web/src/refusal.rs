//! A value that has no physical meaning.

use littlewood::ParameterError;
use wasm_bindgen::prelude::wasm_bindgen;

/// Why a hoop, a start or a limit was refused.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Refusal {
    quantity: &'static str,
    message: String,
    hint: &'static str,
}

#[wasm_bindgen]
impl Refusal {
    /// Name of the quantity, as the command line has it.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn quantity(&self) -> String {
        self.quantity.to_owned()
    }

    /// The quantity, its value, the bound and the unit.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn message(&self) -> String {
        self.message.clone()
    }

    /// What to do.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn hint(&self) -> String {
        self.hint.to_owned()
    }
}

impl From<ParameterError> for Refusal {
    fn from(error: ParameterError) -> Self {
        let quantity = match error {
            ParameterError::OutOfBounds { quantity, .. } => quantity.name(),
            // A point mass at the centre: the offset, or the inertia, has to grow.
            _ => "offset",
        };
        Self { quantity, message: error.to_string(), hint: error.hint() }
    }
}
