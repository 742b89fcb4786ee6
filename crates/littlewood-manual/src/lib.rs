//! The shell completions and the manual pages of the command line, made from its definition.
//!
//! A crate of its own, so that neither the program nor those who build it pay for the generators.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use clap::Command;
use clap_complete::Shell;
use clap_complete::aot::generate;
use clap_mangen::Man;

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
    for page in pages() {
        let mut text = Vec::new();
        page.render(&mut text)?;
        write_file(&prefix.join("share/man/man1").join(page.get_filename()), &text)?;
    }
    Ok(())
}

/// The page of the program, and one for each command.
#[must_use]
pub fn pages() -> Vec<Man> {
    let mut program = littlewood_cli::command().disable_help_subcommand(true);
    program.build();
    let of_command = |command: &Command| {
        let name = format!("{PROGRAM}-{}", command.get_name());
        // The page is found by the name with a hyphen; the command is typed with a space.
        let typed = format!("{PROGRAM} {}", command.get_name());
        Man::new(command.clone().name(name).bin_name(typed))
    };
    let commands: Vec<Man> = program.get_subcommands().map(of_command).collect();
    std::iter::once(Man::new(program)).chain(commands).collect()
}

fn write_file(path: &Path, content: &[u8]) -> io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(path, content)
}
