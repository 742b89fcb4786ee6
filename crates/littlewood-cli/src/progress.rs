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
const SHORT: Duration = Duration::from_secs(2);

/// How soon a bar can show that work will take longer.
const SOON: Duration = Duration::from_millis(500);

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
    first: Count,
    now: Count,
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
        if (state.unit, state.first.total) != (unit, count.total) {
            clear();
            *state = State::new(unit, count);
        }
        state.now = count;
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
            first,
            now: first,
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
        if self.bar.is_hidden() && is_long(self.begun.elapsed(), self.first, self.now) {
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

/// Whether work that began so long ago, when the first count was done, has taken long, or will have
/// at its pace.
fn is_long(elapsed: Duration, first: Count, now: Count) -> bool {
    let share = now.done.saturating_sub(first.done) as f64
        / now.total.saturating_sub(first.done).max(1) as f64;
    elapsed >= SHORT
        || now.total > 0 && elapsed >= SOON && elapsed.as_secs_f64() > share * SHORT.as_secs_f64()
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

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::{Count, is_long};

    #[test]
    fn only_work_of_more_than_two_seconds_is_long() {
        let none = Count {
            done: 0,
            total: 1000,
        };
        let is_long =
            |millis, done| is_long(Duration::from_millis(millis), none, Count { done, ..none });
        // Whatever it is, it may be over in a moment.
        assert!(!is_long(499, 0));
        // At its pace it takes two seconds, or a little more.
        assert!(!is_long(500, 250) && is_long(500, 249));
        assert!(!is_long(1000, 500) && is_long(1000, 499));
        assert!(is_long(2000, 1000));
    }

    #[test]
    fn work_without_a_known_end_has_no_pace() {
        let none = Count { done: 0, total: 0 };
        let is_long =
            |millis, done| is_long(Duration::from_millis(millis), none, Count { done, ..none });
        assert!(!is_long(1900, 0) && !is_long(1900, 5) && is_long(2000, 5));
    }

    #[test]
    fn what_an_earlier_run_has_done_is_no_pace() {
        let resumed = Count {
            done: 900,
            total: 1000,
        };
        let is_long = |done| is_long(Duration::from_secs(1), resumed, Count { done, ..resumed });
        assert!(is_long(940) && !is_long(960));
    }
}
