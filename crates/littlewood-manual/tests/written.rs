//! Every command has a page, and every shell knows every command.

use std::fs;
use std::path::PathBuf;

use littlewood_manual::{SHELLS, place, write};

#[test]
fn pages_and_completions_have_every_command() {
    let prefix: PathBuf = [env!("CARGO_TARGET_TMPDIR"), "prefix"].iter().collect();
    write(&prefix).expect("a folder that can be written to");
    let command = littlewood_cli::command();
    let commands: Vec<String> =
        command.get_subcommands().map(|command| command.get_name().to_owned()).collect();
    assert!(commands.iter().any(|command| command == "simulate"));
    let program =
        fs::read_to_string(prefix.join("share/man/man1/littlewood.1")).expect("the page of the program");
    for command in &commands {
        let page = prefix.join(format!("share/man/man1/littlewood-{command}.1"));
        let page = fs::read_to_string(page).expect("a page");
        assert!(page.contains(&format!("\\fBlittlewood {command}\\fR")), "{command}: {page}");
        assert!(program.contains(&format!("littlewood\\-{command}(1)")), "{command}");
    }
    for shell in SHELLS {
        let script = fs::read_to_string(prefix.join(place(shell).expect("a place"))).expect("a script");
        for command in &commands {
            assert!(script.contains(command), "{shell}: {command}");
        }
        assert!(script.contains("--mass-ratio") || script.contains("mass-ratio"), "{shell}");
    }
}
