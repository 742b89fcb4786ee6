//! Builds the program again when the laboratory has been built again. The laboratory itself needs node, the program
//! does not: without `web/dist` it says how to make it.

use std::path::Path;

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    // A path that does not exist would build the program anew each time; its folder shows when it comes.
    if let Some(path) = ["../../web/dist", "../../web"].into_iter().find(|path| Path::new(path).exists()) {
        println!("cargo:rerun-if-changed={path}");
    }
}
