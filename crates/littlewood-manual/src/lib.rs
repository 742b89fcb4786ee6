//! The shell completions and the manual pages of the command line, made from its definition.
//!
//! A crate of its own, so that neither the program nor those who build it pay for the generators.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use clap_complete::Shell;
use clap_complete::aot::generate;

/// The name of the program.
const PROGRAM: &str = "littlewood";

/// Where a shell looks for the completions of a program, below a prefix such as `/usr/local`; none for shells that load them
/// from no such folder.
#[must_use]
pub fn place(shell: Shell) -> Option<PathBuf> {
    match shell {
        Shell::Bash => Some(format!("share/bash-completion/completions/{PROGRAM}").into()),
        Shell::Fish => Some(format!("share/fish/vendor_completions.d/{PROGRAM}.fish").into()),
        Shell::Zsh => Some(format!("share/zsh/site-functions/_{PROGRAM}").into()),
        Shell::Elvish => Some(format!("share/elvish/lib/{PROGRAM}.elv").into()),
        Shell::PowerShell => Some(format!("share/powershell/{PROGRAM}.ps1").into()),
        _ => None,
    }
}

/// Shells with completions.
pub const SHELLS: [Shell; 5] = [Shell::Bash, Shell::Fish, Shell::Zsh, Shell::Elvish, Shell::PowerShell];

/// Writes completions and manual pages below the prefix.
///
/// # Errors
///
/// Where a file cannot be written.
pub fn write(prefix: &Path) -> io::Result<()> {
    for shell in SHELLS {
        let Some(place) = place(shell) else { continue };
        let mut script = Vec::new();
        generate(shell, &mut littlewood_cli::command(), PROGRAM, &mut script);
        write_file(&prefix.join(place), &script)?;
    }
    let pages = prefix.join("share/man/man1");
    fs::create_dir_all(&pages)?;
    // A page for the program and one for each command; none for `help`, which lists them.
    clap_mangen::generate_to(littlewood_cli::command().disable_help_subcommand(true), pages)
}

fn write_file(path: &Path, content: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, content)
}
