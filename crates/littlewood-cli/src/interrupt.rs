//! Ctrl-C and SIGTERM: the program ends at once, or within some seconds on a busy machine, and
//! leaves no unfinished files.
//!
//! Work that looks at the flag of [`asked`] ends by itself, keeps what is finished and says so. All
//! other work is ended at once, and so is work that does not get to the flag in time, or a program
//! that is asked twice.

use std::process;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread;
use std::time::Duration;

#[cfg(unix)]
use nix::sys::signal::{SigSet, Signal};

use crate::error::Error;
use crate::progress;
use crate::unfinished;

/// How long work has to get to the flag, and to write what is finished.
const PATIENCE: Duration = Duration::from_secs(5);

static ASKED: AtomicBool = AtomicBool::new(false);
static LOOKS: AtomicBool = AtomicBool::new(false);

pub(crate) fn install() {
    #[cfg(unix)]
    hold_back_limits();
    // Without a handler, which the system has no reason to refuse, a signal ends the program as
    // ever; finished chunks stay.
    let _ = ctrlc::set_handler(|| {
        let is_second = ASKED.swap(true, Ordering::Relaxed);
        if is_second || !LOOKS.load(Ordering::Relaxed) {
            end();
        }
        let waiter = thread::Builder::new().spawn(|| {
            thread::sleep(PATIENCE);
            end();
        });
        if waiter.is_err() {
            end();
        }
    });
}

/// Holds back the signal that a file has reached the largest size allowed (`ulimit -f`): the write
/// fails then, as on a full disk, and unfinished files are removed. Threads that are started later
/// hold it back too; programs that are, do not.
#[cfg(unix)]
fn hold_back_limits() {
    let mut signals = SigSet::empty();
    signals.add(Signal::SIGXFSZ);
    // Where it cannot be held back it ends the program as ever.
    let _ = signals.thread_block();
}

/// The flag that becomes true with the signal, for work that looks at it from here on.
pub(crate) fn asked() -> &'static AtomicBool {
    LOOKS.store(true, Ordering::Relaxed);
    &ASKED
}

fn end() -> ! {
    // Held to the end: nothing is begun or put in its place any more.
    let _held = unfinished::remove_all();
    progress::clear();
    Error::Stopped.print();
    process::exit(Error::Stopped.exit_code().into())
}
