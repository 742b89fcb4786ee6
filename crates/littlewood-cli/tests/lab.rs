//! The server of the laboratory, as a browser and as somebody else's page meet it.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};

use tempfile::TempDir;

use crate::support::complaint;

/// A running server. It ends with the test.
struct Lab {
    child: Child,
    port: u16,
}

impl Drop for Lab {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A page of one file.
fn page() -> TempDir {
    let folder = TempDir::new().expect("a folder");
    std::fs::write(folder.path().join("index.html"), "<!doctype html>").expect("written");
    folder
}

/// Starts the server with that page.
fn lab() -> Lab {
    let program = assert_cmd::cargo::cargo_bin("littlewood");
    let page = page();
    let mut child = Command::new(program)
        .args(["lab", "--no-open", "--page"])
        .arg(page.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let mut line = String::new();
    BufReader::new(child.stdout.take().expect("a pipe")).read_line(&mut line).expect("a line");
    let address = line.trim().strip_prefix("The laboratory is at http://127.0.0.1:").expect("an address");
    let port = address.trim_end_matches('/').parse().expect("a port");
    Lab { child, port }
}

fn ask(port: u16, request: &str) -> String {
    let mut stream = TcpStream::connect(("127.0.0.1", port)).expect("it listens");
    stream.write_all(request.as_bytes()).expect("it reads");
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).expect("it answers and closes");
    String::from_utf8_lossy(&answer).into_owned()
}

#[test]
fn the_page_is_served_to_this_machine_alone() {
    let lab = lab();
    let port = lab.port;
    let get = |method: &str, host: &str, path: &str| {
        ask(port, &format!("{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"))
    };
    let ours = format!("127.0.0.1:{port}");
    let first = get("GET", &ours, "/");
    assert!(first.starts_with("HTTP/1.1 200") && first.contains("<!doctype html>"), "{first}");
    assert!(first.contains("Content-Security-Policy: default-src 'none'"), "{first}");
    let head = get("HEAD", &ours, "/");
    assert!(head.starts_with("HTTP/1.1 200") && head.ends_with("\r\n\r\n"), "{head}");
    assert!(get("GET", "evil.example", "/").starts_with("HTTP/1.1 421"));
    assert!(get("POST", &ours, "/").starts_with("HTTP/1.1 405"));
    assert!(get("GET", &ours, "/../Cargo.toml").starts_with("HTTP/1.1 404"));

    let same = page();
    let folder = same.path().to_str().expect("a name in UTF-8");
    let taken = complaint(&["lab", "--no-open", "--page", folder, "--port", &port.to_string()], 1);
    assert!(taken.contains(&format!("cannot listen on port {port} of 127.0.0.1")), "{taken}");
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_it() {
    let mut lab = lab();
    let id = lab.child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().expect("there is a kill").success());
    assert_eq!(lab.child.wait().expect("it ends").code(), Some(0));
}

#[test]
fn a_folder_without_a_page_is_refused_with_the_ways_to_one() {
    let folder = TempDir::new().expect("a folder");
    let message = complaint(&["lab", "--no-open", "--page", folder.path().to_str().expect("UTF-8")], 1);
    assert!(message.contains("there is no page in"), "{message}");
    assert!(message.contains("released program") && message.contains("web/build.sh"), "{message}");
}
