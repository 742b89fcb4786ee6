//! The server of the laboratory, as a browser and as somebody else's page meet it.

mod support;

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};

use support::complaint;

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

/// Starts the server; none where the program was built without the page, which it then says.
fn lab() -> Option<Lab> {
    let program = assert_cmd::cargo::cargo_bin("littlewood");
    let mut child = Command::new(program)
        .args(["lab", "--no-open"])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    let mut line = String::new();
    BufReader::new(child.stdout.take().expect("a pipe")).read_line(&mut line).expect("a line");
    let Some(address) = line.trim().strip_prefix("The laboratory is at http://127.0.0.1:") else {
        assert_eq!(child.wait().expect("it ends").code(), Some(1));
        let message = complaint(&["lab", "--no-open"], 1);
        assert!(
            message.contains("built without the laboratory") && message.contains("web/build.sh"),
            "{message}"
        );
        return None;
    };
    let port = address.trim_end_matches('/').parse().expect("a port");
    Some(Lab { child, port })
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
    let Some(lab) = lab() else { return };
    let port = lab.port;
    let get = |method: &str, host: &str, path: &str| {
        ask(port, &format!("{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"))
    };
    let ours = format!("127.0.0.1:{port}");
    let page = get("GET", &ours, "/");
    assert!(page.starts_with("HTTP/1.1 200") && page.contains("<!doctype html>"), "{page}");
    assert!(page.contains("Content-Security-Policy: default-src 'none'"), "{page}");
    let head = get("HEAD", &ours, "/");
    assert!(head.starts_with("HTTP/1.1 200") && head.ends_with("\r\n\r\n"), "{head}");
    assert!(get("GET", "evil.example", "/").starts_with("HTTP/1.1 421"));
    assert!(get("POST", &ours, "/").starts_with("HTTP/1.1 405"));
    assert!(get("GET", &ours, "/../Cargo.toml").starts_with("HTTP/1.1 404"));

    let taken = complaint(&["lab", "--no-open", "--port", &port.to_string()], 1);
    assert!(taken.contains(&format!("cannot listen on port {port} of 127.0.0.1")), "{taken}");
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_it() {
    let Some(mut lab) = lab() else { return };
    let id = lab.child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &id]).status().expect("there is a kill").success());
    assert_eq!(lab.child.wait().expect("it ends").code(), Some(0));
}
