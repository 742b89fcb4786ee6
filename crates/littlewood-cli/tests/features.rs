//! What a program says of parts that it was built without.

use assert_cmd::Command;

use crate::support::littlewood;

/// The commands of each feature, and whether the program of these tests has them.
const COMMANDS: [(&str, &str, bool); 5] = [
    ("sweep", "sweep", cfg!(feature = "sweep")),
    ("figures", "figures", cfg!(feature = "figures")),
    ("poster", "figures", cfg!(feature = "figures")),
    ("animate", "film", cfg!(feature = "film")),
    ("lab", "lab", cfg!(feature = "lab")),
];

/// Names a program that was built without any feature.
const WITHOUT_FEATURES: &str = "LITTLEWOOD_WITHOUT_FEATURES";

fn without_features() -> Command {
    Command::new(std::env::var_os(WITHOUT_FEATURES).expect(WITHOUT_FEATURES))
}

fn help_of(mut program: Command, arguments: &[&str]) -> String {
    String::from_utf8_lossy(
        &program
            .args(arguments)
            .assert()
            .success()
            .get_output()
            .stdout,
    )
    .into_owned()
}

/// The error of a call that is refused, which prints nothing.
fn refusal(mut program: Command, arguments: &[&str]) -> String {
    String::from_utf8_lossy(
        &program
            .args(arguments)
            .assert()
            .code(2)
            .stdout("")
            .get_output()
            .stderr,
    )
    .into_owned()
}

fn check(program: fn() -> Command, has: impl Fn(bool) -> bool) {
    for (command, feature, is_there) in COMMANDS {
        if has(is_there) {
            assert!(
                help_of(program(), &[command, "--help"]).contains("Usage: "),
                "{command}"
            );
            continue;
        }
        for arguments in [
            &[command][..],
            &[command, "figure-3", "--out", "a.gif"],
            &[command, "--help"],
        ] {
            let message = refusal(program(), arguments);
            let said = format!(
                "`littlewood {command}` requires the feature `{feature}`, which is not compiled in"
            );
            assert!(message.contains(&said), "{message}");
            let hint = format!("hint: build it with `cargo run --release --features {feature} ");
            assert!(message.contains(&hint), "{message}");
        }
        let help = help_of(program(), &["--help"])
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ");
        assert!(
            help.contains(&format!("(requires the feature `{feature}`)")),
            "{help}"
        );
    }
    if !has(cfg!(feature = "sweep")) {
        for name in ["plane.zarr", "plane.parquet"] {
            let message = refusal(
                program(),
                &[
                    "map",
                    "figure-3",
                    "--out",
                    name,
                    "--x",
                    "theta=0:1:2",
                    "--y",
                    "theta_rate=0:1:2",
                ],
            );
            assert!(
                message.contains(name) && message.contains("feature `sweep`"),
                "{message}"
            );
        }
    }
}

#[test]
fn a_command_is_there_or_names_its_feature() {
    check(littlewood, |is_there| is_there);
}

#[test]
fn commands_of_the_python_package_are_named_and_say_where_they_are() {
    for command in ["fit", "score", "certify"] {
        for arguments in [
            &[command][..],
            &[command, "figure-3", "a.csv"],
            &[command, "--help"],
        ] {
            let message = refusal(littlewood(), arguments);
            assert!(
                message.contains(&format!(
                    "`littlewood {command}` is part of the Python package"
                )),
                "{message}"
            );
            assert!(
                message.contains(&format!("python -m littlewood {command} --help")),
                "{message}"
            );
        }
    }
}

#[test]
fn a_removed_command_names_what_does_the_same() {
    for arguments in [
        &["atlas"][..],
        &["atlas", "figure-3", "--first-turn", "--axis", "mu_s=0:1:9"],
        &["atlas", "--help"],
    ] {
        let message = refusal(littlewood(), arguments);
        for said in [
            "`littlewood atlas` was removed",
            "`littlewood map --shade sequence`",
            "`theron_maritz`",
        ] {
            assert!(message.contains(said), "{message}");
        }
    }
    // It is not among the commands of the help.
    assert!(!help_of(littlewood(), &["--help"]).contains("atlas"));
}

/// A program of its own, because Cargo builds one for all tests of a run.
#[test]
#[ignore = "LITTLEWOOD_WITHOUT_FEATURES has to name a program that was built without features"]
fn a_program_without_features_names_them() {
    check(without_features, |_| false);
}
