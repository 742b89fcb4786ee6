//! Prints random motions over the whole accepted range as lines of JSON, for programs that check them:
//!
//! ```sh
//! cargo run --release -p littlewood-random --example motions -- 1000 2019 heavy
//! ```
//!
//! takes the number of motions, the seed, and what is drawn: `any`, `heavy` (no massless hoop), `usual`, or `resisted` (a heavy hoop with
//! rolling resistance, half of them with a start next to where a mode begins); then, if they are wanted, the
//! largest number of transitions (100) and the word `digits`. A line has the hoop, the start, the outcome, and each transition with the
//! state before it and after it, and the digits that are trusted there. The same numbers draw the same motions.

use std::env;
use std::error::Error;
use std::io::{self, Write};

use littlewood::tables::Setup;
use littlewood::{Hoop, Limits, Mode, SlipDirection, State};
use littlewood_random::Draw;
use serde_json::{Value, json};

fn state(state: &State) -> Value {
    let State {
        time,
        theta,
        theta_rate,
        slip,
        x,
        ..
    } = *state;
    json!({ "time": time, "theta": theta, "theta_rate": theta_rate, "slip": slip, "x": x })
}

fn main() -> Result<(), Box<dyn Error>> {
    let words = Vec::from_iter(env::args().skip(1));
    let word =
        |place: usize, default: &str| words.get(place).map_or(default, String::as_str).to_owned();
    let (count, seed): (u64, u64) = (word(0, "1000").parse()?, word(1, "2019").parse()?);
    let kind = word(2, "any");
    let limits = Limits::default().with_transitions(word(3, "100").parse()?);
    let mut out = io::BufWriter::new(io::stdout().lock());
    for number in 0..count {
        let mut draw = Draw::of_case(seed, 0, number);
        let (hoop, start) = match kind.as_str() {
            "any" => draw.motion(),
            "heavy" => draw.heavy_motion(),
            "usual" => {
                let Setup { hoop, start } = draw.usual();
                (Hoop::new(hoop)?, start)
            }
            "resisted" if number % 2 == 0 => draw.resisted_in_contact(),
            "resisted" => {
                let (hoop, start) = draw.heavy_motion();
                (draw.resisted(&hoop), start)
            }
            other => return Err(format!("'{other}': any, heavy, usual or resisted").into()),
        };
        let motion = hoop.simulate(start, limits)?;
        let digits = if word(4, "") == "digits" {
            hoop.digits(start, limits)?
        } else {
            Vec::new()
        };
        let transitions =
            Vec::from_iter(motion.transitions().iter().enumerate().map(|(place, it)| {
                json!({
                    "digits": digits.get(place),
                    "cause": it.cause.name(),
                    "from": it.from.map(Mode::name),
                    "to": it.to.map(Mode::name),
                    "direction": SlipDirection::code(it.direction),
                    "before": state(&it.before),
                    "after": state(&it.after),
                })
            }));
        let line = json!({
            "number": number,
            "hoop": hoop.parameters(),
            "start": start,
            "outcome": motion.outcome().kind().name(),
            "transitions": transitions,
        });
        writeln!(out, "{line}")?;
    }
    Ok(out.flush()?)
}
