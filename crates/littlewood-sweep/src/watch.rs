//! What a computation tells while it is under way, and what stops it between two motions.

use core::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use crate::options::{Options, Progress};

/// Motions after which a thread tells of them: seldom enough to cost nothing where a motion takes a
/// microsecond, often enough where one takes a tenth of a second.
const TELL: u64 = 32;

/// The counts of a run, which all its threads share.
pub(crate) struct Ledger<'a> {
    options: &'a Options<'a>,
    followed: AtomicU64,
    done: AtomicU64,
    reused: u64,
    total: u64,
}

impl<'a> Ledger<'a> {
    pub(crate) const fn new(options: &'a Options<'a>, reused: u64, total: u64) -> Self {
        let (followed, done) = (AtomicU64::new(reused), AtomicU64::new(reused));
        Self {
            options,
            followed,
            done,
            reused,
            total,
        }
    }

    pub(crate) fn progress(&self) -> Progress {
        Progress {
            followed: self.followed.load(Ordering::Relaxed),
            done: self.done.load(Ordering::Relaxed),
            reused: self.reused,
            total: self.total,
        }
    }

    pub(crate) fn report(&self) {
        if let Some(callback) = self.options.progress {
            callback(self.progress());
        }
    }

    pub(crate) fn finish(&self, points: u64) {
        self.done.fetch_add(points, Ordering::Relaxed);
        self.report();
    }

    pub(crate) const fn watch(&self) -> Watch<'_> {
        Watch {
            ledger: Some(self),
            cancel: self.options.cancel,
            untold: 0,
        }
    }
}

/// What a thread looks at between two motions.
#[derive(Clone)]
pub(crate) struct Watch<'a> {
    ledger: Option<&'a Ledger<'a>>,
    cancel: Option<&'a AtomicBool>,
    /// Motions that were followed and not yet told of.
    untold: u64,
}

impl Watch<'_> {
    pub(crate) const NONE: Watch<'static> = Watch {
        ledger: None,
        cancel: None,
        untold: 0,
    };

    pub(crate) fn is_cancelled(&self) -> bool {
        self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    pub(crate) fn count(&mut self) {
        self.untold += 1;
        if self.untold == TELL {
            self.tell();
        }
    }

    fn tell(&mut self) {
        if let Some(ledger) = self.ledger {
            ledger.followed.fetch_add(self.untold, Ordering::Relaxed);
            ledger.report();
        }
        self.untold = 0;
    }
}

impl Drop for Watch<'_> {
    fn drop(&mut self) {
        if self.untold > 0 {
            self.tell();
        }
    }
}
