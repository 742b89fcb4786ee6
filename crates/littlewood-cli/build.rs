//! Builds the program again when the laboratory has been built again. The laboratory itself needs node, the program
//! does not: without `web/dist` it says how to make it.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed=../../web/dist");
}
