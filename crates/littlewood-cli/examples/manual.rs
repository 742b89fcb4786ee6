//! `manual PREFIX` writes the shell completions and the manual pages of the command line, from its
//! definition, below a prefix such as `/usr/local`. An example, so that neither the program nor
//! those who build it pay for the generators.

use std::fs;
use std::io;
use std::path::Path;
use std::process::ExitCode;

use clap_complete::Shell;
use clap_complete::aot::generate;

/// Shells, and where each looks for the completions of a program below a prefix.
const SHELLS: [(Shell, &str); 5] = [
    (Shell::Bash, "share/bash-completion/completions/littlewood"),
    (
        Shell::Fish,
        "share/fish/vendor_completions.d/littlewood.fish",
    ),
    (Shell::Zsh, "share/zsh/site-functions/_littlewood"),
    (Shell::Elvish, "share/elvish/lib/littlewood.elv"),
    (Shell::PowerShell, "share/powershell/littlewood.ps1"),
];

/// Writes completions and manual pages below the prefix.
fn write(prefix: &Path) -> io::Result<()> {
    for (shell, place) in SHELLS {
        let mut script = Vec::new();
        generate(
            shell,
            &mut littlewood_cli::command(),
            "littlewood",
            &mut script,
        );
        let path = prefix.join(place);
        fs::create_dir_all(path.parent().unwrap_or(prefix))?;
        fs::write(path, script)?;
    }
    let pages = prefix.join("share/man/man1");
    fs::create_dir_all(&pages)?;
    // A page for the program and one for each command; none for `help`, which lists them.
    clap_mangen::generate_to(
        littlewood_cli::command().disable_help_subcommand(true),
        pages,
    )
}

fn main() -> io::Result<ExitCode> {
    let mut arguments = std::env::args_os().skip(1);
    let (Some(prefix), None) = (arguments.next(), arguments.next()) else {
        eprintln!("usage: manual PREFIX");
        return Ok(ExitCode::from(2));
    };
    write(Path::new(&prefix))?;
    Ok(ExitCode::SUCCESS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pages_and_completions_have_every_command() {
        let prefix = tempfile::tempdir().expect("a folder");
        write(prefix.path()).expect("a folder that can be written to");
        let read = |place: &str| fs::read_to_string(prefix.path().join(place)).expect("a file");
        let command = littlewood_cli::command();
        let commands: Vec<&str> = command
            .get_subcommands()
            .filter(|command| !command.is_hide_set())
            .map(clap::Command::get_name)
            .collect();
        assert!(commands.contains(&"simulate"));
        let program = read("share/man/man1/littlewood.1");
        for command in &commands {
            let page = read(&format!("share/man/man1/littlewood-{command}.1"));
            assert!(
                page.contains(&format!("\\fBlittlewood {command}\\fR")),
                "{command}: {page}"
            );
            assert!(
                program.contains(&format!("littlewood\\-{command}(1)")),
                "{command}"
            );
        }
        for (shell, place) in SHELLS {
            let script = read(place);
            for command in &commands {
                assert!(script.contains(command), "{shell}: {command}");
            }
            assert!(script.contains("mass-ratio"), "{shell}");
        }
    }
}
