//! Ctrl-C: the first asks the work to stop where it can be resumed, the second stops it at once.

use std::sync::atomic::{AtomicBool, Ordering};

static ASKED: AtomicBool = AtomicBool::new(false);

/// Listens for Ctrl-C. The flag becomes true when it comes.
pub(crate) fn listen() -> &'static AtomicBool {
    // Without a handler, which the system has no reason to refuse, Ctrl-C ends the program as ever; finished chunks
    // stay.
    let _ = ctrlc::set_handler(|| {
        if ASKED.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    &ASKED
}
