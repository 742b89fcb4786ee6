//! A value that has no physical meaning.

use littlewood::ParameterError;
use wasm_bindgen::prelude::wasm_bindgen;

/// Why a hoop, a start or a limit was refused.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Refusal(ParameterError);

#[wasm_bindgen]
impl Refusal {
    /// Name of the quantity, as the command line has it.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn quantity(&self) -> String {
        self.0.quantity().name().to_owned()
    }

    /// The quantity, its value, the bound and the unit.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn message(&self) -> String {
        self.0.to_string()
    }

    /// What to do.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn hint(&self) -> String {
        self.0.hint().to_owned()
    }
}

impl From<ParameterError> for Refusal {
    fn from(error: ParameterError) -> Self {
        Self(error)
    }
}
