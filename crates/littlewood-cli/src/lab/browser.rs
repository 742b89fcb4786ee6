//! Opening an address in the browser of this machine.

use std::env;
use std::io;
use std::process::{Command, Stdio};

/// Opens an address of this machine. Where nobody sits at a screen nothing is opened: some systems
/// would start a browser for text.
pub(super) fn open(address: &str) -> io::Result<()> {
    if !has_screen() {
        return Ok(());
    }
    let mut command = if cfg!(windows) {
        // A title comes first.
        let mut start = Command::new("cmd");
        start.args(["/c", "start", ""]);
        start
    } else if cfg!(target_os = "macos") {
        Command::new("open")
    } else {
        Command::new("xdg-open")
    };
    let null = Stdio::null;
    command
        .arg(address)
        .stdin(null())
        .stdout(null())
        .stderr(null())
        .spawn()
        .map(drop)
}

fn has_screen() -> bool {
    cfg!(any(windows, target_os = "macos"))
        || ["DISPLAY", "WAYLAND_DISPLAY"]
            .iter()
            .any(|name| env::var_os(name).is_some_and(|it| !it.is_empty()))
}
