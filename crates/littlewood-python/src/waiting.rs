//! Work on other threads, while this one listens for Ctrl-C and shows progress.

use core::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use core::time::Duration;
use std::sync::mpsc::{RecvTimeoutError, channel};

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// Time between two looks at the signals.
const LOOK: Duration = Duration::from_millis(100);

/// What the work and the waiting thread tell each other.
#[derive(Debug, Default)]
pub(crate) struct Signals {
    cancelled: AtomicBool,
    done: AtomicUsize,
}

/// The work has stopped before its end.
#[derive(Debug)]
pub(crate) struct Cancelled;

impl Signals {
    /// An error if the work should stop.
    pub(crate) fn check(&self) -> Result<(), Cancelled> {
        if self.cancelled.load(Ordering::Relaxed) { Err(Cancelled) } else { Ok(()) }
    }

    /// Tells of this much more work done.
    pub(crate) fn add(&self, count: usize) {
        self.done.fetch_add(count, Ordering::Relaxed);
    }
}

/// Runs `work` on `threads` threads of its own (0: as many as there are cores) without holding the interpreter.
///
/// The threads end with the work: a process that forks afterwards has none to miss. `progress` is called with the
/// amount done, about ten times a second and at the end. What Ctrl-C or `progress` raise stops the work.
pub(crate) fn run<T: Send>(
    py: Python<'_>,
    threads: usize,
    progress: Option<&Py<PyAny>>,
    work: impl FnOnce(&Signals) -> Result<T, Cancelled> + Send,
) -> PyResult<T> {
    let signals = Signals::default();
    py.detach(|| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .map_err(|error| PyRuntimeError::new_err(format!("cannot start {threads} threads: {error}")))?;
        let (sender, receiver) = channel();
        std::thread::scope(|scope| {
            scope.spawn(|| {
                // The receiver outlives this thread, so that nothing is lost.
                let _ = sender.send(pool.install(|| work(&signals)));
            });
            let mut raised = None;
            loop {
                let result = receiver.recv_timeout(LOOK);
                let look = || {
                    Python::attach(|py| {
                        py.check_signals()?;
                        if let Some(progress) = progress {
                            progress.call1(py, (signals.done.load(Ordering::Relaxed),))?;
                        }
                        Ok(())
                    })
                };
                match result {
                    Ok(Ok(result)) => return raised.map_or_else(look, Err).map(|()| result),
                    Ok(Err(Cancelled)) => return raised.map_or_else(look, Err).and_then(|()| Err(stopped())),
                    Err(RecvTimeoutError::Timeout) => {
                        if let (None, Err(error)) = (&raised, look()) {
                            signals.cancelled.store(true, Ordering::Relaxed);
                            raised = Some(error);
                        }
                    }
                    Err(RecvTimeoutError::Disconnected) => {
                        return Err(stopped());
                    }
                }
            }
        })
    })
}

fn stopped() -> PyErr {
    PyRuntimeError::new_err("the simulation has stopped before its end")
}
