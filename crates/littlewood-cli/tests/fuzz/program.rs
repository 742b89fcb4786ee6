//! The program, run with an eye on the clock.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Instant;

use crate::fuzz::{HANGS, Verdict};

/// What came of a run.
pub(crate) struct Ran {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: Vec<u8>,
    pub(crate) stderr: String,
    hangs: bool,
}

/// The command as it is typed.
pub(crate) fn typed(words: &[String]) -> String {
    let quoted = words.iter().map(|word| {
        let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "-_=.,:/+".contains(letter);
        if !word.is_empty() && word.chars().all(is_plain) {
            word.clone()
        } else {
            format!("'{}'", word.replace('\'', r"'\''"))
        }
    });
    format!("littlewood {}", quoted.collect::<Vec<_>>().join(" "))
}

/// Runs the program in a folder; what it prints goes through files, of which there is no end.
pub(crate) fn run(words: &[String], folder: &Path) -> Ran {
    let (out, err) = (folder.join(".out"), folder.join(".err"));
    let begun = Instant::now();
    let mut child = Command::new(env!("CARGO_BIN_EXE_littlewood"))
        .args(words)
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(File::create(&out).expect("a file"))
        .stderr(File::create(&err).expect("a file"))
        .spawn()
        .expect("it runs");
    let mut pause = std::time::Duration::from_micros(500);
    let (code, hangs) = loop {
        if let Some(status) = child.try_wait().expect("its state") {
            break (status.code(), false);
        }
        if begun.elapsed() > HANGS - HANGS / 10 {
            child.kill().expect("it ends");
            child.wait().expect("it ends");
            break (None, true);
        }
        sleep(pause);
        pause = (pause * 3 / 2).min(std::time::Duration::from_millis(20));
    };
    let stdout = fs::read(&out).expect("its output");
    let stderr = String::from_utf8_lossy(&fs::read(&err).expect("its messages")).into_owned();
    Ran {
        code,
        stdout,
        stderr,
        hangs,
    }
}

/// Whether a run ended as every run may: with a result and no message, or with a message and a hint
/// and no result.
pub(crate) fn judge(ran: &Ran) -> Verdict {
    let message = || ran.stderr.chars().take(2000).collect::<String>();
    if ran.hangs {
        return Err(format!("it hangs\n{}", message()));
    }
    match ran.code {
        Some(0) if !ran.stderr.is_empty() => {
            Err(format!("exit code 0 with a message: {}", message()))
        }
        Some(0) => Ok("done"),
        Some(2) if !ran.stdout.is_empty() => Err(format!(
            "exit code 2 with a result: {}",
            String::from_utf8_lossy(&ran.stdout)
        )),
        Some(2) => {
            // The last is what clap says.
            let helps = ["hint:", "help:", "For more information"];
            if helps.iter().any(|help| ran.stderr.contains(help)) {
                Ok("refused")
            } else {
                Err(format!("a refusal without a hint: {}", message()))
            }
        }
        code => Err(format!("exit code {code:?}: {}", message())),
    }
}
