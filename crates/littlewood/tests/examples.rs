//! The examples of `examples/` run to their end; what they claim they assert.

use std::path::Path;
use std::process::Command;

#[test]
fn every_example_runs() {
    let this = std::env::current_exe().expect("the path of this test");
    let built = this
        .ancestors()
        .nth(2)
        .expect("the build folder")
        .join("examples");
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let mut count = 0;
    for entry in sources.read_dir().expect("the folder of examples") {
        let source = entry.expect("an entry").path();
        let name = source.file_stem().expect("a name");
        let program = built
            .join(name)
            .with_extension(std::env::consts::EXE_EXTENSION);
        let output = Command::new(&program)
            .output()
            .expect("`cargo test` builds the examples");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {errors}", source.display());
        assert!(
            !output.stdout.is_empty(),
            "{} prints nothing",
            source.display()
        );
        count += 1;
    }
    assert!(count >= 6, "{count} examples");
}
