//! HTTP/1.1, as far as a page needs it: one request a connection, its head alone, within bounds of
//! size and time. Nothing is allocated by what a request says of itself, and a body is never waited
//! for.

use std::io::{self, ErrorKind, Read, Write};
use std::net::{Shutdown, TcpListener, TcpStream};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

use super::answer::{Answer, MALFORMED, Question, TOO_LONG};

/// The longest head of a request: a link with the whole state, and the cookies of every server of
/// this machine.
const HEAD: usize = 32 * 1024;

/// Connections at a time. A browser opens six, and some that it then leaves idle.
const CONNECTIONS: usize = 64;

/// How long a connection may take, from its first byte to its last.
const PATIENCE: Duration = Duration::from_secs(5);

/// What is read after an answer, so that a client that still sends gets to read it.
const DRAIN: usize = 64 * 1024;

/// How long an answer waits for such a client.
const FAREWELL: Duration = Duration::from_secs(1);

/// How long the server waits where the system has no more connections to give.
const PAUSE: Duration = Duration::from_millis(100);

pub(super) fn serve(
    listener: &TcpListener,
    answer: impl Fn(&Question<'_>) -> Answer + Send + Sync + 'static,
) {
    // Each thread holds a copy, by which they are counted.
    let answer = Arc::new(answer);
    for stream in listener.incoming() {
        let Ok(stream) = stream else {
            thread::sleep(PAUSE);
            continue;
        };
        // Beyond that number a connection is closed at once, and so is one for which the system has
        // no thread.
        if Arc::strong_count(&answer) <= CONNECTIONS {
            let answer = Arc::clone(&answer);
            let _ = thread::Builder::new().spawn(move || {
                // A client that has left, or that takes too long, wants no answer.
                let _ = converse(&stream, answer.as_ref());
            });
        }
    }
}

fn converse(stream: &TcpStream, answer: &impl Fn(&Question<'_>) -> Answer) -> io::Result<()> {
    let end = Instant::now() + PATIENCE;
    let head = read_head(stream, end)?;
    let request = head.as_deref().map(parse);
    let (reads_body, answer) = match &request {
        None => (true, TOO_LONG.answer()),
        Some(None) => (true, MALFORMED.answer()),
        Some(Some((method, question))) => (*method != "HEAD", answer(question)),
    };
    write(stream, head_of(&answer).as_bytes(), end)?;
    if reads_body {
        write(stream, &answer.body, end)?;
    }
    stream.shutdown(Shutdown::Write)?;
    drain(stream, end.min(Instant::now() + FAREWELL))
}

/// The head of a request, up to the empty line; none if it is too long.
fn read_head(mut stream: &TcpStream, end: Instant) -> io::Result<Option<Vec<u8>>> {
    let mut head = vec![0; HEAD];
    let mut length = 0;
    while let Some(rest) = head.get_mut(length..).filter(|rest| !rest.is_empty()) {
        stream.set_read_timeout(Some(until(end)?))?;
        let count = stream.read(rest)?;
        if count == 0 {
            return Err(ErrorKind::UnexpectedEof.into());
        }
        // The empty line may have begun in what was read before.
        let from = length.saturating_sub(EMPTY_LINE.len());
        length += count;
        if let Some(at) = head[from..length]
            .windows(EMPTY_LINE.len())
            .position(|four| four == EMPTY_LINE)
        {
            head.truncate(from + at);
            return Ok(Some(head));
        }
    }
    Ok(None)
}

const EMPTY_LINE: &[u8] = b"\r\n\r\n";

/// Method and question of a head; none if it is malformed.
fn parse(head: &[u8]) -> Option<(&str, Question<'_>)> {
    let text = str::from_utf8(head).ok()?;
    let mut lines = text.split("\r\n");
    let mut words = lines.next()?.split(' ');
    let (method, path, version) = (words.next()?, words.next()?, words.next()?);
    let is_token =
        |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_graphic());
    if !is_token(method)
        || !is_token(path)
        || words.next().is_some()
        || !version.starts_with("HTTP/1.")
    {
        return None;
    }
    let (mut host, mut has_body) = (None, false);
    for line in lines {
        let (name, value) = line.split_once(':')?;
        let value = value.trim_matches([' ', '\t']);
        if !is_token(name) || value.contains(|letter: char| letter.is_control() && letter != '\t') {
            return None;
        }
        if name.eq_ignore_ascii_case("host") {
            if host.replace(value).is_some() {
                return None;
            }
        } else if name.eq_ignore_ascii_case("content-length") {
            has_body |= value != "0";
        } else if name.eq_ignore_ascii_case("transfer-encoding") {
            has_body = true;
        }
    }
    Some((
        method,
        Question {
            reads: matches!(method, "GET" | "HEAD"),
            has_body,
            host,
            path,
        },
    ))
}

fn head_of(answer: &Answer) -> String {
    let Answer {
        status,
        headers,
        body,
    } = answer;
    let mut head = format!(
        "HTTP/1.1 {status} \r\nContent-Length: {}\r\nConnection: close\r\n",
        body.len()
    );
    for (name, value) in headers {
        head.push_str(&format!("{name}: {value}\r\n"));
    }
    head + "\r\n"
}

fn write(mut stream: &TcpStream, mut bytes: &[u8], end: Instant) -> io::Result<()> {
    while !bytes.is_empty() {
        stream.set_write_timeout(Some(until(end)?))?;
        let count = stream.write(bytes)?;
        if count == 0 {
            return Err(ErrorKind::WriteZero.into());
        }
        bytes = bytes.get(count..).unwrap_or_default();
    }
    Ok(())
}

/// Reads what the client has sent beyond its request: a connection that is closed before takes the
/// answer with it.
fn drain(mut stream: &TcpStream, end: Instant) -> io::Result<()> {
    let mut bytes = [0; 4096];
    let mut total = 0;
    while total < DRAIN {
        stream.set_read_timeout(Some(until(end)?))?;
        match stream.read(&mut bytes)? {
            0 => break,
            count => total += count,
        }
    }
    Ok(())
}

fn until(end: Instant) -> io::Result<Duration> {
    let left = end.saturating_duration_since(Instant::now());
    if left.is_zero() {
        Err(ErrorKind::TimedOut.into())
    } else {
        Ok(left)
    }
}
