//! `littlewood lab`: serves the laboratory, the page in which a motion is dragged and watched, to
//! this machine alone.

mod answer;
mod assets;
mod browser;
mod http;
mod source;

use std::io::{self, Write};
use std::net::{Ipv4Addr, TcpListener};
use std::sync::atomic::Ordering;
use std::thread;
use std::time::Duration;

use crate::args::LabArgs;
use crate::error::Error;
use crate::interrupt;

use answer::answer;

/// How often it is seen whether Ctrl-C has come.
const LOOK: Duration = Duration::from_millis(100);

pub(crate) fn run(args: &LabArgs) -> Result<(), Error> {
    let page = source::page(args.page.as_deref())?;
    let refused = |source| Error::Port {
        port: args.port,
        source,
    };
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, args.port)).map_err(refused)?;
    let port = listener.local_addr().map_err(refused)?.port();
    let asked_to_stop = interrupt::asked();
    // It waits for connections as long as the program runs.
    thread::Builder::new()
        .spawn(move || {
            http::serve(&listener, move |question| {
                answer(question, port, |name| page.find(name))
            });
        })
        .map_err(refused)?;
    let address = format!("http://127.0.0.1:{port}/");
    announce(&address)?;
    if !args.no_open {
        // The address has been printed: without a browser it can be typed.
        let _ = browser::open(&address);
    }
    while !asked_to_stop.load(Ordering::Relaxed) {
        thread::sleep(LOOK);
    }
    Ok(())
}

fn announce(address: &str) -> Result<(), Error> {
    let mut out = io::stdout().lock();
    writeln!(out, "The laboratory is at {address}\nCtrl-C ends it.")
        .and_then(|()| out.flush())
        .map_err(|source| Error::Write {
            target: "the standard output".to_owned(),
            source,
        })
}
