//! `littlewood lab`: serves the laboratory, the page in which a motion is dragged and watched, to this machine alone.

mod answer;
mod assets;
mod browser;
mod source;

use std::io::{self, Write};
use std::net::Ipv4Addr;
use std::sync::atomic::Ordering;
use std::thread;
use std::time::Duration;

use tiny_http::{Header, Method, Request, Response, Server};

use crate::args::LabArgs;
use crate::error::Error;
use crate::interrupt;

use answer::{Answer, Question, answer};
use assets::Page;

/// Threads that answer requests. A browser requests several files at once.
const THREADS: usize = 4;

/// How long a thread waits before it looks whether Ctrl-C has come.
const LOOK: Duration = Duration::from_millis(100);

/// Runs the command, until Ctrl-C.
///
/// # Errors
/// There is no page, the port is taken, or the address cannot be printed.
pub(crate) fn run(args: &LabArgs) -> Result<(), Error> {
    let page = source::page(args.page.as_deref())?;
    let server = Server::http((Ipv4Addr::LOCALHOST, args.port))
        .map_err(|source| Error::Port { port: args.port, source: into_io(source) })?;
    let port = server.server_addr().to_ip().map_or(args.port, |address| address.port());
    let asked_to_stop = interrupt::asked();
    let address = format!("http://127.0.0.1:{port}/");
    announce(&address)?;
    if !args.no_open {
        // The address has been printed: without a browser it can be typed.
        let _ = browser::open(&address);
    }
    thread::scope(|scope| {
        for _ in 0..THREADS {
            scope.spawn(|| {
                while !asked_to_stop.load(Ordering::Relaxed) {
                    if let Ok(Some(request)) = server.recv_timeout(LOOK) {
                        respond(request, port, &page);
                    }
                }
            });
        }
    });
    Ok(())
}

fn announce(address: &str) -> Result<(), Error> {
    let mut out = io::stdout().lock();
    writeln!(out, "The laboratory is at {address}\nCtrl-C ends it.")
        .and_then(|()| out.flush())
        .map_err(|source| Error::Write { target: "the standard output".to_owned(), source })
}

fn respond(request: Request, port: u16, page: &Page) {
    let host = request.headers().iter().find(|header| header.field.equiv("Host"));
    let question = Question {
        reads: matches!(request.method(), Method::Get | Method::Head),
        host: host.map(|header| header.value.as_str()),
        path: request.url(),
    };
    let Answer { status, headers, body } = answer(&question, port, |name| page.find(name));
    let mut response = Response::from_data(body).with_status_code(status);
    for (name, value) in headers {
        if let Ok(header) = Header::from_bytes(name, value) {
            response.add_header(header);
        }
    }
    // A browser that has left wants no answer.
    let _ = request.respond(response);
}

fn into_io(error: Box<dyn std::error::Error + Send + Sync>) -> io::Error {
    match error.downcast::<io::Error>() {
        Ok(error) => *error,
        Err(error) => io::Error::other(error),
    }
}
