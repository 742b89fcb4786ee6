//! A bar with rate and time left on the standard error: on a terminal, and for work that takes a
//! while.

use std::fmt;
use std::io::{self, IsTerminal};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{
    HumanCount, HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle,
};

/// Work that takes no longer than this has no bar.
const SHORT: Duration = Duration::from_secs(1);

/// How often a bar is drawn where nothing moves it.
const TICK: Duration = Duration::from_millis(500);

/// How often it is seen whether a bar is to be shown.
const LOOK: Duration = Duration::from_millis(100);

/// The bar that is on the screen.
static SHOWN: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// A bar, or nothing.
pub(crate) struct Bar {
    /// None without a terminal.
    state: Option<Arc<Mutex<State>>>,
}

struct State {
    begun: Instant,
    of: &'static str,
    unit: &'static str,
    total: u64,
    bar: ProgressBar,
    is_over: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Count {
    pub(crate) done: u64,
    /// Of how many; 0 where nobody knows.
    pub(crate) total: u64,
}

impl Bar {
    /// Nothing yet.
    pub(crate) fn new() -> Self {
        Self {
            state: io::stderr().is_terminal().then(State::watched).flatten(),
        }
    }

    /// Tells how many starts, frames or the like are done. Another unit, or another total, is other
    /// work.
    pub(crate) fn show(&self, unit: &'static str, count: Count) {
        self.show_of("", unit, count);
    }

    /// The same, with the name of what is made of them.
    pub(crate) fn show_of(&self, of: &'static str, unit: &'static str, count: Count) {
        // Nobody waits for a bar: another thread has just moved it.
        let Some(mut state) = self.state.as_ref().and_then(|state| state.try_lock().ok()) else {
            return;
        };
        if (state.unit, state.total) != (unit, count.total) {
            clear();
            *state = State::new(unit, count);
        }
        if state.of != of {
            state.of = of;
            state.bar.set_message(of);
        }
        state.bar.set_position(count.done);
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        if let Some(state) = &self.state {
            state.lock().unwrap_or_else(PoisonError::into_inner).is_over = true;
            clear();
        }
    }
}

impl State {
    fn new(unit: &'static str, first: Count) -> Self {
        Self {
            begun: Instant::now(),
            of: "",
            unit,
            total: first.total,
            bar: hidden_bar(unit, first),
            is_over: false,
        }
    }

    /// With a thread that shows the bar when it is time; none where the system has no thread to
    /// give.
    fn watched() -> Option<Arc<Mutex<Self>>> {
        let state = Arc::new(Mutex::new(Self::new("", Count { done: 0, total: 0 })));
        let watched = Arc::clone(&state);
        let watcher = thread::Builder::new().spawn(move || {
            loop {
                thread::sleep(LOOK);
                let state = watched.lock().unwrap_or_else(PoisonError::into_inner);
                if state.is_over {
                    break;
                }
                state.show_if_long();
            }
        });
        watcher.is_ok().then_some(state)
    }

    fn show_if_long(&self) {
        if self.bar.is_hidden() && self.begun.elapsed() > SHORT {
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
            self.bar.enable_steady_tick(TICK);
            *shown() = Some(self.bar.clone());
        }
    }
}

pub(crate) fn clear() {
    if let Some(bar) = shown().take() {
        bar.finish_and_clear();
    }
}

fn shown() -> MutexGuard<'static, Option<ProgressBar>> {
    SHOWN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A bar that is not shown yet.
fn hidden_bar(unit: &'static str, first: Count) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(first.total), ProgressDrawTarget::hidden());
    let template = if first.total == 0 {
        format!("{{spinner}} {{human_pos}} {unit}  {{msg}}")
    } else {
        format!(
            "{{bar:32}} {{percent:>3}}%  {{human_pos}} of {{human_len}} {unit}  {{pace}}  {{rest}} left  {{msg}}"
        )
    };
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(style.with_key("pace", pace).with_key("rest", rest));
    }
    // What was done before says nothing about the speed of this work.
    bar.set_position(first.done);
    bar.reset_eta();
    bar
}

/// Whole ones a second where there are many.
fn pace(state: &ProgressState, writer: &mut dyn fmt::Write) {
    let pace = state.per_sec();
    let _ = if pace < 10.0 {
        write!(writer, "{pace:.1}/s")
    } else {
        write!(writer, "{}/s", HumanCount(pace as u64))
    };
}

/// The time that is left, once there is a pace.
fn rest(state: &ProgressState, writer: &mut dyn fmt::Write) {
    let _ = if state.per_sec() > 0.0 {
        write!(writer, "{:#}", HumanDuration(state.eta()))
    } else {
        write!(writer, "?")
    };
}
