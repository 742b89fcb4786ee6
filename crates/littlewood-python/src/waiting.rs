//! Work on other threads, while this one listens for Ctrl-C and shows progress.

use core::num::NonZeroUsize;
use core::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use core::time::Duration;
use std::sync::mpsc::{RecvTimeoutError, channel};

use littlewood_sweep::{Halt, Options, Progress, Refused, Workers};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// Time between two looks at the signals.
const LOOK: Duration = Duration::from_millis(100);

/// Runs `work` on `threads` threads of its own (0: as many as there are cores) without holding the
/// interpreter.
///
/// The threads end with the work: a process that forks afterwards has none to miss. `progress` is
/// called with the amount done, about ten times a second and at the end. What Ctrl-C or `progress`
/// raise stops the work.
pub(crate) fn run<T: Send>(
    py: Python<'_>,
    threads: usize,
    progress: Option<&Py<PyAny>>,
    work: impl FnOnce(&Workers, &Options<'_>) -> Result<T, Halt> + Send,
) -> PyResult<Result<T, Refused>> {
    let (cancelled, followed) = (AtomicBool::new(false), AtomicU64::new(0));
    let count = |progress: Progress| {
        followed.fetch_max(progress.followed, Ordering::Relaxed);
    };
    let options = || Options {
        cancel: Some(&cancelled),
        progress: Some(&count),
        ..Options::default()
    };
    py.detach(|| {
        let workers = Workers::new(NonZeroUsize::new(threads))
            .map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        let (sender, receiver) = channel();
        std::thread::scope(|scope| {
            scope.spawn(|| {
                // The receiver outlives this thread, so that nothing is lost.
                let _ = sender.send(work(&workers, &options()));
            });
            let mut raised = None;
            loop {
                let result = receiver.recv_timeout(LOOK);
                let look = || {
                    Python::attach(|py| {
                        py.check_signals()?;
                        if let Some(progress) = progress {
                            progress.call1(py, (followed.load(Ordering::Relaxed),))?;
                        }
                        Ok(())
                    })
                };
                let result = match result {
                    Ok(Ok(result)) => Ok(Ok(result)),
                    Ok(Err(Halt::Refused(refused))) => Ok(Err(refused)),
                    Ok(Err(Halt::Cancelled)) | Err(RecvTimeoutError::Disconnected) => Err(
                        PyRuntimeError::new_err("the simulation has stopped before its end"),
                    ),
                    Err(RecvTimeoutError::Timeout) => {
                        if let (None, Err(error)) = (&raised, look()) {
                            cancelled.store(true, Ordering::Relaxed);
                            raised = Some(error);
                        }
                        continue;
                    }
                };
                return raised.map_or_else(look, Err).and(result);
            }
        })
    })
}
