//! The server of the laboratory, as a browser and as somebody else's page meet it.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

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

/// A page, its story and two scripts.
fn page() -> TempDir {
    let folder = TempDir::new().expect("a folder");
    std::fs::create_dir(folder.path().join("assets")).expect("a folder");
    for name in ["index.html", "story.html", "sw.js", "assets/a.js"] {
        std::fs::write(folder.path().join(name), "<!doctype html>").expect("written");
    }
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
    BufReader::new(child.stdout.take().expect("a pipe"))
        .read_line(&mut line)
        .expect("a line");
    let address = line
        .trim()
        .strip_prefix("The laboratory is at http://127.0.0.1:")
        .expect("an address");
    let port = address.trim_end_matches('/').parse().expect("a port");
    Lab { child, port }
}

fn ask(port: u16, request: &str) -> String {
    let mut stream = TcpStream::connect(("127.0.0.1", port)).expect("it listens");
    stream.write_all(request.as_bytes()).expect("it reads");
    let mut answer = Vec::new();
    stream
        .read_to_end(&mut answer)
        .expect("it answers and closes");
    String::from_utf8_lossy(&answer).into_owned()
}

#[test]
fn the_page_is_served_to_this_machine_alone() {
    let lab = lab();
    let port = lab.port;
    let get = |method: &str, host: &str, path: &str| {
        ask(
            port,
            &format!("{method} {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"),
        )
    };
    let ours = format!("127.0.0.1:{port}");
    let first = get("GET", &ours, "/");
    assert!(
        first.starts_with("HTTP/1.1 200") && first.contains("<!doctype html>"),
        "{first}"
    );
    assert!(
        first.contains("Content-Security-Policy: default-src 'none'"),
        "{first}"
    );
    let head = get("HEAD", &ours, "/");
    assert!(
        head.starts_with("HTTP/1.1 200") && head.ends_with("\r\n\r\n"),
        "{head}"
    );
    for header in [
        "Content-Type: text/html; charset=utf-8",
        "X-Content-Type-Options: nosniff",
    ] {
        assert!(
            first.contains(header) && first.contains("Cache-Control: no-cache"),
            "{first}"
        );
    }
    let script = get("GET", &format!("localhost:{port}"), "/assets/a.js");
    assert!(
        script.contains("Content-Type: text/javascript; charset=utf-8"),
        "{script}"
    );
    assert!(
        script.contains("Cache-Control: max-age=31536000, immutable"),
        "{script}"
    );
    let written = get("POST", &ours, "/");
    assert!(
        written.starts_with("HTTP/1.1 405") && written.contains("Allow: GET, HEAD"),
        "{written}"
    );
    // Pages of this machine may have it in a frame, and no others.
    assert!(
        first.contains("frame-ancestors http://127.0.0.1:* http://localhost:*\r\n"),
        "{first}"
    );
    // The script that would stay in the browser is one that ends itself.
    let worker = get("GET", &ours, "/sw.js");
    assert!(
        worker.contains("Content-Type: text/javascript") && worker.contains(".unregister()"),
        "{worker}"
    );
    assert!(!worker.contains("<!doctype html>"), "{worker}");
    // The story has an address without its ending.
    for (path, status) in [
        ("/?x=1", 200),
        ("/story", 200),
        ("/story.html", 200),
        ("/story?x=1", 200),
        ("/sheet", 404),
        ("/etc/passwd", 404),
        ("/../Cargo.toml", 404),
        ("//index.html", 404),
        ("index.html", 404),
        ("*", 404),
        ("/assets", 404),
        ("/assets/../../index.html", 404),
    ] {
        let answer = get("GET", &ours, path);
        assert!(
            answer.starts_with(&format!("HTTP/1.1 {status}")),
            "{path}: {answer}"
        );
    }
    for host in [
        "evil.example",
        &format!("evil.example:{port}"),
        "127.0.0.1",
        "127.0.0.1:1",
    ] {
        let answer = get("GET", host, "/");
        assert!(
            answer.starts_with("HTTP/1.1 421") && !answer.contains("<!doctype"),
            "{host}: {answer}"
        );
    }

    let same = page();
    let folder = same.path().to_str().expect("a name in UTF-8");
    let taken = complaint(
        &[
            "lab",
            "--no-open",
            "--page",
            folder,
            "--port",
            &port.to_string(),
        ],
        1,
    );
    assert!(
        taken.contains(&format!("cannot listen on port {port} of 127.0.0.1")),
        "{taken}"
    );
}

/// The first line of the answer to what may be no request at all, and how long it took.
fn answer_to(port: u16, request: &[u8]) -> (String, Duration) {
    let began = Instant::now();
    let mut stream = TcpStream::connect(("127.0.0.1", port)).expect("it listens");
    stream
        .set_read_timeout(Some(Duration::from_secs(20)))
        .expect("a time limit");
    // It may have answered, and closed, before it was asked to the end.
    let _ = stream.write_all(request);
    let mut answer = Vec::new();
    let _ = stream.read_to_end(&mut answer);
    let line = String::from_utf8_lossy(&answer)
        .lines()
        .next()
        .unwrap_or_default()
        .trim_end()
        .to_owned();
    (line, began.elapsed())
}

/// Most memory that a process has held, in kilobytes.
#[cfg(target_os = "linux")]
fn memory(lab: &Lab) -> u64 {
    let status =
        std::fs::read_to_string(format!("/proc/{}/status", lab.child.id())).expect("it runs");
    let line = status
        .lines()
        .find_map(|line| line.strip_prefix("VmHWM:"))
        .expect("its memory");
    line.trim()
        .trim_end_matches(" kB")
        .parse()
        .expect("a number")
}

#[test]
fn a_body_is_refused_without_waiting_for_it() {
    let lab = lab();
    let ours = format!("Host: 127.0.0.1:{}", lab.port);
    for (first, host, more, expected) in [
        (
            "POST / HTTP/1.1",
            "Host: evil.com",
            "Content-Length: 99999999999",
            "HTTP/1.1 421",
        ),
        (
            "POST / HTTP/1.1",
            &ours,
            "Content-Length: 99999999999",
            "HTTP/1.1 405",
        ),
        (
            "POST / HTTP/1.1",
            &ours,
            "Transfer-Encoding: chunked",
            "HTTP/1.1 405",
        ),
        (
            "GET / HTTP/1.1",
            &ours,
            "Content-Length: 18446744073709551616",
            "HTTP/1.1 413",
        ),
        (
            "GET / HTTP/1.1",
            &ours,
            "Content-Length: -1",
            "HTTP/1.1 413",
        ),
        (
            "GET / HTTP/1.1",
            &ours,
            "Transfer-Encoding: chunked",
            "HTTP/1.1 413",
        ),
        (
            "GET / HTTP/1.1",
            &ours,
            "Expect: 100-continue\r\nContent-Length: 5",
            "HTTP/1.1 413",
        ),
        ("GET / HTTP/1.1", &ours, "Content-Length: 0", "HTTP/1.1 200"),
    ] {
        let (answer, time) = answer_to(
            lab.port,
            format!("{first}\r\n{host}\r\n{more}\r\n\r\n").as_bytes(),
        );
        assert_eq!(answer, expected, "{first}, {host}, {more}");
        // Nothing is sent after the head: a server that waits for it does not answer.
        assert!(
            time < Duration::from_secs(5),
            "{first}, {host}, {more}: {time:?}"
        );
    }
}

#[cfg(target_os = "linux")]
#[test]
fn what_is_sent_is_not_kept() {
    let lab = lab();
    let before = memory(&lab);
    let mut stream = TcpStream::connect(("127.0.0.1", lab.port)).expect("it listens");
    stream
        .set_write_timeout(Some(Duration::from_secs(5)))
        .expect("a time limit");
    let host = format!("127.0.0.1:{}", lab.port);
    let head = format!("POST / HTTP/1.1\r\nHost: {host}\r\nContent-Length: 3000000000\r\n\r\n");
    stream
        .write_all(head.as_bytes())
        .expect("it reads the head");
    let sent = (0..64)
        .take_while(|_| stream.write_all(&[b'x'; 1 << 20]).is_ok())
        .count();
    assert!(sent < 64, "all 64 MiB were taken");
    assert!(
        memory(&lab) < before + 4096,
        "{} kB, {before} kB before",
        memory(&lab)
    );
    assert!(
        ask(lab.port, &format!("GET / HTTP/1.1\r\nHost: {host}\r\n\r\n"))
            .starts_with("HTTP/1.1 200")
    );
}

#[test]
fn what_is_no_request_is_refused() {
    let lab = lab();
    let ours = format!("Host: 127.0.0.1:{}\r\n", lab.port);
    let long = "a".repeat(100_000);
    for (request, expected) in [
        (format!("GET /\0 HTTP/1.1\r\n{ours}\r\n"), "HTTP/1.1 400"),
        (
            format!("GET / HTTP/1.1\r\n{ours}X: \0\r\n\r\n"),
            "HTTP/1.1 400",
        ),
        (
            format!("GET / HTTP/1.1\r\n{ours}{ours}\r\n"),
            "HTTP/1.1 400",
        ),
        (format!("GET / HTTP/2\r\n{ours}\r\n"), "HTTP/1.1 400"),
        ("\r\n\r\n".to_owned(), "HTTP/1.1 400"),
        ("GET\r\n\r\n".to_owned(), "HTTP/1.1 400"),
        (format!("GET /\r\n{ours}\r\n"), "HTTP/1.1 400"),
        (format!("GET  / HTTP/1.1\r\n{ours}\r\n"), "HTTP/1.1 400"),
        (format!("GET / HTTP/1.1 \r\n{ours}\r\n"), "HTTP/1.1 400"),
        (format!("G\u{7f}T / HTTP/1.1\r\n{ours}\r\n"), "HTTP/1.1 400"),
        (
            format!("GET / HTTP/1.1\r\n{ours}X: a\nY: b\r\n\r\n"),
            "HTTP/1.1 400",
        ),
        (format!("GET / HTTP/1.1\r\n{ours}X\r\n\r\n"), "HTTP/1.1 400"),
        (
            format!("GET / HTTP/1.1\r\n{ours}X : a\r\n\r\n"),
            "HTTP/1.1 400",
        ),
        (
            format!("GET / HTTP/1.1\r\n{ours}: a\r\n\r\n"),
            "HTTP/1.1 400",
        ),
        (
            format!("GET / HTTP/1.1\r\n{ours} folded\r\n\r\n"),
            "HTTP/1.1 400",
        ),
        (
            format!("GET /{long} HTTP/1.1\r\n{ours}\r\n"),
            "HTTP/1.1 431",
        ),
        (
            format!("GET / HTTP/1.1\r\n{ours}X: {long}\r\n\r\n"),
            "HTTP/1.1 431",
        ),
        (
            format!("GET / HTTP/1.1\r\n{ours}{}\r\n", "A: a\r\n".repeat(20_000)),
            "HTTP/1.1 431",
        ),
        ("GET / HTTP/1.1\r\n\r\n".to_owned(), "HTTP/1.1 421"),
        (
            format!(
                "GET /index.html?{} HTTP/1.1\r\n{ours}\r\n",
                "a".repeat(20_000)
            ),
            "HTTP/1.1 200",
        ),
    ] {
        assert_eq!(
            answer_to(lab.port, request.as_bytes()).0,
            expected,
            "{request:.60?}"
        );
    }
    let request = [
        format!("GET / HTTP/1.1\r\n{ours}X: ").as_bytes(),
        b"\xff\r\n\r\n",
    ]
    .concat();
    assert_eq!(answer_to(lab.port, &request).0, "HTTP/1.1 400");
}

#[test]
fn silent_and_slow_clients_do_not_keep_others_from_the_page() {
    let lab = lab();
    let request = format!("GET / HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", lab.port);
    // A browser leaves connections idle that it has opened in advance.
    let idle: Vec<TcpStream> = (0..20)
        .map(|_| TcpStream::connect(("127.0.0.1", lab.port)).expect("it listens"))
        .collect();
    let (answer, time) = answer_to(lab.port, request.as_bytes());
    assert_eq!(answer, "HTTP/1.1 200");
    assert!(time < Duration::from_secs(5), "{time:?}");
    // Far more than it holds: each is closed at once, or after a while.
    let began = Instant::now();
    let mut more: Vec<TcpStream> = (0..200)
        .map(|_| TcpStream::connect(("127.0.0.1", lab.port)).expect("it listens"))
        .collect();
    for (i, stream) in more.iter_mut().enumerate() {
        stream
            .set_read_timeout(Some(Duration::from_secs(20)))
            .expect("a time limit");
        // A byte now and then does not win time.
        let _ = stream.write_all(if i % 2 == 0 { b"G" } else { b"" });
        let _ = stream
            .read(&mut [0])
            .map(|count| assert_eq!(count, 0))
            .map_err(|error| {
                assert_eq!(
                    error.kind(),
                    std::io::ErrorKind::ConnectionReset,
                    "it is closed in 20 s"
                );
            });
    }
    assert!(
        began.elapsed() < Duration::from_secs(20),
        "{:?}",
        began.elapsed()
    );
    drop(idle);
    assert_eq!(answer_to(lab.port, request.as_bytes()).0, "HTTP/1.1 200");
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_it() {
    let mut lab = lab();
    let id = lab.child.id().to_string();
    assert!(
        Command::new("kill")
            .args(["-INT", &id])
            .status()
            .expect("there is a kill")
            .success()
    );
    assert_eq!(lab.child.wait().expect("it ends").code(), Some(0));
}

#[test]
fn a_folder_without_a_page_is_refused_with_the_ways_to_one() {
    let folder = TempDir::new().expect("a folder");
    let message = complaint(
        &[
            "lab",
            "--no-open",
            "--page",
            folder.path().to_str().expect("UTF-8"),
        ],
        1,
    );
    assert!(message.contains("there is no page in"), "{message}");
    assert!(
        message.contains("released program") && message.contains("web/build.sh"),
        "{message}"
    );
}
