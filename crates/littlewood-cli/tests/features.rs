//! What the program says of parts that it was built without.

use crate::support::{complaint, text};

/// The commands of each feature, and whether this program has them.
const COMMANDS: [(&str, &str, bool); 6] = [
    ("sweep", "sweep", cfg!(feature = "sweep")),
    ("atlas", "sweep", cfg!(feature = "sweep")),
    ("figures", "figures", cfg!(feature = "figures")),
    ("poster", "figures", cfg!(feature = "figures")),
    ("animate", "film", cfg!(feature = "film")),
    ("lab", "lab", cfg!(feature = "lab")),
];

#[test]
fn a_command_that_is_not_there_names_its_feature() {
    for (command, feature, is_there) in COMMANDS {
        if is_there {
            assert!(text(&[command, "--help"]).contains("Usage: "), "{command}");
            continue;
        }
        for arguments in [&[command][..], &[command, "figure-3", "--out", "a.gif"], &[command, "--help"]] {
            let message = complaint(arguments, 2);
            let said = format!(
                "`littlewood {command}` is not in this program: it was built without the feature `{feature}`"
            );
            assert!(message.contains(&said), "{message}");
            assert!(
                message
                    .contains(&format!("hint: in the sources, `cargo run --release --features {feature} ")),
                "{message}"
            );
        }
        let help = text(&["--help"]).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(help.contains(&format!("(not in this program: feature `{feature}`)")), "{help}");
    }
}

#[cfg(not(feature = "sweep"))]
#[test]
fn a_store_that_cannot_be_written_names_the_feature() {
    for name in ["plane.zarr", "plane.parquet"] {
        let axes = ["--x", "theta=0:1:2", "--y", "theta_rate=0:1:2"];
        let message = complaint(&[&["map", "figure-3", "--out", name], &axes[..]].concat(), 2);
        assert!(message.contains(name) && message.contains("feature `sweep`"), "{message}");
    }
}
